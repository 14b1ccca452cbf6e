"""What oscillating functions do again and again as a variable tends to infinity.

If the arguments of all sines and cosines are of the first degree, with slopes of rational ratios,
they have a common period P. At c + nP each has the value that it has at c, and what is left does
not oscillate. A claim that fails there from some n on is false on every neighbourhood of the end,
and a function with different limits for two values of c has none.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from math import lcm

from flint import arb, fmpq

from tresym.reals.decisions.answer import Answer, exact_text
from tresym.reals.decisions.asymptotics.leading_terms import sign_towards
from tresym.reals.decisions.asymptotics.limit_values import limit_of
from tresym.reals.decisions.identity import decide
from tresym.reals.decisions.statement import Path
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate, stands
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


def failure_where_waves_return(difference: Expr, relation: str, path: Path) -> Answer | None:
    """Return a refutation at points to which the waves of a difference return, or None."""
    u = symbol("_u")
    if path.point is not None and symbols(path.point):
        return None
    for side in path.sides:
        along = side * u if path.point is None else path.point + side / u
        e = substitute(difference, {path.name: along})
        if symbols(e) != {"_u"}:
            return None
        for c, period, fixed in _with_fixed_waves(e, "_u", Given()):
            found = sign_towards(fixed, "_u", None, 1)
            if found is None or stands(arb(found[0]), relation):
                continue
            with ball_precision():
                n = (1 / found[1] / evaluate(period, {})).upper().fmpq().ceil() + 1
            where = exact_text(substitute(along, {"_u": c + number(n) * period}))
            why = (
                f"it fails at {path.name} = {where} and again and again towards the end of the "
                "path, where the sines and cosines have the same values"
            )
            return Answer(Verdict.REFUTED, why, witness={path.name: where})
    return None


def has_no_limit(e: Expr, name: str, side: int, given: Given) -> bool:
    """Return whether ``e`` provably has no limit, finite or infinite, at side · ∞."""
    e = substitute(e, {name: side * symbol(name)})
    fixed = (left for _, _, left in _with_fixed_waves(e, name, given))
    limits = (limit_of(left, name, None, 1, given) for left in fixed)
    found = [value for value in limits if value is not None]
    return any(differ(x, y, given) for x, y in pairwise(found))


def differ(x: Expr, y: Expr, given: Given) -> bool:
    """Return whether two limits differ for all values of the parameters."""
    if x in (INFINITY, -INFINITY) or y in (INFINITY, -INFINITY):
        return x != y
    apart = decide(x, y, given).verdict is Verdict.REFUTED
    return apart and not symbols(x) | symbols(y)


def _with_fixed_waves(e: Expr, name: str, given: Given) -> Iterator[tuple[Expr, Expr, Expr]]:
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
