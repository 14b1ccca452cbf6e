"""Parse a claim from text, LaTeX or SymPy relations."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import replace
from functools import cache
from typing import TYPE_CHECKING, Any, NamedTuple

from tresym.reals.decisions.identity import decide
from tresym.reals.decisions.path_regions import reach_of
from tresym.reals.decisions.statement import (
    Comparison,
    Derivative,
    Path,
    Statement,
    chained,
    functions,
)
from tresym.reals.decisions.written_derivatives import NOT_DECIDED, read_derivatives
from tresym.reals.domain.conditions import Given
from tresym.reals.language import expression
from tresym.reals.language.binders import elementary, is_infinite, outermost, worked_out
from tresym.reals.language.calls import INFINITY, INTEGERS
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ZERO,
    Expr,
    add,
    instantiate,
    multiply,
    number,
    opened,
    symbol,
    symbols,
)
from tresym.reals.language.parsing import Compared, parse, parse_claim, parse_given
from tresym.reals.language.sentences import spelled, spelled_conditions
from tresym.reals.language.sympy import RELATIONS, atoms, order_paths, unworked
from tresym.reals.language.typesetting import to_latex
from tresym.reals.language.unicode_input import plain
from tresym.reals.language.variable_names import explain, without_declaration
from tresym.reals.numbers.exact import InputError
from tresym.reals.signs.sign import sign as sign_of
from tresym.reals.verdict import Verdict

if TYPE_CHECKING:
    from tresym.reals.language.latex import Relations

ORDERS = ("O", "o", "~", "Theta", "omega")
LIMIT = "->"
MAX_CHARACTERS = 30_000
MAX_PATH = 200
NO_CHAIN = "a limit or an order claim cannot be part of a chain: write one relation at a time"

_WORD = re.compile(r"(?<!\{)\s(?:--)?(given|as|on)\s(?!\s*\})")
_LATEX = re.compile(r"[\\{}]")
_PATH = re.compile(r"\s*([A-Za-z_]\w*)\s*->\s*(.+?)\s*")
_AND = re.compile(r"\band\b|;|&&?|∧")
_DANGLING = re.compile(r"\b(and|or)\s*$")
_TOGETHER = re.compile(r"\s*\(([\w\s,]+)\)\s*->\s*\((.+)\)\s*")
_MEANT = re.compile(r",\s*\((\w+),\s*([\w./+-]+)\)\s*\)\s*$")
"""The end of an order as SymPy prints it: O(x**(-4), (x, oo))."""
_UNIFORMLY = re.compile(r"\suniformly\b")
_INFINITE = re.compile(r"([-+]?)(?:oo|inf|infinity)")
_SIDES = {"+": (1,), "-": (-1,), "": (1, -1)}
_LONE = "a limit must stand alone on one side and be compared by == with its value"
_ASSUMPTIONS = {
    "is_extended_positive": ">",
    "is_extended_negative": "<",
    "is_extended_nonnegative": ">=",
    "is_extended_nonpositive": "<=",
    "is_extended_nonzero": "!=",
}


class _Written(NamedTuple):
    """A claim as it was written, nothing of it worked out."""

    comparisons: tuple[Compared, ...]
    given: tuple[Compared, ...]
    path: Path | None
    on: tuple[Compared, ...] = ()
    uniformly: bool = False

    def __str__(self) -> str:
        parts = (("", chained(self.comparisons)), (" given ", chained(self.given)))
        text = "".join(word + part for word, part in parts if part)
        text += " uniformly" if self.uniformly else ""
        text = text if self.path is None else f"{text} as {self.path}"
        return f"{text} on {chained(self.on)}" if self.on else text


def in_latex(text: str) -> str:
    """Return a claim in the grammar of text as LaTeX; empty if it cannot be read."""
    try:
        comparisons, given, path, _, _ = _written(text, "", None)
    except InputError:
        return ""
    shown = to_latex(comparisons)
    shown += rf" \quad ({to_latex(given)})" if given else ""
    if path is None:
        return shown
    point = multiply(number(path.sides[0]), INFINITY) if path.point is None else path.point
    side = "" if path.point is None or len(path.sides) > 1 else "^+" if path.sides[0] > 0 else "^-"
    return rf"{shown} \quad ({to_latex([(symbol(path.name), '->', point)])}{side})"


def read(claim: Any, given: Any = "", path: str | None = None) -> Statement:
    """Read a claim with its conditions and its path.

    Args:
        claim: text, LaTeX or a SymPy relation. Text may end in ``given CONDITIONS`` and
            ``as PATH``.
        given: text, LaTeX, SymPy relations, or a :class:`~tresym.reals.Given`.
        path: such as ``"x -> 0+"``.

    Raises:
        InputError: the input cannot be read; the message is one line and says what to write.
    """
    written = _written(claim, given, path)
    text = _split(claim)[0] if isinstance(claim, str) else str(claim)
    for _, relation, _ in written.comparisons:
        if relation not in (*RELATIONS.values(), *ORDERS, LIMIT):
            raise InputError(
                f"{relation} does not make a claim: use one of == != > >= < <= ~ or ->"
            )
        if relation in (*ORDERS, LIMIT) and len(written.comparisons) > 1:
            raise InputError(NO_CHAIN)
    shown = str(written)
    if not all(isinstance(part, str) and _is_plain(part) for part in (claim, given, path or "")):
        written = _read_again(shown)
    return _checked(_stated(written, shown, text))


def need_variables(claim: Any, given: Any = "", path: str | None = None) -> None:
    """Check that all names in typed text are variables or known.

    Names in LaTeX, SymPy relations and conditions that are no text are taken as they are.

    Raises:
        InputError: a name is no variable; the message says what to write. Text that cannot be read
            at all is not this function's concern.
    """
    if not (isinstance(claim, str) and isinstance(given, str)) or _LATEX.search(claim + given):
        return
    try:
        written = _written(claim, given, path)
    except InputError:
        return
    known = [] if written.path is None else [written.path.name]
    under = f"{given} {_split(claim)[1]}"
    names = without_declaration(written.comparisons, written.given, known, under)
    if names:
        raise InputError(explain(f"{claim} {given}", names))


def _is_plain(text: str) -> bool:
    """Whether text is in the grammar as it stands, neither LaTeX nor with signs of print."""
    return text.isascii() and not _LATEX.search(text)


def _read_again(shown: str) -> _Written:
    """What is written in the text that is shown: of LaTeX and of SymPy just that is decided."""
    uniformly = _UNIFORMLY.search(shown) is not None
    shown, _, on = _UNIFORMLY.sub("", shown).partition(" on ")
    claim, _, end = shown.partition(" as ")
    claim, _, under = claim.partition(" given ")
    path = read_path(end) if end else None
    parts = tuple(parse_claim(claim)), tuple(parse_given(under))
    return _Written(*parts, path, _given(on), uniformly)


def _stated(written: _Written, shown: str, text: str) -> Statement:
    """What is decided of what is written."""
    parts, said, path, on, uniformly = written
    if uniformly and (path is None or not _is_order(parts)):
        raise InputError("uniformly belongs to an order with a path: f == g + O(h) as x -> 0")
    if path is not None and path.expression is not None:
        whole = path
        parts, said, path = _along_expression(parts, said, path)
        # All variables move along such a path together, so that one constant must serve.
        uniformly = bool({n for link in parts for e in link[::2] for n in symbols(e)} - {path.name})
        if uniformly and not _is_order(parts):
            raise InputError(
                f"the path {whole} is supported for orders with a constant, f == g + O(h)"
            )
    if on:
        if path is None or not _is_order(parts):
            raise InputError("on REGION belongs to an order with a path: f == g + O(h) as x -> 0")
        path = replace(path, reach=reach_of(on, path))
    given = Given(tuple(link for link in said if link[1] not in ("==", "in"))).unfolded()
    equations = tuple((left, right) for left, relation, right in said if relation == "==")
    closed = sum(relation in (">=", "<=") for _, relation, _ in said) > 1
    equations += tuple(
        (symbol(name), number(where.low))
        for name, where in (given.box.items() if closed else ())
        if where.low is not None and where.low == where.high
        if not (where.low_open or where.high_open)
    )
    integers = tuple(dict.fromkeys(str(link[0]) for link in said if link[1] == "in"))
    if len(parts) == 1 and any(side.op == "limit" for side in parts[0][::2]):
        comparison, path = _limit(*parts[0], path)
        found: tuple[Comparison, ...] = (comparison,)
    else:
        found = tuple(_comparison(*part) for part in parts)
    _need_apart(found, said)
    return Statement(found, given, path, text, shown, equations, integers, uniformly)


def _need_apart(comparisons: Iterable[Comparison], said: Iterable[Compared]) -> None:
    """That no letter names a variable and a function, or functions of several arities."""
    trees = [side for c in comparisons for side in (c.left, c.right)]
    trees += [side for link in said for side in link[::2]]
    heads = {node.args[0].args[0]: len(node.args) for e in trees for node in functions(e)}
    for e in trees:
        for name in symbols(e) & heads.keys():
            raise InputError(
                f"{name} is used both as a function and as a variable; for a "
                f"product write {name}*(…)"
            )
        for node in functions(e):
            if len(node.args) != heads[node.args[0].args[0]]:
                raise InputError(
                    f"{node.args[0].args[0]} is used with different numbers of arguments"
                )


def read_as(claim: Any, given: Any = "", path: str | None = None) -> str:
    """Return the claim with conditions and path in the grammar of text; empty if unreadable.

    Nothing is worked out of it, so that it is at hand also where deciding did not end.
    """
    try:
        is_read = isinstance(claim, Statement)
        return claim.read_as if is_read else str(_written(claim, given, path))
    except InputError:
        return ""


def _written(claim: Any, given: Any, path: str | None) -> _Written:
    if not isinstance(claim, str):
        comparison, conditions = _from_sympy(claim)
        tends = _path(path) or _path_of_orders(claim)
        if tends is not None:
            conditions, tends = _without_sign(conditions, tends)
        return _Written((comparison,), (*_given(given), *conditions), tends)
    try:
        return _strictly(claim, given, path)
    except InputError:
        found = spelled(claim)
        if found is None:
            raise
    end = found.path or path
    more = f" given {found.given}" if found.given else ""
    again = _strictly(f"{found.claim}{more}", given, end)
    return _read_again(str(again))


def _strictly(claim: str, given: Any, path: str | None) -> _Written:
    """A claim of text or LaTeX in the grammar as it stands."""
    uniformly = _UNIFORMLY.search(claim) is not None
    text, own, own_path, region = _split(_UNIFORMLY.sub("", claim))
    meant = _MEANT.search(text)
    if meant is not None and not (own_path or path):
        own_path = f"{meant[1]} -> {meant[2]}"
    text = text if meant is None else f"{text[: meant.start()]})"
    under, end, on = (*_given(given), *_given(own)), _path(own_path or path), _given(region)
    if not _LATEX.search(text):
        return _Written(tuple(parse_claim(plain(text))), under, end, on, uniformly)
    from tresym.reals.language.latex import read_latex

    chains = read_latex(text.strip().strip("$"))
    last = chains[-1] if chains[1:] and chains[-1].ops[0].startswith("->") else None
    said = last or chains[0].condition
    if len(chains) != (2 if last else 1):
        raise InputError(
            "LaTeX: give one claim at a time; put its conditions after "
            "\\text{for} or give them separately"
        )
    if said is not None and said.ops[0].startswith("->"):
        end = _path_of(said)
    elif said is not None:
        under = (*under, *map(_condition, said.links))
    return _Written(tuple(chains[0].links), under, end, on, uniformly)


def _path_of_orders(claim: Any) -> Path | None:
    """Return where the orders of a SymPy relation are meant, as in O(r**(-5), (r, oo))."""
    found = order_paths(claim)
    if len(found) > 1:
        raise InputError("the orders of a claim must belong to one path")
    if not found:
        return None
    ((name, point, sign),) = found
    return Path(name, point, (sign,) if point is None else (1, -1))


def _without_sign(
    conditions: tuple[Compared, ...], path: Path
) -> tuple[tuple[Compared, ...], Path]:
    """Use the assumption that the variable of the path is positive for its side."""
    x = symbol(path.name)
    signs = [link for link in conditions if link[0] == x and link[1] != "in"]
    for link in signs:
        if link[1] == "!=":
            continue  # so it is beside the end
        side = 1 if link[1][0] == ">" else -1
        if path.point == ZERO and side in path.sides:
            path = replace(path, sides=(side,))
        elif path.sides != (side,) and path.point is None:
            return conditions, path
    inside = path.point is None or path.point.op == "number"
    return (tuple(x for x in conditions if x not in signs), path) if inside else (conditions, path)


def _split(text: str) -> tuple[str, str, str, str]:
    """The claim, its conditions, path and region, quotes around the latter three dropped."""
    if len(text) > MAX_CHARACTERS:
        raise InputError(f"the claim has {len(text)} characters; the limit is {MAX_CHARACTERS}")
    claim, *rest = _WORD.split(text)
    found = {"given": "", "as": "", "on": ""}
    for word, part in zip(rest[::2], rest[1::2], strict=True):
        if found[word]:
            raise InputError(f"a claim can have only one part that begins with the word {word}")
        found[word] = part.strip().strip("'\"")
    return claim.strip(), found["given"], found["as"], found["on"]


def _along_expression(
    parts: tuple[Compared, ...], said: tuple[Compared, ...], path: Path
) -> tuple[tuple[Compared, ...], tuple[Compared, ...], Path]:
    """Put s/b for a in a claim as a*b -> oo, so that s is the variable that tends to oo.

    The variable that is eliminated is the first one without an upper bound by a constant.
    """
    assert path.expression is not None
    given = Given(tuple(link for link in said if link[1] not in ("==", "in")))
    taken = {n for left, _, right in (*parts, *said) for n in symbols(left) | symbols(right)}
    for name in sorted(symbols(path.expression)):
        factor = differentiate(path.expression, name)
        bounded = name in given.box and given.box[name].high is not None
        rest = expression.substitute(path.expression, {name: ZERO})
        whole = decide(rest, ZERO, given).verdict is Verdict.PROVED
        if bounded or name in symbols(factor) or not whole or sign_of(factor, given, ">") != "+":
            continue
        s = expression.fresh("s", taken)
        put = {name: symbol(s) / factor}

        def change(link: Compared, put: dict[str, Expr] = put) -> Compared:
            left, relation, right = (
                expression.substitute(link[0], put),
                link[1],
                expression.substitute(link[2], put),
            )
            return left, relation, right

        moved = tuple(map(change, parts)), tuple(map(change, said))
        return *moved, replace(path, name=s)
    raise InputError(
        f"the path {path} is supported if {path.expression} is a variable times a positive factor"
    )


def _is_order(parts: tuple[Compared, ...]) -> bool:
    """Whether a claim is an order with a constant, O(…) at its right end."""
    right = spread(parts[0][2])
    return len(parts) == 1 and any(term.op == "O" for term in _terms(right))


def _comparison(left: Expr, relation: str, right: Expr) -> Comparison:
    """What is decided of a comparison: derivatives carried out, an order as its gauge."""
    right = spread(right)
    terms = right.args if right.op == "+" else (right,)
    orders = [term for term in terms if term.op in expression.ORDERS]
    if relation == "==" and len(orders) == 1:
        rest = [term for term in terms if term is not orders[0]]
        left = left - add(*rest) if rest else left
        relation, right = orders[0].op, orders[0].args[0]
    if any(n.op == "antiderivative" for n in outermost(left, right)) and relation == "==":
        return _without_ends(left, right)
    if relation == LIMIT and right in (INFINITY, -INFINITY):
        return replace(_comparison(left, relation, ZERO), right=right)
    if relation == "==" and right in (INFINITY, -INFINITY) and left.op in ("integral", "sum"):
        return replace(_comparison(left, relation, ZERO), right=right)
    work = cache(worked_out)
    written = tuple(
        dict.fromkeys(d for side in (left, right) for d in read_derivatives(side, work))
    )
    values = (node for node in outermost(left, right) if node.op == "at" and len(node.names) == 1)
    primitives = tuple(dict.fromkeys(node.args[0] for node in values))
    return Comparison(work(left), relation, work(right), written, primitives)


def spread(e: Expr) -> Expr:
    """``c (f + O(g))`` as ``c f + O(c g)``."""
    if e.op == "+":
        return add(*map(spread, e.args))
    parts = e.args if e.op == "*" and not elementary(e) else ()
    factors = [part for part in parts if not elementary(part)]
    terms = _terms(factors[0]) if len(factors) == 1 else ()
    rest = multiply(*(part for part in parts if part is not factors[0]))
    if not any(term.op in ("O", "o") for term in terms):
        return e
    return add(
        *(
            Expr(term.op, (rest * term.args[0],)) if term.op in ("O", "o") else rest * term
            for term in terms
        )
    )


def _limit(left: Expr, relation: str, right: Expr, path: Path | None) -> tuple[Comparison, Path]:
    """``limit(f, x, p) == L`` as ``f -> L`` on its path."""
    if path is not None:
        raise InputError("limit(…) states its own path: leave out the other one")
    left, value = (left, right) if left.op == "limit" else (right, left)
    if relation != "==" or not (elementary(value) or is_infinite(value)):
        raise InputError(_LONE)
    (name,), body = opened(left, symbols(value))
    side = {1: "+", -1: "-"}.get(int(left.args[2].args[0].p), "")
    return _comparison(body, LIMIT, value), _ending(name, left.args[1], side)


def _without_ends(left: Expr, right: Expr) -> Comparison:
    """An equation of integrals without ends as one of derivatives."""
    names, known, rest = set(), [], []
    for term in (*_terms(left), *(-term for term in _terms(right))):
        nodes = [node for node in outermost(term) if node.op == "antiderivative"]
        if not nodes:
            rest.append(-term)
            continue
        (node, *others), name = nodes, str(nodes[0].args[1])
        parts = term.args if term.op == "*" else (term,)
        factors = [part for part in parts if part != node]
        if others or len(factors) != len(parts) - 1 or name in symbols(multiply(*factors)):
            raise InputError(NOT_DECIDED["antiderivative"])
        names.add(name)
        known.append(multiply(*factors, instantiate(node.args[0], (node.args[1],))))
    if len(names) != 1:
        raise InputError(
            "all indefinite integrals of a claim must have the same variable of integration"
        )
    (by,) = names
    f, function = (worked_out(add(*terms)) for terms in (known, rest))
    for side in (f, function):
        tuple(read_derivatives(side, worked_out))
    value = differentiate(function, by)
    return Comparison(value, "==", f, (Derivative(function, by, 1, value),))


def _terms(e: Expr) -> tuple[Expr, ...]:
    return e.args if e.op == "+" else (e,)


def _path(path: str | None) -> Path | None:
    if not path:
        return None
    if len(path) > MAX_PATH or not _LATEX.search(path):
        return read_path(path)
    from tresym.reals.language.latex import read_latex

    return _path_of(read_latex(path.strip().strip("$").replace("->", "\\to"))[0])


def _path_of(chain: Relations) -> Path:
    """A path that LaTeX states as ``x \\to 0^+``."""
    if len(chain.ops) != 1 or not chain.ops[0].startswith("->") or chain.terms[0].op != "symbol":
        raise InputError("LaTeX: write a path like x \\to 0^+")
    return _ending(str(chain.terms[0]), chain.terms[1], chain.ops[0][2:])


def _ending(name: str, point: Expr, side: str) -> Path:
    if point in (INFINITY, -INFINITY):
        return Path(name, None, (1 if point == INFINITY else -1,))
    if name in symbols(point) or not elementary(point):
        raise InputError("a path must end at a constant, at a parameter or at oo")
    return Path(name, point, _SIDES[side])


def _given(given: Any) -> tuple[Compared, ...]:
    if isinstance(given, Given):
        return given.comparisons
    if isinstance(given, str) and _LATEX.search(given):
        from tresym.reals.language.latex import read_latex

        chains = read_latex(given.strip().strip("$"))
        return tuple(_condition(link) for chain in chains for link in chain.links)
    if isinstance(given, str):
        if word := _DANGLING.search(given):
            raise InputError(f"a condition is missing after the word {word[1]}")
        try:
            return tuple(parse_given(_AND.sub(",", plain(given)).strip()))
        except InputError:
            again = spelled_conditions(given)
            if again is None:
                raise
            return tuple(parse_given(again))
    if isinstance(given, Iterable) and getattr(given, "ndim", None) != 0:
        return tuple(link for part in given for link in _given(part))
    if type(given).__name__ == "Equality":
        return (_condition((unworked(given.lhs), "==", unworked(given.rhs))),)
    return Given.from_sympy(given).comparisons


def _condition(link: Compared) -> Compared:
    """A condition from elsewhere, if it can be one."""
    parse_given(chained((link,)))
    return link


def _from_sympy(claim: Any) -> tuple[Compared, tuple[Compared, ...]]:
    """A SymPy relation, and the assumptions its symbols carry."""
    name = type(claim).__name__
    if name not in RELATIONS:
        hint = (
            "; SymPy evaluated the relation: pass evaluate=False"
            if name.startswith("Boolean")
            else ""
        )
        raise InputError(
            f"{name} is not a claim: give text or a SymPy relation such as Eq(f, g){hint}"
        )
    comparison = unworked(claim.lhs), RELATIONS[name], unworked(claim.rhs)
    conditions = []
    names: set[str] = set()
    for variable in _variables(claim):
        if variable.name in names:
            raise InputError(f"two different SymPy symbols are both called {variable.name}")
        names.add(variable.name)
        for assumption, sign in _ASSUMPTIONS.items():
            if getattr(variable, assumption):
                conditions.append((symbol(variable.name), sign, expression.ZERO))
        if variable.is_integer:
            conditions.append((symbol(variable.name), "in", INTEGERS))
    return comparison, tuple(conditions)


def _variables(claim: Any) -> list[Any]:
    """The symbols of a relation, those of its derivatives too, all of them real variables.

    Raises:
        InputError: a symbol that may not take every real value that its sign allows.
    """
    found = atoms(claim, "Symbol")
    for variable in found:
        if variable.is_extended_real is False or variable.is_finite is False:
            raise InputError(f"{variable.name} is not real: only real variables are supported")
        for kind in () if variable.is_integer else ("integer", "rational", "algebraic"):
            if variable.assumptions0.get(kind) is not None:
                raise InputError(
                    f"the SymPy assumption about whether {variable.name} is "
                    f"{kind} is not supported: only "
                    "signs and integer=True are"
                )
    return found


def read_path(text: str) -> Path:
    """``x -> 0``, ``0+``, ``0-``, ``pi/2``, ``oo`` or ``-oo``, for any variable and any constant.

    Raises:
        InputError: anything else.
    """
    match = _PATH.fullmatch(plain(text)) if len(text) <= MAX_PATH else None
    several = _TOGETHER.fullmatch(plain(text)) if len(text) <= MAX_PATH else None
    if several is not None:
        return _several(several[1], several[2])
    if match is None and len(text) <= MAX_PATH and plain(text).count("->") == 1:
        left, _, right = plain(text).partition("->")
        what = parse(left)
        far = _INFINITE.fullmatch(right.replace(" ", ""))
        if symbols(what) and far is not None and not far[1].startswith("-") and elementary(what):
            return Path("", None, (1,), expression=what)
    if match is None:
        raise InputError("write a path like x -> 0+ (or 0, 0-, 1/2, pi, oo, -oo)")
    name, end = match[1], match[2].replace(" ", "")
    infinite = _INFINITE.fullmatch(end)
    if infinite:
        return _ending(name, -INFINITY if infinite[1] == "-" else INFINITY, "")
    side = end[-1:] if end.endswith(("+", "-")) else ""
    return _ending(name, parse(end.removesuffix(side).removesuffix("^") if side else end), side)


def _without_path(statement: Statement) -> bool:
    """Return whether an order compares sums of powers of parameters that are said positive."""
    (claim,) = statement.comparisons
    names = symbols(claim.left) | symbols(claim.right)
    box = statement.given.box
    return (
        bool(names)
        and all(n in box and (box[n].low or 0) >= 0 for n in names)
        and all(box[n].low is not None for n in names)
    )


def _several(names: str, points: str) -> Path:
    """Return the path of several variables that tend to a point together."""
    variables = tuple(name.strip() for name in names.split(","))
    ends = tuple(parse(part) for part in points.split(","))
    if len({*variables}) < len(variables) or len(ends) != len(variables) or len(ends) < 2:
        raise InputError("write a path in several variables like (x, y) -> (0, 0)")
    if not all(name.isidentifier() and symbol(name) == parse(name) for name in variables):
        raise InputError("write a path in several variables like (x, y) -> (0, 0)")
    if any(symbols(e) or not elementary(e) for e in ends):
        raise InputError("a path in several variables must end at constants")
    return Path("", ZERO, (1,), together=variables, points=ends)


def _checked(statement: Statement) -> Statement:
    """The statement, if its parts belong together."""
    kinds = [c.relation for c in statement.comparisons]
    near = [kind for kind in kinds if kind in (*ORDERS, LIMIT)]
    if near and len(kinds) > 1:
        raise InputError(NO_CHAIN)
    path = statement.path
    if path is None:
        if near and not (near == ["O"] and _without_path(statement)):
            raise InputError("an order claim needs its path, such as --as 'x -> 0+'")
        return statement
    if not near and "==" in kinds:
        raise InputError(
            "a path is only for O, o, ~, -> and inequalities; give an equation conditions instead"
        )
    whole = path.name in statement.integers and path.point is not None
    if whole:
        raise InputError(f"{path.name} is an integer, so its path must end at oo or -oo")
    said = [*statement.given.names]
    said += [name for sides in statement.equations for e in sides for name in symbols(e)]
    free = statement.implicit or path.expression is not None
    if path.name in said and not free:
        raise InputError(
            f"leave out the conditions on {path.name}: the path says where the claim holds"
        )
    return statement
