"""From a claim to a finding: the one place where verdicts on claims are given.

A claim is PROVED when its evidence checks; otherwise it is tried at exact points, and REFUTED
only when a ball excludes it at one of them. A claim that rests on one that does not hold is
UNDECIDED, whatever its own evidence.
"""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from dataclasses import replace
from time import process_time

from sympy import Basic, Derivative, Eq, Integral, Subs
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
from tresym.ledger.definitions import (
    captured,
    conflict,
    judge_definition,
    restrictions,
    table,
)
from tresym.ledger.evidence.asymptotics import Asymptotics, judge_asymptotics
from tresym.ledger.evidence.balls import Boxes
from tresym.ledger.evidence.chain import check_chain, instantiated, unmet_condition
from tresym.ledger.evidence.charted import Charted, judge_charted
from tresym.ledger.evidence.denial import Denied, denied_somewhere, judge_counterexample
from tresym.ledger.evidence.evaluated import Evaluated, judge_evaluated
from tresym.ledger.evidence.facts import by_facts, facts_of
from tresym.ledger.evidence.integrals import (
    NotShownError,
    need_integrals,
    need_smooth,
    under_binder,
    with_bounds,
)
from tresym.ledger.evidence.manifest import continuous_on, is_manifest, manifest_sign, undefined
from tresym.ledger.evidence.meant import unfit
from tresym.ledger.evidence.printed import judge_printed
from tresym.ledger.evidence.satisfied import satisfiable
from tresym.ledger.finding import WEAKEST_FIRST, Finding, StepFinding
from tresym.ledger.meaning import (
    CircularError,
    Conditions,
    conditions,
    defined,
    definitions,
    formula,
    known,
    put_in,
    put_into,
    tree,
)
from tresym.ledger.reasons import citing, substituting
from tresym.ledger.second_look import (
    contradiction,
    rootless,
    scalars,
    violation,
)
from tresym.ledger.statements import AtMostOne, ExactlyOne, ForSome
from tresym.reals.advocate import STOPPED
from tresym.reals.balls.boxes import CertificateError
from tresym.reals.decisions.identity import decide
from tresym.reals.language.binders import derivative, elementary, generalised
from tresym.reals.language.expression import ZERO, Expr, differentiate, substitute, symbols
from tresym.reals.language.formula import Relation, relations
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict

Findings = Mapping[str, Finding]

NEVER_ATTACKED = (*(Definition, Root, ImplicitFunction, AllOf, UniqueRoot, Monotone, Asymptotics),)
"""What says nothing that a point could contradict, and conjunctions, whose parts were attacked."""

UNDECIDED, PROVED, REFUTED = Verdict.UNDECIDED, Verdict.PROVED, Verdict.REFUTED


def judge(claim: Claim, found: Findings, evidence: Finding | None = None) -> Finding:
    """The finding on ``claim``, given those on the claims it uses.

    Args:
        claim: what to judge.
        found: findings by label, those on all that the claim uses among them.
        evidence: what :func:`judge_evidence` has found, where it was asked before.
    """
    began = time.perf_counter()
    before = evidence.seconds if evidence else 0.0
    finding = _resting_on_sand(claim, found) or evidence or _guarded(claim, found)
    seconds = before + time.perf_counter() - began
    return replace(finding, seconds=seconds, of=claim, conditions=asked_by(claim))


def judge_evidence(claim: Claim) -> Finding | None:
    """The finding on the claim's own evidence, all it uses taken to hold; needs no other finding.

    None for a conjunction, which has no evidence but the findings on its parts.
    """
    if isinstance(claim.proof, AllOf):
        return None
    began = time.perf_counter()
    return replace(_guarded(claim, {}), seconds=time.perf_counter() - began)


