"""Infinite sums and products: power series, quoted theorems, limits of finite sums.

A claim with one series is first given to :mod:`tresym.reals.decisions.power_series`. If that does
not decide it, each series is replaced by its value according to a quoted theorem, or by the limit
of a closed form of its partial sums.
"""

from __future__ import annotations

from dataclasses import replace

from tresym.reals.decisions.answer import Answer, Decide
from tresym.reals.decisions.finite_sums import first_terms
from tresym.reals.decisions.known_values import Known, known_value
from tresym.reals.decisions.power_series import decide_power_series
from tresym.reals.decisions.statement import Comparison, Statement
from tresym.reals.language.binders import is_infinite, outermost
from tresym.reals.language.expression import (
    Expr,
    opened,
    replaced,
    symbols,
)
from tresym.reals.verdict import Verdict


def decide_infinite(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    """Decide a claim with infinite sums or products.

    Args:
        decided: the procedure for claims without them.
    """
    nodes = [node for node in outermost(claim.left, claim.right) if is_infinite(node)]
    limit = statement.path is not None
    if claim.derivatives or statement.equations or (limit and not is_infinite(claim.right)):
        why = "a series together with derivatives, limits or conditions with == is not supported"
        return Answer(Verdict.UNDECIDED, why)
    if claim.relation not in ("==", "->") and any(symbols(node) - {"oo"} for node in nodes):
        return Answer(Verdict.UNDECIDED, "for a series with variables only equations are supported")
    found = None
    if len(set(nodes)) == 1 and claim.relation == "==" and not statement.integers:
        side = claim.solved(nodes[0])
        if side is not None:
            found = decide_power_series(side, nodes[0], statement.given)
            if found or found.verdict is Verdict.REFUTED:
                return _as_claimed(found, claim, nodes[0])
    known: dict[Expr, Known] = {}
    for node in dict.fromkeys(nodes):
        (k,), body = opened(node, statement.given.names)
        form = known_value(node.op, body, k, node.args[1], node.args[2], statement.given)
        if form is None and limit:
            return Answer(Verdict.UNDECIDED, f"{node}: no known theorem gives its value")
        if form is None:
            answer = first_terms(claim, statement, decided)
            return answer if found is None or answer.verdict is not Verdict.UNDECIDED else found
        known[node] = form
    answer = with_values(claim, statement, known, decided)
    if answer.verdict is Verdict.UNDECIDED and not limit:  # 0/0 where a theorem leaves out a factor
        other = first_terms(claim, statement, decided)
        return answer if other.verdict is Verdict.UNDECIDED else other
    return answer


def _as_claimed(found: Answer, claim: Comparison, series: Expr) -> Answer:
    """Values of an elementary side and of a series as those of the two sides of the claim."""
    if found.values is None or claim.right == series:
        return found
    return replace(found, values=found.values[::-1] if claim.left == series else None)


def with_values(
    claim: Comparison, statement: Statement, known: dict[Expr, Known], decided: Decide
) -> Answer:
    """Decide the claim with the values of the series according to quoted theorems."""
    values = {node: form.value for node, form in known.items()}
    left, right = (replaced(side, values) for side in (claim.left, claim.right))
    answer = decided(replace(claim, left=left, right=right), statement)
    said = "; ".join(f"{node} = {form.value} by {form.source}" for node, form in known.items())
    return replace(answer, why=f"{said}; {answer.why}", region=None)
