"""Solve an expression for one symbol by inverting its functions."""

from __future__ import annotations

from tresym.reals.functions.table import TABLE
from tresym.reals.language.expression import (
    ZERO,
    Expr,
    add,
    apply,
    multiply,
    number,
    power,
    symbols,
)
from tresym.reals.numbers.exact import InputError


def solutions(e: Expr, name: str) -> list[Expr]:
    """Return candidates for zeros of ``e`` in the symbol ``name``.

    If the symbol occurs in several terms of a sum, nothing is found. A candidate may be non-real or
    not a zero; the caller must prove what it uses.

    Example:
        >>> from tresym.reals.language.expression import symbol
        >>> x, y = symbol("x"), symbol("y")
        >>> [str(s) for s in solutions(x - y, "x")]
        ['y']
    """
    try:
        return _solved(e, name, ZERO)
    except InputError:
        return []


def _solved(e: Expr, name: str, value: Expr) -> list[Expr]:
    """Return candidates for ``e = value``."""
    if e.op == "symbol":
        return [value] if e.args == (name,) else []
    with_name = [arg for arg in e.args if name in symbols(arg)] if e.op != "number" else []
    if len(with_name) != 1 and not (e.op == "*" and value == ZERO):
        return []
    if e.op == "+":
        return _solved(with_name[0], name, value - add(*(a for a in e.args if a != with_name[0])))
    if e.op == "*":
        if value == ZERO:
            return [c for arg in with_name for c in _solved(arg, name, ZERO)]
        return _solved(
            with_name[0], name, value / multiply(*(a for a in e.args if a != with_name[0]))
        )
    if e.op == "^":
        return _solved_power(e.args[0], e.args[1], name, value)
    row = TABLE.get(e.op)
    inverse = row and (row.inverse or (row.branch and row.branch[0]))
    if inverse and not (e.op == "exp" and value == ZERO):
        return _solved(e.args[0], name, apply(inverse, value))
    return []


def _solved_power(base: Expr, exponent: Expr, name: str, value: Expr) -> list[Expr]:
    if exponent.op != "number":
        return (
            []
            if name in symbols(base)
            else _solved(exponent, name, apply("log", value) / apply("log", base))
        )
    r = exponent.args[0]
    if value == ZERO or r == 0:
        return _solved(base, name, ZERO) if r > 0 else []
    root = power(value, number(1 / r))
    return [
        c
        for side in ((root, -root) if r.q == 1 and r.p % 2 == 0 else (root,))
        for c in _solved(base, name, side)
    ]
