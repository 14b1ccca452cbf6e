"""F(ε, γ) by Gauss's transformation of R_F and R_J together (DLMF 19.22.18–20).

With t = tan ε and **rest = (γ + b sin²ε)/cos²ε passed as it is** (at a turning point it is 0
exactly, and forming it by subtraction is what loses the digits), F = (1−b) u + Π, where

    u = R_F(x², y², z²),   Π = (ABC/3) R_J(x², y², z², z² + C²),
    x = A t,  y = √((a+b) rest),  z² = x² + G²,  G² = a(γ+b),  H² = b(a−γ),
    A² = (a+b)(γ+b),  B² = b(a+b),  C² = b(γ+b);  z² − y² = H², G² + C² = A², H² + C² = B².

*A step.* u is halved and 2 Π′ = Π + C u − arctan(C/z) when (G, H) go to G + H and 2√(GH), which
are twice their means (that spares the halves), and

    x′ = x + y,  y′ = 2 z x′/z′,  A′ = A + B,  B′² = A′² − G′² + H′²,  C′ = 2 C A′/B′.

Then G′² − H′² = ((G² − H²)/G′)², and F = (1−b) u + Σ ± (C_n u − 2ⁿ arctan(C_n/z_n)) with the u of
the start, the last term positive and the others negative.

*The way back.* Along the orbit x goes through 0 at ψ = 0, and y at a turning point, with a change
of sign; x′, y′, z and z′ stay positive, and both sides of a step are analytic there. So beyond the
far end of the quarter, where the phase is 2F(far end) − F(ε), the same steps hold with one sign
turned, and x′ = |G² − H²|/(|x| + |y|).

*The end.* The steps bring κ = (G² − H²)/2 = (y² − x²)/2 quadratically to 0. With μ = x² + κ,
d = G² − κ, D = A² − κ, which is d + C², and I_m = ½ ∫ (s+μ)^(−m) (s+z²)^(−½) ds from 0 to ∞,

    u = Σ c_j κ^(2j) I_(2j+1),   c_j = (1, 1/2, 3/8, …), the coefficients of (1 − ρ²)^(−½),
    Π = C (u₀ − arctan(C/z)/C + Σ T_j κ^(2j) (I_(2j+1) − I_(2j)/D)),   j = 1, 2, …,  u₀ = I₁,

as AB = √(D² − κ²) and 1/((s+μ)(s+μ+D)) splits into partial fractions. Here T_j is √(1−η) times
the sum of c_i η^(i−j), i ≥ j, with η = (κ/D)². The end takes j = 0, or j = 0 and 1 with T₁ = ½; by
parts I₂ and I₃ come from I₁ = log((√d + z)²/μ)/(2√d).

*What is left out.* Let σ be the larger of |κ|/μ and |κ|/D, and σ² ≤ 1/8. As c_j decreases,
c_j √(1−η) ≤ T_j ≤ c_j/√(1−η) ≤ 1.07 c_j; and 0 ≤ κ^(2j) I_(2j+1) ≤ σ^(2j) u₀, as it is with
I_(2j)/D. So from j on σ^(2j) u₀ times 8c_j/7 is more than all that u is without, and times
1.07·8c_j/7 more than Π/C is. With |T₁ − ½| ≤ 0.28 η on top, both are below σ² u₀ after j = 0 and
below σ⁴ u₀ after j = 1 (8/7·1.07·3/8 + 0.28 < 1).
"""

from __future__ import annotations

from functools import cache
from typing import Any, NamedTuple

from flint import arb, ctx

GAUSS_LIMIT = 24
"""Most steps of the transformation; more are needed only for γ extremely near a."""


class Ending(NamedTuple):
    """When to stop: 2κ is less than ``small`` times x² and A²; the term j = 0 alone below ``tiny``.

    ``left_out`` bounds the relative error of u and Π/C that remains.
    """

    small: Any
    tiny: Any
    left_out: Any


