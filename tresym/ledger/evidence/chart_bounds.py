"""Bounds on a region, proved by positive margins on closed boxes in suitable coordinates.

The claim says the bound, as a relation under the conditions that are the region. The evidence says
how it is shown: coordinates, which are functions of the claim's symbols and take the region into a
box; and for each side of the bound a margin in these coordinates, positive on the box. The passage
from one to the other is exact: what is said, with its definitions put in, is a positive factor
times what the margin means. That is an identity for the exact procedure, and the signs are those of
the one prover.

A margin is a formula that is traced: what runs in balls and what it means are the same steps. Steps
that stand for defined symbols, or for long expressions, are read as these where a :class:`Reading`
is shown. At the edges of the box, where a quotient has no value, the margin's program is its
continuation: the points of the region are limits of those at which all parts have values.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any, ClassVar

from flint import arb, fmpq
from sympy import Basic, S
from sympy import Expr as Expression

from tresym.ledger.claim import Claim, parts_of
from tresym.ledger.conversion import (
    REMEMBERED,
    Conditions,
    Rules,
    conditions,
    conjuncts,
    formula,
    known,
    put_in,
    tree,
)
from tresym.ledger.evidence.box_bounds import closed, decimal, decisions_of
from tresym.ledger.evidence.chain import instantiated, unmet_condition
from tresym.ledger.evidence.integrals import NotShownError, with_bounds
from tresym.ledger.evidence.sign_prover import is_manifest, undefined
from tresym.ledger.finding import Finding
from tresym.ledger.reasons import citing
from tresym.reals.balls.branch_and_bound import Bound, Box, BoxProof
from tresym.reals.balls.tracing import Named, Part, Program, traced
from tresym.reals.decisions.identity import decide_continuous
from tresym.reals.language.binders import elementary
from tresym.reals.language.expression import ZERO, Expr, number
from tresym.reals.language.formula import Relation
from tresym.reals.numbers.arithmetic import ball_precision, balls
from tresym.reals.numbers.exact import InputError
from tresym.reals.signs.closure import has_inside, is_regular
from tresym.reals.verdict import Verdict

FINE = 512
"""Bits at which a quotient's divisor must differ from 0 somewhere."""


@dataclass(frozen=True)
class Reading:
    """What a named step of a margin is, at these arguments, in the claim's symbols.

    A part, or what a named function means, is worked out, with the claims put in, and equals the
    value by the exact procedure. A root satisfies its equation by a claim, which says that the
    value equals its image, and lies between the ends.

    Attributes:
        step: the part, or the root.
        at: its arguments.
        value: what it is there.
        given: under which conditions.
        claims: claims that are put in.
        cited: claims whose bounds are used.
        inner: readings that are used in it.
    """

    step: Named | Part
    at: tuple[Expression, ...]
    value: Expression
    given: tuple[Basic, ...]
    claims: tuple[Claim, ...] = ()
    cited: tuple[Claim, ...] = ()
    inner: tuple[Reading, ...] = ()

    def __hash__(self) -> int:
        return hash((id(self.step), self.at, self.value))


@dataclass(frozen=True)
class Shown:
    """A side of what is said, as ``over`` times a margin in the coordinates, and ``spare``.

    Attributes:
        margin: a function of the coordinates and the arithmetic.
        over: the factor, in the claim's symbols; its sign is proven.
        spare: what is left over, which is proven not to be negative.
        slopes: whether mean-value forms are tried too.
    """

    margin: Callable[..., Any]
    over: Expression = S.One
    spare: Expression = S.Zero
    slopes: bool = False
    precision: int = 64


@dataclass(frozen=True)
class On:
    """A chart: its coordinates, the box that holds them, and what is shown there.

    Attributes:
        coordinates: in the claim's symbols.
        box: a closed box.
        shown: margins, one for each side of what is said.
        where: the part of the region that the chart is for; with none, all of it.
        cited: claims whose bounds show, there, the signs of factors and of what is left over.
    """

    coordinates: tuple[Expression, ...]
    box: Box
    shown: tuple[Shown, ...]
    where: tuple[Basic, ...] = ()
    cited: tuple[Claim, ...] = ()


@dataclass(frozen=True)
class Charted:
    """Every chart shows every side of what is said, and together they cover the region.

    Attributes:
        on: the charts.
        readings: what named steps of the margins are.
        put: equations of earlier claims that are put into what is said.
        cited: earlier claims whose bounds are used.
        stored: gives the stored proofs, or None where there are none.
        budget: boxes a search may look at, for each margin.
        constant: the constant of the bound, where it has one.
        also: what the programs of the margins rest on beside.
        remainder: how an order that is printed beside the bound is read.
    """

    on: tuple[On, ...]
    readings: tuple[Reading, ...] = ()
    put: tuple[Claim, ...] = ()
    cited: tuple[Claim, ...] = ()
    stored: Callable[[], tuple[BoxProof, ...] | None] | None = None
    budget: int = 30_000
    constant: fmpq | None = None
    also: tuple[Claim, ...] = field(default=())
    remainder: Any = None
    kind: ClassVar[str] = "bound"
    expect: ClassVar[Verdict] = Verdict.ENCLOSED

    @property
    def claims(self) -> tuple[Claim, ...]:
        """What the passage rests on."""
        there = (claim for on in self.on for claim in on.cited)
        return (*self.put, *self.cited, *there, *_claims(self.readings), *self.also)

    @property
    def bounds(self) -> tuple[Bound, ...]:
        """What balls show: each margin is positive on its box."""
        return tuple(
            Bound(traced(s.margin, len(on.box)), on.box, s.slopes, s.precision, sufficient=True)
            for on in self.on
            for s in on.shown
        )


