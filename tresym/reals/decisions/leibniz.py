"""Derivatives of integrals with variable ends and parameters, by Leibniz's rule.

d/dp ∫ f dt from a to b is f(b) b′ − f(a) a′ + ∫ ∂f/∂p dt where f is analytic at all t from a to b
and all p in question, which is shown, as are a and b. Functions left unknown are smooth. The claim
is then decided with the value of the derivative put in, at all points of the conditions.
"""

from __future__ import annotations

from dataclasses import replace

from tresym.reals.decisions.answer import Answer, Decide
from tresym.reals.decisions.statement import Comparison, Statement, functions
from tresym.reals.domain.conditions import Given
from tresym.reals.language.binders import elementary, integral, outermost
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    LEAVES,
    ZERO,
    Expr,
    add,
    fresh,
    instantiate,
    opened,
    rebuild,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.signs.closure import has_inside, is_regular
from tresym.reals.signs.definedness import continuous_on
from tresym.reals.signs.sign import proof, sign
from tresym.reals.verdict import Verdict


class _OpenError(Exception):
    """The rule is not shown to apply; the text says why."""


def decide_by_leibniz(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    """Decide a claim with derivatives of integrals, by differentiation under the integral sign.

    Args:
        decided: the procedure for claims without derivatives of integrals.
    """
    given = statement.given
    if statement.path is not None or statement.equations or statement.integers:
        why = "derivatives of integrals are supported only under conditions that are inequalities"
        return Answer(Verdict.UNDECIDED, why)
    if not (is_regular(given) and has_inside(given)):
        return Answer(
            Verdict.UNDECIDED,
            (
                "the conditions could not be shown to have interior points, "
                "where a derivative makes sense"
            ),
        )
    try:
        left, right = (_worked_out(side, given) for side in (claim.left, claim.right))
    except _OpenError as error:
        return Answer(Verdict.UNDECIDED, str(error))
    kept = tuple(d for d in claim.derivatives if not _integrals(d.function))
    answer = decided(Comparison(left, claim.relation, right, kept), statement)
    return replace(
        answer, why=f"by Leibniz's rule for differentiation under the integral sign; {answer.why}"
    )


def _integrals(e: Expr) -> list[Expr]:
    return [node for node in outermost(e) if node.op != "unknown"]


def _worked_out(e: Expr, given: Given) -> Expr:
    """``e`` with the derivatives of integrals in it worked out."""
    if e.op in LEAVES or not e.hidden:
        return e
    if e.op != "derivative":
        known = e.op in ("unknown", "integral")
        return e if known else rebuild(e, tuple(_worked_out(arg, given) for arg in e.args))
    place = e.args[1]
    if place.op != "symbol" or symbols(place) & symbols(e.args[0]):
        raise _OpenError(
            "the derivative of an integral at a point is not supported: "
            "differentiate with respect to a variable"
        )
    body = _worked_out(instantiate(e.args[0], (place,)), given)
    return _slope(body, str(place), given)


def _slope(body: Expr, name: str, given: Given) -> Expr:
    """The derivative of an expression with integrals, by the chain rule."""
    nodes = [node for node in dict.fromkeys(_integrals(body)) if name in symbols(node)]
    if any(node.op != "integral" for node in nodes):
        raise _OpenError("derivatives of sums and limits are not supported")
    marks = {node: symbol(f"[{n}]") for n, node in enumerate(nodes)}
    plain = replaced(body, marks)
    back = {str(mark): node for node, mark in marks.items()}
    terms = [differentiate(plain, name)]
    for node, mark in marks.items():
        terms.append(differentiate(plain, str(mark)) * _rule(node, name, given))
    return substitute(add(*terms), back)


def _rule(node: Expr, name: str, given: Given) -> Expr:
    """Leibniz's rule for one integral."""
    (t,), f = opened(node, given.names | {name})
    low, high = node.args[1:]
    if not elementary(low, high) or _integrals(f) or "oo" in symbols(low) | symbols(high):
        raise _OpenError(
            f"{node}: its limits and its integrand must be finite elementary expressions"
        )
    if any(continuous_on(end, given, proof) is not None for end in (low, high)):
        raise _OpenError(f"{node}: its limits could not be shown to be differentiable")
    regions = between(t, low, high, given)
    if not (is_smooth(f, Given()) or all(is_smooth(f, inside) for inside in regions)):
        raise _OpenError(
            f"{node}: its integrand could not be shown to be smooth from {low} to {high}"
        )
    ends = (
        sign_ * substitute(f, {t: end}) * differentiate(end, name)
        for sign_, end in ((1, high), (-1, low))
    )
    inner = differentiate(f, name)
    return add(*ends, ZERO if inner == ZERO else integral(inner, t, low, high))


def between(t: str, low: Expr, high: Expr, given: Given) -> list[Given]:
    """The conditions, and that t is from one end to the other, in each order that may be."""
    x, found = symbol(t), []
    for a, b in ((low, high), (high, low)):
        if sign(b - a, given, "<") != "-":
            found.append(given & Given(((b, ">=", a), (x, ">=", a), (x, "<=", b))))
    return found


def is_smooth(f: Expr, given: Given) -> bool:
    """Whether ``f`` is shown to be smooth, for all smooth functions left unknown in it."""
    while found := list(dict.fromkeys(functions(f))):
        inner = [arg for node in found for arg in node.args[1:]]
        marks: dict[Expr, Expr] = {}
        for node in found:
            taken = symbols(f) | given.names | {str(mark) for mark in marks.values()}
            marks[node] = symbol(fresh("u", taken))
        f = add(replaced(f, marks), *(arg * symbol(fresh("v", symbols(f))) for arg in inner))
    return continuous_on(f, given, proof) is None
