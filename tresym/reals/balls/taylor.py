"""Enclose a function of one variable on an interval by Taylor's theorem.

    f(m + h) = c₀ + c₁h + … + c_{n−1}h^{n−1} + R hⁿ,

where R is the n-th Taylor coefficient over the whole interval. This gives sharp enclosures of a
difference that nearly vanishes together with its first derivatives, where direct evaluation in
balls and the mean value theorem are too coarse. For example, 1 − cos(x) − x²/2 + x⁴/24 is at most
x⁶/720, below 10⁻¹⁰ on [0, 1/16], where the balls of its terms add up to 10⁻³.

Source: K. Makino, M. Berz, *Taylor models and other validated functional inclusion methods*,
Int. J. Pure Appl. Math. 4, 2003.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Sequence
from functools import partial, reduce
from typing import Any

from flint import arb, arb_series, ctx, fmpq

from tresym.reals.balls.gradient import horner
from tresym.reals.domain.evaluation import UndefinedError, Walker
from tresym.reals.functions.table import TABLE
from tresym.reals.language.expression import Expr, off_the_cut, symbol

TERMS = 8


class InSeries(Walker):
    """Compute Taylor coefficients; NaN or ``ZeroDivisionError`` where a function is not smooth."""

    def _number(self, x: Any) -> arb_series:
        return x if isinstance(x, arb_series) else arb_series([arb(x)], ctx.cap)

    def _computed(self, e: Expr) -> arb_series:
        if e.op == "pi":
            return self._number(arb.pi())
        if e.op == "atan2":
            return self.value(off_the_cut(e))
        series: arb_series = super()._computed(e)
        return series

    def _power(self, base: Expr, exponent: Expr) -> arb_series:
        x = self.value(base)
        if exponent.op == "number":
            return _rational_power(exponent.args[0], x)
        return _power(x, self.value(exponent))

    def _apply(self, name: str, *values: arb_series) -> arb_series:
        if name in ("abs", "cbrt") and (values[0][0] > 0 or values[0][0] < 0):
            (x,), side = values, 1 if values[0][0] > 0 else -1
            return x * side if name == "abs" else side * ((x * side).log() / 3).exp()
        row = TABLE[name]
        if row.series is not None:
            series: arb_series = row.series(*values)
            return series
        if row.quotient is None:
            raise ZeroDivisionError(f"{name} is not smooth")
        above, below = row.quotient
        return (self._apply(above, *values) if above else 1) / self._apply(below, *values)


class SeriesSteps:
    """An expression as a list of steps in Taylor series, for evaluation at many points.

    The values are those of :class:`InSeries`; equal parts share a step.
    """

    def __init__(self, e: Expr, names: Sequence[str]) -> None:
        """Compile an expression.

        Args:
            e: the expression.
            names: its variables, in the order of the values of a point.
        """
        self._places = {symbol(name): n for n, name in enumerate(names)}
        self._constants: list[tuple[int, Expr]] = []
        self._steps: list[tuple[Callable[..., arb_series], tuple[int, ...], int]] = []
        self._walker = InSeries(None, {})
        self._end = self._place(e)

    def value(self, point: Sequence[arb_series]) -> arb_series:
        """Return the series; raises what :class:`InSeries` raises."""
        values: list[Any] = [*point, *[None] * (len(self._places) - len(point))]
        for k, leaf in self._constants:
            values[k] = self._walker._number(arb.pi() if leaf.op == "pi" else leaf.args[0])
        for operation, places, k in self._steps:
            values[k] = operation(*(values[n] for n in places))
        series: arb_series = values[self._end]
        return series

    def _place(self, e: Expr) -> int:
        """Return the place of the value of ``e``, which is computed in a step if it is new."""
        if e in self._places:
            return self._places[e]
        if e.op == "symbol":
            raise UndefinedError(e)
        if e.op == "atan2":
            return self._place(off_the_cut(e))
        if e.op in ("number", "pi"):
            k = self._places[e] = len(self._places)
            self._constants.append((k, e))
            return k
        exponent = e.args[1] if e.op == "^" else None
        if exponent is not None and exponent.op == "number":
            operation: Callable[..., arb_series] = partial(_rational_power, exponent.args[0])
            places: tuple[int, ...] = (self._place(e.args[0]),)
        else:
            places = tuple(self._place(arg) for arg in e.args)
            operation = partial(self._walker._apply, e.op)
            if e.op in ("+", "*", "^"):
                operation = {"+": _sum, "*": _product, "^": _power}[e.op]
        k = self._places[e] = len(self._places)
        self._steps.append((operation, places, k))
        return k


def _sum(*values: arb_series) -> arb_series:
    return reduce(operator.add, values)


def _product(*values: arb_series) -> arb_series:
    return reduce(operator.mul, values)


def _power(base: arb_series, exponent: arb_series) -> arb_series:
    return (base.log() * exponent).exp()


def _rational_power(r: fmpq, x: arb_series) -> arb_series:
    if r.q == 1:
        return x ** int(r) if r >= 0 else 1 / x ** -int(r)
    return x.sqrt() if r == fmpq(1, 2) else (x.log() * arb(r)).exp()


def taylor_value(
    e: Expr,
    name: str,
    x: arb,
    terms: int = TERMS,
    series: Callable[[dict[str, Any]], Walker] | None = None,
) -> arb:
    """Return a ball that contains ``e`` at every value of its variable in ``x``.

    FLINT truncates every series at a global length, which is raised here and restored.

    Args:
        e: the expression.
        name: its variable.
        x: a ball.
        terms: the number of Taylor coefficients before the remainder.
        series: returns a walker that computes Taylor coefficients with these variables.

    Returns:
        The ball; NaN if no enclosure is found.
    """
    middle = x.mid()
    series = series or partial(InSeries, None)
    before = ctx.cap
    ctx.cap = terms + 1
    try:
        near, over = (series({name: arb_series([at, 1], ctx.cap)}).value(e) for at in (middle, x))
        if min(near.prec, over.prec) <= terms:
            return arb.nan()
        return horner([near[j] for j in range(terms)], x - middle, over[terms])
    except (ValueError, ZeroDivisionError, UndefinedError):
        return arb.nan()
    finally:
        ctx.cap = before
