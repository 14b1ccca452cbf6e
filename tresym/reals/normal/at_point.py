"""Whether what is claimed holds exactly at an exact point."""

from __future__ import annotations

from collections.abc import Mapping

from flint import arb, fmpq

from tresym.reals.domain.conditions import Condition
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.expression import (
    ZERO,
    Expr,
    as_expr,
    substitute,
)
from tresym.reals.normal.field import ALL_THEORIES
from tresym.reals.normal.locally_constant import equal_constants
from tresym.reals.numbers.exact import InputError


def equal_at(left: Expr, right: Expr, point: Mapping[str, fmpq | Expr]) -> bool:
    """Return whether both sides, defined at the exact ``point``, are exactly equal there.

    Args:
        left: one side.
        right: the other side.
        point: an exact value for each variable.
    """
    at = {name: as_expr(value) for name, value in point.items()}
    try:
        return equal_constants(substitute(left, at), substitute(right, at), ALL_THEORIES)
    except InputError:  # a power that is too long to write
        return False


def satisfies(
    condition: Condition, point: Mapping[str, fmpq | Expr], at: Mapping[str, arb]
) -> bool:
    """Return whether the exact ``point`` satisfies the condition; equality is decided exactly.

    Args:
        condition: the condition.
        point: an exact value for each variable.
        at: the same point as balls.
    """
    balls = dict(at)
    if condition.holds_exactly(balls):
        return True
    value = evaluate(condition.expression, balls)
    near = condition.relation == ">=" and value.is_finite() and value.contains(0)
    return near and equal_at(condition.expression, ZERO, point)
