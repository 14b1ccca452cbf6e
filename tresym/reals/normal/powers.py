"""Represent roots, exponentials and logarithms by generators.

- |f|^(1/n) for each canonical factor f of a radicand. That a radicand is positive is a condition on
  the signs of its factors.
- log|f| for each factor f of an argument.
- y = exp(exponent) for each exponent of a rational basis of the exponents that occur.

For example, √(x³ − x²) on x > 1 becomes x·g with the generator g² = x − 1, and
exp(x/2 + log(x)) becomes y·x with the generator y = exp(x/2). Exponentials of exponents that are
linearly independent over the rational numbers, up to constants, are algebraically independent
(Ax's theorem, *On Schanuel's conjectures*, Ann. of Math. 93, 1971).
"""

from __future__ import annotations

from collections.abc import Iterable
from math import lcm

from flint import fmpq

from tresym.reals.normal.factors import factor_fraction
from tresym.reals.normal.rational_basis import RationalBasis
from tresym.reals.normal.ring import AgainError, Fraction, Generator, Poly, UndefinedError
from tresym.reals.normal.sign_equations import SignEquations
from tresym.reals.numbers.factoring import TooLargeError


class Powers:
    """Roots, exponentials and logarithms of the elements of a ring."""

    def __init__(self, equations: SignEquations) -> None:
        """Prepare powers in the ring of ``equations``, to which conditions on signs are added."""
        self.ring = equations.ring
        self.equations = equations
        self._orders: dict[str, int] = {}
        self._exponents = RationalBasis(self.ring, with_numbers=True)

    # Roots

    def root(self, x: Fraction, r: fmpq, signed: bool = False) -> Fraction:
        """Return ``x**r`` for ``x ≥ 0``; with ``signed``, the odd root with the sign of ``x``."""
        if x.num.is_zero():
            if r < 0:
                raise UndefinedError("a negative power of zero")
            return self.ring.zero
        sign, parts = factor_fraction(self.ring, x)
        result = self.ring.one
        if signed:
            result = self.ring.fraction(sign)
            for part in (part for part, k in parts.values() if k.p % 2):
                result = result * self.ring.fraction(self.equations.sigma(part))
        else:
            self.equations.require_factored(sign, parts, strict=r < 0)
        for part, k in parts.values():
            result = result * self._absolute_power(part, k * r)
        return result

    def _absolute_power(self, f: Poly, r: fmpq) -> Fraction:
        """Return ``|f|**r`` for a canonical factor ``f``."""
        if r == 0:
            return self.ring.one
        used = self.ring.used(f)
        if len(f) == 1 and len(used) == 1 and f == self.ring.variables[used[0]]:
            generator = self.ring.at(used[0])
            if generator.kind == "sign":
                return self.ring.one
            if generator.kind == "root" and r.q != 1:
                base, order = generator.data
                return self._absolute_power(base, r / order)
            if generator.kind == "exp" and r.q != 1:
                index, unit = generator.data[:2]
                return self._basis_exp([(index, r / unit)])
        whole = r.p // r.q
        rest = r - whole
        result = self.ring.fraction(f) ** int(whole)
        if whole % 2:
            result = result * self.ring.fraction(self.equations.sigma(f))
        if rest != 0:
            order = self._order(f, int(rest.q))
            root = self._root_generator(f, order)
            k = int(rest.p * (order // rest.q))
            result = result * self.ring.fraction(root**k)
        return result

    def _order(self, f: Poly, n: int) -> int:
        key = str(f)
        old = self._orders.get(key, 1)
        new = lcm(old, n)
        if new > 60:
            raise TooLargeError("a root of order over 60")
        self._orders[key] = new
        if new != old != 1:
            raise AgainError
        return new

    def _root_generator(self, f: Poly, order: int) -> Poly:
        key = (str(f), order)
        sign = self.equations.sigma(f)
        if not self.ring.known("root", key):
            generator = self.ring.generator("root", key, (f, order))
            self.ring.relate(generator, order, f * sign)
        return self.ring.variable(self.ring.generator("root", key))

    # Logarithms and exponentials

    def log(self, x: Fraction) -> Fraction:
        """Return ``log x`` on ``x > 0`` as a sum over the factors of ``x``."""
        sign, parts = factor_fraction(self.ring, x)
        self.equations.require_factored(sign, parts, strict=True)
        return sum((self._log_absolute(part) * k for part, k in parts.values()), self.ring.zero)

    def _log_absolute(self, f: Poly) -> Fraction:
        used = self.ring.used(f)
        if len(f) == 1 and len(used) == 1 and f == self.ring.variables[used[0]]:
            generator = self.ring.at(used[0])
            if generator.kind == "sign":
                return self.ring.zero
            if generator.kind == "root":
                base, order = generator.data
                return self.log_of_absolute(base) / order
            if generator.kind == "exp":
                index, unit = generator.data[:2]
                return self._exponents.elements[index] / unit
        return self.ring.fraction(self.ring.generator("log", str(f), (f,)))

    def log_of_absolute(self, p: Poly) -> Fraction:
        """Return ``log|p|``."""
        _, parts = factor_fraction(self.ring, self.ring.fraction(p))
        return sum((self._log_absolute(part) * k for part, k in parts.values()), self.ring.zero)

    def exp(self, x: Fraction) -> Fraction:
        """Return ``exp x``; rational multiples of logarithms become powers."""
        parts = self.ring.by_signs(x)
        if parts is not None:
            return self._expby_signs(parts)
        result = self.ring.one
        rest, pieces = self.linear_part(x, "log")
        for generator, r in pieces:
            result = result * self._absolute_power(generator.data[0], r)
        return result * self._basis_exp(self._exponents.combination(rest))

    def _expby_signs(self, parts: list[tuple[Fraction, Fraction]]) -> Fraction:
        """Return the exponential of a sum of ``s·w``, each factor cosh w + s·sinh w where s is a
        sign.
        """
        result = self.ring.one
        for sign, part in parts:
            y = self.exp(part)
            if not sign.num.is_one():
                z = 1 / y
                y = (y + z + sign * (y - z)) / 2
            result = result * y
        return result

    def linear_part(self, x: Fraction, kind: str) -> tuple[Fraction, list[tuple[Generator, fmpq]]]:
        """Split off all rational multiples of generators of ``kind``.

        Returns:
            The rest of ``x``, and pairs of a generator and its rational coefficient.
        """
        pieces = [piece for piece in self._multiples(x, kind) if piece[0].kind == kind]
        for generator, ratio in pieces:
            x = x - self.ring.fraction(generator) * ratio
        return x, pieces

    def _multiples(self, x: Fraction, kind: str) -> list[tuple[Generator, fmpq]]:
        """Return the rational multiples of generators of ``kind`` that ``x`` contains."""
        pieces = []
        for position in self.ring.used(x.num):
            generator = self.ring.at(position)
            if generator.kind != kind:
                continue
            ratio = fmpq(0)
            if x.den.is_constant():
                alone = tuple(int(i == position) for i in range(self.ring.size))
                ratio = fmpq(x.num[alone], x.den.leading_coefficient())
            elif x.num.degrees()[position] == 1:
                ratio = self._share(x, position)
            if ratio != 0:
                pieces.append((generator, ratio))
        return pieces

    def _share(self, x: Fraction, position: int) -> fmpq:
        """Return the rational coefficient of a generator in the polynomial part of ``x``."""
        content = x.den.content()
        quotient, _ = divmod(x.num.derivative(position), x.den // content)
        return fmpq(quotient[(0,) * self.ring.size], content)

    def _basis_exp(self, terms: Iterable[tuple[int, fmpq]]) -> Fraction:
        result = self.ring.one
        for index, r in terms:
            unit = self._exponents.unit(index, int(r.q))
            exponent = self._exponents.elements[index]
            generator = self.ring.generator("exp", (index, unit), (index, unit, exponent))
            result = result * self.ring.fraction(generator) ** int(r.p * (unit // r.q))
        return result
