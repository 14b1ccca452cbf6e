"""Every formula of the paper as printed, including its cancellation.

The order is the paper's. Each docstring names the display by its label, or by its section if it has
none. Where a printed form loses digits (the tests show where), :mod:`tresym.racket.formulas.stable`
has an equal form that does not. Angles are in radians; ``S`` and ``S2`` are signs, +1 or −1; ``m``
is the arithmetic, as explained in :mod:`tresym.racket.formulas`.
"""

from __future__ import annotations

from typing import Any

# Sec. 2 and 3: the angular momentum in the body frame


def euler_equations(M1: Any, M2: Any, M3: Any, I1: Any, I2: Any, I3: Any) -> tuple[Any, Any, Any]:
    """Return dM/dt in the body frame (eq_dMi)."""
    return (-(1 / I2 - 1 / I3) * M2 * M3, (1 / I1 - 1 / I3) * M1 * M3, -(1 / I1 - 1 / I2) * M1 * M2)


def energy(M1: Any, M2: Any, M3: Any, I1: Any, I2: Any, I3: Any) -> Any:
    """Return E, from the first of the two first integrals (eq_first_int)."""
    return (M1**2 / I1 + M2**2 / I2 + M3**2 / I3) / 2


def momentum_squared(M1: Any, M2: Any, M3: Any) -> Any:
    """Return M², the second first integral (eq_first_int)."""
    return M1**2 + M2**2 + M3**2


def ellipsoid_radii(I1: Any, I2: Any, I3: Any, E: Any, m: Any) -> tuple[Any, Any, Any]:
    """Return the radii of the energy ellipsoid (Sec. 3, after eq_first_int)."""
    return m.sqrt(2 * I1 * E), m.sqrt(2 * I2 * E), m.sqrt(2 * I3 * E)


def momentum(theta: Any, psi: Any, M: Any, m: Any) -> tuple[Any, Any, Any]:
    """Return (M₁, M₂, M₃) in terms of the Euler angles (eq_Mi)."""
    return (M * m.cos(theta), -M * m.sin(theta) * m.cos(psi), M * m.sin(theta) * m.sin(psi))


# Sec. 4: the Euler angles


def angle_rates(
    theta: Any, psi: Any, M: Any, I1: Any, I2: Any, I3: Any, m: Any
) -> tuple[Any, Any, Any]:
    """Return the time derivatives of (θ, φ, ψ) (eq_euler_angle)."""
    sine, cosine = m.sin(psi), m.cos(psi)
    return (
        M * (1 / I3 - 1 / I2) * m.sin(theta) * sine * cosine,
        M * (sine**2 / I3 + cosine**2 / I2),
        M * (1 / I1 - sine**2 / I3 - cosine**2 / I2) * m.cos(theta),
    )


def shape(I1: Any, I2: Any, I3: Any) -> tuple[Any, Any]:
    """Return the parameters a and b (Sec. 4)."""
    return I2 / I1 - 1, 1 - I2 / I3


def depth_from_energy(E: Any, M: Any, I2: Any) -> Any:
    """Return γ in terms of energy and momentum (Sec. 4)."""
    return 2 * I2 * E / M**2 - 1


def planar_rates(theta: Any, psi: Any, a: Any, b: Any, m: Any) -> tuple[Any, Any]:
    """Return (dθ/dφ, dψ/dφ) of the planar system (eq_Euler)."""
    sine, cosine = m.sin(psi), m.cos(psi)
    return (
        -b * m.sin(theta) * sine * cosine / (1 - b * sine**2),
        (a + b * sine**2) * m.cos(theta) / (1 - b * sine**2),
    )


def depth(theta: Any, psi: Any, a: Any, b: Any, m: Any) -> Any:
    """Return γ in terms of the Euler angles (eq_gamma)."""
    return a - m.sin(theta) ** 2 * (a + b * m.sin(psi) ** 2)


# Sec. 5: the two phase portraits


def cos_theta(psi: Any, a: Any, b: Any, gamma: Any, S: Any, m: Any) -> Any:
    """Return cos θ in terms of ψ (Sec. 5)."""
    sine = m.sin(psi)
    return S * m.sqrt((gamma + b * sine**2) / (a + b * sine**2))


def psi_rate(psi: Any, a: Any, b: Any, gamma: Any, S: Any, m: Any) -> Any:
    """Return dψ/dφ in terms of ψ alone (eq_dpsidphi)."""
    sine = m.sin(psi)
    roots = m.sqrt(a + b * sine**2) * m.sqrt(gamma + b * sine**2)
    return S * roots / (1 - b * sine**2)


