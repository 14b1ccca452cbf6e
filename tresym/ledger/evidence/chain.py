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
from tresym.reals.language.binders import generalised, outermost, worked_out
from tresym.reals.language.expression import HALF, PI, ZERO, Expr, apply, replaced, sqrt, symbol
from tresym.reals.language.formula import Conjunction, Equivalence, Formula, Relation
from tresym.reals.verdict import Verdict

OPENING = ("differentiation", "evaluating")
"""Reasons by which derivatives and values are worked out."""

ONE_TO_ONE = {
    "exp": (),
    "sinh": (),
    "tanh": (),
    "asinh": (),
    "atan": (),
    "log": ("+",),
    "sqrt": ("+", "0", ">=0"),
    "square": ("+", "0", ">=0"),
}
"""Strictly monotone functions, and the sign that both sides must be shown to have."""

MONOTONE = {"cos": (-1, ZERO, PI), "sin": (1, -PI * HALF, PI * HALF)}
"""Functions that may be applied to both sides of an inequality: −1 where they turn it round, and
the closed interval, on which they are strictly monotone, that must hold both sides."""


def check_chain(says: Formula, chain: Chain, given: Conditions) -> tuple[StepFinding, ...]:
    """Findings for every step; all are PROVED exactly when the chain proves ``says``."""
    try:
        need(bool(chain), "the chain has no step")
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
    """What checking a step comes to: PROVED where nothing that it asks for is missing."""
    began = time.perf_counter()
    try:
        check(*asked)
    except NotShownError as error:
        return StepFinding(Verdict.UNDECIDED, str(error), time.perf_counter() - began)
    return StepFinding(Verdict.PROVED, "", time.perf_counter() - began)


def _as_meant(before: Stage, reasons: tuple[Reason, ...], given: Conditions) -> Stage:
    """What a step leads to that names no form: all put in and worked out by which it has a sign."""
    used = tuple(c for reason in reasons if reason.name == "substituting" for c in reason.claims)
    try:
        rules, _ = instantiated(used, with_bounds(given, reasons))
    except NotShownError:
        return before
    if isinstance(before, Relation):
        raise NotShownError("a step from an equation names the next one")
    meant = tuple(put_in(e, rules) for e in before)
    opened = any(reason.name in OPENING for reason in reasons)
    return tuple(map(worked_out, meant)) if opened else meant


def _ends(says: Formula, chain: Chain, given: Conditions) -> tuple[Stage, Stage | None]:
    """Where a chain for ``says`` starts, and where it must arrive (None: at a sign)."""
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
    """What must be positive (or not negative) for an inequality: the difference of its sides.

    Where the first step applies a monotone function, it is the difference of their values.
    """
    sides = (says.left, says.right)
    given = with_bounds(given, reasons)
    for name in (r.function for r in reasons if r.function is not None):
        need(name in MONOTONE, f"{name} is not known to be monotone")
        direction, low, high = MONOTONE[name]
        for side in sides:
            for room in (side - low, high - side):
                lies = manifest_sign(room, given) in NON_NEGATIVE
                need(lies, f"{side} is not shown to lie where {name} is monotone")
        sides = (direction * apply(name, sides[0]), direction * apply(name, sides[1]))
    return sides[0] - sides[1]


def _arrives(
    says: Formula,
    last: Stage,
    goal: Stage | None,
    reasons: tuple[Reason, ...],
    given: Conditions,
) -> None:
    """That a chain ends at the right side itself, or at a manifest sign."""
    if goal is not None:
        return None if last == goal else _check_step(last, goal, (), given)
    if isinstance(last, Relation) or len(last) != 1 or not isinstance(says, Relation):
        raise NotShownError("an inequality is shown by the sign of a number")
    given, strict = with_bounds(given, reasons), says.sign in (">", "<")
    integrals = dict.fromkeys(node for node in outermost(last[0]) if node.op == "integral")
    numbers = {node: symbol(f"[{n}]") for n, node in enumerate(integrals)}
    bounds = tuple(c for r in reasons if r.name == "citing" for c in r.claims)
    signs = {n: sign_of_integral(node, bounds, given, strict) for node, n in numbers.items()}
    need_integrals((node for node in outermost(last[0]) if node not in numbers), given)
    known = (Relation(n, ">" if sign == "+" else ">=", ZERO) for n, sign in signs.items() if sign)
    # What is cited may bound the same integrals.
    cited = (Relation(replaced(c.left, numbers), c.sign, replaced(c.right, numbers)) for c in given)
    wanted = ">" if strict else ">="
    arrived = is_manifest(Relation(replaced(last[0], numbers), wanted, ZERO), (*cited, *known))
    return need(arrived, f"the sign of {last[0]} is not manifest")


