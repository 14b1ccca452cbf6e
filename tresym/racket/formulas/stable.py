"""The paper's quantities without cancellation, from which every number is computed.

Each function is algebraically equal to a formula in :mod:`tresym.racket.formulas.printed`, or to a
step between two of them, but never subtracts nearly equal numbers, so that it keeps its digits in
any arithmetic ``m`` (the last argument). Angles are in radians, ``a`` and ``b`` are the paper's
shape parameters, ``gamma`` is its γ, which vanishes on the separatrix.

On the separatrix everything follows from one number, the *phase* P = π + arcsin(√(b/(a+b)) cos ε₀),
π ≤ P ≤ 3π/2. With k = √(ab) and r = √(b/a), so that T = kP,

    P = π + arctan(r tanh kP),      cot ε₀ = √(1 + r²) sinh kP.

P is of order one for every shape, and each of these functions is a short formula in k and r.
"""

from __future__ import annotations

from typing import Any


def shape(I1: Any, I2: Any, I3: Any) -> tuple[Any, Any]:
    """Return the shape parameters (a, b) of three principal moments, smallest first."""
    return (I2 - I1) / I1, (I3 - I2) / I3


def depth_from_momentum(M1: Any, M2: Any, M3: Any, a: Any, b: Any) -> Any:
    """Return γ from the angular momentum in the body frame: positive if the motion rotates."""
    return (a * M1**2 - b * M3**2) / (M1**2 + M2**2 + M3**2)


def depth(theta: Any, psi: Any, a: Any, b: Any, m: Any) -> Any:
    """Return γ at the Euler angles θ, ψ; exact to relative accuracy in each of its two terms."""
    return a * m.cos(theta) ** 2 - b * (m.sin(theta) * m.sin(psi)) ** 2


def radicand(psi: Any, psi_min: Any, b: Any, m: Any) -> Any:
    """Return γ + b sin²ψ if the trajectory turns at ``psi_min``, where it is exactly 0."""
    return b * m.sin(psi - psi_min) * m.sin(psi + psi_min)


def theta_min(a: Any, b: Any, gamma: Any, m: Any) -> Any:
    """Return the smallest θ of a trajectory, also near the stable rotation γ = a."""
    return m.atan(m.sqrt((a - gamma) / (gamma + b)))


def separatrix_map(defect: Any, a: Any, b: Any, m: Any) -> Any:
    """Return the right-hand side of the exact separatrix equation in fixed-point form (Sec. 6)."""
    mu = m.sqrt(b / (a + b))
    argument = m.sqrt(a * b) * (m.pi + m.asin(mu * m.cos(defect)))
    return m.atan(m.sqrt(a / (a + b)) / m.sinh(argument))


def separatrix_left(defect: Any, a: Any, b: Any, m: Any) -> Any:
    """Return the left-hand side of the paper's exponential equation, e^{−2T} at the root."""
    square = (1 + b / a) * m.sin(defect) ** 2
    return square / (m.sqrt(1 + b / a * m.sin(defect) ** 2) + m.cos(defect)) ** 2


def phase(defect: Any, a: Any, b: Any, m: Any) -> Any:
    """Return the phase P = π + arcsin(√(b/(a+b)) cos ε), also accurate if the sine is near 1."""
    return m.pi + m.atan(m.sqrt(b) * m.cos(defect) / m.sqrt(a + b * m.sin(defect) ** 2))


def phase_map(phase: Any, k: Any, r: Any, m: Any) -> Any:
    """Return the right-hand side of P = π + arctan(r tanh kP), whose one root is the phase."""
    return m.pi + m.atan(r * m.tanh(k * phase))


def phase_slope(phase: Any, k: Any, r: Any, m: Any) -> Any:
    """Return the derivative 1 − b/(cosh² kP + r² sinh² kP) of P − ``phase_map(P)``.

    At the root it is 1 − b sin²ε₀. The difference 1 − tanh² may cancel, but then the term that
    loses digits is negligible.
    """
    tangent = m.tanh(k * phase)
    ratio = r * tangent
    return 1 - k * r * (1 - tangent * tangent) / (1 + ratio * ratio)


def defect_at(phase: Any, k: Any, r: Any, m: Any) -> Any:
    """Return the defect ε₀ in radians for a phase."""
    return m.atan(1 / (m.sqrt(1 + r * r) * m.sinh(k * phase)))


def flip_at(phase: Any, k: Any, r: Any, m: Any) -> Any:
    """Return the flip Δψ = π − 2ε₀ in radians for a phase, relatively accurate as ε₀ → π/2."""
    return 2 * m.atan(m.sqrt(1 + r * r) * m.sinh(k * phase))


def leading_term(k: Any, r: Any, m: Any) -> Any:
    """Return ε* = 2√(a/(a+b)) e^{−√(ab)(π + arcsin √(b/(a+b)))}: ε₀ = ε*(1 + c₁ε*² + …)."""
    return 2 / m.sqrt(1 + r * r) * m.exp(-k * (m.pi + m.atan(r)))


def first_coefficient(k: Any, r: Any) -> Any:
    """Return c₁ = (6b − 1 + 3b/a)/12 of the expansion of ε₀ in powers of ε*²."""
    return (6 * k * r - 1 + 3 * r**2) / 12


def turn_slope(defect: Any, a: Any, b: Any, m: Any) -> Any:
    """Return ∂F/∂γ at γ = 0 (S = +1), the definite integral from ε to π/2."""
    sine, cosine = m.sin(defect), m.cos(defect)
    arc = m.asinh(m.sqrt(a / (a + b)) * cosine / sine)
    rest = m.sqrt(a + b * sine**2) * cosine / (a * sine**2)
    return -((a - b - 2 * a * b) / (a * m.sqrt(a)) * arc + rest) / (4 * b * m.sqrt(b))
