"""Chains: each step checked with the reasons it names and nothing else."""

from __future__ import annotations

import time
from collections.abc import Iterable
from dataclasses import replace

from sympy import (
    Basic,
    Derivative,
    Eq,
    Equivalent,
    Expr,
    Integer,
    Integral,
    MatrixBase,
    Rel,
    Subs,
    Tuple,
    pi,
)
from sympy.core.relational import (
    GreaterThan,
    LessThan,
    Relational,
    StrictGreaterThan,
    StrictLessThan,
)

from tresym.ledger.claim import Chain, Claim, Reason, Step
from tresym.ledger.evidence.defined import Conditions, undefined
from tresym.ledger.evidence.integrals import (
    NotShownError,
    sign_of_integral,
    with_bounds,
    without_integrals,
)
from tresym.ledger.evidence.manifest import NON_NEGATIVE, is_manifest, manifest_sign
from tresym.ledger.finding import StepFinding
from tresym.ledger.meaning import Rules, definitions, put_in, to_expression, to_given
from tresym.reals.decisions.identity import Decision, decide
from tresym.reals.verdict import Verdict

PROVED = StepFinding(Verdict.PROVED, "")

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

MONOTONE = {"cos": (-1, Integer(0), pi), "sin": (1, -pi / 2, pi / 2)}
"""Functions that may be applied to both sides of an inequality: −1 where they turn it round, and
the closed interval, on which they are strictly monotone, that must hold both sides."""


def _undecided(why: str) -> StepFinding:
    return StepFinding(Verdict.UNDECIDED, why)


def check_chain(says: Basic, chain: Chain, given: Conditions) -> tuple[StepFinding, ...]:
    """Findings for every step; all are PROVED exactly when the chain proves ``says``."""
    if not chain:
        return (_undecided("the chain has no step"),)
    start, goal = _ends(says, chain)
    findings, before = [], start
    if goal is None and chain:
        before = _compared(says, chain[0].reasons, given)
        if isinstance(before, StepFinding):
            return (before,)
    for link in chain:
        after = goal if link.expression is None else link.expression
        began = time.perf_counter()
        if after is None:
            finding = _undecided("an inequality needs a form whose sign is manifest")
        else:
            finding = _check_step(before, Step(after, link.reasons), given)
            before = after
        findings.append(replace(finding, seconds=time.perf_counter() - began))
    if all(f.verdict is Verdict.PROVED for f in findings):
        arrival = _arrives(says, before, goal, chain[-1], given)
        if arrival.verdict is not Verdict.PROVED:
            findings.append(arrival)
    return tuple(findings)


def _ends(says: Basic, chain: Chain) -> tuple[Basic, Basic | None]:
    """Where a chain for ``says`` starts, and where it must arrive (None: at a sign)."""
    if isinstance(says, Equivalent):
        first, second = says.args
        last = chain[-1].expression if chain else None
        return (second, first) if last == first else (first, second)
    if isinstance(says, Eq):
        return says.lhs, says.rhs
    if isinstance(says, GreaterThan | StrictGreaterThan | LessThan | StrictLessThan):
        return says.gts - says.lts, None
    raise TypeError(f"a chain cannot prove {says}")


def _compared(says: Basic, reasons: tuple[Reason, ...], given: Conditions) -> Basic | StepFinding:
    """What must be positive (or not negative) for an inequality: the difference of its sides.

    Where the first step applies a monotone function, it is the difference of their values.
    """
    sides = (says.gts, says.lts)
    given = with_bounds(given, reasons)
    for name in (r.function for r in reasons if r.function is not None):
        if name not in MONOTONE:
            return _undecided(f"{name} is not known to be monotone")
        direction, low, high = MONOTONE[name]
        for side in sides:
            for room in (side - low, high - side):
                if manifest_sign(room, given) not in NON_NEGATIVE:
                    return _undecided(f"{side} is not shown to lie where {name} is monotone")
        sides = tuple(direction * _apply(name, side) for side in sides)
    return sides[0] - sides[1]


def _arrives(
    says: Basic, last: Basic, goal: Basic | None, link: Step, given: Conditions
) -> StepFinding:
    """The end of a chain: the right side itself, or a manifest sign."""
    if goal is not None:
        return PROVED if last == goal else _check_step(last, Step(goal, ()), given)
    given = with_bounds(given, link.reasons)
    strict = isinstance(says, StrictGreaterThan | StrictLessThan)
    if isinstance(last, Integral):
        bounds = tuple(c for r in link.reasons if r.name == "citing" for c in r.claims)
        try:
            found = sign_of_integral(last, bounds, given)
        except NotShownError as error:
            return _undecided(str(error))
    else:
        # Without splitting sums first, as for integrals.
        found = None if strict else manifest_sign(last, given, 0)
        found = found if found in NON_NEGATIVE else manifest_sign(last, given)
    if found == "+" or (found in ("0", ">=0") and not strict):
        return PROVED
    return _undecided(f"the sign of {last} is not manifest")


