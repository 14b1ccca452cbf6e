"""The sign of a function of one variable beside a point, or towards infinity, by its germ there."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from flint import fmpq

from tresym.reals.balls.germ import Germ, Germs, LogarithmError, RamifiedError, UnresolvedError
from tresym.reals.balls.run import formula
from tresym.reals.language.expression import Expr, substitute, symbol
from tresym.reals.numbers.arithmetic import ball_precision

ORDER = 10
HALVINGS = 14
_PARAMETER = "_t"


def sign_beside(e: Expr, name: str, point: Expr | None, side: int) -> tuple[int, fmpq] | None:
    """The sign of ``e`` on a whole one-sided neighbourhood.

    Args:
        point: where; None for infinity.
        side: +1 from above or to +∞, −1 from below or to −∞.

    Returns:
        The sign (0 where ``e`` vanishes identically) and r: it holds for 0 < |x − point| ≤ r, or
        for |x| ≥ 1/r; None where no expansion settles it.
    """
    t = symbol(_PARAMETER)
    along = side / t if point is None else point + side * t
    run = formula(substitute(e, {name: along}), _PARAMETER)
    with ball_precision():
        for parameter, field, reach in _fields():
            try:
                found = _sign(field.germ(run(parameter, field)))
            except (UnresolvedError, RamifiedError, LogarithmError, ZeroDivisionError):
                continue
            if found is not None:
                return found, reach
    return None


def _sign(germ: Germ) -> int | None:
    if germ.vanishes:
        return 0
    size = germ.range()
    return 1 if size > 0 else -1 if size < 0 else None


def _fields() -> Iterator[tuple[Any, Germs, fmpq]]:
    """t in the arithmetic of germs, on shorter and shorter ranges: as it is, √t, ∛t, 1/log(1/t)."""
    for k in range(HALVINGS):
        own = fmpq(1, 2**k)
        for index in (1, 2, 3):
            field = Germs(own, ORDER)
            yield field.x**index, field, own**index
        if 0 < k < 7:
            field = Germs(own, ORDER)
            yield field.exp(-1 / field.x), field, fmpq(1, 2 ** (1 + 3 * 2**k // 2))
