"""Truncated series, the sizes of their remainders, and products of coefficients."""

from __future__ import annotations

from functools import reduce
from typing import NamedTuple

from flint import arb, fmpq

from tresym.reals.expansions.scale import (
    Powers,
    UnresolvedError,
)
from tresym.reals.language.expression import (
    ONE,
    ZERO,
    Expr,
    add,
    apply,
    factors_in,
    multiply,
    number,
    power,
)
from tresym.reals.language.like_terms import collected

MAX_SIZE = 4_000

Term = tuple[Expr, Expr]
"""An exponent and a coefficient."""


class ShortError(UnresolvedError):
    """More terms may help."""


class Size(NamedTuple):
    """An upper bound height · Π element^power of the size of a function on 0 < t ≤ reach."""

    height: arb
    powers: Powers


class Series(NamedTuple):
    """The terms by rising exponents, and a remainder of the order of w^end, 0 if that is None."""

    terms: list[Term]
    end: Expr | None = None
    rest: Size | None = None
    """The size of all of the remainder, where a range is asked for."""


class Enclosure(NamedTuple):
    """f = (k + δ) Π element^power with |δ| ≤ error on 0 < t ≤ reach; δ → 0."""

    k: arb
    powers: Powers
    error: arb

    @property
    def low(self) -> arb:
        """A lower bound of |k + δ|."""
        return arb(self.k.abs_lower()) - self.error

    @property
    def high(self) -> arb:
        """An upper bound of |k + δ|."""
        return arb(self.k.abs_upper()) + self.error


def plus(c: Expr, d: Expr) -> Expr:
    """The sum of two coefficients, like terms as one."""
    total = add(c, d)
    if total.size > MAX_SIZE:
        raise UnresolvedError("a coefficient of the expansion exceeds the size limit")
    return collected(total) if total.op == "+" else total


def times(c: Expr, d: Expr) -> Expr:
    """The product of two coefficients that are not 0, powers of one base as one."""
    if c == ONE or d == ONE:
        return d if c == ONE else c
    powers: dict[Expr, fmpq] = {}
    exponent = ZERO
    for part in (part for x in (c, d) for part in (factors_in(x))):
        if part.op == "exp":
            exponent = plus(exponent, part.args[0])
            continue
        base, r = part, fmpq(1)
        if part.op == "^" and part.args[1].op == "number":
            base, r = part.args[0], part.args[1].args[0]
        powers[base] = powers.get(base, fmpq(0)) + r
    factors = [_power(base, r) for base, r in powers.items() if r != 0]
    found = multiply(*factors, *([apply("exp", exponent)] if exponent != ZERO else []))
    if found.size > MAX_SIZE:
        raise UnresolvedError("a coefficient of the expansion exceeds the size limit")
    return found


def quotient(c: Expr, d: Expr) -> Expr:
    """The quotient of two coefficients that are not 0."""
    return times(c, raised(d, fmpq(-1)))


def raised(c: Expr, r: fmpq) -> Expr:
    """The power of a coefficient that is not 0, and positive where r is no integer."""
    if c.op == "exp":
        return apply("exp", number(r) * c.args[0])
    if c.op == "*" and (r.q == 1 or (c.args[0].op == "number" and c.args[0].args[0] > 0)):
        if r.q == 1:
            return reduce(times, (raised(part, r) for part in c.args))
        return times(_power(c.args[0], r), raised(multiply(*c.args[1:]), r))
    if c.op == "^" and c.args[1].op == "number" and (r.q == 1 or c.args[1].args[0].q != 1):
        return _power(c.args[0], r * c.args[1].args[0])
    return _power(c, r)


def _power(base: Expr, r: fmpq) -> Expr:
    """A power, of a number with an exponent between 0 and 1 beside a number."""
    if base.op == "symbol" and r != 1:  # an element, of which no power is multiplied out
        return Expr("^", (base, number(r)))
    if base.op != "number" or base == ONE or r.q == 1:
        return base if base == ONE else power(base, number(r))
    whole = int(r.p // r.q)
    return power(base, number(whole)) * power(base, number(r - whole))
