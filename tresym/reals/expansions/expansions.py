"""Expansions in the most rapidly varying element of a scale, with certified remainders.

    f = c₀ w^p₀ + c₁ w^p₁ + … + c_{n−1} w^p_{n−1} + R,   p₀ < p₁ < …

The coefficients are expressions, so what cancels is seen by the exact normal form and by nothing
else; R is bounded by a number times a product of powers of elements on all of 0 < t ≤ reach. The
leading term of c₀ is found in turn, and so that of f (D. Gruntz, *On Computing Limits in a Symbolic
Manipulation System*, 1996). Taylor's theorem gives the remainders: on |v| ≤ s < 1 the nth
coefficient of log(1 + v) and of atan v is at most 1/n and 1/(n (1 − s)^n), and so on.
"""

from __future__ import annotations

from functools import lru_cache
from math import factorial

from flint import arb, arb_series, ctx, fmpq

from tresym.reals.domain.evaluation import evaluate
from tresym.reals.expansions.scale import (
    UnresolvedError,
)
from tresym.reals.expansions.series_arithmetic import ORDERS, SeriesArithmetic
from tresym.reals.expansions.truncated_series import Series, ShortError, plus
from tresym.reals.functions.row import Function
from tresym.reals.functions.table import TABLE
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ONE,
    ZERO,
    Expr,
    apply,
    as_expr,
    number,
    power,
    substitute,
    symbol,
    symbols,
    trees,
)
from tresym.reals.normal.field import ALL_THEORIES
from tresym.reals.normal.locally_constant import equal_constants


