"""When a link that fails somewhere is reported as false: the statement is known, and it is whole.

A counterexample refutes the formula as it was read, but the text around it may restrict its
symbols in ways that were not understood. A refutation is therefore withheld, with the reason, if a
symbol is not free, if it needs a definition from another paragraph, or if the equality holds at
other points, so that a condition is missing rather than the equality wrong.
"""

from __future__ import annotations

import random
import re
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from enum import Enum
from typing import NamedTuple

from flint import fmpq

from tresym.manuscript import prose
from tresym.manuscript.context import Memory, Under
from tresym.manuscript.display import Said
from tresym.manuscript.mentions import names_in
from tresym.manuscript.terms import Head, base_of, read_term, unknown_in
from tresym.reals.domain.evaluation import evaluate, stands
from tresym.reals.language.binders import elementary, outermost
from tresym.reals.language.calls import INFINITY, INTEGERS
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    DOTS,
    Expr,
    add,
    instantiate,
    multiply,
    number,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import Compared
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError

NO_VARIABLES = symbols(INFINITY) | symbols(DOTS)
_RANGES = ((0, 1), (1, 4), (-3, 0), (3, 20))
_POINTS = 120
_INDICES = frozenset("ijklmnpqrsKLMN")
_SUBSCRIPT = re.compile(r"[A-Za-z]+?_?(\d*[i-s][i-s\d]{0,3})")
_WAVES = re.compile(r"\b(?:sin|cos|tan|cot|sec|csc)\(|\(-1\)\*\*")
_NEAR_END = re.compile(r"small|large|asymptotic\w*|leading|(?<!using the )order", re.IGNORECASE)
"""Words that say no more than a path does."""
_BOUNDS = frozenset(("<", ">", "<=", ">=", "!="))


class DoubtKind(Enum):
    """Why a refutation may not refute what the author means."""

    NOT_FREE = "a symbol is restricted"
    SENTENCE = "its sentence restricts it"
    FUNCTION = "a function is not known"
    UNREAD = "a symbol depends on what was not read"
    DEFINITION = "it may be a definition"
    RANGE = "a bound without a range"
    ROUNDED = "numbers may be rounded"
    CONTRADICTION = "a contradiction may be meant"
    CLOSENESS = "an approximation without a tolerance"
    SEQUENCE = "a limit of a sequence"
    FAR = "a definition in another paragraph"
    SUMMED = "an index may be summed over"
    SOUGHT = "a symbol is determined by the expansion"


class Doubt(NamedTuple):
    """A reason not to report a refutation: its kind, and the words for the author."""

    kind: DoubtKind
    text: str


@dataclass(frozen=True)
class Ground:
    """The evidence that decides whether a refutation of a link is reported.

    Attributes:
        doubts: reasons not to report one.
        explicit: whether its sentence says for which values of all its symbols it is claimed.
        universal: whether the text calls it an identity, or says "for all".
        reach: the numbers of the scopes around the link, outermost first.
        alike: whether both sides are read as the same expression.
        places: for a side that is one symbol, the line of its definition, 0 for running text.
        bounds: bounds in the text that may be meant for its symbols.
    """

    doubts: tuple[Doubt, ...] = ()
    explicit: bool = False
    universal: bool = False
    reach: tuple[int, ...] = ()
    alike: bool = False
    places: dict[str, int] = field(default_factory=dict)
    bounds: tuple[Compared, ...] = ()


