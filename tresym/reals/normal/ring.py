"""Compute with fractions of integer polynomials in generators, some with a monic relation.

A generator is a real function of the symbols (a symbol, π, |f|^(1/n), a sign, exp, tan of a half
angle, log|f|, atan, or an opaque value). In a relation ``g**n = r``, ``r`` contains only older
generators. Newer generators come first in the lexicographic order, so that one division by each
relation, newest first, reduces a polynomial to its remainder.
"""

from __future__ import annotations

from collections.abc import Container
from functools import cache
from math import comb
from typing import Any, NamedTuple, TypeAlias

from flint import Ordering, fmpq, fmpz, fmpz_mpoly, fmpz_mpoly_ctx

from tresym.reals.numbers.factoring import TooLargeError, factors_of

Poly: TypeAlias = fmpz_mpoly

MAX_TERMS = 4000
MAX_DEGREE = 400
LARGEST_DEGREE = 10**6
"""The maximal degree of sums: FLINT's cost grows with it, and its gcd is wrong beyond 64 bits."""
CONJUGATE_TERMS = 600
REMEMBERED = 1 << 14
_INVERSE = frozenset(("log", "atan", "opaque", "cos", "sin"))


class UndefinedError(Exception):
    """Raised for an operation that is nowhere defined, such as division by zero."""


class Generator(NamedTuple):
    """Describe what a generator stands for.

    Attributes:
        kind: ``"symbol"``, ``"root"``, ``"exp"``, …
        data: what its kind needs, such as radicand and order of a root.
        position: its index in the exponent vectors.
    """

    kind: str
    data: tuple[Any, ...]
    position: int


class Fraction:
    """A fraction ``num/den`` over a ring, in reduced form, with the usual arithmetic operators."""

    __slots__ = ("den", "num", "ring")

    def __init__(self, ring: Ring, num: Poly, den: Poly) -> None:
        self.ring = ring
        self.num = num
        self.den = den

    @property
    def key(self) -> tuple[str, str]:
        """Return text that is the same for equal fractions."""
        return str(self.num), str(self.den)

    def __neg__(self) -> Fraction:
        return Fraction(self.ring, -self.num, self.den)

    def __add__(self, other: Fraction | fmpq | int) -> Fraction:
        x, y, ring = self, self.ring.fraction(other), self.ring
        if x.den == y.den:
            total = _bounded(x.num + y.num)
            return Fraction(ring, total, x.den) if x.den.is_one() else ring.cancel(total, x.den)
        common = x.den.gcd(y.den)
        left, right = y.den / common, x.den / common
        return ring.make(_bounded(x.num * left + y.num * right), x.den * left)

    def __sub__(self, other: Fraction | fmpq | int) -> Fraction:
        return self + -self.ring.fraction(other)

    def __mul__(self, other: Fraction | fmpq | int) -> Fraction:
        x, y, ring = self, self.ring.fraction(other), self.ring
        if len(x.num) * len(y.num) > 40 * MAX_TERMS:
            raise TooLargeError(f"a normal form of more than {MAX_TERMS} terms")
        top, bottom = (x.num, x.den), (y.num, y.den)
        if x.den.is_one() and y.den.is_one():
            return Fraction(ring, ring.reduce(x.num * y.num), x.den)
        g, h = x.num.gcd(y.den), y.num.gcd(x.den)
        if not g.is_one() and not g.is_zero():
            top, bottom = (x.num / g, x.den), (y.num, y.den / g)
        if not h.is_one() and not h.is_zero():
            top, bottom = (top[0], x.den / h), (y.num / h, bottom[1])
        return ring.make(top[0] * bottom[0], top[1] * bottom[1])

    def __truediv__(self, other: Fraction | fmpq | int) -> Fraction:
        return self * self.ring.fraction(other).inverse()

    def __radd__(self, other: fmpq | int) -> Fraction:
        return self + other

    def __rsub__(self, other: fmpq | int) -> Fraction:
        return -self + other

    def __rmul__(self, other: fmpq | int) -> Fraction:
        return self * other

    def __rtruediv__(self, other: fmpq | int) -> Fraction:
        return self.inverse() * other

    def inverse(self) -> Fraction:
        """Return ``1/x``.

        Raises:
            UndefinedError: ``x`` is zero.
        """
        if self.num.is_zero():
            raise UndefinedError("a division by an expression that is identically zero")
        return self.ring.make(self.den, self.num)

    def __pow__(self, n: int) -> Fraction:
        x, ring = self, self.ring
        if n < 0:
            return self.inverse() ** -n
        degree = max(x.num.total_degree(), x.den.total_degree(), 0)
        if degree * n > MAX_DEGREE and len(x.num) + len(x.den) > 2:
            raise TooLargeError(f"a power of degree over {MAX_DEGREE}")
        if max(comb(n + len(p) - 1, n) for p in (x.num, x.den) if len(p)) > 10 * MAX_TERMS:
            raise TooLargeError(f"a power of more than {10 * MAX_TERMS} terms")
        if not ring.relations:
            return Fraction(ring, x.num**n, x.den**n)
        result = ring.one
        while n:
            if n & 1:
                result = result * x
            n >>= 1
            x = x * x if n else x
        return result


