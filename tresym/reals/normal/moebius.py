"""Möbius substitution in a polynomial: map the range of a variable to [0, ∞]."""

from __future__ import annotations

from flint import fmpq, fmpz_mpoly

from tresym.reals.numbers.factoring import TooLargeError

MAX_DEGREE = 300


def on_orthant(p: fmpz_mpoly, i: int, low: fmpq | None, high: fmpq | None) -> fmpz_mpoly:
    """Map the range of a variable to [0, ∞] by a Möbius substitution.

    With two finite ends, x = (low + high·u)/(1 + u), and the result is multiplied by a power of 1 +
    u. Otherwise x = low + u or x = high − u. So u = 0 corresponds to ``low``, or to ``high`` if
    ``low`` is None.

    Args:
        p: the polynomial.
        i: the index of the variable x.
        low: the lower end, or None for −∞.
        high: the upper end, or None for ∞. At least one end is finite.

    Returns:
        The polynomial in u ≥ 0, multiplied by a positive factor.

    Raises:
        TooLargeError: the degree in the variable is more than ``MAX_DEGREE``.
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
            raise TooLargeError(
                f"a polynomial of degree over {MAX_DEGREE} in a variable with a range"
            )
    result = coefficients.pop() if coefficients else context.constant(0)
    below = bottom
    for part in reversed(coefficients):
        result, below = result * top + part * below, below * bottom
    return result
