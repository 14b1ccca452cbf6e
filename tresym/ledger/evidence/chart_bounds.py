"""Bounds on a region, proved by positive margins on closed boxes in suitable coordinates.

The claim states a bound; its conditions describe the region. The evidence consists of charts. A
chart has coordinates, which are functions of the claim's symbols and map the region into a box, and
for each side of the bound a margin: a function of the coordinates that is positive on the box.

Two things are checked:

1. Exactly: after substitution of definitions, the difference of the sides of the bound is
   ``over`` times the margin plus ``spare``, where the sign prover shows ``over`` > 0 and
   ``spare`` ≥ 0. The identity is decided by exact normal forms.
2. In ball arithmetic: every margin is positive on its box (branch and bound).

A margin is a Python function that is traced, so the program that runs in balls and the formula that
is compared exactly consist of the same steps. A :class:`Reading` identifies a named step with a
defined symbol or a longer expression. Where a quotient is undefined on the boundary of the box, the
program continues the margin; this is sound because every point of the region is a limit of points
at which all parts are defined.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any, ClassVar

from flint import arb, fmpq

from tresym.ledger.claim import Claim
from tresym.ledger.conversion import (
    REMEMBERED,
    Conditions,
    Rules,
    known,
    put_in,
)
from tresym.ledger.evidence.box_bounds import Boxes, closed, decimal, decisions_of
from tresym.ledger.evidence.integrals import NotShownError, with_bounds
from tresym.ledger.evidence.premises import instantiated, unmet_condition
from tresym.ledger.evidence.sign_prover import is_manifest, shortened, undefined
from tresym.ledger.finding import Finding
from tresym.ledger.formulas import Condition, in_order, in_trees, mapped, relations_of
from tresym.ledger.reasons import citing
from tresym.reals.balls.branch_and_bound import Bound, Box, BoxProof
from tresym.reals.balls.tracing import Named, Part, Program, traced
from tresym.reals.decisions.identity import decide_continuous
from tresym.reals.domain.operation_domains import operations
from tresym.reals.language.binders import elementary
from tresym.reals.language.expression import (
    LEAVES,
    ONE,
    ZERO,
    Expr,
    number,
    replaced,
    symbols,
)
from tresym.reals.language.formula import Relation
from tresym.reals.numbers.arithmetic import ball_precision, balls
from tresym.reals.numbers.exact import InputError
from tresym.reals.signs.closure import has_inside, is_regular
from tresym.reals.verdict import Verdict

FINE = 512
"""Precision in bits for the test that the divisors of a margin do not vanish identically."""


@dataclass(frozen=True)
class Reading:
    """The statement that a named step of a margin equals an expression in the claim's symbols.

    For a part or a named function with a formula, the equality is decided exactly after
    substituting the claims. For a root, a claim must state its equation, and the value must lie
    between the ends.

    Attributes:
        step: the named step.
        at: its arguments.
        value: the expression that it equals at these arguments.
        given: the conditions under which it does.
        claims: claims whose equations are substituted.
        cited: claims whose bounds are used.
        inner: readings of steps inside this step.
    """

    step: Named | Part
    at: tuple[Expr, ...]
    value: Expr
    given: tuple[Condition, ...]
    claims: tuple[Claim, ...] = ()
    cited: tuple[Claim, ...] = ()
    inner: tuple[Reading, ...] = ()

    def __hash__(self) -> int:
        return hash((id(self.step), self.at, self.value))


@dataclass(frozen=True)
class Shown:
    """One side of the bound, written as ``over`` · margin + ``spare``.

    Attributes:
        margin: a function of the coordinates and the arithmetic.
        over: a factor in the claim's symbols that is proved to be positive.
        spare: a term in the claim's symbols that is proved to be non-negative.
        slopes: whether the mean value form is tried, too.
        precision: precision of the balls in bits.
    """

    margin: Callable[..., Any]
    over: Expr = ONE
    spare: Expr = ZERO
    slopes: bool = False
    precision: int = 64


@dataclass(frozen=True)
class On:
    """A chart: coordinates, a box that contains their values, and the margins on it.

    Attributes:
        coordinates: functions of the claim's symbols.
        box: a closed box.
        shown: margins, one for each side of the bound.
        where: conditions that describe the part of the region covered by the chart; empty for all.
        cited: claims whose bounds are used for the signs of ``over`` and ``spare``.
    """

    coordinates: tuple[Expr, ...]
    box: Box
    shown: tuple[Shown, ...]
    where: tuple[Condition, ...] = ()
    cited: tuple[Claim, ...] = ()


@dataclass(frozen=True)
class Charted:
    """Evidence for a bound on a region: charts that cover the region, each with all sides.

    Attributes:
        on: the charts.
        readings: the meanings of named steps of the margins.
        put: earlier claims whose equations are substituted into the statement.
        cited: earlier claims whose bounds are used.
        stored: returns the stored proofs, or None if there are none.
        budget: maximal number of boxes in a search, per margin.
        constant: the constant of the bound, or None.
        also: further claims that the programs of the margins depend on.
        remainder: a `Remainder`: how the order printed in the paper is interpreted; or None.
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
        """The claims that the evidence uses."""
        there = (claim for on in self.on for claim in on.cited)
        return (*self.put, *self.cited, *there, *_claims(self.readings), *self.also)

    @property
    def bounds(self) -> tuple[Bound, ...]:
        """The bounds for ball arithmetic: each margin is positive on its box."""
        return tuple(
            Bound(traced(s.margin, len(on.box)), on.box, s.slopes, s.precision, sufficient=True)
            for on in self.on
            for s in on.shown
        )


