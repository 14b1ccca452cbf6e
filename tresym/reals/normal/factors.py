"""Factor polynomials in the generators canonically, and find the signs of the factors.

A factorisation that :mod:`.denesting` proposes is verified by multiplying it out. A sign that is
not known is a generator σ with σ² = 1.
"""

from __future__ import annotations

from typing import Any

from flint import fmpq, fmpz

from tresym.reals.normal.denesting import canonical
from tresym.reals.normal.monotone import same_sign
from tresym.reals.normal.ranges import MAX_DEPTH
from tresym.reals.normal.ring import Fraction, Poly, UndefinedError, small_factor
from tresym.reals.normal.sign_equations import SignedRing
from tresym.reals.numbers.factoring import TooLargeError, primes_of

MAX_FACTOR_TERMS = 1000

Factors = dict[str, tuple[Poly, fmpq]]


class FactoredRing(SignedRing):
    """A ring with signs whose elements are represented by their factors."""

    def __init__(self, *arguments: Any) -> None:
        """Take the arguments of the base class."""
        super().__init__(*arguments)
        self._factored: dict[str, tuple[fmpz, list[tuple[Poly, int]]]] = {}

    def factor(self, p: Poly) -> tuple[fmpz, list[tuple[Poly, int]]]:
        """Return ``p`` as an integer times powers of canonical factors; exponents may be negative.

        Raises:
            TooLargeError: ``p`` has more than :data:`MAX_FACTOR_TERMS` terms.
        """
        key = str(p)
        found = self._factored.get(key)
        if found is None:
            found = self._factor(p)
            self._factored[key] = found
        return found

    def _factor(self, p: Poly) -> tuple[fmpz, list[tuple[Poly, int]]]:
        if p.is_constant():
            return p.leading_coefficient(), []
        if len(p) > MAX_FACTOR_TERMS:
            raise TooLargeError(
                f"factoring a polynomial of {len(p)} terms (the limit is {MAX_FACTOR_TERMS})"
            )
        if len(p) == 1:
            ((monomial, value),) = p.terms()
            return value, [(self.variables[i], int(k)) for i, k in enumerate(monomial) if k]
        if p.total_degree() == 1:
            content = p.content()
            unit = content if p.leading_coefficient() > 0 else -content
            raw = [(p // self.context.constant(unit), 1)]
        else:
            unit, raw = small_factor(self, p)
        merged: dict[str, tuple[Poly, int]] = {}
        for factor, exponent in raw:
            if factor.leading_coefficient() < 0:
                factor = -factor
                unit = unit if exponent % 2 == 0 else -unit
            scale, parts = canonical(self, factor, self.factor)
            if not self._multiplies(factor, scale, parts):
                scale, parts = fmpz(1), [(factor, 1)]
            unit *= scale**exponent
            for part, k in parts:
                name = str(part)
                merged[name] = (part, merged.get(name, (part, 0))[1] + k * exponent)
        return unit, [item for item in merged.values() if item[1]]

    def _multiplies(self, f: Poly, unit: fmpz, parts: list[tuple[Poly, int]]) -> bool:
        """Return whether the product is ``f`` at almost all points, where no factor vanishes."""
        if parts == [(f, 1)]:
            return bool(unit == 1)
        top, bottom = self.context.constant(unit), f
        for part, k in parts:
            top, bottom = (top * part**k, bottom) if k > 0 else (top, bottom * part**-k)
            if k < 0 and self.is_mixed(part) and self.is_mixed(self.reduce(part * f)):
                return False
        return bool(self.reduce(top - bottom).is_zero())

    def _settle(self, key: str) -> None:
        super()._settle(key)
        self._factored.clear()

    def factors(self, x: Fraction) -> tuple[int, Factors]:
        """Return ``x`` as a sign times powers of canonical factors, primes among them.

        Raises:
            UndefinedError: ``x`` is zero.
        """
        if x.num.is_zero():
            raise UndefinedError("a logarithm or negative power of zero")
        result: Factors = {}
        sign = 1
        for p, side in ((x.num, 1), (x.den, -1)):
            unit, parts = self.factor(p)
            sign = sign if unit > 0 else -sign
            for prime, k in primes_of(abs(unit)):
                parts = [*parts, (self.context.constant(prime), k)]
            for part, k in parts:
                key = str(part)
                old = result.get(key, (part, fmpq(0)))[1]
                result[key] = (part, old + side * k)
        return sign, {key: value for key, value in result.items() if value[1] != 0}

    # Signs

    def _sign_function(self, x: Fraction) -> Fraction:
        """Return the sign of ``x`` as a product of the signs of its factors."""
        if x.num.is_zero():
            return self.zero
        sign, parts = self.factors(x)
        product = self.context.constant(sign)
        for part, k in parts.values():
            if k.p % 2:
                product = product * self.sigma(part)
        return self.fraction(self.reduce(product))

    def sigma(self, f: Poly) -> Poly:
        """Return the sign of a factor; an arc tangent has the sign of its argument."""
        used = self.used(f)
        if len(f) == 1 and f.total_degree() == 1:
            generator = self.at(used[0])
            if generator.kind == "atan":
                return self._sign_function(generator.data[0]).num
            if generator.kind == "sign":
                return f
        inner = None if self.sign(f) else same_sign(self, f)
        if inner is not None:
            return self._sign_function(self.fraction(inner)).num
        return super().sigma(f)

    def _by_signs(self, x: Fraction) -> list[tuple[Fraction, Fraction]] | None:
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

    def _sign_content(self, x: Fraction) -> tuple[Fraction, Fraction] | None:
        """Return a product of signs that every term of ``x`` contains, and the rest; else None."""
        parts = self._by_signs(x)
        return parts[0] if parts is not None and len(parts) == 1 else None

    def _require_positive(self, x: Fraction, strict: bool = False) -> None:
        """Record that ``x`` is not negative on the domain; with ``strict``, that it is positive."""
        if x.num.is_zero():
            return
        self._require_sign_of(*self.factors(x), strict)

    def _require_sign_of(self, sign: int, parts: Factors, strict: bool) -> None:
        self.require_sign([(part, int(k.p)) for part, k in parts.values()], sign, strict)

    def require_sign(self, parts: list[tuple[Poly, int]], sign: int, strict: bool = False) -> None:
        """Record the sign of a product as the base class does, also for arguments of inverse
        functions.
        """
        for i, (part, k) in enumerate(parts):
            if k % 2 == 0 or (str(part) not in self.known_signs and self._sign_in(parts, part)):
                continue
            inner = same_sign(self, part)
            if inner is not None and not inner.is_zero():
                outer, more = self.factors(self.fraction(inner))
                powers = [(f, int(n.p)) for f, n in more.values()]
                self.require_sign([*parts[:i], *powers, *parts[i + 1 :]], sign * outer, strict)
                break
        super().require_sign(parts, sign, strict)

    def _prove_sign(self, p: Poly, depth: int) -> int:
        found = super()._prove_sign(p, depth)
        inner = same_sign(self, p) if not found and depth < MAX_DEPTH else None
        return found if inner is None else self.product_sign(inner, depth + 1)
