"""The theorems that the proofs quote, each once; a claim whose evidence applies one names it."""

from tresym.ledger.axioms import RULES, Axiom

LAGRANGE = Axiom(
    "Lagrange's inversion formula",
    "The power series w(y) with w = yφ(w) and w(0) = 0, and any power series H of it, have the "
    "coefficients that the powers of φ have.",
    "NIST Digital Library of Mathematical Functions, §1.10(vii)",
    r"[y^n]\,H(w(y)) = \frac1n\,[w^{n-1}]\,H'(w)\,\varphi(w)^n",
)

ROUCHE = Axiom(
    "Rouché's theorem",
    "Two holomorphic functions whose difference is smaller than one of them on a circle have "
    "equally many zeros inside it.",
    "J. B. Conway, Functions of One Complex Variable I, 2nd ed. (1978), Theorem V.3.8",
)

CAUCHY = Axiom(
    "Cauchy's estimate",
    "The coefficients of a power series are at most its largest size on a circle over the powers "
    "of the radius.",
    "J. B. Conway, Functions of One Complex Variable I, 2nd ed. (1978), Corollary IV.2.14",
    r"|c_n| \le \rho^{-n} \max_{|w|=\rho} |f(w)|",
)

CHEBYSHEV = Axiom(
    "Chebyshev's inequality for integrals",
    "The mean of a product of a falling and a rising function is at most the product of their "
    "means.",
    "G. H. Hardy, J. E. Littlewood, G. Pólya, Inequalities, 2nd ed. (1952), Theorem 236",
)

PICARD = Axiom(
    "Picard–Lindelöf theorem",
    "Differential equations with continuously differentiable right sides have one solution from "
    "each start.",
    "G. Teschl, Ordinary Differential Equations and Dynamical Systems (2012), Theorem 2.2",
)

(IMPLICIT_FUNCTION,) = (axiom for axiom in RULES if axiom.name == "implicit function theorem")
"""The same theorem as the judge's rule, where a sentence applies it to functions of its own."""
