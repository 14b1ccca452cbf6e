"""What is asked of a link, and what it is if the answer is no."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from enum import Enum
from typing import Any, NamedTuple

from flint import fmpq

from tresym.manuscript import accusations, prose
from tresym.manuscript.accusations import NO_VARIABLES, Ground
from tresym.manuscript.context import DEPTH, Memory, Under
from tresym.manuscript.display import Said
from tresym.manuscript.mentions import about, names_in
from tresym.manuscript.printed_ranges import path_on_range
from tresym.manuscript.source import Display
from tresym.manuscript.terms import Head, base_of, unknown_in, variables_of_integrals
from tresym.reals.language.binders import (
    antiderivative,
    elementary,
    is_infinite,
    limit,
    outermost,
)
from tresym.reals.language.calls import INFINITY, INTEGERS, UNKNOWN
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    DOTS,
    PI,
    UNWORKED,
    ZERO,
    Expr,
    add,
    factors_in,
    instantiate,
    multiply,
    number,
    opened,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import Compared, chained
from tresym.reals.language.latex_operands import Piece
from tresym.reals.language.latex_tokens import RELATIONS
from tresym.reals.numbers.exact import InputError, parse_number

DEFINED, ASSUMED, EQUATION, UNREAD = "DEFINED", "ASSUMED", "EQUATION", "UNREAD"
CONSTANTS = re.compile(r"[CcAB]_?\d*|[CcA]_\w")
_COUNTS = frozenset(("n", "N", "k", "m"))
"""Letters that tend to infinity unless the text says otherwise."""
_WHOLE_LETTERS = frozenset("jklmnN")
"""Letters of integers in an exponent of -1."""
_NUMBERED = re.compile(r"[A-Za-z]+_?\d+")
TOLD = "as the text before it says, with"
WHERE = "under the conditions of the definition, with"
SHARED = "for any value of the integral or sum on both sides"
_WHOLES = frozenset(("integral", "sum", "product", "limit"))
CUT = "the last digit is cut off, not rounded"
EARLIER = "under conditions from earlier sections"
_WORKED = frozenset(
    ("antiderivative", "coefficient", "derivative", "integral", "nth", "limit", "sum", "product")
)
"""Expressions that are evaluated: an equality with one of these, or with a series, is not an
equation to be solved."""


class Obstacle(Enum):
    """What keeps a link from being decided that the author can remove by a directive."""

    NO_PATH = "has no path; write % tresym: as x -> 0 (or another path) before display"
    FAILS = "fails somewhere; write % tresym: claim or solve before display"
    POSITIVE = (
        "holds for positive symbols; write % tresym: given x > 0 (or the like) before display"
    )
    TWO_READINGS = "has two readings; write brackets or % tresym: shorter in display"
    CONDITION = "has an unread condition; write % tresym: given … before display"


class TwoReadings(str):
    """The reason why a term is not read, where that is that it has two readings."""

    __slots__ = ()


class Attempt(NamedTuple):
    """One form of a link to be decided: as it stands, or with definitions substituted.

    Attributes:
        text: the claim, in the grammar of ``tresym check``.
        how: what was substituted or assumed, in words.
        read_as: the link as it is shown to the author.
        may_fail: whether a refutation of this form refutes the link.
        put: the values substituted for symbols, in order.
        plain: the claim before the substitutions.
        sides, given: the claim and its conditions as expressions.
        far: substituted symbols that were defined in another paragraph.
        same: whether the same variables stand on both sides.
        under: its conditions or its path, in the grammar of ``tresym check``.
    """

    text: str
    how: str
    read_as: str
    may_fail: bool = True
    put: tuple[tuple[str, Expr], ...] = ()
    plain: str = ""
    sides: Compared | None = None
    given: tuple[Compared, ...] = ()
    far: tuple[str, ...] = ()
    same: bool = False
    under: str = ""


@dataclass(frozen=True)
class Link:
    """One link of a chain, and the claims that decide it.

    Attributes:
        number: its place in the display, from 1.
        sides: both sides and the relation; None if they could not be read.
        read_as: the link with its conditions, in the grammar of ``tresym check``.
        status, why: the status and its reason, if nothing is left to decide.
        claims: the forms to try in order: as it stands, then with definitions substituted.
        firm: whether a refutation makes it REFUTED; if not, it becomes ``otherwise``.
        otherwise: status and reason for a link that fails without being a firm claim.
        same: whether the same variables stand on both sides.
        goes_on: whether it is an equality that continues a chain: the second one of ``a = b = c``.
        worked: whether it evaluates a derivative, an integral, a sum, a limit or a series.
        multiplied: whether its sides are components of products that were written out.
        unknown: whether it contains an arbitrary function.
        around: the text before and behind its display, and the number of its scope.
        noted: the kind that a directive gives its display.
        second: the same link in the other of two readings.
        symbols: the symbols of its chain, each with its kind and the evidence for that.
        constants: symbols that the text calls numbers.
        counted: symbols that are indices elsewhere, and so are positive integers.
        ground: the evidence that decides whether a refutation is reported.
        obstacle: what the author can remove, if it is not decided.
        solves: the equation that it solves, if its claims are those of a solution.
        value: for the value of a function at a point, the function, how often it is
            differentiated, the point, and the value.
        reach: the numbers of the section and of the scopes in it, outermost first.
        moving: letters that its chapter differentiates.
    """

    display: Display
    number: int
    sides: Compared | None = None
    read_as: str = ""
    status: str = ""
    why: str = ""
    claims: tuple[Attempt, ...] = ()
    firm: bool = False
    otherwise: tuple[str, str] = ("UNDECIDED", "")
    same: bool = False
    goes_on: bool = False
    worked: bool = False
    multiplied: bool = False
    unknown: bool = False
    ground: Ground = field(default_factory=Ground)
    obstacle: Obstacle | None = None
    solves: Any = None
    value: tuple[str, int, Expr, Expr] | None = None
    reach: tuple[int, ...] = ()
    moving: frozenset[str] = field(default=frozenset(), repr=False)
    shown: str = field(default="", repr=False)
    around: tuple[str, str, int] = field(default=("", "", 0), repr=False)
    noted: str = ""
    second: Link | None = None
    symbols: tuple[tuple[str, str, str], ...] = ()
    constants: frozenset[str] = frozenset()
    counted: frozenset[str] = frozenset()


def claim(
    memory: Memory,
    link: Link,
    n: int,
    said: Said,
    compared: Compared,
    pieces: tuple[Piece, Piece],
    under: Under,
    head: Head | None,
    signed: bool,
) -> Link:
    """Return a link with the claims that decide it, and its status if they fail.

    Args:
        n: its index in the chain ``said``, from 0.
        compared: both sides and the relation.
        pieces: both sides as they were read, with the digits of printed numbers.
        under: the conditions of its display.
        head: the symbol that its left side may define, if any.
        signed: whether it stands for two statements, with an upper and a lower sign.
    """
    left, relation, right = compared
    try:
        known = memory.known(under)
        if memory.partial:  # what is differentiated by is independent
            known = {n: e for n, e in known.items() if n not in _by(left, right)}
        fixed = memory.uses.numbers | names_in(under.given)
        left = memory.under_binders(left, known, fixed)
        right = memory.under_binders(right, known, fixed)
        left, right = _as_one_limit(left), _as_one_limit(right)
    except InputError as error:
        return replace(read_so(link, compared), status=UNREAD, why=str(error))
    if signed and said.either and relation != "==":
        why = "the text does not say which sign is meant"
        return replace(read_so(link, compared), status=UNREAD, why=why)
    if signed and said.either:
        left, right = left**2, right**2
    if pieces[0].printed and not pieces[1].printed and relation == "==":
        left, right, pieces = right, left, pieces[::-1]
    if under.put_in:
        values = dict(under.put_in)
        left, right = substitute(left, values), substitute(right, values)
        put = [(substitute(a, values), r, substitute(b, values)) for a, r, b in under.given]
        under = replace(under, given=tuple(put))
    printed, compared = compared, (left, relation, right)
    link = replace(link, ground=accusations.ground(memory, compared, said, n, under, head))
    orders = any(node.op in ("O", "o") for node in outermost(left, right))
    as_path = ""
    if relation == "~" and right.op == "+" and DOTS in right.args:
        right = without_dots(right)
        compared = left, relation, right
    if relation == "~" or orders:
        if relation == "~" and not symbols(left) | symbols(right):
            return _printed(link, compared, pieces[1])
        path = memory.path_for(symbols(left) | symbols(right), under)
        path = path or usual_path(right) or _path_of_index(left, right)
        path = path or memory.likely_path(symbols(left) | symbols(right), under)
        if not path:
            advice = "write % tresym: as x -> 0 (or another path) before the display"
            why = f"it has no path: {advice}"
            link = replace(link, obstacle=Obstacle.NO_PATH)
            return replace(read_so(link, compared), status=UNREAD, why=why)
        sought = _coefficients(left, right, path) - known.keys()
        if sought:
            why = f"an expansion whose coefficients {', '.join(sorted(sought))} are sought"
            return replace(read_so(link, compared), status=EQUATION, why=why)
        as_path = f" as {path}"
        if any(node.op == "O" for node in outermost(left, right)):
            own = (*under.passing, *under.row)
            ranged = path_on_range(path, bool(under.path), own)
            if ranged is None:
                said_range = chained(about(frozenset((path.split()[0],)), own))
                why = f"an order on its range, {said_range}, is not supported"
                link = replace(link, obstacle=Obstacle.CONDITION)
                return replace(read_so(link, compared), status=UNREAD, why=why)
            as_path = f" uniformly as {ranged}" if under.uniformly else f" as {ranged}"
    elif (
        relation == "=="
        and pieces[1].printed.strip("-")
        and not symbols(left) - NO_VARIABLES
        and (not pieces[1].printed.strip("-").isdigit())
    ):
        return _printed(link, compared, pieces[1])
    old = {n for n in known if n not in memory.recent} - {name for name, _ in under.sources}
    changed = (left, right) != _by_one_variable(left, right, {n: known[n] for n in old})
    left, right = _by_one_variable(left, right, known)
    attempts, same = _attempts(memory, (left, relation, right), under, as_path)
    named = (symbols(left) | symbols(right)) - NO_VARIABLES
    stated_path = memory.path_for(named, under)
    near = stated_path or memory.likely_path(named, under) or _path_of_series(left, right)
    attempts = (*attempts, *_near_the_end(attempts, near))
    sure = under.kind == prose.CLAIM and (under.noted or same or not said.before)
    sure = sure and (under.noted or said.universal or head is None)
    goes_on = n > 0 and same and under.kind != prose.SOLVE
    numeric = not (symbols(left) | symbols(right)) - NO_VARIABLES
    numeric = numeric and not unknown_in(left, right)  # y(0) = 1 is asked of y
    worked = not unknown_in(left, right) and any(
        node.op in _WORKED or is_infinite(node) for node in outermost(printed[0], printed[2])
    )
    worked = worked or DOTS.args[0] in symbols(left) | symbols(right)
    firm = not said.before and (sure or goes_on or numeric) and (under.noted or not as_path)
    stated = stated_path and relation in ("==", "~") and not unknown_in(left, right)
    waves = relation == "~" and any(
        f"{name}(" in str(side) for side in (left, right) for name in ("sin", "cos")
    )  # the zeros of both sides do not coincide, and nobody means that they do
    firm = firm or bool(
        as_path
        and not (waves and as_path.endswith("oo"))
        and stated
        and same
        and head is None
        and not said.before
        and under.kind in ("", prose.CLAIM)
    )
    firm = firm or (
        relation == "=="
        and same
        and not said.before
        and _is_general(left, right, under, head, signed and not said.either)
    )
    firm = firm or (worked and same and relation == "==" and under.kind != prose.SOLVE)
    firm = (
        firm
        and not said.remarks
        and not changed
        and not _is_up_to(n, said, known)
        and sum(RELATIONS.get(op, "").startswith("->") for op in said.ops[:n]) < 2  # steps
        and not (under.noted and under.kind == prose.SOLVE and n == 0)
    )
    link = replace(link, sides=(left, relation, right), read_as=attempts[0].read_as)
    fallback = _fallback(memory, left, relation, right, None if as_path else head)
    if under.noted and under.kind == prose.CLAIM:
        fallback = "UNDECIDED", ""
    if under.noted and n == 0 and under.kind == prose.SOLVE:
        return replace(link, status=fallback[0], why=fallback[1])
    if head is not None and fallback[0] == DEFINED and symbols(right):
        if said.conditions or under.put_in:
            memory.undefine(head.name)
        else:
            memory.define(head, right)
    undecided = "UNDECIDED", ""
    keep = firm or (same and relation == "==" and n > 0) or as_path or relation != "=="
    counted = memory.uses.indices - memory.uses.numbers
    chain = n > 0 and relation == "==" and under.kind != prose.SOLVE
    if any(str(side).count(str(DOTS)) > 1 for side in (left, right)):
        attempts = ()  # series in brackets are compared with what they follow from
    link = replace(link, claims=attempts, firm=firm, same=same, goes_on=chain, worked=worked)
    constants = memory.uses.numbers | names_in(under.given) | memory.held
    link = replace(link, counted=counted, constants=constants)
    if fallback[0] == EQUATION and unknown_in(left, right):
        link = replace(link, same=False, unknown=True)
    about_it = not under.unread_of or under.unread_of & (symbols(left) | symbols(right))
    if under.unread and about_it and not under.noted:
        unread = UNREAD, f"its condition is not understood: {under.unread}"
        link = replace(link, firm=False, unknown=True, otherwise=unread)
        return replace(link, obstacle=Obstacle.CONDITION)
    return replace(link, otherwise=undecided if keep and fallback[0] != DEFINED else fallback)


def _as_one_limit(e: Expr) -> Expr:
    """Return ``c lim f + d`` as the limit of ``c f + d``, which the engine knows."""
    if e.op not in ("*", "+") or elementary(e):
        return e
    varying = [arg for arg in e.args if not elementary(arg)]
    inner = _as_one_limit(varying[0])
    if len(varying) > 1 or inner.op != "limit":
        return e
    rest = [arg for arg in e.args if elementary(arg)]
    joined = add if e.op == "+" else multiply
    (name,), body = opened(inner, frozenset().union(*map(symbols, rest), symbols(inner.args[1])))
    return limit(joined(*rest, body), name, inner.args[1], int(inner.args[2].args[0]))


def _by(*sides: Expr) -> set[str]:
    """Return the variables by which the sides are differentiated."""
    nodes = outermost(*sides)
    return {x for node in nodes if node.op in ("derivative", "nth") for x in node.names}


def _is_up_to(n: int, said: Said, known: Mapping[str, Expr]) -> bool:
    """Whether a link holds only up to something unsaid: a constant ``+ C`` on both sides, or the
    range of a substitution x = φ(θ) in a chain that begins with an integral over x."""
    constants = all(term[-2:] == ("+", "C") for term in said.terms[n : n + 2])
    return constants or not known.keys().isdisjoint(variables_of_integrals(said.terms[0]))


def _is_general(left: Expr, right: Expr, under: Under, head: Head | None, signed: bool) -> bool:
    """Whether an equality is claimed for all values: a sentence says for which values of all its
    variables, or it stands for two statements, with an upper and a lower sign on both sides."""
    names = (symbols(left) | symbols(right)) - NO_VARIABLES
    if head is not None or under.kind or unknown_in(left, right):
        return False
    if any(base_of(name) != name for name in names):
        return False
    return signed or (under.universal and names <= names_in(under.given))


def _attempts(
    memory: Memory, compared: Compared, under: Under, as_path: str
) -> tuple[tuple[Attempt, ...], bool]:
    """Return the claims to try, in order, and whether one has the same variables on both sides."""
    left, relation, right = compared
    attempts: dict[str, Attempt] = {}
    same, free = False, {*NO_VARIABLES}
    end = as_path.partition(" as ")[2].partition(" ")[0]
    if any(node.op == "antiderivative" for node in outermost(left, right)):
        free |= {name for name in symbols(left) | symbols(right) if CONSTANTS.fullmatch(name)}
    for more in ((), memory.earlier):
        conditions: Sequence[Compared] = (*under.given, *more)
        conditions = tuple(c for c in conditions if end not in names_in((c,)))
        spoken = chained(about(symbols(left) | symbols(right), conditions))
        said_so = f"{left} {relation} {right}" + (f" given {spoken}" if spoken else "") + as_path
        for one, other, given, how, put in _forms(memory, left, right, conditions, under):
            if end in put:
                continue  # the variable of the path stands for itself
            given = [
                c for c in given if end not in names_in((c,))
            ]  # the path says where the claim holds
            implied = (*_implied(one, other), *_integers(one, other))
            given += [c for c in implied if end not in names_in((c,))]
            shown = chained(about(symbols(one) | symbols(other), given))
            told = (f" given {shown}" if shown else "") + as_path
            text = _with_functions_named(f"{one} {relation} {other}{told}", unknown_in(one, other))
            how = "; ".join(filter(None, (how, EARLIER if more else "")))
            may_fail = not how.startswith((TOLD, WHERE))
            said = f"{left} {relation} {right} given {shown}" if how.startswith(WHERE) else said_so
            plain = _with_functions_named(
                f"{left} {relation} {right}{told}", unknown_in(left, right)
            )
            pairs = tuple(put.items())
            asked = Attempt(text, how, said, may_fail, pairs, plain, (one, relation, other))
            asked = asked._replace(given=tuple(given), under=told)
            far = accusations.far_definitions(memory, put, under)
            if relation == "==" and not put and (alone := _shared_apart(one, other)) is not None:
                left_, right_ = alone
                shorter = f"{left_} == {right_}{told}"
                apart = Attempt(shorter, SHARED, said, False, pairs, plain, (left_, "==", right_))
                attempts.setdefault(shorter, apart._replace(given=tuple(given), under=told))
            alike = not (symbols(one) ^ symbols(other)) - free
            attempts.setdefault(text, asked._replace(far=far, same=alike))
            same = same or (may_fail and alike)
    first = [one for one in attempts.values() if one.how == SHARED]
    rest = sorted(attempts.values(), key=lambda attempt: not attempt.may_fail)
    return (*first, *(one for one in rest if one.how != SHARED)), same


def _shared_apart(left: Expr, right: Expr) -> tuple[Expr, Expr] | None:
    """Return both sides with symbols for integrals and sums that stand on both; None if none do.

    Only the factors around them are compared then: ``2*I/(2*pi) == I/pi`` whatever I is.
    """
    shared = {*outermost(left)} & {*outermost(right)}
    put = {
        node: symbol(f"Value{n}")
        for n, node in enumerate(sorted(shared, key=str), 1)
        if node.op in _WHOLES
    }
    if not put:
        return None
    return replaced(left, put), replaced(right, put)


def _implied(*sides: Expr) -> list[Compared]:
    """Return bounds on symbols without which roots and logarithms in a claim are undefined.

    They change nothing about the claim: ``sqrt(pi/x)`` is defined for x > 0 only. It is asked for
    claims with integrals, whose own domain is found with more work.
    """
    if all(node.op not in _WHOLES for node in outermost(*sides)):
        return []
    found: list[Compared] = []
    nodes = list(sides)
    while nodes:
        node = nodes.pop()
        if node.hidden and node.op in UNWORKED:
            continue
        even = node.op == "^" and node.args[1].op == "number" and node.args[1].args[0].q % 2 == 0
        if even or node.op == "log":
            bound = _sign_needed(node.args[0], even and node.args[1].args[0] > 0)
            found += [bound] if bound else []
        nodes += [arg for arg in node.args if isinstance(arg, Expr)]
    return list(dict.fromkeys(found))


def _integers(*sides: Expr) -> list[Compared]:
    """Return that the letters of indices in exponents of negative numbers are integers, as those
    in ``(-1)**(2*k + 1)`` are, which is no real number for most other values."""
    names: set[str] = set()
    nodes = list(sides)
    while nodes:
        node = nodes.pop()
        if node.hidden:
            continue  # an index that is bound is an integer already
        if node.op == "^" and node.args[0].op == "number" and node.args[0].args[0] < 0:
            names |= symbols(node.args[1])
        nodes += [arg for arg in node.args if isinstance(arg, Expr)]
    return [(symbol(name), "in", INTEGERS) for name in sorted(names) if name in _WHOLE_LETTERS]


def _sign_needed(e: Expr, at_zero: bool) -> Compared | None:
    """Return the bound on a symbol that makes ``c x**n`` positive, if it is of that form."""
    factors = factors_in(e)
    moving = [one for one in factors if symbols(one)]
    fixed = [one for one in factors if not symbols(one)]
    if len(moving) != 1 or any(one != PI and one.op != "number" for one in fixed):
        return None
    sign = 1
    for one in fixed:
        sign *= -1 if one.op == "number" and one.args[0] < 0 else 1
    (power,) = moving
    inverse = power.op == "^" and power.args[1] == number(-1)
    name = power.args[0] if inverse else power
    if name.op != "symbol" or name in (INFINITY, DOTS):
        return None
    strict = inverse or not at_zero
    relation = (">" if sign > 0 else "<") + ("" if strict else "=")
    return name, relation, ZERO


def _path_of_series(left: Expr, right: Expr) -> str:
    """Return ``x -> 0`` for a series with dots in whole powers of x; empty if none is seen."""
    for side in (right, left):
        if side.op == "+" and DOTS in side.args:
            names = symbols(side) - NO_VARIABLES
            powers = {n for n in names if any(t == symbol(n) ** 2 for t in _factors(side))}
            if len(powers) == 1:
                return f"{min(powers)} -> 0"
    return ""


def _factors(side: Expr) -> Iterator[Expr]:
    for term in side.args:
        yield from term.args if term.op == "*" else (term,)


def _near_the_end(attempts: Iterable[Attempt], path: str) -> Iterator[Attempt]:
    """Yield, for a series with dots in a symbol that tends to 0, the claim for small values."""
    name, _, end = path.partition(" -> ")
    for asked in attempts:
        names = [symbols(side) for side in (asked.sides or ())[::2]]
        if end.rstrip("+-") == "0" and any({name, DOTS.args[0]} <= found for found in names):
            near = f"abs({name}) < 1/1000"
            joined = f"{asked.text}, {near}" if asked.under else f"{asked.text} given {near}"
            yield asked._replace(text=joined, how=f"for small {name}", may_fail=False)


def _with_functions_named(text: str, names: Iterable[str]) -> str:
    """Return the claim with arbitrary functions renamed to names that the grammar accepts."""
    for name in names:
        alone = re.search(rf"\b{name}\b(?!\s*\()", text)
        if alone or not UNKNOWN.fullmatch(name):
            text = re.sub(rf"\b{name}\s*\(", f"fn_{name}(", text)
    return text


def _by_one_variable(left: Expr, right: Expr, known: Mapping[str, Expr]) -> tuple[Expr, Expr]:
    """Return both sides with indefinite integrals over u = φ(x) written as integrals over x.

    The integrand becomes f(φ(x)) dφ/dx. This is done if x is the variable of another such integral,
    or occurs in the link and is the only variable of φ.
    """
    nodes = [n for n in outermost(left, right) if n.op == "antiderivative"]
    by = {str(node.args[1]) for node in nodes}
    spoken = symbols(left) | symbols(right)
    for name in sorted(by & known.keys()):
        value = known[name]
        inner = symbols(value) & (by - {name})
        if not inner and len(symbols(value)) == 1:
            inner = symbols(value) & spoken
        if len(inner) != 1:
            continue
        (x,) = inner
        for node in (n for n in nodes if str(n.args[1]) == name):
            body = substitute(instantiate(node.args[0], (symbol(name),)), {name: value})
            put = {node: antiderivative(body * differentiate(value, x), x)}
            left, right = replaced(left, put), replaced(right, put)
    return left, right


def _forms(
    memory: Memory,
    left: Expr,
    right: Expr,
    given: Sequence[Compared],
    under: Under,
) -> Iterator[tuple[Expr, Expr, Sequence[Compared], str, Mapping[str, Expr]]]:
    """Yield both sides and the conditions as they stand, and with definitions substituted.

    The latest definition is substituted first, alone; then those from which the claim is said to
    follow; then all of them.
    """
    yield left, right, given, "", {}
    known, equal = memory.known(under), {name for name, _ in under.sources}
    given = [c for c in given if c[1] != "==" or str(c[0]) not in equal]
    steps = [*_put_in(known, left, right, given)]
    found = [(*step[:3], f"with {_spoken(step[3])} substituted", step[3]) for step in steps]
    named = [f for f in found if (symbols(f[0]) | symbols(f[1])).isdisjoint(equal)]
    yield from (*found[:1], *(named[:1] if equal else ()), *found[1:][-1:])
    for one, other, conditions, put in steps[-1:]:
        where = [c for name in put for c in memory.where.get(name, ())]
        if where:
            yield one, other, [*conditions, *where], f"{WHERE} {_spoken(put)} substituted", put
    if not memory.told or under.noted:
        return
    told = {name: value for name, value in known.items() if name not in memory.told} | memory.told
    for one, other, conditions, put in [*_put_in(told, left, right, given)][-1:]:
        if not put.keys().isdisjoint(memory.told):
            yield one, other, conditions, f"{TOLD} {_spoken(put)} substituted", put


def _put_in(
    known: dict[str, Expr], left: Expr, right: Expr, given: Sequence[Compared]
) -> Iterator[tuple[Expr, Expr, Sequence[Compared], dict[str, Expr]]]:
    """Yield both sides, conditions and substitutions, with one definition more at each step."""
    put: dict[str, Expr] = {}
    for _ in range(DEPTH):
        names = symbols(left) | symbols(right)
        name = next((n for n in reversed(known) if n in names), "")
        if not name:
            return
        value = {name: known[name]}
        try:
            left, right = substitute(left, value), substitute(right, value)
            given = [(substitute(a, value), r, substitute(b, value)) for a, r, b in given]
        except InputError:
            return
        put = {**put, **value}
        yield left, right, given, put


def _spoken(put: Mapping[str, Expr]) -> str:
    return ", ".join(f"{name} = {value}" for name, value in put.items())


def _fallback(
    memory: Memory, left: Expr, relation: str, right: Expr, head: Head | None
) -> tuple[str, str]:
    """Return the status and the reason for an equality that does not hold everywhere."""
    if relation != "==":
        return "UNDECIDED", ""
    known = head is not None and head.name in memory.functions and not head.derived
    if head is not None and known and head.name not in symbols(right):
        return DEFINED, "defined differently before; this definition holds from here on"
    names = (symbols(left) | symbols(right)) - NO_VARIABLES
    unknown = unknown_in(left, right)
    if unknown:
        return EQUATION, f"read as an equation for {' or '.join(sorted(unknown))}"
    derived = sorted({base for name in names if (base := base_of(name)) != name})
    if head is not None and not derived and head.name in symbols(right):
        derived = [head.name]
    new = names - memory.functions.keys() - names_in(memory.noted) - names_in(memory.lasting)
    unknowns = derived or sorted(new or names)
    return EQUATION, f"read as an equation for {' or '.join(unknowns) or 'nothing'}"


def _printed(link: Link, compared: Compared, piece: Piece) -> Link:
    """Return the link between a constant and its printed digits: rounded, or cut off."""
    left, _, right = compared
    digits = piece.printed.strip("-")
    if not digits:
        why = "the text does not say how close, and the right side is not a decimal"
        return replace(read_so(link, compared), status=UNREAD, why=why)
    mantissa, _, exponent = digits.partition("e")
    places = len(mantissa.partition(".")[2])
    unit = parse_number(f"1e{int(exponent or 0) - places}")
    shown = f"{left} == {piece.printed} to the digits printed"
    half = number(unit * fmpq(1, 2))
    rounded = f"abs({left} - ({right})) <= {half}"
    beyond = right - half if piece.printed.startswith("-") else right + half
    cut = f"abs({left} - ({beyond})) < {half}"  # strictly: 2 is not 1 with its digits cut off
    attempts = [
        Attempt(rounded, "the last digit is rounded", shown),
        Attempt(cut, CUT, shown),
    ]
    return replace(
        link, sides=(left, "==", right), read_as=shown, claims=tuple(attempts), firm=True
    )


def usual_path(right: Expr) -> str:
    """Return the usual path of a remainder: ``x -> 0`` for O(x**3) and o(x**3), ``n -> oo`` for
    O(1/n), and for O(n), since n counts."""
    (*_, order) = [None, *(node for node in outermost(right) if node.op in ("O", "o"))]
    if order is None:
        return ""
    gauge = order.args[0]
    base, exponent = gauge.args if gauge.op == "^" else (gauge, number(1))
    if order.op == "o" and exponent == number(1):
        return ""  # x + o(x) is said of large x as well
    if base.op != "symbol" or exponent.op != "number":
        return ""
    grows = exponent.args[0] < 0 or str(base) in ("n", "N")
    return f"{base} -> {'oo' if grows else '0'}"


def without_dots(series: Expr) -> Expr:
    """Return the terms of a series: ``f ~ a + b + ...`` asserts a and b, with an error o(b).

    A term that is zero, as in ``e^{-x} ~ 0 + 0/x + ...``, asserts more, so then the dots are kept.
    """
    terms = [term for term in series.args if term != DOTS]
    if any(term.op == "*" and ZERO in term.args for term in terms) or len(terms) < 1:
        return series
    return add(*terms)


def _coefficients(left: Expr, right: Expr, path: str) -> set[str]:
    """Return the numbered symbols on the right of an expansion that its left side does not have:
    ``\\sqrt{9 + x} = a_1 + a_2 x + O(x^2)`` determines them."""
    new = symbols(right) - symbols(left) - NO_VARIABLES - {path.partition(" ")[0]}
    alone = left.op == "symbol" or unknown_in(left, right)
    return set() if alone else {name for name in new if _NUMBERED.fullmatch(name)}


def _path_of_index(left: Expr, right: Expr) -> str:
    """Return the usual path of a statement about one index: ``n -> oo``."""
    names = (symbols(left) | symbols(right)) - NO_VARIABLES
    return f"{min(names)} -> oo" if len(names) == 1 and names <= _COUNTS else ""


def read_so(link: Link, compared: Compared) -> Link:
    """Return the link with its sides, and with ``read_as`` without conditions."""
    left, relation, right = compared
    return replace(link, sides=compared, read_as=f"{left} {relation} {right}")
