"""Write functions with boundary layers as sums of exponentials with smooth factors.

Example: ``exp(1 - x) - exp(1 + x - x/e)`` is, with t for e, the sum of exp(1 - x) and of
−exp(1 + x) times the layer e^{−x/t}, which is 1 at x = 0 and vanishes fast beside it. In

    Y(x, e) = Σ_j t^{v_j} g_j(x, t) e^{E_j(x, t)},   e = t^q,

the g_j are smooth where t = 0, and the exponents E_j are sums of negative powers of t with smooth
factors. Derivatives, products and residuals of linear equations have the same form, so that orders
can be read off the Taylor coefficients of the g_j in t.

A quotient such as (e^{x/t} − 1)/(e^{1/t} − 1) has the sum e^{1/t} − 1 below, which is free of x: it
is e^{1/t} times a factor 1 + O(tᵏ) for every k, which is a symbol here until no exponential grows.
"""

from __future__ import annotations

from math import lcm
from typing import NamedTuple

from flint import fmpq

from tresym.asymptotics.differential_problem import OpenError
from tresym.reals.decisions.readable_witnesses import tidied
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.operation_domains import operations
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ONE,
    ZERO,
    Expr,
    apply,
    number,
    rebuild,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.signs.interior import PROVING, is_zero
from tresym.reals.signs.sign import sign

MOST_TERMS = 60
LONGEST = 8
"""Exponents are polynomials in the small parameter of at most this degree."""

Exponent = tuple[tuple[int, Expr], ...]
"""Negative powers of t with their factors, in rising order; empty for the smooth part."""


class Part(NamedTuple):
    """t to a power times a factor that is smooth where t = 0."""

    power: int
    factor: Expr


Layered = dict[Exponent, Part]


