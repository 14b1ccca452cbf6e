"""Compute the exact limit of an expression with parameters.

Parameters are constants. Where the sign of a parameter matters, it is proved under the conditions
by :func:`tresym.reals.signs.sign.sign`; expressions free of the variable are proved to be defined.
If a proof fails, no limit is returned.
"""

from __future__ import annotations

from collections.abc import Iterator

from tresym.reals.domain.conditions import Given
from tresym.reals.expansions.gruntz import Rewritten
from tresym.reals.expansions.scale import T, UnresolvedError
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.expression import (
    LEAVES,
    ZERO,
    Expr,
    factors_in,
    is_polynomial,
    multiply,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.signs.definedness import undefined

MINUS_INFINITY = -INFINITY


def limit_of(e: Expr, name: str, point: Expr | None, side: int, given: Given) -> Expr | None:
    """Return the limit of ``e`` on a path, possibly ``oo`` or ``-oo``; None if it is not proved.

    Args:
        name: the variable.
        point: where the variable tends, possibly with parameters; None for infinity.
        side: +1 from above or to +∞, −1 from below or to −∞.
        given: conditions on the parameters, which are fixed.
    """
    if e.hidden:
        return None
    t = symbol(T)
    found = Rewritten(T, given)
    try:
        along = substitute(e, {name: side / t if point is None else point + side * t})
        if any(undefined(part, given) is not None for part in _fixed(along)):
            return None
        with ball_precision():
            (f,) = found.all_of(along)
            value = found.expansions.limit(f) if found.real else None
    except UnresolvedError:
        value = None
    except (InputError, ZeroDivisionError, OverflowError):
        return None
    if value is None:
        return _squeezed(e, name, point, side, given)
    if isinstance(value, int):
        return {1: INFINITY, -1: MINUS_INFINITY}.get(value)
    return value if undefined(value, given) is None else None


def _squeezed(e: Expr, name: str, point: Expr | None, side: int, given: Given) -> Expr | None:
    """0 where each term is a bounded factor, of sines and cosines, times what tends to 0."""
    limits = _without_waves(e, name, point, side, given)
    return ZERO if limits and all(value == ZERO for value in limits) else None


def stays_bounded(e: Expr, name: str, point: Expr | None, side: int, given: Given) -> bool:
    """Whether each term is a bounded factor, of sines and cosines, times what has a limit."""
    limits = _without_waves(e, name, point, side, given)
    return bool(limits) and not {None, INFINITY, MINUS_INFINITY} & {*limits}


def _without_waves(
    e: Expr, name: str, point: Expr | None, side: int, given: Given
) -> list[Expr | None]:
    """The limits of the terms without their factors of sines and cosines; none without these."""
    limits = []
    for term in e.args if e.op == "+" else (e,):
        factors = factors_in(term)
        waves = [f for f in factors if name in symbols(f) and _is_bounded(f, name)]
        if not waves:
            return []
        rest = multiply(*(f for f in factors if f not in waves))
        limits.append(limit_of(rest, name, point, side, given))
    return limits


def _is_bounded(e: Expr, name: str) -> bool:
    """Whether ``e`` is made of sines and cosines of polynomials and of what is fixed."""
    if name not in symbols(e):
        return True
    if e.op in ("sin", "cos"):
        return is_polynomial(e.args[0], name)
    return e.op in ("+", "*") and all(_is_bounded(arg, name) for arg in e.args)


def _fixed(e: Expr) -> Iterator[Expr]:
    """The largest parts of ``e`` that are free of t."""
    if T not in symbols(e):
        yield e
    elif e.op not in LEAVES:
        for arg in e.args:
            yield from _fixed(arg)
