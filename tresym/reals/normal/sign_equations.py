"""Learn signs of factors by solving linear equations over GF(2).

The facts are the conditions of a claim and those that its own radicands, logarithms and inverse
functions impose. Each says that a product of signs is +1 or −1, which is a linear equation over
GF(2). A sign that is not proven is a generator σ with σ² = 1.
"""

from __future__ import annotations

from typing import Any

from tresym.reals.normal.ranges import ProvingRing
from tresym.reals.normal.ring import Poly
from tresym.reals.numbers.factoring import TooLargeError


class AgainError(TooLargeError):
    """Raised when a unit, an order or a sign was learnt, so that the normal form starts again."""


class SignedRing(ProvingRing):
    """A ring that learns the signs of its factors."""

    def __init__(self, *arguments: Any) -> None:
        """Take the arguments of the base class."""
        super().__init__(*arguments)
        self.rules: dict[str, tuple[int, list[str]]] = {}
        self.polys: dict[str, Poly] = {}
        self._met: dict[str, int] = {}
        self._equations: set[tuple[frozenset[str], int]] = set()
        self._quietly = False  # whether a sign was learnt that this pass has not used yet

    def begin_pass(self) -> None:
        """Forget the equations of the last pass and the signs that new facts may improve."""
        self._equations = set()
        self._tried = {}
        self._quietly = False
        self._signs = {key: sign for key, sign in self._signs.items() if sign}
        self._settle_proven()

    def _settle_proven(self) -> None:
        """Fix the signs that have a generator from an earlier pass and are now proved."""
        for generator in self.generators:
            if generator.kind != "sign":
                continue
            key = str(generator.data[0])
            if key not in self.known_signs and key not in self.rules:
                found = self.sign(generator.data[0])
                if found:
                    self._know(key, found)

    def sigma(self, f: Poly) -> Poly:
        """Return the sign of a canonical factor: ±1 if known, a product of other signs, or a new
        generator.
        """
        if f.is_constant():
            return self.one_poly if f.leading_coefficient() > 0 else -self.one_poly
        known = self.sign(f)
        if known:
            return self.context.constant(known)
        key = self._meet(f)
        if key in self.rules:
            constant, others = self.rules[key]
            product = self.context.constant(constant)
            for other in others:
                product = product * self.sigma(self.polys[other])
            return self.reduce(product)
        if not self.known("sign", key):
            generator = self.generator("sign", key, (f,))
            self.relate(generator, 2, self.one_poly)
        return self.variable(self.generator("sign", key))

    def _meet(self, f: Poly) -> str:
        key = str(f)
        if key not in self.polys:
            self.polys[key] = f
            self._met[key] = len(self._met)
        return key

    def require_sign(self, parts: list[tuple[Poly, int]], sign: int, strict: bool = False) -> None:
        """Record that the product of these powers has the given sign on the domain, or is zero.

        A sign of a single part is used at once. If its generator already occurs in this pass, a new
        pass begins.

        A part that may vanish on a whole region makes the product zero there, so that nothing
        follows for the signs of the other parts, even if its exponent is even or its sign is known.
        Such an equation is ignored, unless ``strict`` states that the product is nowhere zero.

        Args:
            parts: factors and their exponents.
            sign: 1 or −1.
            strict: whether the product is nowhere zero.

        Raises:
            AgainError: a sign was learnt that this pass has already used as unknown.
        """
        keys: set[str] = set()
        for constant, _ in ((part, k) for part, k in parts if part.is_constant() and k % 2):
            sign *= 1 if constant.leading_coefficient() > 0 else -1
        parts = [(part, k) for part, k in parts if not part.is_constant()]
        for part in (part for part, k in parts if k % 2):
            known = self._sign_in(parts, part)
            if known:
                sign *= known
                continue
            keys ^= {self._meet(part)}
        if not keys:
            return
        if not strict and len(parts) > 1 and any(self.is_mixed(part) for part, _ in parts):
            return
        if len(keys) == 1:
            (key,) = keys
            used = self.known("sign", key)
            self._know(key, sign)
            self._quietly |= not used
            if used:
                raise AgainError
            return
        self._equations.add((frozenset(keys), sign))

    def _sign_in(self, parts: list[tuple[Poly, int]], part: Poly) -> int:
        """Return the sign of a part; a part that stands alone is not worth a proof."""
        if not self._inhabited or sum(not p.is_constant() for p, _ in parts) > 1:
            return self.sign(part)
        key = str(part)
        return self.known_signs.get(key) or self._signs.get(key) or self.orthant_sign(part)

    def zero_divisor(
        self, num: Poly, den: Poly, position: int, parts: dict[int, Poly]
    ) -> tuple[Poly, Poly]:
        """Replace a denominator d·(1 ± σ), which is nonzero only where it equals 2d, by 2d."""
        generator = self.at(position)
        for sign in (1, -1):
            if generator.kind == "sign" and self.reduce(parts[0] - sign * parts[1]).is_zero():
                self.require_sign([(generator.data[0], 1)], sign)
                return num, 2 * parts[0]
        return num, den

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
        return not any(part.is_constant() or self._constant_sign(part) for part in parts)

    # Equations between signs

    def learn(self) -> bool:
        """Solve the sign equations of the pass, and return whether anything was learnt."""
        rows = self._eliminated()
        before = len(self.known_signs), len(self.rules), tuple(self.box.items())
        for keys, sign in rows:
            if len(keys) == 1:
                self._know(next(iter(keys)), sign)
            elif len(keys) == 2:
                first, second = sorted(keys)
                self._compare(first, second, sign)
        for keys, sign in rows:
            newest = self._newest(keys)
            if len(keys) > 1 and newest not in self.rules:
                self.rules[newest] = (sign, sorted(keys - {newest}))
                self._settle(newest)
        after = len(self.known_signs), len(self.rules), tuple(self.box.items())
        return self._quietly or before != after

    def _eliminated(self) -> list[tuple[frozenset[str], int]]:
        """Return the equations in reduced row echelon form over GF(2)."""
        rows: list[tuple[frozenset[str], int]] = []
        order = sorted(self._equations, key=lambda row: (len(row[0]), sorted(row[0])))
        for keys, sign in order:
            for other, value in rows:
                if self._newest(other) in keys:
                    keys, sign = keys ^ other, sign * value
            if keys:
                pivot = self._newest(keys)
                rows = [
                    (other ^ keys, value * sign) if pivot in other else (other, value)
                    for other, value in rows
                ]
                rows.append((keys, sign))
        return rows

    def _newest(self, keys: frozenset[str]) -> str:
        """Return the factor whose sign is expressed by the others: one without a generator, or the
        newest.
        """
        return max(keys, key=self._age)

    def _age(self, key: str) -> tuple[int, int]:
        if self.known("sign", key):
            return 0, -self.generator("sign", key).position
        return 1, self._met[key]

    def _settle(self, key: str) -> None:
        """Add the relation that reduces the generator of a sign that is now known."""
        if self.known("sign", key):
            self.relate(self.generator("sign", key), 1, self.sigma(self.polys[key]))

    def _know(self, key: str, sign: int) -> None:
        if key in self.known_signs:
            return
        self.known_signs[key] = sign
        self._settle(key)
        p = self.polys[key]
        self.positives[key] = p if sign > 0 else -p
        self._narrow(self.positives[key])

    def _compare(self, first: str, second: str, sign: int) -> None:
        """Decide two signs with known product if the sum or difference of the factors has one."""
        p, q = self.polys[first], self.polys[second]
        if sign < 0:
            q = -q
        total = self.sign(self.reduce(p + q))
        if total:
            self._know(first, total)
            self._know(second, total * sign)
