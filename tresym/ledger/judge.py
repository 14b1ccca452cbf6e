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
from typing import Any

from tresym.ledger.claim import (
    AllOf,
    Claim,
    Counterexample,
    Definition,
    Dominated,
    Follows,
    FromSlope,
    FromTheEdge,
    ImplicitFunction,
    InfimumBy,
    Instance,
    Monotone,
    MonotoneOf,
    Printed,
    Root,
    RootBound,
    RootMonotone,
    asked_by,
)
from tresym.ledger.conversion import (
    CircularError,
    Conditions,
    conditions,
    defined,
    dependencies,
    dependent,
    known,
)
from tresym.ledger.counterexamples import contradiction
from tresym.ledger.definitions import captured, conflict, judge_definition, table
from tresym.ledger.evidence.allowed_evidence import unfit
from tresym.ledger.evidence.asymptotics import Asymptotics, failing_order
from tresym.ledger.evidence.box_bounds import Boxes
from tresym.ledger.evidence.chart_bounds import Charted, judge_charted
from tresym.ledger.evidence.decided import Decided, judge_decided
from tresym.ledger.evidence.deductions import (
    cited,
    judge_dominated,
    judge_from_slope,
    judge_from_the_edge,
    judge_infimum,
    judge_monotone_of,
    judge_root_bound,
    judge_root_monotone,
    parts_under,
)
from tresym.ledger.evidence.integrals import NotShownError, need, need_integrals, with_bounds
from tresym.ledger.evidence.interval_evaluation import Evaluated, judge_evaluated
from tresym.ledger.evidence.local_facts import by_facts, facts_of
from tresym.ledger.evidence.printed_numbers import judge_printed
from tresym.ledger.evidence.refutation import Denied, denied_somewhere, judge_counterexample
from tresym.ledger.evidence.sign_prover import is_manifest, undefined
from tresym.ledger.finding import WEAKEST_FIRST, Finding, StepFinding
from tresym.ledger.formulas import (
    Says,
    Tending,
    Under,
    binders_in,
    is_equation,
    names_of,
    parts_of,
    relations_of,
    sides_of,
)
from tresym.ledger.judged_roots import judge_at_most_one, judge_implicit_function
from tresym.ledger.reasons import citing
from tresym.ledger.refutations import (
    PROVED,
    REFUTED,
    UNDECIDED,
    all_facts_behind,
    facts_used,
    need_possible,
    refuted_part,
)
from tresym.reals.balls.branch_and_bound import CertificateError
from tresym.reals.cross_check import STOPPED
from tresym.reals.decisions.identity import decide_continuous
from tresym.reals.language.binders import generalised
from tresym.reals.language.expression import Expr, symbols
from tresym.reals.language.formula import Relation
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict

Findings = Mapping[str, Finding]

NEVER_ATTACKED = (
    *(Definition, Root, ImplicitFunction, AllOf, Monotone, Asymptotics),
    *(Follows, RootMonotone, MonotoneOf, InfimumBy, Dominated),
)
"""Evidence whose claims skip the independent check: a single point cannot contradict their
statements, or (for conjunctions) the parts are checked one by one."""
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
    try:
        return _attacked(claim, _judge(claim, found))
    except (CircularError, InputError) as error:
        return Finding(UNDECIDED, str(error))
    except CertificateError as error:
        why = f"the stored proof does not hold ({error}); --full searches for a new one"
        return Finding(UNDECIDED, why)


def _attacked(claim: Claim, finding: Finding) -> Finding:
    """Return the finding, or UNDECIDED if the independent check contradicts the statement."""
    if not finding.verdict.holds or isinstance(claim.proof, NEVER_ATTACKED):
        return finding
    says = claim.statement
    if isinstance(says, Tending):  # no single point contradicts it, and the engine attacked it
        return finding
    if says is None or not _can_be_evaluated(says, claim):
        return finding
    try:
        values = tuple(c for c in claim.given if is_equation(c))
        given = tuple(c for c in claim.given if c not in values)
        worlds = _worlds(claim, says)
        tried = (contradiction(says, given, (*taken, *values)) for taken in worlds)
        against = next((why for why in tried if why is not None), None)
    except (CircularError, InputError):
        return finding
    if against is None:
        return finding
    return replace(finding, verdict=UNDECIDED, why=STOPPED.format(against), stopped=True)