def ground(
    memory: Memory, compared: Compared, said: Said, n: int, under: Under, head: Head | None
) -> Ground:
    """Return the evidence on whether to report a refutation of the ``n``-th link of a chain."""
    now = memory.scopes.now
    left, relation, right = compared
    reach = memory.scopes.path
    lone = (str(side) for side in (left, right) if side.op == "symbol")
    places = {name: memory.lines.get(name, 0) for name in lone if name in memory.functions}
    if under.noted and under.kind == prose.CLAIM:
        return Ground((), True, True, reach, left == right, places)
    names = (symbols(left) | symbols(right)) - NO_VARIABLES
    unknown = unknown_in(left, right)
    own = [c for c in (*under.passing, *under.row) if symbols(c[0]) | symbols(c[2])]
    explicit = bool(names) and names <= names_in(own) | under.anew
    universal = said.universal or under.universal or under.kind == prose.CLAIM
    path = memory.path_for(names, under)
    free = names - {path.split(" ")[0]}  # a path says for which values it is meant
    tied = free | unknown | names_in(c for c in own if names & names_in((c,)))
    here = {n: r for n, r in now.restricted.items() if r.within in (0, now.paragraph)}
    restricted = {name: here[name] for name in sorted(tied & here.keys())}
    bounds = tuple(dict.fromkeys(c for r in restricted.values() for c in r.bounds))
    doubts = [
        Doubt(DoubtKind.NOT_FREE, f"{x} is not free: {r.why}")
        for x, r in restricted.items()
        if not r.bounds and (not r.by or r.by & tied) and not _cancels(x, compared)
    ]

    def doubt(kind: DoubtKind, text: str) -> None:
        doubts.append(Doubt(kind, text))

    if under.stated and not (path and _NEAR_END.fullmatch(under.stated)):
        doubt(DoubtKind.SENTENCE, f"the sentence says '{under.stated}'")
    for name in sorted(unknown):
        doubt(DoubtKind.FUNCTION, f"the text does not say what the function {name} is")
    for x in sorted(names):
        if base_of(x) != x:
            doubt(DoubtKind.UNREAD, f"{x} depends on something that was not read")
    variable = path.split(" ")[0]
    for x in sorted(sought_on_path(left, relation, right, variable) if variable else ()):
        doubt(DoubtKind.SOUGHT, f"{x} may depend on {variable}, or be determined by the expansion")
    if n == 0 and head is not None and not explicit:
        doubt(DoubtKind.DEFINITION, f"it may define {head.name}")
    if relation in _BOUNDS and names and not explicit:
        doubt(DoubtKind.RANGE, "the text does not say for which values the bound is claimed")
    terms = said.terms[n : n + 2]
    if (not names or _is_of_unit(compared)) and _within_print(memory, compared, terms):
        doubt(DoubtKind.ROUNDED, "the numbers may be rounded")
    if not names and n == 0 and all(map(_is_number, terms)) and not said.worked:
        doubt(DoubtKind.CONTRADICTION, "a contradiction may be meant")
    if not names and "\\approx" in said.ops[n : n + 1] and _is_near(compared):
        doubt(DoubtKind.CLOSENESS, "the text does not say how close the numbers are")
    if any(node.op == "limit" and _may_be_sequence(node) for node in outermost(left, right)):
        doubt(DoubtKind.SEQUENCE, "the limit may be that of a sequence")
    for x in sorted(_far_functions(memory, terms)):
        doubt(DoubtKind.FAR, f"{x} is defined in another paragraph")
    for letter in sorted(_repeated(names)):
        doubt(DoubtKind.SUMMED, f"the index {letter} may be summed over")
    return Ground(tuple(doubts), explicit, universal, reach, left == right, places, bounds)


def _cancels(name: str, compared: Compared) -> bool:
    """Whether a symbol is the same summand of both sides, so that nothing depends on it."""
    left, relation, right = compared
    if relation != "==" or not elementary(left, right):
        return False
    own = [side.args if side.op == "+" else (side,) for side in (left, right)]
    rest = [one for side in own for one in side if one != symbol(name)]
    alone = all(symbol(name) in side for side in own)
    return alone and all(name not in symbols(one) for one in rest)


def sought_on_path(left: Expr, relation: str, right: Expr, variable: str) -> set[str]:
    """Return the symbols of an expansion that are no parameters: terms of a sequence with its
    index, y_n, and a constant that stands on its right side alone."""
    names = symbols(left) | symbols(right)
    orders = any(node.op in ("O", "o") for node in outermost(right))
    indexed = {x for x in names if variable in x.partition("_")[2] and x != variable}
    new = symbols(right) - symbols(left) if orders else set()
    terms = right.args if right.op == "+" else ()
    alone = {str(term) for term in terms if term.op == "symbol"} - {"gamma"}
    return indexed | (alone & new)


def far_definitions(memory: Memory, put_in: Iterable[str], under: Under) -> tuple[str, ...]:
    """Return the substituted symbols that are defined in another paragraph."""
    now = memory.scopes.now
    near = {name for name, _ in under.sources} | memory.ahead.keys()
    return tuple(
        name for name in put_in if name not in near and now.places.get(name) != now.paragraph
    )


def _far_functions(memory: Memory, terms: Iterable[Sequence[str]]) -> set[str]:
    """Return the functions in the terms that are defined in another paragraph."""
    now = memory.scopes.now
    heads = (memory.head([token]) for term in terms for token in term if token[-1:].isalpha())
    names = {head.name for head in heads if head}
    return {
        name
        for name, function in now.functions.items()
        if function.parameters
        and now.places.get(name) != now.paragraph
        and name.partition("_")[0].rstrip("0123456789") in names
    }


def _is_near(compared: Compared) -> bool:
    """Whether two constants differ, or may differ, by at most one part in fifty."""
    if not elementary(compared[0], compared[2]):
        return True
    with ball_precision():
        left, right = (evaluate(side, {}) for side in compared[::2])
        return bool(abs(left - right) * 50 <= abs(left))


def _may_be_sequence(node: Expr) -> bool:
    """Whether a limit over an index oscillates for numbers that are not integers: sin(pi*n)."""
    return node.names[0][0] in _INDICES and bool(_WAVES.search(str(node)))


