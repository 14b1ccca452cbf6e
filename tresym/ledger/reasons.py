"""The reasons that a step of a derivation may name."""

from __future__ import annotations

from typing import Any

from tresym.ledger.claim import Claim, Reason

algebra = Reason("algebra")
"""Rational functions, and equality of function values at equal arguments. Every step may use it;
it is named only for the reader."""
roots = Reason("roots", frozenset({"roots"}))
trigonometry = Reason("trigonometry", frozenset({"trigonometry"}))
exponentials = Reason("exponentials", frozenset({"exponentials"}))
inverses = Reason("inverse functions", frozenset({"inverses"}))
differentiation = Reason("differentiation")
"""Carries out derivatives, which otherwise count as variables."""
evaluating = Reason("evaluating")
"""Carries out values at a point, which otherwise count as variables."""


def substituting(*claims: Claim) -> Reason:
    """Substitute the equations of earlier claims for symbols, on both sides of the step."""
    return Reason("substituting", claims=claims)


def citing(*claims: Claim) -> Reason:
    """Use the bounds of earlier claims as conditions, if their own conditions are met."""
    return Reason("citing", claims=claims)


def applying(function: str) -> Reason:
    """Apply an injective function (``"exp"``, ``"sinh"``, …) to both sides of an equation.

    For an inequality, the function must be monotone (``"cos"`` or ``"sin"``).
    """
    return Reason("applying", function=function)


def multiplying(factor: Any) -> Reason:
    """Multiply both sides of an equation by a factor that is proved not to be zero."""
    return Reason("multiplying", factor=factor)


def adding(term: Any) -> Reason:
    """Add a term to both sides of an equation."""
    return Reason("adding", term=term)


def changing_variable(new: Any, *bounds: Claim) -> Reason:
    """Change the variable of an integral to ``new``, an expression in the old variable.

    Args:
        new: the new variable as a function of the old one.
        bounds: proved inequalities that hold on the interval of integration.
    """
    return Reason("changing the variable", expression=new, claims=bounds)


def integrating(antiderivative: Any, *bounds: Claim) -> Reason:
    """Evaluate an integral by an antiderivative; its derivative and continuity are checked."""
    return Reason("integrating", expression=antiderivative, claims=bounds)


def cutting(at: Any, *bounds: Claim) -> Reason:
    """Split an integral at a point of its interval; the integrand must be continuous."""
    return Reason("cutting", expression=at, claims=bounds)


def collecting(*bounds: Claim) -> Reason:
    """Combine a linear combination of integrals over one interval into a single integral."""
    return Reason("collecting", claims=bounds)


def differentiating_integral(slope: Any, *bounds: Claim) -> Reason:
    """Differentiate an integral with respect to a parameter or to one of its ends (Leibniz's rule).

    That ``slope`` is correct and that the integrand is smooth on the closed interval is checked.

    Args:
        slope: the derivative of the integrand with respect to the parameter; 0 if the integrand
            does not depend on it.
        bounds: proved inequalities that hold on the interval of integration.
    """
    return Reason("differentiating the integral", expression=slope, claims=bounds)
