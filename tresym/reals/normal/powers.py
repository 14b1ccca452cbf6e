"""Represent roots, exponentials and logarithms by generators.

- |f|^(1/n) for each canonical factor f of a radicand. That a radicand is positive is a condition on
  the signs of its factors.
- log|f| for each factor f of an argument.
- y = exp(exponent) for each exponent of a rational basis of the exponents that occur.
"""

from __future__ import annotations

from collections.abc import Iterable
from math import lcm
from typing import Any

from flint import fmpq, fmpq_mat

from tresym.reals.normal.factors import FactoredRing
from tresym.reals.normal.ring import Fraction, Generator, Poly, UndefinedError
from tresym.reals.normal.sign_equations import AgainError
from tresym.reals.numbers.factoring import TooLargeError


class PowerRing(FactoredRing):
    """A ring with roots, exponentials and logarithms of its elements."""

    def __init__(self, *arguments: Any) -> None:
        """Take the arguments of the base class."""
        super().__init__(*arguments)
        self._orders: dict[str, int] = {}
        self._basis: dict[str, list[Fraction]] = {"exp": [], "tan": [], "turn": []}
        self._units: dict[str, list[int]] = {"exp": [], "tan": [], "turn": []}

    # Roots

    def _root(self, x: Fraction, r: fmpq, signed: bool = False) -> Fraction:
        """Return ``x**r`` for ``x ≥ 0``; with ``signed``, the odd root with the sign of ``x``."""
        if x.num.is_zero():
            if r < 0:
                raise UndefinedError("a negative power of zero")
            return self.zero
        sign, parts = self.factors(x)
        result = self.one
        if signed:
            result = self.fraction(sign)
            for part in (part for part, k in parts.values() if k.p % 2):
                result = result * self.fraction(self.sigma(part))
        else:
            self._require_sign_of(sign, parts, strict=r < 0)
        for part, k in parts.values():
            result = result * self._absolute_power(part, k * r)
        return result

    def _absolute_power(self, f: Poly, r: fmpq) -> Fraction:
        """Return ``|f|**r`` for a canonical factor ``f``."""
        if r == 0:
            return self.one
        used = self.used(f)
        if len(f) == 1 and len(used) == 1 and f == self.variables[used[0]]:
            generator = self.at(used[0])
            if generator.kind == "sign":
                return self.one
            if generator.kind == "root" and r.q != 1:
                base, order = generator.data
                return self._absolute_power(base, r / order)
            if generator.kind == "exp" and r.q != 1:
                index, unit = generator.data[:2]
                return self._basis_exp([(index, r / unit)])
        whole = r.p // r.q
        rest = r - whole
        result = self.fraction(f) ** int(whole)
        if whole % 2:
            result = result * self.fraction(self.sigma(f))
        if rest != 0:
            order = self._order(f, int(rest.q))
            root = self._root_generator(f, order)
            k = int(rest.p * (order // rest.q))
            result = result * self.fraction(root**k)
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
        sign = self.sigma(f)
        if not self.known("root", key):
            generator = self.generator("root", key, (f, order))
            self.relate(generator, order, f * sign)
        return self.variable(self.generator("root", key))

    # Logarithms and exponentials

    def log(self, x: Fraction) -> Fraction:
        """Return ``log x`` on ``x > 0`` as a sum over the factors of ``x``."""
        sign, parts = self.factors(x)
        self._require_sign_of(sign, parts, strict=True)
        return sum((self._log_absolute(part) * k for part, k in parts.values()), self.zero)

    def _log_absolute(self, f: Poly) -> Fraction:
        used = self.used(f)
        if len(f) == 1 and len(used) == 1 and f == self.variables[used[0]]:
            generator = self.at(used[0])
            if generator.kind == "sign":
                return self.zero
            if generator.kind == "root":
                base, order = generator.data
                return self.log_of_absolute(base) / order
            if generator.kind == "exp":
                index, unit = generator.data[:2]
                return self._basis["exp"][index] / unit
        return self.fraction(self.generator("log", str(f), (f,)))

    def log_of_absolute(self, p: Poly) -> Fraction:
        """Return ``log|p|``."""
        _, parts = self.factors(self.fraction(p))
        return sum((self._log_absolute(part) * k for part, k in parts.values()), self.zero)

    def exp(self, x: Fraction) -> Fraction:
        """Return ``exp x``; rational multiples of logarithms become powers."""
        parts = self._by_signs(x)
        if parts is not None:
            return self._exp_by_signs(parts)
        result = self.one
        rest, pieces = self.linear_part(x, "log")
        for generator, r in pieces:
            result = result * self._absolute_power(generator.data[0], r)
        return result * self._basis_exp(self._decompose("exp", rest))

    def _exp_by_signs(self, parts: list[tuple[Fraction, Fraction]]) -> Fraction:
        """Return the exponential of a sum of ``s·w``, each factor cosh w + s·sinh w where s is a
        sign.
        """
        result = self.one
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
            x = x - self.fraction(generator) * ratio
        return x, pieces

    def _multiples(self, x: Fraction, kind: str) -> list[tuple[Generator, fmpq]]:
        """Return the rational multiples of generators of ``kind`` that ``x`` contains."""
        pieces = []
        for position in self.used(x.num):
            generator = self.at(position)
            if generator.kind != kind:
                continue
            ratio = fmpq(0)
            if x.den.is_constant():
                alone = tuple(int(i == position) for i in range(self.size))
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
        return fmpq(quotient[(0,) * self.size], content)

    # Rational bases of exponents, and of angles

    def _basis_exp(self, terms: Iterable[tuple[int, fmpq]]) -> Fraction:
        result = self.one
        for index, r in terms:
            unit = self._unit("exp", index, int(r.q))
            exponent = self._basis["exp"][index]
            generator = self.generator("exp", (index, unit), (index, unit, exponent))
            result = result * self.fraction(generator) ** int(r.p * (unit // r.q))
        return result

    def _unit(self, kind: str, index: int, q: int) -> int:
        old = self._units[kind][index]
        if old % q:
            self._units[kind][index] = lcm(old, q)
            raise AgainError
        return old

    def _decompose(self, kind: str, x: Fraction) -> list[tuple[int, fmpq]]:
        """Write ``x`` as a rational combination of the basis of its kind, extending the basis if
        needed.
        """
        terms: list[tuple[int, fmpq]] = []
        if kind == "exp":
            for monomial, value in x.num.terms() if x.den.is_constant() else ():
                if not any(monomial):
                    r = fmpq(value, x.den.leading_coefficient())
                    x = x - r
                    terms.append((self._basis_index(kind, self.one), r))
        if x.num.is_zero():
            return terms
        basis = self._basis[kind]
        for index, element in enumerate(basis):
            if element.den == x.den:
                ratio = _proportion(x.num, element.num)
                if ratio is not None:
                    return [*terms, (index, ratio)]
        solution = self._combination(basis, x) if basis else []
        found = [(index, r) for index, r in enumerate(solution) if r != 0]
        if (sum((basis[index] * r for index, r in found), self.zero) - x).num.is_zero():
            return terms + found
        return [*terms, (self._basis_index(kind, x), fmpq(1))]

    def _basis_index(self, kind: str, x: Fraction) -> int:
        basis = self._basis[kind]
        for index, element in enumerate(basis):
            if element.num == x.num and element.den == x.den:
                return index
        basis.append(x)
        self._units[kind].append(1)
        return len(basis) - 1

    def _combination(self, basis: list[Fraction], x: Fraction) -> list[fmpq]:
        """Return the rational coefficients with ``Σ c_i basis_i = x``, or wrong ones if there are
        none.
        """
        common = x.den
        for element in basis:
            common = common * (element.den / common.gcd(element.den))
        columns = [dict((item.num * (common / item.den)).terms()) for item in (*basis, x)]
        rows = sorted({monomial for column in columns for monomial in column})
        if not set(columns[-1]) <= {m for column in columns[:-1] for m in column}:
            return []
        matrix = fmpq_mat(
            [[fmpq(column.get(monomial, 0)) for column in columns] for monomial in rows]
        )
        reduced, _ = matrix.rref()
        n = len(basis)
        solution = [fmpq(0)] * n
        for i in range(len(rows)):
            pivot = next((j for j in range(n + 1) if reduced[i, j] != 0), None)
            if pivot == n:
                return []
            if pivot is not None:
                solution[pivot] = reduced[i, n]
        return solution


def _proportion(p: Poly, q: Poly) -> fmpq | None:
    """Return r with ``p = r·q``, or None."""
    if p.is_zero() or q.is_zero() or len(p) != len(q):
        return None
    a, b = p.leading_coefficient(), q.leading_coefficient()
    return fmpq(a, b) if p * b == q * a else None
