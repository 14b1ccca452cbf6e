"""Enclose a function of one variable on an interval by Taylor's theorem.

    f(m + h) = c₀ + c₁h + … + c_{n−1}h^{n−1} + R hⁿ,

where R is the n-th Taylor coefficient over the whole interval. This gives sharp enclosures of a
difference that nearly vanishes together with its first derivatives, where direct evaluation in
balls and the mean value theorem are too coarse.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from flint import arb, arb_series, ctx, fmpq

from tresym.reals.balls.gradient import horner
from tresym.reals.domain.evaluation import UndefinedError, Walker
from tresym.reals.functions.table import TABLE
from tresym.reals.language.expression import Expr, off_the_cut

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
        found: arb_series = super()._computed(e)
        return found

    def _power(self, base: Expr, exponent: Expr) -> arb_series:
        x = self.value(base)
        r = exponent.args[0] if exponent.op == "number" else None
        if r is not None and r.q == 1:
            n = int(r)
            return x**n if n >= 0 else 1 / x**-n
        if r == fmpq(1, 2):
            return x.sqrt()
        return (x.log() * self.value(exponent)).exp()

    def _apply(self, name: str, *values: arb_series) -> arb_series:
        if name in ("abs", "cbrt") and (values[0][0] > 0 or values[0][0] < 0):
            (x,), side = values, 1 if values[0][0] > 0 else -1
            return x * side if name == "abs" else side * ((x * side).log() / 3).exp()
        row = TABLE[name]
        if row.series is not None:
            found: arb_series = row.series(*values)
            return found
        if row.quotient is None:
            raise ZeroDivisionError(f"{name} is not smooth")
        above, below = row.quotient
        return (self._apply(above, *values) if above else 1) / self._apply(below, *values)


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
