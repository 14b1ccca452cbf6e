"""Möbius substitution in a polynomial: map the range of a variable to [0, ∞]."""

from __future__ import annotations

from flint import fmpq, fmpz_mpoly

from tresym.reals.numbers.factoring import TooLargeError

MAX_DEGREE = 300


def on_orthant(p: fmpz_mpoly, i: int, low: fmpq | None, high: fmpq | None) -> fmpz_mpoly:
    """``p`` times something positive, its ``i``-th variable x written as x = M(u), u ≥ 0.

    Where both ends are finite, M(u) = (low + high·u)/(1 + u), and ``p`` is multiplied by a power of
    1 + u; else M(u) = low + u or high − u. One end at least is finite; u = 0 is ``low``, but
    ``high`` where it stands alone.

    Raises:
        TooLargeError: a power of M of more than ``MAX_DEGREE`` would be multiplied out.
    """
    if high is None and low == 0:
        return p
    context = p.context()
    u = context.gen(i)
    if low is not None and high is not None:
        scale = low.q * high.q
        top, bottom = u * (high * scale).p + (low * scale).p, (u + 1) * scale
    elif low is not None:
        top, bottom = u * low.q + low.p, context.constant(low.q)
    else:
        assert high is not None
        top, bottom = high.p - u * high.q, context.constant(high.q)
    coefficients = []
    while not p.is_zero():
        coefficients.append(p.subs({i: 0}))
        p = (p - coefficients[-1]) / u
        if len(coefficients) > MAX_DEGREE + 1:
            raise TooLargeError("a range is mapped, and a power of it is too large")
    result = coefficients.pop() if coefficients else context.constant(0)
    below = bottom
    for part in reversed(coefficients):
        result, below = result * top + part * below, below * bottom
    return result