def _check_step(before: Basic, link: Step, given: Conditions) -> StepFinding:
    after = link.expression
    assert after is not None
    if isinstance(before, Eq) and isinstance(after, Eq):
        return _check_equation(before, after, link.reasons, given)
    if isinstance(before, MatrixBase) and isinstance(after, MatrixBase):
        if before.shape != after.shape:
            return _undecided("matrices of different shape")
        pairs = zip(before, after, strict=True)
        return _first_failure(_check_scalar(p, q, link.reasons, given) for p, q in pairs)
    if isinstance(before, Eq | MatrixBase | Tuple) or isinstance(after, Rel | MatrixBase | Tuple):
        return _undecided("the step changes the kind of statement")
    return _check_scalar(before, after, link.reasons, given)


def _first_failure(findings: Iterable[StepFinding]) -> StepFinding:
    for finding in findings:
        if finding.verdict is not Verdict.PROVED:
            return finding
    return PROVED


def _check_equation(
    before: Eq, after: Eq, reasons: tuple[Reason, ...], given: Conditions
) -> StepFinding:
    """Both sides rewritten, or one one-to-one operation applied to both."""
    left, right = before.args
    given = with_bounds(given, reasons)
    # Looked at before SymPy merges them with a side: x·y·(1/y) is written x at once.
    for e in (left, right, *(r.factor for r in reasons), *(r.term for r in reasons)):
        gap = None if e is None else undefined(e, given)
        if gap is not None:
            return _undecided(f"nothing shows that {gap} allows the operation it stands in")
    for reason in reasons:
        if reason.term is not None:
            left, right = left + reason.term, right + reason.term
        if reason.factor is not None:
            if manifest_sign(reason.factor, given) not in ("+", "-"):
                return _undecided(f"{reason.factor} is not shown to be non-zero")
            left, right = left * reason.factor, right * reason.factor
        if reason.function is not None:
            for side in (left, right):
                needed = ONE_TO_ONE.get(reason.function)
                if needed is None:
                    return _undecided(f"{reason.function} is not known to be one-to-one")
                if needed and manifest_sign(side, given) not in needed:
                    return _undecided(f"the sign of {side} is not shown")
            left, right = _apply(reason.function, left), _apply(reason.function, right)
    pairs = ((left, after.lhs), (right, after.rhs))
    return _first_failure(_check_scalar(p, q, reasons, given) for p, q in pairs)


def _apply(function: str, e: Expr) -> Expr:
    import sympy

    return e**2 if function == "square" else getattr(sympy, function)(e)


def _check_scalar(
    before: Basic, after: Basic, reasons: tuple[Reason, ...], given: Conditions
) -> StepFinding:
    """The step from one number to the next, after definitions and integrals are dealt with."""
    used = tuple(c for reason in reasons if reason.name == "substituting" for c in reason.claims)
    try:
        rules, given = instantiated(used, with_bounds(given, reasons))
    except NotShownError as error:
        return _undecided(str(error))
    written = (before, after)
    before, after = meant_by = put_in(before, rules), put_in(after, rules)
    if before.has(Integral) or after.has(Integral):
        try:
            before, after = without_integrals(before, after, reasons, given)
        except NotShownError as error:
            return _undecided(str(error))
    if before != after:
        decision = _decided(before, after, reasons, given)
        if decision.verdict is not Verdict.PROVED:
            return _undecided(decision.why)
    for side, meant in zip(written, meant_by, strict=True):
        gap = undefined(side, given)
        if gap is not None and (side == meant or undefined(meant, given) is not None):
            return _undecided(f"nothing shows that {gap} allows the operation it stands in")
    return PROVED


def _decided(
    before: Basic, after: Basic, reasons: tuple[Reason, ...], given: Conditions
) -> Decision:
    theories = frozenset().union(*(reason.theories for reason in reasons))
    opening = any(reason.name in OPENING for reason in reasons)
    left, right = (to_expression(side, opening) for side in (before, after))
    return decide(left, right, to_given(given), theories)


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
        if not ready:
            first = unmet[waiting[0]]
            raise NotShownError(f"{first} is not shown, but a claim that is used needs it")
        rules |= definitions(ready)
        waiting = tuple(claim for claim in waiting if unmet[claim] is not None)
        replaced = (put_in(condition, rules) for condition in given)
        relations = (c for c in replaced if isinstance(c, Relational))
        elementary = (c for c in relations if not c.has(Integral, Derivative, Subs))
        meant = tuple(dict.fromkeys((*given, *elementary)))
    return rules, meant


def unmet_condition(claim: Claim, rules: Rules, given: Conditions) -> Basic | None:
    """The first condition of a claim that is used which does not follow from ``given``."""
    for condition in claim.given:
        meant = put_in(condition, rules)
        if not {condition, meant} & set(given) and not is_manifest(meant, given):
            return condition
    return None
