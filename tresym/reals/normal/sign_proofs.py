"""Prove signs of polynomials in generators from ranges, conjugates, discriminants and facts.

For example, x + 1 − √(x² + 1) is positive for x > 0: with A the root, u + v·A for u = x + 1 and
v = −1 has the sign of u, because u > 0 and u² − v²A² = 2x is positive too. The methods, tried in
this order, are

- the ranges of the single generators: with every range mapped to [0, ∞], all coefficients have one
  sign (the criterion behind Descartes' rule of signs; Basu, Pollack, Roy, *Algorithms in Real
  Algebraic Geometry*, §10.2);
- a known fact f > 0: the polynomial is c·f plus something positive;
- a quadratic without real roots; a conjugate, as in the example; the two cases of a sign;
- a monotone function: an arc tangent has the sign of its argument, ``±π/2 + r·atan u`` with
  ``|r| ≤ 1`` that of its first term, and ``Σ nᵢ log|fᵢ|`` that of ``Π |fᵢ|^nᵢ − 1``.

A sign proved here holds on the open part of the domain, where no factor vanishes.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager

from flint import arb, fmpq, fmpz

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.sample_points import Range
from tresym.reals.normal.box import coefficient_sign, quadratic_sign
from tresym.reals.normal.ring import Fraction, Generator, Poly, Ring, small_factor
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import Interval, rational_ends
from tresym.reals.numbers.factoring import TooLargeError

MAX_SIGN_TERMS = 60
MAX_DEPTH = 4
MAX_TRIALS = 60
MAX_MULTIPLE = 12
_PI_LOW, _PI_HIGH = fmpq(103993, 33102), fmpq(104348, 33215)

Ends = tuple[fmpq | None, fmpq | None]


class SignProver:
    """Proves signs of the polynomials of a ring, and remembers them.

    Attributes:
        ring: the ring.
        given: the conditions.
        box: the range of each symbol.
        known_signs: the signs that were learnt, by the text of the polynomial.
        positives: the polynomials with these signs, made positive.
        has_points: whether points of the domain are known.
    """

    def __init__(
        self,
        ring: Ring,
        given: Given,
        points: Callable[[], Iterable[Mapping[str, fmpq]]] = tuple,
    ) -> None:
        """Prepare to prove signs under ``given``.

        Args:
            ring: the ring.
            given: the conditions.
            points: yields points of the domain. A polynomial that takes both signs there has no
                sign to prove.
        """
        self.ring = ring
        self.given = given
        self.has_points = points is not tuple
        self._find_points = points
        self._more: Iterator[Mapping[str, fmpq]] | None = None
        self._samples: list[tuple[dict[str, arb], dict[int, arb]]] = []
        self.box: dict[str, Range] = dict(given.box)
        self.known_signs: dict[str, int] = {}
        self.positives: dict[str, Poly] = {}
        self._signs: dict[str, int] = {}
        self._trials = 0
        self._everywhere = False
        self._tried: dict[str, int] = {}  # the smallest depth at which no sign was proved

    def sign(self, p: Poly, depth: int = 0) -> int:
        """Return +1 or −1 if ``p`` is shown to have that sign on the open domain, else 0.

        Args:
            p: the polynomial.
            depth: the recursion depth, which is bounded by :data:`MAX_DEPTH`.
        """
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
            self._tried[key] = depth  # this also prevents infinite recursion
            sign = self._prove(p, depth)
            if depth and not sign:
                return 0
            self._signs[key] = sign
        return self._signs[key]

    def quick_sign(self, p: Poly) -> int:
        """Return the sign of ``p`` if it is known or follows from ranges, else 0."""
        key = str(p)
        return self.known_signs.get(key) or self._signs.get(key) or self.orthant_sign(p)

    def know(self, p: Poly, sign: int) -> None:
        """Record the sign of ``p`` as a fact, and narrow the range of a symbol by it."""
        key = str(p)
        self.known_signs[key] = sign
        self.positives[key] = p if sign > 0 else -p
        self._narrow(self.positives[key])

    def forget_failures(self) -> None:
        """Allow new proofs of signs that were not proved: facts learnt since then may help."""
        self._tried = {}
        self._signs = {key: sign for key, sign in self._signs.items() if sign}

    def _prove(self, p: Poly, depth: int) -> int:
        sign = self._prove_directly(p, depth)
        inner = self.same_sign(p) if not sign and depth < MAX_DEPTH else None
        return sign if inner is None else self.product_sign(inner, depth + 1)

    def _prove_directly(self, p: Poly, depth: int) -> int:
        self._trials = 0 if depth == 0 else self._trials + 1
        if len(p) > MAX_SIGN_TERMS or depth > MAX_DEPTH or self._trials > MAX_TRIALS:
            return 0
        if self.ring.is_constant(p):
            return self.ring.constant_sign(p)
        sign = self.orthant_sign(p)
        if sign or len(p) == 1 or (depth == 0 and self._changes_sign(p)):
            return sign
        methods = (self._by_facts, self._by_discriminant, self._by_conjugate, self._by_cases)
        for method in methods:
            sign = method(p, depth)
            if sign:
                return sign
        return 0

    def _changes_sign(self, p: Poly) -> bool:
        """Return whether ``p`` takes both signs at sample points, so that no proof exists."""
        seen = set()
        for point, known in self._sampled():
            with ball_precision(64):
                value = self.ring.ball(p, point, known)
            seen |= {value > 0} if value > 0 or value < 0 else set()
            if len(seen) == 2:
                return True
        return False

    def _sampled(self) -> Iterator[tuple[dict[str, arb], dict[int, arb]]]:
        """Yield points of the domain, found on demand, with the known values of generators."""
        yield from self._samples
        if self._more is None:
            self._more = iter(self._find_points())
        for point in self._more:
            self._samples.append(({name: arb(x) for name, x in point.items()}, {}))
            yield self._samples[-1]

    def definite(self, p: Poly) -> int:
        """Return the sign of ``p`` on the whole box of the conditions, from ranges alone, else 0.

        The sign holds at every point: a square that may vanish does not count as positive.
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
        """Replace the known ranges, signs and positive polynomials within a ``with`` block."""
        kept = self.box, self.known_signs, self.positives, self._signs, self._tried
        self.box, self.known_signs, self.positives = box, signs, positives
        self._signs, self._tried = {}, {}
        try:
            yield
        finally:
            self.box, self.known_signs, self.positives, self._signs, self._tried = kept

    # Ranges

    def ends(self, position: int) -> Ends:
        """Return rational ends of an open interval that contains the values of the generator."""
        generator = self.ring.at(position)
        match generator.kind:
            case "symbol":
                where = self.box.get(generator.data[0], Range())
                return where.low, where.high
            case "pi":
                return _PI_LOW, _PI_HIGH
            case "cosine":
                return self._numeric_ends(generator) or (None, None)
            case "root" | "exp":
                if not self.ring.support(position):
                    return self._numeric_ends(generator) or (fmpq(0), None)
                return self._positive_ends(generator)
            case "log" | "tan" if not self.ring.support(position):
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

    def _numeric_ends(self, generator: Generator) -> tuple[fmpq, fmpq] | None:
        with ball_precision(64):
            return self._outward(self.ring.generator_ball(generator, {}, {}))

    @staticmethod
    def _outward(value: arb) -> tuple[fmpq, fmpq] | None:
        """Return rational ends of an open interval that contains a ball."""
        low, high = rational_ends(value)[:2]
        if low is None or high is None:
            return None
        slack = fmpq(1, 10**9) * (1 + abs(low))
        return low - slack, high + slack

    def _positive_ends(self, generator: Generator) -> Ends:
        """Return the ends of an exponential or a root, by comparison with 1."""
        if generator.kind == "exp":
            exponent = generator.data[2]
            above = self.sign(exponent.num, MAX_DEPTH) * self.sign(exponent.den, MAX_DEPTH)
        else:
            above = self._above_one(generator.data[0])
        return fmpq(1 if above > 0 else 0), fmpq(1) if above < 0 else None

    def _above_one(self, p: Poly) -> int:
        """Return the sign of ``|p| − 1``, or 0 if that of ``p`` is not known."""
        own = self.sign(p, MAX_DEPTH)
        return self.sign(p * own - 1, MAX_DEPTH) if own else 0

    def _log_ends(self, generator: Generator) -> Ends:
        above = self._above_one(generator.data[0])
        return fmpq(0) if above > 0 else None, fmpq(0) if above < 0 else None

    def _tangent_ends(self, generator: Generator) -> Ends:
        """Return the ends of tan(angle/2) from the range of the angle."""
        turns = self._half_turns(generator)
        if turns is None:
            return None, None
        low, high = turns
        below = fmpq(0) if low >= 0 else fmpq(-1) if low >= fmpq(-1, 2) else None
        above = fmpq(0) if high <= 0 else fmpq(1) if high <= fmpq(1, 2) else None
        return below, above

    def has_no_pole(self, generator: Generator) -> bool:
        """Return whether tan(angle/2) is shown to be finite on the whole box of the conditions."""
        with self._knowing(dict(self.given.box), {}, {}):
            return self._half_turns(generator) is not None

    def _half_turns(self, generator: Generator) -> tuple[fmpq, fmpq] | None:
        """Return bounds of angle/π minus an even number if they lie in [−1, 1], else None."""
        _, unit, angle = generator.data
        ends = self._over_pi(angle)
        if ends is None:
            return None
        low, high = ends[0] / unit, ends[1] / unit
        middle = (low + high + 2) / 4
        turns = 2 * (middle.p // middle.q)
        return (low - turns, high - turns) if turns - 1 <= low and high <= turns + 1 else None

    def _over_pi(self, x: Fraction) -> tuple[fmpq, fmpq] | None:
        """Return rational bounds of x/π, exact ones if ``x`` is linear in symbols."""
        boxes = {name: self.box.get(name, Range()) for name in self.ring.dependence(x)}
        if not boxes or any(b.low is None or b.high is None for b in boxes.values()):
            return None
        linear = x.den.is_constant() and x.num.total_degree() == 1
        if not linear or any(self.ring.at(i).kind != "symbol" for i in self.ring.used(x.num)):
            with ball_precision(64):
                at = {name: arb(b.low).union(arb(b.high)) for name, b in boxes.items()}
                return self._outward(self.ring.ball(x, at) / arb.pi())
        ends = [fmpq(0), fmpq(0)]
        for monomial, value in x.num.terms():
            slope = fmpq(value, x.den.leading_coefficient())
            if not any(monomial):
                pair = (_over_pi(slope, True), _over_pi(slope, False))
            else:
                name = self.ring.at(next(i for i, k in enumerate(monomial) if k)).data[0]
                where = boxes[name]
                turns = self.given.half_turns.get(name, Range())
                low, high = _over_pi(where.low, True), _over_pi(where.high, False)
                low = low if turns.low is None else max(low, turns.low)
                high = high if turns.high is None else min(high, turns.high)
                pair = (slope * low, slope * high) if slope > 0 else (slope * high, slope * low)
            ends = [end + more for end, more in zip(ends, pair, strict=True)]
        return ends[0], ends[1]

    def _atan_ends(self, generator: Generator) -> Ends:
        argument = generator.data[0]
        sign = self.sign(argument.num, 1) * self.sign(argument.den, 1)
        return fmpq(0 if sign > 0 else -11, 7), fmpq(0 if sign < 0 else 11, 7)

    def _narrow(self, p: Poly) -> None:
        """Use ``p > 0`` to narrow the range of a symbol, if ``p`` is linear and has no other."""
        used = self.ring.used(p)
        if len(used) != 1 or self.ring.at(used[0]).kind != "symbol" or p.total_degree() != 1:
            return
        slope = p.derivative(used[0]).leading_coefficient()
        name = self.ring.at(used[0]).data[0]
        constant = p - self.ring.variables[used[0]] * slope
        end = -fmpq(fmpz(0) if constant.is_zero() else constant.leading_coefficient(), slope)
        half = Interval(end, None, True) if slope > 0 else Interval(None, end, False, True)
        self.box[name] = self.box.get(name, Range()) & half

    # Ways to prove a sign

    def orthant_sign(self, p: Poly) -> int:
        """Return the sign that follows from the ranges of the single generators, else 0."""
        spans = [Interval()] * self.ring.size
        in_pi = (
            self.ring.known("pi", None)
            and p.degrees()[self.ring.generator("pi", None).position] > 0
        )
        for position in self.ring.used(p):
            low, high = self.ends(position)
            if in_pi and self.ring.at(position).kind == "atan":
                p = self._in_quarter_turns(p, position)
                low, high = (end and fmpq(1 if end > 0 else -1) for end in (low, high))
            spans[position] = Interval(low, high, True, True)
        return self._as_number(coefficient_sign(p, spans))

    def _as_number(self, sign: str | None) -> int:
        """Return ±1 for a sign that holds off the zeros (or everywhere, if required); else 0."""
        strict = {"+": 1, "-": -1}
        return (strict if self._everywhere else {**strict, ">=0": 1, "<=0": -1}).get(sign or "", 0)

    def _by_discriminant(self, p: Poly, depth: int) -> int:
        """Return the sign of a quadratic without real roots in a generator or its square."""

        def ask(q: Poly) -> str | None:
            rest = self.ring.reduce(q)
            return "0" if rest.is_zero() else (None, "+", "-")[self.product_sign(rest, depth + 1)]

        signs = (self._as_number(quadratic_sign(p, i, ask)) for i in self.ring.used(p))
        return next(filter(None, signs), 0)

    def _in_quarter_turns(self, p: Poly, position: int) -> Poly:
        """Return ``p`` times a positive number, with an arc tangent written as τ·π/2."""
        pi, tau = self.ring.variable(self.ring.generator("pi", None)), self.ring.variables[position]
        parts = self.ring.split(p, position)
        degree = max(parts)
        result = self.ring.zero_poly
        for k, part in parts.items():
            result = result + part * (pi * tau) ** k * 2 ** (degree - k)
        return result

    def _by_facts(self, p: Poly, depth: int) -> int:
        """Write ``p`` or ``−p`` as ``c·f`` plus a positive rest, for a known fact ``f > 0``."""
        facts = [f for f in list(self.positives.values())[:8] if not self.ring.is_inverse(f)]
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

    def product_sign(self, p: Poly, depth: int = 0) -> int:
        """Return the sign of ``p``, from those of its factors if it is not proved directly."""
        direct = self.sign(p, depth)
        if direct or p.is_zero() or len(p) > MAX_SIGN_TERMS:
            return direct
        unit, parts = small_factor(self.ring, p)
        total = 1 if unit > 0 else -1
        if len(parts) > 1 or any(k > 1 for _, k in parts):
            for part, k in parts:
                sign = self.sign(part, depth) if k % 2 or self._everywhere else 1
                total *= sign if k % 2 else abs(sign)
            return total
        return 0

    def _by_conjugate(self, p: Poly, depth: int) -> int:
        """Return the sign of ``u + v·A`` from those of u, v and ``u² − v²A²``."""
        for position, degree, _ in self.ring.relations:
            if degree != 2 or p.degrees()[position] != 1 or self.ring.at(position).kind != "root":
                continue
            parts = self.ring.split(p, position)
            if len(parts) != 2:
                continue
            first, second = self.sign(parts[0], depth + 1), self.sign(parts[1], depth + 1)
            if first == second != 0:
                return first
            x = self.ring.variables[position]
            norm = self.ring.reduce(parts[0] ** 2 - parts[1] ** 2 * x**2)
            size = self.product_sign(norm, depth + 1)
            if size > 0 and first:
                return first
            if size < 0 and second:
                return second
        return 0

    def _by_cases(self, p: Poly, depth: int) -> int:
        """Return the sign of ``p`` if it is the same for both values of a sign in it."""
        reduced = self.ring.reduce(p)
        if reduced != p:  # a sign became known in the meantime, or occurs squared
            return self.sign(reduced, depth + 1)
        for position in self.ring.used(p):
            generator = self.ring.at(position)
            if generator.kind != "sign":
                continue
            parts = self.ring.split(p, position)
            signs = set()
            for sign in (1, -1):
                fact = generator.data[0] * sign
                key = str(generator.data[0])
                case = parts.get(0, self.ring.zero_poly) + sign * parts[1]
                known, positives = {**self.known_signs, key: sign}, {**self.positives, key: fact}
                with self._knowing(dict(self.box), known, positives):
                    self._narrow(fact)
                    signs.add(self.product_sign(self.ring.reduce(case), depth + 1))
                if signs & {0} or len(signs) > 1:
                    return 0
            return signs.pop()
        return 0

    # Inverse functions

    def same_sign(self, p: Poly) -> Poly | None:
        """Return a polynomial with the sign of ``p`` everywhere, without its outermost inverse
        functions.

        None is returned if ``p`` does not have one of these forms, or if the sign of an ``fᵢ`` is
        not known.
        """
        kinds = {self.ring.at(i).kind for i in self.ring.used(p)}
        inner = None
        if kinds == {"log"} and p.total_degree() == 1:
            inner = self._of_logarithms(p)
        elif len(p) <= 2 and "atan" in kinds and kinds <= {"atan", "pi", "sign"}:
            inner = self._of_arc_tangents(p)
        return None if inner is None else self.ring.reduce(inner)

    def _of_logarithms(self, p: Poly) -> Poly | None:
        content = p.content()
        product = self.ring.one
        for monomial, value in p.terms():
            if not any(monomial) or abs(value) > MAX_MULTIPLE * content:
                return None
            inner = self.ring.at(next(i for i, k in enumerate(monomial) if k)).data[0]
            sign = self.sign(inner, 1)
            if not sign:
                return None
            try:
                product = product * self.ring.fraction(sign * inner) ** int(value // content)
            except TooLargeError:
                return None
        below = self.product_sign(product.den, 1)
        return below * (product.num - product.den) if below else None

    def _of_arc_tangents(self, p: Poly) -> Poly | None:
        alone: Poly | None = None
        parts: dict[str, tuple[Poly, fmpz]] = {}
        for monomial, value in p.terms():
            used = [(i, k) for i, k in enumerate(monomial) if k and self.ring.at(i).kind != "sign"]
            if len(used) != 1 or used[0][1] != 1:
                return None
            generator = self.ring.at(used[0][0])
            whole = self.ring.context.from_dict({tuple(map(int, monomial)): 1})
            signs = whole // self.ring.variable(generator)
            parts[generator.kind] = (signs, value)
            if generator.kind == "atan":
                alone = generator.data[0].num * generator.data[0].den * signs * value
        if len(parts) != len(p):
            return None
        if "pi" not in parts:
            return alone
        signs, value = parts["pi"]
        return signs * value if abs(parts["atan"][1]) <= 2 * abs(value) else None


def _over_pi(x: fmpq, down: bool) -> fmpq:
    """Return a number below ``x/π``, or above it."""
    return x / (_PI_HIGH if (x > 0) == down else _PI_LOW)
