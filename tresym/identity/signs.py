"""Signs of polynomials in generators: proven from ranges, conjugates, discriminants and facts.

A sign proven here holds on the open part of the domain, where no factor vanishes. The facts are
the conditions a claim was given and those its own radicands, logarithms and inverse functions
impose: each is a product of signs, a linear equation over GF(2).
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager

from flint import arb, fmpq, fmpz, fmpz_mpoly

from tresym.arithmetic import ball_precision
from tresym.identity.given import Given, Range
from tresym.identity.ring import Fraction, Generator, Poly, Ring, TooLargeError, small_factor

SIGN_BITS = 256
MAX_SIGN_TERMS = 60
MAX_DEPTH = 4
MAX_TRIALS = 60
_PI_LOW, _PI_HIGH = fmpq(103993, 33102), fmpq(104348, 33215)

Ends = tuple[fmpq | None, fmpq | None]


class AgainError(TooLargeError):
    """A unit, an order or a sign was learnt: normalise again from the start."""


class SignedRing(Ring):
    """A ring whose generators have ranges, with what is known of the signs of its factors."""

    def __init__(
        self, given: Given, size: int, points: Callable[[], Sequence[Mapping[str, fmpq]]] = tuple
    ) -> None:
        """Signs under ``given``; ``points`` finds some of the domain, which spare vain trials."""
        super().__init__(size)
        self.given = given
        self._find_points = points
        self._samples: list[tuple[dict[str, arb], dict[int, arb]]] | None = None
        self.box: dict[str, Range] = dict(given.box)
        self.known_signs: dict[str, int] = {}
        self.rules: dict[str, tuple[int, list[str]]] = {}
        self.polys: dict[str, Poly] = {}
        self._met: dict[str, int] = {}
        self.positives: dict[str, Poly] = {}
        self._equations: set[tuple[frozenset[str], int]] = set()
        self._signs: dict[str, int] = {}
        self._trials = 0
        self._everywhere = False
        self._quietly = False  # whether a sign was learnt that nothing in this pass has used
        self._tried: dict[str, int] = {}  # the least depth at which no sign was proved
        self._supports: dict[int, frozenset[str]] = {}

    def begin_pass(self) -> None:
        """Forget the equations of the last pass and the signs that new facts may improve."""
        self._equations = set()
        self._tried = {}
        self._quietly = False
        self._signs = {key: sign for key, sign in self._signs.items() if sign}
        self._settle_proven()

    def _settle_proven(self) -> None:
        """Settle the signs that have a generator from an earlier pass and are proven by now."""
        for generator in self.generators:
            if generator.kind != "sign":
                continue
            key = str(generator.data[0])
            if key not in self.known_signs and key not in self.rules:
                found = self.sign(generator.data[0])
                if found:
                    self._know(key, found)

    def symbol(self, name: str) -> Generator:
        """The generator of a variable."""
        return self.generator("symbol", name, (name,))

    # What generators depend on, and their values

    def support(self, position: int) -> frozenset[str]:
        """The symbols that a generator depends on."""
        found = self._supports.get(position)
        if found is None:
            generator = self.at(position)
            if generator.kind == "symbol":
                found = frozenset(generator.data)
            else:
                found = frozenset().union(
                    *(
                        self.dependence(item)
                        for item in generator.data
                        if isinstance(item, Poly | Fraction)
                    )
                )
            self._supports[position] = found
        return found

    def dependence(self, x: Poly | Fraction) -> frozenset[str]:
        """The symbols that ``x`` depends on."""
        if isinstance(x, Fraction):
            return self.dependence(x.num) | self.dependence(x.den)
        return frozenset().union(*(self.support(i) for i in self.used(x)))

    def is_constant(self, x: Poly | Fraction) -> bool:
        """Whether ``x`` depends on no symbol and on nothing opaque."""
        polys = (x.num, x.den) if isinstance(x, Fraction) else (x,)
        return all(
            not self.support(i) and self.at(i).kind != "opaque" for p in polys for i in self.used(p)
        )

    def ball(
        self,
        x: Poly | Fraction,
        point: Mapping[str, arb] | None = None,
        known: dict[int, arb] | None = None,
    ) -> arb:
        """``x`` in balls at ``point``; NaN where a generator has no value there.

        Args:
            known: values of generators at that point, which are used and added to.
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
            case _:
                return arb.nan()

    def text(self, x: Poly) -> str:
        """``x`` with the generators written as what they stand for."""
        result = str(x)
        for i in sorted(self.used(x), key=lambda i: -i):
            result = re.sub(rf"\bg{i}\b", self._name(self.at(i)), result)
        return result.replace("^", "**")

    def _name(self, generator: Generator) -> str:
        data = generator.data
        match generator.kind:
            case "symbol" | "opaque":
                return str(data[0])
            case "pi":
                return "pi"
            case "cosine":
                return f"(2*cos(pi/{data[0]}))"
            case "root":
                return f"abs({self.text(data[0])})**(1/{data[1]})"
            case "exp":
                return f"exp({self.fraction_text(data[2])}/{data[1]})"
            case "tan":
                return f"tan({self.fraction_text(data[2])}/{2 * data[1]})"
            case "cos" | "sin" as name:
                return f"{name}({self.fraction_text(data[2])}/{data[1]})"
            case "atan":
                return f"atan({self.fraction_text(data[0])})"
            case kind:
                return f"{kind}({self.text(data[0])})"

    def fraction_text(self, x: Fraction) -> str:
        """A fraction as :meth:`text` writes polynomials."""
        top = self.text(x.num)
        return top if x.den.is_one() else f"({top})/({self.text(x.den)})"

    # Signs as generators

    def sigma(self, f: Poly) -> Poly:
        """The sign of a canonical factor: ±1 where known, a product of other signs, or new."""
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

        The sign of a single part is used at once; where it stands in what has been found in this
        pass, a new one begins.

        A part that may vanish on a whole region without our knowing says nothing there of the
        other parts, be its exponent even or its sign known: such an equation is not used, unless
        ``strict`` tells that the product is nowhere zero.
        """
        keys: set[str] = set()
        for constant, _ in ((part, k) for part, k in parts if part.is_constant() and k % 2):
            sign *= 1 if constant.leading_coefficient() > 0 else -1
        parts = [(part, k) for part, k in parts if not part.is_constant()]
        for part in (part for part, k in parts if k % 2):
            known = self.sign(part)
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

    def is_mixed(self, p: Poly) -> bool:
        """Whether ``p`` may vanish on a whole region though its normal form is not zero.

        So it may where its generators depend on each other without our knowing: several inverse
        functions, roots within roots, values of unknown functions, sums with signs, arc tangents
        of tangents, constants that may be equal.
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
        """Whether inverse functions among these generators may depend on the others.

        A single logarithm or arc tangent does so only through signs, an arc tangent of tangents,
        or a logarithm of roots of exponentials: else tan(cx + d) or exp(cx + d) were algebraic
        over functions over which they are not. Logarithms of distinct irreducible polynomials in
        the symbols are independent (Ostrowski).
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
        """Whether no coefficient of ``p``, a number in constants, is shown to be other than 0."""
        constants = [i for i in self.used(p) if not self.support(i) and self.at(i).kind != "opaque"]
        if not constants:
            return False
        groups: dict[tuple[int, ...], dict[tuple[int, ...], fmpz]] = {}
        for monomial, value in p.terms():
            powers = [int(k) for k in monomial]
            outer = tuple(0 if i in constants else k for i, k in enumerate(powers))
            inner = tuple(k if i in constants else 0 for i, k in enumerate(powers))
            groups.setdefault(outer, {})[inner] = value
        rational = (0,) * self.size
        return not any(
            set(part) == {rational} or self._constant_sign(self.context.from_dict(part))
            for part in groups.values()
        )

    def varies(self, x: Fraction) -> bool:
        """Whether ``x``, of symbols and logarithms of their polynomials, is constant nowhere.

        Logarithms of distinct irreducible polynomials are algebraically independent over the
        rational functions on every region (Ostrowski), so ``x`` is constant on one region only if
        it is the same constant on all: two values apart exclude that.
        """
        for i in self.involved(x.num) | self.involved(x.den):
            generator = self.at(i)
            if generator.kind == "log":
                if any(self.at(j).kind != "symbol" for j in self.used(generator.data[0])):
                    return False
            elif generator.kind != "symbol":
                return False
        with ball_precision(SIGN_BITS):
            values = [
                self.ball(x, {name: arb(value) for name, value in point.items()})
                for point in Given().points(self.dependence(x), 4)
            ]
        finite = [value for value in values if value.is_finite()]
        return any(not value.overlaps(finite[0]) for value in finite[1:])

    def involved(self, p: Poly) -> set[int]:
        """The generators of ``p``, those inside them, and so on; constants left out."""
        found = {i for i in self.used(p) if self.support(i) or self.at(i).kind == "opaque"}
        for i in tuple(found):
            for item in self.at(i).data:
                if isinstance(item, Fraction):
                    found |= self.involved(item.num) | self.involved(item.den)
                elif isinstance(item, fmpz_mpoly):
                    found |= self.involved(item)
        return found

    def zero_divisor(
        self, num: Poly, den: Poly, position: int, parts: dict[int, Poly]
    ) -> tuple[Poly, Poly]:
        """``d·(1 ± σ)`` is not zero only where σ is ±1, and there it is ``2d``."""
        generator = self.at(position)
        for sign in (1, -1):
            if generator.kind == "sign" and self.reduce(parts[0] - sign * parts[1]).is_zero():
                self.require_sign([(generator.data[0], 1)], sign)
                return num, 2 * parts[0]
        return num, den

    def learn(self) -> bool:
        """Solve the sign equations of the pass; True if the pass has learnt anything."""
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
        """The equations in reduced row echelon form over GF(2)."""
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
        """The factor whose sign the others shall write: one without a generator, or the newest."""
        return max(keys, key=self._age)

    def _age(self, key: str) -> tuple[int, int]:
        if self.known("sign", key):
            return 0, -self.generator("sign", key).position
        return 1, self._met[key]

    def _settle(self, key: str) -> None:
        """Let the generator of a sign that is now known reduce to what it is."""
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

    def _narrow(self, p: Poly) -> None:
        """Use ``p > 0`` to narrow the range of a symbol in which it is linear and alone."""
        used = self.used(p)
        if len(used) != 1 or self.at(used[0]).kind != "symbol" or p.total_degree() != 1:
            return
        slope = p.derivative(used[0]).leading_coefficient()
        name = self.at(used[0]).data[0]
        constant = p - self.variables[used[0]] * slope
        end = -fmpq(fmpz(0) if constant.is_zero() else constant.leading_coefficient(), slope)
        was = self.box.get(name, Range())
        if slope > 0 and (was.low is None or end > was.low):
            self.box[name] = was._replace(low=end, pi_low=None)
        if slope < 0 and (was.high is None or end < was.high):
            self.box[name] = was._replace(high=end, pi_high=None)

    def _compare(self, first: str, second: str, sign: int) -> None:
        """Decide two factors of known product sign where their sum or difference has a sign."""
        p, q = self.polys[first], self.polys[second]
        if sign < 0:
            q = -q
        total = self.sign(self.reduce(p + q))
        if total:
            self._know(first, total)
            self._know(second, total * sign)

    # Proven signs

    def sign(self, p: Poly, depth: int = 0) -> int:
        """+1 or −1 where ``p`` is shown to have that sign on the open domain, else 0."""
        if p.is_zero():
            return 0
        if p.is_constant():
            return 1 if p.leading_coefficient() > 0 else -1
        if p.leading_coefficient() < 0:
            return -self.sign(-p, depth)
        key = str(p)
        if key in self.known_signs:
            return self.known_signs[key]
        if key not in self._signs:
            if depth >= self._tried.get(key, MAX_DEPTH + 1):
                return 0
            self._tried[key] = depth  # also keeps what is being tried from being tried again
            found = self._prove_sign(p, depth)
            if depth and not found:
                return 0
            self._signs[key] = found
        return self._signs[key]

    def _prove_sign(self, p: Poly, depth: int) -> int:
        self._trials = 0 if depth == 0 else self._trials + 1
        if len(p) > MAX_SIGN_TERMS or depth > MAX_DEPTH or self._trials > MAX_TRIALS:
            return 0
        if self.is_constant(p):
            return self._constant_sign(p)
        found = self.orthant_sign(p)
        if found or len(p) == 1 or (depth == 0 and self._changes_sign(p)):
            return found
        methods = (self._by_facts, self._by_discriminant, self._by_conjugate, self._by_cases)
        for method in methods:
            found = method(p, depth)
            if found:
                return found
        return 0

    def _changes_sign(self, p: Poly) -> bool:
        """Whether ``p`` is seen with both signs at points of the domain: no proof can be found."""
        if self._samples is None:
            points = [{name: arb(x) for name, x in point.items()} for point in self._find_points()]
            self._samples = [(point, {}) for point in points]
        seen = set()
        with ball_precision(64):
            for point, known in self._samples:
                value = self.ball(p, point, known)
                seen |= {value > 0} if value > 0 or value < 0 else set()
        return len(seen) == 2

    def definite(self, p: Poly) -> int:
        """The sign of ``p`` on the whole box of the conditions, by ranges alone, else 0.

        It holds at every point: a square that may vanish is not taken as positive.
        """
        self._everywhere = True
        try:
            with self._knowing(dict(self.given.box), {}, {}):
                return self.sign(p)
        finally:
            self._everywhere = False

    @contextmanager
    def _knowing(
        self, box: dict[str, Range], signs: dict[str, int], positives: dict[str, Poly]
    ) -> Iterator[None]:
        """For a while, only these ranges, signs and positive polynomials are known."""
        kept = self.box, self.known_signs, self.positives, self._signs, self._tried
        self.box, self.known_signs, self.positives = box, signs, positives
        self._signs, self._tried = {}, {}
        try:
            yield
        finally:
            self.box, self.known_signs, self.positives, self._signs, self._tried = kept

    def _by_cases(self, p: Poly, depth: int) -> int:
        """The sign of ``p`` where it is the same whichever value a sign in it has."""
        reduced = self.reduce(p)
        if reduced != p:  # a sign that has been settled since, or occurs squared
            return self.sign(reduced, depth + 1)
        for position in self.used(p):
            generator = self.at(position)
            if generator.kind != "sign":
                continue
            parts = self.split(p, position)
            found = set()
            for sign in (1, -1):
                fact = generator.data[0] * sign
                key = str(generator.data[0])
                case = parts.get(0, self.zero_poly) + sign * parts[1]
                signs, positives = {**self.known_signs, key: sign}, {**self.positives, key: fact}
                with self._knowing(dict(self.box), signs, positives):
                    self._narrow(fact)
                    found.add(self.product_sign(self.reduce(case), depth + 1))
                if found & {0} or len(found) > 1:
                    return 0
            return found.pop()
        return 0

    def _constant_sign(self, p: Poly) -> int:
        for bits in (64, SIGN_BITS, 4 * SIGN_BITS):
            with ball_precision(bits):
                value = self.ball(p)
            if value > 0:
                return 1
            if value < 0:
                return -1
        return 0

    def ends(self, position: int) -> Ends:
        """Rational ends of an open interval that contains the generator's values."""
        generator = self.at(position)
        match generator.kind:
            case "symbol":
                where = self.box.get(generator.data[0], Range())
                return where.low, where.high
            case "pi":
                return _PI_LOW, _PI_HIGH
            case "cosine":
                return self._numeric_ends(generator) or (None, None)
            case "root" | "exp":
                if not self.support(position):
                    return self._numeric_ends(generator) or (fmpq(0), None)
                return self._positive_ends(generator)
            case "log" | "tan" if not self.support(position):
                return self._numeric_ends(generator) or (None, None)
            case "tan":
                return self._tangent_ends(generator)
            case "sign" | "cos" | "sin":
                return fmpq(-9, 8), fmpq(9, 8)  # an open interval that contains ±1
            case "atan":
                return self._atan_ends(generator)
            case "log":
                return self._log_ends(generator)
            case _:
                return None, None

    def _numeric_ends(self, generator: Generator) -> Ends | None:
        with ball_precision(64):
            value = self._generator_ball(generator, {}, {})
            if not value.is_finite():
                return None
            low, high = fmpq(*_dyadic(value.lower())), fmpq(*_dyadic(value.upper()))
            slack = fmpq(1, 10**9) * (1 + abs(low))
            return low - slack, high + slack

    def _positive_ends(self, generator: Generator) -> Ends:
        """Ends of an exponential or a root, compared with 1."""
        if generator.kind == "exp":
            exponent = generator.data[2]
            above = self.sign(exponent.num, MAX_DEPTH) * self.sign(exponent.den, MAX_DEPTH)
        else:
            above = self._above_one(generator.data[0])
        return fmpq(1 if above > 0 else 0), fmpq(1) if above < 0 else None

    def _above_one(self, p: Poly) -> int:
        """The sign of ``|p| − 1``, 0 where that of ``p`` is not known."""
        own = self.sign(p, MAX_DEPTH)
        return self.sign(p * own - 1, MAX_DEPTH) if own else 0

    def _log_ends(self, generator: Generator) -> Ends:
        above = self._above_one(generator.data[0])
        return fmpq(0) if above > 0 else None, fmpq(0) if above < 0 else None

    def _tangent_ends(self, generator: Generator) -> Ends:
        """tan(angle/2) from the range of an angle that is a multiple of one symbol."""
        _, unit, angle = generator.data
        used = self.used(angle.num)
        if len(used) != 1 or self.at(used[0]).kind != "symbol" or not angle.den.is_constant():
            return None, None
        if angle.num.total_degree() != 1 or len(angle.num) != 1:
            return None, None
        slope = fmpq(angle.num.leading_coefficient(), angle.den.leading_coefficient() * unit)
        where = self.box.get(self.at(used[0]).data[0], Range())
        ends = [None if end is None else end * slope for end in (where.pi_low, where.pi_high)]
        low, high = ends if slope > 0 else reversed(ends)
        if low is None or high is None or low < -1 or high > 1:
            return None, None
        below = fmpq(0) if low >= 0 else fmpq(-1) if low >= fmpq(-1, 2) else None
        above = fmpq(0) if high <= 0 else fmpq(1) if high <= fmpq(1, 2) else None
        return below, above

    def _atan_ends(self, generator: Generator) -> Ends:
        argument = generator.data[0]
        sign = self.sign(argument.num, 1) * self.sign(argument.den, 1)
        return fmpq(0 if sign > 0 else -11, 7), fmpq(0 if sign < 0 else 11, 7)

    def orthant_sign(self, p: Poly) -> int:
        """The sign of all coefficients once every generator's range is mapped to (0, ∞)."""
        free: list[int] = []
        in_pi = self.known("pi", None) and p.degrees()[self.generator("pi", None).position] > 0
        for position in self.used(p):
            low, high = self.ends(position)
            if in_pi and self.at(position).kind == "atan":
                p = self._in_quarter_turns(p, position)
                low, high = (end and fmpq(1 if end > 0 else -1) for end in (low, high))
            if low == 0 and high is None:
                continue
            if low is None and high is None:
                free.append(position)
                continue
            p = self._mapped(p, position, low, high)
            if len(p) > 4 * MAX_SIGN_TERMS:
                return 0
        signs = {value > 0 for value in p.coeffs()}
        if len(signs) != 1:
            return 0
        if free and any(int(m[i]) % 2 for m in p.monoms() for i in free):
            return 0
        return 1 if signs == {True} else -1

    def _in_quarter_turns(self, p: Poly, position: int) -> Poly:
        """``p`` times a positive number, an arc tangent written as τ·π/2 and its place as τ."""
        pi, tau = self.variable(self.generator("pi", None)), self.variables[position]
        parts = self.split(p, position)
        degree = max(parts)
        result = self.zero_poly
        for k, part in parts.items():
            result = result + part * (pi * tau) ** k * 2 ** (degree - k)
        return result

    def _mapped(self, p: Poly, position: int, low: fmpq | None, high: fmpq | None) -> Poly:
        """``p`` times a positive factor, the generator's range (low, high) mapped to (0, ∞)."""
        u = self.variables[position]
        one = self.one_poly
        if low is not None and high is not None:
            scale = low.q * high.q
            top = self.context.constant((low * scale).p) + u * (high * scale).p
            bottom = (one + u) * scale
        elif low is not None:
            top, bottom = self.context.constant(low.p) + u * low.q, self.context.constant(low.q)
        else:
            assert high is not None
            top, bottom = self.context.constant(high.p) - u * high.q, self.context.constant(high.q)
        parts = self.split(p, position)
        degree = max(parts)
        result = self.zero_poly
        for k, part in parts.items():
            result = result + part * top**k * bottom ** (degree - k)
        return result

    def _by_facts(self, p: Poly, depth: int) -> int:
        """``p > 0`` as ``c·f`` plus something positive, for a known ``f > 0``."""
        facts = [f for f in list(self.positives.values())[:8] if not self.is_inverse(f)]
        for sign in (1, -1):
            for fact in facts:
                for n in range(min(6, len(fact))):
                    value, other = sign * fact.coefficient(n), p[fact.monomial(n)]
                    if other == 0 or (other > 0) != (value > 0):
                        continue
                    rest = p * (sign * abs(value)) - fact * abs(other)
                    if rest.is_zero() or self.orthant_sign(rest) > 0:
                        return sign
        return 0

    def _by_discriminant(self, p: Poly, depth: int) -> int:
        """A quadratic without two real roots, in a generator or its square, has one sign."""
        for position in self.used(p):
            low, high = self.ends(position)
            if low is not None and high is not None and self.at(position).kind != "symbol":
                continue
            degree = int(p.degrees()[position])
            if degree not in (2, 4):
                continue
            parts = self.split(p, position)
            step = degree // 2
            if not set(parts) <= {0, step, degree}:
                continue
            a, c = parts[degree], parts.get(0, self.zero_poly)
            b = parts.get(step, self.zero_poly)
            lead = self.sign(a, depth + 1)
            if not lead:
                continue
            rest = self.reduce(4 * a * c - b * b)
            if self.product_sign(rest, depth + 1) > 0 or (rest.is_zero() and not self._everywhere):
                return lead
        return 0

    def product_sign(self, p: Poly, depth: int = 0) -> int:
        """The sign of ``p`` from those of its factors, where its own is not proved."""
        found = self.sign(p, depth)
        if found or p.is_zero() or len(p) > MAX_SIGN_TERMS:
            return found
        unit, parts = small_factor(self, p)
        total = 1 if unit > 0 else -1
        if len(parts) > 1 or any(k > 1 for _, k in parts):
            for part, k in parts:
                found = self.sign(part, depth) if k % 2 or self._everywhere else 1
                total *= found if k % 2 else abs(found)
            return total
        return 0

    def _by_conjugate(self, p: Poly, depth: int) -> int:
        """The sign of ``u + v·A`` from those of u, v and of ``u² − v²A²``."""
        for position, degree, _ in self.relations:
            if degree != 2 or p.degrees()[position] != 1 or self.at(position).kind != "root":
                continue
            parts = self.split(p, position)
            if len(parts) != 2:
                continue
            first, second = self.sign(parts[0], depth + 1), self.sign(parts[1], depth + 1)
            if first == second != 0:
                return first
            x = self.variables[position]
            norm = self.reduce(parts[0] ** 2 - parts[1] ** 2 * x**2)
            size = self.product_sign(norm, depth + 1)
            if size > 0 and first:
                return first
            if size < 0 and second:
                return second
        return 0


def _dyadic(x: arb) -> tuple[fmpz, fmpz]:
    mantissa, exponent = x.man_exp()
    if exponent >= 0:
        return mantissa * fmpz(2) ** int(exponent), fmpz(1)
    return mantissa, fmpz(2) ** int(-exponent)
