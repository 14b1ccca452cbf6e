"""Generate false variants of claims, which no evidence may prove.

This is mutation testing of the verifier. The statement of a claim is changed (and the ends of its
chains accordingly), and so is each single step of its chains; see
`tresym.dev.mutants.mutations` and, for numbers, bounds and orders,
`tresym.dev.mutants.number_mutations`. The changed statement is also judged without its chain.

- A definition cannot be false. It is changed, and claims that use it are judged with the changed
  definition; of an implicitly defined function, the stated derivative is changed.
- In a conjunction, one part is changed at a time.
- Of a refutation at a point, the conditions are changed, too; of a sentence that other claims
  refute, those claims are changed. The changed evidence must no longer refute anything.

A mutant counts only if balls show that it is violated, since a changed statement may still be true:
γ ≤ 2a differs from γ ≤ a but holds.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from itertools import islice, zip_longest
from typing import Any

from sympy import Basic, Derivative, Eq, Equivalent, Integral, Tuple
from sympy.core.relational import Relational

from tresym.dev.mutants.mutations import mutations, of_relations, scattered
from tresym.dev.mutants.number_mutations import (
    Named,
    bound_changes,
    bounds_fail,
    is_refuted,
    no_inputs_give_it,
    order_changes,
    order_fails,
    printed_changes,
)
from tresym.ledger import paper
from tresym.ledger.claim import (
    AllOf,
    Chain,
    Claim,
    Counterexample,
    Definition,
    ImplicitFunction,
    Instance,
    Monotone,
    Printed,
    Reason,
    Root,
    Step,
    chains_of,
    equal,
    parts_of,
    saying,
    with_reasons,
)
from tresym.ledger.evidence.asymptotics import Asymptotics
from tresym.ledger.evidence.box_bounds import Boxes
from tresym.ledger.evidence.chart_bounds import Charted, Reading
from tresym.ledger.evidence.decided import Decided
from tresym.ledger.evidence.interval_evaluation import Evaluated, fails_at_once
from tresym.ledger.evidence.refutation import Denied, denied_somewhere
from tresym.ledger.judge import judge_evidence
from tresym.ledger.refutations import refute
from tresym.ledger.statements import As, AtMostOne, ExactlyOne
from tresym.reals.verdict import Verdict

Variant = Any
"""A changed expression, relation, printed text or function."""

TRIES, INPUT_TRIES = 40, 3
"""Changes tried at one place to find those that count; fewer for an input of a number, since each
change is evaluated over its whole box."""
EVALUATED_TRIES = 40
"""Changes tried of a statement that is evaluated over a box, integrals included."""
LOOSENED, REGION_TRIES, CHARTED_TRIES = 3, 12, 5
"""Changes per condition, and the total number tried; fewer for bounds on charts."""
LARGEST = 60
"""Largest size of a refuted statement with its conditions that is also decided without its
point."""
DEPENDENTS = 2
"""Maximal number of claims that are judged with a changed definition."""


@dataclass(frozen=True)
class Mutant:
    """A false claim made from ``origin`` by one change at one place.

    ``beneath`` are the changed claims that it depends on, dependencies first.
    """

    origin: Claim
    place: str
    change: str
    claim: Claim
    beneath: tuple[Claim, ...] = ()


@dataclass(frozen=True)
class _Spot:
    """A place where a claim can be changed."""

    name: str
    variants: Iterable[Variant]
    claims: Callable[[Variant], tuple[Claim, ...]]
    violated: Callable[[Claim], bool]
    tries: int = TRIES

    def mutants(self, origin: Claim) -> Iterator[tuple[Mutant, ...]]:
        """Yield, for every change that counts, the claims that it makes false."""
        for variant in islice(self.variants, self.tries):
            claims = self.claims(variant)
            if self.violated(claims[0]):
                yield tuple(Mutant(origin, self.name, str(variant), c) for c in claims)


def _mutations(e: Basic) -> Iterator[Basic]:
    return mutations(e, paper.racket().written.alike)


def mutants(
    claim: Claim,
    wanted: int,
    dependents: tuple[Claim, ...] = (),
    made: Callable[[Claim], Iterable[Mutant]] | None = None,
) -> Iterator[Mutant]:
    """Return mutants of a claim that balls show to be violated; the same ones in every run.

    Args:
        claim: the claim.
        wanted: the number of changes, spread over its places, at least one at each.
        dependents: for a definition, claims that use it.
        made: the mutants of the parts of a conjunction; None to compute them.
    """
    if isinstance(claim.proof, AllOf | Denied):
        yield from _of_parts(claim, wanted, made or (lambda part: mutants(part, wanted)))
        return
    places = [spot.mutants(claim) for spot in _spots(claim, dependents)]
    share = math.ceil(wanted / len(places)) if places else 0
    count = 0
    for found in (m for place in places for m in islice(place, share)):
        count += 1
        yield from found
    # If some places have no further changes, more are made at the others.
    rest = (m for place in places for m in place)
    for found in islice(rest, max(0, wanted - count)):
        yield from found


def why_few(claim: Claim, dependents: tuple[Claim, ...] = ()) -> str:
    """Return why a claim has fewer mutants than wanted."""
    asked = [*_proving(dependents), *_sloping(dependents)]
    if isinstance(claim.proof, Definition | Root | ImplicitFunction) and not asked:
        return "nothing is proved by this definition directly"
    if not isinstance(claim.proof, AllOf | Denied) and not [*_spots(claim, dependents)]:
        return "no change is known for this kind of evidence"
    return "balls show no other change of it violated"


def _of_parts(
    claim: Claim, wanted: int, made: Callable[[Claim], Iterable[Mutant]]
) -> Iterator[Mutant]:
    """Yield the conjunction or refutation with one part changed, taking the parts in turn."""
    evidence: Any = claim.proof
    parts: tuple[Claim, ...] = evidence.claims
    waiting = [(part, iter(made(part))) for part in parts]
    changes: set[tuple[Claim, str, str]] = set()
    while waiting and len(changes) < wanted:
        remaining = []
        for part, changed in waiting:
            mutant = next(changed, None)
            if mutant is None:
                continue
            changes.add((part, mutant.place, mutant.change))
            remaining.append((part, changed))
            others = tuple(mutant.claim if p == part else p for p in parts)
            conjunction = replace(claim, proof=replace(evidence, claims=others))
            place = f"part {part.label}: {mutant.place}"
            below = (*mutant.beneath, mutant.claim)
            yield Mutant(claim, place, mutant.change, conjunction, below)
        waiting = remaining


def _spots(claim: Claim, dependents: tuple[Claim, ...]) -> Iterator[_Spot]:
    match claim.proof:
        case Printed():
            for name, variants, changed in printed_changes(claim, _mutations):
                tries = INPUT_TRIES if name.startswith(("input", "term")) else TRIES
                yield _Spot(name, variants, _one(changed), no_inputs_give_it, tries)
        case Boxes():
            for name, variants, changed in bound_changes(claim):
                yield _Spot(name, variants, _one(changed), bounds_fail)
        case Decided() if not isinstance(claim.statement, As):
            yield _said_spot(claim, "statement", _mutated(claim), _is_violated, CHARTED_TRIES)
            yield _region_spot(claim, _is_violated, CHARTED_TRIES)
        case Asymptotics() | Decided():
            for name, variants, changed in order_changes(claim):
                fails = is_refuted if is_refuted(claim) else order_fails
                yield _Spot(name, variants, _one(changed), fails)
        case Definition() | Root() | ImplicitFunction():
            symbols = {lhs for lhs, _ in _equations(claim.says)}
            proving = [*_proving(dependents)]
            chains = [d for d in proving if not isinstance(d.proof, Charted)]
            asked = sorted(chains or proving, key=lambda d: not symbols & _spoken_of(d))
            for dependent in asked[:DEPENDENTS]:
                yield _definition_spot(claim, dependent)
            for dependent in islice(_sloping(dependents), DEPENDENTS):
                yield _equation_spot(claim, dependent)
        case Charted():
            yield _said_spot(claim, "statement", _mutated(claim), _is_denied)
            yield _region_spot(claim, _is_denied, CHARTED_TRIES)
        case Evaluated():
            says = claim.statement
            pairs = () if says is None else zip_longest(of_relations(says), _mutations(says))
            either = (changed for pair in pairs for changed in pair if changed is not None)
            yield _said_spot(claim, "statement", either, fails_at_once, EVALUATED_TRIES)
            yield _region_spot(claim, fails_at_once)
        case Monotone(slope=chain) if isinstance(claim.statement, AtMostOne):
            yield from _slope_spots(claim, chain, claim.statement)
        case Counterexample():
            yield _counterexample_spot(claim)
            for n, condition in enumerate(claim.given, 1):
                yield _condition_spot(claim, n, condition)
        case Instance():
            for n, relation in enumerate(claim.parts, 1):
                yield _said_spot(claim, f"relation {n}", _mutations(relation))
            yield _region_spot(claim)
        case tuple() if claim.statement is not None:
            parts = chains_of(claim.statement, claim.proof)
            for n, (part, chain) in enumerate(parts, 1):
                yield from _chain_spots(claim, part, chain, f"part {n}: " if parts[1:] else "")
            yield _region_spot(claim)


def _one(changed: Callable[[Variant], Claim]) -> Callable[[Variant], tuple[Claim, ...]]:
    return lambda variant: (changed(variant),)


def _is_violated(claim: Claim) -> bool:
    return claim.statement is not None and refute(claim.statement, claim) is not None


def _is_refuted(claim: Claim) -> bool:
    found = judge_evidence(claim)
    return found is not None and found.verdict is Verdict.REFUTED


def _is_denied(claim: Claim) -> bool:
    return denied_somewhere(claim) is not None


def _mutated(claim: Claim) -> Iterable[Basic]:
    return () if claim.statement is None else _mutations(claim.statement)


def _said_spot(
    claim: Claim,
    name: str,
    variants: Iterable[Basic],
    violated: Callable[[Claim], bool] = _is_violated,
    tries: int = TRIES,
) -> _Spot:
    """Change the statement, so that it fails by the test ``violated``."""
    return _Spot(name, variants, _one(lambda changed: saying(claim, changed)), violated, tries)


def _region_spot(
    claim: Claim, violated: Callable[[Claim], bool] = _is_violated, tries: int = REGION_TRIES
) -> _Spot:
    """Change the conditions: drop one, reverse one, or change its constants."""
    given = claim.given

    def variants() -> Iterator[Named]:
        for n, condition in enumerate(given):
            rest = (*given[:n], *given[n + 1 :])
            yield Named(f"without {condition}", rest)
            for changed in islice(_mutations(condition), LOOSENED):
                if changed.free_symbols <= condition.free_symbols:
                    yield Named(f"{changed} for {condition}", (*rest, changed))

    changed_to = _one(lambda other: replace(claim, given=other.changed))
    return _Spot("region", scattered(variants()), changed_to, violated, tries)


def _counterexample_spot(claim: Claim) -> _Spot:
    """Change the statement that is refuted at a point; judge it with and without the point."""

    def claims(changed: Variant) -> tuple[Claim, ...]:
        at_point = saying(claim, changed)
        plain = all(isinstance(part, Relational) for part in parts_of(changed))
        if not plain or sum(e.count_ops() for e in (changed, *claim.given)) > LARGEST:
            return (at_point,)
        return at_point, replace(at_point, proof=Decided())

    return _Spot("statement", _mutated(claim), claims, _is_refuted)


def _condition_spot(claim: Claim, n: int, condition: Basic) -> _Spot:
    """Change one condition of a refuted sentence; still false if the point satisfies it."""

    def changed_to(changed: Variant) -> Claim:
        return replace(claim, given=(*claim.given[: n - 1], changed, *claim.given[n:]))

    known = condition.free_symbols
    same = (changed for changed in _mutations(condition) if changed.free_symbols <= known)
    return _Spot(f"condition {n}", same, _one(changed_to), _is_refuted)


# Chains


def _chain_spots(claim: Claim, says: Basic, chain: Chain, prefix: str) -> Iterator[_Spot]:
    def claims(changed: Variant) -> tuple[Claim, ...]:
        follows = replace(saying(claim, changed), proof=_following(chain, says, changed))
        if isinstance(changed, Equivalent) or _is_plain(chain):
            return (follows,)
        return follows, replace(follows, proof=Decided(claim.uses))

    yield _Spot(prefix + "statement", _mutations(says), claims, _is_violated)
    yield from _step_spots(claim, _start(says), chain, prefix)


def _is_plain(chain: Chain) -> bool:
    """Return whether a chain has a single step, which the provers decide directly."""
    (link, *more) = chain
    return not more and link.expression is None and not any(r.theories for r in link.reasons)


def _following(chain: Chain, says: Any, changed: Any) -> Chain:
    """Change the last expression of a chain if it is an end of the changed statement."""
    last = chain[-1]
    ends = dict(zip(says.args, changed.args, strict=True))
    return (*chain[:-1], Step(ends.get(last.expression, last.expression), last.reasons))


def _start(says: Any) -> Basic:
    if isinstance(says, Eq | Equivalent):
        return says.args[0]
    return says.gts - says.lts


def _step_spots(claim: Claim, start: Basic, chain: Chain, prefix: str) -> Iterator[_Spot]:
    """Change each expression of a chain alone, claimed to follow from the one before."""
    before = start
    for n, link in enumerate(chain, 1):
        if link.expression is None:
            return

        def claims(changed: Variant, before: Basic = before, link: Step = link) -> tuple[Claim]:
            relate = Equivalent if isinstance(changed, Eq) else equal
            says, proof = relate(before, changed), (Step(changed, link.reasons),)
            return (replace(saying(claim, says), proof=proof),)

        yield _Spot(f"{prefix}step {n}", _mutations(link.expression), claims, _is_violated)
        before = link.expression


def _slope_spots(claim: Claim, chain: Chain, root: ExactlyOne | AtMostOne) -> Iterator[_Spot]:
    between = root.variable > root.low, root.variable < root.high
    inside = replace(claim, given=(*claim.given, *between))
    yield from _step_spots(inside, Derivative(root.difference, root.variable), chain, "slope: ")


# Definitions


def _proving(dependents: tuple[Claim, ...]) -> Iterator[Claim]:
    """Return claims that prove something about a definition they depend on."""
    kinds = tuple | Charted | Printed
    return (d for d in dependents if isinstance(d.proof, kinds))


def _equations(says: Basic) -> tuple[tuple[Basic, Basic], ...]:
    return tuple(part.args for part in parts_of(says) if isinstance(part, Eq))


def _spoken_of(claim: Claim) -> set[Basic]:
    return set().union(*(part.free_symbols for part in claim.parts))


def _definition_spot(claim: Claim, dependent: Claim) -> _Spot:
    """Change a definition and judge a claim that uses it."""

    def claims(changed: Variant) -> tuple[Claim, ...]:
        return (_resting_on(dependent, replace(claim, says=changed)),)

    return _Spot(f"in {dependent.label}", _other_meanings(claim.says), claims, _falls)


def _sloping(dependents: tuple[Claim, ...]) -> Iterator[Claim]:
    return (d for d in dependents if isinstance(d.proof, ImplicitFunction))


def _equation_spot(claim: Claim, dependent: Claim) -> _Spot:
    """Change the equation that defines a function implicitly, and keep the stated derivative.

    The mutant counts if balls show, at a point of the equation, that the derivative differs.
    """
    proof: Any = dependent.proof

    def claims(changed: Variant) -> tuple[Claim, ...]:
        return (replace(dependent, proof=replace(proof, equation=replace(claim, says=changed))),)

    return _Spot(f"in {dependent.label}", _other_meanings(claim.says), claims, _is_refuted)


def _other_meanings(says: Basic) -> Iterator[Basic]:
    """Yield the definition with a different right side, or a different integral on its left."""
    parts = parts_of(says)
    for n, part in enumerate(parts):
        if not isinstance(part, Eq):
            continue
        left, right = part.args
        others = [equal(left, changed) for changed in _mutations(right)]
        if isinstance(left, Integral):
            others += [equal(changed, right) for changed in _mutations(left)]
        for other in others:
            whole = (*parts[:n], other, *parts[n + 1 :])
            yield Tuple(*whole) if isinstance(says, Tuple) else other


def _falls(claim: Claim) -> bool:
    """Return whether the claim is violated at a point where everything that it uses holds."""
    if isinstance(claim.proof, Printed):
        return no_inputs_give_it(claim)
    if isinstance(claim.proof, Charted):
        return denied_somewhere(claim) is not None
    return any(refute(relation, claim) is not None for relation in claim.parts)


def _resting_on(claim: Claim, other: Claim) -> Claim:
    """Return the claim with evidence that names ``other`` instead of the claim with its label."""

    def named(claims: tuple[Claim, ...]) -> tuple[Claim, ...]:
        return tuple(other if c.label == other.label else c for c in claims)

    def reason(r: Reason) -> Reason:
        return replace(r, claims=named(r.claims))

    def read(readings: tuple[Reading, ...]) -> tuple[Reading, ...]:
        return tuple(
            replace(r, claims=named(r.claims), cited=named(r.cited), inner=read(r.inner))
            for r in readings
        )

    proof = claim.proof
    if isinstance(proof, Printed):
        return replace(claim, proof=replace(proof, claims=named(proof.claims)))
    if isinstance(proof, Charted):
        put, cited = named(proof.put), named(proof.cited)
        changed = replace(proof, put=put, cited=cited, readings=read(proof.readings))
        return replace(claim, proof=changed)
    return replace(claim, proof=with_reasons(claim.proof, reason))
