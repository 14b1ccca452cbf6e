"""Inequalities for binomials of two variables, by bounds of them that are known.

For integers 1 ≤ k ≤ n (n/k)ᵏ ≤ C(n, k) ≤ nᵏ/k! ≤ (e n/k)ᵏ, and C(n, k) ≤ 2ⁿ (R. L. Graham, D. E.
Knuth and O. Patashnik, *Concrete Mathematics*, chapters 5 and 9). Which of them a claim needs is
found by trying; what is left is an inequality without the binomial. A claim that none of them
proves may still be true.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from tresym.reals.decisions.answer import Answer, Decide
from tresym.reals.decisions.readable_witnesses import constants_hold
from tresym.reals.decisions.statement import Statement, functions
from tresym.reals.domain.conditions import Given
from tresym.reals.language.calls import FACTORIAL
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.expression import (
    ONE,
    ZERO,
    E,
    Expr,
    factors_in,
    multiply,
    number,
    power,
    substitute,
    symbols,
    unknown,
)
from tresym.reals.normal.to_expression import normal_form

KNOWN = "by a known bound of the binomial"


def decide_by_bounds(claim: Comparison, statement: Statement, decided: Decide) -> Answer | None:
    """Prove an inequality with one binomial; None if that is not shown."""
    left, relation, right = claim.left, claim.relation, claim.right
    if relation not in ("<", "<=", ">", ">="):
        return None
    for side, other, sign in ((left, right, relation), (right, left, _turned(relation))):
        found = _binomial(side)
        if found is None:
            continue
        n, k, rest = found
        if not decided(Comparison(rest, ">=", ZERO), statement):
            continue
        for choice in (k, normal_form(n - k, Given())):
            one = Comparison(rest, sign, other)
            positive = statement
            if not decided(Comparison(choice, ">=", ONE), statement):
                # k = 0, where the binomial is 1, is a case of its own
                if choice.op != "symbol" or not _holds_at_zero(one, choice, statement, decided):
                    continue
                more = Given(((choice, ">=", ONE),))
                positive = replace(statement, given=statement.given & more)
            for bound in _bounds(n, choice, upper=sign in ("<", "<=")):
                answer = decided(Comparison(multiply(bound, rest), sign, other), positive)
                if answer:
                    shown = f"{bound} {'>=' if sign in ('<', '<=') else '<='} binomial({n}, {k})"
                    return replace(answer, why=f"{KNOWN}, {shown}: {answer.why}")
    return None


def _holds_at_zero(one: Comparison, k: Expr, statement: Statement, decided: Decide) -> bool:
    """Return whether the claim with 1 for the binomial holds at k = 0."""
    if k.args[0] not in statement.integers or not decided(Comparison(k, ">=", ZERO), statement):
        return False
    zero = {k.args[0]: ZERO}
    there = statement.mapped(lambda e: substitute(e, zero))
    links = constants_hold(there.given.comparisons)
    if links is None:
        return False
    integers = tuple(name for name in statement.integers if name != k.args[0])
    there = replace(there, given=links, integers=integers)
    return bool(decided(one.mapped(lambda e: substitute(e, zero)), there))


def _turned(relation: str) -> str:
    return relation.translate(str.maketrans("<>", "><"))


def _bounds(n: Expr, k: Expr, upper: bool) -> Iterator[Expr]:
    """Yield bounds of C(n, k) for 1 <= k <= n."""
    if not upper:
        yield power(n / k, k)
        return
    yield power(multiply(E, n) / k, k)
    yield power(n, k) / unknown(FACTORIAL, (k,))
    yield power(number(2), n)


def _binomial(e: Expr) -> tuple[Expr, Expr, Expr] | None:
    """Return n, k and the rest of a product with n!/(k!*(n - k)!)."""
    above: list[Expr] = []
    below: list[Expr] = []
    rest: list[Expr] = []
    for factor in factors_in(e):
        inverse = factor.op == "^" and factor.args[1] == number(-1)
        parts = factors_in(factor.args[0]) if inverse else (factor,)
        if all(map(_is_factorial, parts)):
            (below if inverse else above).extend(part.args[1] for part in parts)
        else:
            rest.append(factor)
    if len(above) != 1 or len(below) != 2 or any(any(functions(part)) for part in rest):
        return None
    (n,), (k, other) = above, below
    if len(symbols(n) | symbols(k)) < 2 or normal_form(n - k - other, Given()) != ZERO:
        return None
    return n, k, multiply(ONE, *rest)


def _is_factorial(e: Expr) -> bool:
    return e.op == "unknown" and e.args[0].args == (FACTORIAL, (0,))
