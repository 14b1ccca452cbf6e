"""Arithmetic of series in a variable that tends to 0, with the sizes of their remainders."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import cmp_to_key
from typing import Any

from flint import arb, fmpq

from tresym.reals.domain.evaluation import applied, evaluate
from tresym.reals.expansions.scale import (
    CHAIN,
    WHOLE_PERIOD,
    Leading,
    Powers,
    Scale,
    UnresolvedError,
)
from tresym.reals.expansions.truncated_series import (
    Enclosure,
    Series,
    ShortError,
    Size,
    Term,
    plus,
    raised,
    times,
)
from tresym.reals.functions.table import SPECIAL
from tresym.reals.language.expression import (
    ONE,
    ZERO,
    Expr,
    number,
    symbols,
)

ORDERS = (2, 3, 5, 9, 16)
"""Terms kept, until one of them is not 0."""
MAX_TRIES = 2
"""Orders tried beyond the first that has a term that is not 0."""
LARGEST_PRODUCT = 16
MOST = arb(10**6)


class SeriesArithmetic:
    """Series in a variable w: leading terms, sums, products, powers, and sizes of remainders."""

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
        if e.op in SPECIAL:
            return self.special(e, walk(e.args[-1]), w, n)
        return getattr(self, "_" + e.op)(walk(e.args[0]), w, n)

    def special(self, e: Expr, f: Series, w: str, n: int) -> Series:
        """A special function where it is analytic, or a factor of an expansion."""
        raise UnresolvedError(f"{e.op} is not expanded")

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
        inner = e.args[-1]
        about = self.enclosure(inner)
        spread = arb(0, 1) * about.error
        argument = (about.k + spread) * (
            arb(0).union(self.largest(about.powers)) if about.powers else arb(1)
        )
        found = applied(e.op, *(self.scale.ball(x) for x in e.args[:-1]), argument)
        if not found.is_finite():
            raise UnresolvedError("a function is not bounded on the range")
        return found
