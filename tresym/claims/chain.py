"""Chains: each step checked with the reasons it names and nothing else."""

from __future__ import annotations

import time
from collections.abc import Iterable
from dataclasses import replace

from sympy import Basic, Eq, Equivalent, Expr, Integer, Integral, MatrixBase, Rel, Symbol, Tuple, pi
from sympy.core.relational import GreaterThan, LessThan, StrictGreaterThan, StrictLessThan

from tresym.claims.claim import Chain, Claim, Definition, Reason, Step, citing, parts_of
from tresym.claims.domain import Conditions, continuous_on, undefined
from tresym.claims.finding import StepFinding
from tresym.claims.signs import NON_NEGATIVE, is_manifest, manifest_sign
from tresym.claims.translate import Rules, definitions, put_in, to_expression, to_given
from tresym.identity import decide
from tresym.verdict import Verdict

PROVED = StepFinding(Verdict.PROVED, "")

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
    given = _with_bounds(given, reasons)
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
    found = manifest_sign(last, _with_bounds(given, link.reasons))
    strict = isinstance(says, StrictGreaterThan | StrictLessThan)
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
    given = _with_bounds(given, reasons)
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
    rules = definitions(used)
    given = _with_bounds(given, reasons)
    given = tuple(dict.fromkeys((*given, *(put_in(condition, rules) for condition in given))))
    spoken_of = frozenset().union(*(e.free_symbols for e in (before, after, *given)))
    unmet = unmet_condition(used, rules, given, spoken_of)
    if unmet is not None:
        return _undecided(f"{unmet} is not shown, but a claim that is put in needs it")
    written = (before, after)
    before, after = put_in(before, rules), put_in(after, rules)
    for side, meant in zip(written, (before, after), strict=True):
        gap = undefined(side, given)
        if gap is not None and (side == meant or undefined(meant, given) is not None):
            return _undecided(f"nothing shows that {gap} allows the operation it stands in")
    if before == after:
        return PROVED
    for reason in reasons:
        if reason.expression is not None and (before.has(Integral) or after.has(Integral)):
            prepared = _without_integral(before, after, reason, given)
            if isinstance(prepared, StepFinding):
                return prepared
            before, after = prepared
    theories = frozenset().union(*(reason.theories for reason in reasons))
    opening = any(reason.name == "differentiation" for reason in reasons)
    decision = decide(
        to_expression(before, opening),
        to_expression(after, opening),
        to_given(given),
        theories,
    )
    return PROVED if decision.verdict is Verdict.PROVED else _undecided(decision.why)


def unmet_condition(
    used: tuple[Claim, ...], rules: Rules, given: Conditions, spoken_of: frozenset[Basic]
) -> Basic | None:
    """The first condition of a claim that is put in which does not follow from ``given``.

    Conditions of definitions on symbols that neither the claim put in nor the statement
    (``spoken_of``) names are those under which its symbols exist: they stand wherever they do.
    """
    for claim in used:
        named = spoken_of.union(*(part.free_symbols for part in parts_of(claim.says)))
        defining = (c for c in (claim, *claim.rests_on) if isinstance(c.proof, Definition))
        existing = {condition for c in defining for condition in c.given}
        for condition in claim.given:
            meant = put_in(condition, rules)
            if condition in existing and not condition.free_symbols & named:
                continue
            if {condition, meant} & set(given):
                continue
            if not is_manifest(meant, given):
                return condition
    return None


def _with_bounds(given: Conditions, reasons: tuple[Reason, ...]) -> Conditions:
    """The conditions, and the cited bounds whose own conditions are among them."""
    bounds = list(given)
    for reason in reasons:
        if reason.name == "citing":
            for claim in reason.claims:
                if set(claim.given) <= set(bounds):
                    parts = parts_of(claim.says)
                    bounds += (p for p in parts if isinstance(p, Rel) and not isinstance(p, Eq))
    return tuple(bounds)


def _without_integral(
    before: Basic, after: Basic, reason: Reason, given: Conditions
) -> tuple[Basic, Basic] | StepFinding:
    """Carry out a change of variable or an integration; what is left is plain algebra."""
    primitive = reason.expression
    assert primitive is not None
    if reason.name == "integrating":
        integrals = before.atoms(Integral) | after.atoms(Integral)
        if len(integrals) != 1:
            return _undecided("the step needs exactly one integral")
        (integral,) = integrals
        failure = _check_antiderivative(integral, primitive, reason.claims, given)
        if failure is not None:
            return failure
        variable, low, high = integral.limits[0]
        value = {integral: primitive.subs(variable, high) - primitive.subs(variable, low)}
        return before.xreplace(value), after.xreplace(value)
    pair = (*before.atoms(Integral), *after.atoms(Integral))
    if len(pair) != 2:
        return _undecided("the step needs one integral on each side")
    old, new = pair if pair[0].variables[0] in primitive.free_symbols else pair[::-1]
    failure = _check_substitution(old, new, primitive, reason.claims, given)
    if failure is not None:
        return failure
    same = {integral: Symbol("[the integral]", real=True) for integral in pair}
    return before.xreplace(same), after.xreplace(same)


def _inside(integral: Integral, bounds: tuple[Claim, ...], given: Conditions) -> Conditions:
    """The conditions on the interval of integration, with the bounds cited for it.

    Conditions on the variable of integration are dropped: it runs over the whole interval,
    whatever a claim assumes of a symbol of that name.
    """
    variable, low, high = integral.limits[0]
    outside = tuple(c for c in given if variable not in c.free_symbols)
    inside = (*outside, (variable - low) * (high - variable) >= 0)
    if manifest_sign(high - low, outside) in NON_NEGATIVE:
        inside = (*inside, variable >= low, variable <= high)
    return _with_bounds(inside, (citing(*bounds),))


def _check_antiderivative(
    integral: Integral, primitive: Expr, bounds: tuple[Claim, ...], given: Conditions
) -> StepFinding | None:
    """None when ``primitive`` is smooth on the interval and its derivative is the integrand."""
    conditions = _inside(integral, bounds, given)
    for e in (primitive, integral.function):
        gap = continuous_on(e, conditions)
        if gap is not None:
            return _undecided(f"nothing shows that {gap} stays off its singularity")
    slope = primitive.diff(integral.variables[0], evaluate=False)
    decision = decide(
        to_expression(slope, open_derivatives=True),
        to_expression(integral.function),
        to_given(conditions),
    )
    return None if decision.verdict is Verdict.PROVED else _undecided(decision.why)


def _check_substitution(
    old: Integral, new: Integral, change: Expr, bounds: tuple[Claim, ...], given: Conditions
) -> StepFinding | None:
    """∫ g(u(ψ)) u′(ψ) dψ = ∫ g dx: integrands, limits and continuity."""
    variable, low, high = old.limits[0]
    fresh, start, end = new.limits[0]
    conditions = _inside(old, bounds, given)
    pulled = new.function.subs(fresh, change)
    for e in (old.function, change, pulled):
        gap = continuous_on(e, conditions)
        if gap is not None:
            return _undecided(f"nothing shows that {gap} stays off its singularity")
    slope = to_expression(change.diff(variable, evaluate=False), open_derivatives=True)
    pairs = (
        (to_expression(old.function), to_expression(pulled) * slope),
        (to_expression(change.subs(variable, low)), to_expression(start)),
        (to_expression(change.subs(variable, high)), to_expression(end)),
    )
    for left, right in pairs:
        decision = decide(left, right, to_given(conditions))
        if decision.verdict is not Verdict.PROVED:
            return _undecided(decision.why)
    return None
