"""F(ε, γ) by Gauss's transformation of R_F and R_J together (DLMF 19.22.18–20).

With t = tan ε and **rest = (γ + b sin²ε)/cos²ε passed as it is** (at a turning point it is 0
exactly, and forming it by subtraction is what loses the digits), F = (1−b) u + Π, where

    u = R_F(x², y², z²),   Π = (ABC/3) R_J(x², y², z², z² + C²),
    x = A t,  y = √((a+b) rest),  z² = x² + G²,  G² = a(γ+b),  H² = b(a−γ),
    A² = (a+b)(γ+b),  B² = b(a+b),  C² = b(γ+b);  z² − y² = H², G² + C² = A², H² + C² = B².

*A step.* u keeps its value and 2 Π′ = Π + C u − arctan(C/z) when (G, H) go to their arithmetic and
geometric means and

    x′ = (x+y)/2,  y′ = z x′/z′,  A′ = (A+B)/2,  B′² = A′² − G′² + H′²,  C′ = C A′/B′.

So F = (1−b) u + Σ ± 2ⁿ (C_n u − arctan(C_n/z_n)), the last term positive and the others negative.

*The end.* The steps bring κ = (G² − H²)/2 = (y² − x²)/2 quadratically to 0. With μ = (x² + y²)/2,
d = z² − μ, D = d + C² and I_m = ½ ∫ (s+μ)^(−m) (s+z²)^(−½) ds, developed in κ,

    u = I₁ + κ²I₃/2 + …,   Π = C (u − arctan(C/z)/C − κ²I₂/(2D) + …).

What is left out of u lies in [0, ½σ⁴ I₁], and that of Π is at most C σ⁴ I₁ in size, where σ is the
larger of κ/μ and κ/D, as long as σ² ≤ 1/8: the coefficients of (1 − ρ²)^(−½) are positive and
decrease from 3/8, 0 ≤ I_(1+2j) ≤ I₁/μ^(2j), and √(D² − κ²) = D (1 − η/2 − r) with η = (κ/D)² and
0 ≤ r ≤ η²/7, so that 3σ⁴/7 + σ⁴/4 + 9σ⁴/49 < σ⁴ is in sight.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any, NamedTuple

from flint import arb, ctx

GAUSS_LIMIT = 24
"""Steps after which the transformation gives up (γ extremely near a)."""


class Ending(NamedTuple):
    """When to end; ``within(e)`` is anything of size at most e.

    The end is where 2κ is below ``small`` ≤ 0.4 of x² and A²: then σ < ``small``/1.6 ≤ ¼.
    """

    small: Any
    within: Callable[[Any], Any]


def turn_by_gauss(
    tangent: Any, rest: Any, a: Any, b: Any, gamma: Any, m: Any, ending: Ending
) -> Any:
    """F(ε, γ), 0 < ε < π/2, from ``tangent`` = tan ε and ``rest`` = (γ + b sin²ε)/cos²ε.

    Args:
        tangent: tan ε; best below 10 or so, as digits are lost beyond.
        rest: (γ + b sin²ε)/cos²ε = γ + (γ+b) tan²ε, as accurate as the answer shall be.
        a: the shape, like ``b``; all numbers of one arithmetic.
        b: see ``a``.
        gamma: −b < γ < a.
        m: the arithmetic.
        ending: :func:`ball_ending` or :data:`FLOAT_ENDING`.

    Raises:
        ArithmeticError: no end after ``GAUSS_LIMIT`` steps.
    """
    total, above = a + b, gamma + b
    g, far = a * above, total * above
    G, H, C = m.sqrt(g), m.sqrt(b * (a - gamma)), m.sqrt(b * above)
    A, B = m.sqrt(far), m.sqrt(b * total)
    x, y, split = A * tangent, m.sqrt(total * rest), gamma * total
    square = x * x
    z = m.sqrt(square + g)
    small, factor, angle, weight = ending.small, 1 - b, 0, 1
    while not (abs(split) < small * square and abs(split) < small * far):
        if weight == 1 << GAUSS_LIMIT:
            raise ArithmeticError("the Gauss transformation does not end: gamma is too near a")
        factor -= weight * C
        angle += weight * m.atan(C / z)
        weight *= 2
        inner = G * H
        G, H = (G + H) / 2, m.sqrt(inner)
        g = G * G
        split = g - inner
        A = (A + B) / 2
        far = A * A
        B = m.sqrt(far - split)
        C = C * A / B
        x = (x + y) / 2
        square = x * x
        before, z = z, m.sqrt(square + g)
        y = before * x / z
    last = weight * C
    time, third = _end(2 * square + split, 2 * g - split, 2 * far - split, split, z, m, ending)
    return (factor + last) * time + angle - last * third - weight * m.atan(C / z)


def _end(
    mean: Any, spread: Any, far: Any, split: Any, z: Any, m: Any, ending: Ending
) -> tuple[Any, Any]:
    """u and the correction of Π/C, from 2μ, 2d, 2D, 2κ and z."""
    long = m.sqrt(spread / 2)
    sum_ = long + z
    circular = m.log(2 * sum_ * sum_ / mean) / (2 * long)
    slope = 2 * z / mean
    second = (slope - circular) / spread
    third = (2 * slope / mean - 3 * second) / spread
    square = split * split
    near, apart = split / mean, split / far
    bound = near * near + apart * apart
    slack = circular * ending.within(bound * bound)
    return circular + square * third / 16 + slack, square * second / (4 * far) + slack


FLOAT_ENDING = Ending(1e-4, lambda _: 0.0)
"""For float64: what is left out is below 1e-16."""


def ball_ending() -> Ending:
    """For balls at the working precision: what is left out is in the ball, near its last bits."""
    return _ball_ending(ctx.prec)


@cache
def _ball_ending(precision: int) -> Ending:
    return Ending(arb((1, min(2 - precision // 4, -2))), lambda bound: arb(0, bound))