def _claims(readings: tuple[Reading, ...]) -> Iterator[Claim]:
    for reading in readings:
        yield from (*reading.claims, *reading.cited, *_claims(reading.inner))


def judge_charted(claim: Claim, proof: Charted) -> Finding:
    """ENCLOSED where the passage is shown and every margin is positive on its box."""
    try:
        why = _gap(claim, proof)
    except (NotShownError, InputError, TypeError) as error:
        why = str(error)
    if why is not None:
        return Finding(Verdict.UNDECIDED, why)
    decisions = decisions_of(proof.bounds, proof.stored, proof.budget)
    constant = None if proof.constant is None else decimal(proof.constant)
    return closed(decisions, ", ".join(map(str, claim.given)), constant)


def _gap(claim: Claim, proof: Charted) -> str | None:
    """What is missing on the way from the margins to what is said, or None."""
    statement = claim.statement
    if statement is None:
        return "no formula is said"
    given = with_bounds(conditions(claim.given), (citing(*proof.cited),))
    stated = known(conditions(claim.given))
    if not (is_regular(stated) and has_inside(stated)):
        return "the region is not shown to be the closure of its inside"
    rules, meant = instantiated(proof.put, given)
    sides = tuple(_sides(statement, rules, meant))
    if not sides:
        return "there is nothing to show"
    if not _covered(given, proof.on):
        return "the charts do not cover the region"
    for on in proof.on:
        where = conditions(on.where)
        here = with_bounds((*meant, *where), (citing(*on.cited),))
        place = _Place(on, proof.readings, rules, (*given, *where), here)
        why = place.outside() or next(filter(None, map(place.gap, sides)), None)
        if why is not None:
            return why
    return None


def _sides(statement: Basic, rules: Rules, given: Conditions) -> Iterator[Expr]:
    """What must be positive, or not negative, for what is said: the room on every side.

    Raises:
        NotShownError: what is said is no bound, or is not shown to be defined.
    """
    for part in parts_of(statement):
        for relation in conjuncts(formula(part)):
            if not isinstance(relation, Relation) or relation.sign in ("==", "!="):
                raise NotShownError(f"{part} is no bound")
            up = relation.upward
            high, low = put_in(up.left, rules), put_in(up.right, rules)
            for side in (high, low):
                gap = undefined(side, given)
                if gap is not None:
                    raise NotShownError(f"nothing shows that {gap} allows its operation")
            if low.op == "abs":
                yield high - low.args[0]
                yield high + low.args[0]
            else:
                yield high - low


def _covered(given: Conditions, charts: tuple[On, ...]) -> bool:
    """Whether every point of the region is where one of the charts is for.

    At a point outside the first, one of its conditions fails: there the others must cover.
    """
    if not charts:
        return any(is_manifest(condition.negated, given) for condition in given)
    first, *others = charts
    for condition in conditions(first.where):
        if condition not in given:
            left = (*given, condition.negated)
            if not (_covered(left, tuple(others)) or is_manifest(condition, given)):
                return False
        given = (*given, condition)
    return True


class _Place:
    """The region of a chart: what its coordinates and the steps of its margins are there."""

    def __init__(
        self,
        on: On,
        readings: tuple[Reading, ...],
        rules: Rules,
        region: Conditions,
        given: Conditions,
    ) -> None:
        """``given`` are the conditions of the region, and what they come to by the rules."""
        self.on, self.readings, self.rules = on, readings, rules
        self.given = given
        self.coordinates = tuple(map(tree, on.coordinates))
        where = conditions(on.where)
        general = tuple(c for c in region if c not in where)
        self.places = (region, *((*general, c) for c in where))

    def outside(self) -> str | None:
        """Which coordinate is not shown to lie in the box, or None."""
        if len(self.coordinates) != len(self.on.box):
            return "the box has another number of sides than there are coordinates"
        for x, side in zip(self.coordinates, self.on.box, strict=True):
            for end, sign in ((side.low, ">="), (side.high, "<=")):
                inside = Relation(x, sign, number(end))
                # One condition of the chart may be enough, and the others in the way.
                if not any(is_manifest(inside, place) for place in self.places):
                    return f"{x} {sign} {end} is not shown"
        return None

    def gap(self, side: Expr) -> str | None:
        """Why no margin shows this side, or None."""
        gaps = []
        for shown in self.on.shown:
            gaps.append(self._gap(side, shown))
            if gaps[-1] is None:
                return None
        return gaps[0] if gaps else "no margin is given"

    def _gap(self, side: Expr, shown: Shown) -> str | None:
        program = traced(shown.margin, len(self.coordinates))
        over, spare = (put_in(tree(e), self.rules) for e in (shown.over, shown.spare))
        if not is_manifest(Relation(over, ">", ZERO), self.given):
            return f"{over} is not shown to be positive"
        if not is_manifest(Relation(spare, ">=", ZERO), self.given):
            return f"{spare} is not shown not to be negative"
        if not _divides_somewhere(program, self.on.box):
            return "a quotient has no value anywhere in the box"
        margin = program.meaning(self.coordinates, self.step)
        return _different(side, put_in(over * margin + spare, self.rules), self.given)

    def step(self, op: Any, args: tuple[Expr, ...], body: Callable[[], Expr] | None = None) -> Expr:
        """What a named step is at these arguments."""
        return _meaning(op, args, body, self.readings, self.given)


