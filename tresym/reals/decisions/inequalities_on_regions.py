"""Decide an inequality on a region by branch and bound, with delicate points apart.

A box is closed because the difference is positive on it, in balls or by the mean value theorem;
because a condition, or the domain, excludes all of it; because it lies beside an edge on which both
sides are equal, and the power that vanishes there is divided out (`edges_of_contact`); or, with one
variable, because it lies in a neighbourhood of an end or of a point of contact on which the
difference has the sign of its leading term.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import product
from typing import Any

from flint import arb, fmpq

from tresym.reals.balls.branch_and_bound import Bound, Box, BoxProof, Counterexample, decide_bound
from tresym.reals.balls.circle import over_a_ball
from tresym.reals.balls.simplest_constants import candidates, enclosure
from tresym.reals.balls.taylor import taylor_value
from tresym.reals.decisions.answer import Answer, exactly, refuted
from tresym.reals.decisions.edges_of_contact import Edge, Quotient, edges_of_contact
from tresym.reals.domain.compiled import Compiled
from tresym.reals.domain.conditions import Condition, Given
from tresym.reals.domain.evaluation import UndefinedError, evaluate, stands
from tresym.reals.domain.sample_points import Range
from tresym.reals.expansions.leading_terms import sign_towards
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import LEAVES, ZERO, Expr, symbols
from tresym.reals.language.solve import solutions
from tresym.reals.normal.at_point import equal_at, satisfies
from tresym.reals.normal.to_expression import numerator
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import Interval, fraction_text, near
from tresym.reals.verdict import Verdict

PRECISION = 128
BUDGETS = {1: 3_000, 2: 12_000}
LARGEST_BUDGET = 20_000
MAX_CONTACTS = 8
MAX_VARIABLES = 4
FAR = 16
_ONE, _NAN = arb(1), arb.nan()


def is_isolated(at: Mapping[str, arb], sides: tuple[Expr, Expr]) -> bool:
    """Return whether no point nearby is found where both sides are defined."""
    with ball_precision(2 * PRECISION):
        for signs in product((1, -1), repeat=len(at)):
            steps = (arb(fmpq(sign, (1 << 40) + 7**k)) for k, sign in enumerate(signs))
            near = {name: at[name] + step for name, step in zip(at, steps, strict=True)}
            if all(evaluate(side, near).is_finite() for side in sides):
                return False
    return bool(at)


def search(
    left: Expr,
    right: Expr,
    strict: bool,
    region: Given,
    inside: Given,
    most: int = LARGEST_BUDGET,
) -> Answer:
    """Decide ``left > right`` (or ``>=`` if not ``strict``) by branch and bound.

    Args:
        region: conditions that hold wherever the claim is made.
        inside: further conditions that a counterexample must satisfy.
        most: how many boxes are examined at most, in several variables.

    Returns:
        ENCLOSED, REFUTED, or UNDECIDED with the region that could not be closed.
    """
    region = _about(region, symbols(left) | symbols(right))
    names = sorted(symbols(left) | symbols(right) | region.names)
    conditions = region.conditions + _about(inside, frozenset(names)).conditions
    search_ = _Search(left, right, strict, region, names, conditions)
    ranges = [region.box.get(name, Range()) for name in names]
    if len(names) == 1:
        return search_.on_line(ranges[0])
    if len(names) <= MAX_VARIABLES and all(map(is_bounded, ranges)):
        return search_.in_box(tuple(ranges), most)
    free = [n for n, r in zip(names, ranges, strict=True) if not is_bounded(r)]
    return Answer(
        Verdict.UNDECIDED,
        "the sign of the difference could not be proved, and interval subdivision needs bounds on "
        f"at most {MAX_VARIABLES} variables: bounds on {', '.join(free or names)} may help",
    )


def _about(region: Given, names: frozenset[str]) -> Given:
    """The conditions that speak of ``names``, or of what such conditions speak of."""
    while True:
        kept = [
            comparison
            for comparison, condition in zip(region.comparisons, region.conditions, strict=True)
            if symbols(condition.expression) & names
        ]
        others = Given(tuple(kept))
        if others.names <= names:
            return others
        names |= others.names


def is_bounded(where: Range) -> bool:
    """Whether both ends are finite."""
    return where.low is not None and where.high is not None


def _rate(slope: Expr, names: Sequence[str]) -> Callable[..., arb]:
    """Return a slope as a function; NaN where it has no formula, as in the order of besselk."""
    compiled = _compiled(slope, names)
    return (lambda *_: arb.nan()) if compiled is None else compiled.real


def _compiled(e: Expr, names: Sequence[str]) -> Compiled | None:
    try:
        return Compiled(e, names)
    except UndefinedError:
        return None


@dataclass
class _Search:
    """One inequality, its derivatives, and the pieces of the line that are closed already."""

    left: Expr
    right: Expr
    strict: bool
    region: Given
    names: list[str]
    spoken_of: tuple[Condition, ...]
    """What holds at a point at which the claim speaks, and is refuted if it fails."""
    pieces: list[tuple[fmpq, fmpq]] = field(default_factory=list)
    edges: list[tuple[Edge, Quotient]] = field(default_factory=list)
    compiled: dict[Expr, Compiled | None] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.difference = self.left - self.right
        self.slopes = [differentiate(self.difference, name) for name in self.names]
        self.smooth = list(_smooth_parts(self.difference)) or [self.difference]
        self.value = Compiled(self.difference, self.names).real
        self.rates = [_rate(slope, self.names) for slope in self.slopes]
        self.bounds = [
            (Compiled(c.expression, self.names).real, c.relation) for c in self.region.conditions
        ]

    # -- one variable -----------------------------------------------------------------------

    def on_line(self, where: Range) -> Answer:
        """The whole range of the one variable: infinite ends by growth, then boxes.

        Where growth does not settle an infinite end, a part of the range is searched for a
        refutation.
        """
        ends = []
        failure = None
        for side, end, other in ((-1, where.low, where.high), (1, where.high, where.low)):
            if end is not None:
                ends.append(end)
                continue
            beside = sign_towards(self.difference, self.names[0], None, side)
            if beside is None or beside[0] < 0 or (self.strict and beside[0] == 0):
                failure = self._failure_towards(None, side, beside)
                if failure.verdict is Verdict.REFUTED:
                    return failure
                ends.append((other or fmpq(0)) + side * FAR)
                continue
            ends.append(side / beside[1])
        low, high = ends
        if low > high:  # the neighbourhoods of both infinities cover the line
            low, high = high, low
        answer = self._within(Interval(low, high))
        return answer if failure is None or answer.verdict is Verdict.REFUTED else failure

    def _within(self, whole: Interval) -> Answer:
        """A bounded range: boxes, and neighbourhoods of the points of contact."""
        for _ in range(MAX_CONTACTS):
            outcome = self._prove((whole,), BUDGETS[1])
            if isinstance(outcome, Answer):
                return outcome
            failure = self._contact(outcome[0], whole)
            if failure is not None:
                return failure
        return _open(self.names, (whole,))

    def _contact(self, worst: Interval, whole: Interval) -> Answer | None:
        """Close a neighbourhood of the point of contact in ``worst``; an answer if that fails."""
        slope = numerator(self.slopes[0], self.region)
        known = solutions(slope, self.names[0]) + solutions(self.difference, self.names[0])
        for point in candidates(worst, known):
            inside = self._at_contact(point)
            if isinstance(inside, Answer):
                return inside
            if not inside:
                continue
            piece = self._piece(point, whole)
            if isinstance(piece, Answer) and piece.verdict is Verdict.REFUTED:
                return piece
            if isinstance(piece, tuple) and piece[0] <= worst.low and worst.high <= piece[1]:
                self.pieces.append(piece)
                return None
        return _open(self.names, (worst,))

    def _piece(self, point: Expr, whole: Interval) -> tuple[fmpq, fmpq] | Answer | None:
        """An interval about ``point``, within ``whole``, where the claim holds off the point."""
        low, high = enclosure(point)
        ends = [low, high]
        for k, side in enumerate((-1, 1)):
            if low == high == whole[k]:
                ends[k] += side  # nothing is claimed beyond the end, where the box's ball may reach
                continue
            beside = self._excluded_beside(point, side)
            if beside is None:
                beside = sign_towards(self.difference, self.names[0], point, side)
                if beside is not None and beside[0] < 0:
                    return self._failure_towards(point, side, beside)
            if beside is None or (self.strict and beside[0] == 0):
                return None
            ends[k] = (low if side > 0 else high) + side * beside[1]
        return (ends[0], ends[1]) if ends[0] <= ends[1] else None

    def _excluded_beside(self, point: Expr, side: int) -> tuple[int, fmpq] | None:
        """A neighbourhood on that side which a condition excludes."""
        for condition in self.region.conditions:
            if condition.relation != "!=":
                beside = sign_towards(condition.expression, self.names[0], point, side)
                if beside is not None and beside[0] < 0:
                    return beside
        return None

    def _at_contact(self, point: Expr) -> bool | Answer:
        """Whether the claim holds at the point itself or does not speak of it."""
        name = self.names[0]
        with ball_precision(2 * PRECISION):
            at = {name: evaluate(point, {})}
            if not at[name].is_finite():
                return False  # a candidate need not be real
            value = evaluate(self.difference, at)
            if any(self._fails(condition, point, at) for condition in self.region.conditions):
                return True
        if value > 0:
            return point.op == "number"  # no other point is one of contact by chance
        if not value.is_finite() or not equal_at(self.left, self.right, {name: point}):
            return False
        if not self.strict:
            return True
        with ball_precision(2 * PRECISION):
            if is_isolated(at, (self.left, self.right)):
                return True
            if all(satisfies(c, {name: point}, at) for c in self.spoken_of):
                values = [evaluate(side, at) for side in (self.left, self.right)]
                return refuted(
                    exactly("both sides are equal", {name: point}), {name: point}, *values
                )
        return False

    def _fails(self, condition: Condition, point: Expr, at: dict[str, arb]) -> bool:
        """Whether the condition excludes the point."""
        e, relation = condition.expression, condition.relation
        value = evaluate(e, at)
        if value < 0 and relation != "!=":
            return True
        if relation == ">=" or not (value.is_finite() and value.contains(0)):
            return False
        return equal_at(e, ZERO, {self.names[0]: point})

    def _failure_towards(
        self, point: Expr | None, side: int, beside: tuple[int, fmpq] | None
    ) -> Answer:
        """A refutation beside a point with a negative leading term, if a rational shows it."""
        where = "infinity" if point is None else f"{self.names[0]} = {point}"
        if beside is not None and (point is None or point.op == "number"):
            for k in range(1, 12):
                t = beside[1] / 2**k
                x = side / t if point is None else point.args[0] + side * t
                answer = self._refute((x,))
                if answer is not None:
                    return answer
        return Answer(
            Verdict.UNDECIDED,
            f"the sign of the difference near {where} could not be determined; a condition that "
            "excludes a neighbourhood may help",
        )

    # -- boxes ------------------------------------------------------------------------------

    def in_box(self, sides: Box, most: int) -> Answer:
        """A bounded region of several variables; a strict claim is not made on its open edges."""
        for edge in edges_of_contact(self.difference, self.names, sides, self.region):
            where = self.region.box[self.names[edge.axis]]
            is_open = where.low_open if edge.side > 0 else where.high_open
            if is_open or not self.strict:
                over = Quotient(self.difference, self.slopes, self.names, edge)
                self.edges.append((edge, over))
        outcome = self._prove(sides, min(most, BUDGETS.get(len(sides), LARGEST_BUDGET)))
        return outcome if isinstance(outcome, Answer) else _open(self.names, outcome)

    def _prove(self, sides: Box, budget: int) -> Answer | Box:
        """ENCLOSED, REFUTED, or the box that stayed open."""
        outcome = decide_bound(Bound(self._margin, sides, precision=PRECISION), budget)
        if isinstance(outcome, BoxProof):
            return Answer(Verdict.ENCLOSED, self._closed(outcome.leaves))
        if isinstance(outcome, Counterexample):
            refutation = self._refute(outcome.point)
            return (
                tuple(Interval(x, x) for x in outcome.point) if refutation is None else refutation
            )
        return outcome.worst

    def _closed(self, leaves: int) -> str:
        parts = [f"verified in interval arithmetic on {leaves} box" + "es" * (leaves != 1)]
        if count := len(self.pieces):
            plural = "s" * (count != 1)
            parts.append(f"and by series expansion near {count} point{plural} of contact")
        for edge, _ in self.edges:
            where = f"{self.names[edge.axis]} = {fraction_text(edge.at)}"
            parts.append(f"and, beside {where}, after division by a power of order {edge.power}")
        return " ".join(parts)

    def _refute(self, point: tuple[fmpq, ...]) -> Answer | None:
        """A refutation at a simple point nearby, or at the point itself."""
        for tolerance in (fmpq(1, 2**10), fmpq(1, 2**30)):
            answer = self._refute_at(tuple(near(x, tolerance) for x in point))
            if answer is not None:
                return answer
        return self._refute_at(point)

    def _refute_at(self, point: tuple[fmpq, ...]) -> Answer | None:
        exact = dict(zip(self.names, point, strict=True))
        for bits in (128, 1000):
            with ball_precision(bits):
                at = {name: arb(x) for name, x in exact.items()}
                if not all(condition.holds_exactly(at) for condition in self.spoken_of):
                    continue
                x, y = evaluate(self.left, at), evaluate(self.right, at)
                if x < y and not is_isolated(at, (self.left, self.right)):
                    return refuted(exactly("it fails", exact), exact, x, y)
        return None

    def _margin(self, *arguments: Any) -> arb:
        """Positive where the claim holds on the whole box; negative where it surely fails."""
        coordinates = arguments[:-1]
        inside = True
        for bound, relation in self.bounds:
            value = bound(*coordinates)
            if value.is_zero() if relation == "!=" else value < 0:
                return _ONE
            if relation == ">" and value <= 0:
                return _ONE
            inside = inside and stands(value, relation)
        if any(_contains(piece, coordinates[0]) for piece in self.pieces):
            return _ONE
        value = self.value(*coordinates)
        if value > 0 or (not self.strict and value >= 0):
            return _ONE
        touching = any(coordinates[edge.axis].contains(edge.at) for edge, _ in self.edges)
        if value.is_finite() and not touching and not all(x.is_exact() for x in coordinates):
            least = self._mean_value(coordinates)
            if least > 0 or (not self.strict and least >= 0):
                return _ONE
            if len(coordinates) == 1 and self._by_taylor(coordinates[0]) > 0:
                return _ONE
        for _, quotient in self.edges:
            if quotient.least(coordinates) > 0:
                return _ONE
        return value if inside else _NAN

    def _by_taylor(self, x: arb) -> arb:
        """The difference on an interval, what its absolute values are of by Taylor's theorem."""
        (name,) = self.names
        known = {part: self._over(part, x) for part in self.smooth}
        if known.get(self.difference) is not None:
            return known[self.difference]
        return evaluate(self.difference, {name: x}, known)

    def _over(self, part: Expr, x: arb) -> arb:
        """A part on an interval, by power series or, where a function has none, by a circle."""
        value = taylor_value(part, self.names[0], x)
        if value.is_finite():
            return value
        if part not in self.compiled:
            self.compiled[part] = _compiled(part, self.names)
        compiled = self.compiled[part]
        return value if compiled is None else over_a_ball(compiled, x)

    def _mean_value(self, coordinates: tuple[arb, ...]) -> arb:
        """A ball whose lower end bounds the difference below on the box."""
        corner = []
        spread = arb(0)
        for x, rate in zip(coordinates, self.rates, strict=True):
            slope = rate(*coordinates)
            if not slope.is_finite():
                return _NAN
            if slope >= 0 or slope <= 0:
                corner.append(x.lower() if slope >= 0 else x.upper())
            else:
                corner.append(x.mid())
                spread += slope * (x - x.mid())
        return self.value(*corner) + spread


def _smooth_parts(e: Expr) -> Iterator[Expr]:
    """What absolute values are of, if there is none in it."""
    if e.op in LEAVES:
        return
    inner = [part for arg in e.args for part in _smooth_parts(arg)]
    yield from inner if inner or e.op != "abs" else e.args


def _contains(piece: tuple[fmpq, fmpq], x: arb) -> bool:
    return bool(x >= arb(piece[0]) and x <= arb(piece[1]))


def _open(names: list[str], worst: Box) -> Answer:
    with ball_precision(PRECISION):
        near = ", ".join(
            f"{name} = {arb((side.low + side.high) / 2).str(8, radius=False)}"
            for name, side in zip(names, worst, strict=True)
        )
    return Answer(
        Verdict.UNDECIDED,
        f"interval subdivision did not succeed near {near}: the two "
        "sides may touch there; a smaller region may help",
    )
