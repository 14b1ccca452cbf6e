"""Refute claims about sums, products and integrals at small integers, in balls.

A claim with a variable that is an integer is evaluated at n = 0, 1, −1, 2, … as far as its sums can
be added up. Partial sums are continued from one n to the next. Only balls that exclude the claim
refute it, and the dispatcher confirms the witness.

Example: ``sum(1/k, k, 1, n) < 5`` fails at n = 83, where the sum is 5.002….
"""

from __future__ import annotations

from collections.abc import Iterator
from math import factorial

from flint import arb

from tresym.reals.decisions.answer import Answer, refuted
from tresym.reals.decisions.statement import Statement, factorial_arguments
from tresym.reals.domain.binder_values import enclosing
from tresym.reals.domain.evaluation import UndefinedError, evaluate, stands
from tresym.reals.language.binders import outermost
from tresym.reals.language.calls import FACTORIAL
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.expression import (
    Expr,
    integer,
    number,
    opened,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import NEGATED
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.values import improper

BITS = 128
FARTHEST, FARTHEST_INSIDE = 390, 24
"""The largest n, and the largest where every term of a sum changes with n."""
NEGATIVE = 3


def refuted_at_integers(claim: Comparison, statement: Statement) -> Answer | None:
    """Return a refutation at a small integer, or None.

    Only for claims in one variable, which is an integer, without further equations.
    """
    names = symbols(claim.left) | symbols(claim.right) | statement.given.names
    names -= {"oo"}
    if len(names) != 1 or claim.derivatives or statement.path is not None or statement.equations:
        return None
    (name,) = names
    if name not in statement.integers or claim.relation not in NEGATED:
        return None
    arguments = factorial_arguments((claim.left, claim.right))
    values = _Values(claim, name, name in statement.given.names)
    with ball_precision(BITS):
        for n in _integers(values.farthest):
            at = {name: number(n)}
            if not all(c.holds_exactly({name: arb(n)}) for c in statement.given.conditions):
                continue
            if any(evaluate(e, {name: arb(n)}) < 0 for e in arguments):
                continue
            try:
                left, right = (values.side(e, n) for e in (claim.left, claim.right))
            except (InputError, ZeroDivisionError, OverflowError, KeyError):
                continue
            if left is None or right is None:
                continue
            if stands(left - right, NEGATED[claim.relation]):
                point = {name: at[name].args[0]}
                return refuted(f"it fails at {name} = {n}", point, left, right)
    return None


def _integers(farthest: int) -> Iterator[int]:
    yield from range(farthest + 1)
    yield from range(-1, -NEGATIVE - 1, -1)


def _without_factorials(e: Expr) -> Expr:
    """Return a constant with the values of its factorials; what has none is left."""
    fixed = {}
    for node in outermost(e):
        n = integer(node.args[-1]) if node.args[0].args == (FACTORIAL, (0,)) else None
        if n is not None and 0 <= n <= FARTHEST:
            fixed[node] = number(factorial(n))
    return replaced(e, fixed) if fixed else e


class _Values:
    """Both sides of a claim at integers, with the partial sums that are known."""

    def __init__(self, claim: Comparison, name: str, empty: bool) -> None:
        self.name, self.empty = name, empty
        self.nodes = list(dict.fromkeys(outermost(claim.left, claim.right)))
        self.partial: dict[tuple[Expr, int], arb] = {}
        hard = any(
            node.op == "integral" or name in symbols(node.args[0])
            for node in self.nodes
            if node.op != "unknown"
        )
        self.farthest = FARTHEST_INSIDE if hard else FARTHEST

    def side(self, e: Expr, n: int) -> arb | None:
        """Return a side at n; None where no value is proved to exist."""
        known: dict[Expr, Expr] = {}
        at: dict[str, arb] = {self.name: arb(n)}
        for m, node in enumerate(outermost(e)):
            value = self._node(node, n)
            if value is None or not value.is_finite():
                return None
            known[node] = symbol(f"[{m}]")
            at[f"[{m}]"] = value
        found = evaluate(substitute(replaced(e, known), {self.name: number(n)}), at)
        return found if found.is_finite() else None

    def _node(self, node: Expr, n: int) -> arb | None:
        put = {self.name: number(n)}
        if node.op == "unknown":
            if node.args[0].args != (FACTORIAL, (0,)):
                return None
            m = evaluate(substitute(node.args[1], put), {}).unique_fmpz()
            return None if m is None or m < 0 else arb(int(m) + 1).gamma()
        if node.op == "integral":
            try:
                return improper.integral(substitute(node, put), enclosing({}))
            except UndefinedError:
                return None
        if node.op not in ("sum", "product"):
            return None
        (k,), body = opened(node, {self.name})
        ends = [evaluate(substitute(e, put), {}).unique_fmpz() for e in node.args[1:]]
        if None in ends or any(n.op != "unknown" for n in outermost(body)):
            return None
        low, high = (int(end) for end in ends if end is not None)
        if not (-1 if self.empty else 0) <= high - low <= FARTHEST:
            return None  # no claim is made of an empty sum, unless a condition speaks of n
        fixed = integer(node.args[1]) is not None and self.name not in symbols(body)
        before = self.partial.get((node, high - 1)) if fixed else None
        start = high if before is not None and high > low else low
        total = before if start != low and before is not None else None
        result = total if total is not None else arb(0 if node.op == "sum" else 1)
        for j in range(start, high + 1):
            term = evaluate(_without_factorials(substitute(body, {**put, k: number(j)})), {})
            result = result + term if node.op == "sum" else result * term
        if fixed:
            self.partial[node, high] = result
        return result
