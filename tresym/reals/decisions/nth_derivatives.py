"""Derivatives of integer order n, by induction on n.

``d^n f/dx^n = g(n, x)`` holds for all n from n0 on if it holds for n0 and if the derivative of
g(n, x) with respect to x is g(n + 1, x). It is refuted at small n by carrying out the derivatives.
"""

from __future__ import annotations

from dataclasses import replace

from tresym.reals.decisions.answer import Answer, Decide
from tresym.reals.decisions.equations import is_whole
from tresym.reals.decisions.finite_sums import from_on
from tresym.reals.decisions.hypergeometric import folded
from tresym.reals.decisions.readable_witnesses import decided_at
from tresym.reals.decisions.statement import Comparison, Statement
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.operation_domains import operations, singularities
from tresym.reals.language.binders import elementary, outermost
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ZERO,
    Expr,
    instantiate,
    number,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.signs.definedness import is_lasting
from tresym.reals.signs.sign import sign
from tresym.reals.verdict import Verdict

LOOKED_AT = 4
"""Values of n at which a claim is looked at."""
_SMOOTH = frozenset(("+", "*", "^", "exp", "sin", "cos", "sinh", "cosh", "atan", "tanh"))
"""Operations that have a derivative wherever they are defined; of powers it is asked apart."""


def decide_repeated(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    """Decide a claim with a derivative of order n.

    Args:
        decided: the procedure for claims without such a derivative.
    """
    nodes = [n for n in outermost(claim.left, claim.right) if n.op == "nth"]
    g = claim.solved(nodes[0]) if len(set(nodes)) == 1 else None
    if g is None or claim.relation != "==" or claim.derivatives or statement.path is not None:
        return Answer(
            Verdict.UNDECIDED,
            ("a derivative of order n is supported only in an equation that is linear in it"),
        )
    inner, place, order = nodes[0].args
    f, x = instantiate(inner, (place,)), str(place)
    if order.op != "symbol" or not elementary(f) or str(order) in symbols(f):
        return Answer(
            Verdict.UNDECIDED,
            "the order of the derivative must be a variable that is not "
            f"in the function, such as n; it is {order}",
        )
    n = str(order)
    plain, least = from_on(statement, n, 0)
    first = Answer(Verdict.UNDECIDED, f"no small value of {n} could be checked")
    for k in range(least, least + LOOKED_AT):
        value = folded(substitute(g, {n: number(k)}))
        derivative = f
        for _ in range(k):
            derivative = differentiate(derivative, x)
        if value is None:
            break
        same = Comparison(derivative, "==", value)
        found, _ = decided_at([{n: number(k)}], same, statement, decided)
        if found is not None:
            return found
        first = decided(same, plain) if k == least else first
    if not first:
        why = f"the base case of the induction, {n} = {least}, could not be proved: {first.why}"
        return Answer(Verdict.UNDECIDED, why)
    beyond = plain.given & Given(((order, ">=", number(least)),))
    whole = tuple(dict.fromkeys((*statement.integers, n)))
    if not is_lasting((g,), beyond, n) or not _is_smooth(g, f, x, beyond, whole):
        why = (
            "induction does not apply: the other side could not be shown "
            f"to be smooth for every {n} >= {least}"
        )
        return Answer(Verdict.UNDECIDED, why)
    later = substitute(g, {n: symbol(n) + 1})
    step = decided(
        Comparison(differentiate(g, x), "==", later),
        replace(plain, given=beyond, integers=whole),
    )
    if not step:
        why = f"the induction step from {n} to {n} + 1 could not be proved: {step.why}"
        return Answer(Verdict.UNDECIDED, why)
    why = f"by induction from {n} = {least}: {first.why}; step from {n} to {n} + 1: {step.why}"
    return replace(step, why=why, region=None)


def _is_smooth(g: Expr, f: Expr, x: str, given: Given, integers: tuple[str, ...]) -> bool:
    """Whether ``g`` has a derivative by ``x`` wherever it is defined and ``f`` is smooth."""
    there = ((e, ">" if positive else "!=", ZERO) for e, positive in singularities(f))
    given = given & Given(tuple(there))
    moving = [node for node in operations((g,)) if x in symbols(node)]
    powers = [node.args for node in moving if node.op == "^"]
    return {node.op for node in moving} <= _SMOOTH and all(
        is_whole(exponent, integers) or sign(base, given) == "+" for base, exponent in powers
    )
