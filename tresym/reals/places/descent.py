"""A point that refutes an inequality, looked for downhill from sampled points.

Directions and steps are those of a pattern search, which needs no derivatives. What it finds is
rounded to simple rationals, and judged at exact points alone.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import combinations

from flint import arb, fmpq

from tresym.reals.language.expression import Expr
from tresym.reals.numbers.arithmetic import WORKING, ball_precision
from tresym.reals.numbers.exact import near
from tresym.reals.places.conditions import Given
from tresym.reals.places.points import ExactPoint
from tresym.reals.places.values import evaluate

MAX_STARTS = 3
MAX_EVALUATIONS = 250
SMALLEST_STEP = fmpq(1, 2**30)
TOLERANCES = (fmpq(1, 2**6), fmpq(1, 2**12), fmpq(1, 2**20))


def low_points(
    difference: Expr, given: Given, starts: Iterable[ExactPoint]
) -> Iterator[ExactPoint]:
    """Points of ``given`` at which the difference is small, simple ones first."""
    with ball_precision(WORKING // 2):
        known = [(value, k, p) for k, p in enumerate(starts) if (value := _value(difference, p))]
    for _, _, start in sorted(known, key=lambda item: item[:2])[:MAX_STARTS]:
        with ball_precision(WORKING // 2):
            found = _descended(difference, given, start)
        for tolerance in TOLERANCES:
            yield {name: near(x, tolerance) for name, x in found.items()}
        yield found


def _value(difference: Expr, point: ExactPoint) -> float | None:
    value = evaluate(difference, {name: arb(x) for name, x in point.items()})
    return float(value.mid()) if value.is_finite() else None


def _inside(given: Given, point: ExactPoint) -> bool:
    at = {name: arb(x) for name, x in point.items()}
    return all(condition.holds_exactly(at) for condition in given.conditions)


def _descended(difference: Expr, given: Given, start: ExactPoint) -> ExactPoint:
    """Where no step of the pattern leads further down."""
    here, lowest, step, left = start, _value(difference, start), fmpq(1), MAX_EVALUATIONS
    directions = list(_directions(sorted(start)))
    while step > SMALLEST_STEP and left > 0 and lowest is not None:
        better = False
        for direction in directions:
            there = {name: x + step * direction.get(name, 0) for name, x in here.items()}
            left -= 1
            value = _value(difference, there) if _inside(given, there) else None
            if value is not None and value < lowest:
                here, lowest, better = there, value, True
        step = step * 2 if better else step / 4
    return here


def _directions(names: list[str]) -> Iterator[dict[str, int]]:
    """Along each axis, and along the diagonals of two."""
    for name in names:
        yield {name: 1}
        yield {name: -1}
    for first, second in combinations(names, 2):
        yield from ({first: i, second: j} for i in (1, -1) for j in (1, -1))
