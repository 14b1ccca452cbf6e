"""Bounds by interval evaluation of the statement over the box of its conditions.

The difference of the two sides of each relation is evaluated in ball arithmetic, integrals and
roots included, and the box is bisected until every ball is positive. The conditions must give each
symbol a lower and an upper bound, or an exact value by an equation.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import ClassVar

from flint import arb, fmpq
from sympy import Basic, Eq, Ge, Gt, Le, Lt, Rational, Symbol

from tresym.ledger.claim import Claim
from tresym.ledger.conversion import CircularError, conjuncts, formula
from tresym.ledger.evidence.box_bounds import closed, decisions_of
from tresym.ledger.evidence.printed_numbers import Term, term_of
from tresym.ledger.finding import Finding, Ruling
from tresym.reals.balls.branch_and_bound import BY_BALL, Bound, BoxProof, Open, inner_points
from tresym.reals.balls.branch_and_bound import Counterexample as Point
from tresym.reals.cross_check import said
from tresym.reals.language.formula import Relation
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError, Interval, as_rational, fraction_text
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


def fails_at_once(claim: Claim) -> bool:
    """Return whether the statement fails in the middle of its box or near one of its corners."""
    try:
        return _failing(tuple(_differences(claim)), Evaluated.precision) is not None
    except (InputError, CircularError):
        return False


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
    values = (c.args for c in claim.given if isinstance(c, Eq))
    known = {x.name: as_rational(str(e)) for x, e in values if isinstance(e, Rational)}
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
    for part in (part for says in claim.parts for part in conjuncts(formula(says))):
        if not isinstance(part, Relation) or part.sign in ("==", "!="):
            raise InputError(f"{part} is not an inequality with <, <=, > or >=")
        up = part.upward
        terms.append(term_of(boxed, up.left - up.right, box))
    # The terms of one claim share their rules, so values without inputs are computed only once.
    return [
        replace(t, constants=terms[0].constants) if t.others == terms[0].others else t
        for t in terms
    ]


def _box(given: tuple[Basic, ...]) -> tuple[dict[str, Interval], tuple[Basic, ...]]:
    """Return the interval of each symbol (open ends are closed), and the other conditions."""
    lows: dict[str, fmpq] = {}
    highs: dict[str, fmpq] = {}
    rest = []
    for part in given:
        x, end = (part.gts, part.lts) if isinstance(part, Ge | Gt | Le | Lt) else (None, None)
        if isinstance(x, Symbol) and isinstance(end, Rational) and x.name not in lows:
            lows[x.name] = as_rational(str(end))
        elif isinstance(end, Symbol) and isinstance(x, Rational) and end.name not in highs:
            highs[end.name] = as_rational(str(x))
        else:
            rest.append(part)
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
