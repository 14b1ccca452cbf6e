"""Signs and ranges of constants and of sums and products of ranges.

For example, the range of π/2 − x for 0 < x < 1 is the interval from π/2 − 1 to π/2.
"""

from __future__ import annotations

from flint import fmpq

from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.expression import Expr
from tresym.reals.normal.box import REALS
from tresym.reals.numbers.arithmetic import ball_precision, decided
from tresym.reals.numbers.exact import Interval, rational_ends


def constant_sign(e: Expr) -> str | None:
    """Return the sign of a constant by its ball, or None."""

    def attempt() -> str | None:
        x = evaluate(e, {})
        return "+" if x > 0 else "-" if x < 0 else "0" if x.is_zero() else None

    return decided(attempt)


def constant_span(e: Expr) -> Interval:
    """Return rational ends of the ball of a constant."""
    with ball_precision():
        value = evaluate(e, {})
        low, high = rational_ends(value)[:2]
    below = None if low is None else fmpq((low * 2**64).floor() - 1, 2**64)
    above = None if high is None else fmpq((high * 2**64).ceil() + 1, 2**64)
    return Interval(below, above, True, True)


def span_sign(span: Interval) -> str | None:
    """Return the sign that all numbers of an interval have, or None."""
    if span.low is not None and span.low >= 0:
        return "+" if span.low > 0 or span.low_open else ">=0"
    if span.high is not None and span.high <= 0:
        return "-" if span.high < 0 or span.high_open else "<=0"
    return None


def beside(end: fmpq, found: str | None) -> Interval:
    """Return the values above or below ``end``, by the sign of their difference from it."""
    if found in ("+", ">=0"):
        return Interval(end, None, found == "+")
    return Interval(None, end, False, found == "-") if found in ("-", "<=0") else REALS


def absolute_sign(span: Interval, nonzero: bool) -> Interval:
    """Return the range of the absolute value of an expression with a given range."""
    if span.low is not None and span.low >= 0:
        return span
    if span.high is not None and span.high <= 0:
        low = None if span.low is None else -span.low
        return Interval(-span.high, low, span.high_open, span.low_open)
    if span.low is None or span.high is None:
        return Interval(fmpq(0), None, nonzero)
    ends = (-span.low, not span.low_open), (span.high, not span.high_open)
    top, closed = max(ends)
    return Interval(fmpq(0), top, nonzero, not closed)


def times(x: str, y: str) -> str:
    """Return the sign of a product."""
    if "0" in (x, y):
        return "0"
    negative = (x in ("-", "<=0")) != (y in ("-", "<=0"))
    if {x, y} <= {"+", "-"}:
        return "-" if negative else "+"
    return "<=0" if negative else ">=0"
