"""Normalise sines and cosines by t = tan(angle/2), for a rational basis of the angles that occur.

Multiples of π, arc tangents and halves of them are first split off an angle. An angle that may be
an odd multiple of π on a whole region, where t is infinite, keeps its cosine and sine as
generators.
"""

from __future__ import annotations

from math import comb, lcm

from flint import arb, fmpq, fmpz_poly

from tresym.reals.normal.powers import PowerRing
from tresym.reals.normal.ring import Fraction, Generator, Poly
from tresym.reals.normal.sign_equations import AgainError
from tresym.reals.numbers.arithmetic import WORKING, ball_precision
from tresym.reals.numbers.factoring import TooLargeError

MAX_HALF_TURN = 720
MAX_MULTIPLE = 96


class AngleRing(PowerRing):
    """A ring with cosines and sines of its elements; every angle is a pair (cosine, sine)."""

    _half_turn = 1
    """The number M such that 2cos(π/M) generates all cosines of rational multiples of π."""
    _twelfths = False
    """Whether cosines of multiples of π/12 were written with roots; only while M is 1."""

    def pi(self, r: fmpq) -> Fraction:
        """Return r·π."""
        return self.fraction(self.generator("pi", None)) * r

    def _turn(self, x: Fraction) -> tuple[Fraction, Fraction]:
        """Return the cosine and sine of ``x``."""
        result = (self.one, self.zero)
        parts = self._by_signs(x)
        if parts is not None:
            for sign, part in parts:
                c, s = self._turn(part)
                result = self._rotate(result, (c, s * sign))
            return result
        rest, half_turns = self._split_pi(x)
        for sign, r in half_turns:
            c, s = self.turn_of_pi(r)
            result = self._rotate(result, (c, s * sign))
        rest, inverses = self._split_atan(rest)
        for generator, sign, r in inverses:
            if (2 * r).q == 1 and abs(r) < 40:
                step = self._turn_of_atan(generator.data[0], half=r.q == 2)
                c, s = self._turn_power(step, int((r * r.q).p))
                result = self._rotate(result, (c, s * sign))
            else:
                rest = rest + self.fraction(generator) * r * sign
        if self._may_be_odd_turn(rest):
            return self._rotate(result, self._plain_turn(rest))
        for index, r in self._decompose("tan", rest):
            unit = self._unit("tan", index, int(r.q))
            angle = self._basis["tan"][index]
            t = self.variable(self.generator("tan", (index, unit), (index, unit, angle)))
            n = int(r.p * (unit // r.q))
            result = self._rotate(result, self._turn_of_half_tangent(t, n))
        return result

    def _rotate(
        self, x: tuple[Fraction, Fraction], y: tuple[Fraction, Fraction]
    ) -> tuple[Fraction, Fraction]:
        """Return the product of two complex numbers."""
        (a, b), (c, d) = x, y
        return a * c - b * d, a * d + b * c

    def _turn_power(self, x: tuple[Fraction, Fraction], n: int) -> tuple[Fraction, Fraction]:
        """Return the n-th power of a complex number of modulus 1."""
        c, s = x if n >= 0 else (x[0], -x[1])
        result = (self.one, self.zero)
        for _ in range(abs(n)):
            result = self._rotate(result, (c, s))
        return result

    def _turn_of_half_tangent(self, t: Poly, n: int) -> tuple[Fraction, Fraction]:
        """Return the cosine and sine of nθ from t = tan(θ/2), as (1 + it)^(2n)/(1 + t²)^n."""
        m = abs(n)
        if m > MAX_MULTIPLE:
            raise TooLargeError("a multiple of an angle beyond 96")
        real, imaginary = self.zero_poly, self.zero_poly
        for k in range(2 * m + 1):
            term = (-1) ** (k // 2) * comb(2 * m, k) * t**k
            if k % 2:
                imaginary = imaginary + term
            else:
                real = real + term
        den = (1 + t * t) ** m
        if n < 0:
            imaginary = -imaginary
        return self.make(real, den), self.make(imaginary, den)

    def _turn_of_atan(self, u: Fraction, half: bool) -> tuple[Fraction, Fraction]:
        """Return the cosine and sine of atan(u), or of half of it."""
        square = 1 + u**2
        self._require_positive(square)
        c = self._root(square, fmpq(-1, 2))
        if not half:
            return c, u * c
        middle = (1 + c) / 2
        half_c = self._root(middle, fmpq(1, 2))
        return half_c, u * c / 2 / half_c

    def _may_be_odd_turn(self, x: Fraction) -> bool:
        """Return whether an angle may be an odd multiple of π on a whole region.

        The tangent of half the angle would be infinite there. The answer is no only for a constant
        that balls separate from such multiples, and for a non-constant angle whose generators are
        independent.
        """
        used = set(self.used(x))
        if used and self.is_constant(x):
            return bool((self.ball(x) / arb.pi() / 2).cos_pi().contains(0))
        used |= self.involved(x)
        kinds = {self.at(i).kind for i in used}
        return self.are_tied(used) or bool(kinds & {"opaque", "cos", "sin", "sign"})

    def _plain_turn(self, x: Fraction) -> tuple[Fraction, Fraction]:
        """Return the cosine and sine of ``x`` as generators whose only relation is c² + s² = 1."""
        result = (self.one, self.zero)
        for index, r in self._decompose("turn", x):
            unit = self._unit("turn", index, int(r.q))
            data = (index, unit, self._basis["turn"][index])
            c, s = (self.generator(kind, (index, unit), data) for kind in ("cos", "sin"))
            self.relate(s, 2, self.one_poly - self.variable(c) ** 2)
            n = int(r.p * (unit // r.q))
            if abs(n) > MAX_MULTIPLE:
                raise TooLargeError("a multiple of an angle beyond 96")
            step = self.fraction(c), self.fraction(s)
            result = self._rotate(result, self._turn_power(step, n))
        return result

    def _split_atan(self, x: Fraction) -> tuple[Fraction, list[tuple[Generator, Fraction, fmpq]]]:
        """Split off arc tangents with a rational coefficient, or with a sign as a factor."""
        x, plain = self.linear_part(x, "atan")
        x, signed = self._without_signed(x, "atan")
        return x, [*((generator, self.one, r) for generator, r in plain), *signed]

    def _split_pi(self, x: Fraction) -> tuple[Fraction, list[tuple[Fraction, fmpq]]]:
        """Split off rational multiples of π, with or without signs as factors.

        Returns:
            The rest of ``x``, and pairs of a sign (or 1) and a rational coefficient.
        """
        if not self.known("pi", None):
            return x, []
        x, plain = self.linear_part(x, "pi")
        x, signed = self._without_signed(x, "pi")
        return x, [*((self.one, r) for _, r in plain), *((sign, r) for _, sign, r in signed)]

    def _without_signed(
        self, x: Fraction, kind: str
    ) -> tuple[Fraction, list[tuple[Generator, Fraction, fmpq]]]:
        """Split off all generators of ``kind`` that are multiplied by products of signs."""
        pieces = []
        for generator, sign, r in self._signed_multiples(x, kind):
            signs = all(self.at(i).kind == "sign" for i in self.used(sign)) and len(sign) == 1
            if signs and sign.leading_coefficient() == 1 and generator.kind == kind:
                pieces.append((generator, self.fraction(sign), r))
                x = x - self.fraction(generator) * r * sign
        return x, pieces

    def _signed_multiples(self, x: Fraction, kind: str) -> list[tuple[Generator, Poly, fmpq]]:
        """Return the terms of ``x`` that contain exactly one generator of ``kind``, linearly."""
        found = []
        for monomial, value in x.num.terms() if x.den.is_constant() else ():
            used = [self.at(i) for i, k in enumerate(monomial) if k]
            these = [g for g in used if g.kind == kind and monomial[g.position] == 1]
            if len(these) == 1:
                rest = self.context.from_dict({tuple(map(int, monomial)): 1})
                r = fmpq(value, x.den.leading_coefficient())
                found.append((these[0], rest // self.variable(these[0]), r))
        return found

    # Rational multiples of π

    def turn_of_pi(self, r: fmpq) -> tuple[Fraction, Fraction]:
        """Return the cosine and sine of rπ."""
        if r == 0:
            return self.one, self.zero
        if 12 % int(r.q) == 0 and self._half_turn == 1:
            self._twelfths = True
            return self._turn_power(self._twelfth(12 // int(r.q)), int(r.p % (2 * r.q)))
        return self._cyclotomic(r)

    def _cyclotomic(self, r: fmpq) -> tuple[Fraction, Fraction]:
        """Return the cosine and sine of rπ as polynomials in z = 2cos(π/M), M even."""
        old = self._half_turn
        m = lcm(old, 2 * int(r.q))
        if m > MAX_HALF_TURN:
            raise TooLargeError(f"an angle of pi/{m}")
        self._half_turn = m
        if m != old and (old != 1 or self._twelfths):
            raise AgainError
        generator = self.generator("cosine", m, (m,))
        z = self.variable(generator)
        if not any(position == generator.position for position, _, _ in self.relations):
            minimal = _minimal(m)
            tail = self.zero_poly
            for k in range(minimal.degree()):
                tail = tail - z**k * minimal[k]
            self.relate(generator, minimal.degree(), tail)
        k = int((r * m).p) % (2 * m)
        return self._chebyshev(z, k), self._chebyshev(z, m // 2 - k)

    def _chebyshev(self, z: Poly, k: int) -> Fraction:
        """Return the cosine of kπ/M from z = 2cos(π/M), by the Chebyshev recurrence."""
        low, high = self.context.constant(2), z
        for _ in range(abs(k)):
            low, high = high, self.reduce(z * high - low)
        return self.make(low, self.context.constant(2))

    def _twelfth(self, k: int) -> tuple[Fraction, Fraction]:
        """Return the cosine and sine of kπ/12 for k = 1, 2, 3, 4, 6, 12."""
        two, three = (self._root(self.fraction(n), fmpq(1, 2)) for n in (2, 3))
        match k:
            case 1:
                return two * (three + 1) / 4, two * (three - 1) / 4
            case 2:
                return three / 2, self.fraction(fmpq(1, 2))
            case 3:
                return two / 2, two / 2
            case 4:
                return self.fraction(fmpq(1, 2)), three / 2
            case 6:
                return self.zero, self.one
            case _:
                return self.fraction(-1), self.zero


def _minimal(m: int) -> fmpz_poly:
    """Return FLINT's minimal polynomial of z = 2cos(π/m), after proving that z is a zero of it.

    It divides the polynomial sin(mθ)/sin θ in 2cos θ, which vanishes at θ = π/m, and balls show
    that the quotient does not vanish there.

    Raises:
        ArithmeticError: the proof fails.
    """
    found, x = fmpz_poly.cos_minpoly(2 * m), fmpz_poly([0, 1])
    before, sines = fmpz_poly([0]), fmpz_poly([1])
    for _ in range(m - 1):
        before, sines = sines, x * sines - before
    quotient, rest = divmod(sines, found)
    with ball_precision(8 * WORKING):
        if rest == 0 and not quotient(2 * arb.cos_pi_fmpq(fmpq(1, m))).contains(0):
            return found
    raise ArithmeticError(f"FLINT's minimal polynomial of 2*cos(pi/{m}) could not be verified")
