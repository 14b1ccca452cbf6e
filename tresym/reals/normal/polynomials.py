"""Convert normal forms to polynomials in symbols."""

from __future__ import annotations

from math import prod

from flint import fmpq

from tresym.reals.domain.conditions import Given
from tresym.reals.language.expression import ONE, Expr, symbol
from tresym.reals.normal.field import Field
from tresym.reals.normal.ring import Poly, Ring, UndefinedError
from tresym.reals.numbers.factoring import TooLargeError

Monomial = tuple[tuple[str, int], ...]
"""Pairs of a symbol and its nonzero power."""


def terms_in_symbols(ring: Ring, p: Poly) -> dict[Monomial, fmpq] | None:
    """Return the terms of ``p``, or None if it contains a generator that is not a symbol."""
    used = {i: ring.at(i) for i in ring.used(p)}
    if any(generator.kind != "symbol" for generator in used.values()):
        return None
    names = {i: str(generator.data[0]) for i, generator in used.items()}
    return {
        tuple((name, int(powers[i])) for i, name in names.items() if powers[i]): fmpq(c)
        for powers, c in p.terms()
    }


def polynomial(e: Expr) -> dict[Monomial, fmpq] | None:
    """Return the terms of a polynomial in symbols with rational coefficients.

    Args:
        e: the expression, which need not be expanded.

    Returns:
        The coefficient of each monomial; None if ``e`` is not such a polynomial.

    Example:
        >>> x = symbol("x")
        >>> polynomial(x * (x + 2))
        {(('x', 2),): 1, (('x', 1),): 2}
    """
    try:
        field = Field(Given())
        (value,) = field.normal(e)
    except (TooLargeError, UndefinedError):
        return None
    terms = terms_in_symbols(field.ring, value.num) if value.den.is_constant() else None
    if terms is None:
        return None
    unit = value.den.leading_coefficient()
    return {monomial: c / unit for monomial, c in terms.items()}


def degree(monomial: Monomial) -> int:
    """Return the total degree of a monomial."""
    return sum(power for _, power in monomial)


def as_expression(monomial: Monomial) -> Expr:
    """Return a monomial as an expression."""
    return prod((symbol(name) ** power for name, power in monomial), start=ONE)
