"""F(ε, γ) = ∫_ε^{π/2} f dψ in Carlson's symmetric form.

With sn² = a cos²ε/(a + b sin²ε), cn² = 1 − sn², dn² = (a+b) z/((γ+b)(a + b sin²ε)), n = b/a and
z = γ + b sin²ε, the paper's integral is

    F = [(1−b) u + (a+b) n J]/ω,  ω = √(a(γ+b)),
    u = sn R_F(cn², dn², 1),      J = ∫ sn²/(1 + n sn²) du = (sn³/3) R_J(cn², dn², 1, 1 + n sn²).

z is an argument of its own: near the turning point its computation by subtraction loses digits. All
terms are positive for every γ ≥ −b sin²ε. The same u and J describe any orbit
(:mod:`tresym.racket.motion.orbit`), with other n and ω below the separatrix. A faster method for F
is :mod:`tresym.racket.motion.gauss`.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from flint import acb, arb


class Amplitude(NamedTuple):
    """A point of an orbit: Jacobi's sn, cn ≥ 0, dn ≥ 0 and the parameter k², in any arithmetic."""

    sn: Any
    cn: Any
    dn: Any
    modulus: Any


class Integrals(NamedTuple):
    """The time u and the third-kind integral J from sn = 0 to an amplitude."""

    time: Any
    third: Any


def amplitude(sine: Any, cosine: Any, z: Any, a: Any, b: Any, gamma: Any, m: Any) -> Amplitude:
    """Return the amplitude at an angle ψ in [0, π/2], from sin ψ, cos ψ and z = γ + b sin²ψ."""
    square = a + b * sine * sine
    root = m.sqrt(square)
    return Amplitude(
        m.sqrt(a) * cosine / root,
        m.sqrt(a + b) * sine / root,
        m.sqrt((a + b) * z / (gamma + b)) / root,
        b * (a - gamma) / (a * (gamma + b)),
    )


def turn(integrals: Integrals, a: Any, b: Any, gamma: Any, m: Any) -> Any:
    """Return F(ε, γ) from the integrals at the amplitude of ε."""
    return ((1 - b) * integrals.time + (a + b) * b / a * integrals.third) / m.sqrt(a * (gamma + b))


def by_flint(at: Amplitude, n: arb) -> Integrals:
    """Return u and J in balls by FLINT's certified R_F and R_J, for any amplitude, also sn < 0."""
    x, y = acb(_square(at.cn)), acb(_square(at.dn))
    square = at.sn * at.sn
    time = at.sn * acb.elliptic_rf(x, y, 1).real
    return Integrals(time, at.sn * square * acb.elliptic_rj(x, y, 1, 1 + n * square).real / 3)


def _square(x: arb) -> arb:
    """x² as a ball without negative numbers."""
    square = x * x
    return square if square > 0 else square.nonnegative_part()
