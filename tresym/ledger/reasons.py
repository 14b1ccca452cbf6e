"""The reasons that a step of a derivation may name."""

from __future__ import annotations

from sympy import Expr

from tresym.ledger.claim import Claim, Reason

algebra = Reason("algebra")
"""Rational functions; equal arguments give equal values. Always allowed, named for the reader."""
roots = Reason("roots", frozenset({"roots"}))
trigonometry = Reason("trigonometry", frozenset({"trigonometry"}))
exponentials = Reason("exponentials", frozenset({"exponentials"}))
inverses = Reason("inverse functions", frozenset({"inverses"}))
differentiation = Reason("differentiation")
"""Opens derivatives (`sympy.Derivative`), which are symbols of their own elsewhere."""
evaluating = Reason("evaluating")
"""Opens values (`sympy.Subs`, see `at`), which are symbols of their own elsewhere."""


def substituting(*claims: Claim) -> Reason:
    """Put in what earlier claims say of single symbols, on both sides."""
    return Reason("substituting", claims=claims)


def citing(*claims: Claim) -> Reason:
    """Use bounds proved earlier as conditions, where their own conditions are met."""
    return Reason("citing", claims=claims)


def applying(function: str) -> Reason:
    """Apply a one-to-one function (``exp``, ``sinh``, …) to both sides of an equation."""
    return Reason("applying", function=function)


def multiplying(factor: Expr) -> Reason:
    """Multiply both sides of an equation by a factor that is shown not to vanish."""
    return Reason("multiplying", factor=factor)


def adding(term: Expr) -> Reason:
    """Add a term to both sides of an equation."""
    return Reason("adding", term=term)


def changing_variable(new: Expr, *bounds: Claim) -> Reason:
    """Change the variable of an integral to ``new``, an expression in the old variable.

    ``bounds`` are proved inequalities that hold on the interval of integration.
    """
    return Reason("changing the variable", expression=new, claims=bounds)


def integrating(antiderivative: Expr, *bounds: Claim) -> Reason:
    """Integrate by an antiderivative: its derivative and its continuity are checked."""
    return Reason("integrating", expression=antiderivative, claims=bounds)


def cutting(at: Expr, *bounds: Claim) -> Reason:
    """Cut an integral at a point of its interval; its integrand must be continuous there."""
    return Reason("cutting", expression=at, claims=bounds)


def collecting(*bounds: Claim) -> Reason:
    """Write a sum of multiples of integrals over one interval as one integral."""
    return Reason("collecting", claims=bounds)


def differentiating_integral(slope: Expr, *bounds: Claim) -> Reason:
    """Differentiate an integral by a parameter, or by an end of it: Leibniz's rule.

    ``slope`` is the derivative of the integrand by the parameter, 0 where it has none. That it
    is, and that the integrand is smooth on the closed interval, is checked.
    """
    return Reason("differentiating the integral", expression=slope, claims=bounds)
