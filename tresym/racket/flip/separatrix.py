"""Compute the flip defect ε₀ on the separatrix (γ = 0) as a ball of any width.

The paper's exponential equation loses its digits long before its root does, so it is solved in the
phase P (:mod:`tresym.racket.formulas.stable`), for which nothing cancels:

    g(P) = P − π − arctan(√(b/a) tanh(√(ab) P)) = 0.

*Uniqueness.* g′ = 1 − u′ with u′ = b/(cosh² T + (b/a) sinh² T), T = √(ab) P, is positive for every
P > 0, as b ≤ 1 < cosh² T; g(π) ≤ 0 < g(3π/2). So there is one root.

*Enclosure.* P(y), the inverse of y = g(P), is expanded at y = g(x) of a near exact point x: its
terms up to y³ come from the one value tanh kx, and **what is left out is below 17 y⁴** where x ≥ 3
and |y| ≤ 1/34. For with r = tan θ, w = kz = X + iY, |z − x| ≤ 1, so that X ≥ 2k and |Y| ≤ k,

    u′(z) = k sin θ cos θ / (cosh(w + iθ) cosh(w − iθ)),  |cosh(X + iY)|² = sinh² X + cos² Y.

Let k = s cos θ. If s ≥ 1, |u′| ≤ k cos θ/(2k)² ≤ 1/4. Else |cos(Y ± θ)| ≥ cos θ (1 − s − s²/2), and
|u′| ≤ s/(4s² + max(0, 1 − s − s²/2)²) < 1/2. So |g′ − 1| < 1/2 on that disc, g is one-to-one there,
its image holds the disc of radius 1/2 around y, and P(y) − x is below 1 on it: the m-th
coefficient, 2^m times a mean over its circle, is below 2^m, and Σ (2|y|)^m from m = 4 on below
17 y⁴.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from flint import arb, fmpq

from tresym.racket.formulas import stable
from tresym.racket.result import GUARD_BITS
from tresym.reals.numbers.arithmetic import Balls, ball_precision, balls, bits

LARGEST_ARGUMENT = 10**17
"""For larger T = √(ab) P, where ε₀ < 10^(−4·10^16), ε₀ is not distinguished from 0."""

FLOAT_BITS = 48
"""Bits of the float64 approximation that are expected to be correct; this only affects speed."""

LARGEST_RESIDUAL = fmpq(1, 34)
LARGE = 16
"""For larger √(ab), sech² √(ab) P is not computed as 1 − tanh², which would cancel."""


class Separatrix(NamedTuple):
    """Balls around the phase P, the defect ε₀ and the flip Δψ = π − 2ε₀, in radians."""

    phase: arb
    defect: arb
    flip: arb


def float_phase(k: float, b: float) -> tuple[float, float]:
    """Compute the phase P and the slope g′(P) in float64.

    Newton's method from P = π is used: g is convex, so the steps are monotone after the first.

    Args:
        k: √(ab); 0 and ∞ are allowed.
        b: the shape parameter b.
    """
    phase = math.pi
    for _ in range(8):
        argument = k * phase
        tangent = math.tanh(argument)
        ratio = b * phase * (tangent / argument if argument > 1e-9 else 1.0)
        residual = phase - math.pi - math.atan(ratio)
        slope = 1 - b * (1 - tangent * tangent) / (1 + ratio * ratio)
        phase -= residual / slope
        if abs(residual) < 1e-9:
            break
    return phase, slope


def enclose_phase(k: arb, r: arb, precision: int) -> arb:
    """Return the phase as a ball of radius about 2^−``precision``, at that working precision.

    Each round quadruples the number of correct bits of the float64 approximation; only the last
    round needs the full precision.
    """
    near = arb(float_phase(float(k), float(k * r))[0])
    for rising in _roundings(precision):
        with ball_precision(rising + 16):
            near = root_from(near, k, r).mid()
    return root_from(near, k, r)


def _roundings(precision: int) -> list[int]:
    """The correct bits after each round, from the float64 approximation to ``precision``/4."""
    steps = []
    while (precision := precision // 4 + 2) > FLOAT_BITS:
        steps.append(precision)
    return steps[::-1]


def root_from(x: arb, k: arb, r: arb) -> arb:
    """Return a ball that contains the unique root, from an exact point ``x`` ≥ 3 near it.

    With v = u′ and w = −v′/2v, the terms of the inverse in h = y/(1 − v) and c = vw/(1 − v) are
    h (1 + hc + h² (2cw + 6c² − vw′/(1 − v))/3).

    Raises:
        ArithmeticError: ``x`` is not near enough, or the precision is too low.
    """
    argument = k * x
    tangent = argument.tanh()
    ratio = r * tangent
    y = x - arb.pi() - ratio.atan()
    if not (x >= 3 and abs(y) <= LARGEST_RESIDUAL):
        raise ArithmeticError("the root is not enclosed; the precision is too low")
    square = ratio * ratio
    scale = k / (1 + square)
    if k < LARGE:
        short = scale * (1 - tangent * tangent)
    else:  # 1 − tanh² would cancel completely, and the result is multiplied by powers of k
        sech = argument.sech()
        short = scale * sech * sech
    v, grown = r * short, scale * (1 + r * r)
    w, over = grown * tangent, 1 / (1 - v)
    h, c = y * over, v * w * over
    # w′ = k (1 + r²) sech² kx (1 − r² tanh² kx) over (1 + r² tanh² kx)², in these terms.
    third = 2 * c * (w + 3 * c) - v * over * (1 + r * r) * short * scale * (1 - square)
    fourth = y * y
    return x - h * (1 + h * (c + h * third / 3)) + arb(0, 17 * fourth * fourth)


def defect_over(a: arb, b: arb, m: Balls = balls) -> arb:
    """Return a ball that contains ε₀ of every shape in the balls ``a`` and ``b``.

    Every root lies in [π, 3π/2], and in the image of every interval that contains it; so it lies in
    all iterates of the phase map.
    """
    k, r = m.sqrt(a * b), m.sqrt(b / a)
    phase = m.pi.union(3 * m.pi / 2)
    while True:
        image = stable.phase_map(phase, k, r, m).intersection(phase)
        if not image.rad() < phase.rad() * arb("0.99"):
            return stable.defect_at(image, k, r, m)
        phase = image


def solve(a: fmpq, b: fmpq, digits: int) -> Separatrix:
    """Compute ε₀ and the flip, each to ``digits`` certified digits, at increasing precision.

    If T is beyond ``LARGEST_ARGUMENT``, the defect is only proved to lie below 10^−digits.
    """
    precision = bits(digits, 20)
    while True:
        with ball_precision(precision):
            p, q = arb(a), arb(b)
            k = (p * q).sqrt()
            r = k / p
            if k > LARGEST_ARGUMENT:
                return _unresolved(digits)
            phase = enclose_phase(k, r, precision)
            defect = stable.defect_at(phase, k, r, balls)
            # π − 2ε₀ cancels only where ε₀ is near π/2.
            flip = arb.pi() - 2 * defect if defect < 1 else stable.flip_at(phase, k, r, balls)
        if min(defect.rel_accuracy_bits(), flip.rel_accuracy_bits()) >= bits(digits, GUARD_BITS):
            return Separatrix(phase, defect, flip)
        precision += 16 + precision // 4


def _unresolved(digits: int) -> Separatrix:
    """0 < ε₀ < 10^−(digits+2) by far: tan ε₀ < 1/sinh T with T > π·LARGEST_ARGUMENT."""
    with ball_precision(bits(digits, 64)):
        tiny = arb(fmpq(1, 10) ** (digits + 2))
        between = arb(0).union(arb.pi() / 2)
        return Separatrix(arb.pi() + between, arb(0, tiny), arb.pi() + arb(0, 2 * tiny))
