"""The paper's quantities without cancellation, from which every number is computed.

Each function is the algebraic equal of a formula in :mod:`tresym.racket.formulas.printed` (or of a
step the paper takes from one to the next) in a form where no two nearly equal numbers are
subtracted, so it keeps its digits in any arithmetic ``m`` (the last argument). Angles are in
radians, ``a`` and ``b`` are the paper's shape parameters, ``gamma`` its distance from the
separatrix.

On the separatrix everything follows from one number, the *phase* P = π + arcsin(√(b/(a+b)) cos ε₀),
π ≤ P ≤ 3π/2. With k = √(ab) and r = √(b/a), so that T = kP,

    P = π + arctan(r tanh kP),      cot ε₀ = √(1 + r²) sinh kP.

P stays of order one for every shape, and each of these functions is one line in k and r.
"""

from __future__ import annotations

from typing import Any


def shape(I1: Any, I2: Any, I3: Any) -> tuple[Any, Any]:
    """The shape parameters (a, b) of three principal moments, smallest first."""
    return (I2 - I1) / I1, (I3 - I2) / I3


def depth_from_momentum(M1: Any, M2: Any, M3: Any, a: Any, b: Any) -> Any:
    """γ of an angular momentum in the body frame: positive rotating, negative oscillating."""
    return (a * M1**2 - b * M3**2) / (M1**2 + M2**2 + M3**2)


def depth(theta: Any, psi: Any, a: Any, b: Any, m: Any) -> Any:
    """γ at the Euler angles θ, ψ; exact to relative accuracy in each of its two terms."""
    return a * m.cos(theta) ** 2 - b * (m.sin(theta) * m.sin(psi)) ** 2


def radicand(psi: Any, psi_min: Any, b: Any, m: Any) -> Any:
    """γ + b sin²ψ of an oscillating trajectory that turns at ``psi_min``; 0 exactly there."""
    return b * m.sin(psi - psi_min) * m.sin(psi + psi_min)


def theta_min(a: Any, b: Any, gamma: Any, m: Any) -> Any:
    """The smallest θ of a trajectory, also near the stable rotation γ = a."""
    return m.atan(m.sqrt((a - gamma) / (gamma + b)))


def separatrix_map(defect: Any, a: Any, b: Any, m: Any) -> Any:
    """Right-hand side of the fixed-point form of the exact separatrix equation (paper, Sec. 6)."""
    mu = m.sqrt(b / (a + b))
    argument = m.sqrt(a * b) * (m.pi + m.asin(mu * m.cos(defect)))
    return m.atan(m.sqrt(a / (a + b)) / m.sinh(argument))


def separatrix_left(defect: Any, a: Any, b: Any, m: Any) -> Any:
    """Left-hand side of the paper's exponential equation, e^{−2T} at the root."""
    square = (1 + b / a) * m.sin(defect) ** 2
    return square / (m.sqrt(1 + b / a * m.sin(defect) ** 2) + m.cos(defect)) ** 2


def phase(defect: Any, a: Any, b: Any, m: Any) -> Any:
    """The phase P = π + arcsin(√(b/(a+b)) cos ε) of a defect ε, also where the sine is near 1."""
    return m.pi + m.atan(m.sqrt(b) * m.cos(defect) / m.sqrt(a + b * m.sin(defect) ** 2))


def phase_map(phase: Any, k: Any, r: Any, m: Any) -> Any:
    """Right-hand side of P = π + arctan(r tanh kP), whose one root is the phase."""
    return m.pi + m.atan(r * m.tanh(k * phase))


def phase_slope(phase: Any, k: Any, r: Any, m: Any) -> Any:
    """Derivative of P − ``phase_map(P)``, 1 − b/(cosh² kP + r² sinh² kP): at the root 1 − b sin²ε₀.

    The difference 1 − tanh² may cancel: what is lost is lost from a term that no longer counts.
    """
    tangent = m.tanh(k * phase)
    ratio = r * tangent
    return 1 - k * r * (1 - tangent * tangent) / (1 + ratio * ratio)


def defect_at(phase: Any, k: Any, r: Any, m: Any) -> Any:
    """The defect ε₀ in radians that belongs to a phase."""
    return m.atan(1 / (m.sqrt(1 + r * r) * m.sinh(k * phase)))


def flip_at(phase: Any, k: Any, r: Any, m: Any) -> Any:
    """The flip Δψ = π − 2ε₀ in radians that belongs to a phase; relative accuracy as ε₀ → π/2."""
    return 2 * m.atan(m.sqrt(1 + r * r) * m.sinh(k * phase))


def uniform_defect(k: Any, r: Any, m: Any) -> Any:
    """One sweep of the phase map from P = π: ε₀ to 2.8 % for every shape, in one line."""
    return defect_at(phase_map(m.pi, k, r, m), k, r, m)


def leading_term(k: Any, r: Any, m: Any) -> Any:
    """ε* = 2√(a/(a+b)) e^{−√(ab)(π + arcsin √(b/(a+b)))}: ε₀ = ε*(1 + c₁ε*² + …)."""
    return 2 / m.sqrt(1 + r * r) * m.exp(-k * (m.pi + m.atan(r)))


def first_coefficient(k: Any, r: Any) -> Any:
    """c₁ = (6b − 1 + 3b/a)/12 of the expansion of ε₀ in powers of ε*²."""
    return (6 * k * r - 1 + 3 * r**2) / 12


def integrand_slope(psi: Any, a: Any, b: Any, m: Any) -> Any:
    """∂f/∂γ at γ = 0 (S = +1)."""
    sine = m.sin(psi)
    return -(1 - b * sine**2) / (2 * m.sqrt(a + b * sine**2) * (m.sqrt(b) * sine) ** 3)


def turn_slope(defect: Any, a: Any, b: Any, m: Any) -> Any:
    """∂F/∂γ at γ = 0 (S = +1): the definite integral from ε to π/2, which vanishes at π/2."""
    sine, cosine = m.sin(defect), m.cos(defect)
    arc = m.asinh(m.sqrt(a / (a + b)) * cosine / sine)
    rest = m.sqrt(a + b * sine**2) * cosine / (a * sine**2)
    return -((a - b - 2 * a * b) / (a * m.sqrt(a)) * arc + rest) / (4 * b * m.sqrt(b))
