"""Refute a general statement, by a point at which it fails or by a claim that contradicts it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import islice
from typing import ClassVar

from flint import arb, fmpq
from sympy import Basic, Equivalent, Tuple
from sympy.core.relational import Relational

from tresym.ledger.claim import Claim, Counterexample
from tresym.ledger.conversion import conditions, defined, known, tree
from tresym.ledger.counterexamples import excluded, scalars
from tresym.ledger.evidence.at_point import Values, unique_by, values_at
from tresym.ledger.finding import Finding, Ruling
from tresym.ledger.statements import Under
from tresym.reals.domain.binder_values import Unique, value
from tresym.reals.domain.evaluation import stands
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import fraction_text
from tresym.reals.verdict import Verdict

BITS = 256, 2048
POINTS = 4
"""Exact points of a region at which a bound is tried."""
Point = Mapping[str, fmpq]


def judge_counterexample(claim: Claim, proof: Counterexample) -> Finding:
    """REFUTED when balls confirm the conditions, and exclude the statement, at the exact point."""
    why = None
    for bits in BITS:
        why = not_denied(claim, proof.point, bits)
        if why is None:
            return _violated(proof.point)
    return Finding(Verdict.UNDECIDED, why or "")


def denied_somewhere(claim: Claim) -> Finding | None:
    """REFUTED with an exact point of the region at which balls exclude the bound, or None."""
    given = known(conditions(claim.given))
    free = {s.name for condition in claim.given for s in condition.free_symbols}
    for point in islice(given.points(sorted(free - defined(claim)), POINTS), POINTS):
        if not_denied(claim, point) is None:
            return _violated(point)
    return None


def _violated(point: Point) -> Finding:
    where = ", ".join(f"{n} = {fraction_text(v)}" for n, v in point.items())
    return Finding(Verdict.REFUTED, f"violated at {where}", witness=point)


def not_denied(claim: Claim, exact: Point, bits: int = BITS[0]) -> str | None:
    """Why the point does not deny what the claim says, or None where balls show that it does."""
    if claim.statement is None:
        return "a point denies a formula, and none is stated"
    with ball_precision(bits):
        point, unique = values_at(exact, claim.rests_on), unique_by(claim.rests_on)
        for condition in claim.given:
            if not _holds_at(condition, point, unique):
                return f"{condition} is not shown at the point"
        if denied_at(claim.statement, point, unique) is None:
            return "the statement is not shown to fail at the point"
    return None


def denied_at(
    says: Basic, point: Values, unique: Unique = lambda node, at: False
) -> tuple[tuple[Basic, ...], Relational] | None:
    """The relation in ``says`` that balls exclude at ``point``, after what holds there, or None."""
    match says:
        case Tuple():
            return next((d for part in says.args if (d := denied_at(part, point, unique))), None)
        case Under(args=(inner, given)):
            holds = _all_hold(given.args, point, unique)
            denied = denied_at(inner, point, unique) if holds else None
            return denied and ((*given.args, *denied[0]), denied[1])
        case Equivalent(args=(first, second)):
            for one, other in ((first, second), (second, first)):
                holds = _all_hold((one,), point, unique)
                denied = denied_at(other, point, unique) if holds else None
                if denied is not None:
                    return (one, *denied[0]), denied[1]
        case Relational():
            for entry in scalars(says):
                if excluded(_difference_at(entry, point, unique), entry.rel_op):
                    return (), entry
    return None


def _all_hold(conditions: tuple[Basic, ...], point: Values, unique: Unique) -> bool:
    return all(_holds_at(entry, point, unique) for part in conditions for entry in scalars(part))


def _holds_at(relation: Basic, point: Values, unique: Unique) -> bool:
    """Whether balls show that a relation holds at ``point``; an equation only where they are 0."""
    return isinstance(relation, Relational) and stands(
        _difference_at(relation, point, unique), relation.rel_op
    )


def _difference_at(relation: Basic, point: Values, unique: Unique) -> arb:
    """The difference of the sides; not finite where a symbol has no value, or a side none."""
    if not {symbol.name for symbol in relation.free_symbols} <= {*point}:
        return arb.nan()
    left, right = map(tree, relation.args)
    return value(left - right, point, unique)


@dataclass(frozen=True)
class Denied:
    """A sentence without a formula, denied by ``claims`` that exhibit the case ``witness``.

    That the claims contradict the sentence is for the reader to see; that they hold is not: a
    denial whose claims do not all hold is UNDECIDED.
    """

    claims: tuple[Claim, ...]
    witness: Point
    expect: ClassVar[Ruling] = Verdict.REFUTED

    def judge(self) -> Finding:
        """REFUTED; only asked when every claim named is found to hold."""
        if not self.claims or not self.witness:
            return Finding(Verdict.UNDECIDED, "a denial needs a claim and a case")
        why = "contradicted by " + ", ".join(claim.label for claim in self.claims)
        return Finding(Verdict.REFUTED, why, witness=self.witness)
