"""The Euler–Maclaurin formula: partial sums, tails of series, and Riemann sums.

If f^(2m) has one sign on [n, ∞) and f^(2m−1) tends to 0, then for n → ∞

    Σ_(k=a..n) f(k) = C + F(n) + f(n)/2 + Σ_(j<m) B_2j/(2j)! f^(2j−1)(n) + R,
    |R| ≤ (2 − 2^(1−2m)) |B_2m|/(2m)! |f^(2m−1)(n)|,

where F is the integral of f from a, and C is a constant (DLMF 2.10.1, 24.9; Olver 1974, ch. 8, §1).
The tail from n to ∞ is the same with the integral from n on, f(n)/2, the opposite signs, and no
constant. A sum of c g(k/λ) with λ → ∞ is a Riemann sum: on 0 ≤ s ≤ β, or s ≥ 0,

    Σ g(k/λ) = λ ∫ g + (g(0) + g(β))/2
               + Σ_(j<m) B_2j/(2j)! λ^(1−2j) (g^(2j−1)(β) − g^(2j−1)(0)) + R,
    |R| ≤ (2 − 2^(1−2m)) |B_2m|/(2m)! λ^(1−2m) ∫ |g^(2m)|.

The constant C is a symbol with rational bounds, which balls prove. Where a theorem gives its value
(γ for 1/k, log(2π)/2 for log k, ζ(s) for k^−s, the total of a convergent series) it is that value.

Example: ``sum(1/k, k, 1, n) == log(n) + O(1)`` needs that 2/k³ is positive for k ≥ 1.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from math import factorial

from flint import arb, fmpq

from tresym.asymptotics.integrands import separated
from tresym.asymptotics.laplace import gamma
from tresym.asymptotics.lemma import Bound, End, Expansion, Obligations, exact_upper, folded
from tresym.asymptotics.stirling import bernoulli
from tresym.reals.decisions.identity import decide
from tresym.reals.decisions.integrals import without_integrals
from tresym.reals.decisions.known_values import known_value
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.expansions.limit_values import limit_of
from tresym.reals.language.binders import integral, total
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    MINUS_ONE,
    ONE,
    PI,
    ZERO,
    Expr,
    add,
    apply,
    fresh,
    integer,
    number,
    opened,
    power,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.parsing import parse
from tresym.reals.normal.to_expression import in_lowest_terms, normal_form
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.signs.definedness import continuous_on
from tresym.reals.signs.sign import proof, sign
from tresym.reals.verdict import Verdict

LEMMA = "the Euler–Maclaurin formula (DLMF 2.10(i))"
LONG = 60
"""From this size on derivatives are simplified."""
STARTS = (0, 1, 3, 9, 30)
"""How far beyond the first term the sign of the derivative is looked for."""
MOST = 5
"""By how many pairs of derivatives the formula begins later, until one tends to 0."""
HALF = fmpq(1, 2)
SHIFTS = tuple(fmpq(n, 2) for n in (0, -1, 1, -2, 2, -3, 3))
FAR, TERMS = 60, 4
"""Where the constant is computed, and with how many derivatives."""
SCALES = tuple(fmpq(*r) for r in ((1, 1), (1, 2), (2, 1), (1, 3)))
POWERS = tuple(fmpq(*r) for r in ((8, 1), (6, 1), (5, 1), (4, 1), (3, 1), (2, 1), (3, 2), (5, 4)))
_INFINITE = (INFINITY, -INFINITY)


def weight(m: int) -> fmpq:
    """Return (2 − 2^(1−2m)) |B_2m|/(2m)!, the factor of the remainder."""
    return (2 - fmpq(2, 4**m)) * abs(bernoulli(2 * m)) / factorial(2 * m)


@lru_cache(maxsize=256)
def derivative(f: Expr, name: str, times: int) -> Expr:
    """Return a derivative of any order, simplified where it gets long."""
    if not times:
        return f
    slope = differentiate(derivative(f, name, times - 1), name)
    if slope.size < LONG:
        return slope
    form = in_lowest_terms(slope)
    return form if form.size < slope.size else slope


class Summand:
    """The derivatives of a summand, and where they have one sign."""

    def __init__(self, f: Expr, k: str, low: int, given: Given) -> None:
        self.f, self.k, self.low, self.given = f, k, low, given
        self.first = next((m for m in range(1, MOST) if self._vanishes(m)), None)

    def _vanishes(self, m: int) -> bool:
        try:
            slope = derivative(self.f, self.k, 2 * m - 1)
        except InputError:
            return False
        return limit_of(slope, self.k, None, 1, self.given) == ZERO

    def weight(self, order: int) -> fmpq:
        """Return the factor of |f^(2m−1)| in the bound of the remainder."""
        assert self.first is not None
        return weight(self.first + order - 1)

    def corrections(self, order: int, at: Expr) -> list[Expr]:
        """Return the terms with derivatives at a point."""
        assert self.first is not None
        return [
            number(bernoulli(2 * j) / factorial(2 * j))
            * substitute(derivative(self.f, self.k, 2 * j - 1), {self.k: at})
            for j in range(1, self.first + order - 1)
        ]

    def error(self, order: int, at: Expr) -> Expr:
        """Return |f^(2m−1)| at a point."""
        assert self.first is not None
        slope = derivative(self.f, self.k, 2 * (self.first + order - 1) - 1)
        return substitute(slope, {self.k: at})

    def constant_from(self, main: Expr, factor: fmpq, alternating: int) -> tuple[fmpq, fmpq] | None:
        """Return rational bounds of the sum up to a large index less the explicit terms there.

        The summand has no parameters.

        Args:
            main: the explicit terms at the index :data:`FAR`, with :data:`TERMS` derivatives.
            factor: the factor of |f^(2m−1)| in the bound of the remainder.
            alternating: 1, or −1 for the sum of (−1)^k f(k).
        """
        assert self.first is not None
        e = derivative(self.f, self.k, 2 * (self.first + TERMS - 1))
        beyond = Given(((symbol(self.k), ">=", number(FAR)),))
        if sign(e, beyond, ">=") not in ("+", ">=0") and sign(e, beyond, "<=") not in ("-", "<=0"):
            return None
        with ball_precision(128):
            total = arb(0)
            for k in range(self.low, FAR + 1):
                total += alternating**k * evaluate(self.f, {self.k: fmpq(k)})
            value = total - evaluate(main, {})
            radius = arb(factor) * abs(evaluate(self.error(TERMS, number(FAR)), {}))
            if not value.is_finite() or not radius.is_finite():
                return None
            spread = radius.upper() + arb((1, -40))
            low, high = (value - spread).lower(), (value + spread).upper()
            return -exact_upper(-low), exact_upper(high)

    def from_where(self, order: int, ask: Obligations) -> int | None:
        """Prove that f^(2m) has one sign from some integer on; return it."""
        assert self.first is not None
        m = self.first + order - 1
        e, k = derivative(self.f, self.k, 2 * m), symbol(self.k)
        defined = self.given & Given(((k, ">=", number(self.low)),))
        if not ask.continuous(self.f, defined):
            return None
        if e == ZERO or decide(e, ZERO, defined).verdict is Verdict.PROVED:
            return self.low
        for relation in (">=", "<="):
            if not ask.holds(e, relation, ZERO, self.given, End(self.k, None, 1, self.given).path):
                continue
            for more in STARTS:
                given = self.given & Given(((k, ">=", number(self.low + more)),))
                if ask.holds(e, relation, ZERO, given):
                    return self.low + more
        return None


class PartialSum(Expansion):
    """Σ f(k) from an integer to h(x), which tends to ∞."""

    lemma = LEMMA

    def __init__(self, terms: Summand, top: Expr, primitive: Expr, end: End, name: str) -> None:
        """Expand a sum.

        Args:
            terms: the summand.
            top: the last index.
            primitive: the integral of the summand from the first index, in the index.
            name: a symbol for the constant.
        """
        self.summand, self.top, self.primitive, self.end = terms, top, primitive, end
        self.constant: Expr = self._named() or symbol(name)
        self.unknown = frozenset((name,)) & symbols(self.constant)
        if self.constant == symbol(name):
            try:
                found = self._enclosed()
            except InputError:
                found = None
            if found is not None:
                low, high = found
                self.constants = Given(
                    ((symbol(name), ">", number(low)), (symbol(name), "<", number(high)))
                )

    def _main(self, order: int, at: Expr) -> Expr:
        s = self.summand
        half = substitute(s.f, {s.k: at}) / 2
        return add(substitute(self.primitive, {s.k: at}), half, *s.corrections(order, at))

    def _error(self, order: int) -> Expr:
        return folded(self.summand.error(order, self.top))

    def _named(self) -> Expr | None:
        """Return the constant where a theorem gives it."""
        s = self.summand
        given = s.given & Given(((symbol(s.k), ">=", ONE),))
        last = limit_of(self.primitive, s.k, None, 1, s.given)
        if last is not None and last not in _INFINITE:
            total = known_value("sum", s.f, s.k, number(s.low), INFINITY, s.given)
            return None if total is None else total.value - last
        if s.first is not None and self._error(1) == ZERO:  # of a polynomial: it is exact
            return substitute(s.f, {s.k: number(s.low)}) - self._main(1, number(s.low))
        if symbols(s.f) != {s.k}:
            return None
        if (found := self._of_a_power(given)) is not None:
            return found
        for kind in ("log", "reciprocal"):
            for shift in SHIFTS:
                found = self._shifted(kind, shift, given)
                if found is not None:
                    return found
        return None

    def _of_a_power(self, given: Given) -> Expr | None:
        """Return the constant of c/k^s for s ≠ 1, c ζ(s) for sums from 1 (DLMF 25.2.10)."""
        s, k = self.summand, symbol(self.summand.k)
        rate = limit_of(k * derivative(s.f, s.k, 1) / s.f, s.k, None, 1, s.given)
        if rate is None or rate.op != "number" or rate == MINUS_ONE or not 1 <= s.low < FAR:
            return None
        c = normal_form(s.f / power(k, rate), given)
        if symbols(c) or decide(s.f, c * power(k, rate), given).verdict is not Verdict.PROVED:
            return None
        before = (-power(number(n), rate) for n in range(1, s.low))
        value = add(apply("zeta", -rate), *before)
        rest = normal_form(c * power(k, rate + 1) / (rate + 1) - self.primitive, given)
        return None if symbols(rest) else c * value + rest

    def _shifted(self, kind: str, shift: fmpq, given: Given) -> Expr | None:
        """Return the constant of c log(k + b) or c/(k + b) for 2b whole (DLMF 5.4, 5.11)."""
        s, k = self.summand, symbol(self.summand.k)
        moved = k + number(shift)
        start = s.low + shift
        if not start > 0:
            return None
        if kind == "log":
            pattern, primitive = apply("log", moved), moved * apply("log", moved) - k
        else:
            pattern, primitive = 1 / moved, apply("log", moved)
        with ball_precision():
            points = [{s.k: fmpq(n, 2) + s.low} for n in (5, 9)]
            values = [evaluate(s.f / pattern, point) for point in points]
            if not all(value.is_finite() for value in values) or not values[0].overlaps(values[1]):
                return None
        c = normal_form(s.f / pattern, given)
        if symbols(c) or decide(s.f, c * pattern, given).verdict is not Verdict.PROVED:
            return None
        if kind == "log":
            value = apply("log", 2 * PI) / 2 - number(shift) - apply("log", _gamma(start))
        else:
            value = -_digamma(start)
        rest = normal_form(c * primitive - self.primitive, given)
        return None if symbols(rest) else c * value + rest

    def _enclosed(self) -> tuple[fmpq, fmpq] | None:
        """Return rational bounds of the constant, by the formula at a large index."""
        s = self.summand
        if symbols(s.f) != {s.k} or s.first is None:
            return None
        return s.constant_from(self._main(TERMS, number(FAR)), s.weight(TERMS), 1)

    def terms(self, order: int) -> tuple[Expr, Expr] | None:
        """Return the constant with the explicit terms at the last index, and |f^(2m−1)| there."""
        try:
            error = self.summand.error(order, self.top)
            main = add(self.constant, self._main(order, self.top))
        except InputError:
            return None
        return main, ZERO if error == ZERO else apply("abs", error)

    def prove(self, order: int, ask: Obligations) -> Bound | None:
        """Prove the sign of the derivative, and that the last index grows."""
        factor = self.summand.weight(order)
        return bounded(self.summand, self.top, self.end, order, ask, factor)


def bounded(
    s: Summand, moving: Expr, end: End, order: int, ask: Obligations, factor: fmpq
) -> Bound | None:
    """Prove the sign of the derivative; the bound holds from where on it has this sign."""
    start = s.from_where(order, ask)
    if start is None:
        return None
    if moving != symbol(end.name):
        return Bound()
    return Bound(factor, fmpq(1, max(start, 1)))


class Tail(Expansion):
    """Σ f(k) from h(x), which tends to ∞, to ∞."""

    lemma = LEMMA

    def __init__(self, terms: Summand, low: Expr, rest: Expr, end: End) -> None:
        """Expand a tail.

        Args:
            terms: the summand.
            low: the first index.
            rest: the integral of the summand from the index to ∞.
        """
        self.summand, self.low, self.rest, self.end = terms, low, rest, end

    def terms(self, order: int) -> tuple[Expr, Expr] | None:
        """Return the explicit terms at the first index, and |f^(2m−1)| there."""
        s = self.summand
        put = {s.k: self.low}
        try:
            main = add(
                substitute(self.rest, put),
                substitute(s.f, put) / 2,
                *(-term for term in s.corrections(order, self.low)),
            )
            error = s.error(order, self.low)
        except InputError:
            return None
        return main, ZERO if error == ZERO else apply("abs", error)

    def prove(self, order: int, ask: Obligations) -> Bound | None:
        """Prove the sign of the derivative, and that the first index grows."""
        factor = self.summand.weight(order)
        return bounded(self.summand, self.low, self.end, order, ask, factor)


class Between(Expansion):
    """Σ f(k) from h₁(x) to h₂(x), which both tend to ∞."""

    lemma = LEMMA

    def __init__(self, terms: Summand, low: Expr, top: Expr, primitive: Expr, end: End) -> None:
        """Expand a sum whose ends both move; ``primitive`` is an antiderivative."""
        self.summand, self.low, self.top = terms, low, top
        self.primitive, self.end = primitive, end

    def terms(self, order: int) -> tuple[Expr, Expr] | None:
        """Return the explicit terms at both ends, and |f^(2m−1)| there."""
        s = self.summand
        try:
            parts = []
            for place, side in ((self.top, 1), (self.low, -1)):
                put = {s.k: place}
                parts.append(side * substitute(self.primitive, put) + substitute(s.f, put) / 2)
                parts += [side * term for term in s.corrections(order, place)]
            sizes = [apply("abs", s.error(order, place)) for place in (self.low, self.top)]
        except InputError:
            return None
        return add(ZERO, *parts), add(ZERO, *sizes)

    def prove(self, order: int, ask: Obligations) -> Bound | None:
        """Prove the sign of the derivative; the last index must not be below the first."""
        if not ask.holds(self.top, ">=", self.low, self.end.given, self.end.path):
            return None
        return None if self.summand.from_where(order, ask) is None else Bound()


class Convergent(Expansion):
    """Σ f(k) up to h(x) → ∞ where f = O(k^−p) with p > 1: a constant and a tail O(h^(1−p))."""

    lemma = "comparison of a series with the integral of a power (DLMF 1.9(ii))"

    def __init__(self, f: Expr, k: str, low: int, top: Expr, p: fmpq, end: End, name: str) -> None:
        """Expand a convergent sum without an antiderivative; the constant is a symbol."""
        self.f, self.k, self.low, self.top, self.p, self.end = f, k, low, top, p, end
        self.constant = symbol(name)
        self.unknown = frozenset((name,))

    def terms(self, order: int) -> tuple[Expr, Expr] | None:
        """Return the constant and the size of the tail, at order 1 alone."""
        return (self.constant, power(self.top, number(1 - self.p))) if order == 1 else None

    def prove(self, order: int, ask: Obligations) -> Bound | None:
        """Prove the size of the terms."""
        k = symbol(self.k)
        far = End(self.k, None, 1, self.end.given)
        if not ask.continuous(self.f, self.end.given & Given(((k, ">=", number(self.low)),))):
            return None
        fits = ask.holds(self.f, "O", power(k, number(-self.p)), far.given, far.path)
        return Bound() if fits else None


class Exact(Expansion):
    """A series that is known in closed form near the end of the path."""

    def __init__(self, value: Expr, lemma: str) -> None:
        """Take a value, by a theorem."""
        self.value, self.lemma = value, lemma

    def terms(self, order: int) -> tuple[Expr, Expr] | None:
        """Return the value, without an error."""
        return self.value, ZERO

    def prove(self, order: int, ask: Obligations) -> Bound | None:
        """Quote the theorem."""
        return Bound(fmpq(0))


class Scaled(Expansion):
    """A function of x times a sum that is expanded."""

    def __init__(self, factor: Expr, inner: Expansion) -> None:
        """Take a factor before an expansion."""
        self.factor, self.inner, self.lemma = factor, inner, inner.lemma
        self.unknown, self.constants = inner.unknown, inner.constants

    def terms(self, order: int) -> tuple[Expr, Expr] | None:
        """Return the terms of the sum, times the factor."""
        found = self.inner.terms(order)
        if found is None:
            return None
        return self.factor * found[0], apply("abs", self.factor) * found[1]

    def prove(self, order: int, ask: Obligations) -> Bound | None:
        """Prove the bound of the sum."""
        return self.inner.prove(order, ask)


class RiemannSum(Expansion):
    """Σ c g(k/λ) over 0 ≤ k ≤ βλ or k ≥ 0, where λ tends to ∞; less the terms before the first."""

    lemma = LEMMA

    def __init__(
        self, factor: Expr, g: Expr, s: str, rate: Expr, top: Expr | None, low: int, end: End
    ) -> None:
        """Expand a sum.

        Args:
            factor: c.
            g: a function of the symbol s.
            rate: λ.
            top: β, None for infinity.
            low: the first index.
        """
        self.factor, self.g, self.s, self.rate = factor, g, s, rate
        self.top, self.low, self.end = top, low, end
        x = symbol(s)
        upper = () if top is None else ((x, "<=", top),)
        self.closed = end.given & Given(((x, ">=", ZERO), *upper))
        whole = integral(g, s, ZERO, INFINITY if top is None else top)
        found = without_integrals([whole], end.given, ())
        self.area = None if found is None or found[0][0] in _INFINITE else found[0][0]

    def _ends(self, times: int) -> Expr:
        e = derivative(self.g, self.s, times)
        first = substitute(e, {self.s: ZERO})
        if self.top is None:
            return -first
        return substitute(e, {self.s: self.top}) - first

    def terms(self, order: int) -> tuple[Expr, Expr] | None:
        """Return the explicit terms, and the power of λ of the first omitted one."""
        if self.area is None:
            return None
        at_zero = substitute(self.g, {self.s: ZERO})
        at_top = ZERO if self.top is None else substitute(self.g, {self.s: self.top})
        try:
            parts = [
                number(bernoulli(2 * j) / factorial(2 * j))
                * power(self.rate, number(1 - 2 * j))
                * self._ends(2 * j - 1)
                for j in range(1, order)
            ]
        except InputError:
            return None
        before = [-substitute(self.g, {self.s: number(k) / self.rate}) for k in range(self.low)] + [
            substitute(self.g, {self.s: number(k) / self.rate}) for k in range(self.low, 0)
        ]
        main = add(self.rate * self.area, at_zero / 2, at_top / 2, *parts, *before)
        size = power(self.rate, number(1 - 2 * order))
        return self.factor * main, apply("abs", self.factor) * size

    def _at(self, k: int) -> Expr:
        """Return a term of the sum."""
        return substitute(self.g, {self.s: number(k) / self.rate if k else ZERO})

    def prove(self, order: int, ask: Obligations) -> Bound | None:
        """Prove that g is smooth, and bound the integral of |g^(2m)|."""
        if not ask.continuous(self.g, self.closed):
            return None
        e, s = derivative(self.g, self.s, 2 * order), symbol(self.s)
        if self.top is not None:
            return Bound()  # a continuous function is bounded on a closed interval
        far = End(self.s, None, 1, self.end.given)
        for times in range(2 * order):
            slope = derivative(self.g, self.s, times)
            if far.limit(slope) != ZERO:
                return None
        return Bound() if ask.holds(e, "O", power(s, number(-2)), far.given, far.path) else None


def euler_maclaurin(node: Expr, end: End) -> Expansion | None:
    """Return the expansion of a sum by the Euler–Maclaurin formula, or None for others."""
    if node.op != "sum":
        return None
    try:
        return _expansion(node, end)
    except (InputError, ZeroDivisionError, OverflowError):
        return None


def _expansion(node: Expr, end: End) -> Expansion | None:
    (k,), body = opened(node, end.taken)
    low, high = node.args[1:]
    if body.hidden or low.hidden or high.hidden:
        return None
    start = integer(low)
    near = end.given & Given(tuple(_beside(end)))
    if high == INFINITY and start is not None:
        known = known_value("sum", body, k, low, high, near)
        if known is not None:
            return Exact(known.value, f"the value by {known.source}")
    if end.name in symbols(body):
        split = separated(body, k, end)
        if split is not None and len(split) == 1 and split[0][0] != ONE:
            inner = _expansion(total("sum", split[0][1], k, low, high), end)
            return None if inner is None else Scaled(split[0][0], inner)
        return None if start is None else _riemann(body, k, start, high, end)
    if start is not None and high != INFINITY and end.tends_to_infinity(high):
        terms = Summand(body, k, start, end.given)
        primitive = _primitive(body, k, low, end.given)
        name = fresh("C", {*symbols(node), *end.taken})
        if terms.first is None or primitive is None:
            return _convergent(body, k, start, high, end, name)
        return PartialSum(terms, high, primitive, end, name)
    moving = start is None and high != INFINITY and end.tends_to_infinity(low)
    if moving and end.tends_to_infinity(high):
        terms = Summand(body, k, 1, end.given)
        primitive = _primitive(body, k, ONE, end.given)
        if terms.first is None or primitive is None:
            return None
        return Between(terms, low, high, primitive, end)
    if high == INFINITY and start is None and end.tends_to_infinity(low):
        terms = Summand(body, k, 1, end.given)
        primitive = _primitive(body, k, ONE, end.given)
        if terms.first is None or primitive is None:
            return None
        last = limit_of(primitive, k, None, 1, end.given)
        if last is None or last in _INFINITE or terms.first != 1:
            return None
        return Tail(terms, low, last - primitive, end)
    return None


def _beside(end: End) -> Iterator[tuple[Expr, str, Expr]]:
    """Yield conditions that hold near the end of the path: within 1/2, or beyond 2."""
    x = symbol(end.name)
    if end.point is None:
        yield end.side * x, ">", number(2)
    else:
        yield end.side * (x - end.point), ">", ZERO
        yield end.side * (x - end.point), "<", number(HALF)


def _convergent(body: Expr, k: str, low: int, high: Expr, end: End, name: str) -> Convergent | None:
    far = End(k, None, 1, end.given)
    for p in POWERS:
        if far.limit(body * power(symbol(k), number(p))) not in (None, *_INFINITE):
            return Convergent(body, k, low, high, p, end, name)
    return None


def _primitive(f: Expr, k: str, low: Expr, given: Given) -> Expr | None:
    """Return the integral of f from ``low`` to k, as an expression in k."""
    y = fresh("y", {k, *symbols(f), *given.names})
    above = given & Given(((symbol(y), ">", low),))
    found = without_integrals([integral(f, k, low, symbol(y))], above, ())
    if found is None or found[0][0] in _INFINITE or INFINITY.args[0] in symbols(found[0][0]):
        return None
    return substitute(found[0][0], {y: symbol(k)})


def _riemann(body: Expr, k: str, low: int, high: Expr, end: End) -> Expansion | None:
    """Return the expansion of a sum whose terms are c(x) g(k/λ(x))."""
    if not -3 <= low <= 3:
        return None
    x = symbol(end.name)
    s = fresh("s", {k, *symbols(body), *end.taken})
    base = x if end.point is None else 1 / (x - end.point)
    near = end.given & Given(((end.side * x, ">", ZERO),) if end.point in (None, ZERO) else ())
    for alpha in SCALES:
        rate = power(base, number(alpha))
        if not end.tends_to_infinity(rate):
            continue
        scaled = substitute(body, {k: rate * symbol(s)})
        split = _factored(scaled, s, end, near)
        top = high if high == INFINITY else normal_form(high / rate, near)
        if split is None or end.name in symbols(top):
            continue
        factor, g = split
        beta = None if top == INFINITY else top
        if beta is not None and sign(beta, end.given) != "+":
            continue
        found = RiemannSum(factor, g, s, rate, beta, low, end)
        if found.area is not None and continuous_on(g, found.closed, proof) is None:
            return found
    return None


def _factored(e: Expr, s: str, end: End, near: Given) -> tuple[Expr, Expr] | None:
    """Return c(x) and g(s) with e = c g, or None."""
    positive = near & Given(((symbol(s), ">", ZERO),))
    form = normal_form(e, positive)
    if end.name not in symbols(form):
        return ONE, form
    point = next(near.points({end.name}, 1), None)
    for place in (ZERO, ONE, number(fmpq(1, 2)), number(2)):
        at = substitute(e, {s: place})
        with ball_precision():
            known = point is not None and symbols(at) <= point.keys()
            value = evaluate(at, point) if point is not None and known else arb.nan()
        if not value.is_finite() or value.contains(0):
            continue
        ratio = normal_form(e / at, positive)
        if end.name not in symbols(ratio):
            return normal_form(at, near), ratio
    return None


def _gamma(x: fmpq) -> Expr:
    """Return Γ at a positive multiple of 1/2."""
    value = gamma(x)
    assert value is not None
    return value


def _digamma(x: fmpq) -> Expr:
    """Return ψ at a positive multiple of 1/2 (DLMF 5.4.12, 5.4.13, 5.5.2)."""
    euler = parse("EulerGamma")
    value, at = (-euler, fmpq(1)) if x.q == 1 else (-euler - 2 * apply("log", number(2)), HALF)
    while at < x:
        value, at = value + number(1 / at), at + 1
    return value