def _worlds(claim: Claim, says: Says) -> tuple[tuple[Any, ...], ...]:
    """Return the sets of equations that the independent check assumes, one attempt for each.

    If no symbol of the statement is defined anywhere, only the conditions are assumed. Otherwise
    the claims used are assumed first, and then only the definitions behind them, because a used
    claim may itself be wrong.
    """
    spoken_of = names_of(says, *claim.given)
    if all(spoken_of.isdisjoint(entry.names) for entry in table(claim.rests_on)):
        return ((),)
    return tuple(dict.fromkeys((facts_used(claim), all_facts_behind(claim))))


def _can_be_evaluated(says: Says, claim: Claim) -> bool:
    """Return whether every symbol may take all values that the conditions allow.

    In claims shown on boxes, a symbol may stand for a quantity without a definition, such as a
    term of higher order; such a claim can only be checked if its conditions name the symbol.
    """
    known = names_of(*claim.given)
    shown = Instance | RootBound | FromSlope | FromTheEdge | Decided
    attacked = isinstance(claim.proof, shown)
    return attacked or names_of(says) <= known


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
        why = captured(claim) or conflict((*claim.rests_on, claim))
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
        slope = not isinstance(claim.says, str) and is_equation(claim.means)
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
            finding = _judge_all(claims, found)
            if finding.verdict is REFUTED:
                false = next(c for c in claims if found[c.label].verdict is REFUTED)
                if not _contains(claim, false):
                    return Finding(UNDECIDED, f"{false.label}, which it names, is refuted")
            if finding.verdict.holds and not isinstance(claim.says, str):
                cited(claim, claims)
            return finding
        case Follows():
            return _judge_parts(claim, claim.proof)
        case RootBound():
            return judge_root_bound(claim, claim.proof)
        case RootMonotone():
            return judge_root_monotone(claim, claim.proof)
        case MonotoneOf():
            return judge_monotone_of(claim, claim.proof)
        case FromSlope():
            return judge_from_slope(claim, claim.proof)
        case FromTheEdge():
            return judge_from_the_edge(claim, claim.proof)
        case InfimumBy():
            return judge_infimum(claim, claim.proof)
        case Dominated():
            return judge_dominated(claim, claim.proof)
        case Counterexample():
            return judge_counterexample(claim, claim.proof)
        case Monotone():
            return judge_at_most_one(claim, claim.proof)
        case ImplicitFunction():
            return judge_implicit_function(claim, claim.proof)
        case Instance():
            return _unless(partial(refuted_part, claim), _judge_instance, claim, claim.proof)
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
        case Decided():
            attack = partial(refuted_part, claim)
            finding = _unless(attack, judge_decided, claim, claim.proof)
            if finding.verdict is UNDECIDED and claim.expect is REFUTED:
                return attack() or finding
            return finding
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


def _judge_with_facts(claim: Claim, found: Findings) -> Finding:
    """Prove the claim's local facts in order, then judge the claim with their help.

    If a fact cannot be shown, the claim is still judged without the facts: it may be false.
    """
    steps: tuple[StepFinding, ...] = ()
    facts = facts_of(claim)
    for fact in facts:
        shown = _guarded(fact, {})
        verdict = shown.verdict if isinstance(shown.verdict, Verdict) else UNDECIDED
        steps += shown.steps or (StepFinding(verdict, shown.why),)
        if shown.verdict is not PROVED:
            alone = _judge(replace(claim, knowing=()), found)
            why = f"the local fact {fact.says} could not be shown: {shown.why}"
            return alone if alone.verdict is REFUTED else Finding(UNDECIDED, why, steps=steps)
    finding = _judge(by_facts(claim, facts), found)
    return replace(finding, steps=steps + finding.steps)


def _contains(claim: Claim, part: Claim) -> bool:
    """Return whether a conjunction states all that one of the claims that it names states."""
    if claim.statement is None or part.statement is None:
        return claim.statement is None and not getattr(claim.proof, "words", False)
    stated = {*parts_under(claim.statement, claim.given)}
    return {*parts_under(part.statement, part.given)} <= stated


