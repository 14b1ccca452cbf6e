"""Rational values of expressions without variables, where arithmetic alone gives them."""

from __future__ import annotations

from flint import fmpq

from tresym.reals.language.expression import Expr

LARGEST = 64
"""The largest exponent that is carried out."""


def rational(e: Expr) -> fmpq | None:
    """Return the value of sums, products and whole powers of numbers; None for anything else.

    Example:
        >>> from tresym.reals.language.parsing import parse
        >>> rational(parse("(1 + 2/3)**2"))
        25/9
    """
    if e.op == "number":
        return e.args[0]
    if e.op == "^":
        base, exponent = map(rational, e.args)
        if base is None or exponent is None or exponent.q != 1 or abs(exponent) > LARGEST:
            return None
        return None if base == 0 and exponent <= 0 else base ** int(exponent.p)
    if e.op not in ("+", "*"):
        return None
    total = fmpq(0 if e.op == "+" else 1)
    for arg in e.args:
        part = rational(arg)
        if part is None:
            return None
        total = total + part if e.op == "+" else total * part
    return total
