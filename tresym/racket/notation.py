"""The paper's symbols, defined once, and how each is written in LaTeX.

All are real. Conditions on them (0 < I₁ < I₂ < I₃, 0 < b ≤ 1, …) belong to the claims that need
them, never to the symbols. This module imports SymPy, so only claims and proofs import it.
"""

from __future__ import annotations

from sympy import Symbol

# fmt: off
__all__ = [
    "I1", "I2", "I3", "M1", "M2", "M3", "S2", "W1", "W2", "W3", "Delta_phi", "Delta_psi", "E",
    "F", "M", "S", "T", "a", "b", "dM1_dt", "dM2_dt", "dM3_dt", "depsilon_dgamma", "dphi_dt",
    "dpsi_dphi", "dpsi_dt", "dtheta_dphi", "dtheta_dt", "epsilon", "epsilon0", "epsilon_star",
    "gamma", "k",
    "lam", "mu", "partialF_partialgamma", "partialepsilon_partialF",
    "partialepsilon_partialgamma", "phi", "psi", "psi0", "psi_f", "psi_max", "psi_min", "r",
    "theta", "theta_max", "theta_min", "u", "x", "x0",
]
# fmt: on


def _real(name: str) -> Symbol:
    return Symbol(name, real=True)


I1, I2, I3 = _real("I1"), _real("I2"), _real("I3")
"""Principal moments of inertia: handle, intermediate axis, normal of the face."""
M1, M2, M3, M = _real("M1"), _real("M2"), _real("M3"), _real("M")
"""Components of the angular momentum in the body frame, and its length."""
W1, W2, W3 = _real("Omega1"), _real("Omega2"), _real("Omega3")
"""Components of the angular velocity in the body frame."""
E = _real("E")
"""Rotational energy."""
theta, phi, psi = _real("theta"), _real("phi"), _real("psi")
"""Euler angles (z-y-z, with x, y, z along e₂, e₃, e₁): tilt of the handle, precession, flip."""
dtheta_dt, dphi_dt, dpsi_dt = _real("dtheta_dt"), _real("dphi_dt"), _real("dpsi_dt")
dM1_dt, dM2_dt, dM3_dt = _real("dM1_dt"), _real("dM2_dt"), _real("dM3_dt")
dtheta_dphi, dpsi_dphi = _real("dtheta_dphi"), _real("dpsi_dphi")
"""Rates, as symbols of their own: each is what some claim says it is."""
a, b = _real("a"), _real("b")
"""Shape of the body: a = I₂/I₁ − 1, b = 1 − I₂/I₃."""
theta_min, theta_max = _real("theta_min"), _real("theta_max")
psi_min, psi_max = _real("psi_min"), _real("psi_max")
"""Bounds of the tilt and of the flip on one trajectory."""
gamma = _real("gamma")
"""Distance from the separatrix: γ = 2 I₂ E/M² − 1."""
epsilon, epsilon0, epsilon_star = _real("epsilon"), _real("epsilon0"), _real("epsilon_star")
"""Flip defect, the flip defect on the separatrix, and what the theorem's formula gives for it."""
depsilon_dgamma, partialepsilon_partialgamma = (
    _real("depsilon_dgamma"),
    _real("partialepsilon_partialgamma"),
)
partialepsilon_partialF, partialF_partialgamma = (
    _real("partialepsilon_partialF"),
    _real("partialF_partialgamma"),
)
"""Derivatives of the flip defect and of F, as symbols of their own."""
psi0, psi_f = _real("psi0"), _real("psi_f")
Delta_psi, Delta_phi = _real("Delta_psi"), _real("Delta_phi")
"""Flip angle at the start and at the end; the changes of the flip and precession angles."""
S, S2 = _real("S"), _real("S2")
"""Signs of cos θ and of sin ψ cos ψ."""
x, x0 = _real("x"), _real("x0")
"""Auxiliary variable √(b/(a+b)) cos ψ, and its value at the start."""
T, k, r = _real("T"), _real("k"), _real("r")
"""Auxiliary variable of the stable form; k = √(ab), r = √(b/a)."""
F = _real("F")
"""The integral of f from the flip defect to π/2."""
u, lam, mu = _real("u"), _real("lambda"), _real("mu")
"""The appendix's unknown and parameters: λ = 1/√(ab), μ = √(b/(a+b))."""

LATEX = {
    dtheta_dt: r"\dot\theta",
    dphi_dt: r"\dot\phi",
    dpsi_dt: r"\dot\psi",
    dM1_dt: r"\dot M_1",
    dM2_dt: r"\dot M_2",
    dM3_dt: r"\dot M_3",
    dtheta_dphi: r"\frac{d\theta}{d\phi}",
    dpsi_dphi: r"\frac{d\psi}{d\phi}",
    depsilon_dgamma: r"\frac{d\epsilon}{d\gamma}",
    partialepsilon_partialgamma: r"\frac{\partial\epsilon}{\partial\gamma}",
    partialepsilon_partialF: r"\frac{\partial\epsilon}{\partial F}",
    partialF_partialgamma: r"\frac{\partial F}{\partial\gamma}",
    epsilon0: r"\epsilon_0",
    epsilon_star: r"\epsilon_*",
    psi_f: r"\psi_f",
    Delta_psi: r"\Delta\psi",
    Delta_phi: r"\Delta\phi",
    lam: r"\lambda",
    theta_min: r"\theta_{\min}",
    theta_max: r"\theta_{\max}",
    psi_min: r"\psi_{\min}",
    psi_max: r"\psi_{\max}",
}
"""How symbols are written where SymPy's own rule would write them otherwise."""
