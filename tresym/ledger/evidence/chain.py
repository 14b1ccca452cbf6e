"""Check a derivation: every step with the reasons it names, and nothing else."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any

from tresym.ledger.claim import Chain, Claim, Reason
from tresym.ledger.conversion import (
    Conditions,
    Rules,
    Stage,
    conditions,
    definitions,
    known,
    put_in,
    put_into,
    stage,
    tree,
)
from tresym.ledger.evidence.integrals import (
    NotShownError,
    need,
    need_integrals,
    sign_of_integral,
    with_bounds,
    without_integrals,
)
from tresym.ledger.evidence.sign_prover import NON_NEGATIVE, is_manifest, manifest_sign, undefined
from tresym.ledger.finding import StepFinding
from tresym.reals.decisions.identity import Decision, decide_continuous
from tresym.reals.functions.row import everywhere
from tresym.reals.functions.table import names
from tresym.reals.language.binders import generalised, outermost, worked_out
from tresym.reals.language.expression import HALF, PI, ZERO, Expr, apply, replaced, sqrt, symbol
from tresym.reals.language.formula import Conjunction, Equivalence, Formula, Relation
from tresym.reals.verdict import Verdict

OUTSIDE = "could not show that {} lies in the domain of the operation applied to it"
OPENING = ("differentiation", "evaluating")
"""Reasons that allow derivatives and substitutions to be carried out."""

ONE_TO_ONE = {
    **dict.fromkeys(names(lambda row: row.rising and row.needs is everywhere), ()),
    "log": ("+",),
    "sqrt": ("+", "0", ">=0"),
    "square": ("+", "0", ">=0"),
}
"""Injective functions that may be applied to an equation, and the signs that both sides may have
(empty: any sign)."""

MONOTONE = {
    "cos": (-1, ZERO, PI),
    "sin": (1, -PI * HALF, PI * HALF),
    "tan": (1, -PI * HALF, PI * HALF),
}
"""Functions that may be applied to both sides of an inequality: the direction (−1 if decreasing),
and the closed interval of strict monotonicity that must contain both sides."""
OPEN = ("tan",)
"""Those of them that have no value at the ends of the interval."""


def check_chain(says: Formula, chain: Chain, given: Conditions) -> tuple[StepFinding, ...]:
    """Check each step of a chain; the chain proves ``says`` if all findings are PROVED.

    A step is checked by substituting the claims that it names, applying the rules for integrals
    that it names, and comparing exact normal forms with the theories that it allows. Both sides
    must be defined under the conditions.

    Args:
        says: an equation, an inequality, a system of equations or an equivalence of two equations.
        chain: the steps, each with its reasons.
        given: the conditions.

    Returns:
        One finding per step, and one more if the last step does not arrive at the right side or at
        a provable sign.
    """
    try:
        need(bool(chain), "the chain has no steps")
        before, goal = _ends(says, chain, given)
    except NotShownError as error:
        return (StepFinding(Verdict.UNDECIDED, str(error)),)
    findings = []
    for link in chain:
        after = goal if link.expression is None else stage(link.expression)
        after = _as_meant(before, link.reasons, given) if after is None else after
        findings.append(_found(_check_step, before, after, link.reasons, given))
        before = after
    if all(f.verdict is Verdict.PROVED for f in findings):
        arrival = _found(_arrives, says, before, goal, chain[-1].reasons, given)
        findings += [arrival] if arrival.verdict is not Verdict.PROVED else []
    return tuple(findings)


def _found(check: Callable[..., None], *asked: Any) -> StepFinding:
    """Run a check; return PROVED, or UNDECIDED with the reason if it raises NotShownError."""
    began = time.perf_counter()
    try:
        check(*asked)
    except NotShownError as error:
        return StepFinding(Verdict.UNDECIDED, str(error), time.perf_counter() - began)
    return StepFinding(Verdict.PROVED, "", time.perf_counter() - began)


def _as_meant(before: Stage, reasons: tuple[Reason, ...], given: Conditions) -> Stage:
    """Return the result of a step that states no expression: all substitutions carried out."""
    used = tuple(c for reason in reasons if reason.name == "substituting" for c in reason.claims)
    try:
        rules, _ = instantiated(used, with_bounds(given, reasons))
    except NotShownError:
        return before
    if isinstance(before, Relation):
        raise NotShownError("a step that starts at an equation must state the next equation")
    meant = tuple(put_in(e, rules) for e in before)
    opened = any(reason.name in OPENING for reason in reasons)
    return tuple(map(worked_out, meant)) if opened else meant


def _ends(says: Formula, chain: Chain, given: Conditions) -> tuple[Stage, Stage | None]:
    """Return the start of a chain for ``says`` and its goal (None: a form with a provable sign)."""
    match says:
        case Equivalence(Relation(sign="==") as first, Relation(sign="==") as second):
            last = chain[-1].expression
            turned = last is not None and stage(last) == first
            return (second, first) if turned else (first, second)
        case Relation(left, "==", right):
            return (left,), (right,)
        case Relation(sign=">" | ">=" | "<" | "<="):
            return (_compared(says.upward, chain[0].reasons, given),), None
        case Conjunction(parts) if parts and all(
            isinstance(part, Relation) and part.sign == "==" for part in parts
        ):
            entries = [part for part in parts if isinstance(part, Relation)]
            return tuple(e.left for e in entries), tuple(e.right for e in entries)
    raise NotShownError(f"a chain cannot prove {says}")


def _compared(says: Relation, reasons: tuple[Reason, ...], given: Conditions) -> Expr:
    """Return the difference that must be positive (or non-negative) for an inequality.

    If the first step applies a monotone function, the difference is taken of the function values.
    """
    sides = (says.left, says.right)
    given = with_bounds(given, reasons)
    for name in (r.function for r in reasons if r.function is not None):
        need(name in MONOTONE, f"{name} is not known to be monotone")
        direction, low, high = MONOTONE[name]
        for side in sides:
            for distance in (side - low, high - side):
                lies = manifest_sign(distance, given) in (("+",) if name in OPEN else NON_NEGATIVE)
                need(
                    lies,
                    f"could not show that {side} lies in [{low}, {high}], where {name} is monotone",
                )
        sides = (direction * apply(name, sides[0]), direction * apply(name, sides[1]))
    return sides[0] - sides[1]


def _arrives(
    says: Formula, last: Stage, goal: Stage | None, reasons: tuple[Reason, ...], given: Conditions
) -> None:
    """Require that the chain ends at the right side, or at an expression of the required sign."""
    if goal is not None:
        return None if last == goal else _check_step(last, goal, (), given)
    if isinstance(last, Relation) or len(last) != 1 or not isinstance(says, Relation):
        raise NotShownError("the chain for an inequality must end at a single number")
    given, strict = with_bounds(given, reasons), says.sign in (">", "<")
    integrals = dict.fromkeys(node for node in outermost(last[0]) if node.op == "integral")
    numbers = {node: symbol(f"[{n}]") for n, node in enumerate(integrals)}
    bounds = tuple(c for r in reasons if r.name == "citing" for c in r.claims)
    signs = {n: sign_of_integral(node, bounds, given, strict) for node, n in numbers.items()}
    need_integrals((node for node in outermost(last[0]) if node not in numbers), given)
    known = (Relation(n, ">" if sign == "+" else ">=", ZERO) for n, sign in signs.items() if sign)
    # The cited bounds may contain the same integrals, so they are renamed alike.
    cited = (Relation(replaced(c.left, numbers), c.sign, replaced(c.right, numbers)) for c in given)
    wanted = ">" if strict else ">="
    arrived = is_manifest(Relation(replaced(last[0], numbers), wanted, ZERO), (*cited, *known))
    return need(arrived, f"could not show that {last[0]} {wanted} 0")


def _check_step(
    before: Stage, after: Stage, reasons: tuple[Reason, ...], given: Conditions
) -> None:
    """Check a step between two equations, two numbers, or two matrices entry by entry."""
    if isinstance(before, Relation) and isinstance(after, Relation):
        return _check_equation(before, after, reasons, given)
    if isinstance(before, Relation) or isinstance(after, Relation):
        raise NotShownError("a step cannot lead from an equation to an expression or back")
    need(len(before) == len(after), "the two matrices have different shapes")
    for p, q in zip(before, after, strict=True):
        _check_scalar(p, q, reasons, given)
    return None


def _check_equation(
    before: Relation, after: Relation, reasons: tuple[Reason, ...], given: Conditions
) -> None:
    """Check a step between equations: rewriting, or an injective operation on both sides."""
    left, right = before.left, before.right
    given = with_bounds(given, reasons)
    for side in (left, right):
        _need_defined(side, given)
    for reason in reasons:
        if reason.term is not None:
            term = tree(reason.term)
            _need_defined(term, given)
            left, right = left + term, right + term
        if reason.factor is not None:
            factor = tree(reason.factor)
            _need_defined(factor, given)
            nonzero = manifest_sign(factor, given) in ("+", "-")
            need(nonzero, f"could not show that the factor {factor} is not zero")
            left, right = left * factor, right * factor
        if reason.function is not None:
            known = ONE_TO_ONE.get(reason.function)
            if known is None:
                raise NotShownError(f"{reason.function} is not in the list of injective functions")
            for side in (left, right) if known else ():
                need(
                    manifest_sign(side, given) in known,
                    f"could not show the sign of {side} that {reason.function} requires",
                )
            left, right = _apply(reason.function, left), _apply(reason.function, right)
    _check_scalar(left, after.left, reasons, given)
    _check_scalar(right, after.right, reasons, given)


def _need_defined(e: Expr, given: Conditions) -> None:
    """Require that ``e`` is defined under the conditions."""
    gap = undefined(e, given)
    need(gap is None, OUTSIDE.format(gap))


def _apply(function: str, e: Expr) -> Expr:
    if function == "square":
        return e**2
    return sqrt(e) if function == "sqrt" else apply(function, e)


def _check_scalar(
    before: Expr, after: Expr, reasons: tuple[Reason, ...], given: Conditions
) -> None:
    """Check that two numbers are equal: substitute, apply the integral rules, compare."""
    used = tuple(c for reason in reasons if reason.name == "substituting" for c in reason.claims)
    rules, given = instantiated(used, with_bounds(given, reasons))
    written = (before, after)
    before, after = meant_by = put_in(before, rules), put_in(after, rules)
    if any(node.op != "at" for node in outermost(before, after)):
        before, after = without_integrals(before, after, reasons, given)
    if before != after:
        decision = _decided(before, after, reasons, given)
        need(decision.verdict is Verdict.PROVED, decision.why)
    for side, meant in zip(written, meant_by, strict=True):
        gap = undefined(side, given)
        if gap is not None and side != meant:
            gap = undefined(meant, given)
        need(gap is None, OUTSIDE.format(gap))


def _decided(before: Expr, after: Expr, reasons: tuple[Reason, ...], given: Conditions) -> Decision:
    """Decide equality with the theories named; unevaluated integrals etc. count as variables."""
    theories = frozenset().union(*(reason.theories for reason in reasons))
    if any(reason.name in OPENING for reason in reasons):
        before, after = worked_out(before), worked_out(after)
    left, right = generalised(before, after)
    return decide_continuous(left, right, known(given), theories)


def instantiated(used: tuple[Claim, ...], given: Conditions) -> tuple[Rules, Conditions]:
    """Return the substitution rules of the claims used, and the conditions after substitution.

    Every condition of each claim must follow from ``given``, possibly with the rules of claims
    accepted before it. A claim's own equation, or one that still waits for it, is never used to
    show its condition, since that would be circular.

    Args:
        used: the claims whose equations are substituted.
        given: the conditions at hand.

    Raises:
        NotShownError: the condition of a claim could not be shown.
    """
    rules: Rules = {}
    meant, waiting = given, used
    while waiting:
        unmet = {claim: unmet_condition(claim, rules, meant) for claim in waiting}
        ready = tuple(claim for claim in waiting if unmet[claim] is None)
        first = unmet[waiting[0]]
        need(
            bool(ready),
            f"{waiting[0].label} is used here but holds only under {first}, which could not be "
            "shown",
        )
        rules |= definitions(ready)
        waiting = tuple(claim for claim in waiting if unmet[claim] is not None)
        meant = tuple(dict.fromkeys((*given, *put_into(given, rules))))
    return rules, meant


def unmet_condition(claim: Claim, rules: Rules, given: Conditions) -> Relation | None:
    """Return the first condition of ``claim`` that is not shown from ``given``, or None.

    Args:
        claim: a claim that is used.
        rules: substitutions applied to its conditions.
        given: the conditions at hand.
    """
    for condition in conditions(claim.given):
        (meant,) = put_into((condition,), rules)
        if not {condition, meant} & {*given} and not is_manifest(meant, given):
            return condition
    return None
    return None
