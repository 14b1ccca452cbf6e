"""Whether a function has no limit at infinity, because it oscillates.

If all sines and cosines of the function have a common period P, its values at a + kP, for integers
k, do not oscillate. If they tend to different limits for two values of a, the function has no
limit.
"""

from __future__ import annotations

from itertools import pairwise
from math import lcm

from flint import fmpq

from tresym.reals.decisions.asymptotics.limit_values import limit_of
from tresym.reals.decisions.identity import decide
from tresym.reals.decisions.integer_variables import reduced_in
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.operation_domains import operations
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ONE,
    PI,
    Expr,
    fresh,
    number,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.like_terms import scaled
from tresym.reals.verdict import Verdict

EIGHTHS = (0, 1, 2, 3, 5)
"""Parts of a period at which limits are compared, in eighths."""


def has_no_limit(e: Expr, name: str, side: int, given: Given) -> bool:
    """Return whether ``e`` provably has no limit, finite or infinite, at side · ∞."""
    period = _period(e, name)
    if period is None:
        return False
    k = fresh("k", symbols(e) | given.names)
    found: list[Expr] = []
    for part in EIGHTHS:
        at = period * (number(side) * symbol(k) + number(fmpq(part, 8)))
        along = reduced_in(substitute(e, {name: at}), [k], given)
        value = limit_of(along, k, None, 1, given)
        if value is not None:
            found.append(value)
    return any(_differ(x, y, given) for x, y in pairwise(found))


def _differ(x: Expr, y: Expr, given: Given) -> bool:
    """Return whether two limits differ for all values of the parameters."""
    if x in (INFINITY, -INFINITY) or y in (INFINITY, -INFINITY):
        return x != y
    apart = decide(x, y, given).verdict is Verdict.REFUTED
    return apart and not symbols(x) | symbols(y)


def _period(e: Expr, name: str) -> Expr | None:
    """A common period of the sines and cosines of what is linear in the variable."""
    slopes = []
    for node in operations((e,)):
        if node.op in ("sin", "cos") and name in symbols(node):
            slope = differentiate(node.args[0], name)
            if name in symbols(slope):
                return None
            is_number = slope.op == "number"
            slopes.append((slope.args[0], ONE) if is_number else scaled(slope))
    if len({unit for _, unit in slopes}) != 1:
        return None
    return 2 * PI * number(lcm(*(int(s.q) for s, _ in slopes))) / slopes[0][1]
