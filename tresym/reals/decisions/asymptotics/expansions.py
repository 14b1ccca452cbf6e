"""Expansions in the most rapidly varying element of a scale, with certified remainders.

    f = c₀ w^p₀ + c₁ w^p₁ + … + c_{n−1} w^p_{n−1} + R,   p₀ < p₁ < …

The coefficients are expressions, so what cancels is seen by the exact normal form and by nothing
else; R is bounded by a number times a product of powers of elements on all of 0 < t ≤ reach. The
leading term of c₀ is found in turn, and so that of f (D. Gruntz, *On Computing Limits in a Symbolic
Manipulation System*, 1996). Taylor's theorem gives the remainders: on |v| ≤ s < 1 the nth
coefficient of log(1 + v) and of atan v is at most 1/n and 1/(n (1 − s)^n), and so on.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import cmp_to_key, reduce
from math import factorial
from typing import Any, NamedTuple

from flint import arb, fmpq

from tresym.reals.decisions.asymptotics.scale import (
    CHAIN,
    WHOLE_PERIOD,
    Leading,
    Powers,
    Scale,
    UnresolvedError,
)
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.expression import (
    ONE,
    ZERO,
    Expr,
    add,
    apply,
    multiply,
    number,
    power,
    symbols,
)
from tresym.reals.language.like_terms import collected

ORDERS = (2, 3, 5, 9, 16)
"""Terms kept, until one of them is not 0."""
MAX_TRIES = 2
"""Orders tried beyond the first that has a term that is not 0."""
LARGEST_PRODUCT = 16
MOST = arb(10**6)
MAX_SIZE = 4_000

Term = tuple[Expr, Expr]
"""An exponent and a coefficient."""


class ShortError(UnresolvedError):
    """More terms may help."""


class Size(NamedTuple):
    """An upper bound height · Π element^power of the size of a function on 0 < t ≤ reach."""

    height: arb
    powers: Powers


class Series(NamedTuple):
    """The terms by rising exponents, and a remainder of the order of w^end, 0 if that is None."""

    terms: list[Term]
    end: Expr | None = None
    rest: Size | None = None
    """The size of all of the remainder, where a range is asked for."""


class Enclosure(NamedTuple):
    """f = (k + δ) Π element^power with |δ| ≤ error on 0 < t ≤ reach; δ → 0."""

    k: arb
    powers: Powers
    error: arb

    @property
    def low(self) -> arb:
        """A lower bound of |k + δ|."""
        return arb(self.k.abs_lower()) - self.error

    @property
    def high(self) -> arb:
        """An upper bound of |k + δ|."""
        return arb(self.k.abs_upper()) + self.error


def plus(c: Expr, d: Expr) -> Expr:
    """The sum of two coefficients, like terms as one."""
    total = add(c, d)
    if total.size > MAX_SIZE:
        raise UnresolvedError("a coefficient of the expansion exceeds the size limit")
    return collected(total) if total.op == "+" else total


def times(c: Expr, d: Expr) -> Expr:
    """The product of two coefficients that are not 0, powers of one base as one."""
    if c == ONE or d == ONE:
        return d if c == ONE else c
    powers: dict[Expr, fmpq] = {}
    exponent = ZERO
    for part in (part for x in (c, d) for part in (x.args if x.op == "*" else (x,))):
        if part.op == "exp":
            exponent = plus(exponent, part.args[0])
            continue
        base, r = part, fmpq(1)
        if part.op == "^" and part.args[1].op == "number":
            base, r = part.args[0], part.args[1].args[0]
        powers[base] = powers.get(base, fmpq(0)) + r
    factors = [_power(base, r) for base, r in powers.items() if r != 0]
    found = multiply(*factors, *([apply("exp", exponent)] if exponent != ZERO else []))
    if found.size > MAX_SIZE:
        raise UnresolvedError("a coefficient of the expansion exceeds the size limit")
    return found


def quotient(c: Expr, d: Expr) -> Expr:
    """The quotient of two coefficients that are not 0."""
    return times(c, raised(d, fmpq(-1)))


def raised(c: Expr, r: fmpq) -> Expr:
    """The power of a coefficient that is not 0, and positive where r is no integer."""
    if c.op == "exp":
        return apply("exp", number(r) * c.args[0])
    if c.op == "*" and (r.q == 1 or (c.args[0].op == "number" and c.args[0].args[0] > 0)):
        if r.q == 1:
            return reduce(times, (raised(part, r) for part in c.args))
        return times(_power(c.args[0], r), raised(multiply(*c.args[1:]), r))
    if c.op == "^" and c.args[1].op == "number" and (r.q == 1 or c.args[1].args[0].q != 1):
        return _power(c.args[0], r * c.args[1].args[0])
    return _power(c, r)


def _power(base: Expr, r: fmpq) -> Expr:
    """A power, of a number with an exponent between 0 and 1 beside a number."""
    if base.op == "symbol" and r != 1:  # an element, of which no power is multiplied out
        return Expr("^", (base, number(r)))
    if base.op != "number" or base == ONE or r.q == 1:
        return base if base == ONE else power(base, number(r))
    whole = int(r.p // r.q)
    return power(base, number(whole)) * power(base, number(r - whole))


class Expansions:
    """Expansions of functions of the elements of ``scale``, with bounds for 0 < t ≤ ``reach``.

    Without a reach there are no bounds, and what is found holds as t → 0.
    """

    def __init__(self, scale: Scale, reach: fmpq | None = None) -> None:
        """Nothing is expanded yet."""
        self.scale, self.reach = scale, reach
        self._enclosures: dict[Expr, Enclosure] = {}
        self._sizes: dict[Expr, Size] = {}
        self._largest: dict[str, arb] = {}

    # -- leading terms ----------------------------------------------------------------------

    def leading(self, e: Expr) -> Leading | None:
        """The leading term as t → 0; None for the zero function.

        Raises:
            UnresolvedError: it is not found.
        """
        known = self.scale.leading
        if e not in known:
            known[e] = self._leading(e)
        return known[e]

    def _leading(self, e: Expr) -> Leading | None:
        inside = self.scale.elements(e)
        if self.scale.is_zero(e):
            return None
        if not inside:
            if self.scale.parameters(e) and not self.scale.sign(e):
                return None
            return Leading(e, {})
        w = inside[0]
        if e.op == "symbol":
            return Leading(ONE, {w: ONE})
        for n in ORDERS:
            found = self.tried(e, w, n)
            for p, c in found.terms:
                first = self.leading(c)
                if first is not None:
                    powers = self.scale.times(first.powers, {w: p} if p != ZERO else {})
                    return Leading(first.coefficient, powers)
            if found.end is None:
                return None
        raise UnresolvedError("no leading term was found")

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

    # -- arithmetic -------------------------------------------------------------------------

    def series(self, e: Expr, w: str, n: int, known: dict[Expr, Series] | None = None) -> Series:
        """``e`` in powers of ``w``, about ``n`` terms."""
        known = {} if known is None else known

        def walk(node: Expr) -> Series:
            if w not in symbols(node):
                return Series([(ZERO, node)] if node != ZERO else [])
            if node not in known:
                known[node] = self._node(node, w, n, walk)
            return known[node]

        return walk(e)

    def tried(self, e: Expr, w: str, n: int) -> Series:
        """The series, without a term where n are too few on the way."""
        try:
            return self.series(e, w, n)
        except ShortError:
            return Series([], ZERO)

    def _node(self, e: Expr, w: str, n: int, walk: Callable[[Expr], Series]) -> Series:
        if e.op == "symbol":
            return Series([(ONE, ONE)])
        if e.op == "+":
            return self.sum([walk(arg) for arg in e.args], w, n)
        if e.op == "*":
            found = walk(e.args[0])
            for arg in e.args[1:]:
                found = self.product(found, walk(arg), w, n)
            return found
        if e.op == "^":
            if e.args[0].op == "symbol":
                return Series([(e.args[1], ONE)])
            return self.power(walk(e.args[0]), e.args[1].args[0], w, n)
        return getattr(self, "_" + e.op)(walk(e.args[0]), w, n)

    def _cut(
        self, terms: Iterable[Term], ends: list[Expr], sizes: list[Size], w: str, n: int
    ) -> Series:
        """The series of the terms, at most n below all ``ends``, and of remainders of ``sizes``."""
        compare = self.scale.difference
        end = min(ends, key=cmp_to_key(compare)) if ends else None
        kept: list[Term] = []
        dropped: list[Term] = []
        by_exponent: Any = cmp_to_key(lambda x, y: compare(x[0], y[0]))
        for p, c in sorted(terms, key=by_exponent):
            if kept and compare(kept[-1][0], p) == 0:
                total = plus(kept[-1][1], c)
                kept[-1:] = [(p, total)] if total != ZERO else []
            elif len(kept) == n and (end is None or compare(p, end) < 0):
                end = p
                dropped.append((p, c))
            elif end is not None and compare(p, end) >= 0:
                dropped.append((p, c))
            else:
                kept.append((p, c))
        if end is None:
            return Series(kept)
        rest = None
        if self.reach is not None:
            rest = self._total([*sizes, *(self._term(t, w) for t in dropped)])
        return Series(kept, end, rest)

    def sum(self, parts: list[Series], w: str, n: int) -> Series:
        """f + g + …."""
        ends = [f.end for f in parts if f.end is not None]
        sizes = [f.rest for f in parts if f.rest is not None]
        return self._cut([t for f in parts for t in f.terms], ends, sizes, w, n)

    def product(self, f: Series, g: Series, w: str, n: int) -> Series:
        """f g."""
        if not (f.terms or f.end) or not (g.terms or g.end):
            return Series([])
        terms = [(p + q, times(c, d)) for p, c in f.terms for q, d in g.terms]
        ends, sizes = [], []
        if f.end is not None:
            ends.append(f.end + self._low(g))
        if g.end is not None:
            ends.append(g.end + self._low(f))
        if self.reach is not None:
            if f.rest is not None:
                sizes.append(self._times(f.rest, self._whole(g, w)))
            if g.rest is not None and f.terms:
                sizes.append(self._times(g.rest, self._whole(Series(f.terms), w)))
        return self._cut(terms, ends, sizes, w, n)

    @staticmethod
    def _low(f: Series) -> Expr:
        return f.terms[0][0] if f.terms else f.end or ZERO

    def relative(self, f: Series) -> tuple[Expr, Expr, int]:
        """c and p of f = c w^p (1 + …), and the sign of c.

        Raises:
            UnresolvedError: they are not found, or a wave may make c vanish.
        """
        while f.terms and self.leading(f.terms[0][1]) is None:
            f.terms.pop(0)
        if not f.terms:
            raise ShortError("division by an expression that may be zero")
        p, c = f.terms[0]
        first = self.leading(c)
        return c, p, self.scale.sign(first.coefficient if first else ZERO)

    def _beyond(self, f: Series, c: Expr, p: Expr, w: str, n: int) -> Series:
        """v of f = c w^p (1 + v)."""
        inverse = Series([(-p, raised(c, fmpq(-1)))])
        return self.product(Series(f.terms[1:], f.end, f.rest), inverse, w, n)

    def power(self, f: Series, r: fmpq, w: str, n: int) -> Series:
        """f^r."""
        if r.q == 1 and 0 < r <= LARGEST_PRODUCT:
            found = f
            for _ in range(int(r) - 1):
                found = self.product(found, f, w, n)
            return found
        if r.q != 1 and not f.terms and f.end is None and r > 0:
            return f
        c, p, sign = self.relative(f)
        if r.q != 1 and sign < 0:
            raise UnresolvedError("an even root of a negative expression")
        binomials, b = [ONE], fmpq(1)
        for k in range(n):
            b = b * (r - k) / (k + 1)
            binomials.append(number(b))
        largest = abs(arb(b))

        def rest(s: arb, m: int) -> arb:
            if m != n:
                raise UnresolvedError("a different truncation order")
            return largest * ((1 - s) ** (arb(r) - m)).max((1 + s) ** (arb(r) - m))

        v = self._beyond(f, c, p, w, n)
        body = self._compose(binomials[:n], rest, v, w, n)
        front = Series([(number(r) * p, raised(c, r))])
        return self.product(front, body, w, n)

    # -- functions --------------------------------------------------------------------------

    def _compose(
        self, known: list[Expr], rest: Callable[[arb, int], arb], v: Series, w: str, n: int
    ) -> Series:
        """h(v) for v → 0 from its Taylor coefficients at 0 and a bound of the next for |v| ≤ s."""
        if not v.terms and v.end is None:
            return Series([(ZERO, known[0])] if known[0] != ZERO else [])
        low = self._low(v)
        if self.scale.sign(low) <= 0:
            raise UnresolvedError("an argument that does not tend to 0")
        size = None
        if self.reach is not None:
            whole = self._whole(v, w)
            s = whole.height * self.largest(whole.powers)
            if not s < arb("0.9"):
                raise UnresolvedError("the range is too long for a Taylor expansion")
            size = Size(rest(s, n), {})
            for _ in range(n):
                size = self._times(size, whole)
        terms = [Series([(ZERO, known[0])] if known[0] != ZERO else [])]
        grown = Series([(ZERO, ONE)])
        for c in known[1:]:
            grown = self.product(grown, v, w, n)
            if c != ZERO:
                terms.append(self.product(grown, Series([(ZERO, c)]), w, n))
        terms.append(Series([], number(n) * low, size))
        return self.sum(terms, w, n)

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

    # -- bounds for 0 < t ≤ reach -----------------------------------------------------------

    def _times(self, x: Size, y: Size) -> Size:
        return Size(x.height * y.height, self.scale.times(x.powers, y.powers))

    def _total(self, parts: list[Size]) -> Size:
        """A bound of the sum."""
        first = parts[0].powers
        for part in parts[1:]:
            if self.scale.compare(part.powers, first) > 0:
                first = part.powers
        height = arb(0)
        for part in parts:
            height += part.height * self.largest(self.scale.times(part.powers, first, -1))
        return Size(height, first)

    def _term(self, term: Term, w: str) -> Size:
        p, c = term
        return self._times(self.size(c), Size(arb(1), {w: p} if p != ZERO else {}))

    def _whole(self, f: Series, w: str) -> Size:
        """A bound of a series that is not 0."""
        parts = [self._term(term, w) for term in f.terms]
        return self._total(parts if f.rest is None else [*parts, f.rest])

    def largest(self, p: Powers) -> arb:
        """An upper bound of a product that does not tend to ∞.

        Raises:
            UnresolvedError: it does, or the range is too long.
        """
        if not p:
            return arb(1)
        names = [w for w in self.scale.order if w in p]
        x = self.scale.ball(p[names[0]])
        if not x > 0:
            raise UnresolvedError("a bound that tends to infinity")
        if len(names) == 1:
            return self._element(names[0]) ** x
        if all(w in CHAIN for w in names):
            return self._along_chain(names, [self.scale.ball(p[w]) for w in names])
        top = self._height(names[0])
        found, rate = arb(1), x
        for w in names[1:]:
            y = self.scale.ball(p[w])
            if y > 0:
                found *= self.largest({w: p[w]})
                continue
            other = self._height(w)
            ratio = self.largest(self.scale.times(other.powers, top.powers, -1))
            rate -= abs(y) * other.high / top.low * ratio
        if not rate > 0:
            raise UnresolvedError("the range is too long: the exponential is not small on it")
        return found * self._element(names[0]) ** rate

    def _height(self, w: str) -> Enclosure:
        if w not in self.scale.heights:
            raise UnresolvedError("logarithms are nested too deeply")
        return self.enclosure(self.scale.heights[w])

    def _along_chain(self, names: list[str], exponents: list[arb]) -> arb:
        """Of t, log t, … alone: the product increases with t where its derivative is positive."""
        x, *others = exponents
        heights = [self._element(w) for w in names]
        slope, start = x, CHAIN.index(names[0])
        for w, y in zip(names[1:], others, strict=True):
            if y < 0:  # d log(1/w) is the product of the elements between, times d log(1/first)
                between = arb(1)
                for v in CHAIN[start + 1 : CHAIN.index(w) + 1]:
                    between *= self._element(v)
                slope += y * between
        if not slope > 0:
            raise UnresolvedError(
                "the range is too long: the power does not dominate the logarithms on it"
            )
        found = arb(1)
        for value, y in zip(heights, exponents, strict=True):
            found *= value**y
        return arb(found.abs_upper())

    def _element(self, w: str) -> arb:
        """The largest value of an element, of those of the chain the one at the end of the range.

        Raises:
            UnresolvedError: it is not less than 1.
        """
        if w not in self._largest:
            if w == CHAIN[0]:
                found = arb(self.reach)
            elif w in CHAIN:
                found = -1 / self._element(CHAIN[CHAIN.index(w) - 1]).log()
            else:
                height = self._height(w)
                least = height.low / self.largest(self.scale.times({}, height.powers, -1))
                found = arb((-least.min(MOST)).exp().upper())  # a bound, and no tower
            if not 0 < found < 1:
                raise UnresolvedError("the range is too long")
            self._largest[w] = found
        return self._largest[w]

    def enclosure(self, e: Expr) -> Enclosure:
        """The leading term with its error on the range, less than half of what is not a wave."""
        if e not in self._enclosures:
            self._enclosures[e] = self._enclosed(e)
        return self._enclosures[e]

    def _enclosed(self, e: Expr) -> Enclosure:
        lead = self.leading(e)
        if lead is None:
            raise UnresolvedError("the zero function")
        if not self.scale.elements(e):
            return Enclosure(self.scale.ball(e), {}, arb(0))
        for w in reversed(self.scale.elements(e)):
            self._element(w)  # is between 0 and 1 on all of the range
        tries = MAX_TRIES
        for n in ORDERS:
            found = self.tried(e, w, n)
            while found.terms and self.leading(found.terms[0][1]) is None:
                found.terms.pop(0)
            if not found.terms:
                continue
            (p, c), *others = found.terms
            first = self.enclosure(c)
            front = self.scale.times(first.powers, {w: p} if p != ZERO else {})
            error = first.error
            parts = [self._term(term, w) for term in others]
            for part in parts if found.rest is None else [*parts, found.rest]:
                error += part.height * self.largest(self.scale.times(part.powers, front, -1))
            if first.k.contains(0) or error < abs(first.k) / 2:
                return Enclosure(first.k, front, error)
            tries -= 1
            if not tries:
                break
        raise UnresolvedError("the range is too long")

    def size(self, e: Expr) -> Size:
        """An upper bound of |e|."""
        if e not in self._sizes:
            self._sizes[e] = self._size(e)
        return self._sizes[e]

    def _size(self, e: Expr) -> Size:
        inside = self.scale.elements(e)
        if not inside:
            found = self.scale.ball(e)
            if not found.is_finite():
                raise UnresolvedError("a coefficient has no finite value")
            return Size(arb(found.abs_upper()), {})
        for w in inside:
            self._element(w)  # is between 0 and 1 on all of the range
        if e.op == "symbol":
            return Size(arb(1), {inside[0]: ONE})
        if e.op == "+":
            return self._total([self.size(arg) for arg in e.args])
        if e.op == "*":
            found = self.size(e.args[0])
            for arg in e.args[1:]:
                found = self._times(found, self.size(arg))
            return found
        if e.op == "^" and e.args[0].op == "symbol":
            return Size(arb(1), {inside[0]: e.args[1]})
        if e.op == "^":
            r = e.args[1].args[0]
            if r.q == 1 and r > 0:
                base = self.size(e.args[0])
                return Size(base.height ** int(r), self._raised(base.powers, r))
            about = self.enclosure(e.args[0])
            if not about.low > 0:
                raise UnresolvedError("a power of an expression that may be 0")
            height = (about.low ** arb(r)).max(about.high ** arb(r))
            return Size(height, self._raised(about.powers, r))
        if e.op in ("sin", "cos"):
            return Size(arb(1), {})
        if e.op == "abs":
            return self.size(e.args[0])
        return Size(arb(self._bounded(e).abs_upper()), {})

    @staticmethod
    def _raised(p: Powers, r: fmpq) -> Powers:
        return {w: number(r) * x for w, x in p.items()}

    def _bounded(self, e: Expr) -> arb:
        """The values of exp, log or atan of what has a finite limit."""
        at = {w: arb(0).union(self._element(w)) for w in self.scale.elements(e)}
        at |= dict.fromkeys(self.scale.phases(e), arb(0, WHOLE_PERIOD))
        found = evaluate(e, at)
        if found.is_finite():
            return found
        (inner,) = e.args
        about = self.enclosure(inner)
        spread = arb(0, 1) * about.error
        argument = (about.k + spread) * (
            arb(0).union(self.largest(about.powers)) if about.powers else arb(1)
        )
        found = getattr(argument, e.op)()
        if not found.is_finite():
            raise UnresolvedError("a function is not bounded on the range")
        return found
