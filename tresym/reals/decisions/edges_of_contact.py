"""Divide out the power of a variable that vanishes on an edge of a box.

Example: ``sin(x*y) <= x*y given 0 < x <= 1, 0 < y <= 1``. Both sides are equal on the whole edge
x = 0, and no box beside that edge is closed by evaluation in balls. But the difference is D = x³ R,
where R is the third Taylor coefficient of D between the edge and x, and R is positive.

In general let the coefficients D₀, …, D_{n−1} of D in powers of x − c vanish identically in the
other variables, which is shown by exact normal forms. Where D is smooth between the edge and x,
Taylor's theorem gives D = (x − c)ⁿ R, where R is the n-th coefficient at a point between; with more
terms, R = D_n + D_{n+1} (x − c) + … is enclosed more sharply. Where the ball of R has the sign
wanted, so has D off the edge. A corner at which two such edges meet stays open.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from flint import arb, arb_series, ctx, fmpq

from tresym.reals.balls.gradient import horner
from tresym.reals.balls.taylor import SeriesSteps
from tresym.reals.decisions.identity import decide
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import UndefinedError
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import ZERO, Expr, number, substitute, symbols
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError, Interval
from tresym.reals.verdict import Verdict

HIGHEST = 8
"""The highest power that is divided out."""
MORE = 3
"""Taylor coefficients beyond the first that does not vanish, before the remainder."""
SHARES = (fmpq(3, 7), fmpq(5, 11), fmpq(8, 13))
"""Where on the edge it is seen which coefficients vanish."""
PRECISION = 256


class Edge(NamedTuple):
    """The edge of a box where a coordinate is ``at``, and the power that vanishes there.

    Attributes:
        axis: the number of the coordinate.
        at: its value on the edge.
        side: 1 if the box lies above that value, -1 if below.
        power: the difference is this power of the distance times a function.
    """

    axis: int
    at: fmpq
    side: int
    power: int


def edges_of_contact(
    difference: Expr, names: Sequence[str], box: Sequence[Interval], given: Given
) -> list[Edge]:
    """Return the edges of the box on which the difference vanishes identically.

    Args:
        difference: the expression.
        names: its variables, in the order of the sides of the box.
        box: the sides.
        given: conditions under which coefficients may be shown to vanish.
    """
    edges = []
    for axis, (name, where) in enumerate(zip(names, box, strict=True)):
        others = Given(tuple(c for c in given.comparisons if name not in symbols(c[0] - c[2])))
        for side, end in ((1, where.low), (-1, where.high)):
            power = _seen(difference, names, box, axis, end)
            if power and _vanish(difference, name, end, power, others):
                edges.append(Edge(axis, end, side, power))
    return edges


def _seen(
    difference: Expr, names: Sequence[str], box: Sequence[Interval], axis: int, end: fmpq
) -> int:
    """Return how many coefficients are 0 at sample points of an edge; 0 if that is not seen."""
    powers = set()
    try:
        steps = SeriesSteps(difference, names)
    except UndefinedError:
        return 0
    for share in SHARES:
        with ball_precision(PRECISION):
            point = [arb(x.low + share * (x.high - x.low)) for x in box]
            point[axis] = arb(end)
            series = _series(steps, point, axis, HIGHEST + 1)
        if series is None:
            return 0
        nonzero = (j for j in range(HIGHEST + 1) if not series[j].contains(0))
        powers.add(next(nonzero, 0))
    return min(powers)


def _vanish(difference: Expr, name: str, end: fmpq, power: int, given: Given) -> bool:
    """Return whether the first coefficients on an edge are shown to vanish identically."""
    put = {name: number(end)}
    try:
        for order in range(power):
            difference = differentiate(difference, name) if order else difference
            if decide(substitute(difference, put), ZERO, given).verdict is not Verdict.PROVED:
                return False
    except (InputError, ZeroDivisionError):
        return False
    return True


def _series(steps: SeriesSteps, point: Sequence[arb], axis: int, cap: int) -> list[arb] | None:
    """Return the first Taylor coefficients in one variable; None where there are none."""
    before = ctx.cap
    ctx.cap = cap
    try:
        at = [arb_series([x, 1] if n == axis else [x], cap) for n, x in enumerate(point)]
        value = steps.value(at)
        if value.prec < cap:
            return None
        coefficients = [value[j] for j in range(cap)]
        return coefficients if all(c.is_finite() for c in coefficients) else None
    except (ValueError, ZeroDivisionError, UndefinedError):
        return None
    finally:
        ctx.cap = before


class Quotient:
    """A difference over the power of the distance from an edge, and its slopes.

    The distance is taken to be positive, on either side of the edge. A slope of the quotient is the
    quotient of the slope, which vanishes on the edge as the difference does.
    """

    def __init__(
        self, difference: Expr, slopes: Sequence[Expr], names: Sequence[str], edge: Edge
    ) -> None:
        """Prepare the evaluation.

        Args:
            difference: the expression.
            slopes: its derivatives by the variables.
            names: the variables.
            edge: the edge.
        """
        self._value = SeriesSteps(difference, names)
        self._rates = [SeriesSteps(slope, names) for slope in slopes]
        self._edge = edge

    def least(self, box: Sequence[arb]) -> arb:
        """Return a ball whose lower end bounds the quotient on a box, or NaN.

        In the other variables the mean value theorem is used.
        """
        corner, spread = list(box), arb(0)
        for axis, (x, rate) in enumerate(zip(box, self._rates, strict=True)):
            if axis == self._edge.axis or x.is_exact():
                continue
            slope = self._over(rate, box)
            if not slope.is_finite():
                return arb.nan()
            if slope >= 0 or slope <= 0:
                corner[axis] = x.lower() if slope >= 0 else x.upper()
            else:
                corner[axis] = x.mid()
                spread += slope * (x - x.mid())
        return self._over(self._value, corner) + spread

    def _over(self, steps: SeriesSteps, box: Sequence[arb]) -> arb:
        """Return a ball for an expression that vanishes on the edge, over the power."""
        axis, at, side, power = self._edge
        x, edge = box[axis], arb(at)
        cap = power + MORE + 1
        there = _series(steps, [*box[:axis], edge, *box[axis + 1 :]], axis, cap)
        between = _series(steps, [*box[:axis], edge.union(x), *box[axis + 1 :]], axis, cap)
        if there is None or between is None:
            return arb.nan()
        value = horner(there[power:-1], x - edge, between[-1])
        return value if side > 0 or power % 2 == 0 else -value
