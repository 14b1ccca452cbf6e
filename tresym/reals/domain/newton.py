"""Enclose points that satisfy equations, by the interval Newton method.

With k equations, all variables but k are set to rational values. Floating-point Newton steps lead
near a solution. Then one interval Newton step N(X) = m − F′(X)⁻¹ F(m) is made. If N(X) lies in the
interior of X, X contains exactly one solution. Source: R. Moore, R. Kearfott, M. Cloud,
*Introduction to Interval Analysis*, 8.4.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations, islice

from flint import arb, arb_mat

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.sample_points import _sample
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import Expr, symbols
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import Interval

BITS, STEPS, STARTS, MOST_CHOICES = 128, 40, 24, 6
SMALL, WIDTH = arb((1, -80)), arb((1, -60))


def points_on(
    equations: Sequence[Expr], given: Given, names: Sequence[str]
) -> Iterator[dict[str, arb]]:
    """Yield balls that contain exactly one point each at which all ``equations`` vanish.

    Args:
        equations: the expressions that vanish.
        given: conditions that are proved to hold strictly at the points.
        names: further symbols for which the points have values.
    """
    known = sorted(frozenset(names).union(given.names, *map(symbols, equations)))
    slopes = [{n: differentiate(e, n) for n in symbols(e)} for e in equations]
    inside = sorted(frozenset().union(*map(symbols, equations)))
    ranges = [given.box.get(name, Interval()) for name in known]
    choices = list(islice(combinations(inside, len(equations)), MOST_CHOICES))
    for k in range(STARTS if choices else 0):
        with ball_precision(BITS):  # not around the yield: the caller would run inside it
            start = {
                name: arb(_sample(where, k, j))
                for j, (name, where) in enumerate(zip(known, ranges, strict=True))
            }
            point = _solution(equations, slopes, start, choices[k % len(choices)])
            holds = point is not None and all(c.holds(point) for c in given.conditions)
        if point is not None and holds:
            yield point


def _solution(
    equations: Sequence[Expr],
    slopes: Sequence[Mapping[str, Expr]],
    start: dict[str, arb],
    moving: Sequence[str],
) -> dict[str, arb] | None:
    """Return a ball with exactly one solution in the ``moving`` variables, or None."""

    def step(middle: dict[str, arb], where: dict[str, arb]) -> dict[str, arb] | None:
        values = arb_mat([[evaluate(e, middle)] for e in equations])
        rates = [[evaluate(s[n], where) if n in s else arb(0) for n in moving] for s in slopes]
        try:
            change = arb_mat(rates).solve(values)
        except ZeroDivisionError:
            return None
        return middle | {n: middle[n] - change[i, 0] for i, n in enumerate(moving)}

    point = start
    for _ in range(STEPS):
        after = step(point, point)
        if after is None or not all(after[n].is_finite() for n in moving):
            return None
        is_near = all(abs(after[n] - point[n]) < SMALL for n in moving)
        point = after | {n: after[n].mid() for n in moving}
        if is_near:
            break
    else:
        return None
    box = point | {n: point[n] + arb(0, WIDTH) for n in moving}
    enclosure = step(point, box)
    if enclosure is None or not all(box[n].contains_interior(enclosure[n]) for n in moving):
        return None
    return enclosure
