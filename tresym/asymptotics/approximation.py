"""Carry expansions through an expression: from its integrals, sums and factorials to the whole.

A value is an explicit main part A and an error g ≥ 0, meaning f = A + O(g) along the path. Sums add
errors; products and powers multiply relative errors, which must tend to 0; logarithm, exponential
and the functions with a bounded derivative carry them on.

Example: with n! = S(1 + O(1/n)), ``factorial(2*n)/factorial(n)**2`` is S(2n)/S(n)²·(1 + O(1/n)).
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from tresym.asymptotics.lemma import End
from tresym.reals.domain.conditions import Given
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.expression import (
    LEAVES,
    ONE,
    ZERO,
    Expr,
    add,
    apply,
    integer,
    multiply,
    power,
    rebuild,
    symbol,
)
from tresym.reals.signs.sign import sign

LIPSCHITZ = frozenset(("sin", "cos", "atan", "tanh", "asinh", "abs"))
"""Functions with a derivative of at most 1."""


class Approximation(NamedTuple):
    """f = ``main`` + O(``error``); the error is ``ZERO`` where main is f itself."""

    main: Expr
    error: Expr


def approximated(e: Expr, known: Mapping[Expr, Approximation], end: End) -> Approximation | None:
    """Return an explicit approximation of ``e``, or None where its error may be too large.

    Args:
        known: approximations of the integrals, sums and factorials in it.
    """
    if e in known:
        return known[e]
    if not e.hidden or e.op in LEAVES:
        return Approximation(e, ZERO)
    if e.names or e.op == "unknown":
        return None
    parts = [approximated(arg, known, end) for arg in e.args]
    found = [part for part in parts if part is not None]
    if len(found) < len(parts):
        return None
    if e.op == "+":
        errors = [part.error for part in found if part.error != ZERO]
        return Approximation(add(*(part.main for part in found)), add(ZERO, *errors))
    if e.op == "*":
        return _product(found, end)
    if all(part.error == ZERO for part in found):
        return Approximation(rebuild(e, tuple(part.main for part in found)), ZERO)
    first, second = found[0], found[-1]
    if e.op == "^":
        if second.error == ZERO and e.args[1].op == "number":
            return _power(first, second.main, end)
        if not _is_positive(first.main, end) or not _is_relatively_small(first, end):
            return None
        log = apply("log", first.main)
        error = size(log, end) * second.error
        if first.error != ZERO:
            error = error + (size(second.main, end) + second.error) * first.error / first.main
        whole = _exponential(Approximation(second.main * log, error), end)
        return None if whole is None else whole._replace(main=power(first.main, second.main))
    if e.op == "exp":
        return _exponential(first, end)
    if e.op == "log" and _is_relatively_small(first, end) and _is_positive(first.main, end):
        return Approximation(apply("log", first.main), first.error / abs(first.main))
    if e.op in LIPSCHITZ:
        return Approximation(apply(e.op, first.main), first.error)
    return None


def size(e: Expr, end: End) -> Expr:
    """Return |e|, without the bars where ``e`` is shown to be positive near the end."""
    return e if _is_positive(e, end) else abs(e)


def _product(parts: list[Approximation], end: End) -> Approximation:
    main = multiply(*(part.main for part in parts))
    sizes = [size(part.main, end) for part in parts]
    for n, part in enumerate(parts):
        if not _is_relatively_small(part, end):
            sizes[n] = sizes[n] + part.error
    errors = [
        multiply(part.error, *(other for m, other in enumerate(sizes) if m != n))
        for n, part in enumerate(parts)
        if part.error != ZERO
    ]
    return Approximation(main, add(ZERO, *errors))


def _power(part: Approximation, exponent: Expr, end: End) -> Approximation | None:
    n = integer(exponent)
    if not _is_relatively_small(part, end):
        return None
    if n is None and not _is_positive(part.main, end):
        return None
    main = power(part.main, exponent)
    return Approximation(main, size(main, end) * part.error / size(part.main, end))


def _exponential(part: Approximation, end: End) -> Approximation | None:
    if end.limit(part.error) in (None, INFINITY, -INFINITY):
        return None
    main = apply("exp", part.main)
    return Approximation(main, main * part.error)


def _is_relatively_small(part: Approximation, end: End) -> bool:
    return part.error == ZERO or _tends_to_zero(part.error / part.main, end)


def _tends_to_zero(e: Expr, end: End) -> bool:
    return end.limit(e) == ZERO


def _is_positive(e: Expr, end: End) -> bool:
    x, side = symbol(end.name), end.side
    near = (side * x, ">", ONE) if end.point is None else (side * x, ">", side * end.point)
    if sign(e, end.given & Given((near,))) == "+":
        return True
    last = end.limit(e)
    if last is None or last == -INFINITY:
        return False
    return last == INFINITY or sign(last, end.given) == "+"
