"""Bounds by interval evaluation of the statement over the box of its conditions.

The difference of the two sides of each relation is evaluated in ball arithmetic, integrals and
roots included, and the box is bisected until every ball is positive. The conditions must give each
symbol a lower and an upper bound, or an exact value by an equation.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, ClassVar

from flint import arb, fmpq

from tresym.ledger.claim import Claim
from tresym.ledger.evidence.box_bounds import closed, decisions_of
from tresym.ledger.evidence.printed_numbers import Term, term_of
from tresym.ledger.finding import Finding, Ruling
from tresym.ledger.formulas import in_trees, is_bound, is_equation, relations_of
from tresym.reals.balls.branch_and_bound import BY_BALL, Bound, BoxProof, Open, inner_points
from tresym.reals.balls.branch_and_bound import Counterexample as Point
from tresym.reals.cross_check import said
from tresym.reals.language.formula import Relation
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError, Interval, fraction_text
from tresym.reals.verdict import Verdict


@dataclass(frozen=True)
class Evaluated:
    """Evidence that the relations of a statement hold strictly on the box of its conditions.

    Attributes:
        claims: claims that define the symbols and prove that roots are unique.
        stored: returns the stored proofs, or None if there are none.
        budget: maximal number of boxes in a search, per relation.
        precision: precision of the balls in bits.
    """

    claims: tuple[Claim, ...] = ()
    stored: Callable[[], tuple[BoxProof, ...] | None] | None = None
    budget: int = 2_000
    precision: int = 64
    kind: ClassVar[str] = "bound"
    expect: ClassVar[Ruling] = Verdict.ENCLOSED


def judge_evaluated(claim: Claim, proof: Evaluated) -> Finding:
    """Return ENCLOSED if all relations hold on the box, REFUTED with a point if one fails.

    Raises:
        InputError: the statement is not a bound, or the conditions do not describe a box.
    """
    terms = tuple(_differences(claim))
    failing = _failing(terms, proof.precision)
    if failing is not None:
        return _refuted(claim, *failing)
    decisions = _decided(terms, proof)
    for term, found in zip(terms, decisions, strict=True):
        if isinstance(found, Point):
            return _refuted(claim, term, found.point, found.value)
    return closed(decisions, ", ".join(map(str, claim.given)))


def _decided(terms: tuple[Term, ...], proof: Evaluated) -> tuple[BoxProof | Point | Open, ...]:
    """Decide whether each term is positive on its box; without inputs, its value decides."""
    if any(term.inputs for term in terms):
        bounds = tuple(_bound(term, proof.precision) for term in terms)
        return decisions_of(bounds, proof.stored, proof.budget)
    with ball_precision(proof.precision):
        return tuple(BoxProof(BY_BALL) if t.value(()) > 0 else Open(()) for t in terms)


def _failing(terms: tuple[Term, ...], precision: int) -> tuple[Term, tuple[fmpq, ...], arb] | None:
    """Return a term, a point and the negative value of the term there, or None if none fails."""
    with ball_precision(precision):
        for term in terms:
            for point in inner_points(tuple(term.inputs.values())):
                difference = term.value(tuple(map(arb, point)))
                if difference < 0:
                    return term, point, difference
    return None


def _refuted(claim: Claim, term: Term, at: tuple[fmpq, ...], difference: arb) -> Finding:
    """Return REFUTED with the point and the amount by which the relation is violated."""
    values = (part for part in map(in_trees, claim.given) if is_equation(part))
    known = {str(c.left): c.right.args[0] for c in values if _is_value(c)}
    point = {**known, **dict(zip(term.inputs, at, strict=True))}
    where = ", ".join(f"{name} = {fraction_text(x)}" for name, x in point.items())
    seen = f"violated at {where or 'the constants themselves'}"
    why = f"{seen}, where the side that should be larger is smaller by {said(-difference)}"
    return Finding(Verdict.REFUTED, why, witness=point)


def _differences(claim: Claim) -> list[Term]:
    """Return for each relation the difference of its sides that must be positive."""
    terms = []
    box, rest = _box(claim.given)
    boxed = replace(claim, given=rest)
    for part in relations_of(in_trees(claim.statement)):
        if part.sign in ("==", "!="):
            raise InputError(f"{part} is not an inequality with <, <=, > or >=")
        up = part.upward
        terms.append(term_of(boxed, up.left - up.right, box))
    # The terms of one claim share their rules, so values without inputs are computed only once.
    return [
        replace(t, constants=terms[0].constants) if t.others == terms[0].others else t
        for t in terms
    ]


def _is_value(part: Relation) -> bool:
    """Return whether a relation compares a symbol on its left with a number."""
    return (part.left.op, part.right.op) == ("symbol", "number")


def _box(given: tuple[Any, ...]) -> tuple[dict[str, Interval], tuple[Any, ...]]:
    """Return the interval of each symbol (open ends are closed), and the other conditions."""
    lows: dict[str, fmpq] = {}
    highs: dict[str, fmpq] = {}
    rest = []
    for condition in given:
        part = in_trees(condition)
        up = part.upward if is_bound(part) and part.sign != "!=" else None
        if up is not None and _is_value(up) and str(up.left) not in lows:
            lows[str(up.left)] = up.right.args[0]
        elif up is not None and _is_value(up.mirrored) and str(up.right) not in highs:
            highs[str(up.right)] = up.left.args[0]
        else:
            rest.append(condition)
    if lows.keys() != highs.keys() or any(highs[x] < low for x, low in lows.items()):
        raise InputError(
            "the conditions must give each symbol a rational lower and upper bound (a box)"
        )
    return {x: Interval(low, highs[x]) for x, low in lows.items()}, tuple(rest)


def _bound(term: Term, precision: int) -> Bound:
    """Return the bound "the term is positive on the box of its inputs"."""

    def margin(*at: arb | fmpq) -> arb:
        return term.value(at[:-1])

    return Bound(margin, tuple(term.inputs.values()), precision=precision)
