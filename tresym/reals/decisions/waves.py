"""Hold the sines and cosines of an expression fixed along points a whole period apart.

Where sin(x) and cos(x) have the same values again and again, what is left of the expression often
has a limit there: along x = c + 2 pi n, ``x*sin(x)`` is ``x*sin(c)``. Two such limits that differ
show that the whole expression has no limit.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from math import lcm

from flint import fmpq

from tresym.reals.decisions.identity import decide
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.expansions.limit_values import limit_of
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    LEAVES,
    ONE,
    PI,
    Expr,
    number,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.like_terms import scaled
from tresym.reals.normal.to_expression import in_lowest_terms, normal_form
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.signs.interior import PROVING
from tresym.reals.signs.sign import sign
from tresym.reals.verdict import Verdict

EIGHTHS = (6, 2, 7, 5, 3, 1, 4, 0)
"""Parts of a period at which waves are held fixed, those where a sine is 0 last."""
WAVES = ("sin", "cos", "tan", "cot", "sec", "csc")


def has_no_limit(e: Expr, name: str, side: int, given: Given) -> bool:
    """Return whether ``e`` provably has no limit, finite or infinite, at side · ∞."""
    e = substitute(e, {name: side * symbol(name)})
    fixed = (left for _, _, left in with_fixed_waves(e, name, given))
    limits = (limit_of(left, name, None, 1, given) for left in fixed)
    known = [value for value in limits if value is not None]
    return any(differ(x, y, given) for x, y in pairwise(known))


def differ(x: Expr, y: Expr, given: Given) -> bool:
    """Return whether two limits differ for all values of the parameters."""
    if x in (INFINITY, -INFINITY) or y in (INFINITY, -INFINITY):
        return x != y
    apart = decide(x, y, given).verdict is Verdict.REFUTED
    return apart and not symbols(x) | symbols(y)


def with_fixed_waves(e: Expr, name: str, given: Given) -> Iterator[tuple[Expr, Expr, Expr]]:
    """Yield c, the period P, and ``e`` with the values that its waves have at c + nP."""
    waves, slopes = _waves(e, name), []
    for slope in (in_lowest_terms(differentiate(node.args[0], name)) for node in waves):
        if name in symbols(slope):
            return
        slopes.append((slope.args[0], ONE) if slope.op == "number" else scaled(slope))
    units = {unit for _, unit in slopes}
    if len(units) != 1 or sign(units.pop(), given, "!=") not in PROVING["!="]:
        return
    period = 2 * PI * number(lcm(*(int(s.q) for s, _ in slopes))) / slopes[0][1]
    for part in EIGHTHS:
        c = period * number(fmpq(part, 8))
        there = {wave: normal_form(substitute(wave, {name: c}), Given()) for wave in waves}
        with ball_precision():
            known = all(symbols(x) or evaluate(x, {}).is_finite() for x in there.values())
        if known:
            yield c, period, replaced(e, there)


def _waves(e: Expr, name: str) -> set[Expr]:
    """The sines and cosines in which the variable occurs, but those inside of others."""
    if e.op in LEAVES or name not in symbols(e):
        return set()
    return {e} if e.op in WAVES else set().union(*(_waves(arg, name) for arg in e.args))
