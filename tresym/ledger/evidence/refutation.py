"""Refute a general statement, by a point at which it fails or by a claim that contradicts it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import islice
from typing import Any, ClassVar

from flint import fmpq

from tresym.ledger.claim import Claim, Counterexample
from tresym.ledger.conversion import conditions, defined, known
from tresym.ledger.counterexamples import excluded
from tresym.ledger.evidence.at_point import Place, place_of
from tresym.ledger.finding import Finding, Ruling
from tresym.ledger.formulas import EqualMatrices, Says, Under, in_trees, names_of, relations_of
from tresym.reals.domain.evaluation import stands
from tresym.reals.language.compound import Equivalent, Together
from tresym.reals.language.formula import Relation
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import fraction_text
from tresym.reals.verdict import Verdict

BITS = 256, 2048
POINTS = 4
"""Number of exact points of a region at which a bound is tried."""
Point = Mapping[str, fmpq]


def judge_counterexample(claim: Claim, proof: Counterexample) -> Finding:
    """Return REFUTED if balls confirm the conditions and exclude the statement at the point.

    Args:
        claim: the claim to refute.
        proof: the exact point; it is evaluated with 256 bits, then with 2048.
    """
    why = None
    for bits in BITS:
        why = not_denied(claim, proof.point, bits)
        if why is None:
            return _violated(proof.point)
    return Finding(Verdict.UNDECIDED, why or "")


def denied_somewhere(claim: Claim) -> Finding | None:
    """Try a few exact points of the region; return REFUTED if the bound fails at one, or None."""
    given = known(conditions(claim.given))
    free = names_of(*map(in_trees, claim.given))
    for point in islice(given.points(sorted(free - defined(claim)), POINTS), POINTS):
        if not_denied(claim, point) is None:
            return _violated(point)
    return None


def _violated(point: Point) -> Finding:
    """Return REFUTED with the point as its witness."""
    where = ", ".join(f"{n} = {fraction_text(v)}" for n, v in point.items())
    return Finding(Verdict.REFUTED, f"violated at {where}", witness=point)


def not_denied(claim: Claim, exact: Point, bits: int = BITS[0]) -> str | None:
    """Return why the point is no counterexample, or None if balls show that it is one.

    Args:
        claim: the claim.
        exact: rational coordinates by symbol name.
        bits: precision of the balls.
    """
    if claim.statement is None:
        return "the claim has no formula, so a point cannot contradict it"
    with ball_precision(bits):
        point = place_of(exact, claim.rests_on)
        for condition in map(in_trees, claim.given):
            if not _holds_at(condition, point):
                return f"could not confirm the condition {condition} at the point"
        if denied_at(claim.statement, point) is None:
            return "could not show that the statement fails at the point"
    return None


def denied_part(says: Any, exact: Point) -> tuple[tuple[Says, ...], Relation] | None:
    """Return what :func:`denied_at` finds at exact coordinates, without any definition."""
    with ball_precision(BITS[0]):
        return denied_at(in_trees(says), place_of(exact, ()))


def denied_at(says: Says, point: Place) -> tuple[tuple[Any, ...], Relation] | None:
    """Find a relation in ``says`` that balls exclude at ``point``.

    Args:
        says: a relation, several of them, an `Under` or an equivalence of two.
        point: the values of the symbols.

    Returns:
        The conditions that hold at the point and the relation that fails, or None.
    """
    match says:
        case Together(parts):
            return next((d for part in parts if (d := denied_at(part, point))), None)
        case Under(inner, given):
            denied = denied_at(inner, point) if _all_hold(given, point) else None
            return denied and ((*given, *denied[0]), denied[1])
        case Equivalent((first, second)):
            for one, other in ((first, second), (second, first)):
                denied = denied_at(other, point) if _all_hold((one,), point) else None
                if denied is not None:
                    return (one, *denied[0]), denied[1]
        case Relation() | EqualMatrices():
            for entry in relations_of(says):
                if excluded(point.value(entry.left - entry.right), entry.sign):
                    return (), entry
    return None


def _all_hold(conditions: tuple[Any, ...], point: Place) -> bool:
    """Return whether balls confirm all relations at ``point``."""
    return all(_holds_at(entry, point) for part in conditions for entry in relations_of(part))


def _holds_at(relation: Any, point: Place) -> bool:
    """Return whether balls confirm a relation; an equation only if the ball is exactly 0."""
    if not isinstance(relation, Relation):
        return False
    return bool(stands(point.value(relation.left - relation.right), relation.sign))


@dataclass(frozen=True)
class Denied:
    """Evidence against a sentence without a formula: proved claims that contradict it.

    The reader has to judge that the claims contradict the sentence. That the claims hold is
    checked: if one does not, the finding is UNDECIDED.

    Attributes:
        claims: the claims that contradict the sentence.
        witness: the case in which the sentence fails, as values by symbol name.
    """

    claims: tuple[Claim, ...]
    witness: Point
    expect: ClassVar[Ruling] = Verdict.REFUTED

    def judge(self) -> Finding:
        """Return REFUTED; called only if every claim named has been found to hold."""
        if not self.claims or not self.witness:
            why = "the evidence must name a claim that contradicts the sentence, and a case"
            return Finding(Verdict.UNDECIDED, why)
        why = "contradicted by " + ", ".join(claim.label for claim in self.claims)
        return Finding(Verdict.REFUTED, why, witness=self.witness)
