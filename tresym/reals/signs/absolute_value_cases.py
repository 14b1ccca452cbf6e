"""Split absolute values by the sign of their arguments."""

from __future__ import annotations

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.operation_domains import bound
from tresym.reals.language.expression import Expr, rebuild
from tresym.reals.signs.interior import Ask

MAX_CASES = 3


def by_cases(difference: Expr, relation: str, given: Given, ask: Ask) -> str | None:
    """Cases: the claim holds for either sign of what stands within an absolute value.

    Decides ``abs(x) + abs(y) >= abs(x + y)``. Ends after three absolute values in turn.
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
    """The argument of an absolute value in ``e`` that has none within, if there is one."""
    for arg in e.args if e.op not in ("number", "symbol", "pi") else ():
        found = _absolute(arg)
        if found is not None:
            return found
    return e.args[0] if e.op == "abs" else None


def _without(e: Expr, inner: Expr, side: Expr) -> Expr:
    """``e`` with ``abs(inner)`` replaced by ``side``."""
    if e.op in ("number", "symbol", "pi"):
        return e
    if e.op == "abs" and e.args[0] == inner:
        return side
    return rebuild(e, tuple(_without(arg, inner, side) for arg in e.args))
