"""Write exponents, or angles, as rational combinations of some of them.

For example, of the exponents x, x/2 + y and y the first two become the basis, and the third is
(x/2 + y) − x/2; since x occurs halved, its unit is x/2, of which all multiples are integers. The
coefficients are found by linear algebra over the rational numbers and checked by summing up.
"""

from __future__ import annotations

from math import lcm

from flint import fmpq, fmpq_mat

from tresym.reals.normal.ring import AgainError, Fraction, Poly, Ring


class RationalBasis:
    """Elements of a ring of which others are rational combinations.

    Attributes:
        elements: the basis; it grows.
    """

    def __init__(self, ring: Ring, with_numbers: bool = False) -> None:
        """Create an empty basis.

        Args:
            ring: the ring.
            with_numbers: whether a rational number in a sum is a term of its own.
        """
        self.elements: list[Fraction] = []
        self._ring = ring
        self._with_numbers = with_numbers
        self._units: list[int] = []

    def unit(self, index: int, q: int) -> int:
        """Return n such that 1/n of a basis element is used; it must be a multiple of ``q``.

        Raises:
            AgainError: it was not, and now it is.
        """
        old = self._units[index]
        if old % q:
            self._units[index] = lcm(old, q)
            raise AgainError
        return old

    def combination(self, x: Fraction) -> list[tuple[int, fmpq]]:
        """Write ``x`` as a rational combination of the basis, which is extended if needed.

        Returns:
            Pairs of the index of an element and its coefficient.
        """
        terms: list[tuple[int, fmpq]] = []
        if self._with_numbers:
            for monomial, value in x.num.terms() if x.den.is_constant() else ():
                if not any(monomial):
                    r = fmpq(value, x.den.leading_coefficient())
                    x = x - r
                    terms.append((self._index(self._ring.one), r))
        if x.num.is_zero():
            return terms
        basis = self.elements
        for index, element in enumerate(basis):
            if element.den == x.den:
                ratio = _proportion(x.num, element.num)
                if ratio is not None:
                    return [*terms, (index, ratio)]
        solution = self._solution(basis, x) if basis else []
        others = [(index, r) for index, r in enumerate(solution) if r != 0]
        if (sum((basis[index] * r for index, r in others), self._ring.zero) - x).num.is_zero():
            return terms + others
        return [*terms, (self._index(x), fmpq(1))]

    def _index(self, x: Fraction) -> int:
        for index, element in enumerate(self.elements):
            if element.num == x.num and element.den == x.den:
                return index
        self.elements.append(x)
        self._units.append(1)
        return len(self.elements) - 1

    def _solution(self, basis: list[Fraction], x: Fraction) -> list[fmpq]:
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
