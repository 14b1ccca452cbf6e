"""The paper's symbols, each defined once, with their LaTeX.

All are real. Conditions on them (0 < I₁ < I₂ < I₃, 0 < b ≤ 1, …) belong to the claims that need
them, never to the symbols.
"""

from __future__ import annotations

from tresym.reals.language.expression import symbol as _real

# fmt: off
__all__ = [
    "I1", "I2", "I3", "M1", "M2", "M3", "S2", "W1", "W2", "W3", "Delta_phi", "Delta_psi", "E",
    "F", "M", "P", "Q", "S", "T", "a", "b", "c1", "c2", "dM1_dt", "dM2_dt", "dM3_dt",
    "depsilon_dgamma", "dphi_dt", "dpsi_dphi", "dpsi_dt", "dtheta_dphi", "dtheta_dt", "epsilon",
    "epsilon0", "epsilon_4", "epsilon_pi", "epsilon_printed", "epsilon_star", "gamma", "k",
    "kappa", "lam", "mu", "partialF_partialgamma", "partialepsilon_partialF",
    "partialepsilon_partialgamma", "phi", "psi", "psi0", "psi_f", "psi_max", "psi_min", "r",
    "theta", "theta_max", "theta_min", "u", "x", "x0",
]
# fmt: on


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
"""Derivatives, as independent symbols; claims say what they are equal to."""
a, b = _real("a"), _real("b")
"""Shape of the body: a = I₂/I₁ − 1, b = 1 − I₂/I₃."""
theta_min, theta_max = _real("theta_min"), _real("theta_max")
psi_min, psi_max = _real("psi_min"), _real("psi_max")
"""Bounds of the tilt and of the flip on one trajectory."""
gamma = _real("gamma")
"""Level of the motion, 0 on the separatrix: γ = 2 I₂ E/M² − 1."""
epsilon, epsilon0, epsilon_printed = map(_real, ("epsilon", "epsilon0", "epsilon_printed"))
"""Flip defect, the flip defect on the separatrix, and its value by the theorem's formula."""
depsilon_dgamma, partialepsilon_partialgamma = (
    _real("depsilon_dgamma"),
    _real("partialepsilon_partialgamma"),
)
partialepsilon_partialF, partialF_partialgamma = (
    _real("partialepsilon_partialF"),
    _real("partialF_partialgamma"),
)
"""Derivatives of the flip defect and of F, as independent symbols."""
psi0, psi_f = _real("psi0"), _real("psi_f")
Delta_psi, Delta_phi = _real("Delta_psi"), _real("Delta_phi")
"""Flip angle at the start and at the end; the changes of the flip and precession angles."""
S, S2 = _real("S"), _real("S2")
"""Signs of cos θ and of sin ψ cos ψ."""
x, x0 = _real("x"), _real("x0")
"""Auxiliary variable √(b/(a+b)) cos ψ, and its value at the start."""
T, k, r = _real("T"), _real("k"), _real("r")
"""Auxiliary variable of the stable form; k = √(ab), r = √(b/a)."""
kappa = _real("kappa")
epsilon_pi, epsilon_4 = _real("epsilon_pi"), _real("epsilon_4")
"""1/√(ab); the defect after one sweep of the phase, from π and from 4."""
P, Q, epsilon_star = _real("P"), _real("Q"), _real("epsilon_star")
"""The phase T/√(ab), log(ε₀/ε*), and the leading term ε* of ε₀."""
c1, c2 = _real("c1"), _real("c2")
"""Coefficients of ε₀ = ε*(1 + c₁ε*² + c₂ε*⁴ + …)."""
F = _real("F")
"""The integral of f from the flip defect to π/2."""
u, lam, mu = _real("u"), _real("lambda"), _real("mu")
"""The appendix's unknown and parameters: λ = 1/√(ab), μ = √(b/(a+b))."""

LATEX = {
    "dtheta_dt": r"\dot\theta",
    "dphi_dt": r"\dot\phi",
    "dpsi_dt": r"\dot\psi",
    "dM1_dt": r"\dot M_1",
    "dM2_dt": r"\dot M_2",
    "dM3_dt": r"\dot M_3",
    "dtheta_dphi": r"\frac{d\theta}{d\phi}",
    "dpsi_dphi": r"\frac{d\psi}{d\phi}",
    "depsilon_dgamma": r"\frac{d\epsilon}{d\gamma}",
    "partialepsilon_partialgamma": r"\frac{\partial\epsilon}{\partial\gamma}",
    "partialepsilon_partialF": r"\frac{\partial\epsilon}{\partial F}",
    "partialF_partialgamma": r"\frac{\partial F}{\partial\gamma}",
    "epsilon0": r"\epsilon_0",
    "epsilon_printed": r"\hat\epsilon_0",
    "epsilon_star": r"\epsilon_*",
    "c1": "c_1",
    "c2": "c_2",
    "psi_f": r"\psi_f",
    "Delta_psi": r"\Delta\psi",
    "Delta_phi": r"\Delta\phi",
    "lambda": r"\lambda",
    "theta_min": r"\theta_{\min}",
    "theta_max": r"\theta_{\max}",
    "psi_min": r"\psi_{\min}",
    "psi_max": r"\psi_{\max}",
    "epsilon_pi2": r"\epsilon_{\pi 2}",
    "chiprime": r"\chi'",
    "epsilonprime_r": r"\epsilon'_r",
    "epsilonprime_o": r"\epsilon'_o",
    "eigenvalue": r"\lambda",
}
"""The LaTeX of symbols whose names do not say it, by name."""

