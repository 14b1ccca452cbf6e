"""The limit of an expression with parameters, exactly: by growth, whose coefficients are exact.

A parameter is a constant: its sign, where that matters, is one that
:func:`tresym.reals.signs.sign.sign` proves under the conditions, and what is free of the variable
is shown to be defined there. What is not shown so has no limit here: the answer is None.
"""

from __future__ import annotations

from collections.abc import Iterator

from tresym.reals.growth.rewritten import Rewritten
from tresym.reals.growth.scale import T, UnresolvedError
from tresym.reals.language.expression import LEAVES, Expr, substitute, symbol, symbols
from tresym.reals.language.parsing import INFINITY
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.places.conditions import Given
from tresym.reals.signs.defined import undefined

MINUS_INFINITY = -INFINITY


def limit_of(e: Expr, name: str, point: Expr | None, side: int, given: Given) -> Expr | None:
    """The limit of ``e`` on a path, ``oo`` and ``-oo`` among the values; None where none is shown.

    Args:
        name: the variable.
        point: where it goes, which may hold parameters; None for infinity.
        side: +1 from above or to +∞, −1 from below or to −∞.
        given: conditions on the parameters, which are fixed.
    """
    t = symbol(T)
    found = Rewritten(T, given)
    try:
        along = substitute(e, {name: side / t if point is None else point + side * t})
        if any(undefined(part, given) is not None for part in _fixed(along)):
            return None
        with ball_precision():
            f = found.of(along)
            value = found.expansions.limit(f) if found.real else None
    except (UnresolvedError, InputError, ZeroDivisionError, OverflowError):
        return None
    if isinstance(value, int):
        return {1: INFINITY, -1: MINUS_INFINITY}.get(value)
    return value if value is not None and undefined(value, given) is None else None


def _fixed(e: Expr) -> Iterator[Expr]:
    """The largest parts of ``e`` that are free of t."""
    if T not in symbols(e):
        yield e
    elif e.op not in LEAVES:
        for arg in e.args:
            yield from _fixed(arg)
