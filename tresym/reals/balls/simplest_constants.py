"""Guess the simplest constant near a ball: candidates for exact points."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from flint import arb, fmpq

from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.expression import PI, E, Expr, apply, number, sqrt
from tresym.reals.numbers.arithmetic import WORKING, ball_precision
from tresym.reals.numbers.exact import Interval, rational_ends

LARGEST_DENOMINATOR = 1_000

_KINDS: tuple[tuple[Callable[[arb], arb], Callable[[Expr], Expr]], ...] = (
    (lambda x: x / arb.pi(), lambda r: r * PI),
    (lambda x: x / arb(1).exp(), lambda r: r * E),
    (lambda x: x * arb(1).exp(), lambda r: r / E),
    (lambda x: x * abs(x), lambda r: sqrt(r) if r.args[0] > 0 else -sqrt(-r)),
    (lambda x: x.exp(), lambda r: apply("log", r)),
    (lambda x: x.log(), lambda r: apply("exp", r)),
    (lambda x: x.tan(), lambda r: apply("atan", r)),
)
"""Maps under which a constant may become a simple rational, with their inverses."""


def candidates(worst: Interval, known: Sequence[Expr] = ()) -> Iterator[Expr]:
    """Yield exact points near the interval ``worst``, the simplest ones of each kind.

    Args:
        worst: the interval in which a point of contact is expected.
        known: exact points that are yielded first if they lie in the interval.
    """
    seen: set[Expr] = set()
    for point in known:
        with ball_precision():
            is_near = evaluate(point, {}).overlaps(worst.ball())
        if is_near:
            seen.add(point)
            yield point
    for wider in (1, 2**12, 2**24):
        gap = wider * (worst.width or fmpq(1, 2**40))
        about = Interval(worst.low - gap, worst.high + gap)
        constants = [number(about.simplest())]
        with ball_precision():
            for there, back in _KINDS:
                low = rational_ends(there(arb(about.low))).low
                high = rational_ends(there(arb(about.high))).high
                if low is None or high is None or low > high:
                    continue
                r = Interval(low, high).simplest()
                if r != 0 and max(abs(r.p), r.q) < LARGEST_DENOMINATOR:
                    constants.append(back(number(r)))
        for point in constants:
            if point not in seen:
                seen.add(point)
                yield point


def enclosure(point: Expr) -> tuple[fmpq, fmpq]:
    """Return rationals on both sides of the constant, equal to it if it is rational."""
    if point.op == "number":
        return point.args[0], point.args[0]
    with ball_precision(2 * WORKING):
        value = evaluate(point, {})
        return value.lower().fmpq(), value.upper().fmpq()
