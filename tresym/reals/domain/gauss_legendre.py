"""Integrate an analytic function by the Gauss–Legendre rule, with many points in one call.

FLINT's quadrature asks for one value at a time, and below a few hundred bits most of its time goes
into these calls. Here each step of a compiled integrand is carried out for all points of a piece.
The rule with n ≥ 2 points on [m − r, m + r] has an error of at most

    (64/15)·r·M·ρ^(−2n)/(1 − ρ^(−2)),

if the integrand is analytic and at most M on the ellipse with the ends as foci and half-axes
r(ρ ± 1/ρ)/2. (Its Chebyshev coefficients are at most 2Mρ^(−k); those below 2n and the odd ones
contribute nothing, the others 32/15 each.) A complex ball around the ellipse proves both. A piece
on which none does is halved, unless the integrand is negligible there. Example: for ∫ 1/(1 + x²)
from 0 to 1 the ball around the ellipse with ρ = 2 stays away from ±i, and 32 points give 60 bits.

Source: L. N. Trefethen, *Is Gauss quadrature better than Clenshaw–Curtis?*, SIAM Review 50 (2008),
theorem 4.5.
"""

from __future__ import annotations

import operator
from functools import cache, lru_cache
from itertools import repeat
from math import ceil, log2
from typing import Protocol, runtime_checkable

from flint import acb, arb, ctx, fmpq


@runtime_checkable
class Integrand(Protocol):
    """A function of one variable at many points, as :class:`.compiled.Compiled` is."""

    def reals(self, points: list[arb]) -> list[arb] | None:
        """Return the values at real points; None if one is not proved to exist."""

    def holomorphics(self, points: list[acb]) -> list[acb]:
        """Return the values at complex balls, each not finite unless proved holomorphic there."""


RATIOS = (16, 8, 5, 3, 2)
"""The numbers ρ for which a ball around the ellipse is tried."""
SIZES = (*range(4, 17, 2), *range(20, 33, 4), *range(40, 65, 8), *range(80, 129, 16), 160, 192, 256)
"""The numbers of points."""
MOST = 400
"""How many pieces are looked at."""
SPARE = 3
"""How many bits the error of one piece lies below the error that is wanted."""


def integral(f: Integrand, low: arb, high: arb, accuracy: int) -> arb | None:
    """Return the integral of a function of one variable; None if balls do not show it analytic.

    Args:
        f: the integrand.
        low, high: the ends.
        accuracy: the bits that the error should have.
    """
    total, stack, count = arb(0), [(low, high)], 0
    wanted = accuracy + SPARE
    small = arb((1, -wanted))
    most = accuracy * 5 // 8 + 8
    while stack:
        a, b = stack.pop()
        count += 1
        if count > MOST:
            return None
        middle, half = (a + b) / 2, (b - a) / 2
        found = _points(f, middle, half, wanted)
        if found is None or found[0] > most:
            over = f.reals([a.union(b)])
            if over is not None and (over[0] * half).abs_upper() < small:
                total += 2 * half * over[0]
                continue
            middle = middle.mid()
            stack += [(middle, b), (a, middle)]
            continue
        n, error = found
        places, weights = _rule(n, ctx.prec)
        values = f.reals(list(map(operator.add, repeat(middle), map(half.__mul__, places))))
        if values is None:
            return None
        total += half * sum(map(operator.mul, weights, values), arb(0, error))
    return total


def _points(f: Integrand, middle: arb, half: arb, wanted: int) -> tuple[int, arb] | None:
    """Return the least number of points, and a bound of the error for a piece of half-width 1."""
    boxes = [acb(middle + half * x, half * y) for x, y, _ in _ellipses()]
    scale = log2(max(1e-300, float(half.abs_upper())))
    best: tuple[int, int, arb] | None = None
    for place, value in enumerate(f.holomorphics(boxes)):
        if not value.is_finite():
            continue
        bound = value.abs_upper()
        size = -wanted if bound.is_zero() else float(bound.log()) / 0.6931
        bits = wanted + size + scale + 2.5
        needed = ceil(bits / (2 * log2(RATIOS[place])))
        n = next((n for n in SIZES if n >= needed), None)
        if n is not None and (best is None or n < best[0]):
            best = n, place, bound
    if best is None:
        return None
    n, place, bound = best
    return n, (bound * _factor(place, n)).upper()


@lru_cache(maxsize=1)
def _ellipses() -> list[tuple[arb, arb, arb]]:
    """Return for each ρ the balls around 0 that contain the half-axes, and 64/(15(1 − ρ⁻²))."""
    found = []
    for ratio in RATIOS:
        x, y = (arb(fmpq(ratio * ratio + sign, 2 * ratio)).upper() for sign in (1, -1))
        found.append((arb(0, x), arb(0, y), arb(fmpq(64, 15) / (1 - fmpq(1, ratio**2))).upper()))
    return found


@cache
def _factor(place: int, n: int) -> arb:
    """Return the bound of the error over M for the half-width 1."""
    return (_ellipses()[place][2] * arb(fmpq(1, RATIOS[place] ** (2 * n)))).upper()


@lru_cache(maxsize=256)
def _rule(n: int, precision: int) -> tuple[list[arb], list[arb]]:
    """Return the points and the weights between −1 and 1, at the working precision."""
    pairs = [arb.legendre_p_root(n, k, weight=True) for k in range(n)]
    return [x for x, _ in pairs], [w for _, w in pairs]
