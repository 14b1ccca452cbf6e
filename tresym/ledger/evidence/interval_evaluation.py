"""Bounds by interval evaluation of the statement over the box of its conditions.

No margin is made of it: the difference of the sides is walked over with its integrals and roots.
The conditions are the ends of each symbol, or an equation for one that has a value.
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
    """Each relation of the statement, decided in balls on the box; its sides differ everywhere.

    Attributes:
        claims: what the symbols are, and which roots are one.
        stored: gives the stored proofs, or None where there are none.
        budget: boxes a search may look at, for each relation.
    """

    claims: tuple[Claim, ...] = ()
    stored: Callable[[], tuple[BoxProof, ...] | None] | None = None
    budget: int = 2_000
    precision: int = 64
    kind: ClassVar[str] = "bound"
    expect: ClassVar[Ruling] = Verdict.ENCLOSED


def judge_evaluated(claim: Claim, proof: Evaluated) -> Finding:
    """ENCLOSED where all relations hold on the box, REFUTED at a point at which one fails.

    Raises:
        InputError: the statement is no bound, or the conditions are no box.
    """
    terms = tuple(_rooms(claim))
    failing = _failing(terms, proof.precision)
    if failing is not None:
        return _refuted(claim, *failing)
    decisions = _decided(terms, proof)
    for term, found in zip(terms, decisions, strict=True):
        if isinstance(found, Point):
            return _refuted(claim, term, found.point, found.value)
    return closed(decisions, ", ".join(map(str, claim.given)))


def _decided(terms: tuple[Term, ...], proof: Evaluated) -> tuple[BoxProof | Point | Open, ...]:
    """What each term comes to on its box; where nothing varies its value tells."""
    if any(term.inputs for term in terms):
        bounds = tuple(_bound(term, proof.precision) for term in terms)
        return decisions_of(bounds, proof.stored, proof.budget)
    with ball_precision(proof.precision):
        return tuple(BoxProof(BY_BALL) if t.value(()) > 0 else Open(()) for t in terms)


def fails_at_once(claim: Claim) -> bool:
    """Whether balls exclude the statement in the middle of the box, or near a corner of it."""
    try:
        return _failing(tuple(_rooms(claim)), Evaluated.precision) is not None
    except (InputError, CircularError):
        return False


def _failing(terms: tuple[Term, ...], precision: int) -> tuple[Term, tuple[fmpq, ...], arb] | None:
    """A point of the first to be tried at which a relation fails, with its room, or None."""
    with ball_precision(precision):
        for term in terms:
            for point in inner_points(tuple(term.inputs.values())):
                room = term.value(tuple(map(arb, point)))
                if room < 0:
                    return term, point, room
    return None


def _refuted(claim: Claim, term: Term, at: tuple[fmpq, ...], room: arb) -> Finding:
    """REFUTED at a point, with what is given a value there, by as much as the sides differ."""
    values = (c.args for c in claim.given if isinstance(c, Eq))
    known = {x.name: as_rational(str(e)) for x, e in values if isinstance(e, Rational)}
    point = {**known, **dict(zip(term.inputs, at, strict=True))}
    where = ", ".join(f"{name} = {fraction_text(x)}" for name, x in point.items())
    seen = f"violated at {where or 'the constants themselves'}"
    why = f"{seen}, where the side that is to be larger is less by {said(-room)}"
    return Finding(Verdict.REFUTED, why, witness=point)


def _rooms(claim: Claim) -> list[Term]:
    """The difference of the sides of each relation that is said, by which it must be positive."""
    terms = []
    box, rest = _box(claim.given)
    boxed = replace(claim, given=rest)
    for part in (part for says in claim.parts for part in conjuncts(formula(says))):
        if not isinstance(part, Relation) or part.sign in ("==", "!="):
            raise InputError(f"{part} is no bound")
        up = part.upward
        terms.append(term_of(boxed, up.left - up.right, box))
    # One claim, one set of rules: what they have in common is worked out once.
    return [
        replace(t, constants=terms[0].constants) if t.others == terms[0].others else t
        for t in terms
    ]


def _box(given: tuple[Basic, ...]) -> tuple[dict[str, Interval], tuple[Basic, ...]]:
    """Between which ends each symbol lies, ends that do not count among them, and what is left."""
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
        raise InputError("the conditions are no box")
    return {x: Interval(low, highs[x]) for x, low in lows.items()}, tuple(rest)


def _bound(term: Term, precision: int) -> Bound:
    def margin(*at: arb | fmpq) -> arb:
        return term.value(at[:-1])

    return Bound(margin, tuple(term.inputs.values()), precision=precision)
