"""Decide claims with factorials and gamma functions together: n! = Γ(n + 1).

A factorial speaks of integers n ≥ 0 alone, a gamma function of all real numbers. The claim with
Γ(n + 1) for n! is therefore at least as strong, and it is decided for integers n ≥ 0.
"""

from __future__ import annotations

from dataclasses import replace

from tresym.reals.decisions.answer import Answer, Decide
from tresym.reals.decisions.statement import Statement, functions
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.operation_domains import operations
from tresym.reals.language.calls import FACTORIAL
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.expression import (
    ONE,
    ZERO,
    Expr,
    apply,
    number,
    rebuild,
    symbol,
    symbols,
)
from tresym.reals.signs.interior import PROVING
from tresym.reals.signs.sign import sign


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


def decide_as_reals(comparison: Comparison, statement: Statement, decided: Decide) -> Answer | None:
    """Prove an inequality between factorials for all real numbers from the first integer on.

    ``factorial(n) >= (n/E)**n given n integer, n >= 1`` follows from ``gamma(n + 1) >= (n/E)**n
    given n >= 1``, which is stronger. None where that is not shown: at numbers that are no integers
    an inequality may fail, as gamma(n + 1) >= 1 does at n = 1/2.
    """
    trees = (comparison.left, comparison.right, *statement.said)
    if comparison.relation not in ("<", "<=", ">", ">=") or statement.path is not None:
        return None
    if statement.equations or comparison.derivatives:
        return None
    changed = [with_gamma(e) for e in trees]
    if any(e.hidden for e in changed):
        return None
    box = statement.given.box
    least = {name: box[name].first_integer() for name in statement.integers if name in box}
    first = ((symbol(n), ">=", number(low)) for n, low in least.items() if low is not None)
    real = replace(statement, integers=(), given=statement.given & Given(tuple(first)))
    # A power of a negative number has a value at integer exponents alone, and would be left out.
    for node in operations(changed):
        varies = node.op == "^" and bool(symbols(node.args[1]))
        if varies and sign(node.args[0], real.given, ">") not in PROVING[">"]:
            return None
    answer = decide_by_gamma(comparison, real, decided)
    return answer if answer else None


def with_gamma(e: Expr) -> Expr:
    """Return ``e`` with Γ(n + 1) for n!."""
    if not e.hidden:
        return e
    args = tuple(with_gamma(arg) if isinstance(arg, Expr) else arg for arg in e.args)
    if e.op == "unknown" and e.args[0].args == (FACTORIAL, (0,)):
        return apply("gamma", args[1] + ONE)
    return rebuild(e, args) if args != e.args else e
