"""dε/dγ and d²ε/dγ² in closed form, for every γ in (−b, a).

With the phase Φ(ψ, γ) from ψ = π/2, ε(γ) is defined by Φ = π, so dε/dγ = Φ_γ/f. In the time τ the
derivative of the integrand is −(1 − b sin²ψ)/(2z), and 1/z = (1/m₁² − 1)/(a − γ) with m₁ = cos θ,
so

    Φ_γ = −[(1+γ) I₁ − (1+a) τ]/(2(a−γ)),   I₁ = ∫ dτ/m₁²,   I₁₁ = ∫ dτ/m₁⁴.

The integral of the third kind cancels: I₁ needs only D = ∫ sn²/dn² du = (sn³/3) R_D(cn², 1, dn²),
and I₁₁ follows from I₁ by differentiating m₂m₃/m₁³ along the flow:

    3γ(γ+b) I₁₁ = −a(a+b) τ + 2[γ(a+b) + a(γ+b)] I₁ − b m₂m₃/m₁³.

On an oscillating orbit I₁ diverges at every turning point, but m₁ I₁ does not. Therefore m₁Φ_γ is
computed, from (γ+b) I₁ = m₂/(m₁m₃) + (a+b) τ − (a−γ) ∫ dτ/m₃², so that dε/dγ is finite at γ* too.
"""

from __future__ import annotations

from contextlib import suppress
from typing import NamedTuple

from flint import acb, arb, fmpq

from tresym.racket.flip.defect import PRECISION_LIMIT, settled
from tresym.racket.motion.carlson import Amplitude
from tresym.racket.motion.jacobi import functions
from tresym.racket.motion.orbit import (
    Orbit,
    Place,
    angle_at,
    exact_level,
    handle_at,
    orbit,
    time_of,
)
from tresym.reals.numbers.arithmetic import ball_precision, bits
from tresym.reals.numbers.exact import InputError


class Slopes(NamedTuple):
    """Balls around ε and its first two derivatives with respect to γ."""

    defect: arb
    first: arb
    second: arb


def slopes(a: fmpq, b: fmpq, gamma: fmpq, digits: int) -> Slopes:
    """Compute ε(γ), dε/dγ and d²ε/dγ², each to ``digits`` certified digits (or proved near 0).

    Raises:
        InputError: unless −b < γ < a.
        ArithmeticError: the precision limit is reached.
    """
    if not -b < gamma < a:
        raise InputError("gamma: must lie strictly between -b and a for a slope")
    precision = bits(digits, 64)
    while precision < PRECISION_LIMIT:
        with ball_precision(precision), suppress(ArithmeticError):
            found = _on(orbit(a, b, exact_level(a, b, gamma)))
            if all(settled(x, digits, precision) for x in found):
                return found
        precision *= 2
    raise ArithmeticError("the precision limit is reached")


def _on(on: Orbit) -> Slopes:
    """The derivatives on an orbit, at the working precision."""
    a, b = on.a, on.b
    gamma, below = on.level.gamma, on.level.below
    place = time_of(on, arb.pi())
    defect = arb.pi() / 2 - angle_at(on, place)
    sine, cosine = defect.sin_cos()
    square = sine * sine
    m1, scale, clock = handle_at(on, place), a + b * square, 1 - b * square
    tau, weighted, first_kind = _derivatives(on, place, m1)
    first = weighted * scale / clock
    doubled = _fourth_power(on, place, tau, first_kind, below / scale * sine * cosine, m1)
    # Φ_γγ at fixed ψ, from those of τ and I₁.
    shifted = (1 + gamma) * first_kind - (1 + a) * tau
    tau_slope = -(first_kind - tau) / (2 * below)
    first_slope = -3 * (doubled - first_kind) / (2 * below)
    bent = first_kind + (1 + gamma) * first_slope - (1 + a) * tau_slope
    second_by_gamma = -(shifted / below + bent) / (2 * below)
    # Differentiate F(ε(γ), γ) = π twice; f, f_γ, f_ψ are taken at ε.
    z = m1 * m1 * scale
    f = clock / (m1 * scale)
    by_gamma = -f / (2 * z)
    by_angle = -f * b * sine * cosine * (2 / clock + 1 / scale + 1 / z)
    second = (second_by_gamma - 2 * by_gamma * first - by_angle * first * first) / f
    return Slopes(defect, first, second)


def _derivatives(on: Orbit, place: Place, m1: arb) -> tuple[arb, arb, arb]:
    """τ, m₁Φ_γ and I₁ at a point of the orbit."""
    a, b = on.a, on.b
    gamma, below, above, regime = on.level
    at = functions(on.elliptic, place.time)
    u, d = place.time, _second_kind(at)
    modulus = on.elliptic.modulus
    if place.halves:
        far = Amplitude(arb(1), arb(0), on.elliptic.complement.sqrt(), modulus)
        u = u + 2 * place.halves * on.quarter_time
        d = d + 2 * place.halves * _second_kind(far)
    tau = u / on.speed
    if regime >= 0:
        rest = ((1 - b) * modulus + b / a * (1 + a)) * d
        slope = -((1 - b) * u + rest) / (2 * on.speed * above)
        return tau, m1 * slope, ((1 + a) * tau - 2 * below * slope) / (1 + gamma)
    turned = -1 if place.halves % 2 else 1
    tangent = turned * (above * (a + b) / (b * below)).sqrt() * at.sn / at.dn
    weighted_first = (tangent - m1 * (a + b) * modulus * d / on.speed) / above
    weighted = -((1 + gamma) * weighted_first - (1 + a) * m1 * tau) / (2 * below)
    return tau, weighted, weighted_first / m1


def _second_kind(at: Amplitude) -> arb:
    """D = ∫ sn²/dn² du."""
    x, z = (acb((root * root).nonnegative_part()) for root in (at.cn, at.dn))
    return at.sn**3 * acb.elliptic_rd(x, 1, z).real / 3


def _fourth_power(on: Orbit, place: Place, tau: arb, first_kind: arb, product: arb, m1: arb) -> arb:
    """I₁₁ at a point with m₂m₃ = ``product``; elementary on the separatrix, where m₁ ∝ 1/cosh u."""
    a, b = on.a, on.b
    gamma, _, above, regime = on.level
    if regime == 0:
        u = place.time
        hyperbolic = 3 * u / 8 + (2 * u).sinh() / 4 + (4 * u).sinh() / 32
        return hyperbolic * ((a + b) / b) ** 2 / on.speed
    total = 2 * (gamma * (a + b) + a * above) * first_kind - a * (a + b) * tau
    return (total - b * product / m1**3) / (3 * gamma * above)
