"""Compute the cells of an error table elsewhere: bytes in, bytes out.

Balls travel as midpoint and radius in binary, without rounding.
"""

from __future__ import annotations

import pickle
from typing import Any

from flint import arb, fmpz

from tresym.accuracy.error_table import Cell, Question, cell
from tresym.reals.language.expression import Expr
from tresym.reals.numbers.exact import InputError


def encoded(question: Question, x: Expr, digits: int) -> bytes:
    """Return what a worker is asked: one cell."""
    return pickle.dumps((question, x, digits))


def computed(asked: bytes) -> bytes:
    """Compute a cell; the function that workers call."""
    question, x, digits = pickle.loads(asked)
    found = cell(question, x, digits)
    if isinstance(found, InputError):
        return pickle.dumps(str(found))
    return pickle.dumps(tuple(map(_parts, found)))


def decoded(found: bytes) -> Cell | InputError:
    """Return the cell that a worker computed."""
    parts = pickle.loads(found)
    return InputError(parts) if isinstance(parts, str) else Cell(*map(_ball, parts))


def _parts(x: arb | None) -> tuple[int, ...] | None:
    """Return a ball as two pairs of mantissa and exponent."""
    if x is None:
        return None
    numbers = (*x.mid().man_exp(), *x.rad().man_exp())
    return tuple(map(int, numbers))


def _ball(parts: tuple[int, ...] | None) -> Any:
    if parts is None:
        return None
    middle, power, radius, other = parts
    return arb((fmpz(middle), fmpz(power)), (fmpz(radius), fmpz(other)))
