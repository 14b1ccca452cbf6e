"""Judge a claim: the only place where verdicts on the ledger's claims are given.

The type of the evidence selects a checking function (`_by_kind`). A claim is PROVED if its
evidence passes every check. Otherwise a counterexample is searched for, and the claim is REFUTED
only if ball arithmetic shows at an exact point that it is false. A claim that uses another claim
which does not hold is UNDECIDED, whatever its own evidence.

Before a claim passes, an independent check tries to contradict it at other points
(`_attacked`, `tresym.reals.cross_check`); if it succeeds, the claim is UNDECIDED and the
contradiction is reported.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from time import perf_counter
from typing import Any

from sympy import Basic, Derivative, Eq, Integral, Subs, Symbol
from sympy.core.relational import Relational

from tresym.ledger.claim import (
    AllOf,
    Chain,
    Claim,
    Counterexample,
    Definition,
    Formally,
    ImplicitFunction,
    Instance,
    Monotone,
    Printed,
    Root,
    Together,
    UniqueRoot,
    asked_by,
    by,
    chains_of,
    equal,
    parts_of,
)
from tresym.ledger.conversion import (
    CircularError,
    Conditions,
    conditions,
    defined,
    definitions,
    dependencies,
    dependent,
    formula,
    known,
    put_in,
    put_into,
    tree,
)
from tresym.ledger.counterexamples import (
    contradiction,
    rootless,
    scalars,
    violation,
)
from tresym.ledger.definitions import (
    captured,
    conflict,
    confused,
    judge_definition,
    restrictions,
    table,
)
from tresym.ledger.evidence.admissible import unfit
from tresym.ledger.evidence.asymptotics import (
    Asymptotics,
    Squeezed,
    failing_order,
    judge_squeezed,
)
from tresym.ledger.evidence.box_bounds import Boxes
from tresym.ledger.evidence.chain import check_chain, instantiated, unmet_condition
from tresym.ledger.evidence.chart_bounds import Charted, judge_charted
from tresym.ledger.evidence.integrals import (
    NotShownError,
    need,
    need_integrals,
    need_smooth,
    under_binder,
    with_bounds,
)
from tresym.ledger.evidence.interval_evaluation import Evaluated, judge_evaluated
from tresym.ledger.evidence.local_facts import by_facts, facts_of
from tresym.ledger.evidence.printed_numbers import judge_printed
from tresym.ledger.evidence.refutation import Denied, denied_somewhere, judge_counterexample
from tresym.ledger.evidence.satisfiability import satisfiable
from tresym.ledger.evidence.sign_prover import continuous_on, is_manifest, manifest_sign, undefined
from tresym.ledger.finding import WEAKEST_FIRST, Finding, StepFinding
from tresym.ledger.reasons import citing, substituting
from tresym.ledger.statements import AtMostOne, Binding, ExactlyOne, ForSome
from tresym.reals.balls.branch_and_bound import CertificateError
from tresym.reals.cross_check import STOPPED
from tresym.reals.decisions.identity import decide_continuous
from tresym.reals.language.binders import derivative, elementary, generalised
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import ZERO, Expr, substitute, symbols
from tresym.reals.language.formula import Relation, relations
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict

Findings = Mapping[str, Finding]

NEVER_ATTACKED = (
    *(Definition, Root, ImplicitFunction, AllOf, UniqueRoot, Monotone, Asymptotics, Squeezed),
)
"""Evidence whose claims skip the independent check: a single point cannot contradict their
statements, or (for conjunctions) the parts have been checked already."""

UNDECIDED, PROVED, REFUTED = Verdict.UNDECIDED, Verdict.PROVED, Verdict.REFUTED
ENCLOSED = Verdict.ENCLOSED


def judge(claim: Claim, found: Findings, evidence: Finding | None = None) -> Finding:
    """Return the finding on ``claim``, given the findings on the claims it uses.

    Args:
        claim: the claim to judge.
        found: findings by label; they must include all claims that ``claim`` uses.
        evidence: the result of :func:`judge_evidence` if it is known already; None to compute it.

    Raises:
        InputError: ``found`` lacks a claim that is used.
    """
    began = time.perf_counter()
    before = evidence.seconds if evidence else 0.0
    finding = _resting_on_sand(claim, found) or evidence or _guarded(claim, found)
    if finding.verdict is PROVED and any(found[u.label].verdict is ENCLOSED for u in claim.uses):
        # An exact argument from an enclosed premise gives an enclosed conclusion only.
        finding = replace(finding, verdict=ENCLOSED)
    seconds = before + time.perf_counter() - began
    return replace(finding, seconds=seconds, of=claim, conditions=asked_by(claim))


def judge_evidence(claim: Claim) -> Finding | None:
    """Return the finding on the claim's own evidence, assuming that the claims it uses hold.

    Needs no other findings, so claims can be judged in parallel. None for a conjunction, whose
    only evidence is the findings on its parts.
    """
    if isinstance(claim.proof, AllOf):
        return None
    began = time.perf_counter()
    return replace(_guarded(claim, {}), seconds=time.perf_counter() - began)


def _guarded(claim: Claim, found: Findings) -> Finding:
    """Judge the evidence and cross-check the result; errors in the input give UNDECIDED."""
    start = perf_counter()
    try:
        finding = _judge(claim, found)
        return _attacked(claim, finding, perf_counter() - start)
    except (CircularError, InputError) as error:
        return Finding(UNDECIDED, str(error))
    except CertificateError as error:
        why = f"the stored proof does not hold ({error}); --full searches for a new one"
        return Finding(UNDECIDED, why)


def _attacked(claim: Claim, finding: Finding, spent: float) -> Finding:
    """Return the finding, or UNDECIDED if the independent check contradicts the statement."""
    if not finding.verdict.holds or isinstance(claim.proof, NEVER_ATTACKED):
        return finding
    says = claim.statement
    if says is None or not _can_be_evaluated(says, claim):
        return finding
    try:
        values = tuple(c for c in claim.given if isinstance(c, Eq))
        given = tuple(c for c in claim.given if c not in values)
        worlds = _worlds(claim, says)
        tried = (contradiction(says, given, (*taken, *values), spent) for taken in worlds)
        against = next((why for why in tried if why is not None), None)
    except (CircularError, InputError):
        return finding
    if against is None:
        return finding
    return replace(finding, verdict=UNDECIDED, why=STOPPED.format(against), stopped=True)


def _worlds(claim: Claim, says: Basic) -> tuple[tuple[Basic, ...], ...]:
    """Return the sets of equations that the independent check assumes, one attempt for each.

    If no symbol of the statement is defined anywhere, only the conditions are assumed. Otherwise
    the claims used are assumed first, and then only the definitions behind them, because a used
    claim may itself be wrong.
    """
    spoken_of = {str(s) for e in (says, *claim.given) for s in e.free_symbols}
    if all(spoken_of.isdisjoint(entry.names) for entry in table(claim.rests_on)):
        return ((),)
    return tuple(dict.fromkeys((_known(claim), _behind(claim))))


def _can_be_evaluated(says: Basic, claim: Claim) -> bool:
    """Return whether every symbol may take all values that the conditions allow.

    In claims shown on boxes, a symbol may stand for a quantity without a definition, such as a
    term of higher order; such a claim can only be checked if its conditions name the symbol.
    """
    known = frozenset().union(*(condition.free_symbols for condition in claim.given))
    attacked = isinstance(claim.proof, tuple | Together | Formally | Instance)
    return attacked or says.free_symbols <= known


def _resting_on_sand(claim: Claim, found: Findings) -> Finding | None:
    """Return UNDECIDED if the definitions conflict or a used claim does not hold, else None.

    Conjunctions are exempt from the second test: `_judge_all` gives them the verdict of their
    weakest part.
    """
    for used in claim.uses:
        if used.label not in found:
            raise InputError(f"{claim.label} uses {used.label}, which has not been judged yet")
        if found[used.label].of not in (None, used):
            return Finding(UNDECIDED, f"another claim labelled {used.label} was judged")
    try:
        why = confused(claim) or captured(claim) or conflict((*claim.rests_on, claim))
    except InputError as error:
        why = str(error)
    if why is not None:
        return Finding(UNDECIDED, why)
    if isinstance(claim.proof, AllOf):
        return None
    for used in claim.uses:
        if not found[used.label].verdict.holds:
            verdict = found[used.label].verdict.value
            return Finding(UNDECIDED, f"depends on {used.label}, which is {verdict}")
    return None


def _judge(claim: Claim, found: Findings) -> Finding:
    """Return the finding on the evidence; UNDECIDED if a side condition could not be shown."""
    try:
        why = unfit(claim)
        need(why is None, f"{why}")
        finding = _judge_with_facts(claim, found) if claim.knowing else _by_kind(claim, found)
        slope = isinstance(claim.says, Basic) and isinstance(claim.means, Eq)
        need(
            not (slope and finding.verdict.holds),
            "the formula only confirms a derivative, which does not prove the stated order",
        )
        return finding
    except NotShownError as error:
        return Finding(UNDECIDED, str(error), steps=error.steps)


def _by_kind(claim: Claim, found: Findings) -> Finding:
    """Call the checking function for the claim's type of evidence."""
    match claim.proof:
        case Definition() | Root():
            return judge_definition(claim, claim.proof)
        case Printed():
            return judge_printed(claim)
        case AllOf(claims):
            return _judge_all(claims, found)
        case Formally():
            return _judge_relations(claim)
        case Counterexample():
            return judge_counterexample(claim, claim.proof)
        case UniqueRoot():
            return _judge_unique_root(claim, claim.proof)
        case Monotone():
            return _judge_at_most_one(claim, claim.proof)
        case ImplicitFunction():
            return _judge_implicit_function(claim, claim.proof)
        case Instance():
            return _unless(partial(_refuted, claim), _judge_instance, claim, claim.proof)
        case Together() | tuple() if claim.statement is not None:
            return _judge_chains(claim, chains_of(claim.statement, claim.proof))
        case Charted():
            finding = judge_charted(claim, claim.proof)
            return finding if finding.verdict.holds else denied_somewhere(claim) or finding
        case Evaluated():
            return judge_evaluated(claim, claim.proof)
        case Asymptotics():
            shown = failing_order(claim)
            return shown or Finding(
                UNDECIDED, "no asymptotic expansion was found that contradicts the order"
            )
        case Squeezed():
            return _unless(partial(failing_order, claim), judge_squeezed, claim, claim.proof)
        case Boxes():
            return claim.proof.judge(", ".join(map(str, claim.given)))
        case Denied():
            return claim.proof.judge()
        case _:
            raise NotShownError(
                f"{type(claim.proof).__name__} is not a supported type of evidence for this claim"
            )