def psi_bounds(b: Any, gamma: Any, m: Any) -> tuple[Any, Any]:
    """Return (ψ_min, ψ_max) of an oscillating trajectory, −b ≤ γ < 0 (eq_borne_psi)."""
    turn = m.asin(m.sqrt(abs(gamma) / b))
    return turn, m.pi - turn


def sin_psi_cos_psi(theta: Any, a: Any, b: Any, gamma: Any, S2: Any, m: Any) -> Any:
    """Return the product sin ψ cos ψ in terms of θ (Sec. 5)."""
    square = m.cos(theta) ** 2
    root = m.sqrt((gamma + b - (a + b) * square) * (a * square - gamma))
    return S2 / (b * m.sin(theta) ** 2) * root


def theta_rate(theta: Any, a: Any, b: Any, gamma: Any, S2: Any, m: Any) -> Any:
    """Return dθ/dφ in terms of θ alone (eq_dthetadphi)."""
    square = m.cos(theta) ** 2
    root = m.sqrt((gamma + b - (a + b) * square) * (a * square - gamma))
    return -S2 * m.sin(theta) * root / (gamma + 1 - (a + 1) * square)


def theta_bounds_rotating(a: Any, b: Any, gamma: Any, m: Any) -> tuple[Any, Any]:
    """Return (θ_min, θ_max) for γ > 0 (eq_borne_theta)."""
    return m.acos(m.sqrt((gamma + b) / (a + b))), m.acos(m.sqrt(gamma / a))


def theta_bounds_oscillating(a: Any, b: Any, gamma: Any, m: Any) -> tuple[Any, Any]:
    """Return (θ_min, θ_max) for γ < 0 (eq_borne_theta)."""
    least = m.acos(m.sqrt((gamma + b) / (a + b)))
    return least, m.pi - least


# Sec. 6: the flip


def integrand(psi: Any, a: Any, b: Any, gamma: Any, S: Any, m: Any) -> Any:
    """Return the integrand f = dφ/dψ, whose integral is Δφ (after eq_robust_gen)."""
    sine = m.sin(psi)
    roots = m.sqrt(a + b * sine**2) * m.sqrt(gamma + b * sine**2)
    return S * (1 - b * sine**2) / roots


def flip(defect: Any, m: Any) -> Any:
    """Return Δψ = π − 2ε (eqdefect)."""
    return m.pi - 2 * defect


def asymptotic_defect(a: Any, b: Any, m: Any) -> Any:
    """Return ε₀ of the theorem without its remainder (prop1, eps0)."""
    root = m.sqrt(a * b)
    return m.exp(-root * m.pi) * (2 * m.sqrt(a / (a + b)) * m.exp(-b / m.sqrt(1 + b / a)))


def linear_defect(defect: Any, b: Any, gamma: Any) -> Any:
    """Return ε(γ) of the theorem without its remainder, from ε₀ = ``defect`` (eq_pavao)."""
    return defect - gamma / (4 * b * defect)


def separatrix_left(defect: Any, a: Any, b: Any, m: Any) -> Any:
    """Return the left-hand side of the exact equation for ε₀ (Sec. 6)."""
    root = m.sqrt(1 + b / a * m.sin(defect) ** 2)
    return (root - m.cos(defect)) / (root + m.cos(defect))


def separatrix_right(defect: Any, a: Any, b: Any, m: Any) -> Any:
    """Return the right-hand side of the exact equation for ε₀ (Sec. 6)."""
    arc = m.asin(m.sqrt(b / (a + b)) * m.cos(defect))
    return m.exp(-2 * m.sqrt(a * b) * (m.pi + arc))


def separatrix_residual(defect: Any, a: Any, b: Any, m: Any) -> Any:
    """Return left minus right side of the exact equation for ε₀: increasing, 0 at the root."""
    return separatrix_left(defect, a, b, m) - separatrix_right(defect, a, b, m)


# Appendix: ε₀


def auxiliary_variable(psi: Any, a: Any, b: Any, m: Any) -> Any:
    """Return the variable x = √(b/(a+b)) cos ψ (appendix)."""
    return m.sqrt(b / (a + b)) * m.cos(psi)


def auxiliary_integrand(x: Any, a: Any, b: Any, m: Any) -> Any:
    """Return the integrand in x, whose integral from x₀ to −x₀ is −2πb (appendix)."""
    root = m.sqrt(1 - x**2)
    return 1 / ((1 - (a + b) / b * x**2) * root) - b / root


