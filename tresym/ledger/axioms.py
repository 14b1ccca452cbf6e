"""Quoted theorems on which claims rest, each named once with its source.

A claim names the theorems that its evidence quotes. Its report also lists those of all claims it
depends on, as Lean's ``#print axioms`` does. `RULES` are the theorems of calculus that justify the
judge's own rules; every claim may depend on them, so they are not repeated for each claim.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Axiom:
    """A theorem that is quoted without proof.

    Attributes:
        name: the usual name of the theorem.
        says: the theorem, in one or two sentences.
        source: where it is proved: book and number of the theorem.
        formula: LaTeX of its conclusion, or None.
        rule: for a member of `RULES`, the rule of the judge that applies it.
    """

    name: str
    says: str
    source: str
    formula: str | None = None
    rule: str = ""


KHALIL = "H. K. Khalil, Nonlinear Systems, 3rd ed. (2002), Theorem "
RUDIN = "W. Rudin, Principles of Mathematical Analysis, 3rd ed. (1976), Theorem "

RULES = (
    Axiom(
        "intermediate value theorem",
        "A continuous function on an interval takes every value between two that it takes.",
        RUDIN + "4.23",
        rule="exactly one",
    ),
    Axiom(
        "mean value theorem",
        "A differentiable function whose derivative has one sign on an interval is strictly "
        "monotone there; where the derivative is 0 throughout, it is constant.",
        RUDIN + "5.10 and 5.11",
        r"f(y) - f(x) = (y - x) f'(\xi)",
        "locally constant; exactly one; sign; a bound by its slopes",
    ),
    Axiom(
        "Taylor's theorem",
        "What a Taylor polynomial leaves out is a term of the next order, with its derivative in "
        "between.",
        RUDIN + "5.15",
        r"f(y) = \sum_{k<n} \frac{f^{(k)}(x)}{k!}(y-x)^k + \frac{f^{(n)}(\xi)}{n!}(y-x)^n",
        "sign; order; a bound on a box",
    ),
    Axiom(
        "fundamental theorem of calculus",
        "The integral of a continuous function is the difference of the values of an "
        "antiderivative.",
        RUDIN + "6.20 and 6.21",
        r"\int_p^q F'(x)\,dx = F(q) - F(p)",
        "integrating",
    ),
    Axiom(
        "order of integrals",
        "The integral of a continuous function of one sign over an interval has that sign, and "
        "integrals are linear and add up over adjoining intervals.",
        RUDIN + "6.12",
        rule="sign of an integral; collecting; cutting",
    ),
    Axiom(
        "change of variable",
        "A continuously differentiable substitution carries an integral over.",
        RUDIN + "6.19",
        r"\int_{g(p)}^{g(q)} f(x)\,dx = \int_p^q f(g(u))\,g'(u)\,du",
        "changing the variable",
    ),
    Axiom(
        "Leibniz's rule",
        "An integral may be differentiated under its sign where the derivative of the integrand "
        "is continuous on the closed strip.",
        RUDIN + "9.42",
        r"\frac{d}{dp}\int_x^y f(u, p)\,du = \int_x^y \frac{\partial f}{\partial p}(u, p)\,du",
        "differentiating the integral",
    ),
    Axiom(
        "implicit function theorem",
        "Where an equation is smooth and its derivative by the unknown is not zero, it has one "
        "solution nearby, which is smooth.",
        RUDIN + "9.28",
        r"\frac{dx}{dp} = -\frac{\partial L/\partial p}{\partial L/\partial x}",
        "implicit function; a root monotone in a parameter",
    ),
    Axiom(
        "Lyapunov's theorem",
        "An equilibrium is stable if a function that does not increase along the motion has a "
        "strict minimum there.",
        KHALIL + "4.1",
        rule="stable equilibrium",
    ),
    Axiom(
        "instability by the first approximation",
        "An equilibrium is unstable if the linearised system has an eigenvalue with a positive "
        "real part.",
        KHALIL + "4.7",
        rule="unstable equilibrium",
    ),
)
"""Theorems that make the judge's rules sound; `tresym verify` quotes them for all claims."""
