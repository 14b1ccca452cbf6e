"""Compute in a tower of generators: fractions of integer polynomials, reduced by monic relations.

For example, √(x + 1) is a generator g over the symbol x with the relation g² = x + 1, so that
1/(g + 1) becomes (g − 1)/x. A generator is a real function of the symbols (a symbol, π, |f|^(1/n),
a sign, exp, tan of a half angle, log|f|, atan, or an opaque value). In a relation ``g**n = r``,
``r`` contains only older generators. Newer generators come first in the lexicographic order, so
that one division by each relation, newest first, reduces a polynomial to its remainder (this is
the normal form with respect to a Gröbner basis whose leading terms are coprime; Cox, Little,
O'Shea, *Ideals, Varieties, and Algorithms*, §2.6 and §2.9).

The ring also knows what each generator depends on, its value in balls, and whether generators may
depend on each other, so that a polynomial in them could vanish on a whole region.
"""

from __future__ import annotations

from collections.abc import Callable, Container, Mapping
from functools import cache
from math import comb
from typing import Any, NamedTuple, TypeAlias

from flint import Ordering, arb, fmpq, fmpz, fmpz_mpoly, fmpz_mpoly_ctx

from tresym.reals.functions.table import SPECIAL, TABLE
from tresym.reals.numbers.arithmetic import decided, side
from tresym.reals.numbers.factoring import TooLargeError, factors_of

Poly: TypeAlias = fmpz_mpoly

MAX_TERMS = 4000
MAX_DEGREE = 400
LARGEST_DEGREE = 10**6
"""The maximal degree of sums: FLINT's cost grows with it, and its gcd is wrong beyond 64 bits."""
CONJUGATE_TERMS = 600
REMEMBERED = 1 << 14
SIGN_BITS = 256
_INVERSE = frozenset(("log", "atan", "opaque", "cos", "sin"))


class UndefinedError(Exception):
    """Raised for an operation that is nowhere defined, such as division by zero."""


