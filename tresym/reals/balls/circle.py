"""Enclose an analytic function on an interval by a polynomial, from its values on a circle.

The coefficients of f(m + h s) = Σ cₖ sᵏ are a discrete Fourier sum of n values on the circle of
radius h about m. If f is analytic on the disc of radius 4h and at most M there, then |cₖ| ≤ M·4⁻ᵏ
(Cauchy's estimates), so that what the sum adds to the coefficients (those of order k + n, k + 2n,
…) and what the polynomial leaves out are together at most 3M·4⁻ⁿ on |s| ≤ 1. This needs no formula
for derivatives, so it serves Bessel functions and Γ as well as exp. For example, J₀ on [1, 2] is a
polynomial of degree 39 to 22 digits.

Source: L. N. Trefethen, J. A. C. Weideman, *The exponentially convergent trapezoidal rule*, SIAM
Review 56, 2014.
"""

from __future__ import annotations

from functools import lru_cache

from flint import acb, arb, arb_poly, ctx, fmpq

from tresym.reals.domain.compiled import Compiled
from tresym.reals.domain.evaluation import UndefinedError

ENOUGH = 20


def over_a_ball(f: Compiled, x: arb) -> arb:
    """Return a ball that contains f at every point of a ball; NaN if it is not shown analytic."""
    found = on_a_circle(f, x.mid(), arb(x.rad()), ENOUGH)
    if found is None:
        return arb.nan()
    series, rest = found
    c = series.coeffs()
    value = c[0] + arb(0, rest) if c else arb(0, rest)
    if len(c) > 1:
        value += arb(0, abs(c[1]).upper())
    for k in range(2, len(c)):
        top = abs(c[k]).upper()
        even = c[k].union(arb(0)) if k % 2 == 0 else arb(0, top)
        value += even
    return value


@lru_cache(maxsize=16)
def _circle(terms: int, precision: int) -> list[acb]:
    """Return the points of the upper half of the unit circle, at the working precision."""
    angles = [fmpq(2 * j, terms) for j in range(terms // 2 + 1)]
    return [acb(arb.cos_pi_fmpq(x), arb.sin_pi_fmpq(x)) for x in angles]


def on_a_circle(
    f: Compiled, middle: fmpq | arb, half: fmpq | arb, terms: int
) -> tuple[arb_poly, arb] | None:
    """Return coefficients by Cauchy's formula, and a bound of what is left out."""
    m, h = arb(middle), arb(half)
    reach = (4 * h).upper()
    square = acb(m + arb(0, reach), arb(0, reach))
    try:
        size = abs(f.holomorphic(square))
        if not size.is_finite() or not f.real(m).is_finite():
            return None
        values = [f.holomorphic(m + h * point) for point in _circle(terms, ctx.prec)]
    except (UndefinedError, ValueError, ZeroDivisionError):
        return None
    if not all(value.is_finite() for value in values):
        return None
    lower = [value.conjugate() for value in values[1 : (terms + 1) // 2]]
    sums = acb.dft([*values, *reversed(lower)])
    series = arb_poly([value.real / terms for value in sums])
    return series, (3 * size.upper() / arb(4) ** terms).upper()