def _unless(
    other: Callable[[], Finding | None], judged: Callable[..., Finding], *asked: Any
) -> Finding:
    """Return ``judged(*asked)``; if it fails to show something, the result of ``other``."""
    try:
        return judged(*asked)
    except NotShownError:
        finding = other()
        if finding is None:
            raise
        return finding


def _need_all(steps: tuple[StepFinding, ...]) -> None:
    """Require that there is at least one step and that every step is PROVED."""
    why = next((s.why for s in steps if s.verdict is not PROVED), None)
    need(why is None, f"{why}", steps)
    need(bool(steps), "there is nothing to prove")


def _judge_with_facts(claim: Claim, found: Findings) -> Finding:
    """Prove the claim's local facts in order, then judge the claim with their help.

    If a fact cannot be shown, the claim is still judged without the facts: it may be false.
    """
    steps: tuple[StepFinding, ...] = ()
    facts = facts_of(claim)
    for fact in facts:
        shown = _guarded(fact, {})
        steps += shown.steps
        if shown.verdict is not PROVED:
            alone = _judge(replace(claim, knowing=()), found)
            why = f"the local fact {fact.says} could not be shown: {shown.why}"
            return alone if alone.verdict is REFUTED else Finding(UNDECIDED, why, steps=steps)
    finding = _judge(by_facts(claim, facts), found)
    return replace(finding, steps=steps + finding.steps)


