"""Changes of printed numbers, of bounds on boxes and of orders, and what shows each violated.

Only balls decide that a changed number, bound or order is false, at points or over a whole box of
inputs; nothing is shared with the searches that are to refuse it.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import product
from typing import Any, cast

from flint import arb, fmpq
from sympy import Basic

from tresym.ledger.claim import Claim, Printed
from tresym.ledger.evidence.balls import Asymptotics, Boxes
from tresym.ledger.evidence.printed import number_of
from tresym.ledger.statements import Rounds
from tresym.reals.balls.boxes import Bound, Box, BoxPoint, value_at
from tresym.reals.balls.order import Order
from tresym.reals.numbers.arithmetic import ball_precision, balls
from tresym.reals.numbers.exact import InputError, Interval, fraction_text, printed

Changes = tuple[str, Iterable[Any], Callable[[Any], Claim]]
"""A place, the changes that can be made there, and the claim that each makes."""

BITS = 128
SPLITS = (1, 4, 16)
CELLS = 16
"""Pieces that each input of a printed number is cut into, and the most cells they may make."""
RANGES = 1024
NEAR = (12, 20, 28)
"""Where an order is looked at: small parameters 2^−n, with as many bits as follow."""
NEAR_BITS = 640
LESS = arb("0.9")
AWAY = arb("0.0625")


@dataclass(frozen=True)
class Named:
    """A changed function or statement, with the change in words."""

    text: str
    changed: Any

    def __str__(self) -> str:
        return self.text


# Printed numbers


def printed_changes(
    claim: Claim, mutations: Callable[[Basic], Iterable[Basic]]
) -> Iterator[Changes]:
    """The term changed, and digits moved in the printed number and in every printed input."""
    says = cast(Rounds, claim.statement)

    def stated(term: Basic, text: str) -> Claim:
        return replace(claim, means=Rounds(term, text, says.half_units))

    yield "printed number", moved_digits(says.text), lambda text: stated(says.term, text)
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


def moved_digits(text: str) -> Iterator[str]:
    """Each digit before the exponent by one, leading ones first, the sign, then by more."""
    places = [n for n, c in enumerate(text.lower().partition("e")[0]) if c.isdigit()]
    for by in range(1, 10):
        for n in places:
            for moved in (int(text[n]) + by, int(text[n]) - by):
                if 0 <= moved <= 9:
                    yield f"{text[:n]}{moved}{text[n + 1 :]}"
        if by == 1:
            yield text[1:] if text.startswith("-") else "-" + text


def no_inputs_give_it(claim: Claim) -> bool:
    """Whether balls over pieces of the box of inputs all miss the printed interval."""
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
    """Balls for the term over cells that cover its inputs; none where they are too many."""
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
    """The claim without its formula, of which changed evidence says nothing."""
    return replace(claim, says=str(claim.says), given=())


# Bounds on boxes


def bound_changes(claim: Claim) -> Iterator[Changes]:
    """Each margin, alone: negated, or lowered by twice its size at the centre or at a corner.

    What is claimed is that the changed margin is positive on the box, no more and no less.
    """
    proof = cast(Boxes, claim.proof)
    for n, bound in enumerate(proof.bounds, 1):

        def changed(margin: Named, bound: Bound = bound) -> Claim:
            other = replace(bound, margin=margin.changed, sufficient=False)
            return _with(_in_words(claim), bounds=(other,), stored=None)

        yield f"bound {n}", _lowered(bound), changed


def bounds_fail(claim: Claim) -> bool:
    """Whether a ball shows one of the bounds violated at a point of its box."""
    bounds = cast(Boxes, claim.proof).bounds
    with ball_precision(BITS):
        return any(bound_fails(bound, p) for bound in bounds for p in _places(bound.box))


def bound_fails(bound: Bound, point: BoxPoint) -> bool:
    """Whether a ball shows the bound violated at ``point``."""
    return bool(value_at(bound.margin, point) < 0)


def _places(region: Box) -> list[BoxPoint]:
    """The centre of the box, then points near its corners."""
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
    """The gauge, the function, and for "at most C times" the constant and the range."""
    proof = cast(Asymptotics, claim.proof)
    words = _in_words(claim)
    yield "order", _orders(proof.statement), lambda named: _with(words, statement=named.changed)


def _orders(order: Order) -> Iterator[Named]:
    f, g = order.function, order.gauge

    def small(x: Any) -> Any:
        return order.side / x if order.at is None else (x - order.at) * order.side

    def gauge(text: str, changed: Callable[[Any, Any], Any]) -> Named:
        return Named(text, replace(order, gauge=changed))

    yield gauge("t g", lambda x, m: small(x) * g(x, m))
    yield gauge("t^2 g", lambda x, m: small(x) ** 2 * g(x, m))
    yield Named("f/t", replace(order, function=lambda x, m: f(x, m) / small(x)))
    yield Named("f/t^2", replace(order, function=lambda x, m: f(x, m) / small(x) ** 2))
    yield gauge("t^3 g", lambda x, m: small(x) ** 3 * g(x, m))
    yield gauge("g/2", lambda x, m: g(x, m) / 2)
    yield gauge("2 g", lambda x, m: 2 * g(x, m))
    yield gauge("-g", lambda x, m: -g(x, m))
    yield gauge("g/t", lambda x, m: g(x, m) / small(x))
    yield Named("f exp(1/t)", replace(order, function=lambda x, m: f(x, m) * _e(small(x), m)))
    yield Named("f exp(2/t)", replace(order, function=lambda x, m: f(x, m) * _e(small(x) / 2, m)))
    yield gauge("g exp(-1/t)", lambda x, m: g(x, m) / _e(small(x), m))
    yield gauge("g exp(-2/t)", lambda x, m: g(x, m) / _e(small(x) / 2, m))
    yield gauge("t g exp(-1/t)", lambda x, m: small(x) * g(x, m) / _e(small(x), m))
    if order.constant is not None:
        for part in (2, 4, 16):
            yield Named(f"C/{part}", replace(order, constant=order.constant / part))
            if order.upto is not None:
                wider = replace(order, upto=order.upto * part)
                yield Named(f"up to {part} times as far", wider)


def _e(t: Any, m: Any) -> Any:
    return m.exp(1 / t)


def order_fails(claim: Claim) -> bool:
    """Whether balls show it: the ratio grows, stays, or is off 1 where it must not."""
    order = cast(Asymptotics, claim.proof).statement
    with ball_precision(NEAR_BITS):
        if order.kind == "<=":
            reach = fmpq(2**12) if order.upto is None else order.upto
            ratios = (_ratio(order, reach / fmpq(2) ** k) for k in range(25))
            return any(ratio > arb(order.constant) for ratio in ratios)
        first, second, third = (_ratio(order, fmpq(1, 2**n)) for n in NEAR)
        if order.kind == "O":
            return bool(second > 2 * first and third > 2 * second and first > 0)
        if order.kind == "o":
            return bool(second > LESS * first and third > LESS * second and first > 0)
        off, later = abs(second - 1), abs(third - 1)
        return bool(off > AWAY and later > AWAY and later > LESS * off) or _opposite(order)


def _ratio(order: Order, t: fmpq) -> arb:
    """|f/g| where the small parameter is ``t``; not finite where a ball cannot tell."""
    return abs(_quotient(order, t))


def _quotient(order: Order, t: fmpq) -> arb:
    f, g = (order.at_parameter(h, arb(t), balls) for h in (order.function, order.gauge))
    return f / g if not g.contains(0) else arb.nan()


def _opposite(order: Order) -> bool:
    return all(_quotient(order, fmpq(1, 2**n)) < 0 for n in NEAR)
