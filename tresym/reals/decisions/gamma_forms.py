"""Decide claims with factorials and gamma functions together: n! = Γ(n + 1).

A factorial speaks of integers n ≥ 0 alone, a gamma function of all real numbers. The claim with
Γ(n + 1) for n! is therefore at least as strong, and it is decided for integers n ≥ 0.
"""

from __future__ import annotations

from dataclasses import replace

from tresym.reals.decisions.answer import Answer, Decide
from tresym.reals.decisions.statement import Statement, functions
from tresym.reals.domain.conditions import Given
from tresym.reals.language.calls import FACTORIAL
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.expression import ONE, ZERO, Expr, apply, rebuild, symbols


def decide_by_gamma(comparison: Comparison, statement: Statement, decided: Decide) -> Answer:
    """Decide a claim with Γ(n + 1) put for every n!."""
    arguments = {
        node.args[1]
        for e in (comparison.left, comparison.right, *statement.said)
        for node in functions(e)
        if node.args[0].args == (FACTORIAL, (0,))
    }
    there = Given(tuple((n, ">=", ZERO) for n in sorted(arguments, key=str) if symbols(n)))
    changed = statement.mapped(with_gamma)
    path = changed.path
    moving = path is not None and any(path.name in symbols(n) for n in arguments)
    given = changed.given if moving else changed.given & there
    answer = decided(comparison.mapped(with_gamma), replace(changed, given=given))
    return replace(answer, why=f"with n! = gamma(n + 1): {answer.why}")


def with_gamma(e: Expr) -> Expr:
    """Return ``e`` with Γ(n + 1) for n!."""
    if not e.hidden:
        return e
    args = tuple(with_gamma(arg) if isinstance(arg, Expr) else arg for arg in e.args)
    if e.op == "unknown" and e.args[0].args == (FACTORIAL, (0,)):
        return apply("gamma", args[1] + ONE)
    return rebuild(e, args) if args != e.args else e