def turn_by_gauss(
    tangent: Any, rest: Any, a: Any, b: Any, gamma: Any, m: Any, ending: Ending, back: bool = False
) -> Any:
    """Compute F(ε, γ) for 0 ≤ ε < π/2 by Gauss's transformation.

    Args:
        tangent: tan ε; digits are lost if it is much larger than 10.
        rest: (γ + b sin²ε)/cos²ε = γ + (γ+b) tan²ε, as accurate as the result should be.
        a: the shape, like ``b``; all numbers of one arithmetic.
        b: see ``a``.
        gamma: −b < γ < a.
        m: the arithmetic.
        ending: :func:`ball_ending` or :data:`FLOAT_ENDING`.
        back: whether to return the phase of −ε (γ > 0), or that of ε on the way back (γ < 0).

    Raises:
        ArithmeticError: no convergence after ``GAUSS_LIMIT`` steps.
    """
    total, above = a + b, gamma + b
    far, g, split = total * above, a * above, gamma * total
    square = far * (tangent * tangent)
    C, z = m.sqrt(b * above), m.sqrt(square + g)
    small = ending.small
    if not back and abs(split) < small * square and abs(split) < small * far:
        return _end(square, g, far, split, C, z, 1 - b, m, ending)
    G, A = m.sqrt(g), m.sqrt(far)
    x = A * tangent
    y, H, B = m.sqrt(total * rest), m.sqrt(b * (a - gamma)), m.sqrt(b * total)
    sum_ = abs(split) / (x + y) if back else x + y
    factor, angle, weight = 1 - b, 0, 1
    while weight < 1 << GAUSS_LIMIT:
        factor -= C
        angle += weight * m.atan(C / z)
        weight *= 2
        inner = G * H
        x, G, A = sum_, G + H, A + B
        square, g, far = x * x, G * G, A * A
        split = split * split / g
        B = m.sqrt(far - split)
        C = 2 * C * A / B
        before, z = z, m.sqrt(square + g)
        if split < small * square and split < small * far:
            return weight * _end(square, g, far, split, C, z, factor, m, ending) + angle
        sum_, H = x + 2 * before * x / z, 2 * m.sqrt(inner)
    raise ArithmeticError("the Gauss transformation does not end: gamma is too near a")


def _end(
    square: Any, g: Any, far: Any, split: Any, C: Any, z: Any, factor: Any, m: Any, ending: Ending
) -> Any:
    """``factor`` u + Π from x², G², A², 2κ, C and z, for small 2κ."""
    kappa, size, tiny = split / 2, abs(split), ending.tiny
    mean, d = square + kappa, g - kappa
    long = m.sqrt(d)
    sum_ = long + z
    time = m.log(sum_ * sum_ / mean) / (2 * long)
    found = ending.left_out * time * (abs(factor) + C) - m.atan(C / z)
    if not (size < tiny * square and size < tiny * far):
        ratio = kappa / mean
        slope = z * ratio
        second = (slope - kappa * time) / (2 * d)
        found -= C * (kappa / (2 * (far - kappa))) * second
        time += (slope * ratio - 3 * kappa * second) / (8 * d)
    return found + (factor + C) * time


def ending(small: Any, left_out: Any) -> Ending:
    """Return the ending for a given ``small`` ≤ 0.4; ``left_out`` must be at most small⁴/4.

    |κ|/μ is at most small/(2 − small) ≤ small/1.6 and σ⁴ < small⁴/6; with ``tiny`` σ² < small⁴/14.
    """
    return Ending(small, small * small / 2, left_out)


FLOAT_ENDING = ending(1e-4, 0.0)
"""The ending for float64, with a relative error below 1e-16."""


def ball_ending() -> Ending:
    """Return the ending for balls at the working precision; the error is included in the ball."""
    return _ball_ending(ctx.prec)


@cache
def _ball_ending(precision: int) -> Ending:
    exponent = min(2 - precision // 4, -2)
    return ending(arb((1, exponent)), arb(0, arb((1, 4 * exponent - 2))))
