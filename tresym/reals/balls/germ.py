"""Germs at 0+: a formula expanded at one end of a path, with a remainder that is a certified ball.

A germ says of a function, for *every* x in (0, x₀],

    f(x) = x^v · exp(p₀ + p₁/x + … + p_s/x^s) · (c₀ + c₁x + … + c_{n−1}x^{n−1} + Δ(x) xⁿ),

where Δ(x) lies in the ball ``rest``. It is an arithmetic like the others: a formula runs in it
unchanged, and the cancellation near 0 that no ball survives is removed by algebra, because the
coefficients stay exact (polynomials in π with rational coefficients) as long as the formula allows.
Remainders come from Taylor's theorem on the range of the argument; what is exponentially small goes
into them with its largest size on (0, x₀].
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partialmethod, reduce
from itertools import zip_longest
from typing import Any, TypeAlias

from flint import arb, arb_series, ctx, fmpq, fmpq_poly, fmpq_series, fmpz

from tresym.reals.balls.gradient import horner, taylor_coefficients
from tresym.reals.numbers.exact import as_rational

Exact = fmpq_poly
Coefficient: TypeAlias = "fmpq_poly | arb"
"""A number: exact, as a polynomial in π, or a ball."""

PI = fmpq_poly([0, 1])
ZERO = fmpq_poly([0])
ONE = fmpq_poly([1])


LARGEST_PRODUCT = 16
"""Powers up to this one are products."""


class UnresolvedError(ArithmeticError):
    """No germ on this range: a sign or a zero is not certain, or the range is too long."""


class RamifiedError(ArithmeticError):
    """A root of an odd power of x: the caller puts x = t^``index`` and begins again."""

    def __init__(self, index: int) -> None:
        super().__init__(f"a root of index {index}")
        self.index = index


class LogarithmError(ArithmeticError):
    """A logarithm of something that tends to 0 or ∞: the caller puts x = exp(−1/t)."""


def as_ball(c: Coefficient) -> arb:
    """The number as a ball at the working precision."""
    if isinstance(c, arb):
        return c
    exact = c.coeffs()
    return arb(exact[0]) if len(exact) == 1 else horner(exact, arb.pi())


def is_zero(c: Coefficient) -> bool:
    """Certainly zero (π is transcendental, so an exact number is 0 only as a polynomial)."""
    return c.is_zero() if isinstance(c, arb) else bool(c == 0)


def _plus(c: Coefficient, d: Coefficient) -> Coefficient:
    if isinstance(c, arb) or isinstance(d, arb):
        return as_ball(c) + as_ball(d)
    return c + d


def _times(c: Coefficient, d: Coefficient) -> Coefficient:
    if isinstance(c, arb) or isinstance(d, arb):
        return as_ball(c) * as_ball(d)
    return c * d


def _over(c: Coefficient, d: Coefficient) -> Coefficient:
    if isinstance(d, Exact) and isinstance(c, Exact):
        quotient, remainder = divmod(c, d)
        if remainder == 0:
            return quotient
    return as_ball(c) / as_ball(d)


def _number(x: Any) -> Coefficient:
    return x if isinstance(x, arb | fmpq_poly) else fmpq_poly([x])


@dataclass(frozen=True, eq=False)
class Germ:
    """A function near 0+; see the module for what the parts mean."""

    field: Germs
    power: int
    exponent: tuple[Coefficient, ...]
    """p₀, p₁, …, p_s, without zeros at the end."""
    terms: tuple[Coefficient, ...]
    rest: arb
    """Exactly 0 for an exact polynomial, which may then be lengthened at will."""

    # -- reading ----------------------------------------------------------------------------

    @property
    def vanishes(self) -> bool:
        """Certainly the zero function."""
        return not self.terms and self.rest.is_zero()

    @property
    def leading(self) -> arb:
        """The ball of c₀, the limit of f / (x^v exp …) (a bound of it when no term is known)."""
        return as_ball(self.terms[0]) if self.terms else self.rest

    def range(self) -> arb:
        """A ball that contains f/(x^v exp …) on all of (0, x₀]."""
        return horner([as_ball(c) for c in self.terms], self.field.whole, self.rest)

    def at(self, x: arb) -> arb:
        """A ball that contains f at a point of (0, x₀]."""
        total = horner([as_ball(c) for c in self.terms], x, self.rest)
        for power, p in enumerate(self.exponent):
            total *= (as_ball(p) / x**power).exp()
        return total * x**self.power

    def growth(self) -> int:
        """Of |x^v exp(…)| as x → 0: 1 if unbounded, 0 if it has a limit that is not 0, −1 if null.

        Raises:
            UnresolvedError: the sign of the exponent is not certain.
        """
        for p in reversed(self.exponent[1:]):
            if as_ball(p) > 0:
                return 1
            if as_ball(p) < 0:
                return -1
            raise UnresolvedError("the sign of an exponent is not certain")
        return (self.power < 0) - (self.power > 0)

    # -- arithmetic -------------------------------------------------------------------------

    def __neg__(self) -> Germ:
        return replace(self, terms=tuple(-c for c in self.terms), rest=-self.rest)

    def __add__(self, other: Any) -> Germ:
        return self.field.add(self, self.field.germ(other))

    __radd__ = __add__

    def __sub__(self, other: Any) -> Germ:
        return self + (-self.field.germ(other))

    def __rsub__(self, other: Any) -> Germ:
        return (-self) + other

    def __mul__(self, other: Any) -> Germ:
        return self.field.multiply(self, self.field.germ(other))

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Germ:
        return self.field.divide(self, self.field.germ(other))

    def __rtruediv__(self, other: Any) -> Germ:
        return self.field.divide(self.field.germ(other), self)

    def __pow__(self, power: Any) -> Germ:
        return self.field.power(self, power)

    def __abs__(self) -> Germ:
        size = self.range()
        if size > 0 or self.vanishes:
            return self
        if size < 0:
            return -self
        raise UnresolvedError("the sign of the argument of abs is not certain")


class Germs:
    """The arithmetic of germs on (0, x₀], under the array API's function names.

    Args:
        upto: x₀, rational.
        order: terms kept.
    """

    def __init__(self, upto: fmpq, order: int = 8) -> None:
        self.upto = arb(upto)
        self.whole = arb(0).union(self.upto)
        self.order = order
        self.pi = self.constant(PI)
        self.x = Germ(self, 1, (), (ONE,), arb(0))

    # -- making -----------------------------------------------------------------------------

    def constant(self, c: Any) -> Germ:
        """The constant ``c``: integer, fraction, polynomial in π, or ball.

        A ball may also stand for any function with values in it, here and in every coefficient:
        germs are enclosures for each x by itself.
        """
        number = _number(c)
        return Germ(self, 0, (), () if is_zero(number) else (number,), arb(0))

    def bounded(self, values: arb) -> Germ:
        """Any function with values in the ball."""
        return Germ(self, 0, (), (), values)

    def germ(self, x: Any) -> Germ:
        """``x`` as a germ: it is one, or a constant."""
        return x if isinstance(x, Germ) else self.constant(x)

    def _made(
        self,
        power: int,
        exponent: tuple[Coefficient, ...],
        terms: list[Coefficient],
        rest: arb,
    ) -> Germ:
        """The germ in normal form: at most ``order`` terms, none of them zero at the front."""
        first = 0
        while first < len(terms) and is_zero(terms[first]):
            first += 1
        kept = terms[first : first + self.order]
        rest = self._polynomial(terms[first + self.order :], rest)
        if rest.is_zero():
            while kept and is_zero(kept[-1]):
                kept.pop()
            if not kept:
                return Germ(self, 0, (), (), rest)
        while exponent and is_zero(exponent[-1]):
            exponent = exponent[:-1]
        return Germ(self, power + first, exponent, tuple(kept), rest)

    # -- sums and products ------------------------------------------------------------------

    def _length(self, f: Germ) -> int:
        return self.order if f.rest.is_zero() else len(f.terms)

    def _cut(self, f: Germ, length: int) -> tuple[list[Coefficient], arb]:
        """``length`` terms of f and the remainder behind them (f is exact, or has as many)."""
        kept = list(f.terms[:length])
        rest = self._polynomial(f.terms[length:], f.rest)
        return kept + [ZERO] * (length - len(kept)), rest

    def _monomial(self, power: int) -> arb:
        """The range of x^power, power ≥ 0, on (0, x₀]."""
        return arb(0).union(self.upto**power) if power else arb(1)

    def values(self, f: Germ) -> arb:
        """A ball that contains f on all of (0, x₀], for f that tends to a finite limit.

        Raises:
            UnresolvedError: f is not bounded, or not certainly.
        """
        if f.vanishes:
            return arb(0)
        if len(f.exponent) > 1:
            if f.growth() > 0:
                raise UnresolvedError("the function is not bounded")
            largest = self._flat([as_ball(p) for p in f.exponent], f.power)
            return f.range() * arb(0).union(largest)
        f = self._plain(f)
        if f.power < 0:
            raise UnresolvedError("the function is not bounded")
        return f.range() * self._monomial(f.power)

    def add(self, f: Germ, g: Germ) -> Germ:
        """f + g."""
        if f.vanishes or g.vanishes:
            return g if f.vanishes else f
        if f.exponent != g.exponent:
            f, g = self._same_exponent(f, g)
        low = min(f.power, g.power)
        ends = [h.power - low + len(h.terms) for h in (f, g) if not h.rest.is_zero()]
        length = min([*ends, self.order + max(f.power, g.power) - low])
        terms: list[Coefficient] = [ZERO] * length
        rest = arb(0)
        for h in (f, g):
            shift = h.power - low
            if shift > length:
                rest += h.range() * self._monomial(shift - length)
                continue
            kept, beyond = self._cut(h, length - shift)
            rest += beyond
            for j, c in enumerate(kept):
                terms[shift + j] = _plus(terms[shift + j], c)
        return self._made(low, f.exponent, terms, rest)

    def multiply(self, f: Germ, g: Germ) -> Germ:
        """f · g."""
        if f.vanishes or g.vanishes:
            return self.constant(0)
        n = min(self._length(f), self._length(g))
        (p, rest_f), (q, rest_g) = self._cut(f, n), self._cut(g, n)
        product: list[Coefficient] = [ZERO] * max(2 * n - 1, 0)
        factors = [(j, d) for j, d in enumerate(q) if not is_zero(d)]
        for i, c in enumerate(p):
            for j, d in () if is_zero(c) else factors:
                product[i + j] = _plus(product[i + j], _times(c, d))
        rest = rest_f * self._polynomial(q) + rest_g * f.range()
        rest += self._polynomial(product[n:])
        return self._made(f.power + g.power, _sum(f.exponent, g.exponent), product[:n], rest)

    def _polynomial(self, terms: Sequence[Coefficient], rest: arb = arb(0)) -> arb:  # noqa: B008
        """The range of the polynomial on (0, x₀], with ``rest`` behind its last term."""
        return horner([as_ball(c) for c in terms], self.whole, rest)

    def _same_exponent(self, f: Germ, g: Germ) -> tuple[Germ, Germ]:
        """f and g over the exponent of the larger one; the smaller becomes a bounded remainder."""
        gap = list(_sum(g.exponent, tuple(-c for c in f.exponent))) or [ZERO]
        while len(gap) > 1 and is_zero(gap[-1]):
            gap.pop()
        if len(gap) == 1:
            factor = as_ball(gap[0]).exp()
            terms = tuple(_times(c, factor) for c in g.terms)
            return f, replace(g, exponent=f.exponent, terms=terms, rest=g.rest * factor)
        if as_ball(gap[-1]) > 0:
            return self._same_exponent(g, f)
        if not as_ball(gap[-1]) < 0:
            raise UnresolvedError("which of two exponentials is larger is not certain")
        # g = exp(p) x^lead [x^(power − lead) exp(gap) …], and the bracket is bounded.
        lead = f.power + max(self._length(f), 1)
        largest = self._flat([as_ball(c) for c in gap], g.power - lead)
        return f, Germ(self, lead, f.exponent, (), g.range() * arb(0).union(largest))

    def _flat(self, gap: list[arb], power: int) -> arb:
        """An upper bound of x^power · exp(g₀ + g₁/x + … + g_s/x^s) on (0, x₀], where g_s < 0."""
        s, x = len(gap) - 1, self.upto
        rate = -gap[s]
        for j in range(1, s):  # g_j/x^j ≤ max(g_j, 0) · x₀^(s−j)/x^s
            rate -= gap[j].max(arb(0)) * x ** (s - j)
        if not rate > 0:
            raise UnresolvedError("the range is too long for an exponential to be small on it")
        rate = rate.lower()
        height = gap[0].exp()
        at_end = x**power * (-rate / x**s).exp()
        peak = (rate * s / (-power)).root(s) if power < 0 else x
        if power >= 0 or peak > x:  # x^power exp(−rate/x^s) increases up to its peak
            return (height * at_end).upper()
        return (height * peak**power * (-rate / peak**s).exp()).max(height * at_end).upper()

    def divide(self, f: Germ, g: Germ) -> Germ:
        """f / g.

        Raises:
            UnresolvedError: the leading coefficient of g may vanish, or g on the range.
        """
        if not g.terms and not g.rest.contains(0):
            part = Germ(self, -g.power, tuple(-p for p in g.exponent), (), 1 / g.rest)
            return self.multiply(f, part)
        c, u = self._relative(g)
        signs = [ONE if j % 2 == 0 else -ONE for j in range(self.order)]
        product = self.multiply(f, self._compose(signs, lambda s: 1 / (1 + s), u))
        terms = [_over(d, c) for d in product.terms]
        exponent = _sum(product.exponent, tuple(-p for p in g.exponent))
        return self._made(product.power - g.power, exponent, terms, product.rest / as_ball(c))

    def _relative(self, f: Germ) -> tuple[Coefficient, Germ]:
        """c and u of f = x^v exp(…) c (1 + u), where u tends to 0."""
        if not f.terms or as_ball(f.terms[0]).contains(0):
            raise UnresolvedError("a leading coefficient is not certainly different from 0")
        c = f.terms[0]
        u = self._made(1, (), [_over(d, c) for d in f.terms[1:]], f.rest / as_ball(c))
        return c, u

    def _scaled(
        self, f: Germ, c: Coefficient, power: int, exponent: tuple[Coefficient, ...]
    ) -> Germ:
        terms = [_times(c, d) for d in f.terms]
        return self._made(f.power + power, _sum(f.exponent, exponent), terms, f.rest * as_ball(c))

    def power(self, f: Germ, power: Any) -> Germ:
        """f^power for a rational power.

        Raises:
            RamifiedError: the power of x would not be an integer.
        """
        q = as_rational(power)
        if q == 1:
            return f
        if q == 0:
            return self.constant(1)
        v = f.power * q
        if not f.terms and q.q == 1 and 0 < q <= LARGEST_PRODUCT:
            return reduce(self.multiply, [f] * int(q))  # nothing is known of it but its size
        if not f.terms and f.rest > 0 and v.q == 1:
            sizes = (f.rest.log() * arb(q)).exp()
            return Germ(self, int(v.p), tuple(p * q for p in f.exponent), (), sizes)
        c, u = self._relative(f)
        if v.q != 1:
            raise RamifiedError(int(v.q))
        if u.vanishes:
            body = self.constant(1)
        elif q.q == 1 and 0 < q <= LARGEST_PRODUCT:
            body = reduce(self.multiply, [1 + u] * int(q))
        else:
            body = self.exp(self.log1p(u) * q)
        return self._scaled(body, _root(c, q), int(v.p), tuple(p * q for p in f.exponent))

    # -- functions --------------------------------------------------------------------------

    def _compose(self, known: list[Coefficient], series: Series, u: Germ) -> Germ:
        """h(u) for a germ u that tends to 0, from the Taylor coefficients of h at 0.

        The remainder is Lagrange's, over the hull of 0 and the range of u.
        """
        hull = self.values(u).union(arb(0))
        last = taylor_coefficients(series, hull, self.order + 1)[self.order]
        if not last.is_finite():
            raise UnresolvedError("the range is too long for a Taylor expansion")
        total = self.bounded(last)
        for c in reversed(known):
            total = self.add(self.multiply(total, u), self.constant(c))
        return total

    def _apply(self, name: str, f: Germ) -> Germ:
        """A function that is analytic at the limit of f."""
        series = _SERIES[name]
        f = self._plain(f)
        if f.vanishes or (f.power >= 0 and not f.exponent):
            base = f.terms[0] if f.power == 0 and f.terms else ZERO
            if f.power == 0 and not f.terms and not f.vanishes:
                return self.bounded(taylor_coefficients(series, f.rest, 1)[0])
            at = as_ball(base)
            known = _taylor(name, base, self.order)
            above = f if is_zero(base) else self._made(1, (), list(f.terms[1:]), f.rest)
            return self._compose(known, lambda s: series(s + at), above)
        if f.growth() < 0:  # exponentially small: h(f) = h(0) + f (h'(0) + h''(ξ)/2 f)
            h0, h1 = _taylor(name, ZERO, 2)
            hull = self.values(f).union(arb(0))
            second = self.bounded(taylor_coefficients(series, hull, 3)[2])
            return self.constant(h0) + f * (self.constant(h1) + second * f)
        raise UnresolvedError(f"{name} of a function without a finite limit")

    def _plain(self, f: Germ) -> Germ:
        """f with a constant exponential factor exp(p₀) multiplied out."""
        if len(f.exponent) != 1:
            return f
        factor = as_ball(f.exponent[0]).exp()
        terms = tuple(_times(c, factor) for c in f.terms)
        return replace(f, exponent=(), terms=terms, rest=f.rest * factor)

    def _large(self, f: Germ) -> int:
        """±1 where f tends to ±∞ with a certain sign on the whole range, else 0.

        Raises:
            UnresolvedError: |f| grows and its sign is not certain.
        """
        if f.vanishes or f.growth() <= 0:
            return 0
        size = f.range()
        if size > 0 or size < 0:
            return 1 if size > 0 else -1
        raise UnresolvedError("the sign of a large argument is not certain")

    def exp(self, f: Germ) -> Germ:
        """Exponential; the part of f that does not tend to 0 goes to the exponent."""
        f = self._plain(f)
        if f.vanishes or f.exponent or f.power > 0:
            return self._apply("exp", f)
        count = 1 - f.power
        if len(f.terms) < count and not f.rest.is_zero():
            raise UnresolvedError("a divergent part of an exponent is not known")
        terms = [*f.terms, *[ZERO] * (count - len(f.terms))]
        grown = self._apply("exp", self._made(1, (), terms[count:], f.rest))
        return replace(grown, exponent=_sum(grown.exponent, tuple(reversed(terms[:count]))))

    def log(self, f: Germ) -> Germ:
        """Natural logarithm.

        Raises:
            LogarithmError: f tends to 0 or ∞ like a power.
            UnresolvedError: f is not certainly positive.
        """
        if f.power:
            raise LogarithmError("log x")
        if not f.terms and not f.exponent and f.rest > 0:
            return self.bounded(f.rest.log())
        c, u = self._relative(f)
        if not as_ball(c) > 0:
            raise UnresolvedError("the argument of a logarithm is not certainly positive")
        start = ZERO if c == ONE else as_ball(c).log()
        divergent = self._made(-len(f.exponent) + 1, (), [*reversed(f.exponent)], arb(0))
        return divergent + self.constant(start) + self.log1p(u)

    def sqrt(self, f: Germ) -> Germ:
        """Square root."""
        return self.power(f, fmpq(1, 2))

    def log1p(self, f: Germ) -> Germ:
        """log(1 + f)."""
        return self.log(1 + f) if self._large(f) else self._apply("log1p", f)

    def expm1(self, f: Germ) -> Germ:
        """exp(f) − 1."""
        return self.exp(f) - 1 if self._large(f) else self._apply("expm1", f)

    def _wave(self, name: str, f: Germ) -> Germ:
        if f.vanishes or f.growth() <= 0:
            return self._apply(name, f)
        return self.bounded(arb(0, 1))

    sin, cos = partialmethod(_wave, "sin"), partialmethod(_wave, "cos")
    tan, asin = partialmethod(_apply, "tan"), partialmethod(_apply, "asin")
    atanh = partialmethod(_apply, "atanh")

    def acos(self, f: Germ) -> Germ:
        """Inverse cosine."""
        return self.pi / 2 - self.asin(f)

    def atan(self, f: Germ) -> Germ:
        """Inverse tangent, also of what tends to ±∞."""
        sign = self._large(f)
        return self.pi * sign / 2 - self.atan(1 / f) if sign else self._apply("atan", f)

    def sinh(self, f: Germ) -> Germ:
        """Hyperbolic sine."""
        return (self.exp(f) - self.exp(-f)) / 2 if self._large(f) else self._apply("sinh", f)

    def cosh(self, f: Germ) -> Germ:
        """Hyperbolic cosine."""
        return (self.exp(f) + self.exp(-f)) / 2 if self._large(f) else self._apply("cosh", f)

    def tanh(self, f: Germ) -> Germ:
        """Hyperbolic tangent."""
        sign = self._large(f)
        if not sign:
            return self._apply("tanh", f)
        small = self.exp(-2 * sign * f)
        return sign * (1 - 2 * small / (1 + small))

    def asinh(self, f: Germ) -> Germ:
        """Inverse hyperbolic sine."""
        sign = self._large(f)
        if not sign:
            return self._apply("asinh", f)
        return sign * self.log(sign * f + self.sqrt(1 + f * f))

    def acosh(self, f: Germ) -> Germ:
        """Inverse hyperbolic cosine."""
        return self.log(f + self.sqrt(f * f - 1))


Series = Callable[[arb_series], arb_series]

_SERIES: dict[str, Series] = {
    "exp": lambda s: s.exp(),
    "expm1": lambda s: s.exp() - 1,
    "log1p": lambda s: (1 + s).log(),
    "sin": lambda s: s.sin(),
    "cos": lambda s: s.cos(),
    "tan": lambda s: s.tan(),
    "asin": lambda s: s.asin(),
    "atan": lambda s: s.atan(),
    "sinh": lambda s: (s.exp() - (-s).exp()) / 2,
    "cosh": lambda s: (s.exp() + (-s).exp()) / 2,
    "tanh": lambda s: 1 - 2 / ((2 * s).exp() + 1),
    "asinh": lambda s: (s + (1 + s * s).sqrt()).log(),
    "atanh": lambda s: ((1 + s) / (1 - s)).log() / 2,
}

_EXACT: dict[str, Callable[[fmpq_series], fmpq_series]] = {
    "expm1": lambda s: s.exp() - 1,
    "log1p": lambda s: (1 + s).log(),
}


def _taylor(name: str, base: Coefficient, length: int) -> list[Coefficient]:
    """Taylor coefficients of the function at ``base``: rational at 0, balls elsewhere."""
    if not is_zero(base):
        return list(taylor_coefficients(_SERIES[name], as_ball(base), length))
    before = ctx.cap
    ctx.cap = length
    try:
        variable = fmpq_series([0, 1], 1, length)
        series = _EXACT.get(name, lambda s: getattr(s, name)())(variable)
        if series.prec < length:
            raise RuntimeError(f"a series of length {series.prec} where {length} terms are needed")
        return [fmpq_poly([series[j]]) for j in range(length)]
    finally:
        ctx.cap = before


def _sum(p: tuple[Coefficient, ...], q: tuple[Coefficient, ...]) -> tuple[Coefficient, ...]:
    """The sum of two exponents, without zeros at the end."""
    total = [_plus(c, d) for c, d in zip_longest(p, q, fillvalue=ZERO)]
    while total and is_zero(total[-1]):
        total.pop()
    return tuple(total)


def _root(c: Coefficient, q: fmpq) -> Coefficient:
    """c^q: exact for integer powers and for roots of perfect powers."""
    if q.q == 1 and isinstance(c, Exact):
        return c ** int(q.p) if q > 0 else _over(ONE, c ** int(-q.p))
    if isinstance(c, Exact) and c.degree() == 0 and c[0] > 0:
        top, bottom = fmpz(c[0].p), fmpz(c[0].q)
        roots = [n.root(int(q.q)) for n in (top, bottom)]
        if [r ** int(q.q) for r in roots] == [top, bottom]:
            return fmpq_poly([fmpq(*roots) ** int(q.p)])
    x = as_ball(c)
    if not x > 0:
        raise UnresolvedError("the argument of a root is not certainly positive")
    return (x.log() * arb(q)).exp()
