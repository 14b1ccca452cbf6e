"""F(ε, γ) by numerical integration of the paper's f: independent methods for checks and charts.

The integrand of ∫_ε^{π/2} f dψ as printed is nearly singular where γ + b sin²ψ nearly vanishes. The
substitution tan ψ = κ sinh t (γ > 0), eᵗ (γ = 0) or κ cosh t (γ < 0), κ = √(|γ|/(γ+b)), removes
that factor,

    f dψ = (1 − b sin²ψ) cos ψ / (√(γ+b) √(a + b sin²ψ)) dt,

for every γ, and passes through a turning point at t = 0: t < 0 is the way back. No elliptic
functions are used.
"""

from __future__ import annotations

from typing import Any

from flint import acb, arb


def integrand(psi: Any, a: Any, b: Any, gamma: Any, m: Any) -> Any:
    """Return f of the paper with S = +1."""
    square = m.sin(psi) ** 2
    return (1 - b * square) / (m.sqrt(a + b * square) * m.sqrt(gamma + b * square))


def printed(defect: Any, a: Any, b: Any, gamma: Any, mp: Any, method: str = "tanh-sinh") -> Any:
    """Compute F(ε, γ) by mpmath's ``quad`` on the integrand as printed.

    Returns:
        The value and mpmath's estimate of its error, which is not a bound.
    """
    return mp.quad(
        lambda psi: integrand(psi, a, b, gamma, mp), [defect, mp.pi / 2], method=method, error=True
    )


def parameter(psi: Any, b: Any, gamma: Any, m: Any) -> Any:
    """Return t ≥ 0 for an angle ψ < π/2 before the turning point (t of either sign for γ > 0)."""
    tangent = m.tan(psi)
    if gamma == 0:
        return m.log(tangent)
    ratio = m.sqrt(abs(gamma) / (gamma + b))
    return m.asinh(tangent / ratio) if gamma > 0 else m.acosh(tangent / ratio)


def tangent(t: Any, b: Any, gamma: Any, m: Any) -> Any:
    """Return tan ψ at the parameter t."""
    if gamma == 0:
        return m.exp(t)
    ratio = m.sqrt(abs(gamma) / (gamma + b))
    return ratio * (m.sinh(t) if gamma > 0 else m.cosh(t))


def rate(t: Any, a: Any, b: Any, gamma: Any, m: Any) -> Any:
    """Return f dψ/dt, smooth at every t."""
    square = tangent(t, b, gamma, m) ** 2
    sec2 = 1 + square
    sin2 = square / sec2
    return (1 - b * sin2) / (m.sqrt(a + b * sin2) * m.sqrt(sec2 * (gamma + b)))


def substituted(t: Any, a: Any, b: Any, gamma: Any, mp: Any) -> Any:
    """Compute the phase from the parameter t to ψ = π/2 (t = ∞) by mpmath's ``quad``.

    Below the separatrix ``t`` < 0 means the way through the turning point.
    """
    middle = -mp.log(abs(gamma) / (gamma + b)) / 2 if gamma else mp.mpf(0)
    ends = [t, *(x for x in (middle, middle + 4) if x > t), mp.inf]
    return mp.quad(lambda x: rate(x, a, b, gamma, mp), ends)


def rigorous(defect: arb, a: arb, b: arb, gamma: arb) -> arb:
    """Compute F(ε, γ) by FLINT's rigorous integration of f as printed, at the working precision.

    It requires γ + b sin²ψ > 0 on the whole interval; at a turning point use
    :func:`rigorous_turned`.
    """

    def f(psi: acb, analytic: bool) -> acb:
        square = psi.sin() ** 2
        long = (a + b * square).sqrt(analytic=analytic)
        return (1 - b * square) / (long * (gamma + b * square).sqrt(analytic=analytic))

    return acb.integral(f, defect, arb.pi() / 2).real


def rigorous_turned(chi: arb, a: arb, b: arb, gamma: arb) -> arb:
    """Compute the phase from ψ = π/2 to cos ψ = cos ψ_min sin χ (γ < 0), by rigorous integration.

    √(γ + b sin²ψ) = √(γ+b) cos χ gives f dψ = (1 − b sin²ψ)/(√b sin ψ √(a + b sin²ψ)) dχ, which is
    regular at the turning point χ = π/2.
    """
    largest = 1 + gamma / b

    def f(angle: acb, analytic: bool) -> acb:
        square = 1 - largest * angle.sin() ** 2
        sine = (b * square).sqrt(analytic=analytic)
        return (1 - b * square) / (sine * (a + b * square).sqrt(analytic=analytic))

    return acb.integral(f, 0, chi).real


def rate_turned(chi: arb, a: arb, b: arb, gamma: arb) -> arb:
    """Return the integrand of :func:`rigorous_turned`."""
    square = 1 - (1 + gamma / b) * chi.sin() ** 2
    return (1 - b * square) / (b * square * (a + b * square)).sqrt()
