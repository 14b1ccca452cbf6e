"""Numerators, denominators and rational roots of rational functions of one variable."""

from __future__ import annotations

from flint import fmpq, fmpq_poly

from tresym.reals.language.expression import Expr, factors_in, multiply, number, power


def over(e: Expr) -> tuple[Expr, Expr]:
    """Return numerator and denominator of a product.

    Example:
        >>> from tresym.reals.language.parsing import parse
        >>> [str(part) for part in over(parse("(k + 1)/(k**2 + 1)"))]
        ['k + 1', 'k**2 + 1']
    """
    above, below = [], []
    for part in factors_in(e):
        exponent = part.args[1] if part.op == "^" else None
        if exponent is not None and exponent.op == "number" and exponent.args[0] < 0:
            below.append(power(part.args[0], -exponent))
        elif part.op == "number":
            above.append(number(part.args[0].p))
            below.append(number(part.args[0].q))
        else:
            above.append(part)
    return multiply(*above), multiply(*below)


def roots_of(p: fmpq_poly) -> list[tuple[fmpq, int]]:
    """Return the rational roots of a polynomial with their multiplicities."""
    found = []
    for factor, times in p.factor()[1]:
        if factor.degree() == 1:
            found.append((-factor[0] / factor[1], int(times)))
    return found