class Expansions(SeriesArithmetic):
    """Expansions of functions of the elements of ``scale``, with bounds for 0 < t ≤ ``reach``.

    Without a reach there are no bounds, and what is found holds as t → 0.
    """

    def limit(self, e: Expr) -> Expr | int:
        """The limit as t → 0; ±1 for ±∞.

        Raises:
            UnresolvedError: it is not found, or waves have none.
        """
        inside = self.scale.elements(e)
        if not inside:
            if self.scale.phases(e) and not self.scale.is_zero(e):
                raise UnresolvedError("an oscillating term")
            return e
        for n in ORDERS:
            found = self.tried(e, inside[0], n)
            while found.terms and self.scale.is_zero(found.terms[0][1]):
                found.terms.pop(0)
            low = self.scale.sign(found.terms[0][0]) if found.terms else 1
            if low < 0:
                first = self.leading(e)
                return self.scale.sign(first.coefficient) if first else ZERO
            if found.end is None or self.scale.sign(found.end) > 0:
                return self.limit(found.terms[0][1]) if low == 0 else ZERO
        raise UnresolvedError("no limit was found")

    def growth(self, e: Expr) -> int:
        """1 where ``e`` is unbounded, 0 where it is of the order of 1, −1 where it tends to 0."""
        found = self.leading(e)
        return -1 if found is None else self.scale.growth(found.powers)

    def _split(self, f: Series) -> tuple[Expr, Series]:
        """c₀ and v of f = c₀ + v, where v has positive powers alone."""
        terms, constant = [], ZERO
        for p, c in f.terms:
            sign = self.scale.sign(p)
            if sign > 0:
                terms.append((p, c))
            elif sign == 0:
                constant = c
            elif self.leading(c) is not None:
                raise UnresolvedError("an unbounded argument")
        if f.end is not None and self.scale.sign(f.end) <= 0:
            raise ShortError("too few terms of the argument are known")
        return constant, Series(terms, f.end, f.rest)

    def _exp(self, f: Series, w: str, n: int) -> Series:
        c, v = self._split(f)
        known = [number(fmpq(1, factorial(k))) for k in range(n)]
        body = self._compose(known, lambda s, m: s.exp() / factorial(m), v, w, n)
        return self.product(Series([(ZERO, ONE if c == ZERO else apply("exp", c))]), body, w, n)

    def _log(self, f: Series, w: str, n: int) -> Series:
        c, p, sign = self.relative(f)
        if sign < 0 or self.scale.sign(p):
            raise UnresolvedError("the logarithm of an expression that is not of order 1")
        v = self._beyond(f, c, p, w, n)
        known = [ZERO, *(number(fmpq((-1) ** (k + 1), k)) for k in range(1, n))]
        body = self._compose(known, lambda s, m: 1 / (m * (1 - s) ** m), v, w, n)
        front = [] if c == ONE else [(ZERO, apply("log", c))]
        return self.sum([Series(front), body], w, n)

    def _wave(self, f: Series, w: str, n: int, odd: int) -> Series:
        """The sine, or cosine for ``odd`` 0: (1, v, −v²/2, …) turned by the constant term."""
        c, v = self._split(f)

        def about_zero(odd: int) -> Series:
            at = [number(fmpq((-1) ** (k // 2), factorial(k))) for k in range(n)]
            kept = [a if k % 2 == odd else ZERO for k, a in enumerate(at)]
            return self._compose(kept, lambda _, m: arb(1) / factorial(m), v, w, n)

        if c == ZERO:
            return about_zero(odd)
        sine, cosine = (Series([(ZERO, apply(name, c))]) for name in ("sin", "cos"))
        if not odd:
            sine, cosine = cosine, self.product(sine, Series([(ZERO, number(-1))]), w, n)
        parts = (sine, about_zero(0)), (cosine, about_zero(1))
        return self.sum([self.product(x, y, w, n) for x, y in parts], w, n)

    def _cos(self, f: Series, w: str, n: int) -> Series:
        return self._wave(f, w, n, 0)

    def _sin(self, f: Series, w: str, n: int) -> Series:
        return self._wave(f, w, n, 1)

    def _atan(self, f: Series, w: str, n: int) -> Series:
        c, v = self._split(f)
        if c != ZERO:  # atan(c + v) = atan c + atan(v/(1 + c² + c v)) as long as c (c + v) > −1
            below = self.sum(
                [
                    Series([(ZERO, plus(ONE, power(c, number(2))))]),
                    self.product(Series([(ZERO, c)]), v, w, n),
                ],
                w,
                n,
            )
            v = self.product(v, self.power(below, fmpq(-1), w, n), w, n)
        known = [ZERO if k % 2 == 0 else number(fmpq((-1) ** (k // 2), k)) for k in range(n)]
        body = self._compose(known, lambda _, m: arb(1) / m, v, w, n)
        front = [] if c == ZERO else [(ZERO, apply("atan", c))]
        return self.sum([Series(front), body], w, n)

    def _abs(self, f: Series, w: str, n: int) -> Series:
        if len(f.terms) == 1 and f.end is None:
            return Series([(f.terms[0][0], apply("abs", f.terms[0][1]))])
        raise UnresolvedError(
            "an absolute value of an expression that changes sign infinitely often"
        )

    def special(self, e: Expr, f: Series, w: str, n: int) -> Series:
        """Taylor's theorem for a special function, or the expansion of a factor at 0."""
        row, parameters = TABLE[e.op], e.args[:-1]
        c, v = self._split(f)
        n = min(n, row.terms or n)
        known = [_coefficient(row, parameters, c, k) for k in range(n)]

        def rest(s: arb, m: int) -> arb:
            balls = [self.scale.ball(x) for x in parameters]
            if row.remainder is not None and c == ZERO:
                found = row.remainder(*balls, s, m)
            else:
                found = _jet(row, parameters, balls, self.scale.ball(c) + arb(0, 1) * s, m)
            if not found.is_finite():
                raise UnresolvedError("the range is too long for an expansion")
            return abs(found)

        return self._compose(known, rest, v, w, n)


Z = "_z"
"""The variable by which a function is differentiated."""


def _coefficient(row: Function, parameters: tuple[Expr, ...], c: Expr, k: int) -> Expr:
    """The k-th Taylor coefficient of a function of the last argument at c."""
    if c == ZERO and row.taylor is not None:
        found = row.taylor(*parameters, k, trees)
        if found is not None:
            return as_expr(found)
    if row.remainder is not None:
        raise UnresolvedError("a factor of an expansion away from its end")
    value = substitute(_derivative(row.name, parameters, k), {Z: c})
    return tidied_constant(value * number(fmpq(1, factorial(k))))


@lru_cache(maxsize=1 << 10)
def _derivative(name: str, parameters: tuple[Expr, ...], k: int) -> Expr:
    if k == 0:
        return Expr(name, (*parameters, symbol(Z)))
    return differentiate(_derivative(name, parameters, k - 1), Z)


def tidied_constant(e: Expr) -> Expr:
    """A coefficient, 0 if that is shown, so that it is not taken for a leading one."""
    return ZERO if not symbols(e) and equal_constants(e, ZERO, ALL_THEORIES) else e


def _jet(row: Function, parameters: tuple[Expr, ...], balls: list[arb], around: arb, m: int) -> arb:
    """The m-th Taylor coefficient at all points of a ball."""
    if row.series is not None:
        before = ctx.cap
        ctx.cap = m + 1
        try:
            at = arb_series([around, 1], m + 1)
            found = row.series(*(arb_series([x], m + 1) for x in balls), at)
            if found.prec > m and found[m].is_finite():
                return arb(found[m])
        except (ValueError, ZeroDivisionError):
            pass
        finally:
            ctx.cap = before
    value = evaluate(_derivative(row.name, parameters, m), {Z: around})
    return value / factorial(m)
