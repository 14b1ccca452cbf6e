"""Limits and orders of what holds definite integrals, from each side of the path by itself.

The integrals are evaluated if antiderivatives are found near the end of the path. Otherwise an
integral whose two limits approach each other is treated by l'Hôpital's rule: if F and G tend to 0,
G′ does not vanish near the end and F′/G′ has a limit, finite or infinite, then F/G has the same.
"""

from __future__ import annotations

from dataclasses import replace

from tresym.asymptotics.path_claims import allows, compared_of, neighbourhood
from tresym.reals.decisions.answer import Answer, Decide, exact_text, worst
from tresym.reals.decisions.exceptional_values import also_at_holes
from tresym.reals.decisions.identity import decide
from tresym.reals.decisions.integrals import without_integrals
from tresym.reals.decisions.statement import Statement
from tresym.reals.decisions.waves import differ
from tresym.reals.domain.conditions import Given
from tresym.reals.expansions.leading_terms import leading_sign
from tresym.reals.expansions.limit_values import limit_of
from tresym.reals.language.binders import elementary, outermost
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.comparisons import LIMIT, Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ONE,
    ZERO,
    Expr,
    factors_in,
    multiply,
    number,
    opened,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.paths import Path
from tresym.reals.signs.definedness import continuous_on
from tresym.reals.verdict import Verdict

NEAR, FAR = number(1) / 10, number(10)
_OPEN = "no antiderivative could be found and verified near the end of the path"


def decide_integral_limits(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    """Decide a claim with integrals along a path.

    Args:
        decided: the procedure for claims without integrals.
    """
    path = statement.path
    if path is None:
        raise TypeError("a claim along a path needs its path")
    sides = (replace(path, sides=(side,)) for side in path.sides)
    found = [_one_side(claim, replace(statement, path=side), decided) for side in sides]
    for answer in found:
        if answer.verdict is Verdict.REFUTED:
            return answer
    return worst(found)


def _one_side(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    path = statement.path
    assert path is not None
    given = statement.given & neighbourhood(path, path.sides[0], FAR)
    infinite = [side for side in (claim.left, claim.right) if side in (INFINITY, -INFINITY)]
    sides = [side for side in (claim.left, claim.right) if side not in infinite]
    found = without_integrals(sides, given, claim.primitives)
    if found is not None and not any(INFINITY.args[0] in symbols(e) for e in found[0]):
        left, right = (*found[0], *infinite)
        answer = decided(replace(claim, left=left, right=right), statement)
        answer = replace(answer, why=f"{found[1]}; {answer.why}", region=None, constant=None)
        known = dict(zip(sides, found[0], strict=True))
        return also_at_holes(answer, known, claim, statement, decided)
    value = _by_derivatives(claim, path, statement.given)
    if value is not None and allows(claim.relation, value, claim.right, statement.given):
        return Answer(
            Verdict.PROVED, (f"by l'Hôpital's rule: the ratio of the derivatives tends to {value}")
        )
    if value is not None and claim.relation == LIMIT and differ(value, claim.right, Given()):
        at = (path.point or ZERO) + number(path.sides[0]) * NEAR
        why = f"by l'Hôpital's rule: the ratio of the derivatives tends to {value}"
        return Answer(Verdict.REFUTED, why, witness={path.name: exact_text(at)})
    return Answer(Verdict.UNDECIDED, _OPEN)


def _by_derivatives(claim: Comparison, path: Path, given: Given) -> Expr | None:
    """Return the limit by l'Hôpital's rule of an integral with merging ends, or None."""
    compared = compared_of(claim)[0]
    parts = factors_in(compared)
    nodes = [part for part in parts if part.op == "integral"]
    rest = multiply(*(part for part in parts if part not in nodes))
    if len(nodes) != 1 or not elementary(rest, *nodes[0].args[1:]):
        return None
    (name,), f = opened(nodes[0], {*symbols(compared), *given.names})
    low, high = nodes[0].args[1:]
    if path.name in symbols(f) or not elementary(f) or next(outermost(f), None) is not None:
        return None
    (side,) = path.sides
    ends = [limit_of(e, path.name, path.point, side, given) for e in (low, high)]
    if any(end is None or end in (INFINITY, -INFINITY) for end in ends):
        return None
    first, last = (end or ZERO for end in ends)
    x = symbol(name)
    around = given & Given(((x, ">", first - NEAR**6), (x, "<", first + NEAR**6)))
    together = decide(first, last, given).verdict is Verdict.PROVED
    if not together or continuous_on(f, around) is not None:
        return None
    below = ONE / rest
    slope = differentiate(below, path.name)
    if limit_of(below, path.name, path.point, side, given) != ZERO:
        return None
    if not leading_sign(slope, path.name, path.point, side, given):
        return None
    rise, fall = (substitute(f, {name: e}) * differentiate(e, path.name) for e in (high, low))
    above = rise - fall
    return limit_of(above / slope, path.name, path.point, side, given)
