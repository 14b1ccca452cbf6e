"""Whether conditions and equations hold together at some point: what is found there is checked.

What is found are values of some symbols, put in everywhere, and a point of the others, or a segment
that one of them runs through. Then every equation must hold identically, but for one, which changes
its sign on the segment and has no jump there; and every inequality holds in balls.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import lru_cache

from flint import arb
from sympy import Basic, Integer

from tresym.ledger.claim import Step
from tresym.ledger.evidence.chain import check_chain
from tresym.ledger.meaning import Conditions, Rules, conditions, formula, put_in, tree
from tresym.ledger.reasons import differentiating_integral
from tresym.ledger.second_look import scalars, somewhere
from tresym.reals.decisions.identity import decide
from tresym.reals.language.binders import elementary, generalised
from tresym.reals.language.expression import Expr
from tresym.reals.language.formula import Relation, relations
from tresym.reals.numbers.arithmetic import ball_precision, side
from tresym.reals.numbers.exact import Interval
from tresym.reals.places.unworked import enclosed, jumps
from tresym.reals.places.values import stands
from tresym.reals.verdict import Verdict

Place = Mapping[str, Interval]
"""Exact values of symbols by name, or a segment."""

BITS = 40
BY_END = (Step(None, (differentiating_integral(Integer(0)),)),)
"""How a derivative is shown to be what is put in for it."""


@lru_cache(maxsize=512)
def satisfiable(given: tuple[Basic, ...], known: tuple[Basic, ...]) -> bool:
    """Whether a point is found at which all of ``given`` and ``known`` is shown to hold."""
    said = (r for e in known for entry in scalars(e) for r in relations(formula(entry)))
    put, places = somewhere(given, known)
    rules = {tree(left): tree(right) for left, right in put.items()}
    named = [{str(symbol): where for symbol, where in place.items()} for place in places]
    return hold((*conditions(given), *said), rules, named)


def hold(asked: Iterable[Relation], rules: Rules, places: Iterable[Place]) -> bool:
    """Whether all that is asked holds in one of the places, with the values that are put in."""
    if any(left.op != "symbol" for left in rules):
        return False
    meant = [Relation(put_in(r.left, rules), r.sign, put_in(r.right, rules)) for r in asked]
    bounds = tuple(r for r in meant if r.sign != "==")
    equations = [r for r in meant if r.sign == "=="]
    open_ = [r.left - r.right for r in equations if not _is_identity(r, bounds)]
    valued = [put_in(right, rules) for right in rules.values()]
    valued += [side for r in equations for side in (r.left, r.right)]

    def holds(place: Place) -> bool:
        moving = [name for name, where in place.items() if where.low != where.high]
        inside = {name: where.ball() for name, where in place.items()}
        return (
            len(open_) == len(moving) <= 1
            and all(enclosed(e, inside).is_finite() for e in valued if elementary(e))
            and all(stands(enclosed(r.left - r.right, inside), r.sign) for r in bounds)
            and all(_crosses(e, place, moving[0]) for e in open_)
        )

    with ball_precision(BITS):
        return any(map(holds, places))


def _is_identity(equation: Relation, given: Conditions) -> bool:
    """Whether an equation holds wherever both sides have values, or by Leibniz's rule."""
    one, other = generalised(equation.left, equation.right)
    if one == other or decide(one, other).verdict is Verdict.PROVED:
        return True
    steps = check_chain(equation, BY_END, given)
    return all(step.verdict is Verdict.PROVED for step in steps)


def _crosses(e: Expr, place: Place, name: str) -> bool:
    """Whether ``e``, continuous on the segment, has opposite signs at its ends."""
    where = place[name]
    whole, *ends = (
        enclosed(e, {n: x if n == name else i.ball() for n, i in place.items()})
        for x in (where.ball(), arb(where.low), arb(where.high))
    )
    return whole.is_finite() and not jumps(e) and {*map(side, ends)} == {1, -1}
