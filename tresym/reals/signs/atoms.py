"""Write expressions as fractions of polynomials in atoms, with equality at every single point.

An atom is a subexpression that is not a number, sum, product or power, such as a sine or a root.
Only its value is used. Two expressions with the same fraction are equal wherever they are defined.
The normal form of :mod:`tresym.reals.normal.field` recognises more identities, but only at almost
all points.
"""

from __future__ import annotations

from collections.abc import Callable
from math import prod

from flint import fmpq

from tresym.reals.functions.table import TABLE, names
from tresym.reals.language.expression import UNWORKED, Expr, apply, number, power
from tresym.reals.normal.ring import Fraction, Poly, Ring
from tresym.reals.numbers.factoring import TooLargeError

SIZE = 24
"""The largest number of atoms."""
MAX_GROWTH = 300
"""The maximal number of terms after a power of an atom is substituted."""
_EVEN = names(lambda row: row.even and row.arity == 1)
_ODD = names(lambda row: row.odd and row.arity == 1)
_CIRCULAR = {
    name: row.quotient
    for name, row in TABLE.items()
    if row.quotient and row.family == "trigonometric"
}


class Atoms:
    """Represent expressions in a ring whose generators stand for atoms.

    The data of each generator hold the atom as an expression. For an n-th root they also hold n and
    the radicand.

    Attributes:
        ring: the ring.
    """

    def __init__(self, size: int = SIZE) -> None:
        """Create a ring with ``size`` generators, none of which is used yet."""
        self.ring = Ring(size)
        self._memo: dict[Expr, Fraction] = {}

    def expression(self, position: int) -> Expr:
        """Return the atom at a position as an expression."""
        atom: Expr = self.ring.at(position).data[0]
        return atom

    def of(self, e: Expr) -> Fraction:
        """Return a fraction that has the same value as ``e`` wherever ``e`` is defined.

        Args:
            e: the expression.

        Raises:
            UndefinedError: ``e`` is defined nowhere.
            TooLargeError: ``e`` has too many terms or atoms.
        """
        fraction = self._memo.get(e)
        if fraction is None:
            fraction = self._memo[e] = self._of(e)
        return fraction

    def _of(self, e: Expr) -> Fraction:
        op, args = e.op, e.args
        if op == "number":
            return self.ring.fraction(args[0])
        if op == "+":
            return sum(map(self.of, args), self.ring.zero)
        if op == "*":
            return prod(map(self.of, args), start=self.ring.one)
        if op == "^" and args[1].op == "number":
            return self._power(args[0], args[1].args[0])
        if op in _CIRCULAR:
            above, below = (self.of(apply(f, *args)) if f else self.ring.one for f in _CIRCULAR[op])
            return above / below
        if op in _EVEN or op in _ODD or op == "exp":
            return self._function(op, args[0])
        if op in UNWORKED or op == "bound":
            raise TooLargeError("neither a binder nor a bound variable can be an atom")
        return self.ring.fraction(self.ring.generator(op, tuple(map(self._key, args)), (e,)))

    def _key(self, e: Expr | str) -> tuple[str, str] | str:
        return e if isinstance(e, str) else self.of(e).key

    def _power(self, base: Expr, exponent: fmpq) -> Fraction:
        x, q = self.of(base), int(exponent.q)
        if q > 1:
            root = power(base, number(fmpq(1, q)))
            x = self.ring.fraction(self.ring.generator("root", (x.key, q), (root, x, q)))
        return x ** int(exponent.p)

    def _function(self, name: str, argument: Expr) -> Fraction:
        """Return an even function, odd function or exponential as an atom of ``argument`` or
        ``-argument``.
        """
        u = self.of(argument)
        if u.num.is_zero() or u.num.leading_coefficient() > 0:
            return self.ring.fraction(self.ring.generator(name, u.key, (apply(name, argument),)))
        node = apply(name, -argument)
        value = self.ring.fraction(self.ring.generator(name, (-u).key, (node,)))
        if name == "exp":
            return value.inverse()
        return value if name in _EVEN else -value

    def rewritten(self, p: Poly, is_positive: Callable[[Poly], bool]) -> list[Poly]:
        """Return polynomials with the same sign as ``p``.

        They are ``p`` with powers of roots reduced, and the same with squares of cosines replaced
        by sines, or squares of sines by cosines.

        Args:
            p: a polynomial in the atoms.
            is_positive: decides whether a denominator is proved positive.
        """
        for i in self.ring.used(p):
            generator = self.ring.at(i)
            if generator.kind == "root" and is_positive(generator.data[1].den):
                p = self._lowered(p, i, generator.data[2], generator.data[1])
        forms = {str(p): p}
        for name, other in (("cos", "sin"), ("sin", "cos")):
            q = p
            for i in self.ring.used(p):
                if self.ring.at(i).kind == name and p.degrees()[i] > 1:
                    other_one = self.of(apply(other, *self.expression(i).args)).num
                    square = self.ring.fraction(1 - other_one**2)
                    q = self._lowered(q, i, 2, square)
            forms[str(q)] = q
        return list(forms.values())

    def _lowered(self, p: Poly, i: int, n: int, power: Fraction) -> Poly:
        """Replace the n-th power of atom i by ``power`` and clear its denominator, which must be
        positive.
        """
        most = int(p.degrees()[i]) // n
        if not most or len(p) * max(len(power.num), len(power.den)) ** most > MAX_GROWTH:
            return p
        total = self.ring.zero_poly
        for k, part in self.ring.split(p, i).items():
            whole, rest = divmod(k, n)
            scale = power.num**whole * power.den ** (most - whole)
            total = total + part * self.ring.variables[i] ** rest * scale
        return total