def _judge_chains(claim: Claim, parts: tuple[tuple[Basic, Chain], ...] | None) -> Finding:
    """Return PROVED if every step of every chain is; otherwise search for a counterexample."""
    if parts is None:
        raise NotShownError(
            "the proof must have one chain for each part of the statement, but their numbers differ"
        )
    _need_possible(claim)
    given = conditions(claim.given)
    steps = tuple(s for says, chain in parts for s in check_chain(formula(says), chain, given))

    try:
        _need_all(steps)
    except NotShownError:
        refuted = next(filter(None, (refute(says, claim) for says, _ in parts)), None)
        if refuted is None:
            raise
        return replace(refuted, steps=steps)
    return Finding(PROVED, "every step follows from the reasons it names", steps=steps)


def _need_possible(claim: Claim) -> None:
    """Require a point that satisfies the conditions: nothing is proved from impossible ones."""
    need(
        _possible(claim),
        "no exact point was found that satisfies the conditions, so nothing is proved; "
        "check the conditions",
    )


def _possible(claim: Claim) -> bool:
    """Return whether a point satisfies the conditions, with the definitions substituted."""
    given = conditions(claim.given)
    if not all(elementary(c.left, c.right) for c in given):
        return False
    explicit = [entry for entry in table(claim.rests_on) if entry.explicit]
    rules = {entry.symbol: entry.meaning for entry in explicit}
    bounds = put_into(with_bounds(given, (citing(*claim.uses),)), rules)
    if known(bounds).satisfying_point() is None:
        return False
    assumed = restrictions(claim.rests_on)
    written = (entry.written for entry in explicit)
    return not assumed or satisfiable(claim.given, (*written, *assumed))


