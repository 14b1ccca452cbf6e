"""Split absolute values by the sign of their arguments."""

from __future__ import annotations

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.operation_domains import bound
from tresym.reals.language.expression import Expr, rebuild
from tresym.reals.signs.interior import Ask

MAX_CASES = 3


def by_cases(difference: Expr, relation: str, given: Given, ask: Ask) -> str | None:
    """Cases: an absolute value is split by the sign of its argument, and both cases are proved.

    Decides ``abs(x) + abs(y) >= abs(x + y)``.

    Limits: at most three nested or successive absolute values are split.

    Args:
        difference: the expression that is compared with zero.
        relation: ``">"``, ``">="`` or ``"!="``.
        given: the conditions.
        ask: the prover for the two cases.

    Returns:
        A sentence that states the proof, or None.
    """
    inner = _absolute(difference)
    if inner is None:
        return None
    for side in (inner, -inner):
        case = given & Given((bound(side, ">="),))
        if ask(_without(difference, inner, side), relation, case) is None:
            return None
    return f"by cases, in the sign of {inner}"


def _absolute(e: Expr) -> Expr | None:
    """Return the argument of an innermost absolute value in ``e``, or None if there is none."""
    for arg in e.args if e.op not in ("number", "symbol", "pi") else ():
        inner = _absolute(arg)
        if inner is not None:
            return inner
    return e.args[0] if e.op == "abs" else None


def _without(e: Expr, inner: Expr, side: Expr) -> Expr:
    """Return ``e`` with ``abs(inner)`` replaced by ``side``."""
    if e.op in ("number", "symbol", "pi"):
        return e
    if e.op == "abs" and e.args[0] == inner:
        return side
    return rebuild(e, tuple(_without(arg, inner, side) for arg in e.args))
