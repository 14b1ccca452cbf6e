"""F(ε, γ) = ∫_ε^{π/2} f dψ in Carlson's symmetric form, and its fast evaluation.

With sn² = a cos²ε/(a + b sin²ε), cn² = 1 − sn², dn² = (a+b) z/((γ+b)(a + b sin²ε)), n = b/a and
**z = γ + b sin²ε passed as it is** (forming it by subtraction is what loses the digits near the
turning point), the paper's integral is

    F = [(1−b) u + (a+b) n J]/ω,  ω = √(a(γ+b)),
    u = sn R_F(cn², dn², 1),      J = ∫ sn²/(1 + n sn²) du = (sn³/3) R_J(cn², dn², 1, 1 + n sn²).

Every term is positive, for every γ ≥ −b sin²ε. The same u and J serve any orbit
(:mod:`tresym.flip.orbit`), with other n and ω below the separatrix. They come by two routes:
FLINT's R_F, R_J, and the quadratic Gauss transformation of both together (DLMF 19.22.18–20), in
which the differences of the arguments are carried along, so that nothing is subtracted but in the
recursion for R_J.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

from flint import acb, arb, ctx

GAUSS_LIMIT = 24
"""Gauss steps after which the transformation gives up (γ extremely near a)."""


class Amplitude(NamedTuple):
    """Where an orbit stands: Jacobi's sn, cn ≥ 0, dn ≥ 0 and the parameter k², any arithmetic."""

    sn: Any
    cn: Any
    dn: Any
    modulus: Any


class Integrals(NamedTuple):
    """The time u and the third-kind integral J from sn = 0 to an amplitude."""

    time: Any
    third: Any


def amplitude(sine: Any, cosine: Any, z: Any, a: Any, b: Any, gamma: Any, m: Any) -> Amplitude:
    """The amplitude at an angle ψ in [0, π/2], from its sine and cosine and z = γ + b sin²ψ."""
    square = a + b * sine * sine
    root = m.sqrt(square)
    return Amplitude(
        m.sqrt(a) * cosine / root,
        m.sqrt(a + b) * sine / root,
        m.sqrt((a + b) * z / (gamma + b)) / root,
        b * (a - gamma) / (a * (gamma + b)),
    )


def turn(integrals: Integrals, a: Any, b: Any, gamma: Any, m: Any) -> Any:
    """F(ε, γ) from the integrals at the amplitude of ε."""
    return ((1 - b) * integrals.time + (a + b) * b / a * integrals.third) / m.sqrt(a * (gamma + b))


def by_flint(at: Amplitude, n: arb) -> Integrals:
    """u and J in balls by FLINT's certified R_F and R_J; any amplitude, sn < 0 too."""
    x, y = acb(_square(at.cn)), acb(_square(at.dn))
    square = at.sn * at.sn
    time = at.sn * acb.elliptic_rf(x, y, 1).real
    return Integrals(time, at.sn * square * acb.elliptic_rj(x, y, 1, 1 + n * square).real / 3)


def _square(x: arb) -> arb:
    """x² as a ball that holds no negative number."""
    square = x * x
    return square if square > 0 else square.nonnegative_part()


def by_gauss(at: Amplitude, n: Any, m: Any, stop: Callable[[Any], Any]) -> Integrals:
    """u and J by Gauss transformations of R_F(x², y², z²) and R_J(x², y², z², p²) together.

    Written in x, y, z and g = z² − x², h = z² − y², e = p² − z², which transform without
    subtraction; √g and √h follow the arithmetic-geometric mean.

    Args:
        at: the amplitude, 0 < sn ≤ 1.
        n: the characteristic, n > 0.
        m: the arithmetic.
        stop: given 2ρ = (x² − y²)/μ with μ = (x² + y²)/2, None to go on, or else the factor by
            which the elementary integrals at x² = y² = μ are off.

    Raises:
        ArithmeticError: no end after ``GAUSS_LIMIT`` steps.
    """
    sn, x, y, modulus = at
    z2 = z = 1
    g = sn * sn
    e, h = n * g, modulus * g
    trail: list[tuple[Any, Any, Any]] = []
    mean = (x * x + y * y) / 2
    while (factor := stop((x - y) * (x + y) / mean)) is None:
        if len(trail) == GAUSS_LIMIT:
            raise ArithmeticError("the Gauss transformation does not end: gamma is too near a")
        inner, outer, root = m.sqrt(g * h), m.sqrt((e + g) * (e + h)), m.sqrt(e)
        elementary = m.atan(root / z) / root
        e = e * (1 + (e + g + h) / (outer + inner)) / 2
        z2 = (z2 + x * y + inner) / 2
        g, h = ((g + h) / 2 + inner) / 2, inner
        trail.append((outer, elementary, e + g))
        x, before, z = (x + y) / 2, z, m.sqrt(z2)
        y = before * x / z
        mean = (x * x + y * y) / 2
    half, root = (g + h) / 2, m.sqrt(e)
    long = m.sqrt(half)
    circular = m.asinh(long / m.sqrt(mean)) / long
    first = circular * factor
    third = 3 * factor * (circular - m.atan(root / z) / root) / (e + half)
    for outer, elementary, weight in reversed(trail):
        third = (2 * weight * third - 3 * (first - elementary)) / outer
    return Integrals(sn * first, sn * sn * sn * third / 3)


def ball_stop(twice: arb) -> arb | None:
    """End the Gauss transformation of balls at the working precision, with its error in a factor.

    R(x², y², …) with x², y² = μ(1 ± ρ) is an integral of 1/√((t+μ)² − μ²ρ²) times a positive
    function, which lies between 1/(t+μ) and (1 − ρ²)^(−1/2)/(t+μ): so the value lies within a
    factor [1, (1 − ρ²)^(−1/2)] of that at x² = y² = μ, and (1 − t)^(−1/2) ≤ 1 + t for t ≤ ½.
    """
    square = twice * twice / 4
    if square < arb((1, -ctx.prec)):
        return 1 + arb(0).union(square)
    return None
