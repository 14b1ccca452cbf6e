"""False variants of printed numbers, bounds and orders, with what shows that they are false.

A changed number, bound or order counts as false only if ball arithmetic shows it, at points or over
the whole box of inputs. The code shares nothing with the searches under test.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import islice, product
from typing import Any, cast

from flint import arb
from sympy import Basic, Symbol, Tuple, exp, oo
from sympy.core.function import AppliedUndef

from tresym.ledger.ball_evaluation import value
from tresym.ledger.claim import Claim, Printed, equal, saying
from tresym.ledger.evidence.asymptotics import ordered, t
from tresym.ledger.evidence.box_bounds import Boxes
from tresym.ledger.evidence.printed_numbers import number_of
from tresym.ledger.statements import As, Rounds
from tresym.reals.balls.branch_and_bound import Bound, Box, BoxPoint, value_at
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError, Interval, fraction_text, printed
from tresym.reals.verdict import Verdict

Changes = tuple[str, Iterable[Any], Callable[[Any], Claim]]
"""A place, the changes that can be made there, and the claim that each change produces."""

BITS = 128
SPLITS = (1, 4, 16)
CELLS = 16
"""Number of pieces of each input of a printed number, and the maximal number of cells."""
RANGES = 1024
NEAR = (12, 20, 28)
"""Exponents n: an order is evaluated at the small parameters 2^−n, with `NEAR_BITS` bits."""
NEAR_BITS = 640
LESS = arb("0.9")


@dataclass(frozen=True)
class Named:
    """A changed function or statement, with a description of the change."""

    text: str
    changed: Any

    def __str__(self) -> str:
        return self.text


# Printed numbers


def printed_changes(
    claim: Claim, mutations: Callable[[Basic], Iterable[Basic]]
) -> Iterator[Changes]:
    """Yield changes of the unit, the term, and the digits of the number and its inputs."""
    says = cast(Rounds, claim.statement)

    def stated(term: Basic, text: str) -> Claim:
        return replace(claim, means=Rounds(term, text, says.half_units))

    yield "printed number", moved_digits(says.text), lambda text: stated(says.term, text)
    yield "unit", other_units(says.text), lambda text: stated(says.term, text)
    yield "term", mutations(says.term), lambda term: stated(term, says.text)
    for n, condition in enumerate(claim.given):
        if isinstance(condition, Rounds):

            def changed(text: str, n: int = n, name: Basic = condition.term) -> Claim:
                given = claim.given
                return replace(claim, given=(*given[:n], Rounds(name, text), *given[n + 1 :]))

            yield f"input {condition.term}", moved_digits(condition.text), changed


def _with(claim: Claim, **changes: Any) -> Claim:
    proof: Any = claim.proof
    return replace(claim, proof=replace(proof, **changes))


def other_units(text: str) -> Iterator[str]:
    """Yield the same digits in a unit ten times as large or as small."""
    digits, _, exponent = text.lower().partition("e")
    yield from (f"{digits}e{int(exponent or 0) + by}" for by in (1, -1, 3, -3))


def moved_digits(text: str) -> Iterator[str]:
    """Yield variants of a decimal: each digit changed by one, the sign, then larger changes."""
    places = [n for n, c in enumerate(text.lower().partition("e")[0]) if c.isdigit()]
    for by in range(1, 10):
        for n in places:
            for moved in (int(text[n]) + by, int(text[n]) - by):
                if 0 <= moved <= 9:
                    yield f"{text[:n]}{moved}{text[n + 1 :]}"
        if by == 1:
            yield text[1:] if text.startswith("-") else "-" + text


def no_inputs_give_it(claim: Claim) -> bool:
    """Return whether no inputs in the box give a value in the printed interval."""
    says = cast(Rounds, claim.statement)
    interval = printed(says.text)
    half = interval.width / 2 * says.half_units
    low, high = interval.middle - half, interval.middle + half
    for pieces in SPLITS:
        values = _values(says.term, claim.given, claim.proof, pieces)
        if values and all(v > high or v < low for v in values):
            return True
    return False


@lru_cache(maxsize=RANGES)
def _values(term: Basic, given: tuple[Basic, ...], proof: Printed, pieces: int) -> tuple[arb, ...]:
    """Yield balls for the term on cells that cover the box; none if there are too many."""
    claim = Claim("changed", "", proof, given=given, means=Rounds(term, "0"))
    try:
        number = number_of(claim)
    except InputError:
        return ()
    sides = [_pieces(side, pieces if side.width else 1) for side in number.inputs.values()]
    if math.prod(map(len, sides)) > CELLS:
        return ()
    with ball_precision(BITS):
        values = tuple(map(number.value, product(*sides)))
    return values if all(v.is_finite() for v in values) else ()


def _pieces(side: Interval, pieces: int) -> list[arb]:
    width = side.width / pieces
    ends = [(side.low + n * width, side.low + (n + 1) * width) for n in range(pieces)]
    return [Interval(*pair).ball() for pair in ends]


def _in_words(claim: Claim) -> Claim:
    """Return the claim without its formula, so that changed evidence does not contradict it."""
    return replace(claim, says=str(claim.says), given=())


# Bounds on boxes


def bound_changes(claim: Claim) -> Iterator[Changes]:
    """Yield the evidence with one margin changed: negated, or lowered by twice its size at a point.

    The mutant states that the changed margin is positive on the box.
    """
    proof = cast(Boxes, claim.proof)
    for n, bound in enumerate(proof.bounds, 1):

        def changed(margin: Named, bound: Bound = bound) -> Claim:
            other = replace(bound, margin=margin.changed, sufficient=False)
            return _with(_in_words(claim), bounds=(other,), stored=None)

        yield f"bound {n}", _lowered(bound), changed


def bounds_fail(claim: Claim) -> bool:
    """Return whether a ball shows that one of the bounds is violated at a point of its box."""
    bounds = cast(Boxes, claim.proof).bounds
    with ball_precision(BITS):
        return any(bound_fails(bound, p) for bound in bounds for p in _places(bound.box))


def bound_fails(bound: Bound, point: BoxPoint) -> bool:
    """Return whether a ball shows that the bound is violated at ``point``."""
    return bool(value_at(bound.margin, point) < 0)


def _places(region: Box) -> list[BoxPoint]:
    """Yield the centre of the box, then points near its corners."""
    inward = [(s.low + s.width / 2**32, s.high - s.width / 2**32) for s in region]
    centre = tuple(side.middle for side in region)
    return list(dict.fromkeys((centre, *product(*inward))))


def _lowered(bound: Bound) -> Iterator[Named]:
    margin = bound.margin
    yield Named("the margin negated", lambda *x: -margin(*x))
    for times in (2, 3, 5, 8, 13):
        for point in _places(bound.box):
            where = ", ".join(fraction_text(x) for x in point)
            with ball_precision(BITS):
                excess = times * abs(value_at(margin, point))
            if excess.is_finite():
                text = f"{times} x its size at {where} less"
                yield Named(text, lambda *x, e=excess: margin(*x) - e)


# Orders


def order_changes(claim: Claim) -> Iterator[Changes]:
    """Yield changes of the power of the remainder, and of the terms that are kept.

    For an order that is refuted on a path, only smaller orders are generated; they are false, too.
    """
    says = claim.statement
    if isinstance(says, As):
        place = f"order as {says.args[1]} -> {says.args[2]}"
        changes = islice(_orders(says, claim), SMALLER if is_refuted(claim) else None)
        yield place, changes, lambda changed: saying(claim, changed)


def is_refuted(claim: Claim) -> bool:
    """Return whether the evidence is meant to refute the claim."""
    return claim.expect is Verdict.REFUTED


SMALLER = 5
"""As many of the changed orders are smaller than what is said."""


def _orders(says: As, claim: Claim) -> Iterator[As]:
    equation, e, point, _ = says.args
    (node,) = (node for node in equation.atoms(AppliedUndef) if str(node.func) in ("O", "o"))
    if isinstance(e, Tuple) or isinstance(point, Tuple):
        along = getattr(claim.proof, "along", {})
        pairs = zip(e.args, point.args, strict=True)
        e, point = next(p for p in pairs if along.get(p[0], t).free_symbols)
    small = 1 / e if point in (oo, -oo) else e - point
    powers, flat = (small**n for n in range(1, 6)), (exp(-n / small) for n in (1, 2, 3, 4, 8, 16))
    for factor in (*powers, *flat, small / 5):
        yield As(equation.xreplace({node: node.func(node.args[0] * factor)}), *says.args[1:])
    for factor in (1 / small, 1 / small**2, 1 + small, exp(1 / small)):
        changed = equal(equation.lhs * factor, equation.rhs)
        yield As(changed, *says.args[1:])


def order_fails(claim: Claim) -> bool:
    """Return whether balls show that the ratio grows (for o: does not shrink) near the limit."""
    says = claim.statement
    stated = ordered(says.args[0]) if isinstance(says, As) else None
    if stated is None or not isinstance(says, As) or not isinstance(says.args[1], Symbol):
        return False
    _, x, point, side = says.args
    if (stated.difference.free_symbols | stated.gauge.free_symbols) - {x}:
        return False
    ratios = []
    with ball_precision(NEAR_BITS):
        for n in NEAR:
            near = arb(2) ** -n
            here = 1 / near if point is oo else value(point, {}) + int(side or 1) * near
            f, g = (value(e, {x: here}) for e in (stated.difference, stated.gauge))
            ratios.append(abs(f / g))
        first, second, third = ratios
        if stated.kind == "O":
            return bool(second > 2 * first and third > 2 * second and first > 0)
        return bool(second > LESS * first and third > LESS * second and first > 0)
