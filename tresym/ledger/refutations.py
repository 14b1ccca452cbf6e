"""Refute claims at points, and show that the conditions of a claim can hold together."""

from __future__ import annotations

from typing import Any

from tresym.ledger.claim import (
    Claim,
    Definition,
    FromSlope,
    FromTheEdge,
    ImplicitFunction,
    InfimumBy,
    Root,
)
from tresym.ledger.conversion import CircularError, conditions, known, put_into
from tresym.ledger.counterexamples import violation
from tresym.ledger.definitions import restrictions, table
from tresym.ledger.evidence.chart_bounds import Charted
from tresym.ledger.evidence.integrals import need, with_bounds
from tresym.ledger.evidence.refutation import denied_somewhere
from tresym.ledger.evidence.satisfiability import satisfiable
from tresym.ledger.finding import Finding, StepFinding
from tresym.ledger.formulas import EqualMatrices, Says, in_trees, parts_of
from tresym.ledger.reasons import citing
from tresym.reals.language.binders import elementary
from tresym.reals.language.formula import Relation
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict

ELSEWHERE = (FromSlope, FromTheEdge, InfimumBy)
"""Evidence that uses claims at other points than the one at hand: their conditions need not hold
here."""
UNDECIDED, PROVED, REFUTED = Verdict.UNDECIDED, Verdict.PROVED, Verdict.REFUTED


def need_all(steps: tuple[StepFinding, ...]) -> None:
    """Require that there is at least one step and that every step is PROVED."""
    why = next((s.why for s in steps if s.verdict is not PROVED), None)
    need(why is None, f"{why}", steps)
    need(bool(steps), "there is nothing to prove")


def need_possible(claim: Claim) -> None:
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


def refute(says: Says, claim: Claim) -> Finding | None:
    """Return REFUTED with a point that violates ``says``, or None if no such point is found.

    The point satisfies the conditions of ``claim`` and the equations of the claims it uses; ball
    arithmetic proves that ``says`` fails there.
    """
    try:
        for known in dict.fromkeys((facts_used(claim), all_facts_behind(claim))):
            found = violation(says, claim.given, known)
            if found is not None:
                return Finding(REFUTED, found.why, witness=found.point)
    except (CircularError, InputError):
        return None
    return None


def seen_false(claim: Claim) -> Finding:
    """Return REFUTED if a counterexample is found without using the evidence, else UNDECIDED."""
    found = denied_somewhere(claim) if isinstance(claim.proof, Charted) else refuted_part(claim)
    return found or Finding(UNDECIDED, "neither a proof nor a counterexample was found")


def refuted_part(claim: Claim) -> Finding | None:
    """Return REFUTED for the first part of the statement with a counterexample, or None."""
    found = (refute(says, claim) for says in claim.parts)
    return next((finding for finding in found if finding is not None), None)


def all_facts_behind(claim: Claim) -> tuple[Any, ...]:
    """Return the equations and conditions of all definitions that the claim depends on.

    If the claim uses definitions only, or if two different claims have the same label, this is the
    same as `facts_used`.
    """
    defining = Definition | Root | ImplicitFunction
    elsewhere = isinstance(claim.proof, ELSEWHERE)
    uses = () if elsewhere else claim.uses
    if not elsewhere and all(isinstance(c.proof, defining) for c in uses):
        return facts_used(claim)
    used = {c.label: c for c in claim.rests_on if isinstance(c.proof, defining)}
    if not elsewhere and any(used.get(c.label, c) is not c for c in claim.rests_on):
        return facts_used(claim)
    known = dict.fromkeys(c for d in (*used.values(), *uses) for c in map(in_trees, d.given))
    known.update((p, None) for d in used.values() for p in parts_of(d.says))
    return tuple(known)


def facts_used(claim: Claim) -> tuple[Any, ...]:
    """Return the statements and conditions of the used claims that concern defined symbols.

    A used claim without any definition behind it is left out: it holds for all values that satisfy
    its conditions, so it restricts nothing, and whether its conditions hold is just what may be
    wrong.
    """
    if isinstance(claim.proof, ELSEWHERE):
        return all_facts_behind(claim)
    known: dict[Any, None] = {}
    for used in claim.uses:
        if table((used, *used.rests_on)):
            known.update(dict.fromkeys(map(in_trees, used.given)))
            known.update((p, None) for p in _relations(used.decided))
    return tuple(known)


def _relations(says: Any) -> list[Any]:
    """Return the parts of a statement that compare numbers or matrices."""
    return [p for p in parts_of(in_trees(says)) if isinstance(p, Relation | EqualMatrices)]
