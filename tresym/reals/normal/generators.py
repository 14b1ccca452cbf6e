"""Record what generators depend on, and evaluate them in balls."""

from __future__ import annotations

from collections.abc import Mapping

from flint import arb, fmpq

from tresym.reals.functions.table import SPECIAL, TABLE
from tresym.reals.normal.ring import Fraction, Generator, Poly, Ring

SIGN_BITS = 256


class ValuedRing(Ring):
    """A ring whose generators are functions of symbols, with values at points."""

    def __init__(self, size: int) -> None:
        """Create a ring with at most ``size`` generators, none of which exists yet."""
        super().__init__(size)
        self._supports: dict[int, frozenset[str]] = {}

    def symbol(self, name: str) -> Generator:
        """Return the generator of a variable."""
        return self.generator("symbol", name, (name,))

    def support(self, position: int) -> frozenset[str]:
        """Return the symbols that a generator depends on."""
        found = self._supports.get(position)
        if found is None:
            generator = self.at(position)
            if generator.kind == "symbol":
                found = frozenset(generator.data)
            else:
                found = frozenset().union(*map(self.dependence, self.inside(position)))
            self._supports[position] = found
        return found

    def dependence(self, x: Poly | Fraction) -> frozenset[str]:
        """Return the symbols that ``x`` depends on."""
        return frozenset().union(*(self.support(i) for i in self.used(x)))

    def involved(self, x: Poly | Fraction) -> set[int]:
        """Return the generators of ``x`` and, recursively, those inside them, without constants."""
        found = {i for i in self.used(x) if self.support(i) or self.at(i).kind == "opaque"}
        return found.union(*(self.involved(p) for i in found for p in self.inside(i)))

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
                known[i] = self._generator_ball(self.at(i), point or {}, known)
            values[i] = known[i]
        for monomial, coefficient in x.terms():
            term = arb(coefficient)
            for i, value in values.items():
                if monomial[i]:
                    term = term * value ** int(monomial[i])
            total = total + term
        return total

    def _generator_ball(
        self, generator: Generator, point: Mapping[str, arb], known: dict[int, arb]
    ) -> arb:
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
