"""Reading a claim: text in the expression grammar, LaTeX, or SymPy's relations."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Any, NamedTuple

from tresym.reals.language import expression
from tresym.reals.language.binders import elementary, outermost, worked_out
from tresym.reals.language.expression import ONE, Expr, add, instantiate, opened, symbol, symbols
from tresym.reals.language.parsing import (
    INFINITY,
    Compared,
    condition,
    parse,
    parse_claim,
    parse_conditions,
)
from tresym.reals.language.sympy import RELATIONS, atoms, unworked
from tresym.reals.language.typography import plain
from tresym.reals.numbers.exact import InputError
from tresym.reals.places.conditions import Given

if TYPE_CHECKING:
    from tresym.reals.language.latex import Relations

ORDERS = ("O", "o", "~")
MAX_CHARACTERS = 30_000
MAX_PATH = 200
NO_CHAIN = "an order claim is one relation, and no chain"

_WORD = re.compile(r"(?<!\{)\s(?:--)?(given|as)\s(?!\s*\})")
_LATEX = re.compile(r"[\\{}]")
_PATH = re.compile(r"\s*([A-Za-z_]\w*)\s*->\s*(.+?)\s*")
_AND = re.compile(r"\band\b|;|&&?|∧")
_INFINITE = re.compile(r"([-+]?)(?:oo|inf|infinity)")
_SIDES = {"+": (1,), "-": (-1,), "": (1, -1)}
_NOT_DECIDED = {
    "integral": "integrals are not decided: claim diff(F, x) == f of an antiderivative F",
    "limit": "a limit is claimed by itself: limit(f, x, a) == L, or f == L + o(1) as x -> a",
    "at": "a value at a point is not decided here: put the point in",
    "derivative": "the value of a derivative at a point is not decided: write the derivative out",
    **dict.fromkeys(
        expression.ORDERS, "O(…) and o(…) stand at the right end of a claim: f == g + O(h)"
    ),
}
_ASSUMPTIONS = {
    "is_extended_positive": ">",
    "is_extended_negative": "<",
    "is_extended_nonnegative": ">=",
    "is_extended_nonpositive": "<=",
    "is_extended_nonzero": "!=",
}


class Derivative(NamedTuple):
    """A derivative that was written: of which function, by which variable, how often; its value."""

    function: Expr
    by: str
    order: int
    value: Expr


@dataclass(frozen=True)
class Comparison:
    """``left relation right``; for ``O`` and ``o`` the right side is the gauge.

    Attributes:
        derivatives: those that were written: a derivative is one where its function is real, there
            and beside it.
    """

    left: Expr
    relation: str
    right: Expr
    derivatives: tuple[Derivative, ...] = ()

    @property
    def differentiated(self) -> tuple[Expr, ...]:
        """The functions whose derivatives were written."""
        return tuple(dict.fromkeys(found.function for found in self.derivatives))

    @property
    def by(self) -> frozenset[str]:
        """The variables by which."""
        return frozenset(found.by for found in self.derivatives)


@dataclass(frozen=True)
class Path:
    """A variable that tends to a point.

    Attributes:
        name: the variable.
        point: where it tends, None for infinity.
        sides: +1 for from above or to +∞, −1 for from below or to −∞.
    """

    name: str
    point: Expr | None
    sides: tuple[int, ...]

    def __str__(self) -> str:
        side = "" if len(self.sides) > 1 else "+-"[self.sides[0] < 0]
        end = f"{self.point}{side}" if self.point is not None else f"{side.strip('+')}oo"
        return f"{self.name} -> {end}"


@dataclass(frozen=True)
class Statement:
    """A claim as it was read.

    Attributes:
        comparisons: all of them are claimed.
        given: the conditions.
        path: for an order statement.
        text: how it was written.
        read_as: the same in the grammar of expressions, conditions and path included.
    """

    comparisons: tuple[Comparison, ...]
    given: Given
    path: Path | None
    text: str
    read_as: str = ""

    def __str__(self) -> str:
        return self.text


class _Written(NamedTuple):
    """A claim as it was written, nothing of it worked out."""

    comparisons: tuple[Compared, ...]
    given: Given
    path: Path | None

    def __str__(self) -> str:
        parts = (("", chained(self.comparisons)), (" given ", chained(self.given.comparisons)))
        text = "".join(word + part for word, part in parts if part)
        return text if self.path is None else f"{text} as {self.path}"


def chained(comparisons: Iterable[Compared]) -> str:
    """Comparisons in the grammar of text, ``0 < x <= 1`` for two with a side in common."""
    text, last = "", None
    for left, relation, right in comparisons:
        joint = "" if left is last else f"{', ' if text else ''}{left}"
        text += f"{joint} {relation} {right}"
        last = right
    return text


def read(claim: Any, given: Any = "", path: str | None = None) -> Statement:
    """A claim with its conditions.

    Args:
        claim: text, LaTeX or a SymPy relation. Text may end in ``given CONDITIONS`` and
            ``as PATH``.
        given: text, LaTeX, SymPy relations, or a :class:`~tresym.reals.Given`.
        path: such as ``"x -> 0+"``.

    Raises:
        InputError: what is not read; one line says why.
    """
    written = _written(claim, given, path)
    text = _split(claim)[0] if isinstance(claim, str) else str(claim)
    for _, relation, _ in written.comparisons:
        if relation not in (*RELATIONS.values(), *ORDERS):
            raise InputError(f"{relation} is no claim: one is made with == != > >= < <= or ~")
        if relation in ORDERS and len(written.comparisons) > 1:
            raise InputError(NO_CHAIN)
    return _checked(_stated(str(written), text))


def _stated(shown: str, text: str) -> Statement:
    """What is decided: just what is read from the text that is shown."""
    claim, _, end = shown.partition(" as ")
    claim, _, under = claim.partition(" given ")
    parts, path = tuple(parse_claim(claim)), read_path(end) if end else None
    given = Given(tuple(parse_conditions(under)))
    if len(parts) == 1 and parts[0][0].op == "limit" and parts[0][1] == "==":
        comparison, path = _limit(parts[0][0], parts[0][2], path)
        return Statement((comparison,), given, path, text, shown)
    return Statement(tuple(_comparison(*part) for part in parts), given, path, text, shown)


def read_as(claim: Any, given: Any = "", path: str | None = None) -> str:
    """The claim with its conditions and path in the grammar; nothing where it is not read.

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
        return _Written((comparison,), _given(given) & conditions, _path(path))
    text, own, own_path = _split(claim)
    under, end = _given(given) & _given(own), _path(own_path or path)
    if not _LATEX.search(text):
        return _Written(tuple(parse_claim(plain(text))), under, end)
    from tresym.reals.language.latex import read_latex

    chains = read_latex(text.strip().strip("$"))
    last = chains[-1] if chains[1:] and chains[-1].ops[0].startswith("->") else None
    said = last or chains[0].condition
    if len(chains) != (2 if last else 1):
        raise InputError("LaTeX: one claim at a time; conditions follow \\text{for} or go apart")
    if said is not None and said.ops[0].startswith("->"):
        end = _path_of(said)
    elif said is not None:
        under = under & Given(tuple(condition(*link) for link in said.links))
    return _Written(tuple(chains[0].links), under, end)


