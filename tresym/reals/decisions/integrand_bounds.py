"""Compare an integral with parameters with an expression, by its integrand.

``integral(exp(-x**2), x, 0, a) <= a given a > 0`` holds, because the integrand is at most 1, the
right side over the length of the interval. ``integral(exp(-x**3), x, 0, a) >= a - a**4/4 given a >
0`` follows from the derivatives by the end: both sides are 0 at a = 0, and the derivative of the
left side, the integrand, is nowhere smaller than that of the right side. For a strict comparison
the integrand need only be larger at an end, and so near it. Equations follow in the same way, so
that no antiderivative is looked for where the other side is one. Integrand and expression are shown
to be continuous on the closed interval. Several integrals over one interval count as that of their
sum. What fails refutes nothing.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.conditions import Given
from tresym.reals.language.binders import derivative, elementary, outermost, worked_out
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.expression import (
    ZERO,
    Expr,
    add,
    fresh,
    opened,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import MIRRORED
from tresym.reals.signs.definedness import undefined
from tresym.reals.signs.interior import jumps
from tresym.reals.signs.sign import proof
from tresym.reals.signs.sign import sign as sign_of
from tresym.reals.verdict import Verdict

Decide = Callable[[Comparison, Statement], Answer]
_SIGNS = {"<": "-", ">": "+"}


def decide_by_integrand(claim: Comparison, statement: Statement, decided: Decide) -> Answer | None:
    """Return a proof of a comparison with integrals over one interval, or None."""
    nodes = list(dict.fromkeys(outermost(claim.left, claim.right)))
    if any(node.op != "integral" for node in nodes) or claim.derivatives or not nodes:
        return None
    if (
        claim.relation not in MIRRORED
        or claim.relation == "!="
        or statement.path is not None
        or statement.equations
        or len({node.args[1:] for node in nodes}) > 1
    ):
        return None
    low, high = nodes[0].args[1:3]
    marks = {node: symbol(f"[{n}]") for n, node in enumerate(nodes)}
    gap = replaced(claim.left - claim.right, marks)
    if not elementary(gap, low, high):
        return None
    t = fresh("t", frozenset().union(*map(symbols, (*nodes, gap)), statement.given.names))
    terms = []
    for node, mark in marks.items():
        share = worked_out(derivative(gap, str(mark.args[0])))
        (name,), body = opened(node)
        terms.append(share * substitute(body, {name: symbol(t)}))
    f, sign = worked_out(add(*terms)), claim.relation
    other = -substitute(gap, {str(mark.args[0]): ZERO for mark in marks.values()})
    known = {str(mark.args[0]) for mark in marks.values()}
    if not elementary(f, other) or known & (symbols(f) | symbols(other)):
        return None
    x = symbol(t)
    closed = statement.given & Given(((x, ">=", low), (x, "<=", high)))
    if undefined(f, closed, proof) is not None or jumps((f,), closed):
        return None
    inside = replace(statement, given=statement.given & Given(((x, ">", low), (x, "<", high))))

    def shown(left: Expr, relation: str, right: Expr, there: Statement) -> bool:
        if relation[0] == "<":
            left, relation, right = right, MIRRORED[relation], left
        asked = replace(claim, left=left, relation=relation, right=right)
        found = decided(asked, there)
        verdicts.append(found.verdict)
        return bool(found)

    verdicts: list[Verdict] = []
    if not shown(low, "<", high, statement):
        return None
    for ways in (_by_end,) if sign == "==" else (_near_an_end, _by_mean, _by_end):
        verdicts[1:] = []
        shown_last = ""
        for left, relation, right, is_inside in ways(f, t, low, high, sign, other, closed):
            if not shown(left, relation, right, inside if is_inside else statement):
                break
            shown_last = f"{left} {relation} {right}"
        else:
            if len(verdicts) > 1:
                weak = Verdict.ENCLOSED if Verdict.ENCLOSED in verdicts else Verdict.PROVED
                return Answer(weak, f"by its integrand: {shown_last} between the ends")
    return None


Asked = tuple[Expr, str, Expr, bool]


def _by_mean(
    f: Expr, t: str, low: Expr, high: Expr, sign: str, other: Expr, closed: Given
) -> Iterator[Asked]:
    """The integrand is compared with the other side over the length of the interval."""
    yield f, sign, other / (high - low), True


def _near_an_end(
    f: Expr, t: str, low: Expr, high: Expr, sign: str, other: Expr, closed: Given
) -> Iterator[Asked]:
    """The integrand is nowhere on the wrong side of the mean, and off it at an end and so near."""
    mean = other / (high - low)
    for end in (low, high) if len(sign) == 1 else ():
        there = worked_out(substitute(f, {t: end}))
        if elementary(there) and sign_of(there - mean, closed, dear=False) == _SIGNS[sign]:
            yield there, sign, mean, False
            yield f, sign + "=", mean, True
            return


def _by_end(
    f: Expr, t: str, low: Expr, high: Expr, sign: str, other: Expr, closed: Given
) -> Iterator[Asked]:
    """Both sides are compared where the ends meet, and their derivatives by an end."""
    for end, fixed, factor in ((high, low, 1), (low, high, -1)):
        if end.op != "symbol" or end.args[0] in symbols(fixed) | symbols(f):
            continue
        put = {end.args[0]: symbol(t)}
        moving = substitute(other, put)
        slope = worked_out(derivative(moving, t))
        if not elementary(slope):
            continue
        smooth = undefined(moving, closed, proof) is None and not jumps((moving,), closed)
        if smooth and undefined(slope, closed, proof) is None:
            yield ZERO, sign[0] + "=", substitute(other, {end.args[0]: fixed}), False
            yield (f if factor == 1 else -f), (sign if factor == 1 else MIRRORED[sign]), slope, True
            return
