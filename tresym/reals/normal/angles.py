"""Normalise sines and cosines by t = tan(angle/2), for a rational basis of the angles that occur.

Multiples of π, arc tangents and halves of them are first split off an angle. An angle that may be
an odd multiple of π on a whole region, where t is infinite, keeps its cosine and sine as
generators.

For example, with t = tan(x/2) both sin(x)² and 1 − cos(x)² become 4t²/(1 + t²)². A cosine of a
rational multiple of π is a polynomial in 2cos(π/M), whose minimal polynomial is its relation
(Watkins and Zeitlin, *The minimal polynomial of cos(2π/n)*, Amer. Math. Monthly 100, 1993).
"""

from __future__ import annotations

from math import comb, lcm

from flint import arb, fmpq, fmpz_poly

from tresym.reals.normal.powers import Powers
from tresym.reals.normal.rational_basis import RationalBasis
from tresym.reals.normal.ring import AgainError, Fraction, Generator, Poly
from tresym.reals.numbers.arithmetic import WORKING, ball_precision
from tresym.reals.numbers.factoring import TooLargeError

MAX_HALF_TURN = 720
MAX_MULTIPLE = 96


class Angles:
    """Cosines and sines of the elements of a ring; every angle is a pair (cosine, sine)."""

    def __init__(self, powers: Powers) -> None:
        """Prepare angles in the ring of ``powers``, with which roots are taken."""
        self.ring = powers.ring
        self.powers = powers
        self.equations = powers.equations
        self._angles = RationalBasis(self.ring)  # with a tangent of half the angle
        self._plain_angles = RationalBasis(self.ring)  # with a cosine and a sine
        self._half_turn = 1  # M: 2cos(π/M) generates all cosines of rational multiples of π
        self._twelfths = False  # whether multiples of π/12 were written with roots, while M is 1

    def pi(self, r: fmpq) -> Fraction:
        """Return r·π."""
        return self.ring.fraction(self.ring.generator("pi", None)) * r

    def turn(self, x: Fraction) -> tuple[Fraction, Fraction]:
        """Return the cosine and sine of ``x``."""
        result = (self.ring.one, self.ring.zero)
        parts = self.ring.by_signs(x)
        if parts is not None:
            for sign, part in parts:
                c, s = self.turn(part)
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
                rest = rest + self.ring.fraction(generator) * r * sign
        if self._may_be_odd_turn(rest):
            return self._rotate(result, self._plain_turn(rest))
        for index, r in self._angles.combination(rest):
            unit = self._angles.unit(index, int(r.q))
            angle = self._angles.elements[index]
            t = self.ring.variable(self.ring.generator("tan", (index, unit), (index, unit, angle)))
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
        result = (self.ring.one, self.ring.zero)
        for _ in range(abs(n)):
            result = self._rotate(result, (c, s))
        return result

    def _turn_of_half_tangent(self, t: Poly, n: int) -> tuple[Fraction, Fraction]:
        """Return the cosine and sine of nθ from t = tan(θ/2), as (1 + it)^(2n)/(1 + t²)^n."""
        m = abs(n)
        if m > MAX_MULTIPLE:
            raise TooLargeError("a multiple of an angle beyond 96")
        real, imaginary = self.ring.zero_poly, self.ring.zero_poly
        for k in range(2 * m + 1):
            term = (-1) ** (k // 2) * comb(2 * m, k) * t**k
            if k % 2:
                imaginary = imaginary + term
            else:
                real = real + term
        den = (1 + t * t) ** m
        if n < 0:
            imaginary = -imaginary
        return self.ring.make(real, den), self.ring.make(imaginary, den)

    def _turn_of_atan(self, u: Fraction, half: bool) -> tuple[Fraction, Fraction]:
        """Return the cosine and sine of atan(u), or of half of it."""
        square = 1 + u**2
        self.equations.require_positive(square)
        c = self.powers.root(square, fmpq(-1, 2))
        if not half:
            return c, u * c
        middle = (1 + c) / 2
        half_c = self.powers.root(middle, fmpq(1, 2))
        return half_c, u * c / 2 / half_c

    def _may_be_odd_turn(self, x: Fraction) -> bool:
        """Return whether an angle may be an odd multiple of π on a whole region.

        The tangent of half the angle would be infinite there. The answer is no only for a constant
        that balls separate from such multiples, and for a non-constant angle whose generators are
        independent.
        """
        used = set(self.ring.used(x))
        if used and self.ring.is_constant(x):
            return bool((self.ring.ball(x) / arb.pi() / 2).cos_pi().contains(0))
        used |= self.ring.involved(x)
        kinds = {self.ring.at(i).kind for i in used}
        return self.ring.are_tied(used) or bool(kinds & {"opaque", "cos", "sin", "sign"})

    def _plain_turn(self, x: Fraction) -> tuple[Fraction, Fraction]:
        """Return the cosine and sine of ``x`` as generators whose only relation is c² + s² = 1."""
        result = (self.ring.one, self.ring.zero)
        for index, r in self._plain_angles.combination(x):
            unit = self._plain_angles.unit(index, int(r.q))
            data = (index, unit, self._plain_angles.elements[index])
            c, s = (self.ring.generator(kind, (index, unit), data) for kind in ("cos", "sin"))
            self.ring.relate(s, 2, self.ring.one_poly - self.ring.variable(c) ** 2)
            n = int(r.p * (unit // r.q))
            if abs(n) > MAX_MULTIPLE:
                raise TooLargeError("a multiple of an angle beyond 96")
            step = self.ring.fraction(c), self.ring.fraction(s)
            result = self._rotate(result, self._turn_power(step, n))
        return result

    def _split_atan(self, x: Fraction) -> tuple[Fraction, list[tuple[Generator, Fraction, fmpq]]]:
        """Split off arc tangents with a rational coefficient, or with a sign as a factor."""
        x, plain = self.powers.linear_part(x, "atan")
        x, signed = self._without_signed(x, "atan")
        return x, [*((generator, self.ring.one, r) for generator, r in plain), *signed]

    def _split_pi(self, x: Fraction) -> tuple[Fraction, list[tuple[Fraction, fmpq]]]:
        """Split off rational multiples of π, with or without signs as factors.

        Returns:
            The rest of ``x``, and pairs of a sign (or 1) and a rational coefficient.
        """
        if not self.ring.known("pi", None):
            return x, []
        x, plain = self.powers.linear_part(x, "pi")
        x, signed = self._without_signed(x, "pi")
        return x, [*((self.ring.one, r) for _, r in plain), *((sign, r) for _, sign, r in signed)]

    def _without_signed(
        self, x: Fraction, kind: str
    ) -> tuple[Fraction, list[tuple[Generator, Fraction, fmpq]]]:
        """Split off all generators of ``kind`` that are multiplied by products of signs."""
        pieces = []
        for generator, sign, r in self._signed_multiples(x, kind):
            signs = (
                all(self.ring.at(i).kind == "sign" for i in self.ring.used(sign)) and len(sign) == 1
            )
            if signs and sign.leading_coefficient() == 1 and generator.kind == kind:
                pieces.append((generator, self.ring.fraction(sign), r))
                x = x - self.ring.fraction(generator) * r * sign
        return x, pieces

    def _signed_multiples(self, x: Fraction, kind: str) -> list[tuple[Generator, Poly, fmpq]]:
        """Return the terms of ``x`` that contain exactly one generator of ``kind``, linearly."""
        multiples = []
        for monomial, value in x.num.terms() if x.den.is_constant() else ():
            used = [self.ring.at(i) for i, k in enumerate(monomial) if k]
            these = [g for g in used if g.kind == kind and monomial[g.position] == 1]
            if len(these) == 1:
                rest = self.ring.context.from_dict({tuple(map(int, monomial)): 1})
                r = fmpq(value, x.den.leading_coefficient())
                multiples.append((these[0], rest // self.ring.variable(these[0]), r))
        return multiples

    # Rational multiples of π

    def turn_of_pi(self, r: fmpq) -> tuple[Fraction, Fraction]:
        """Return the cosine and sine of rπ."""
        if r == 0:
            return self.ring.one, self.ring.zero
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
        generator = self.ring.generator("cosine", m, (m,))
        z = self.ring.variable(generator)
        if not any(position == generator.position for position, _, _ in self.ring.relations):
            minimal = _minimal(m)
            tail = self.ring.zero_poly
            for k in range(minimal.degree()):
                tail = tail - z**k * minimal[k]
            self.ring.relate(generator, minimal.degree(), tail)
        k = int((r * m).p) % (2 * m)
        return self._chebyshev(z, k), self._chebyshev(z, m // 2 - k)

    def _chebyshev(self, z: Poly, k: int) -> Fraction:
        """Return the cosine of kπ/M from z = 2cos(π/M), by the Chebyshev recurrence."""
        low, high = self.ring.context.constant(2), z
        for _ in range(abs(k)):
            low, high = high, self.ring.reduce(z * high - low)
        return self.ring.make(low, self.ring.context.constant(2))

    def _twelfth(self, k: int) -> tuple[Fraction, Fraction]:
        """Return the cosine and sine of kπ/12 for k = 1, 2, 3, 4, 6, 12."""
        two, three = (self.powers.root(self.ring.fraction(n), fmpq(1, 2)) for n in (2, 3))
        match k:
            case 1:
                return two * (three + 1) / 4, two * (three - 1) / 4
            case 2:
                return three / 2, self.ring.fraction(fmpq(1, 2))
            case 3:
                return two / 2, two / 2
            case 4:
                return self.ring.fraction(fmpq(1, 2)), three / 2
            case 6:
                return self.ring.zero, self.ring.one
            case _:
                return self.ring.fraction(-1), self.ring.zero


def _minimal(m: int) -> fmpz_poly:
    """Return FLINT's minimal polynomial of z = 2cos(π/m), after proving that z is a zero of it.

    It divides the polynomial sin(mθ)/sin θ in 2cos θ, which vanishes at θ = π/m, and balls show
    that the quotient does not vanish there.

    Raises:
        ArithmeticError: the proof fails.
    """
    minimal, x = fmpz_poly.cos_minpoly(2 * m), fmpz_poly([0, 1])
    before, sines = fmpz_poly([0]), fmpz_poly([1])
    for _ in range(m - 1):
        before, sines = sines, x * sines - before
    quotient, rest = divmod(sines, minimal)
    with ball_precision(8 * WORKING):
        if rest == 0 and not quotient(2 * arb.cos_pi_fmpq(fmpq(1, m))).contains(0):
            return minimal
    raise ArithmeticError(f"FLINT's minimal polynomial of 2*cos(pi/{m}) could not be verified")
