"""Boole's formula: partial sums and tails of sums whose terms alternate in sign.

If f^(2m) has one sign on [n, ∞) and f^(2m−1) tends to 0, then for n → ∞

    Σ_(k=a..n) (−1)^k f(k) = C + (−1)^n (f(n)/2 − Σ_(j<m) E_(2j−1)(0)/(2 (2j−1)!) f^(2j−1)(n)) + R,
    |R| ≤ |E_(2m−1)(0)|/(2m−1)! |f^(2m−1)(n)|,

with Euler polynomials E_j and a constant C, the value of the series if it converges (DLMF 24.17.1;
R is the term j = m, at most half of the bound, and an integral of f^(2m), of which the bound takes
the largest value of |E_(2m−1)|, its value at the ends). The tail from n to ∞ is C less the sum up
to n − 1, which is (−1)^n (f(n)/2 + Σ_(j<m) E_(2j−1)(0)/(2 (2j−1)!) f^(2j−1)(n)).

Example: ``sum((-1)^k/(k + 1), k, 0, n) == log(2) + (-1)^n/(2*n) + O(1/n**2)``.
"""

from __future__ import annotations

from math import factorial

from flint import fmpq

from tresym.asymptotics.euler_maclaurin import FAR, TERMS, Summand, bounded, derivative
from tresym.asymptotics.lemma import Bound, End, Expansion, Obligations, folded
from tresym.asymptotics.stirling import bernoulli
from tresym.reals.decisions.identity import decide
from tresym.reals.decisions.known_values import known_value
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.operation_domains import preorder
from tresym.reals.expansions.limit_values import limit_of
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    MINUS_ONE,
    ONE,
    ZERO,
    Expr,
    add,
    apply,
    fresh,
    integer,
    number,
    opened,
    power,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict

LEMMA = "Boole's formula for alternating sums (DLMF 24.17(i))"


def euler_at_zero(n: int) -> fmpq:
    """Return the value of the Euler polynomial E_n at 0 (DLMF 24.4.26)."""
    return fmpq(-2 * (2 ** (n + 1) - 1)) * bernoulli(n + 1) / (n + 1)


class AlternatingSum(Expansion):
    """Σ (−1)^k f(k) from an integer to h(x), or from h(x) to ∞, where h tends to ∞."""

    lemma = LEMMA

    def __init__(self, terms: Summand, moving: Expr, low: int | None, end: End, name: str) -> None:
        """Expand a sum.

        Args:
            terms: f.
            moving: the last index, or the first one of a tail.
            low: the first index; None for a tail.
            name: a symbol for the constant.
        """
        self.summand, self.moving, self.low, self.end = terms, moving, low, end
        self.constant: Expr = ZERO
        if low is None:
            return
        self.constant = self._named() or symbol(name)
        self.unknown = frozenset((name,)) & symbols(self.constant)
        if self.unknown and symbols(terms.f) == {terms.k}:
            far = power(MINUS_ONE, number(FAR)) * self._at(TERMS, number(FAR), 1)
            bounds = terms.constant_from(far, self._weight(TERMS), -1)
            if bounds is not None:
                below, above = (number(bound) for bound in bounds)
                self.constants = Given(((symbol(name), ">", below), (symbol(name), "<", above)))

    def _named(self) -> Expr | None:
        """Return the constant where it is exact or a theorem gives the value of the series."""
        s = self.summand
        if s.first is not None and s.error(1, symbol(s.k)) == ZERO:  # of a polynomial: it is exact
            first = substitute(s.f, {s.k: number(s.low)}) - self._at(1, number(s.low), 1)
            return (-1) ** s.low * first
        if limit_of(s.f, s.k, None, 1, s.given) != ZERO:
            return None
        body = power(MINUS_ONE, symbol(s.k)) * s.f
        known = known_value("sum", body, s.k, number(s.low), INFINITY, s.given)
        return None if known is None else known.value

    def _at(self, order: int, at: Expr, side: int) -> Expr:
        """Return f/2 with the derivatives at a point: ``side`` is 1 at the end of a sum."""
        s = self.summand
        assert s.first is not None
        slopes = [
            number(-side * euler_at_zero(n) / (2 * factorial(n)))
            * substitute(derivative(s.f, s.k, n), {s.k: at})
            for n in range(1, 2 * (s.first + order - 1) - 1, 2)
        ]
        return add(substitute(s.f, {s.k: at}) / 2, *slopes)

    def _weight(self, order: int) -> fmpq:
        assert self.summand.first is not None
        n = 2 * (self.summand.first + order - 1) - 1
        return abs(euler_at_zero(n)) / factorial(n)

    def terms(self, order: int) -> tuple[Expr, Expr] | None:
        """Return the constant with the explicit terms at the index, and |f^(2m−1)| there."""
        side = -1 if self.low is None else 1
        try:
            near = power(MINUS_ONE, self.moving) * self._at(order, self.moving, side)
            error = folded(self.summand.error(order, self.moving))
        except InputError:
            return None
        return add(self.constant, near), ZERO if error == ZERO else apply("abs", error)

    def prove(self, order: int, ask: Obligations) -> Bound | None:
        """Prove the sign of the derivative, and that the index grows."""
        return bounded(self.summand, self.moving, self.end, order, ask, self._weight(order))


def alternating_sum(node: Expr, end: End) -> AlternatingSum | None:
    """Return the expansion of an alternating sum by Boole's formula, or None for others."""
    if node.op != "sum":
        return None
    (k,), body = opened(node, end.taken)
    low, high = node.args[1:]
    if body.hidden or low.hidden or high.hidden or end.name in symbols(body):
        return None
    try:
        f = _without_sign(body, k, end.given)
        if f is None:
            return None
        start = integer(low)
        terms = Summand(f, k, 1 if start is None else start, end.given)
        if terms.first is None:
            return None
        if start is not None and high != INFINITY and end.tends_to_infinity(high):
            name = fresh("C", {*symbols(node), *end.taken})
            return AlternatingSum(terms, high, start, end, name)
        if start is None and high == INFINITY and end.tends_to_infinity(low):
            converges = limit_of(f, k, None, 1, end.given) == ZERO
            return AlternatingSum(terms, low, None, end, "") if converges else None
    except (InputError, ZeroDivisionError, OverflowError):
        return None
    return None


def _without_sign(body: Expr, k: str, given: Given) -> Expr | None:
    """Return f where the body is (−1)^k f(k) and f has no such powers; or None."""
    s = symbol(fresh("s", {k, *symbols(body), *given.names}))
    powers = [e for e in preorder(body) if e.op == "^" and e.args[0] == MINUS_ONE]
    put = {
        e: s * MINUS_ONE ** substitute(e.args[1], {k: ZERO})
        for e in powers
        if differentiate(e.args[1], k) in (ONE, MINUS_ONE)
        and integer(substitute(e.args[1], {k: ZERO})) is not None
    }
    if not put:
        return None
    marked = replaced(body, put)
    odd, even = (substitute(marked, {str(s.args[0]): number(v)}) for v in (1, -1))
    return odd if decide(odd + even, ZERO, given).verdict is Verdict.PROVED else None
