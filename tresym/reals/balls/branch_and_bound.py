"""Branch and bound in ball arithmetic: decide inequalities on boxes.

A *margin* is a plain function of balls (last argument the arithmetic) that a claim makes positive
on a box with rational sides. The search halves boxes until each one is closed: because the ball of
the margin over it is positive, or because its mean-value form with monotone coordinates moved to
their lower side is. What it finds is a :class:`BoxProof`, a bisection tree that can be stored,
re-checked without any search, and found anew.

Unbounded regions enter through charts (a coordinate 1/a, say), so that infinity is an edge; a
corner is closed because the margin is positive there too. An edge where the margin tends to 0 is
never closed: divide it out first.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import product
from typing import Any, ClassVar

from flint import arb, fmpq

from tresym.reals.balls.gradient import coordinates, gradients
from tresym.reals.numbers.arithmetic import ball_precision, balls
from tresym.reals.numbers.exact import Interval, as_rational, fraction_text
from tresym.reals.verdict import Verdict

Margin = Callable[..., Any]
Box = tuple[Interval, ...]
BoxPoint = tuple[fmpq, ...]

BY_BALL = "b"
BY_SLOPES = "m"
AXES = "xyzw"
SMALLEST = fmpq(1, 2**40)
"""The search ends at a box whose longest side is this part of the whole: it touches zero there."""


FINE = 512
"""Bits at which a formula must differ at two points: flat ones differ by little."""
SLENDER = 2**8
"""No box is made longer than this times its width, both as parts of the whole."""


class CertificateError(ValueError):
    """A stored box proof that is malformed or does not prove its bound."""


def box(*sides: tuple[Any, Any]) -> Box:
    """The box with these sides; ends are exact (text, integers, fractions).

    Raises:
        ValueError: a side whose ends are out of order.
    """
    made = tuple(Interval(as_rational(low), as_rational(high)) for low, high in sides)
    if any(side.low > side.high for side in made):
        raise ValueError("the ends of a side are out of order")
    return made


@dataclass(frozen=True)
class Bound:
    """The statement: ``margin(x₁, …, x_n, m) > 0`` for every point of ``box``.

    Attributes:
        margin: function of n balls and the arithmetic.
        box: the closed box.
        slopes: whether mean-value forms are tried too (the margin must run on gradients).
        precision: working precision in bits.
        sufficient: whether the margin only suffices for what is claimed. A point at which it is
            negative then refutes nothing, and the search ends open.
    """

    margin: Margin
    box: Box
    slopes: bool = False
    precision: int = 64
    sufficient: bool = False


@dataclass(frozen=True)
class BoxProof:
    """A bisection tree in prefix order, one letter a node.

    ``x``, ``y``, ``z``, ``w`` halve the box along that axis; ``b`` closes it because the ball of
    the margin over it is positive, ``m`` because the mean-value form is.
    """

    tree: str
    verdict: ClassVar = Verdict.ENCLOSED

    @property
    def leaves(self) -> int:
        """The number of boxes closed."""
        return self.tree.count(BY_BALL) + self.tree.count(BY_SLOPES)


@dataclass(frozen=True)
class Counterexample:
    """A rational point at which the ball of the margin is negative."""

    point: BoxPoint
    value: arb
    verdict: ClassVar = Verdict.REFUTED


@dataclass(frozen=True)
class Open:
    """Nothing is shown, for lack of budget or of a better margin; ``worst`` stayed open."""

    worst: Box
    verdict: ClassVar = Verdict.UNDECIDED


def inconsistent(function: Margin, region: Box, slopes: bool = False) -> str | None:
    """Why ``function`` is none of its coordinates in balls, or None; at the working precision.

    It must not be constant, and what it gives over a small box must hold what it gives at points of
    it: a margin that compares floats, forgets radii or goes by the type of what it is given does
    not.
    """
    start = tuple(side.middle for side in region)
    end = tuple((side.low + 3 * side.high) / 4 for side in region)
    near = tuple(p + (q - p) / (32 + n) for n, (p, q) in enumerate(zip(start, end, strict=True)))
    here = tuple(Interval(p, q) for p, q in zip(start, near, strict=True))
    values = [value_at(function, start), value_at(function, near), function(*_sides(here), balls)]
    if not all(isinstance(v, arb) for v in values):
        return "the formula gives no ball"
    if start == near or not all(v.is_finite() for v in values):
        return None
    first, second, whole = values
    if first.mid() == second.mid():
        with ball_precision(FINE):
            if value_at(function, start).mid() == value_at(function, near).mid():
                return "the formula does not depend on its coordinates"
    if not (whole.overlaps(first) and whole.overlaps(second)):
        return "the formula over a box does not hold its values there"
    if slopes:
        rates = _slopes(function, here)
        steps = [rate * arb(q - p) for rate, p, q in zip(rates, start, near, strict=True)]
        if not (second - first).overlaps(sum(steps, arb(0))):
            return "the formula's slopes are not those of its values"
    return None


def decide_bound(
    bound: Bound, budget: int = 20_000, stored: BoxProof | None = None
) -> BoxProof | Counterexample | Open:
    """A proof of the bound, a point that refutes it, or neither, found in ``budget`` boxes.

    What is called a proof has been checked, whether it was stored or found.

    Raises:
        CertificateError: ``stored``, or what was found, does not prove the bound.
    """
    found = stored or _found(bound, budget)
    if isinstance(found, BoxProof):
        recheck(bound, found)
    elif isinstance(found, Counterexample):
        with ball_precision(bound.precision):
            inside = all(s.holds(x) for s, x in zip(bound.box, found.point, strict=True))
            if not (inside and value_at(bound.margin, found.point) < 0):
                raise CertificateError("the bound does not fail at the point that was found")
    return found


def _found(bound: Bound, budget: int) -> BoxProof | Counterexample | Open:
    with ball_precision(bound.precision):
        for point in _inner_corners(bound.box):
            value = value_at(bound.margin, point)
            if value < 0:
                return _negative(bound, point, value)
        return _search(bound, budget)


def _negative(bound: Bound, point: BoxPoint, value: arb) -> Counterexample | Open:
    """What a point with a negative margin shows: where the margin only suffices, nothing."""
    if bound.sufficient:
        return Open(tuple(Interval(x, x) for x in point))
    return Counterexample(point, value)


def _search(bound: Bound, budget: int) -> BoxProof | Counterexample | Open:
    tree: list[str] = []
    stack = [bound.box]
    for _ in range(budget):
        if not stack:
            return BoxProof("".join(tree))
        here = stack.pop()
        if bound.margin(*_sides(here), balls) > 0:
            tree.append(BY_BALL)
            continue
        middle = tuple(side.middle for side in here)
        centre = value_at(bound.margin, middle)
        if centre < 0:
            return _negative(bound, middle, centre)
        axis = _longest(here, bound.box)
        if _relative(here, bound.box, axis) < SMALLEST:
            return Open(here)
        if bound.slopes and centre > 0:
            slopes = _slopes(bound.margin, here)
            if _extreme(bound.margin, here, slopes, lowest=True) > 0:
                tree.append(BY_SLOPES)
                continue
            axis = _steepest(here, bound.box, slopes, axis)
        tree.append(AXES[axis])
        stack.extend(reversed(halves(here, axis)))
    return Open(stack[-1]) if stack else BoxProof("".join(tree))


def recheck(bound: Bound, proof: BoxProof) -> None:
    """Check a stored proof: replay the tree and close every box again, with no search.

    Raises:
        CertificateError: the tree is malformed, or a box does not close.
    """
    with ball_precision(bound.precision):
        for here, mark in leaf_boxes(bound.box, proof):
            if mark == BY_BALL:
                closed = bound.margin(*_sides(here), balls) > 0
            else:
                slopes = _slopes(bound.margin, here)
                closed = _extreme(bound.margin, here, slopes, lowest=True) > 0
            if not closed:
                raise CertificateError(f"the box {_shown(here)} does not close")


def leaf_boxes(region: Box, proof: BoxProof) -> Iterator[tuple[Box, str]]:
    """The boxes a proof closes, which together are the region, and the marks that say how.

    Raises:
        CertificateError: the tree is malformed.
    """
    if not isinstance(proof.tree, str):
        raise CertificateError("the tree is no text")
    stack = [region]
    for mark in proof.tree:
        if not stack:
            raise CertificateError("the tree goes on after its last box")
        here = stack.pop()
        if mark in (BY_BALL, BY_SLOPES):
            yield here, mark
        elif mark in AXES[: len(here)]:
            stack.extend(reversed(halves(here, AXES.index(mark))))
        else:
            raise CertificateError(f"unknown mark {mark!r} in the tree")
    if stack:
        raise CertificateError("the tree ends before its last box")


def value_at(function: Margin, point: BoxPoint) -> arb:
    """The ball of the function at a rational point, at the working precision."""
    return function(*(arb(x) for x in point), balls)


def halves(here: Box, axis: int) -> tuple[Box, Box]:
    """The two halves of the box along ``axis``."""
    side, before, after = here[axis], here[:axis], here[axis + 1 :]
    lower, upper = side._replace(high=side.middle), side._replace(low=side.middle)
    return (*before, lower, *after), (*before, upper, *after)


def _sides(here: Box) -> tuple[arb, ...]:
    return tuple(side.ball() for side in here)


def _shown(here: Box) -> str:
    return " x ".join(f"[{fraction_text(x.low)}, {fraction_text(x.high)}]" for x in here)


def inner_points(region: Box) -> list[BoxPoint]:
    """The middle, and what is next to the corners; one point where there is nothing to choose."""
    middle = tuple(side.middle for side in region)
    return [middle, *(_inner_corners(region) if region else ())]


def _inner_corners(region: Box) -> list[BoxPoint]:
    """The corners, moved inward by 2⁻³² of the sides: an excluded edge yields no witness."""
    inset = fmpq(1, 2**32)
    return list(product(*((x.low + x.width * inset, x.high - x.width * inset) for x in region)))


def _relative(here: Box, whole: Box, axis: int) -> fmpq:
    """The length of a side as a part of the whole one."""
    side = whole[axis].width
    return here[axis].width / side if side else fmpq(0)


def _longest(here: Box, whole: Box) -> int:
    """The axis along which ``here`` is longest relative to ``whole``."""
    return max(range(len(here)), key=lambda axis: _relative(here, whole, axis))


def _slopes(function: Margin, here: Box) -> tuple[arb, ...]:
    """Enclosures of the partial derivatives over the box."""
    return function(*coordinates(_sides(here)), gradients).slopes


def _steepest(here: Box, whole: Box, slopes: tuple[arb, ...], longest: int) -> int:
    """The axis along which the function can vary most, of those not far shorter than the longest.

    The longest where the slopes are unknown: they may be large along one axis however short it is.
    """
    if not all(s.is_finite() for s in slopes):
        return longest
    least = _relative(here, whole, longest) / SLENDER
    long = [axis for axis in range(len(here)) if _relative(here, whole, axis) >= least]
    return max(
        long,
        key=lambda axis: float(abs(slopes[axis]).upper() * here[axis].width),
    )


def _extreme(function: Margin, here: Box, slopes: tuple[arb, ...], lowest: bool) -> arb:
    """A ball whose lower end bounds the function below on the box (upper end above, for highest).

    Coordinates in which the function is monotone move to the end that matters, which is exact; the
    others enter by the mean value theorem about their middle, f(m) + Σ ∂ᵢf(box)·(Xᵢ − mᵢ).
    """
    point, spread = [], arb(0)
    for side, slope in zip(here, slopes, strict=True):
        if slope >= 0:
            point.append(side.low if lowest else side.high)
        elif slope <= 0:
            point.append(side.high if lowest else side.low)
        else:
            point.append(side.middle)
            spread += slope * (side.ball() - arb(side.middle))
    return value_at(function, tuple(point)) + spread
