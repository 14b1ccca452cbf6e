"""Decide inequalities on boxes by branch and bound in ball arithmetic.

A *margin* is a plain function of balls (its last argument is the arithmetic) that is positive on a
box with rational sides if the claim holds. The search bisects the box until each part is closed. A
part is closed if the ball of the margin over it is positive, or if its mean-value form is, with the
coordinates in which it is monotone set to their lower side. The result is a :class:`BoxProof`: a
bisection tree that can be stored, checked again without a search, and found anew.

Unbounded regions are mapped to boxes by charts (with a coordinate 1/a, for example), so that
infinity becomes an edge. The margin must be positive on the closed box. Where it tends to 0 at an
edge, the search cannot succeed, and the vanishing factor must be divided out first.

Example: the margin 2 − x² − y on the box [0, 1] × [0, 1/2]. Its ball over the whole box is about
[1/2, 2], so that one box proves x² + y < 2 there; on [0, 1] × [0, 1] it reaches 0, and the
inequality is closed only off the corner (1, 1).

Source: R. E. Moore, R. B. Kearfott, M. J. Cloud, *Introduction to Interval Analysis*, SIAM 2009,
chapters 5 and 6 (mean-value form, monotonicity test, subdivision).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
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
"""The search stops at a box of this relative size, since the margin probably touches zero there."""


FINE = 512
"""The precision in bits at which a margin must differ at two points, as it may be nearly flat."""
SLENDER = 2**8
"""The maximal ratio of the relative lengths of two sides of a box."""


class CertificateError(ValueError):
    """Raised for a stored box proof that is malformed or does not prove its bound."""


def box(*sides: tuple[Any, Any]) -> Box:
    """Return the box with these sides.

    Args:
        sides: pairs of exact ends (text, integers or fractions).

    Raises:
        ValueError: the lower end of a side is above its upper end.

    Example:
        >>> box((0, "1/2"))[0].middle
        1/4
    """
    made = tuple(Interval(as_rational(low), as_rational(high)) for low, high in sides)
    if any(side.low > side.high for side in made):
        raise ValueError("a side of the box has its lower end above its upper end; swap the ends")
    return made


@dataclass(frozen=True)
class Bound:
    """The statement ``margin(x₁, …, x_n, m) > 0`` for every point of ``box``.

    Attributes:
        margin: a function of n balls and the arithmetic.
        box: the closed box.
        slopes: whether mean-value forms are also tried; the margin must then accept gradients.
        precision: the working precision in bits.
        sufficient: whether a positive margin is only sufficient for the claim. A point with a
            negative margin then refutes nothing, and the search ends undecided.
    """

    margin: Margin
    box: Box
    slopes: bool = False
    precision: int = 64
    sufficient: bool = False


@dataclass(frozen=True)
class BoxProof:
    """A bisection tree in prefix order, with one letter per node.

    The letters ``x``, ``y``, ``z`` and ``w`` bisect the box along that axis. The letter ``b``
    closes it because the ball of the margin is positive, and ``m`` because the mean-value form is.
    """

    tree: str
    verdict: ClassVar = Verdict.ENCLOSED

    @property
    def leaves(self) -> int:
        """Return the number of closed boxes."""
        return self.tree.count(BY_BALL) + self.tree.count(BY_SLOPES)


@dataclass(frozen=True)
class Counterexample:
    """A rational point at which the ball of the margin is negative."""

    point: BoxPoint
    value: arb
    verdict: ClassVar = Verdict.REFUTED


@dataclass(frozen=True)
class Open:
    """No result, for lack of budget or of a sharper margin; ``worst`` is a box left unclosed."""

    worst: Box
    verdict: ClassVar = Verdict.UNDECIDED


def inconsistent(function: Margin, region: Box, slopes: bool = False) -> str | None:
    """Return why ``function`` is not a valid margin, or None if no fault is found.

    The function must not be constant, and its ball over a small box must contain its values at
    points of the box. A function that compares floats, drops radii or depends on the types of its
    arguments fails this test.

    Args:
        function: the margin.
        region: the box.
        slopes: whether the derivatives are tested as well.
    """
    start = tuple(side.middle for side in region)
    end = tuple((side.low + 3 * side.high) / 4 for side in region)
    near = tuple(p + (q - p) / (32 + n) for n, (p, q) in enumerate(zip(start, end, strict=True)))
    here = tuple(Interval(p, q) for p, q in zip(start, near, strict=True))
    values = [value_at(function, start), value_at(function, near), function(*_sides(here), balls)]
    if not all(isinstance(v, arb) for v in values):
        return "the formula does not return a ball"
    if start == near or not all(v.is_finite() for v in values):
        return None
    first, second, whole = values
    if first.mid() == second.mid():
        with ball_precision(FINE):
            if value_at(function, start).mid() == value_at(function, near).mid():
                return "the formula does not depend on its coordinates"
    if not (whole.overlaps(first) and whole.overlaps(second)):
        return "the ball of the formula over a box does not contain its values at points of the box"
    if slopes:
        rates = _slopes(function, here)
        steps = [rate * arb(q - p) for rate, p, q in zip(rates, start, near, strict=True)]
        if not (second - first).overlaps(sum(steps, arb(0))):
            return "the derivatives of the formula do not agree with its values"
    return None


def decide_bound(
    bound: Bound, budget: int = 20_000, stored: BoxProof | None = None
) -> BoxProof | Counterexample | Open:
    """Return a proof of the bound, a point that refutes it, or neither.

    Every proof that is returned has been checked, whether it was stored or found; boxes that the
    search has just closed are not evaluated again.

    Args:
        bound: the statement.
        budget: the maximal number of boxes that are examined.
        stored: a proof found earlier, which is checked instead of searching.

    Raises:
        CertificateError: ``stored``, or the result of the search, does not pass the check.
    """
    closed: list[tuple[Box, str]] = []
    outcome = stored or _found(bound, budget, closed)
    if isinstance(outcome, BoxProof):
        recheck(bound, outcome, closed)
    elif isinstance(outcome, Counterexample):
        with ball_precision(bound.precision):
            inside = all(s.holds(x) for s, x in zip(bound.box, outcome.point, strict=True))
            if not (inside and value_at(bound.margin, outcome.point) < 0):
                raise CertificateError(
                    "the margin is not negative at the counterexample that was found"
                )
    return outcome


def _found(
    bound: Bound, budget: int, closed: list[tuple[Box, str]]
) -> BoxProof | Counterexample | Open:
    with ball_precision(bound.precision):
        for point in _inner_corners(bound.box):
            value = value_at(bound.margin, point)
            if value < 0:
                return _negative(bound, point, value)
        return _search(bound, budget, closed)


def _negative(bound: Bound, point: BoxPoint, value: arb) -> Counterexample | Open:
    """Return what a point with a negative margin shows; nothing if the margin only suffices."""
    if bound.sufficient:
        return Open(tuple(Interval(x, x) for x in point))
    return Counterexample(point, value)


def _search(
    bound: Bound, budget: int, closed: list[tuple[Box, str]]
) -> BoxProof | Counterexample | Open:
    """Bisect the box until every part is closed, and add the closed ones to ``closed``."""
    tree: list[str] = []
    stack = [bound.box]
    for _ in range(budget):
        if not stack:
            return BoxProof("".join(tree))
        here = stack.pop()
        if bound.margin(*_sides(here), balls) > 0:
            tree.append(BY_BALL)
            closed.append((here, BY_BALL))
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
                closed.append((here, BY_SLOPES))
                continue
            axis = _steepest(here, bound.box, slopes, axis)
        tree.append(AXES[axis])
        stack.extend(reversed(halves(here, axis)))
    return Open(stack[-1]) if stack else BoxProof("".join(tree))


def recheck(bound: Bound, proof: BoxProof, closed: Iterable[tuple[Box, str]] = ()) -> None:
    """Check a stored proof: replay the tree and close every box again, without a search.

    Args:
        bound: the statement.
        proof: the tree.
        closed: boxes with their marks that a search has just closed, in the order of the tree.

    Raises:
        CertificateError: the tree is malformed, or a box does not close.
    """
    known = iter(closed)
    with ball_precision(bound.precision):
        for here, mark in leaf_boxes(bound.box, proof):
            if (here, mark) == next(known, None):
                continue
            if mark == BY_BALL:
                closed = bound.margin(*_sides(here), balls) > 0
            else:
                slopes = _slopes(bound.margin, here)
                closed = _extreme(bound.margin, here, slopes, lowest=True) > 0
            if not closed:
                raise CertificateError(f"the box {_shown(here)} does not close")


def leaf_boxes(region: Box, proof: BoxProof) -> Iterator[tuple[Box, str]]:
    """Yield the boxes that a proof closes, which together form the region, and their marks.

    Raises:
        CertificateError: the tree is malformed.
    """
    if not isinstance(proof.tree, str):
        raise CertificateError("the bisection tree is not a string")
    stack = [region]
    for mark in proof.tree:
        if not stack:
            raise CertificateError("the bisection tree continues after its last box")
        here = stack.pop()
        if mark in (BY_BALL, BY_SLOPES):
            yield here, mark
        elif mark in AXES[: len(here)]:
            stack.extend(reversed(halves(here, AXES.index(mark))))
        else:
            raise CertificateError(f"unknown mark {mark!r} in the tree")
    if stack:
        raise CertificateError("the bisection tree ends before its last box")


def value_at(function: Margin, point: BoxPoint) -> arb:
    """Return the ball of the function at a rational point, at working precision."""
    return function(*(arb(x) for x in point), balls)


def halves(here: Box, axis: int) -> tuple[Box, Box]:
    """Return the two halves of the box along ``axis``."""
    side, before, after = here[axis], here[:axis], here[axis + 1 :]
    lower, upper = side._replace(high=side.middle), side._replace(low=side.middle)
    return (*before, lower, *after), (*before, upper, *after)


def _sides(here: Box) -> tuple[arb, ...]:
    return tuple(side.ball() for side in here)


def _shown(here: Box) -> str:
    return " x ".join(f"[{fraction_text(x.low)}, {fraction_text(x.high)}]" for x in here)


def inner_points(region: Box) -> list[BoxPoint]:
    """Return the middle and points next to the corners; one point if the box has no sides."""
    middle = tuple(side.middle for side in region)
    return [middle, *(_inner_corners(region) if region else ())]


def _inner_corners(region: Box) -> list[BoxPoint]:
    """Return the corners, moved inward by 2⁻³² of the sides, as an edge may be excluded."""
    inset = fmpq(1, 2**32)
    return list(product(*((x.low + x.width * inset, x.high - x.width * inset) for x in region)))


def _relative(here: Box, whole: Box, axis: int) -> fmpq:
    """Return the length of a side relative to the side of ``whole``."""
    side = whole[axis].width
    return here[axis].width / side if side else fmpq(0)


def _longest(here: Box, whole: Box) -> int:
    """Return the axis along which ``here`` is longest relative to ``whole``."""
    return max(range(len(here)), key=lambda axis: _relative(here, whole, axis))


def _slopes(function: Margin, here: Box) -> tuple[arb, ...]:
    """Return enclosures of the partial derivatives over the box."""
    return function(*coordinates(_sides(here)), gradients).slopes


def _steepest(here: Box, whole: Box, slopes: tuple[arb, ...], longest: int) -> int:
    """Return the axis along which the function varies most, among those not much too short.

    If the slopes are unknown, the longest axis is returned, since any axis may have a large slope.
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
    """Return a ball whose lower end is a lower bound of the function on the box.

    With ``lowest`` false, the upper end is an upper bound. Coordinates in which the function is
    monotone are set to the end that matters. For the others, the mean value theorem about their
    middle is used: f(m) + Σ ∂ᵢf(box)·(Xᵢ − mᵢ).
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