def _judge_parts(claim: Claim, proof: Follows) -> Finding:
    """Judge each part of the statement by its own evidence, under its own conditions.

    Raises:
        NotShownError: a part is not shown, or there is not one piece of evidence for each part.
    """
    parts: tuple[Any, ...] = claim.parts
    if len(parts) != len(proof.parts) or not parts:
        raise NotShownError("there must be one piece of evidence for each part of the statement")
    findings = []
    for n, (part, evidence) in enumerate(zip(parts, proof.parts, strict=True), 1):
        given = claim.given
        while isinstance(part, Under):
            given = (*given, *part.given)
            part = part.formula
        alone = Claim(f"{claim.label}, part {n}", part, evidence, given=given)
        if isinstance(evidence, AllOf):
            need(cited(alone, evidence.claims) is not None, f"part {n} has no formula")
            findings.append(Finding(PROVED, f"part {n} is one of a claim named"))
            continue
        finding = _guarded(alone, {})
        if finding.verdict is REFUTED:
            return replace(finding, why=f"part {n}: {finding.why}")
        need(finding.verdict.holds, f"part {n}: {finding.why}", finding.steps)
        findings.append(finding)
    weakest = min((f.verdict for f in findings), key=WEAKEST_FIRST.index)
    steps = tuple(s for f in findings for s in f.steps)
    why = "; ".join(dict.fromkeys(f.why for f in findings))
    return Finding(weakest, why, steps=steps)


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
    labels = tuple(c.label for c in claims)
    return Finding(weakest, f"follows from {', '.join(labels)}", follows_from=labels)


def _judge_instance(claim: Claim, proof: Instance) -> Finding:
    """Return PROVED if the statement is an instance of an earlier claim.

    The values must be given to variables (not to defined or bound symbols), and they must satisfy
    every condition of the general claim.
    """
    general = proof.claim
    parts = () if isinstance(general.says, str) else parts_of(general.says)
    written = (*parts, *general.given)
    plain = bool(parts) and general.means is None and all(isinstance(e, Relation) for e in written)
    need(plain, f"{general.label} has no instances, because it does not consist of relations")
    names = {name for name, _ in proof.values}
    finite = all("oo" not in symbols(e) for _, e in proof.values)
    need(finite, "an instance gives numbers to variables, and oo is none")
    need(all(map(str.isidentifier, names)), "an instance may only replace variables")
    bound = any(binders_in(*sides_of(written)))
    bound = bound or bool(names & defined(general))
    need(not bound, "an instance must not replace a symbol that is bound or defined")
    _need_independent(general, written, names)
    need_possible(claim)
    given = with_bounds(conditions(claim.given), (citing(*proof.cited),))
    same = _is_instance(parts_of(claim.says), parts_of(proof.says), given)
    need(same, f"the statement is not {general.label} with these values substituted")
    for condition in conditions(tuple(map(proof.put, general.given))):
        met = condition in given or is_manifest(condition, given)
        need(met, f"the instance needs {condition}, which could not be shown")
    both = (*relations_of(claim.says), *relations_of(proof.says))
    _need_values([side for part in both for side in (part.left, part.right)], given)
    return Finding(PROVED, f"it is an instance of {general.label}")


def _is_instance(says: tuple[Any, ...], put: tuple[Any, ...], given: Conditions) -> bool:
    """Return whether relations are those of another list, with sides that are equal."""
    if says == put:
        return True
    return len(says) == len(put) and all(
        isinstance(one, Relation)
        and one.sign == other.sign
        and _is_equal(one.left, other.left, given)
        and _is_equal(one.right, other.right, given)
        for one, other in zip(says, put, strict=True)
    )


def _is_equal(one: Expr, other: Expr, given: Conditions) -> bool:
    left, right = generalised(one, other)
    return one == other or decide_continuous(left, right, known(given)).verdict is PROVED


def _need_independent(claim: Claim, written: Iterable[Any], names: Iterable[str]) -> None:
    """Require that no symbol in ``written`` is defined in terms of the symbols ``names``.

    If y is defined as x², then replacing x alone would leave y unchanged and prove a falsehood.
    """
    spoken_of = names_of(*written)
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