WORDS = {
    "I1": "principal moment of inertia about the handle",
    "I2": "principal moment of inertia about the intermediate axis",
    "I3": "principal moment of inertia about the normal of the face",
    "M": "length of the angular momentum",
    "M1": "angular momentum along the handle",
    "M2": "angular momentum along the intermediate axis",
    "M3": "angular momentum along the normal of the face",
    "Omega1": "angular velocity about the handle",
    "Omega2": "angular velocity about the intermediate axis",
    "Omega3": "angular velocity about the normal of the face",
    "E": "energy of the rotation",
    "R": "rotation from the body frame to the laboratory frame, by ψ, θ and φ about z, y and z",
    "theta": "Euler angle: tilt of the handle from the angular momentum",
    "phi": "Euler angle: precession of the handle about the angular momentum",
    "psi": "Euler angle: rotation about the handle, which is the flip",
    "a": "shape of the body: relative excess of the second moment over the first",
    "b": "shape of the body: relative deficit of the second moment from the third",
    "gamma": "level of the motion: 0 on the separatrix, negative where ψ oscillates",
    "S": "sign of cos θ, and of dψ/dφ: 1 or −1",
    "S2": "sign of sin ψ cos ψ: 1 or −1",
    "theta_min": "least tilt of the handle in a motion",
    "theta_max": "largest tilt of the handle in a motion",
    "psi_min": "lower turning point of an oscillating motion",
    "psi_max": "upper turning point of an oscillating motion",
    "psi0": "flip angle at the start",
    "psi_f": "flip angle at the end",
    "Delta_psi": "change of ψ in one turn of the handle: the flip",
    "Delta_phi": "change of φ: the turn of the handle",
    "epsilon": "flip defect: half of what the symmetric motion lacks to a half turn, Δψ = π − 2ε",
    "epsilon0": "flip defect on the separatrix",
    "epsilon_printed": "ε₀ by the formula of the theorem without its remainder",
    "x": "√(b/(a + b)) cos ψ, a variable of integration",
    "x0": "the value of x at the start",
    "F": "half a turn of the handle: the integral of dφ/dψ from ε to π/2",
    "lambda": "1/√(ab), small for large ab",
    "mu": "√(b/(a + b)), small with λ",
    "u": "correction of the exponent of ε₀ in the appendix",
    "kappa": "1/√(ab), the coordinate in which bounds for large ab are proved; λ of the appendix",
    "epsilon_star": "leading term of ε₀ for large ab",
    "c1": "first coefficient of ε₀ = ε*(1 + c₁ε*² + c₂ε*⁴ + …)",
    "c2": "second coefficient of ε₀ = ε*(1 + c₁ε*² + c₂ε*⁴ + …)",
    "P": "the phase on the separatrix, between π and 3π/2, from which ε₀ follows",
    "Q": "log(ε₀/ε*)",
    "epsilon_pi": "sweep from π: the defect after one step of the fixed-point iteration from π",
    "epsilon_4": "sweep from 4: the defect after one step of the fixed-point iteration from 4",
    "T": "unknown of the stable form, equal to √(ab) P at its root; a variable in lemmas about it",
    "k": "a variable of lemmas that are applied to √(ab)",
    "r": "a variable of lemmas that are applied to √(b/a)",
    "chi": "time before the middle of the flip, for a motion that may have turning points",
    "hot": "higher-order terms that the paper omits",
}
"""The meaning of each symbol in words, by name, in the order of the paper."""

WORDS_OF_PROOFS = {
    "dtheta_dphi": "derivative of θ by φ",
    "dpsi_dphi": "derivative of ψ by φ; its value at the start is an initial condition",
    "dtheta_dt": "rate of the tilt",
    "dphi_dt": "rate of the precession",
    "dpsi_dt": "rate of the flip angle",
    "dM1_dt": "rate of the angular momentum along the handle",
    "dM2_dt": "rate of the angular momentum along the intermediate axis",
    "dM3_dt": "rate of the angular momentum along the normal of the face",
    "depsilon_dgamma": "derivative of ε by γ",
    "partialF_partialepsilon": "derivative of F by its lower limit, for γ > 0",
    "partialF_partialepsilon0": "derivative of F by its lower limit, on the separatrix",
    "partialF_partialgamma": "derivative of F by γ, on the separatrix",
    "partialepsilon_partialF": "derivative of ε by F, on the separatrix",
    "partialepsilon_partialgamma": "derivative of ε by γ, on the separatrix",
    "P_pi": "phase after a sweep from π and one step of Newton's method",
    "epsilon_pi2": "defect for the phase after a sweep from π and one step of Newton's method",
    "P_4": "phase after a sweep from 4 and one step of Newton's method",
    "epsilon_42": "defect for the phase after a sweep from 4 and one step of Newton's method",
    "chiprime": "derivative of the time χ by γ, along a level",
    "epsilonprime_r": "derivative of ε by γ if ψ rotates",
    "epsilonprime_o": "derivative of ε by γ if ψ oscillates and has not reached a turning point",
    "B1": "first rotational constant of a molecule, as 1/I₁",
    "B2": "second rotational constant of a molecule, as 1/I₂",
    "B3": "third rotational constant of a molecule, as 1/I₃",
    "N1": "angular momentum along the handle at another time",
    "N2": "angular momentum along the intermediate axis at another time",
    "N3": "angular momentum along the normal of the face at another time",
}
"""The meaning of symbols that occur in single proofs only."""