def _split(text: str) -> tuple[str, str, str]:
    """The claim, its conditions and its path, quotes around the latter two dropped."""
    if len(text) > MAX_CHARACTERS:
        raise InputError(f"{len(text)} characters are beyond the limit of {MAX_CHARACTERS}")
    claim, *rest = _WORD.split(text)
    found = {"given": "", "as": ""}
    for word, part in zip(rest[::2], rest[1::2], strict=True):
        if found[word]:
            raise InputError(f"a claim has one part that begins with the word {word}")
        found[word] = part.strip().strip("'\"")
    return claim.strip(), found["given"], found["as"]


def _comparison(left: Expr, relation: str, right: Expr) -> Comparison:
    """What is decided of a comparison: derivatives carried out, an order as its gauge."""
    terms = right.args if right.op == "+" else (right,)
    orders = [term for term in terms if term.op in expression.ORDERS]
    if relation == "==" and len(orders) == 1:
        rest = [term for term in terms if term is not orders[0]]
        left = left - add(*rest) if rest else left
        relation, right = orders[0].op, orders[0].args[0]
    work = cache(worked_out)
    written = tuple(dict.fromkeys(d for side in (left, right) for d in _derivatives(side, work)))
    return Comparison(work(left), relation, work(right), written)


def _limit(left: Expr, value: Expr, path: Path | None) -> tuple[Comparison, Path]:
    """``limit(f, x, p) == L`` as ``f == L + o(1)`` on its path."""
    if path is not None:
        raise InputError("a limit has its path in it: write no other")
    (name,), body = opened(left, symbols(value))
    side = {1: "+", -1: "-"}.get(int(left.args[2].args[0].p), "")
    return _comparison(body - value, "o", ONE), _ending(name, left.args[1], side)