class Ring:
    """The polynomial ring with its generators and relations, and the arithmetic of fractions."""

    def __init__(self, size: int) -> None:
        """Create a ring for at most ``size`` generators; one more raises :class:`TooLargeError`."""
        self.size = size
        self.context, self.variables = _polynomials(size)
        self.generators: list[Generator] = []
        self.relations: list[tuple[int, int, Poly]] = []
        self._by_key: dict[tuple[Any, ...], Generator] = {}
        self.one_poly = self.context.constant(1)
        self.zero_poly = self.context.constant(0)
        self.zero = self.fraction(self.zero_poly)
        self.one = self.fraction(self.one_poly)

    # Generators

    def generator(self, kind: str, key: Any, data: tuple[Any, ...] = ()) -> Generator:
        """Return the generator of ``kind`` with ``key``, creating it on first use.

        Args:
            kind: the kind of function.
            key: what identifies the generator among those of its kind.
            data: what its kind needs; used only when it is created.

        Raises:
            TooLargeError: the ring already has ``size`` generators.
        """
        found = self._by_key.get((kind, key))
        if found is None:
            if len(self.generators) == self.size:
                raise TooLargeError(f"a normal form with more than {self.size} generators")
            found = Generator(kind, data, self.size - 1 - len(self.generators))
            self.generators.append(found)
            self._by_key[kind, key] = found
        return found

    def known(self, kind: str, key: Any) -> bool:
        """Return whether that generator exists already."""
        return (kind, key) in self._by_key

    def at(self, position: int) -> Generator:
        """Return the generator at a position of the exponent vector."""
        return self.generators[self.size - 1 - position]

    def variable(self, generator: Generator) -> Poly:
        """Return the generator as a polynomial."""
        return self.variables[generator.position]

    def relate(self, generator: Generator, degree: int, value: Poly) -> None:
        """Record the relation ``generator**degree = value``, with ``value`` in older generators."""
        rule = self.variable(generator) ** degree - value
        kept = [item for item in self.relations if item[0] != generator.position]
        self.relations = sorted([*kept, (generator.position, degree, rule)], key=lambda r: r[0])

    def used(self, x: Poly | Fraction) -> list[int]:
        """Return the positions of the generators that occur in ``x``."""
        if isinstance(x, Fraction):
            return sorted({*self.used(x.num), *self.used(x.den)})
        if x.is_constant():
            return []
        return [i for i, degree in enumerate(x.degrees()) if degree > 0]

    def inside(self, position: int) -> list[Poly]:
        """Return the polynomials that a generator is a function of."""
        return [p for item in self.at(position).data for p in polys(item)]

    # Arithmetic

    def fraction(self, x: Fraction | Generator | Poly | fmpq | int) -> Fraction:
        """Return a generator, a polynomial or a rational number as a fraction."""
        if isinstance(x, Fraction):
            return x
        if isinstance(x, Generator):
            x = self.variable(x)
        if isinstance(x, fmpz_mpoly):
            return Fraction(self, x, self.one_poly)
        value = fmpq(x)
        return Fraction(self, self.context.constant(value.p), self.context.constant(value.q))

    def reduce(self, p: Poly) -> Poly:
        """Return ``p`` modulo the relations.

        Raises:
            TooLargeError: the result has more than ``MAX_TERMS`` terms.
        """
        if self.relations:
            degrees = p.degrees()
            for position, degree, rule in self.relations:
                if degrees[position] >= degree:
                    p = p % rule
                    degrees = p.degrees()
        if len(p) > MAX_TERMS:
            raise TooLargeError(f"a normal form of more than {MAX_TERMS} terms")
        return p

    def make(self, num: Poly, den: Poly) -> Fraction:
        """Return the fraction ``num/den`` in reduced form.

        Raises:
            UndefinedError: ``den`` is zero modulo the relations.
        """
        if self.relations:
            num, den = self.reduce(num), self.reduce(den)
            if not den.is_constant():
                num, den = self._rational_denominator(num, den)
        if den.is_zero():
            raise UndefinedError("a denominator is identically zero")
        return self.cancel(num, den)

    def cancel(self, num: Poly, den: Poly) -> Fraction:
        """Return the fraction of reduced polynomials without common factors; ``den`` is not 0."""
        if den.is_one():
            return Fraction(self, num, den)
        if num.is_zero():
            return self.zero
        common = num.gcd(den)
        if not common.is_one():
            num, den = num / common, den / common
        if den.leading_coefficient() < 0:
            num, den = -num, -den
        return Fraction(self, num, den)

    def _rational_denominator(self, num: Poly, den: Poly) -> tuple[Poly, Poly]:
        """Clear roots and signs from the denominator by multiplying with the conjugate."""
        degrees = den.degrees()
        for position, degree, _ in self.relations:
            if den.is_zero():
                break
            if degrees[position] <= 0:
                continue
            x = self.variables[position]
            parts = self.split(den, position)
            if len(parts) == 1:
                (k,) = parts
                lift = x ** (degree - k)
                num, den = self.reduce(num * lift), self.reduce(den * lift)
                degrees = den.degrees()
                continue
            if degree != 2 or len(den) * len(num) > CONJUGATE_TERMS or self.is_inverse(den):
                continue
            conjugate = parts[0] - parts[1] * x
            norm = self.reduce(den * conjugate)
            if norm.is_zero():
                num, den = self.zero_divisor(num, den, position, parts)
                degrees = den.degrees()
                continue
            if self.is_mixed(norm):
                continue
            common = norm.gcd(conjugate)
            norm, conjugate = norm / common, conjugate / common
            num, den = self.reduce(num * conjugate), norm
            degrees = den.degrees()
        return num, den

    def zero_divisor(
        self, num: Poly, den: Poly, position: int, parts: dict[int, Poly]
    ) -> tuple[Poly, Poly]:
        """Return the fraction if ``den`` is a zero divisor; subclasses may use more knowledge."""
        return num, den

    def is_mixed(self, p: Poly) -> bool:
        """Return whether ``p`` may vanish on a whole region; subclasses may decide more cases."""
        return self.is_inverse(p)

    def is_inverse(self, p: Poly) -> bool:
        """Return whether ``p`` contains a logarithm, arc tangent or opaque generator."""
        return any(self.at(i).kind in _INVERSE for i in self.used(p))

    def split(self, p: Poly, position: int) -> dict[int, Poly]:
        """Return the coefficients of ``p`` by powers of one generator: ``{k: coefficient of
        g**k}``.
        """
        slope = p.derivative(position)
        if slope.derivative(position).is_zero():
            rest = p - slope * self.variables[position]
            return {k: part for k, part in ((0, rest), (1, slope)) if not part.is_zero()}
        return {powers[position]: part for powers, part in self.grouped(p, {position}).items()}

    def grouped(self, p: Poly, positions: Container[int]) -> dict[tuple[int, ...], Poly]:
        """Return the coefficient of each monomial in the generators at ``positions``."""
        groups: dict[tuple[int, ...], dict[tuple[int, ...], Any]] = {}
        for monomial, value in p.terms():
            outer = tuple(int(k) if i in positions else 0 for i, k in enumerate(monomial))
            inner = tuple(0 if i in positions else int(k) for i, k in enumerate(monomial))
            groups.setdefault(outer, {})[inner] = value
        return {outer: self.context.from_dict(part) for outer, part in groups.items()}

    def rational(self, x: Fraction) -> fmpq | None:
        """Return the rational number that ``x`` is, or None."""
        if not (x.num.is_constant() and x.den.is_constant()):
            return None
        return fmpq(_constant(x.num), _constant(x.den))