Stated = Callable[..., tuple[Claim, ...]]
"""Returns the claims with these labels, those that a file has stated."""


@dataclass(frozen=True)
class Charts:
    """Charts as stored data, which a claim of a file names behind ``shown by charts``.

    Attributes:
        made: returns the charts and readings, for a file that has stated the claims which say what
            the steps of the margins are. What is put in and cited stands in the file. Or returns
            boxes, if the symbols of the claim are no functions of their coordinates.
    """

    made: Callable[[Stated], Charted | Boxes]


def _claims(readings: tuple[Reading, ...]) -> Iterator[Claim]:
    """Yield the claims that the readings use."""
    for reading in readings:
        yield from (*reading.claims, *reading.cited, *_claims(reading.inner))


def _tree(e: Any) -> Expr:
    """Return an expression of the evidence with its terms and factors in one order."""
    return in_order(in_trees(e))


def _conditions(given: tuple[Condition, ...]) -> Conditions:
    """Return conditions in the same order of terms and factors, so that they can be compared."""
    found = tuple(r for c in given for r in relations_of(in_trees(c)))
    odd = next((r for r in found if r.sign == "=="), None)
    if odd is not None:
        raise InputError(f"{odd} is not an inequality such as a > 0, as a condition must be")
    return tuple(mapped(relation, in_order) for relation in found)


def judge_charted(claim: Claim, proof: Charted) -> Finding:
    """Return ENCLOSED if the margins imply the statement and are positive on their boxes."""
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
    """Return why the margins do not imply the statement, or None if they do."""
    statement = claim.statement
    if statement is None:
        return "the claim states no formula"
    given = with_bounds(_conditions(claim.given), (citing(*proof.cited),))
    stated = known(_conditions(claim.given))
    if not (is_regular(stated) and has_inside(stated)):
        return "could not show that the region is the closure of its interior"
    rules, meant = instantiated(proof.put, given)
    sides = tuple(_sides(statement, rules, meant))
    if not sides:
        return "the statement contains no relation that could be shown"
    if not _covered(given, proof.on):
        return "could not show that the charts cover the region"
    for on in proof.on:
        where = _conditions(on.where)
        here = with_bounds((*meant, *where), (citing(*on.cited),))
        place = _Place(on, proof.readings, rules, (*given, *where), here)
        why = place.outside() or next(filter(None, map(place.gap, sides)), None)
        if why is not None:
            return why
    return None