class AgainError(TooLargeError):
    """Raised when a unit, an order or a sign was learnt, so that the normal form starts again."""


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
    """The polynomial ring with its generators and relations, and the arithmetic of fractions.

    Attributes:
        require: called with a polynomial and ±1 when the denominator d·(1 ± σ) is met, σ being the
            sign of the polynomial; without it, such a fraction stays as it is.
        factored: canonical factorisations, see :mod:`.factors`; they depend on the relations.
        full: whether a generator was asked for that had no place; a larger ring may show more.
    """

    def __init__(self, size: int) -> None:
        """Create a ring for at most ``size`` generators; one more raises :class:`TooLargeError`."""
        self.size = size
        self.context, self.variables = _polynomials(size)
        self.generators: list[Generator] = []
        self.relations: list[tuple[int, int, Poly]] = []
        self.full = False
        self.require: Callable[[Poly, int], None] | None = None
        self.factored: dict[str, tuple[fmpz, list[tuple[Poly, int]]]] = {}
        self._by_key: dict[tuple[Any, ...], Generator] = {}
        self._supports: dict[int, frozenset[str]] = {}
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
        generator = self._by_key.get((kind, key))
        if generator is None:
            if len(self.generators) == self.size:
                self.full = True
                raise TooLargeError(f"a normal form with more than {self.size} generators")
            generator = Generator(kind, data, self.size - 1 - len(self.generators))
            self.generators.append(generator)
            self._by_key[kind, key] = generator
        return generator

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
        if len(kept) != len(self.relations):
            self.factored.clear()
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
                num, den = self._without_zero_divisor(num, den, position, parts)
                degrees = den.degrees()
                continue
            if self.is_mixed(norm):
                continue
            common = norm.gcd(conjugate)
            norm, conjugate = norm / common, conjugate / common
            num, den = self.reduce(num * conjugate), norm
            degrees = den.degrees()
        return num, den

    def _without_zero_divisor(
        self, num: Poly, den: Poly, position: int, parts: dict[int, Poly]
    ) -> tuple[Poly, Poly]:
        """Replace a denominator d·(1 ± σ), which is nonzero only where it equals 2d, by 2d."""
        generator = self.at(position)
        if generator.kind != "sign" or self.require is None:
            return num, den
        for sign in (1, -1):
            if self.reduce(parts[0] - sign * parts[1]).is_zero():
                self.require(generator.data[0], sign)
                return num, 2 * parts[0]
        return num, den

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

    # What generators depend on, and their values

    def symbol(self, name: str) -> Generator:
        """Return the generator of a variable."""
        return self.generator("symbol", name, (name,))

    def support(self, position: int) -> frozenset[str]:
        """Return the symbols that a generator depends on."""
        names = self._supports.get(position)
        if names is None:
            generator = self.at(position)
            if generator.kind == "symbol":
                names = frozenset(generator.data)
            else:
                names = frozenset().union(*map(self.dependence, self.inside(position)))
            self._supports[position] = names
        return names

    def dependence(self, x: Poly | Fraction) -> frozenset[str]:
        """Return the symbols that ``x`` depends on."""
        return frozenset().union(*(self.support(i) for i in self.used(x)))

    def involved(self, x: Poly | Fraction) -> set[int]:
        """Return the generators of ``x`` and, recursively, those inside them, without constants."""
        outer = {i for i in self.used(x) if self.support(i) or self.at(i).kind == "opaque"}
        return outer.union(*(self.involved(p) for i in outer for p in self.inside(i)))

    def is_constant(self, x: Poly | Fraction) -> bool:
        """Return whether ``x`` depends on no symbol and on no opaque generator."""
        return all(not self.support(i) and self.at(i).kind != "opaque" for i in self.used(x))

    def ball(
        self,
        x: Poly | Fraction,
        point: Mapping[str, arb] | None = None,
        known: dict[int, arb] | None = None,
    ) -> arb:
        """Return a ball that contains the value of ``x`` at ``point``.

        Args:
            x: a polynomial or fraction.
            point: a ball for each symbol.
            known: values of generators at that point; they are used, and new ones are added.

        Returns:
            The ball; NaN if a generator has no value at the point.
        """
        known = {} if known is None else known
        if isinstance(x, Fraction):
            return self.ball(x.num, point, known) / self.ball(x.den, point, known)
        total = arb(0)
        values = {}
        for i in self.used(x):
            if i not in known:
                known[i] = self.generator_ball(self.at(i), point or {}, known)
            values[i] = known[i]
        for monomial, coefficient in x.terms():
            term = arb(coefficient)
            for i, value in values.items():
                if monomial[i]:
                    term = term * value ** int(monomial[i])
            total = total + term
        return total

    def generator_ball(
        self, generator: Generator, point: Mapping[str, arb], known: dict[int, arb]
    ) -> arb:
        """Return a ball for the value of a generator, as :meth:`ball` does for a polynomial."""
        data = generator.data
        match generator.kind:
            case "symbol":
                return point.get(data[0], arb.nan())
            case "pi":
                return arb.pi()
            case "root":
                return abs(self.ball(data[0], point, known)).root(data[1])
            case "sign":
                value = self.ball(data[0], point, known)
                return arb(1) if value > 0 else arb(-1) if value < 0 else arb.nan()
            case "cosine":
                return 2 * arb.cos_pi_fmpq(fmpq(1, data[0]))
            case "exp":
                return (self.ball(data[2], point, known) / data[1]).exp()
            case "tan":
                return (self.ball(data[2], point, known) / (2 * data[1])).tan()
            case "cos" | "sin" as name:
                return getattr(self.ball(data[2], point, known) / data[1], name)()
            case "log":
                return abs(self.ball(data[0], point, known)).log()
            case "atan":
                return self.ball(data[0], point, known).atan()
            case "opaque" if data[0] in SPECIAL:
                return TABLE[data[0]].ball(*(self.ball(arg, point, known) for arg in data[1:]))
            case _:
                return arb.nan()

    # What may vanish on a whole region

    def is_mixed(self, p: Poly) -> bool:
        """Return whether ``p`` may vanish on a whole region though its normal form is not zero.

        This is possible if its generators may depend on each other in a way that is not known:
        several inverse functions, nested roots, values of arbitrary functions, sums with signs, arc
        tangents of tangents, or constants that may be equal.
        """
        kinds = [self.at(i).kind for i in self.used(p)]
        if len(p) == 1 and set(kinds) == {"exp"}:
            return False
        if "cos" in kinds or "sin" in kinds:
            return True
        if "opaque" in kinds or "sign" in kinds:
            return len(p) > 1
        inner = self.involved(p)
        nested = any(
            self.at(j).kind in ("root", "sign", "opaque")
            for i in inner
            if self.at(i).kind == "root"
            for j in self.involved(self.at(i).data[0])
        )
        return nested or self.are_tied(inner) or self._may_be_zero_by_constants(p)

    def are_tied(self, positions: set[int]) -> bool:
        """Return whether inverse functions among these generators may depend on the others.

        A single logarithm or arc tangent can do so only through signs, as an arc tangent of
        tangents, or as a logarithm of roots of exponentials. Otherwise tan(cx + d) or exp(cx + d)
        would be algebraic over functions over which it is not. Logarithms of distinct irreducible
        polynomials in the symbols are independent (Ostrowski).
        """
        kinds = [self.at(i).kind for i in positions]
        inverses = kinds.count("log") + kinds.count("atan")
        if set(kinds) <= {"symbol", "log"} and all(
            self.at(j).kind == "symbol"
            for i in positions
            if self.at(i).kind == "log"
            for j in self.used(self.at(i).data[0])
        ):
            return False
        return inverses > 1 or (
            inverses == 1
            and (
                bool({"sign", "opaque", "cos", "sin"} & set(kinds))
                or {"atan", "tan"} <= set(kinds)
                or {"log", "exp", "root"} <= set(kinds)
            )
        )

    def _may_be_zero_by_constants(self, p: Poly) -> bool:
        """Return whether no coefficient of ``p``, a polynomial in constants, is shown to be
        nonzero.
        """
        constants = [i for i in self.used(p) if not self.support(i) and self.at(i).kind != "opaque"]
        if not constants:
            return False
        parts = self.grouped(p, {*self.used(p)} - {*constants}).values()
        return not any(part.is_constant() or self.constant_sign(part) for part in parts)

    def constant_sign(self, p: Poly) -> int:
        """Return the sign of a constant, or 0 if balls do not separate it from 0."""
        return decided(lambda: side(self.ball(p)), (64, SIGN_BITS, 4 * SIGN_BITS)) or 0

    def by_signs(self, x: Fraction) -> list[tuple[Fraction, Fraction]] | None:
        """Write ``x`` as a sum of products of signs times terms without signs; None if it has no
        sign.
        """
        if any(self.at(i).kind == "sign" for i in self.used(x.den)):
            return None
        signs = [i for i in self.used(x.num) if self.at(i).kind == "sign"]
        if not signs:
            return None
        return [
            (self.fraction(self.context.from_dict({outer: 1})), self.make(part, x.den))
            for outer, part in self.grouped(x.num, signs).items()
        ]

    def sign_content(self, x: Fraction) -> tuple[Fraction, Fraction] | None:
        """Return a product of signs that every term of ``x`` contains, and the rest; else None."""
        parts = self.by_signs(x)
        return parts[0] if parts is not None and len(parts) == 1 else None


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
    factored = _factored.get(key)
    if factored is None:
        if len(_factored) >= REMEMBERED:
            _factored.clear()
        factored = _factored[key] = factors_of(small)
    unit, factors = factored
    back = dict(enumerate(used))
    return unit, [(f.project_to_context(ring.context, back), k) for f, k in factors]


_factored: dict[tuple[int, str], tuple[fmpz, list[tuple[Poly, int]]]] = {}
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