def _guarded(claim: Claim, found: Findings) -> Finding:
    start = process_time()
    try:
        finding = _judge(claim, found)
        return _attacked(claim, finding, process_time() - start)
    except (CircularError, InputError) as error:
        return Finding(UNDECIDED, str(error))
    except CertificateError as error:
        why = f"the stored proof does not hold ({error}); --full searches for a new one"
        return Finding(UNDECIDED, why)


def _attacked(claim: Claim, finding: Finding, spent: float) -> Finding:
    """The finding, unless balls contradict the formula at the advocate's points."""
    if not finding.verdict.holds or isinstance(claim.proof, NEVER_ATTACKED):
        return finding
    says = claim.statement
    if says is None or not _can_be_evaluated(says, claim):
        return finding
    try:
        values = tuple(c for c in claim.given if isinstance(c, Eq))
        given = tuple(c for c in claim.given if c not in values)
        against = contradiction(says, given, (*_known(claim), *values), spent)
    except CircularError:
        return finding
    if against is None:
        return finding
    return replace(finding, verdict=UNDECIDED, why=STOPPED.format(against), stopped=True)


def _can_be_evaluated(says: Basic, claim: Claim) -> bool:
    """Whether every symbol may take all values that the conditions allow.

    In what boxes enclose, symbols may stand for what is defined nowhere, as higher orders are.
    """
    known = frozenset().union(*(condition.free_symbols for condition in claim.given))
    return isinstance(claim.proof, tuple | Together | Formally) or says.free_symbols <= known


def _resting_on_sand(claim: Claim, found: Findings) -> Finding | None:
    """UNDECIDED when what is used is no ground: definitions that conflict, a claim that fails.

    A conjunction is as strong as its parts are found to be.
    """
    for used in claim.uses:
        if found[used.label].of not in (None, used):
            return Finding(UNDECIDED, f"another claim labelled {used.label} was judged")
    why = captured(claim) or conflict((*claim.rests_on, claim))
    if why is not None:
        return Finding(UNDECIDED, why)
    if isinstance(claim.proof, AllOf):
        return None
    for used in claim.uses:
        if not found[used.label].verdict.holds:
            verdict = found[used.label].verdict.value
            return Finding(UNDECIDED, f"rests on {used.label}, which is {verdict}")
    return None


def _judge(claim: Claim, found: Findings) -> Finding:
    why = unfit(claim)
    if why is not None:
        return Finding(UNDECIDED, why)
    if claim.knowing:
        return _judge_with_facts(claim, found)
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
            finding = _judge_instance(claim, claim.proof)
            return finding if finding.verdict is PROVED else _refuted(claim) or finding
        case Together() | tuple() if claim.statement is not None:
            return _judge_chains(claim, chains_of(claim.statement, claim.proof))
        case Charted():
            finding = judge_charted(claim, claim.proof)
            return finding if finding.verdict.holds else denied_somewhere(claim) or finding
        case Evaluated():
            return judge_evaluated(claim, claim.proof)
        case Asymptotics():
            return judge_asymptotics(claim, claim.proof)
        case Boxes() | Denied():
            return claim.proof.judge()
        case _:
            return Finding(UNDECIDED, "that is no kind of evidence")


def _judge_with_facts(claim: Claim, found: Findings) -> Finding:
    """The finding by the claim's local facts, in the order in which each is shown.

    Where one is not, what is said may still be false.
    """
    steps: tuple[StepFinding, ...] = ()
    facts = facts_of(claim)
    for fact in facts:
        shown = _guarded(fact, {})
        steps += shown.steps
        if shown.verdict is not PROVED:
            alone = _judge(replace(claim, knowing=()), found)
            why = f"the fact {fact.says} is not shown: {shown.why}"
            return alone if alone.verdict is REFUTED else Finding(UNDECIDED, why, steps=steps)
    finding = _judge(by_facts(claim, facts), found)
    return replace(finding, steps=steps + finding.steps)


