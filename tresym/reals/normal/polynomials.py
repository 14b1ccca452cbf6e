"""Read polynomials in symbols off the normal form."""

from __future__ import annotations

from math import prod

from flint import fmpq

from tresym.reals.domain.conditions import Given
from tresym.reals.language.expression import ONE, Expr, symbol
from tresym.reals.normal.field import Field
from tresym.reals.normal.generators import ValuedRing
from tresym.reals.normal.ring import Poly, UndefinedError
from tresym.reals.numbers.factoring import TooLargeError

Monomial = tuple[tuple[str, int], ...]
"""Symbols and their powers, none of which is 0."""


def terms_in_symbols(ring: ValuedRing, p: Poly) -> dict[Monomial, fmpq] | None:
    """The terms of ``p``, or None where a generator is no symbol."""
    used = {i: ring.at(i) for i in ring.used(p)}
    if any(generator.kind != "symbol" for generator in used.values()):
        return None
    names = {i: str(generator.data[0]) for i, generator in used.items()}
    return {
        tuple((name, int(powers[i])) for i, name in names.items() if powers[i]): fmpq(c)
        for powers, c in p.terms()
    }


def polynomial(e: Expr) -> dict[Monomial, fmpq] | None:
    """The terms of a polynomial in symbols with rational coefficients, or None."""
    try:
        field = Field(Given())
        (value,) = field.normal(e)
    except (TooLargeError, UndefinedError):
        return None
    terms = terms_in_symbols(field, value.num) if value.den.is_constant() else None
    if terms is None:
        return None
    unit = value.den.leading_coefficient()
    return {monomial: c / unit for monomial, c in terms.items()}


def degree(monomial: Monomial) -> int:
    """The total degree."""
    return sum(power for _, power in monomial)


def as_expression(monomial: Monomial) -> Expr:
    """The product of the powers."""
    return prod((symbol(name) ** power for name, power in monomial), start=ONE)
