"""Collect like terms of sums."""

from __future__ import annotations

from flint import fmpq

from tresym.reals.language.expression import ONE, ZERO, Expr, add, multiply, number


def scaled(term: Expr) -> tuple[fmpq, Expr]:
    """Return a term as a rational number times the rest."""
    if term.op == "*" and term.args[0].op == "number":
        return term.args[0].args[0], multiply(*term.args[1:])
    return fmpq(1), term


def collected(e: Expr) -> Expr:
    """Combine the like terms of a sum, after multiplying out multiples of sums.

    Example:
        >>> from tresym.reals.language.expression import symbol
        >>> x = symbol("x")
        >>> str(collected(x + 2 * x))
        '3*x'
    """
    found: dict[Expr, Expr] = {}

    def take(term: Expr, scale: Expr) -> None:
        own, inner = scaled(term)
        scale = scale * number(own)
        if inner.op == "+":
            for part in inner.args:
                take(part, scale)
        else:
            found[inner] = found.get(inner, ZERO) + scale

    take(e, ONE)
    return add(*(multiply(scale, inner) for inner, scale in found.items() if scale != ZERO))