def refute(says: Basic, claim: Claim) -> Finding | None:
    """Return REFUTED with a point that violates ``says``, or None if no such point is found.

    The point satisfies the conditions of ``claim`` and the equations of the claims it uses; ball
    arithmetic proves that ``says`` fails there.
    """
    try:
        for known in dict.fromkeys((_known(claim), _behind(claim))):
            found = violation(says, claim.given, known)
            if found is not None:
                return Finding(REFUTED, found.why, witness=found.point)
    except (CircularError, InputError):
        return None
    return None


def seen_false(claim: Claim) -> Finding:
    """Return REFUTED if a counterexample is found without using the evidence, else UNDECIDED."""
    found = denied_somewhere(claim) if isinstance(claim.proof, Charted) else _refuted(claim)
    return found or Finding(UNDECIDED, "neither a proof nor a counterexample was found")


def _refuted(claim: Claim) -> Finding | None:
    """Return REFUTED for the first part of the statement with a counterexample, or None."""
    found = (refute(says, claim) for says in claim.parts)
    return next((finding for finding in found if finding is not None), None)


def _behind(claim: Claim) -> tuple[Basic, ...]:
    """Return the equations and conditions of all definitions that the claim depends on.

    If the claim uses definitions only, or if two different claims have the same label, this is the
    same as `_known`.
    """
    defining = Definition | Root | ImplicitFunction
    if all(isinstance(c.proof, defining) for c in claim.uses):
        return _known(claim)
    used = {c.label: c for c in claim.rests_on if isinstance(c.proof, defining)}
    if any(used.get(c.label, c) is not c for c in claim.rests_on):
        return _known(claim)
    known = dict.fromkeys(c for d in (*used.values(), *claim.uses) for c in d.given)
    known.update((p, None) for d in used.values() for p in parts_of(d.says))
    return tuple(known)


def _known(claim: Claim) -> tuple[Basic, ...]:
    """Return the statements and conditions of the used claims that concern defined symbols.

    A used claim without any definition behind it is left out: it holds for all values that satisfy
    its conditions, so it restricts nothing, and whether its conditions hold is just what may be
    wrong.
    """
    known: dict[Basic, None] = {}
    for used in claim.uses:
        if table((used, *used.rests_on)):
            known.update(dict.fromkeys(used.given))
            known.update((p, None) for p in parts_of(used.decided) if isinstance(p, Relational))
    return tuple(known)