def _judge_chains(claim: Claim, parts: tuple[tuple[Basic, Chain], ...] | None) -> Finding:
    """PROVED when every step of every chain is; otherwise tried at exact points."""
    if parts is None:
        return Finding(UNDECIDED, "the statement has another number of parts than the proof")
    if not _possible(claim):
        return Finding(UNDECIDED, "no exact point is found that satisfies the conditions")
    given = conditions(claim.given)
    steps: list[StepFinding] = []
    for says, chain in parts:
        steps.extend(check_chain(formula(says), chain, given))
    failed = next((s for s in steps if s.verdict is not PROVED), None)
    if not steps:
        return Finding(UNDECIDED, "there is nothing to prove")
    if failed is None:
        return Finding(PROVED, "every step follows from the reasons it names", steps=tuple(steps))
    for says, _ in parts:
        refuted = refute(says, claim)
        if refuted is not None:
            return replace(refuted, steps=tuple(steps))
    return Finding(UNDECIDED, failed.why, steps=tuple(steps))


def _possible(claim: Claim) -> bool:
    """Whether an exact point satisfies the conditions, as the symbols in them are defined."""
    given = conditions(claim.given)
    if not _met_somewhere(given):
        return False
    behind = (c for c in claim.rests_on if isinstance(c.proof, Definition))
    explicit = [entry for entry in table(behind) if entry.explicit]
    rules = {entry.symbol: entry.meaning for entry in explicit}
    bounds = put_into(with_bounds(given, (citing(*claim.uses),)), rules)
    if known(bounds).satisfying_point() is None:
        return False
    assumed = restrictions(claim.rests_on)
    written = (entry.written for entry in explicit)
    return not assumed or satisfiable(claim.given, (*written, *assumed))


def _met_somewhere(given: Conditions) -> bool:
    """Whether an exact point is found at which the conditions hold, which are elementary."""
    plain = all(elementary(c.left, c.right) for c in given)
    return plain and known(given).satisfying_point() is not None


def refute(says: Basic, claim: Claim) -> Finding | None:
    """REFUTED with a point at which balls violate ``says`` and all that is used holds, or None."""
    try:
        for known in dict.fromkeys((_known(claim), _behind(claim))):
            found = violation(says, claim.given, known)
            if found is not None:
                return Finding(REFUTED, found.why, witness=found.point)
    except (CircularError, InputError):
        return None
    return None


def seen_false(claim: Claim) -> Finding:
    """The finding on a claim without its evidence: REFUTED where a point shows it, else open."""
    found = denied_somewhere(claim) if isinstance(claim.proof, Charted) else _refuted(claim)
    return found or Finding(UNDECIDED, "nothing shows it, and nothing shows it to be false")


def _refuted(claim: Claim) -> Finding | None:
    """The first part of the statement that is refuted, or None."""
    found = (refute(says, claim) for says in claim.parts)
    return next((finding for finding in found if finding is not None), None)


