"""Local facts: inequalities that only one claim needs, proved by the sign prover."""

from __future__ import annotations

from dataclasses import replace

from tresym.ledger.claim import Claim, Definition, Monotone, Reason
from tresym.ledger.conversion import conditions, defined
from tresym.ledger.evidence.decided import Decided
from tresym.ledger.evidence.integrals import RULES, NotShownError
from tresym.ledger.evidence.premises import unmet_condition
from tresym.ledger.formulas import Under, in_trees, names_of
from tresym.reals.verdict import Verdict


def facts_of(claim: Claim) -> tuple[Claim, ...]:
    """Return the local facts of a claim as claims of their own, in order.

    Each fact has the conditions of the claim and may cite the facts before it. A fact about a bound
    variable (`Under`) also has the conditions on that variable. Definitions of the symbols of the
    fact are substituted.
    """
    found: list[Claim] = []
    for n, fact in enumerate(claim.knowing, 1):
        fact = in_trees(fact)
        says, more = (fact.formula, fact.given) if isinstance(fact, Under) else (fact, ())
        names, given = names_of(says), (*map(in_trees, claim.given), *more)
        behind = (c for c in claim.rests_on if isinstance(c.proof, Definition))
        meant = [
            c
            for c in behind
            if defined(c) & names and unmet_condition(c, {}, conditions(given)) is None
        ]
        why = Decided(tuple(meant), tuple(found))
        found.append(
            Claim(f"{claim.label}, fact {n}", says, why, given=given, expect=Verdict.PROVED)
        )
    return tuple(found)


def by_facts(claim: Claim, facts: tuple[Claim, ...]) -> Claim:
    """Return the claim with its facts cited in each step and in each rule for integrals."""

    def known(reason: Reason) -> Reason:
        return replace(reason, claims=(*facts, *reason.claims)) if reason.name in RULES else reason

    def decided(proof: Decided) -> Decided:
        chains = (
            tuple(replace(link, reasons=tuple(map(known, link.reasons))) for link in chain)
            for chain in proof.steps
        )
        return replace(proof, cited=(*facts, *proof.cited), steps=(*chains,))

    proof = claim.proof
    if isinstance(proof, Decided):
        return replace(claim, knowing=(), proof=decided(proof))
    if isinstance(proof, Monotone) and isinstance(proof.slope, Decided):
        return replace(claim, knowing=(), proof=Monotone(decided(proof.slope)))
    raise NotShownError("local facts are for what the engine decides")