def _judge_all(claims: tuple[Claim, ...], found: Findings) -> Finding:
    """Judge a conjunction: the verdict of its weakest part; a refuted part refutes it."""
    if not claims:
        return Finding(UNDECIDED, "there is nothing to prove")
    for claim in claims:
        finding = found[claim.label]
        if finding.verdict is REFUTED:
            why = f"{claim.label} is refuted: {finding.why}"
            return Finding(REFUTED, why, witness=finding.witness)
        if finding.verdict is UNDECIDED:
            return Finding(UNDECIDED, f"{claim.label} is undecided")
    weakest = min((found[c.label].verdict for c in claims), key=WEAKEST_FIRST.index)
    return Finding(weakest, "follows from " + ", ".join(c.label for c in claims))


def _judge_unique_root(claim: Claim, proof: UniqueRoot) -> Finding:
    """Return PROVED if there is exactly one root, REFUTED if balls exclude any root."""
    root = claim.statement
    if not isinstance(root, ExactlyOne) or root.difference is None:
        raise NotShownError(
            "this evidence proves that an equation has exactly one root, but the claim states "
            "something else"
        )
    _need_bound(claim, root)
    stated = root.variable, root.difference, root.low, root.high
    try:
        return _one_root(proof, stated, conditions(claim.given))
    except NotShownError as error:
        none = rootless(root.difference, root.variable, (root.low, root.high), claim.given)
        if none is None:
            raise
        return Finding(REFUTED, none.why, witness=none.point, steps=error.steps)


def _need_bound(claim: Claim, says: ExactlyOne | AtMostOne) -> None:
    """Require that the ends do not depend on the bound variable and the conditions are possible."""
    x = says.variable
    free = x not in says.low.free_symbols | says.high.free_symbols
    need(free, f"the ends of the interval must not depend on the bound variable {x}")
    _need_possible(claim)


def _one_root(proof: UniqueRoot, stated: tuple[Basic, ...], given: Conditions) -> Finding:
    """Prove existence and uniqueness: continuity, opposite signs at the ends, a monotone function.

    ``stated`` is the variable, the function (difference of the sides) and the two ends.
    """
    v, h, low, high = map(tree, stated)
    name = str(v)
    # The root may lie anywhere in the interval, so conditions on the variable must not be used.
    given = without(name, given)
    gap = continuous_on(h, (*given, Relation(v, ">=", low), Relation(v, "<=", high)))
    need(gap is None, f"could not show that {gap} stays away from its singularity")
    inside = (*given, Relation(v, ">", low), Relation(v, "<", high))
    start = derivative(h, name)
    steps, slope = _chain_to_sign(start, proof.derivative, inside)
    signs = []
    for end, chain in ((low, proof.at_low), (high, proof.at_high)):
        found, sign = _chain_to_sign(substitute(h, {name: end}), chain, given)
        steps += found
        signs.append(sign)
    _need_all(steps)
    why = (
        "exactly one root needs a derivative of one sign and opposite signs at the ends, but the "
        f"signs found are: derivative {slope}, ends {signs[0]} and {signs[1]}"
    )
    need(slope in ("+", "-") and sorted(map(str, signs)) == ["+", "-"], why, steps)
    why = "the signs at the ends are opposite and the derivative has one sign"
    return Finding(PROVED, why, steps=steps)


def _judge_at_most_one(claim: Claim, proof: Monotone) -> Finding:
    """Return PROVED if left minus right side is smooth and increasing between the ends."""
    says = claim.statement
    if not isinstance(says, AtMostOne) or says.difference is None:
        raise NotShownError(
            "this evidence proves that an equation has at most one root, but the claim states "
            "something else"
        )
    _need_bound(claim, says)
    v, low, high, difference = map(tree, (*says.args[:3], says.difference))
    name = says.variable.name
    given = without(name, conditions(claim.given))
    inside = (*given, Relation(v, ">", low), Relation(v, "<", high))
    need_smooth(difference, inside)
    rising = Relation(differentiate(difference, name), ">", ZERO)
    steps = check_chain(rising, proof.slope, inside)
    _need_all(steps)
    return Finding(PROVED, "left side minus right side is increasing on the interval", steps=steps)