def _check_step(
    before: Stage, after: Stage, reasons: tuple[Reason, ...], given: Conditions
) -> None:
    if isinstance(before, Relation) and isinstance(after, Relation):
        return _check_equation(before, after, reasons, given)
    if isinstance(before, Relation) or isinstance(after, Relation):
        raise NotShownError("the step changes the kind of statement")
    need(len(before) == len(after), "matrices of different shape")
    for p, q in zip(before, after, strict=True):
        _check_scalar(p, q, reasons, given)
    return None


def _check_equation(
    before: Relation, after: Relation, reasons: tuple[Reason, ...], given: Conditions
) -> None:
    """Both sides rewritten, or one one-to-one operation applied to both."""
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
            need(nonzero, f"{factor} is not shown to be non-zero")
            left, right = left * factor, right * factor
        if reason.function is not None:
            known = ONE_TO_ONE.get(reason.function)
            if known is None:
                raise NotShownError(f"{reason.function} is not known to be one-to-one")
            for side in (left, right) if known else ():
                need(manifest_sign(side, given) in known, f"the sign of {side} is not shown")
            left, right = _apply(reason.function, left), _apply(reason.function, right)
    _check_scalar(left, after.left, reasons, given)
    _check_scalar(right, after.right, reasons, given)


def _need_defined(e: Expr, given: Conditions) -> None:
    gap = undefined(e, given)
    need(gap is None, f"nothing shows that {gap} allows the operation it stands in")


def _apply(function: str, e: Expr) -> Expr:
    if function == "square":
        return e**2
    return sqrt(e) if function == "sqrt" else apply(function, e)


def _check_scalar(
    before: Expr, after: Expr, reasons: tuple[Reason, ...], given: Conditions
) -> None:
    """The step from one number to the next, after definitions and integrals are dealt with."""
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
        need(gap is None, f"nothing shows that {gap} allows the operation it stands in")


def _decided(before: Expr, after: Expr, reasons: tuple[Reason, ...], given: Conditions) -> Decision:
    """Whether both are equal by the theories named, with what stays unworked as variables."""
    theories = frozenset().union(*(reason.theories for reason in reasons))
    if any(reason.name in OPENING for reason in reasons):
        before, after = worked_out(before), worked_out(after)
    left, right = generalised(before, after)
    return decide_continuous(left, right, known(given), theories)


def instantiated(used: tuple[Claim, ...], given: Conditions) -> tuple[Rules, Conditions]:
    """What the claims that are put in say, and the conditions as they read with that.

    All conditions of each are shown, from ``given`` and by what those before it say: none lends
    itself, or another that waits for it, the equation by which its own condition holds.

    Raises:
        NotShownError: a condition is not shown.
    """
    rules: Rules = {}
    meant, waiting = given, used
    while waiting:
        unmet = {claim: unmet_condition(claim, rules, meant) for claim in waiting}
        ready = tuple(claim for claim in waiting if unmet[claim] is None)
        first = unmet[waiting[0]]
        need(bool(ready), f"{first} is not shown, but a claim that is used needs it")
        rules |= definitions(ready)
        waiting = tuple(claim for claim in waiting if unmet[claim] is not None)
        meant = tuple(dict.fromkeys((*given, *put_into(given, rules))))
    return rules, meant


def unmet_condition(claim: Claim, rules: Rules, given: Conditions) -> Relation | None:
    """The first condition of a claim that is used which does not follow from ``given``."""
    for condition in conditions(claim.given):
        (meant,) = put_into((condition,), rules)
        if not {condition, meant} & {*given} and not is_manifest(meant, given):
            return condition
    return None
    return None