def _is_of_unit(compared: Compared) -> bool:
    """Whether both sides are numbers times one capital letter, which may be a unit: 2.4 V."""
    names = symbols(compared[0]) | symbols(compared[2])
    if len(names) != 1 or not min(names).isupper():
        return False
    name = min(names)
    parts = [side.args if side.op == "*" else (side,) for side in compared[::2]]
    return all(
        sum(part == symbol(name) for part in side) == 1
        and sum(bool(symbols(part)) for part in side if isinstance(part, Expr)) == 1
        for side in parts
    )


def _is_number(term: Sequence[str]) -> bool:
    digits = [t for t in term if t != "-"]
    return len(digits) == 1 and digits[0][0].isdigit()


def _repeated(names: Iterable[str]) -> set[str]:
    """Return index letters in the subscripts of several symbols, as p in ``R_{1p} T_{pq}``."""
    found = (m[1] for name in names if (m := _SUBSCRIPT.fullmatch(name)))
    counts = Counter(letter for letters in found for letter in {*letters} if letter.isalpha())
    return {letter for letter, count in counts.items() if count > 1}


def _within_print(memory: Memory, compared: Compared, terms: Sequence[Sequence[str]]) -> bool:
    """Whether the difference of two constants may come from rounding the printed decimals."""
    slack = fmpq(0)
    unit = {name: fmpq(1) for side in compared[::2] for name in symbols(side)}
    with ball_precision():
        try:
            gap = abs(evaluate(compared[0] - compared[2], unit))
            for term in terms:
                value = evaluate(read_term(term, memory.author).tree, unit)
                for n, token in enumerate(term):
                    whole = len(term) == 1 and token.isdigit() and len(token) > 2
                    if not whole and not (token[0].isdigit() and "." in token[:-1]):
                        continue
                    half = f"{token}.5" if whole else f"{token}5"
                    more = [*term[:n], half, *term[n + 1 :]]
                    other = evaluate(read_term(more, memory.author).tree, unit)
                    slack += abs(other - value).upper().fmpq()
            return bool(slack) and bool(gap <= slack * fmpq(101, 100))
        except (InputError, AttributeError, KeyError, ValueError):
            return False


def holds_elsewhere(sides: Compared, given: Sequence[Compared]) -> dict[str, str] | None:
    """Return a random point at which a failing equality holds; None if none is found.

    Two different analytic functions differ at almost all points. So an equality that holds at one
    of a few random points holds on a region, as ``sqrt(x**2) = x`` does: a condition is missing.

    Args:
        sides: the equality.
        given: the conditions that the point must satisfy.
    """
    one, relation, other = sides
    by = {node.names for node in outermost(one, other) if node.op == "antiderivative"}
    if len(by) == 1:
        ((name,),) = by
        one, other = _differentiated(one, name), _differentiated(other, name)
    if relation != "==" or not elementary(one, other):
        return None
    names = sorted((symbols(one) | symbols(other) | names_in(given)) - symbols(INTEGERS))
    integers = {str(a) for a, r, _ in given if r == "in"} | {x for x in names if x[0] in _INDICES}
    r = random.Random(0)
    tried, held = {True: 0, False: 0}, {True: 0, False: 0}
    found: dict[str, str] | None = None
    with ball_precision():
        for k in range(_POINTS):
            whole = bool(integers) and k % 2 == 0
            point = {name: _value(r, whole and name in integers, k) for name in names}
            if not all(_given_holds(c, point) for c in given):
                continue
            exact = {name: number(value) for name, value in point.items()}
            try:
                gap = evaluate(substitute(one - other, exact), {})
            except InputError:
                continue  # an exponent with large numerator, say
            if not gap.is_finite():
                continue
            tried[whole] += 1
            if gap.contains(0) and abs(gap).upper() < 1e-12:
                held[whole] += 1
                found = {name: str(value) for name, value in point.items()}
    return found if held[False] or 4 * held[True] > tried[True] else None


def _differentiated(e: Expr, name: str) -> Expr:
    """The derivative of a combination of indefinite integrals."""
    if e.op == "antiderivative":
        return instantiate(e.args[0], (symbol(name),))
    if e.op == "+":
        return add(*(_differentiated(arg, name) for arg in e.args))
    if e.op == "*":
        varying = [arg for arg in e.args if not elementary(arg)]
        constant = [arg for arg in e.args if elementary(arg)]
        if len(varying) == 1 and all(name not in symbols(arg) for arg in constant):
            return multiply(*constant, _differentiated(varying[0], name))
    return differentiate(e, name)


def _value(r: random.Random, whole: bool, k: int) -> fmpq:
    if whole:
        return fmpq(r.randint(1, 12))
    low, high = _RANGES[k // 2 % 4] if k % 8 < 4 else r.choice(_RANGES)
    return fmpq(low) + fmpq(r.randint(1, 9972), 9973) * (high - low)


def _given_holds(condition: Compared, point: dict[str, fmpq]) -> bool:
    left, relation, right = condition
    if relation == "in":
        return point[str(left)].q == 1
    try:
        return stands(evaluate(left - right, point), relation)
    except (KeyError, AttributeError):
        return False