def without(name: str, given: Conditions) -> Conditions:
    """Return the conditions in which the symbol ``name`` does not occur."""
    return tuple(c for c in given if name not in symbols(c.left) | symbols(c.right))


def _chain_to_sign(
    start: Expr, chain: Chain, given: Conditions
) -> tuple[tuple[StepFinding, ...], str | None]:
    """Check a chain that starts at ``start``; return its steps and the sign of its last form."""
    if not chain or chain[-1].expression is None:
        why = "the last step of the chain must state an expression whose sign can be proved"
        return (StepFinding(UNDECIDED, why),), None
    last = tree(chain[-1].expression)
    steps = check_chain(Relation(start, "==", last), chain, given)
    return steps, manifest_sign(last, given)


def _judge_instance(claim: Claim, proof: Instance) -> Finding:
    """Return PROVED if the statement is an instance of an earlier claim.

    The values must be given to variables (not to defined or bound symbols), and they must satisfy
    every condition of the general claim.
    """
    general = proof.claim
    parts = parts_of(general.says) if isinstance(general.says, Basic) else ()
    written = (*parts, *general.given)
    plain = (
        bool(parts) and general.means is None and all(isinstance(e, Relational) for e in written)
    )
    need(plain, f"{general.label} has no instances, because it does not consist of relations")
    variables = all(isinstance(x, Symbol) for x, _ in proof.values)
    need(variables, "an instance may only replace variables, not expressions")
    bound = any(e.atoms(Integral, Derivative, Subs, Binding) for e in written)
    bound = bound or any(x.name in defined(general) for x, _ in proof.values)
    need(not bound, "an instance must not replace a symbol that is bound or defined")
    _need_independent(general, written, {x.name for x, _ in proof.values})
    need(
        claim.says == proof.says,
        f"the statement is not {general.label} with these values substituted",
    )
    _need_possible(claim)
    given = with_bounds(conditions(claim.given), (citing(*proof.cited),))
    for condition in conditions(tuple(map(proof.put, general.given))):
        met = condition in given or is_manifest(condition, given)
        need(met, f"the instance needs {condition}, which could not be shown")
    says = relations(formula(claim.says))
    _need_values([side for part in says for side in (part.left, part.right)], given)
    return Finding(PROVED, f"it is an instance of {general.label}")


def _need_independent(claim: Claim, written: Iterable[Basic], names: Iterable[str]) -> None:
    """Require that no symbol in ``written`` is defined in terms of the symbols ``names``.

    If y is defined as x², then replacing x alone would leave y unchanged and prove a falsehood.
    """
    spoken_of = {s.name for e in written for s in e.free_symbols if isinstance(s, Symbol)}
    name = dependent(spoken_of, names, dependencies((*claim.rests_on, claim)))
    need(
        name is None,
        f"{name} is defined in terms of a symbol that is replaced, but would stay unchanged",
    )


def _need_values(sides: Sequence[Expr], given: Conditions) -> None:
    """Require that both sides are defined, integrals included."""
    for side in sides:
        gap = undefined(side, given)
        need(gap is None, f"could not show that {gap} lies in the domain of its operation")
    need_integrals(sides, given)