class Reader:
    """Reads expressions in x and e as sums of exponentials.

    Attributes:
        q: e is t to this power.
        t: the name of t.
        nearly_one: symbols for the factors 1 + O(tᵏ), for every k, by which sums below fractions
            differ from their largest exponential.
    """

    def __init__(self, x: str, small: str, given: Given, trees: list[Expr]) -> None:
        """Choose the power so that e has no roots in the expressions.

        Args:
            x: the variable.
            small: the small parameter, which is positive.
            given: conditions on the parameters and the variable.
            trees: what will be read.
        """
        self.x, self.small = x, small
        self.q = lcm(
            1,
            *(
                int(node.args[1].args[0].q)
                for node in operations(trees)
                if node.op == "^" and node.args[1].op == "number" and small in symbols(node.args[0])
            ),
        )
        taken = {small, x}.union(*map(symbols, trees))
        self.t = "t"
        while self.t in taken:
            self.t += "_"
        self.given = given & Given(((symbol(self.t), ">", ZERO),))
        self.nearly_one: dict[Expr, str] = {}

    # Reading

    def read(self, e: Expr) -> Layered:
        """Return an expression as a sum of exponentials.

        Raises:
            OpenError: it has another form.
        """
        if self.small not in symbols(e):
            return {(): Part(0, e)}
        if e.op == "symbol":
            return {(): Part(self.q, ONE)}
        if e.op == "+":
            return self.sum([self.read(arg) for arg in e.args])
        if e.op == "*":
            total: Layered = {(): Part(0, ONE)}
            for arg in e.args:
                total = self.product(total, self.read(arg))
            return total
        if e.op == "^":
            return self._power(*e.args)
        if e.op == "exp":
            return self._exp(e.args[0])
        if e.op in ("sinh", "cosh") and self._is_singular(e.args[0]):
            rising, falling = apply("exp", e.args[0]), apply("exp", -e.args[0])
            half = number(fmpq(1, 2))
            return self.read(half * rising + (half if e.op == "cosh" else -half) * falling)
        return {(): Part(0, rebuild(e, tuple(self._smooth(arg) for arg in e.args)))}

    def _is_singular(self, e: Expr) -> bool:
        found = self.read(e)
        return set(found) != {()} or found[()].power < 0

    def _smooth(self, e: Expr) -> Expr:
        if self.small not in symbols(e):
            return e
        found = self.read(e)
        if set(found) != {()} or found[()].power < 0:
            raise OpenError(f"{e} is neither smooth nor exponential as {self.small} -> 0")
        return self._whole(found[()])

    def _whole(self, part: Part) -> Expr:
        return symbol(self.t) ** part.power * part.factor if part.power else part.factor

    def _power(self, base: Expr, exponent: Expr) -> Layered:
        if exponent.op != "number":
            return self._exp(exponent * apply("log", base))
        c = exponent.args[0]
        found = self.read(base)
        if len(found) > 1 and c.q == 1 and 0 < c <= LONGEST:
            total = found
            for _ in range(int(c) - 1):
                total = self.product(total, found)
            return total
        if len(found) > 1:
            found = self._largest(base, found)
        ((key, (v, g)),) = found.items()
        if c.q == 1 and self.t in symbols(g):  # a power of t may be hidden in a sum
            first = self._first(g)
            if first:
                v, g = v + first, normal_form(g / symbol(self.t) ** first, self.given)
        if (v * c).q != 1:
            raise OpenError(f"({base})**({exponent}) is no power of a root of {self.small}")
        power = tuple((k, tidied(f * number(c))) for k, f in key)
        return {power: Part(int(v * c), g ** number(c))}

    def _first(self, g: Expr) -> int:
        """Return how often a factor vanishes where t = 0."""
        for k in range(LONGEST):
            if not is_zero(substitute(g, {self.t: ZERO}), self.given):
                return k
            g = differentiate(g, self.t)
        raise OpenError(f"the order of {g} was not found")

    def _largest(self, base: Expr, found: Layered) -> Layered:
        """Return the largest exponential of a sum that is free of x."""
        if self.x in symbols(base):
            raise OpenError(f"the power of the sum {base} is not supported")
        for key, part in found.items():
            if all(self._is_flat(minus(other, key)) for other in found if other != key):
                name = self.nearly_one.setdefault(base, f"[near 1, {len(self.nearly_one)}]")
                return {key: part._replace(factor=part.factor * symbol(name))}
        raise OpenError(f"it is not known which term of {base} is the largest")

    def _is_flat(self, key: Exponent) -> bool:
        """Whether the exponential vanishes faster than all powers, for all x."""
        return bool(key) and sign(key[0][1], self.given, "<") == "-"

    def _exp(self, e: Expr) -> Layered:
        found = self.read(e)
        if set(found) != {()}:
            raise OpenError(f"the exponent {e} is not supported")
        v, g = found[()]
        if v >= 0:
            return {(): Part(0, apply("exp", self._whole(found[()])))}
        singular: list[tuple[int, Expr]] = []
        regular: Expr = ZERO
        t, factorial = symbol(self.t), 1
        for k in range(LONGEST):
            c = tidied(
                normal_form(substitute(g, {self.t: ZERO}) / number(fmpq(factorial)), self.given)
            )
            if c != ZERO and v + k < 0:
                singular.append((v + k, c))
            elif c != ZERO:
                regular = regular + (c * t ** (v + k) if v + k else c)
            g = tidied(differentiate(g, self.t))
            if g == ZERO:
                return {tuple(singular): Part(0, apply("exp", regular))}
            factorial *= k + 1
        raise OpenError(f"the exponent {e} is no polynomial in {self.small}")

    # Arithmetic

    def sum(self, terms: list[Layered]) -> Layered:
        """Return the sum of sums of exponentials."""
        total: dict[Exponent, list[Part]] = {}
        for term in terms:
            for key, part in term.items():
                total.setdefault(key, []).append(part)
        found: Layered = {}
        for key, parts in total.items():
            v = min(part.power for part in parts)
            g: Expr = ZERO
            for part in parts:
                g = g + self._whole(Part(part.power - v, part.factor))
            if g != ZERO:
                found[key] = Part(v, g)
        return found

    def product(self, one: Layered, other: Layered) -> Layered:
        """Return the product of two sums."""
        if len(one) * len(other) > MOST_TERMS:
            raise OpenError("the approximation has too many exponentials")
        terms = [
            {plus(a, b): Part(p.power + r.power, p.factor * r.factor)}
            for a, p in one.items()
            for b, r in other.items()
        ]
        return self.sum(terms)

    def derivative(self, e: Layered) -> Layered:
        """Return the derivative by x."""
        terms = []
        for key, (v, g) in e.items():
            terms.append({key: Part(v, differentiate(g, self.x))})
            for k, f in key:
                slope = tidied(differentiate(f, self.x))
                if slope != ZERO:
                    terms.append({key: Part(v + k, g * slope)})
        return self.sum(terms)

    def coefficients(self, part: Part, below: int) -> list[tuple[int, Expr]]:
        """Return the Taylor coefficients, by power of t, of the powers below a bound."""
        found = []
        g, factorial = part.factor, 1
        for k in range(max(0, below - part.power)):
            c = substitute(g, {self.t: ZERO}) * number(fmpq(1, factorial))
            found.append((part.power + k, c))
            g = differentiate(g, self.t)
            factorial *= k + 1
        return found


def plus(a: Exponent, b: Exponent) -> Exponent:
    """Return the sum of two exponents."""
    total = dict(a)
    for k, f in b:
        total[k] = tidied(normal_form(total.get(k, ZERO) + f, Given()))
    return tuple(sorted((k, f) for k, f in total.items() if f != ZERO))


def minus(a: Exponent, b: Exponent) -> Exponent:
    """Return the difference of two exponents."""
    return plus(a, tuple((k, -f) for k, f in b))


def known_sign(e: Expr, given: Given) -> int:
    """Return 1 or −1 if an expression has that sign wherever the conditions hold, else 0."""
    for value in (1, -1):
        if sign(value * e, given, ">") in PROVING[">"]:
            return value
    return 0
