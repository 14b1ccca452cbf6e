"""Decide claims with derivatives also where only the formula of a derivative is undefined.

The rules of differentiation give ``x/abs(x)*2*abs(x)`` as the derivative of ``abs(x)**2``. At 0
this formula has no value, but the function has the derivative 0 there. So a proof that uses the
formula says nothing about x = 0, and ``diff(abs(x)**2, x) != 0`` is false.

At a zero c of such a denominator the derivative is computed as a limit: if f is continuous at c and
its derivative has the same finite limit from both sides, then f is differentiable at c and the
limit is its derivative (a consequence of the mean value theorem: W. Rudin, *Principles of
Mathematical Analysis*, 1976, exercise 5.9). For a derivative of order n this is used for each order
up to n. If the limits from the two sides differ or are infinite, f has no derivative of this kind
at c, and the claim says nothing there.

Limitations: a zero must be one value of the variable of differentiation, which may depend on
parameters. If not all zeros are found or a limit is not computed, the answer names the points that
it leaves out, as in "where x**2 + a**2 != 0".
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial

from tresym.reals.decisions.answer import Answer, Decide, worst
from tresym.reals.decisions.derivative_domains import interior
from tresym.reals.decisions.equations import is_empty
from tresym.reals.decisions.exceptional_values import (
    may_be_defined,
    value_put_in,
    with_substituted_witness,
)
from tresym.reals.decisions.identity import decide
from tresym.reals.decisions.readable_witnesses import constants_hold
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.operation_domains import bound, needs
from tresym.reals.expansions.limit_values import limit_of
from tresym.reals.language.binders import elementary
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.comparisons import Comparison, Derivative
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    LEAVES,
    ZERO,
    Expr,
    add,
    multiply,
    rebuild,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.solve import solutions
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.signs.definedness import undefined
from tresym.reals.signs.discontinuities import value_at_zero, zeros
from tresym.reals.signs.interior import is_nonzero
from tresym.reals.signs.structural import sign_by_form
from tresym.reals.verdict import Verdict


class _OpenError(Exception):
    """The derivative at a hole of its formula is not known; the argument is what vanishes there."""


def at_removable_holes(
    found: Answer, claim: Comparison, statement: Statement, decided: Decide
) -> Answer:
    """Return the weakest of a proof and of the answers where derivatives are limits of formulas.

    Args:
        found: a proof wherever the formulas of all derivatives are defined.
        claim: the comparison that was proved.
        statement: its conditions.
        decided: the procedure for claims without derivatives.
    """
    answers, left_out = [found], []
    if not any(_suspects(d, claim, statement.given) for d in claim.derivatives):
        return found
    inside = interior(statement.given, claim.differentiated, claim.by)
    for part, by in _holes(claim, inside):
        value = value_at_zero(part, symbols(part) - {by})
        if value is None:
            left_out.append(part)
        for c in solutions(part, by) if value is None else (value[by],):
            try:
                answers += _at(c, by, claim, statement, inside, decided)
            except _OpenError:
                left_out.append(part)
    answer = worst(answers)
    if not answer or not left_out:
        return answer
    shown = ", ".join(f"{part} != 0" for part in dict.fromkeys(left_out))
    return replace(
        answer,
        why=f"{answer.why}; proved where {shown}",
        region=f"{answer.region}, {shown}" if answer.region else f"where {shown}",
    )


def _suspects(d: Derivative, claim: Comparison, given: Given) -> list[Expr]:
    """Return what the formula of a derivative requires not to vanish, if neither its form nor a
    condition, nor what the functions or the rest of the claim require, says so.
    """
    if not elementary(d.value, d.function):
        return []
    marks = {d.value: symbol(f"[d{n}]") for n, d in enumerate(claim.derivatives)}
    sides = (marked(side, marks) for side in (claim.left, claim.right))
    outside = {e for e, _ in needs(sides)}
    real = (part for part in needs(claim.differentiated) if part[1] != ">=")
    conditions = {*given.comparisons, *(bound(*part) for part in real)}
    return [
        e
        for e, relation in needs((d.value,), powers=False)
        if relation != ">="
        and d.by in symbols(e)
        and e not in outside
        and sign_by_form(e) != "+"
        and not {bound(e, ">"), bound(e, "!=")} & conditions
    ]


def _holes(claim: Comparison, inside: Given) -> Iterator[tuple[Expr, str]]:
    """Yield what may vanish where a function is real and the formula of its derivative is not."""
    seen = set()
    for d in claim.derivatives:
        for e in _suspects(d, claim, inside):
            if is_nonzero(e, inside):
                continue
            for part in zeros(e, inside):
                if (part, d.by) not in seen and d.by in symbols(part):
                    seen.add((part, d.by))
                    yield part, d.by


def _at(
    c: Expr,
    by: str,
    claim: Comparison,
    statement: Statement,
    inside: Given,
    decided: Decide,
) -> Iterator[Answer]:
    """Yield the answer at ``by = c``; nothing if the claim says nothing there.

    Raises:
        _OpenError: a derivative there is not known.
    """
    value = {by: c}
    change = partial(value_put_in, value=value)
    there = statement.mapped(change)
    if is_empty(there.given):
        return
    marks, limits = {}, {}
    for n, d in enumerate(claim.derivatives):
        slope = _slope_at(d, c, by, inside)
        if slope is None:
            return
        marks[d.value] = symbol(f"[d{n}]")
        limits[f"[d{n}]"] = slope
    sides = []
    for side in (claim.left, claim.right):
        moved = substitute(change(marked(side, marks)), limits)
        sides.append(moved)
    here = Comparison(sides[0], claim.relation, sides[1])
    if not may_be_defined(here):
        if any(may_be_defined(Comparison(side, "==", ZERO)) for side in sides):
            return  # the other side is undefined
        raise _OpenError(by)
    kept = constants_hold(there.given.comparisons)
    there = replace(there, given=there.given if kept is None else kept)
    answer = decided(here, there)
    yield with_substituted_witness(answer, f"{by} = {c}", value)


def _slope_at(d: Derivative, c: Expr, by: str, inside: Given) -> Expr | None:
    """Return the derivative at ``by = c``, None if there is none.

    Raises:
        _OpenError: that is not known.
    """
    at = substitute(d.value, {by: c})
    given = without_name(inside, by)
    if undefined(at, given) is None or d.by != by:
        return at
    f = substitute(d.function, {by: c})
    if undefined(f, given) is not None:
        raise _OpenError(d.function)
    formula = d.function
    for order in range(d.order + 1):
        ends = [limit_of(formula, by, c, side, given) for side in (1, -1)]
        if None in ends:
            raise _OpenError(d.function)
        above, below = (end or ZERO for end in ends)
        if {above, below} & {INFINITY, -INFINITY}:
            return None
        pairs = [(above, below), *([(above, f)] if order == 0 else ())]
        for x, y in pairs:
            if decide(x, y, given).verdict is not Verdict.PROVED:
                if _differ(x, y):
                    return None
                raise _OpenError(d.function)
        formula = differentiate(formula, by)
    return above


def without_name(given: Given, name: str) -> Given:
    """Return the conditions in which ``name`` does not occur."""
    links = (c for c in given.comparisons if name not in symbols(c[0]) | symbols(c[2]))
    return Given(tuple(links))


def _differ(x: Expr, y: Expr) -> bool:
    if symbols(x) | symbols(y):
        return False
    with ball_precision():
        return bool(evaluate(x - y, {}) != 0)


def marked(e: Expr, marks: dict[Expr, Expr]) -> Expr:
    """Return ``e`` with subexpressions replaced, also where sums and products were flattened."""
    if e in marks:
        return marks[e]
    if e.op in LEAVES:
        return e
    args = list(e.args)
    for known, mark in marks.items():
        if known.op == e.op and e.op in ("+", "*"):
            rest, parts = list(args), [part for part in known.args if part.op != "number"]
            if all(part in rest for part in parts):
                for part in parts:
                    rest.remove(part)
                numbers = [part for part in known.args if part.op == "number"]
                less = [-x for x in numbers] if e.op == "+" else [1 / x for x in numbers]
                args = [*rest, *less, mark]
    if e.op in ("+", "*"):
        combine = add if e.op == "+" else multiply
        return combine(*(marked(arg, marks) for arg in args))
    return rebuild(e, tuple(marked(arg, marks) for arg in args))
