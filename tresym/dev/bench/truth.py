"""Count correct digits: compare a value of any arithmetic with an enclosure of the truth."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from flint import arb, ctx, fmpq

from tresym.dev.bench.run import RIGHT, WRONG, Judged
from tresym.reals.numbers.arithmetic import ball_precision

SLACK = 1.5
"""The number of digits by which a result may miss the request and still count as right."""


def true_digits(value: Any, truth: arb, *, most: float = 1e6) -> float:
    """Return −log₁₀ of the relative error of ``value``, at least 0 and at most ``most``.

    A ball counts by its midpoint. A value that is not a real number (NaN, complex, None) has 0
    digits.
    """
    found = as_ball(value)
    if found is None or not found.is_finite():
        return 0.0
    if truth.is_zero():
        return most if found.is_zero() else 0.0
    with ball_precision(max(ctx.prec, min(2 * truth.rel_accuracy_bits(), 100_000), 128)):
        error = abs(found / truth - 1).upper()
        if error <= 0:
            return most
        return min(most, max(0.0, float(-error.log() / arb.const_log10())))


def as_ball(value: Any) -> arb | None:
    """Return a float, mpmath number, fraction or ball's midpoint exactly; None for other values."""
    if isinstance(value, arb):
        return value.mid()
    if isinstance(value, float | int | fmpq):
        return arb(value)
    if hasattr(value, "man") and hasattr(value, "exp"):
        return arb((-int(value.man) if value < 0 else int(value.man), int(value.exp)))
    return None


def by_digits(truth: arb, asked: float, claims: float | None = None) -> Callable[[Any], Judged]:
    """Return a judge that compares the correct digits with those asked for.

    Args:
        truth: a ball around the true value.
        asked: the digits asked for.
        claims: the digits that the method claims, to be recorded.
    """

    def judge(value: Any) -> Judged:
        digits = true_digits(value, truth, most=asked + 50)
        if digits >= asked - SLACK:
            return Judged(digits, claims, RIGHT)
        why = f"{digits:.1f} true digits of the {asked:g} asked for"
        return Judged(digits, claims, WRONG, why)

    return judge