def _derivatives(e: Expr, work: Callable[[Expr], Expr]) -> Iterator[Derivative]:
    """The derivatives that are written in ``e``, inner ones first, worked out by ``work``.

    Raises:
        InputError: what else binds a variable and is not decided.
    """
    if INFINITY.args[0] in symbols(e):
        raise InputError("oo is no real number or variable, and all here are real")
    for node in outermost(e):
        place = node.args[-1]
        if node.op == "at" and elementary(*node.args) and node.args[0].loose:
            continue
        fixed = place.op != "symbol" or bool(symbols(place) & symbols(node.args[0]))
        if node.op != "derivative" or fixed:
            raise InputError(_NOT_DECIDED[node.op])
        function, times = node, 0
        while function.op == "derivative" and function.args[1] == place:
            function, times = instantiate(function.args[0], (place,)), times + 1
        yield from _derivatives(function, work)
        yield Derivative(work(function), place.args[0], times, work(node))


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
        raise InputError("LaTeX: a path is written like x \\to 0^+")
    return _ending(str(chain.terms[0]), chain.terms[1], chain.ops[0][2:])


def _ending(name: str, point: Expr, side: str) -> Path:
    if point in (INFINITY, -INFINITY):
        return Path(name, None, (1 if point == INFINITY else -1,))
    if symbols(point) or not elementary(point):
        raise InputError("a path ends at a constant or at oo")
    return Path(name, point, _SIDES[side])


def _given(given: Any) -> Given:
    if isinstance(given, Given):
        return given
    if isinstance(given, str) and _LATEX.search(given):
        from tresym.reals.language.latex import read_latex

        chains = read_latex(given.strip().strip("$"))
        return Given(tuple(condition(*link) for chain in chains for link in chain.links))
    if isinstance(given, str):
        return Given.parse(_AND.sub(",", plain(given)).strip())
    if isinstance(given, Iterable) and getattr(given, "ndim", None) != 0:
        result = Given()
        for part in given:
            result = result & _given(part)
        return result
    return Given.from_sympy(given)


def _from_sympy(claim: Any) -> tuple[Compared, Given]:
    """A SymPy relation, and the assumptions its symbols carry."""
    name = type(claim).__name__
    if name not in RELATIONS:
        hint = "; SymPy evaluated it: pass evaluate=False" if name.startswith("Boolean") else ""
        raise InputError(f"{name} is not a claim: give text or a relation such as Eq(f, g){hint}")
    comparison = unworked(claim.lhs), RELATIONS[name], unworked(claim.rhs)
    conditions = []
    names: set[str] = set()
    for variable in _variables(claim):
        if variable.name in names:
            raise InputError(f"two different symbols are called {variable.name}")
        names.add(variable.name)
        for assumption, sign in _ASSUMPTIONS.items():
            if getattr(variable, assumption):
                conditions.append((symbol(variable.name), sign, expression.ZERO))
    return comparison, Given(tuple(conditions))


def _variables(claim: Any) -> list[Any]:
    """The symbols of a relation, those of its derivatives too, all of them real variables.

    Raises:
        InputError: a symbol that may not take every real value that its sign allows.
    """
    found = atoms(claim, "Symbol")
    for variable in found:
        if variable.is_extended_real is False or variable.is_finite is False:
            raise InputError(f"{variable.name} is not a real variable, and all variables here are")
        for kind in ("integer", "rational", "algebraic"):
            if variable.assumptions0.get(kind) is not None:
                raise InputError(
                    f"whether {variable.name} is {kind} is assumed, and variables here take every "
                    "real value that their sign allows"
                )
    return found


def read_path(text: str) -> Path:
    """``x -> 0``, ``0+``, ``0-``, ``pi/2``, ``oo`` or ``-oo``, for any variable and any constant.

    Raises:
        InputError: anything else.
    """
    match = _PATH.fullmatch(plain(text)) if len(text) <= MAX_PATH else None
    if match is None:
        raise InputError("a path is written like x -> 0+ (or 0, 0-, 1/2, pi, oo, -oo)")
    name, end = match[1], match[2].replace(" ", "")
    infinite = _INFINITE.fullmatch(end)
    if infinite:
        return _ending(name, -INFINITY if infinite[1] == "-" else INFINITY, "")
    side = end[-1:] if end.endswith(("+", "-")) else ""
    return _ending(name, parse(end.removesuffix(side).removesuffix("^") if side else end), side)


def _checked(statement: Statement) -> Statement:
    """The statement, if its parts belong together."""
    orders = [c for c in statement.comparisons if c.relation in ORDERS]
    if orders and len(statement.comparisons) > 1:
        raise InputError(NO_CHAIN)
    if not orders:
        if statement.path is not None:
            raise InputError("a path belongs to O, o and ~ alone; use given for conditions")
        return statement
    if statement.path is None:
        raise InputError("an order claim needs its path, such as --as 'x -> 0+'")
    if statement.given.comparisons:
        raise InputError("an order claim takes no conditions; its path says where it holds")
    (comparison,) = statement.comparisons
    others = (symbols(comparison.left) | symbols(comparison.right)) - {statement.path.name}
    if others:
        raise InputError(
            f"an order claim has one variable, {statement.path.name}; "
            f"{', '.join(sorted(others))} must be numbers"
        )
    return statement