def _judge_implicit_function(claim: Claim, proof: ImplicitFunction) -> Finding:
    """Return PROVED if the implicit function theorem applies and gives the stated derivative."""
    needs_equations = "implicit differentiation needs an equation and states an equation"
    if not (isinstance(proof.equation.decided, Eq) and isinstance(claim.says, Eq)):
        raise NotShownError(needs_equations)
    equation, says = formula(proof.equation.decided), formula(claim.says)
    if not isinstance(equation, Relation) or not isinstance(says, Relation):
        raise NotShownError(needs_equations)
    need(equation.sign == says.sign == "==", needs_equations)
    u, p, at = proof.unknown.name, proof.parameter.name, tree(proof.at)
    left, right = equation.left, equation.right
    fixed = u != p and not {u, p} & (symbols(right) | symbols(at))
    need(
        fixed,
        "the right side of the equation must not depend on the unknown or on the parameter",
    )
    new = says.left.op == "symbol" and says.left not in definitions(claim.rests_on)
    need(new and not symbols(says.left) & symbols(left), f"{says.left} is not a new symbol")
    outside = without(p, conditions(claim.given))
    there = substitute(left, {p: at})
    by_unknown = derivative(there, u)
    slope = -derivative(left, p, at) / by_unknown
    if not under_binder(says.right, slope, outside):
        why = "the stated derivative differs from the derivative of the implicit function"
        other = Finding(UNDECIDED, why)
        return _refuted_slope(claim, proof) or other
    _need_possible(claim)
    place = tree(proof.parameter)
    near = (*outside, Relation(place, ">=", at), Relation(place, "<=", at))
    unmet = unmet_condition(proof.equation, {}, near)
    need(unmet is None, f"the equation holds only under {unmet}, which could not be shown")
    need_smooth(left, near)
    steps, sign = _chain_to_sign(by_unknown, proof.slope, outside)
    _need_all(steps)
    manifest = sign in ("+", "-")
    need(manifest, f"could not show the sign of the derivative with respect to {u}", steps)
    written = tuple(c for c in claim.given if proof.parameter not in c.free_symbols)
    on_curve = (proof.equation.decided.xreplace({proof.parameter: proof.at}),)
    need(satisfiable(written, on_curve), "no point was found that satisfies the equation", steps)
    why = f"the equation is smooth and its derivative with respect to {u} is not zero"
    return Finding(PROVED, why, steps=steps)


def _refuted_slope(claim: Claim, proof: ImplicitFunction) -> Finding | None:
    """Return REFUTED with a point of the curve where the stated derivative is wrong, or None."""
    says, equation = claim.says, proof.equation.decided
    assert isinstance(says, Basic)
    assert isinstance(equation, Basic)
    left, p = equation.args[0], proof.parameter
    by_unknown = Derivative(left.xreplace({p: proof.at}), proof.unknown)
    slope = -Subs(Derivative(left, p), p, proof.at) / by_unknown
    return refute(
        equal(says.args[1], slope), replace(claim, proof=by(substituting(proof.equation)))
    )


def _judge_relations(claim: Claim) -> Finding:
    """Judge the relations one by one; the first that is not PROVED determines the finding.

    A statement "for some values, φ" is refuted by proving the negation of φ for all values.
    """
    says = claim.statement
    if isinstance(says, ForSome):
        (some,) = says.args
        never = some.negated if isinstance(some, Relational) else None
        need(isinstance(never, Relational), "could not show that the relation holds at no point")
        _without_chain(never, claim)
        where = known(conditions(claim.given)).satisfying_point()
        return Finding(
            REFUTED, f"{never} holds for all values, for example at the witness", witness=where
        )
    relations = [entry for part in claim.parts for entry in scalars(part)]
    need(bool(relations), "the statement contains no relation that could be decided")
    for relation in relations:
        need(isinstance(relation, Relational), f"{relation} is not a relation")
        refuted = partial(refute, relation, claim)
        finding = _unless(refuted, _without_chain, relation, claim)
        if finding.verdict is not PROVED:
            return finding
    return finding


def _without_chain(written: Relational, claim: Claim) -> Finding:
    """Prove one relation: an equation by normal forms, an inequality by the sign prover."""
    _need_possible(claim)
    relation, given = formula(written), conditions(claim.given)
    if not isinstance(relation, Relation):
        raise NotShownError(f"{written} is not a relation between numbers")
    rules, _ = instantiated(claim.uses, given)
    meant = put_into(given, rules)
    plain = tuple(c for c in meant if elementary(c.left, c.right))
    left, right = (put_in(side, rules) for side in (relation.left, relation.right))
    if relation.sign == "==":
        one, other = generalised(left, right)
        decision = decide_continuous(one, other, known(plain))
        shown, why = decision.verdict is PROVED, decision.why
    else:
        shown = is_manifest(Relation(left, relation.sign, right), plain)
        why = (
            "the sign of the difference of the two sides is proven"
            if shown
            else "could not determine the sign of the difference of the two sides"
        )
    need(shown, why)
    _need_values((left, right), plain)
    return Finding(PROVED, why)