def _different(left: Expr, right: Expr, given: Conditions) -> str | None:
    if left == right:
        return None
    if not elementary(left, right):
        return "an integral, a derivative or a limit is no part of a margin"
    decision = decide_continuous(left, right, known(given))
    return None if decision.verdict is Verdict.PROVED else decision.why


def _meaning(
    op: Any,
    args: tuple[Expr, ...],
    body: Callable[[], Expr] | None,
    readings: tuple[Reading, ...],
    given: Conditions,
) -> Expr:
    """What a named step is: by a reading, or as it says itself.

    Raises:
        NotShownError: an argument is not shown to be where the step means anything.
    """
    for reading in readings:
        if reading.step is op and all(
            _same(x, tree(y), given) for x, y in zip(args, reading.at, strict=True)
        ):
            _need(reading, given)
            return tree(reading.value)
    if body is not None:
        return body()
    if op.meaning is None:
        raise NotShownError("nothing says which root is meant")
    for room in op.asks(*args) if isinstance(op, Named) else ():
        if not is_manifest(Relation(room, ">=", ZERO), given):
            raise NotShownError(f"{room} is not shown not to be negative")
    found: Expr = op.meaning(*args)
    return found


@lru_cache(maxsize=REMEMBERED)
def _same(x: Expr, y: Expr, given: Conditions) -> bool:
    return _different(x, y, given) is None


def _need(reading: Reading, given: Conditions) -> None:
    """A reading is shown, and its conditions hold here.

    Raises:
        NotShownError: it is not, or one does not.
    """
    for condition in conditions(reading.given):
        if condition not in given and not is_manifest(condition, given):
            raise NotShownError(f"{condition} is not shown, but a reading needs it")
    why = _unread(reading)
    if why is not None:
        raise NotShownError(why)


@lru_cache(maxsize=REMEMBERED)
def _unread(reading: Reading) -> str | None:
    """Why a step is not shown to be what it is read as, or None."""
    stated = conditions(reading.given)
    given = with_bounds(stated, (citing(*reading.cited),))
    at, value = tuple(map(tree, reading.at)), tree(reading.value)
    if isinstance(reading.step, Part):
        rules, meant = instantiated(reading.claims, given)
        program = traced(reading.step.formula, len(at))
        found = program.meaning(
            at, lambda op, args, body=None: _meaning(op, args, body, reading.inner, given)
        )
        return _different(put_in(found, rules), put_in(value, rules), meant)
    step = reading.step
    if step.meaning is not None:
        rules, meant = instantiated(reading.claims, given)
        return _different(
            put_in(_meaning(step, at, None, (), given), rules), put_in(value, rules), meant
        )
    if step.image is None or step.between is None:
        return "that is no root"
    low, high = step.between
    for end, sign in ((low, ">="), (high, "<=")):
        if not is_manifest(Relation(value, sign, end), given):
            return f"{value} {sign} {end} is not shown"
    for room in step.asks(*at):
        if not is_manifest(Relation(room, ">=", ZERO), given):
            return f"{room} is not shown not to be negative"
    for claim in reading.claims:
        for part in conjuncts(formula(claim.decided)) if claim.in_formulas else ():
            if (
                isinstance(part, Relation)
                and part.sign == "=="
                and part.left == value
                and unmet_condition(claim, {}, given) is None
                and _different(part.right, step.image(value, *at), given) is None
            ):
                return None
    return f"no claim says that {value} is the root"


@lru_cache(maxsize=REMEMBERED)
def _divides_somewhere(program: Program, box: Box) -> bool:
    """Whether at a point of the box no argument of a quotient is 0.

    Then the points at which one is have no inside: what is shown beside them holds at them.
    """
    seen = []

    def special(op: Any, args: tuple[Any, ...]) -> Any:
        if isinstance(op, Part):
            return args[0]
        if not isinstance(op, Named):
            seen.append(args[0])
        return op(*args)

    with ball_precision(FINE):
        point = tuple(arb((2 * side.low + side.high) / 3) for side in box)
        value = program.run(point, balls, special)
        return bool(value.is_finite() and all(x != 0 for x in seen))
