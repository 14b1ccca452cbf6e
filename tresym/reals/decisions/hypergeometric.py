"""Hypergeometric series: infinite sums whose successive terms have a rational ratio.

A term is a product of rational functions of n, factorials of linear functions of n, and powers with
n in the exponent. The ratio of consecutive terms gives the radius of convergence; Gauss's test
decides convergence at its ends. Source: K. Knopp, *Theory and Application of Infinite
Series*, §§ 20 and 36.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import factorial, gcd

from flint import arb, fmpq, fmpq_poly, fmpz_poly

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.expansions.laurent import OpenError, root
from tresym.reals.language.calls import FACTORIAL, INFINITY
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    LEAVES,
    ONE,
    ZERO,
    Expr,
    apply,
    integer,
    multiply,
    number,
    opened,
    rebuild,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.normal.at_point import equal_at
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.signs.sign import sign

HIGHEST = 6
"""Up to which degree a polynomial is read."""
LATEST = 12
"""Up to where a first term that is not 0 is looked for."""
TERMS = 400
K = fmpq_poly([0, 1])


@dataclass(frozen=True)
class Series:
    """``Σ head f(k) u^(p k + q)`` over k = 0, 1, …, with ``f(0) = 1``.

    Attributes:
        above, below: P and Q, where ``f(k + 1)/f(k) = P(k)/Q(k)``; no natural number is a root.
        u: what is raised, 1 where the terms are numbers.
        step, start: p and q.
        head: what stands before all of it.
        first: the first term as it is written.
    """

    above: fmpq_poly
    below: fmpq_poly
    u: Expr
    step: int
    start: int
    head: Expr
    first: Expr

    @property
    def rate(self) -> fmpq | None:
        """The limit of the ratio without u^p; None where that is infinite."""
        gap = self.above.degree() - self.below.degree()
        if gap > 0:
            return None
        return fmpq(0) if gap < 0 else _lead(self.above) / _lead(self.below)

    def converges(self, positive: bool) -> bool:
        """By Gauss, where the ratio of terms tends to 1, or to −1: it is ±(1 − s/k + O(1/k²))."""
        n = self.below.degree()
        s = self.below[n - 1] / self.below[n] - self.above[n - 1] / self.above[n]
        return bool(s > 1) if positive else bool(s > 0)


def _lead(p: fmpq_poly) -> fmpq:
    return p[p.degree()]


# The terms


def series_of(node: Expr, avoid: frozenset[str] = frozenset()) -> Series | None:
    """Return the hypergeometric series of an infinite sum, or None if it is not one."""
    low = integer(node.args[1])
    if node.op != "sum" or node.args[2] != INFINITY or low is None:
        return None
    (n,), body = opened(node, avoid)
    try:
        return _series(body, n, low)
    except (OpenError, ZeroDivisionError, InputError):
        return None


class _Terms:
    """The factors of a term, each a rational function of n, a factorial, or a power."""

    def __init__(self, n: str) -> None:
        self.n = n
        self.above, self.below = fmpq_poly([1]), fmpq_poly([1])
        self.head: list[Expr] = []
        self.coefficient: list[Expr] = []
        self.bases: list[tuple[Expr, int, int]] = []

    def ratio(self, above: fmpq_poly, below: fmpq_poly, times: int) -> None:
        if times < 0:
            above, below, times = below, above, -times
        self.above *= above**times
        self.below *= below**times

    def take(self, e: Expr, times: int) -> None:
        """One more factor, ``e**times``."""
        n = self.n
        if n not in symbols(e):
            self.head.append(e ** number(times))
        elif e.op == "*":
            for arg in e.args:
                self.take(arg, times)
        elif e.op == "^" and n not in symbols(e.args[0]):
            self.power(e.args[0], e.args[1], times)
        elif e.op == "^" and e.args[1].op == "number" and e.args[1].args[0].q == 1:
            self.take(e.args[0], times * int(e.args[1].args[0].p))
        elif e.op == "exp":
            self.exponential(e.args[0], times)
        elif e.op == "unknown" and e.args[0].args == (FACTORIAL, (0,)):
            self.coefficient.append(e ** number(times))
            slope, start = _linear(e.args[1], n)
            if slope < 0:
                raise OpenError
            for j in range(1, slope + 1):
                self.ratio(fmpq_poly([start + j, slope]), fmpq_poly([1]), times)
        else:
            p = polynomial(e, n)
            self.coefficient.append(e ** number(times))
            self.ratio(p(K + 1), p, times)

    def power(self, base: Expr, exponent: Expr, times: int) -> None:
        slope, start = _linear(exponent, self.n)
        slope, start = slope * times, start * times
        if base.op == "number":
            self.coefficient.append(base ** (slope * symbol(self.n) + start))
            self.ratio(fmpq_poly([base.args[0]]), fmpq_poly([1]), slope)
        else:
            self.bases.append((base, slope, start))

    def exponential(self, inner: Expr, times: int) -> None:
        slope = differentiate(inner, self.n)
        if self.n in symbols(slope):
            raise OpenError
        self.head.append(apply("exp", times * substitute(inner, {self.n: ZERO})))
        self.bases.append((apply("exp", times * slope), 1, 0))


def _linear(e: Expr, n: str) -> tuple[int, int]:
    """The slope and the start of what is linear in n, both integers."""
    p = polynomial(e, n)
    if p.degree() > 1 or p[0].q != 1 or p[1].q != 1:
        raise OpenError
    return int(p[1].p), int(p[0].p)


def polynomial(e: Expr, n: str) -> fmpq_poly:
    """A polynomial in n with rational coefficients.

    Raises:
        OpenError: ``e`` is none.
    """
    if e.op == "number":
        return fmpq_poly([e.args[0]])
    if e.op == "symbol" and e.args == (n,):
        return K
    if e.op in ("+", "*"):
        parts = [polynomial(arg, n) for arg in e.args]
        result = parts[0]
        for part in parts[1:]:
            result = result + part if e.op == "+" else result * part
        return result
    if e.op == "^" and e.args[1].op == "number":
        r = e.args[1].args[0]
        if r.q == 1 and 0 < r <= HIGHEST:
            return polynomial(e.args[0], n) ** int(r.p)
    raise OpenError


def _series(body: Expr, n: str, low: int) -> Series | None:
    terms = _Terms(n)
    terms.take(body, 1)
    if terms.above == 0 or terms.below == 0:
        return None
    coefficient = multiply(*terms.coefficient)
    for a in range(low, low + LATEST):
        first = folded(substitute(coefficient, {n: number(a)}))
        if first is None:
            return None
        if not equal_at(first, ZERO, {}):
            break
    else:
        return None
    shared = terms.above.gcd(terms.below)
    above, below = ((p // shared)(K + a) for p in (terms.above, terms.below))
    if any(k >= 0 for p in (above, below) for k in whole_roots(p)):
        return None
    u, step, start, more = _raised(terms.bases)
    head = multiply(*terms.head, first, more)
    whole = folded(substitute(body, {n: number(a)}))
    return None if whole is None else Series(above, below, u, step, start + step * a, head, whole)


def _raised(bases: list[tuple[Expr, int, int]]) -> tuple[Expr, int, int, Expr]:
    """The bases of all powers as one, u^(p n + q), and what else there is."""
    if not bases:
        return ONE, 1, 0, ONE
    step = gcd(*(p for _, p, _ in bases))
    _, p, q = max(bases, key=lambda found: (abs(found[2]), found[0].op == "symbol"))
    start = q // (p // step)
    u = multiply(*(b ** number(r // step) for b, r, _ in bases))
    rest = (b ** number(s - (r // step) * start) for b, r, s in bases)
    return u, step, start, multiply(*rest)


def folded(e: Expr) -> Expr | None:
    """``e`` with its factorials of numbers as numbers, None where one has no value."""
    if e.op in LEAVES:
        return e
    if e.op == "unknown":
        n = integer(e.args[1]) if e.args[0].args == (FACTORIAL, (0,)) else None
        return None if n is None or not 0 <= n <= 1000 else number(factorial(n))
    args = [folded(arg) for arg in e.args]
    known = [arg for arg in args if arg is not None]
    return rebuild(e, tuple(known)) if len(known) == len(args) else None


def whole_roots(p: fmpq_poly) -> list[int]:
    """The roots of a polynomial that are integers."""
    whole = fmpz_poly([int(c) for c in (p * int(p.denom())).coeffs()])
    factors = whole.factor()[1]
    return [int(-f[0] / f[1]) for f, _ in factors if f.degree() == 1 and int(f[0]) % int(f[1]) == 0]


# Where it converges


def radius_of(s: Series) -> Expr | None:
    """Return the radius of convergence in |u|; None if it is infinite."""
    rate = s.rate
    if rate is None:
        return ZERO
    return None if rate == 0 else root(1 / abs(rate), s.step)


def out_of_range(s: Series, given: Given) -> str:
    """Return why convergence under the conditions is unproved; empty if it is proved."""
    radius = radius_of(s)
    if radius == ZERO:
        return "the series diverges"
    if radius is None or _sign(radius - size_of(s.u), given) == "+":
        return ""
    for side in (1, -1):
        its_sign = _sign(radius - side * s.u, given)
        if its_sign == "+":
            continue
        even = side > 0 or s.step % 2 == 0
        if its_sign == "-" and not symbols(s.u):
            return "the series diverges"
        if its_sign not in ("0", ">=0"):
            return f"the series converges only where abs({s.u}) < {radius}: add this as a condition"
        if not s.converges(bool((s.rate or 0) > 0) == even):
            where = f" where {s.u} is {radius * side}" if symbols(s.u) else ""
            return f"the series diverges{where}"
    return ""


def has_terms(s: Series, at: dict[str, arb]) -> bool:
    """Return whether the common factor of the terms is proved to be nonzero."""
    with ball_precision():
        head = evaluate(s.head, at)
    return bool(head > 0 or head < 0)


def size_of(e: Expr) -> Expr:
    """The absolute value, of the factors."""
    if e.op == "*":
        return multiply(*map(size_of, e.args))
    if e.op == "^" and e.args[1].op == "number" and e.args[1].args[0].q == 1:
        return size_of(e.args[0]) ** e.args[1]
    return apply("abs", e)


def _sign(e: Expr, given: Given) -> str | None:
    if symbols(e):
        return sign(e, given, ">") or sign(e, given, ">=")
    with ball_precision():
        ball = evaluate(e, {})
    return "+" if ball > 0 else "0" if equal_at(e, ZERO, {}) else "-"


def summed(s: Series, at: dict[str, arb]) -> arb | None:
    """Return a ball around the sum, or None if it converges too slowly."""
    u = evaluate(s.u, at) ** s.step
    term = evaluate(s.first, at)
    rate = s.rate
    if rate is None or not abs(u * rate) < 0.95:
        return None
    total = arb(0)
    for k in range(TERMS):
        total += term
        ratio = s.above(fmpq(k)) / s.below(fmpq(k))
        term *= u * ratio
        if k % 20 == 19:
            bound = abs(_ratio_beyond(s, k + 1) * u)
            if bound < 0.99:
                rest = (abs(term) / (1 - bound)).upper()
                if rest < abs(total) * arb(2) ** -100 or k > TERMS - 21:
                    return total + arb(0, rest)
    return None


def _ratio_beyond(s: Series, n: int) -> arb:
    """A ball around P(k)/Q(k) for all k from n on."""
    z = arb(0).union(1 / arb(n))
    gap = s.below.degree() - s.above.degree()
    top, below = (
        sum((arb(c) * z**j for j, c in enumerate(reversed(p.coeffs()))), arb(0))
        for p in (s.above, s.below)
    )
    return top / below * z**gap
