"""Find a point that satisfies conditions and equations together, and check it.

The counterexample search (`tresym.ledger.counterexamples.somewhere`) proposes substitutions for
some symbols and exact values for the others, of which one may be a segment instead. This module
verifies the proposal independently: every inequality holds in ball arithmetic, every equation but
one is an identity after substitution, and the remaining equation is continuous on the segment and
changes its sign there, so it has a root by the intermediate value theorem. Integrals are enclosed
by the midpoint rule on each cell, with the second derivative in the remainder.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import lru_cache
from typing import Any

from flint import arb

from tresym.ledger.conversion import Conditions, Rules, conditions, formula, known, put_in
from tresym.ledger.counterexamples import somewhere
from tresym.ledger.evidence.integrals import NotShownError, without_integrals
from tresym.ledger.evidence.sign_prover import undefined
from tresym.ledger.formulas import in_trees
from tresym.ledger.reasons import differentiating_integral
from tresym.reals.decisions.identity import decide_continuous
from tresym.reals.domain.binder_values import jumps
from tresym.reals.domain.evaluation import evaluate, stands
from tresym.reals.language.binders import elementary, generalised, outermost, worked_out
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import ZERO, Expr, opened, replaced, symbol
from tresym.reals.language.formula import Relation, relations
from tresym.reals.numbers.arithmetic import ball_precision, side
from tresym.reals.numbers.exact import Interval
from tresym.reals.verdict import Verdict

Place = Mapping[str, Interval]
"""Exact values of symbols by name, or a segment."""

BITS = 40
CELLS = 32
"""Number of cells into which an interval of integration is divided."""
WIDENING = arb((1, -8))
"""Relative widening of a segment, because integrals are enclosed only roughly."""
BY_END = (differentiating_integral(ZERO),)
"""The rule that gives the derivative of an integral by one of its ends."""


@lru_cache(maxsize=512)
def satisfiable(given: tuple[Any, ...], known: tuple[Any, ...]) -> bool:
    """Return whether a point is found where ``given`` and ``known`` are all proved to hold.

    False only means that no point was found.

    Args:
        given: conditions (inequalities).
        known: relations of the claims used, equations among them.

    Example:
        >>> from tresym.reals.language.expression import number
        >>> above, below = (Relation(symbol("x"), sign, number(1)) for sign in "><")
        >>> satisfiable((above,), ()), satisfiable((above,), (below,))
        (True, False)
    """
    stated = (r for e in known for r in relations(formula(e)))
    put, places = somewhere(given, known)
    rules = {in_trees(left): in_trees(right) for left, right in put.items()}
    named = [{str(symbol): where for symbol, where in place.items()} for place in places]
    return hold((*conditions(given), *stated), rules, named)


def hold(asked: Iterable[Relation], rules: Rules, places: Iterable[Place]) -> bool:
    """Return whether all relations are proved to hold at one of ``places``.

    Args:
        asked: the relations.
        rules: symbols to the expressions that replace them.
        places: proposals: for each other symbol an exact value or, for at most one, a segment.
    """
    if any(left.op != "symbol" for left in rules):
        return False
    meant = [Relation(put_in(r.left, rules), r.sign, put_in(r.right, rules)) for r in asked]
    bounds = tuple(r for r in meant if r.sign != "==")
    equations = [r for r in meant if r.sign == "=="]
    open_ = [r.left - r.right for r in equations if not _is_identity(r, bounds)]
    valued = [put_in(right, rules) for right in rules.values()]
    valued += [side for r in equations for side in (r.left, r.right)]

    def holds(place: Place) -> bool:
        at = {name: _widened(where) for name, where in place.items()}
        moving = [name for name, where in place.items() if where.low != where.high]
        return (
            len(open_) == len(moving) <= 1
            and all(evaluate(e, at).is_finite() for e in valued if elementary(e))
            and all(stands(_enclosed(r.left - r.right, at), r.sign) for r in bounds)
            and all(_crosses(e, at, moving[0]) for e in open_)
        )

    with ball_precision(BITS):
        return any(map(holds, places))


def _widened(where: Interval) -> arb:
    """Return a ball for a number, or for a segment slightly widened on both sides."""
    return where.ball() * (1 + WIDENING * arb(0, 1)) if where.low != where.high else where.ball()


def _is_identity(equation: Relation, given: Conditions) -> bool:
    """Return whether an equation is an identity, or follows by Leibniz's rule."""
    one, other = generalised(equation.left, equation.right)
    if one == other or decide_continuous(one, other).verdict is Verdict.PROVED:
        return True
    try:
        one, other = without_integrals(equation.left, equation.right, BY_END, given)
    except NotShownError:
        return False
    one, other = generalised(one, other)
    shown = one == other or decide_continuous(one, other, known(given)).verdict is Verdict.PROVED
    return shown and all(undefined(side, given) is None for side in (equation.left, equation.right))


def _crosses(e: Expr, at: Mapping[str, arb], name: str) -> bool:
    """Return whether ``e`` is continuous on the segment, with opposite signs at its ends."""
    ends = at[name].lower(), at[name].upper()
    return (
        not jumps(e)
        and _enclosed(e, at).is_finite()
        and {side(_enclosed(e, {**at, name: end})) for end in ends} == {1, -1}
    )


def _enclosed(e: Expr, at: Mapping[str, arb]) -> arb:
    """Return a ball that contains ``e``, integrals included; NaN if none is found."""
    nodes = {node: f"[{n}]" for n, node in enumerate(outermost(e))}
    known = {name: _integral(node, at) for node, name in nodes.items()}
    return evaluate(replaced(e, {n: symbol(name) for n, name in nodes.items()}), {**at, **known})


def _integral(node: Expr, at: Mapping[str, arb]) -> arb:
    """Enclose an integral by the midpoint rule: on each cell f(m)·h + f″(ξ)·h³/24."""
    if node.op != "integral" or not elementary(*node.args[1:]):
        return arb.nan()
    (name,), body = opened(node, at)
    f = worked_out(body)
    if not elementary(f) or jumps(f):
        return arb.nan()
    bend = differentiate(differentiate(f, name), name)
    low, high = (evaluate(end, at) for end in node.args[1:])
    h, total = (high - low) / CELLS, arb(0)
    for n in range(CELLS):
        middle = low + h * (n + arb(0.5))
        cell = {**at, name: middle + h * arb(0, 0.5)}
        known: dict[Expr, arb] = {}
        if not evaluate(f, cell, known).is_finite():
            return arb.nan()
        total += h * evaluate(f, {**at, name: middle}) + h**3 / 24 * evaluate(bend, cell, known)
    return total