def _sides(statement: Any, rules: Rules, given: Conditions) -> Iterator[Expr]:
    """Yield the differences that must be positive (or non-negative); two for |a| ≤ b.

    Raises:
        NotShownError: the statement is not a bound, or could not be shown to be defined.
    """
    for relation in relations_of(statement):
        if relation.sign in ("==", "!="):
            raise NotShownError(f"{relation} is not an inequality with <, <=, > or >=")
        up = relation.upward
        high, low = put_in(up.left, rules), put_in(up.right, rules)
        for side in (high, low):
            gap = undefined(side, given)
            if gap is not None:
                raise NotShownError(
                    f"could not show that {gap} lies in the domain of its operation"
                )
        if low.op == "abs":
            yield high - low.args[0]
            yield high + low.args[0]
        else:
            yield high - low


def _covered(given: Conditions, charts: tuple[On, ...]) -> bool:
    """Return whether the charts are proved to cover the region.

    At a point outside the first chart one of its conditions fails; there the other charts must
    cover the region (recursively).
    """
    if not charts:
        return any(is_manifest(condition.negated, given) for condition in given)
    first, *others = charts
    for condition in _conditions(first.where):
        if condition not in given:
            left = (*given, condition.negated)
            if not (_covered(left, tuple(others)) or is_manifest(condition, given)):
                return False
        given = (*given, condition)
    return True


class _Place:
    """The region of a chart, with the meanings of its coordinates and of its margins' steps."""

    def __init__(
        self,
        on: On,
        readings: tuple[Reading, ...],
        rules: Rules,
        region: Conditions,
        given: Conditions,
    ) -> None:
        """Store the conditions; ``given`` also contains them with the rules substituted."""
        self.on, self.readings, self.rules = on, readings, rules
        self.given = given
        self.coordinates = tuple(map(_tree, on.coordinates))
        where = _conditions(on.where)
        general = tuple(c for c in region if c not in where)
        self.places = (region, *((*general, c) for c in where))

    def outside(self) -> str | None:
        """Return which coordinate could not be shown to lie in the box, or None."""
        if len(self.coordinates) != len(self.on.box):
            return (
                f"the box has {len(self.on.box)} sides, but there are {len(self.coordinates)} "
                "coordinates"
            )
        for x, side in zip(self.coordinates, self.on.box, strict=True):
            for end, sign in ((side.low, ">="), (side.high, "<=")):
                inside = Relation(x, sign, number(end))
                # A single condition of the chart is often enough, and the others can distract
                # the prover.
                if not any(is_manifest(inside, place) for place in self.places):
                    return f"could not show that the coordinate satisfies {x} {sign} {end}"
        return None

    def gap(self, side: Expr) -> str | None:
        """Return why no margin shows this side of the bound, or None if one does."""
        gaps = []
        for shown in self.on.shown:
            gaps.append(self._gap(side, shown))
            if gaps[-1] is None:
                return None
        return gaps[0] if gaps else "the chart contains no margin"

    def _gap(self, side: Expr, shown: Shown) -> str | None:
        """Return why this margin does not show the side, or None if it does."""
        program = traced(shown.margin, len(self.coordinates))
        over, spare = (put_in(_tree(e), self.rules) for e in (shown.over, shown.spare))
        if not is_manifest(Relation(over, ">", ZERO), self.given):
            return f"could not show that the factor {over} is positive"
        if not is_manifest(Relation(spare, ">=", ZERO), self.given):
            return f"could not show that {spare} is not negative"
        if not _divides_somewhere(program, self.on.box):
            return "could not show that the divisors in the margin are not identically zero"
        margin = program.meaning(self.coordinates, self.step)
        return _different(side, _put_in(over * margin + spare, self.rules, self.given), self.given)

    def step(self, op: Any, args: tuple[Expr, ...], body: Callable[[], Expr] | None = None) -> Expr:
        """Return the meaning of a named step at these arguments."""
        return _meaning(op, args, body, self.readings, self.given)


def _different(left: Expr, right: Expr, given: Conditions) -> str | None:
    """Return why the two sides are not proved equal, or None if they are."""
    if left == right:
        return None
    if not elementary(left, right):
        return "a margin must not contain integrals, derivatives or limits"
    decision = decide_continuous(left, right, known(given))
    return None if decision.verdict is Verdict.PROVED else decision.why


