"""Learn signs of factors by solving linear equations over GF(2).

For example, √(x·(x − 1)) and log(x) say that σ(x)·σ(x − 1) = 1 and σ(x) = 1, from which
σ(x − 1) = 1 follows. The facts are the conditions of a claim and those that its own radicands,
logarithms and inverse functions impose. Each says that a product of signs is +1 or −1, which is a
linear equation over GF(2); Gaussian elimination solves them. A sign that is not proven is a
generator σ with σ² = 1.
"""

from __future__ import annotations

from tresym.reals.normal.factors import PowersOfFactors, factor_fraction
from tresym.reals.normal.ring import AgainError, Fraction, Poly
from tresym.reals.normal.sign_proofs import SignProver


class SignEquations:
    """The signs of the factors of a ring: known, given by a rule, or generators.

    Attributes:
        rules: factors whose sign is a constant times the signs of other factors.
        polys: the factors that were met, by their text.
    """

    def __init__(self, signs: SignProver) -> None:
        """Create an empty system of equations, and take over what the ring requires of signs."""
        self.ring = signs.ring
        self.signs = signs
        self.ring.require = lambda p, sign: self.require_sign([(p, 1)], sign)
        self.rules: dict[str, tuple[int, list[str]]] = {}
        self.polys: dict[str, Poly] = {}
        self._met: dict[str, int] = {}
        self._equations: set[tuple[frozenset[str], int]] = set()
        self._quietly = False  # whether a sign was learnt that this pass has not used yet

    def begin_pass(self) -> None:
        """Forget the equations of the last pass and the signs that new facts may improve."""
        self._equations = set()
        self._quietly = False
        self.signs.forget_failures()
        self._settle_proven()

    def _settle_proven(self) -> None:
        """Fix the signs that have a generator from an earlier pass and are now proved."""
        for generator in self.ring.generators:
            if generator.kind != "sign":
                continue
            key = str(generator.data[0])
            if key not in self.signs.known_signs and key not in self.rules:
                sign = self.signs.sign(generator.data[0])
                if sign:
                    self._know(key, sign)

    def sigma(self, f: Poly) -> Poly:
        """Return the sign of a canonical factor: ±1 if known, a product of other signs, or a new
        generator.

        An arc tangent has the sign of its argument.
        """
        if len(f) == 1 and f.total_degree() == 1:
            generator = self.ring.at(self.ring.used(f)[0])
            if generator.kind == "atan":
                return self.sign_function(generator.data[0]).num
            if generator.kind == "sign":
                return f
        inner = None if self.signs.sign(f) else self.signs.same_sign(f)
        if inner is not None:
            return self.sign_function(self.ring.fraction(inner)).num
        if f.is_constant():
            return self.ring.one_poly if f.leading_coefficient() > 0 else -self.ring.one_poly
        known = self.signs.sign(f)
        if known:
            return self.ring.context.constant(known)
        key = self._meet(f)
        if key in self.rules:
            constant, others = self.rules[key]
            product = self.ring.context.constant(constant)
            for other in others:
                product = product * self.sigma(self.polys[other])
            return self.ring.reduce(product)
        if not self.ring.known("sign", key):
            generator = self.ring.generator("sign", key, (f,))
            self.ring.relate(generator, 2, self.ring.one_poly)
        return self.ring.variable(self.ring.generator("sign", key))

    def sign_function(self, x: Fraction) -> Fraction:
        """Return the sign of ``x`` as a product of the signs of its factors."""
        if x.num.is_zero():
            return self.ring.zero
        sign, parts = factor_fraction(self.ring, x)
        product = self.ring.context.constant(sign)
        for part, k in parts.values():
            if k.p % 2:
                product = product * self.sigma(part)
        return self.ring.fraction(self.ring.reduce(product))

    def _meet(self, f: Poly) -> str:
        key = str(f)
        if key not in self.polys:
            self.polys[key] = f
            self._met[key] = len(self._met)
        return key

    def require_positive(self, x: Fraction, strict: bool = False) -> None:
        """Record that ``x`` is not negative on the domain; with ``strict``, that it is positive."""
        if not x.num.is_zero():
            self.require_factored(*factor_fraction(self.ring, x), strict)

    def require_factored(self, sign: int, parts: PowersOfFactors, strict: bool) -> None:
        """Record that a fraction, given by its factors, is not negative, or that it is positive."""
        self.require_sign([(part, int(k.p)) for part, k in parts.values()], sign, strict)

    def require_sign(self, parts: list[tuple[Poly, int]], sign: int, strict: bool = False) -> None:
        """Record that the product of these powers has the given sign on the domain, or is zero.

        A sign of a single part is used at once. If its generator already occurs in this pass, a new
        pass begins.

        A part that may vanish on a whole region makes the product zero there, so that nothing
        follows for the signs of the other parts, even if its exponent is even or its sign is known.
        Such an equation is ignored, unless ``strict`` states that the product is nowhere zero.

        A part that is an inverse function is also replaced by its argument.

        Args:
            parts: factors and their exponents.
            sign: 1 or −1.
            strict: whether the product is nowhere zero.

        Raises:
            AgainError: a sign was learnt that this pass has already used as unknown.
        """
        for i, (part, k) in enumerate(parts):
            if k % 2 == 0:
                continue
            if str(part) not in self.signs.known_signs and self._sign_in(parts, part):
                continue
            inner = self.signs.same_sign(part)
            if inner is not None and not inner.is_zero():
                outer, factors = factor_fraction(self.ring, self.ring.fraction(inner))
                powers = [(f, int(n.p)) for f, n in factors.values()]
                self.require_sign([*parts[:i], *powers, *parts[i + 1 :]], sign * outer, strict)
                break
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
        if not strict and len(parts) > 1 and any(self.ring.is_mixed(part) for part, _ in parts):
            return
        if len(keys) == 1:
            (key,) = keys
            used = self.ring.known("sign", key)
            self._know(key, sign)
            self._quietly |= not used
            if used:
                raise AgainError
            return
        self._equations.add((frozenset(keys), sign))

    def _sign_in(self, parts: list[tuple[Poly, int]], part: Poly) -> int:
        """Return the sign of a part; a part that stands alone is not worth a proof."""
        if not self.signs.has_points or sum(not p.is_constant() for p, _ in parts) > 1:
            return self.signs.sign(part)
        return self.signs.quick_sign(part)

    # Equations between signs

    def learn(self) -> bool:
        """Solve the sign equations of the pass, and return whether anything was learnt."""
        rows = self._eliminated()
        before = len(self.signs.known_signs), len(self.rules), tuple(self.signs.box.items())
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
        after = len(self.signs.known_signs), len(self.rules), tuple(self.signs.box.items())
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
        if self.ring.known("sign", key):
            return 0, -self.ring.generator("sign", key).position
        return 1, self._met[key]

    def _settle(self, key: str) -> None:
        """Add the relation that reduces the generator of a sign that is now known."""
        if self.ring.known("sign", key):
            self.ring.relate(self.ring.generator("sign", key), 1, self.sigma(self.polys[key]))

    def _know(self, key: str, sign: int) -> None:
        if key not in self.signs.known_signs:
            self.signs.know(self.polys[key], sign)
            self._settle(key)

    def _compare(self, first: str, second: str, sign: int) -> None:
        """Decide two signs with known product if the sum or difference of the factors has one."""
        p, q = self.polys[first], self.polys[second]
        if sign < 0:
            q = -q
        total = self.signs.sign(self.ring.reduce(p + q))
        if total:
            self._know(first, total)
            self._know(second, total * sign)
