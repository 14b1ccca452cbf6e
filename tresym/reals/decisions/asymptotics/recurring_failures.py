"""Failures of a claim that return again and again as a variable tends to infinity."""

from __future__ import annotations

from itertools import product
from math import lcm

from flint import arb, fmpq

from tresym.reals.decisions.answer import Answer, exact_text
from tresym.reals.decisions.asymptotics.leading_terms import sign_towards
from tresym.reals.decisions.identity import decide
from tresym.reals.decisions.statement import Path
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate, stands
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    LEAVES,
    PI,
    Expr,
    number,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import NEGATED
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.verdict import Verdict

PERIOD_POINTS = 12
PATH_BITS = 256


# What comes again and again


def periodic_failure(difference: Expr, relation: str, path: Path) -> Answer | None:
    """A refutation where a difference has the period 2π, in u or in 1/u, and fails at a point."""
    u = symbol("_u")
    if path.point is not None and symbols(path.point):
        return None
    for side in path.sides:
        along = side * u if path.point is None else path.point + side / u
        e = substitute(difference, {path.name: along})
        if not symbols(e) <= {"_u"}:
            return None
        if decide(e, substitute(e, {"_u": u + 2 * PI})).verdict is not Verdict.PROVED:
            continue
        for at in (fmpq(2 * n + 1, 4) for n in range(PERIOD_POINTS)):
            with ball_precision(PATH_BITS):
                value = evaluate(e, {"_u": at})
                if value.is_finite() and stands(value, NEGATED[relation]):
                    where = substitute(along, {"_u": number(at)})
                    why = (
                        "the difference is periodic and the claim fails at "
                        f"{path.name} = {where}, so it "
                        "fails again and again towards the end of the path"
                    )
                    return Answer(Verdict.REFUTED, why, witness={path.name: exact_text(where)})
    return None


def failure_where_waves_return(difference: Expr, relation: str, path: Path) -> Answer | None:
    """A refutation at points c + 2 π N n, at which every sine and cosine has its value at c.

    Their arguments are of the first degree with rational slopes, and N is a multiple of the
    denominators. What is left without them has a sign from somewhere on.
    """
    name = path.name
    waves = {node: differentiate(node.args[0], name) for node in _waves(difference, name)}
    slopes = [slope.args[0] for slope in waves.values() if slope.op == "number"]
    if path.point is not None or not slopes or len(slopes) < len(waves):
        return None
    if symbols(difference) != {name}:
        return None
    turns = lcm(*(int(slope.q) for slope in slopes))
    for side, quarter in product(path.sides, range(4)):
        c = turns * quarter * PI / 2
        there = {wave: substitute(wave, {name: c}) for wave in waves}
        if not all(evaluate(value, {}).is_finite() for value in there.values()):
            continue
        left = replaced(difference, {w: normal_form(e, Given()) for w, e in there.items()})
        found = sign_towards(left, name, path.point, side)
        if found is None or stands(arb(found[0]), relation):
            continue
        n = int((1 / found[1] / (6 * turns)).ceil()) + 1
        where = exact_text(side * 2 * turns * n * PI + c)
        why = (
            f"it fails at {name} = {where} and at all later points where "
            "the sines and cosines have the same values"
        )
        return Answer(Verdict.REFUTED, why, witness={name: where})
    return None


def _waves(e: Expr, name: str) -> set[Expr]:
    """The sines and cosines in which the variable occurs, but those inside of others."""
    if e.op in LEAVES or name not in symbols(e):
        return set()
    return {e} if e.op in ("sin", "cos") else set().union(*(_waves(arg, name) for arg in e.args))