def _behind(claim: Claim) -> tuple[Basic, ...]:
    """The definitions behind all that is used: where they hold, so does what follows from them.

    What is used, where that is definitions, or where two of them define one symbol.
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
    """What the claims that are used say of what is defined, and under which conditions.

    Where no definition stands behind a claim it restricts nothing: it holds wherever its conditions
    do, and whether they do is what a user of it may have got wrong.
    """
    known: dict[Basic, None] = {}
    for used in claim.uses:
        if table((used, *used.rests_on)):
            known.update(dict.fromkeys(used.given))
            known.update((p, None) for p in parts_of(used.says) if isinstance(p, Relational))
    return tuple(known)


def _judge_all(claims: tuple[Claim, ...], found: Findings) -> Finding:
    """A conjunction: as strong as its weakest part; one refuted part refutes it."""
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
    """PROVED by its evidence, or REFUTED where balls show that there is no root at all."""
    root = claim.statement
    if not isinstance(root, ExactlyOne) or root.difference is None:
        return Finding(UNDECIDED, "the statement is not that an equation has exactly one root")
    why = _ill_bound(claim, root)
    if why is not None:
        return Finding(UNDECIDED, why)
    stated = root.variable, root.difference, root.low, root.high
    finding = _one_root(proof, stated, conditions(claim.given))
    if finding.verdict is PROVED:
        return finding
    none = rootless(root.difference, root.variable, (root.low, root.high), claim.given)
    return Finding(REFUTED, none.why, witness=none.point, steps=finding.steps) if none else finding


def _ill_bound(claim: Claim, says: ExactlyOne | AtMostOne) -> str | None:
    """Why a statement on roots is none: its variable is no name of its own, or nothing is given."""
    if says.variable in says.low.free_symbols | says.high.free_symbols:
        return f"{says.variable} is bound, and the ends depend on it"
    if not _possible(claim):
        return "no exact point is found that satisfies the conditions"
    if any(says.variable.name in defined(used) for used in claim.uses):
        return f"{says.variable} is bound, and is defined in what is used"
    return None


def _one_root(proof: UniqueRoot, stated: tuple[Basic, ...], given: Conditions) -> Finding:
    """Continuity, a derivative of one sign inside, and opposite signs at the ends."""
    v, h, low, high = map(tree, stated)
    name = str(v)
    # The root is looked for in the whole interval, whatever is assumed of the symbol.
    given = without(name, given)
    gap = continuous_on(h, (*given, Relation(v, ">=", low), Relation(v, "<=", high)))
    if gap is not None:
        return Finding(UNDECIDED, f"nothing shows that {gap} stays off its singularity")
    inside = (*given, Relation(v, ">", low), Relation(v, "<", high))
    start = derivative(h, name)
    steps, slope = _chain_to_sign(start, proof.derivative, inside)
    signs = []
    for end, chain in ((low, proof.at_low), (high, proof.at_high)):
        found, sign = _chain_to_sign(substitute(h, {name: end}), chain, given)
        steps += found
        signs.append(sign)
    failed = next((s for s in steps if s.verdict is not PROVED), None)
    if failed is not None:
        return Finding(UNDECIDED, failed.why, steps=steps)
    if slope not in ("+", "-") or sorted(map(str, signs)) != ["+", "-"]:
        why = f"signs found: derivative {slope}, ends {signs[0]} and {signs[1]}"
        return Finding(UNDECIDED, why, steps=steps)
    why = "opposite signs at the ends, derivative of one sign"
    return Finding(PROVED, why, steps=steps)


def _judge_at_most_one(claim: Claim, proof: Monotone) -> Finding:
    """PROVED where the left side less the right one is smooth, and rises, between the ends."""
    says = claim.statement
    if not isinstance(says, AtMostOne) or says.difference is None:
        return Finding(UNDECIDED, "the evidence is for an equation with one root at most")
    why = _ill_bound(claim, says)
    if why is not None:
        return Finding(UNDECIDED, why)
    v, low, high, difference = map(tree, (*says.args[:3], says.difference))
    name = says.variable.name
    given = without(name, conditions(claim.given))
    inside = (*given, Relation(v, ">", low), Relation(v, "<", high))
    try:
        need_smooth(difference, inside)
    except NotShownError as error:
        return Finding(UNDECIDED, str(error))
    rising = Relation(differentiate(difference, name), ">", ZERO)
    steps = check_chain(rising, proof.slope, inside)
    failed = next((s for s in steps if s.verdict is not PROVED), None)
    if not steps or failed is not None:
        return Finding(UNDECIDED, failed.why if failed else "nothing is shown", steps=steps)
    return Finding(PROVED, "the difference of the sides rises throughout", steps=steps)


def without(name: str, given: Conditions) -> Conditions:
    """The conditions that do not speak of a symbol."""
    return tuple(c for c in given if name not in symbols(c.left) | symbols(c.right))


def _chain_to_sign(
    start: Expr, chain: Chain, given: Conditions
) -> tuple[tuple[StepFinding, ...], str | None]:
    """A chain from ``start`` to a form of manifest sign, and that sign."""
    if not chain or chain[-1].expression is None:
        return (StepFinding(UNDECIDED, "the chain ends at no expression"),), None
    last = tree(chain[-1].expression)
    steps = check_chain(Relation(start, "==", last), chain, given)
    return steps, manifest_sign(last, given)


def _judge_instance(claim: Claim, proof: Instance) -> Finding:
    """PROVED when the values are of variables, and every condition of the claim holds of them."""
    general = proof.claim
    bound = any(e.atoms(Integral, Derivative, Subs) for e in (general.says, *general.given))
    if bound or any(x.name in defined(general) for x, _ in proof.values):
        return Finding(UNDECIDED, "the values are of symbols that are bound, or defined")
    if claim.says != proof.says:
        return Finding(UNDECIDED, "what is said is no instance of the claim")
    if not _possible(claim):
        return Finding(UNDECIDED, "no exact point is found that satisfies the conditions")
    given = with_bounds(conditions(claim.given), (citing(*proof.cited),))
    for condition in conditions(tuple(map(proof.put, general.given))):
        if condition not in given and not is_manifest(condition, given):
            return Finding(UNDECIDED, f"{condition} is not shown, but the instance needs it")
    says = relations(formula(claim.says))
    gap = _gap([side for part in says for side in (part.left, part.right)], given)
    return (
        Finding(UNDECIDED, gap) if gap else Finding(PROVED, f"it is an instance of {general.label}")
    )


def _gap(sides: Sequence[Expr], given: Conditions) -> str | None:
    """What is not shown to exist in the sides, in words."""
    gap = next((gap for side in sides if (gap := undefined(side, given)) is not None), None)
    if gap is not None:
        return f"nothing shows that {gap} allows its operation"
    try:
        need_integrals(sides, given)
    except NotShownError as error:
        return str(error)
    return None


def _judge_implicit_function(claim: Claim, proof: ImplicitFunction) -> Finding:
    """PROVED when the claim says the slope of the implicit function, and the theorem applies."""
    equation, says = formula(proof.equation.says), formula(claim.says)
    if not all(isinstance(f, Relation) and f.sign == "==" for f in (equation, says)):
        return Finding(UNDECIDED, "an equation is differentiated, and an equation is its slope")
    assert isinstance(equation, Relation)
    assert isinstance(says, Relation)
    u, p, at = proof.unknown.name, proof.parameter.name, tree(proof.at)
    left, right = equation.left, equation.right
    if {u, p} & (symbols(right) | symbols(at)) or u == p:
        return Finding(UNDECIDED, "the right side depends on what varies")
    if says.left.op != "symbol" or says.left in definitions(claim.rests_on):
        return Finding(UNDECIDED, f"{says.left} is not a new symbol")
    outside = without(p, conditions(claim.given))
    there = substitute(left, {p: at})
    by_unknown = derivative(there, u)
    slope = -derivative(left, p, at) / by_unknown
    if symbols(says.left) & symbols(left):
        return Finding(UNDECIDED, f"{says.left} is not a new symbol")
    if not under_binder(says.right, slope, outside):
        other = Finding(UNDECIDED, "that is not the slope of the implicit function")
        return _refuted_slope(claim, proof) or other
    if not _possible(claim):
        return Finding(UNDECIDED, "no exact point is found that satisfies the conditions")
    place = tree(proof.parameter)
    near = (*outside, Relation(place, ">=", at), Relation(place, "<=", at))
    unmet = unmet_condition(proof.equation, {}, near)
    if unmet is not None:
        return Finding(UNDECIDED, f"{unmet} is not shown, but the equation needs it")
    try:
        need_smooth(left, near)
    except NotShownError as error:
        return Finding(UNDECIDED, str(error))
    steps, sign = _chain_to_sign(by_unknown, proof.slope, outside)
    failed = next((s for s in steps if s.verdict is not PROVED), None)
    if failed is not None or sign not in ("+", "-"):
        why = failed.why if failed else "the sign of the derivative by the unknown is not manifest"
        return Finding(UNDECIDED, why, steps=steps)
    written = tuple(c for c in claim.given if proof.parameter not in c.free_symbols)
    assert not isinstance(proof.equation.says, str)
    on_curve = (proof.equation.says.xreplace({proof.parameter: proof.at}),)
    if not satisfiable(written, on_curve):
        return Finding(UNDECIDED, "no point is found that satisfies the equation", steps=steps)
    why = f"the equation is smooth and its derivative by {u} is not zero"
    return Finding(PROVED, why, steps=steps)


def _refuted_slope(claim: Claim, proof: ImplicitFunction) -> Finding | None:
    """REFUTED with a point of the equation at which what is said is not the slope, or None."""
    says, equation = claim.says, proof.equation.says
    assert isinstance(says, Basic)
    assert isinstance(equation, Basic)
    left, p = equation.args[0], proof.parameter
    by_unknown = Derivative(left.xreplace({p: proof.at}), proof.unknown)
    slope = -Subs(Derivative(left, p), p, proof.at) / by_unknown
    return refute(
        equal(says.args[1], slope), replace(claim, proof=by(substituting(proof.equation)))
    )


def _judge_relations(claim: Claim) -> Finding:
    """All relations of the statement hold, or the first that does not decides.

    That there is a point is refuted by what holds at none.
    """
    says = claim.statement
    if isinstance(says, ForSome):
        (some,) = says.args
        never = some.negated if isinstance(some, Relational) else None
        if not isinstance(never, Relational) or _without_chain(never, claim).verdict is not PROVED:
            return Finding(UNDECIDED, "nothing shows that it holds nowhere")
        where = known(conditions(claim.given)).satisfying_point()
        return Finding(REFUTED, f"{never} everywhere, as at the witness", witness=where)
    finding = Finding(UNDECIDED, "there is no relation to decide")
    for relation in (entry for part in claim.parts for entry in scalars(part)):
        if not isinstance(relation, Relational):
            return Finding(UNDECIDED, f"{relation} is not a relation")
        finding = _settle(relation, claim)
        if finding.verdict is not PROVED:
            return finding
    return finding


def _settle(relation: Basic, claim: Claim) -> Finding:
    """One relation decided without a chain: by normal form or sign, else at exact points."""
    proved = _without_chain(relation, claim)
    if proved.verdict is PROVED:
        return proved
    return refute(relation, claim) or proved


def _without_chain(written: Relational, claim: Claim) -> Finding:
    """PROVED by normal form or by a manifest sign, else UNDECIDED."""
    if not _possible(claim):
        return Finding(UNDECIDED, "no exact point is found that satisfies the conditions")
    relation, given = formula(written), conditions(claim.given)
    if not isinstance(relation, Relation):
        return Finding(UNDECIDED, f"{written} is not a relation between numbers")
    try:
        rules, _ = instantiated(claim.uses, given)
    except NotShownError as error:
        return Finding(UNDECIDED, str(error))
    meant = put_into(given, rules)
    plain = tuple(c for c in meant if elementary(c.left, c.right))
    if not _met_somewhere(plain):
        return Finding(UNDECIDED, "no exact point is found that satisfies the conditions")
    left, right = (put_in(side, rules) for side in (relation.left, relation.right))
    if relation.sign == "==":
        one, other = generalised(left, right)
        decision = decide(one, other, known(plain))
        shown, why = decision.verdict is PROVED, decision.why
    else:
        shown = is_manifest(Relation(left, relation.sign, right), plain)
        why = "the sign of the difference of the two sides is " + ("proven" if shown else "open")
    gap = _gap((left, right), plain) if shown else None
    if gap is not None:
        return Finding(UNDECIDED, gap)
    return Finding(PROVED if shown else UNDECIDED, why)