def arctanh_left(x: Any, a: Any, b: Any, m: Any) -> Any:
    """Return the left-hand side of the integrated equation, equal to √(ab) π at x₀ (appendix)."""
    return m.atanh(m.sqrt(a / b) * x / m.sqrt(1 - x**2)) - m.sqrt(a * b) * m.asin(x)


def implicit_right(defect: Any, a: Any, b: Any, m: Any) -> Any:
    """Return the right-hand side of the equation after the square root (eqnew)."""
    arc = m.asin(m.sqrt(b / (a + b)) * m.cos(defect))
    return 2 * m.sqrt(a / (a + b)) * m.exp(-m.sqrt(a * b) * (m.pi + arc))


def small_parameters(a: Any, b: Any, m: Any) -> tuple[Any, Any]:
    """Return (λ, μ) in terms of a and b (appendix)."""
    return 1 / m.sqrt(a * b), m.sqrt(b / (a + b))


def mu_of_lambda(lam: Any, b: Any, m: Any) -> Any:
    """Return μ in terms of λ and b (appendix)."""
    return lam * b / m.sqrt(1 + lam**2 * b**2)


def implicit_right_reduced(defect: Any, lam: Any, mu: Any, m: Any) -> Any:
    """Return the right-hand side of eqnew in λ and μ (equation)."""
    arc = m.asin(mu * m.cos(defect))
    return 2 * m.sqrt(1 - mu**2) * m.exp(-1 / lam * (m.pi + arc))


def flat_function(s: Any, m: Any) -> Any:
    """Return e^{−1/s}, infinitely flat at 0 (appendix)."""
    return m.exp(-1 / s)


def defect_of_u(u: Any, lam: Any, mu: Any, m: Any) -> Any:
    """Return ε₀ in the form of the ansatz (u)."""
    return 2 * m.sqrt(1 - mu**2) * m.exp(-1 / lam * (m.pi + m.asin(mu) + u))


def implicit_function(u: Any, lam: Any, mu: Any, m: Any) -> Any:
    """Return G(u, λ, μ) without its higher-order terms (equ)."""
    return u + m.asin(mu) - m.asin(mu * m.cos(defect_of_u(u, lam, mu, m)))


# Appendix: dε/dγ at γ = 0


def defect_per_turn(defect: Any, a: Any, b: Any, S: Any, m: Any) -> Any:
    """Return ∂ε/∂F at γ = 0 (appendix)."""
    sine = m.sin(defect)
    return -S * m.sqrt(b) * sine * m.sqrt(a + b * sine**2) / (1 - b * sine**2)


def defect_per_turn_asymptotic(defect: Any, a: Any, b: Any, S: Any, m: Any) -> Any:
    """Return ∂ε/∂F at γ = 0 for a small defect (appendix)."""
    return -S * m.sqrt(a * b) * defect


def integrand_slope(psi: Any, a: Any, b: Any, S: Any, m: Any) -> Any:
    """Return ∂f/∂γ at γ = 0 (appendix)."""
    sine = m.sin(psi)
    root = m.sqrt(a + b * sine**2)
    return -S / (2 * m.sqrt(b) ** 3) * ((1 - b * sine**2) / (root * sine**3))


def turn_slope_antiderivative(psi: Any, a: Any, b: Any, S: Any, m: Any) -> Any:
    """Return the bracket of ∂F/∂γ at γ = 0, to be taken from ε₀ to π/2 (appendix)."""
    sine, cosine = m.sin(psi), m.cos(psi)
    root = m.sqrt(a + b * sine**2)
    factor = S * (a - b - 2 * a * b) / (4 * m.sqrt(a * b) ** 3)
    logarithm = m.log((m.sqrt(a) * cosine + root) / sine)
    return factor * logarithm + S * root * cosine / (4 * m.sqrt(b) ** 3 * a * sine**2)


def turn_slope(defect: Any, a: Any, b: Any, S: Any, m: Any) -> Any:
    """Return ∂F/∂γ at γ = 0: the bracket between its ends (appendix)."""
    end = turn_slope_antiderivative(m.pi / 2, a, b, S, m)
    return end - turn_slope_antiderivative(defect, a, b, S, m)


def turn_slope_asymptotic(defect: Any, a: Any, b: Any, S: Any, m: Any) -> Any:
    """Return ∂F/∂γ at γ = 0 for a small defect (appendix)."""
    return -S / (4 * m.sqrt(b) ** 3 * m.sqrt(a) * defect**2)


def defect_slope_asymptotic(defect: Any, b: Any) -> Any:
    """Return ∂ε/∂γ at γ = 0 for a small defect (appendix)."""
    return -1 / (4 * b * defect)
