"""Stirling's series for factorials, with its error theorem.

    n! = √(2πn) (n/e)^n exp(Σ_(j<m) B_2j/(2j(2j−1) n^(2j−1)) + R),  |R| ≤ |B_2m|/(2m(2m−1) n^(2m−1))

for every n > 0: the remainder is at most the first omitted term (DLMF 5.11.1 and 5.11(ii)). As
|e^R − 1| ≤ |R| e^|R|, the relative error is bounded for n ≥ 1. Binomial coefficients and other
quotients of factorials are combined from these. The argument must tend to infinity.

Example: ``factorial(n) == sqrt(2*pi*n)*(n/E)**n*(1 + O(1/n))`` holds with m = 1.
"""

from __future__ import annotations

from math import comb

from flint import fmpq

from tresym.asymptotics.lemma import Bound, End, Expansion, Obligations
from tresym.reals.language.calls import FACTORIAL
from tresym.reals.language.expression import (
    PI,
    Expr,
    add,
    apply,
    number,
    power,
    sqrt,
    symbol,
    symbols,
)


def bernoulli(n: int) -> fmpq:
    """Return the Bernoulli number B_n with B_1 = −1/2 (DLMF 24.2.1)."""
    found = [fmpq(1)]
    for m in range(1, n + 1):
        found.append(-sum((comb(m + 1, k) * found[k] for k in range(m)), fmpq(0)) / (m + 1))
    return found[n]


class Stirling(Expansion):
    """The expansion of a factorial whose argument tends to infinity."""

    lemma = "Stirling's series with its error bound (DLMF 5.11(ii))"

    def __init__(self, argument: Expr, end: End) -> None:
        """Expand the factorial of ``argument``."""
        self.argument, self.end = argument, end

    def logarithm(self, order: int) -> Expr:
        """Return log n! up to the first omitted term."""
        u = self.argument
        terms = [
            number(bernoulli(2 * j) / (2 * j * (2 * j - 1))) * power(u, number(1 - 2 * j))
            for j in range(1, order)
        ]
        return add(u * apply("log", u), -u, *terms)

    def terms(self, order: int) -> tuple[Expr, Expr] | None:
        """Return the series with ``order`` − 1 corrections and the first omitted term."""
        main = sqrt(2 * PI * self.argument) * apply("exp", self.logarithm(order))
        return main, main * power(self.argument, number(1 - 2 * order))

    def prove(self, order: int, ask: Obligations) -> Bound | None:
        """Quote the theorem; the argument must be at least 1."""
        size = abs(bernoulli(2 * order)) / (2 * order * (2 * order - 1))
        if size > 1 or not self.end.tends_to_infinity(self.argument):
            return None
        constant = size * (1 + 2 * size)  # e^R < 1 + 2R for 0 < R <= 1
        x = symbol(self.end.name)
        plain = self.argument == x or (self.argument / x).op == "number"
        if plain and self.end.point is None and self.argument == x:
            return Bound(constant, fmpq(1))
        return Bound(constant if self.argument == x else None, None)


def stirling(node: Expr, end: End) -> Stirling | None:
    """Return the expansion of a factorial whose argument tends to infinity, or None."""
    if node.op != "unknown" or node.args[0].args != (FACTORIAL, (0,)):
        return None
    argument = node.args[1]
    if argument.hidden or end.name not in symbols(argument):
        return None
    return Stirling(argument, end) if end.tends_to_infinity(argument) else None