def polys(x: Any) -> tuple[Poly, ...]:
    """Return a polynomial, or those of a fraction, as a tuple; empty for anything else."""
    if isinstance(x, Fraction):
        return x.num, x.den
    return (x,) if isinstance(x, fmpz_mpoly) else ()


def _bounded(p: Poly) -> Poly:
    if len(p) > 1 and p.total_degree() > LARGEST_DEGREE:
        raise TooLargeError(f"a sum with powers of degree over {LARGEST_DEGREE}")
    return p


def _constant(p: Poly) -> fmpz:
    return fmpz(0) if p.is_zero() else p.leading_coefficient()


def small_factor(ring: Ring, p: Poly) -> tuple[fmpz, list[tuple[Poly, int]]]:
    """Return FLINT's factorisation of ``p``, computed in a ring of only the variables that occur.

    FLINT's time grows with the number of variables of the ring, whether they are used or not.

    Returns:
        An integer, and pairs of an irreducible factor and its exponent.
    """
    used = ring.used(p)
    small = project(p, used)
    key = len(used), str(small)
    found = _factors.get(key)
    if found is None:
        if len(_factors) >= REMEMBERED:
            _factors.clear()
        found = _factors[key] = factors_of(small)
    unit, factors = found
    back = dict(enumerate(used))
    return unit, [(f.project_to_context(ring.context, back), k) for f, k in factors]


_factors: dict[tuple[int, str], tuple[fmpz, list[tuple[Poly, int]]]] = {}
"""Cached factorisations by number of variables and text: few polynomials are factored often."""


def project(p: Poly, used: list[int]) -> Poly:
    """Return ``p`` in a ring of only the variables at the positions ``used``."""
    context, _ = _polynomials(len(used))
    return p.project_to_context(context, dict(zip(used, range(len(used)), strict=True)))


@cache
def _polynomials(size: int) -> tuple[fmpz_mpoly_ctx, tuple[Poly, ...]]:
    """Return the ring of integer polynomials in ``size`` generators, and the generators."""
    context = fmpz_mpoly_ctx.get([f"g{i}" for i in range(size)], Ordering.lex)
    return context, context.gens()