def _meaning(
    op: Any,
    args: tuple[Expr, ...],
    body: Callable[[], Expr] | None,
    readings: tuple[Reading, ...],
    given: Conditions,
) -> Expr:
    """Return the meaning of a named step: by a reading, or by its own formula.

    Raises:
        NotShownError: an argument could not be shown to lie in the domain of the step.
    """
    for reading in readings:
        if reading.step is op and all(
            _same(x, _tree(y), given) for x, y in zip(args, reading.at, strict=True)
        ):
            _need(reading, given)
            return _tree(reading.value)
    if body is not None:
        return body()
    if op.meaning is None:
        raise NotShownError("no reading says which root a step of the margin denotes")
    for required in op.asks(*args) if isinstance(op, Named) else ():
        if not is_manifest(Relation(required, ">=", ZERO), given):
            raise NotShownError(f"could not show that {required} is not negative")
    found: Expr = op.meaning(*args)
    return found


@lru_cache(maxsize=REMEMBERED)
def _same(x: Expr, y: Expr, given: Conditions) -> bool:
    """Return whether two expressions are proved equal under the conditions."""
    return _different(x, y, given) is None


def _need(reading: Reading, given: Conditions) -> None:
    """Require that the reading is correct and that its conditions hold here.

    Raises:
        NotShownError: one of both could not be shown.
    """
    for condition in _conditions(reading.given):
        if condition not in given and not is_manifest(condition, given):
            raise NotShownError(f"a reading needs {condition}, which could not be shown")
    why = _unread(reading)
    if why is not None:
        raise NotShownError(why)


@lru_cache(maxsize=REMEMBERED)
def _unread(reading: Reading) -> str | None:
    """Return why a reading could not be shown to be correct, or None if it is."""
    stated = _conditions(reading.given)
    given = with_bounds(stated, (citing(*reading.cited),))
    at, value = tuple(map(_tree, reading.at)), _tree(reading.value)
    if isinstance(reading.step, Part):
        rules, meant = instantiated(reading.claims, given)
        program = traced(reading.step.formula, len(at))
        found = program.meaning(
            at, lambda op, args, body=None: _meaning(op, args, body, reading.inner, given)
        )
        found = shortened(found, given)  # as claims are written
        return _different(_put_in(found, rules, meant), _put_in(value, rules, meant), meant)
    step = reading.step
    if step.meaning is not None:
        rules, meant = instantiated(reading.claims, given)
        found = _meaning(step, at, None, (), given)
        return _different(_put_in(found, rules, meant), _put_in(value, rules, meant), meant)
    if step.image is None or step.between is None:
        return "the step of the reading is neither a formula nor a root"
    low, high = step.between
    for end, sign in ((low, ">="), (high, "<=")):
        if not is_manifest(Relation(value, sign, end), given):
            return f"could not show {value} {sign} {end}"
    for required in step.asks(*at):
        if not is_manifest(Relation(required, ">=", ZERO), given):
            return f"could not show that {required} is not negative"
    for claim in reading.claims:
        for part in claim.parts if claim.in_formulas else ():
            if (
                isinstance(part, Relation)
                and part.sign == "=="
                and part.left == value
                and unmet_condition(claim, {}, given) is None
                and _different(part.right, step.image(value, *at), given) is None
            ):
                return None
    return f"no claim states that {value} is the root"


def _put_in(e: Expr, rules: Rules, given: Conditions) -> Expr:
    """Substitute rules, those for parts of ``e`` too that are equal to a left side.

    Example: that atan(√(b/a)) is y gives a meaning to atan(1/√(a/b)), where a and b are positive.
    """
    whole = [left for left in rules if left.op not in LEAVES]
    alike = {
        node: left
        for node in operations((e,) if whole else ())
        for left in whole
        if node.op == left.op and symbols(node) == symbols(left) and not node.loose
        if _same(node, left, given)
    }
    return put_in(replaced(e, alike), rules)


@lru_cache(maxsize=REMEMBERED)
def _divides_somewhere(program: Program, box: Box) -> bool:
    """Return whether at some point of the box no divisor of the program is 0.

    Then the zeros of the divisors have no interior (the functions are analytic), so that a bound
    proved at all other points extends to them by continuity.
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
