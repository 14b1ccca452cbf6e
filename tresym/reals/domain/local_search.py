"""Search for a counterexample to an inequality by descent from sample points.

The directions and steps are those of a pattern search, which needs no derivatives. The points found
are rounded to simple rationals. Only exact points are used as counterexamples.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import combinations

from flint import fmpq

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.narrow_regions import climbed
from tresym.reals.domain.sample_points import ExactPoint
from tresym.reals.language.expression import Expr
from tresym.reals.numbers.arithmetic import WORKING, ball_precision
from tresym.reals.numbers.exact import near

MAX_STARTS = 3
SMALLEST_STEP = fmpq(1, 2**30)
TOLERANCES = (fmpq(1, 2**6), fmpq(1, 2**12), fmpq(1, 2**20))


def low_points(
    difference: Expr, given: Given, starts: Iterable[ExactPoint]
) -> Iterator[ExactPoint]:
    """Yield points of ``given`` at which the difference is small, simple ones first.

    Args:
        difference: the expression that is minimised.
        given: the conditions.
        starts: points from which the descent starts.
    """

    def depth(point: ExactPoint) -> float | None:
        with ball_precision(WORKING // 2):
            value = evaluate(difference, point)
            inside = all(condition.holds_exactly(point) for condition in given.conditions)
            return -float(value.mid()) if inside and value.is_finite() else None

    known = [(-size, k, p) for k, p in enumerate(starts) if (size := depth(p)) is not None]
    for _, _, start in sorted(known, key=lambda item: item[:2])[:MAX_STARTS]:
        lowest = climbed(depth, start, list(_directions(sorted(start))), SMALLEST_STEP)
        for tolerance in TOLERANCES:
            yield {name: near(x, tolerance) for name, x in lowest.items()}
        yield lowest


def _directions(names: list[str]) -> Iterator[dict[str, int]]:
    """Yield the directions of each axis and of the diagonals of two axes."""
    for name in names:
        yield {name: 1}
        yield {name: -1}
    for first, second in combinations(names, 2):
        yield from ({first: i, second: j} for i in (1, -1) for j in (1, -1))
