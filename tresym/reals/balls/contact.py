"""The first derivative that does not vanish at a point: signs and orders of smooth functions there.

Whether a derivative vanishes at the point is shown exactly, so that constants such as √2 are no
obstacle; the first that does not has a sign, in balls, on a whole neighbourhood. By Taylor's
theorem it gives the sign of a function beside a point where it touches 0, and the order of one
function against another: f = f⁽ᵐ⁾(ξ) tᵐ/m! and g = g⁽ⁿ⁾(η) tⁿ/n! on the whole range.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from math import factorial
from typing import NamedTuple

from flint import arb, fmpq

from tresym.reals.balls.order import Judgement, Size
from tresym.reals.language.expression import PI, ZERO, E, Expr, apply, differentiate, number, sqrt
from tresym.reals.normal.at_point import equal_at
from tresym.reals.numbers.arithmetic import WORKING, ball_precision
from tresym.reals.numbers.exact import InputError, Interval, rational_ends
from tresym.reals.places.values import evaluate
from tresym.reals.verdict import Verdict

LARGEST_DENOMINATOR = 1_000
MAX_ORDER = 8
MAX_SIZE = 3_000
REACHES = tuple(fmpq(1, 4**k) for k in range(12))

_KINDS: tuple[tuple[Callable[[arb], arb], Callable[[Expr], Expr]], ...] = (
    (lambda x: x / arb.pi(), lambda r: r * PI),
    (lambda x: x / arb(1).exp(), lambda r: r * E),
    (lambda x: x * arb(1).exp(), lambda r: r / E),
    (lambda x: x * abs(x), lambda r: sqrt(r) if r.args[0] > 0 else -sqrt(-r)),
    (lambda x: x.exp(), lambda r: apply("log", r)),
    (lambda x: x.log(), lambda r: apply("exp", r)),
    (lambda x: x.tan(), lambda r: apply("atan", r)),
)
"""Maps of the line under which a point may be a simple rational, with their inverses."""


def candidates(worst: Interval, known: Sequence[Expr] = ()) -> Iterator[Expr]:
    """Exact points that ``worst`` suggests, the simplest of each kind, and those that are known."""
    seen: set[Expr] = set()
    for point in known:
        with ball_precision():
            if evaluate(point, {}).overlaps(worst.ball()):
                seen.add(point)
                yield point
    for wider in (1, 2**12, 2**24):
        gap = wider * (worst.width or fmpq(1, 2**40))
        about = Interval(worst.low - gap, worst.high + gap)
        found = [number(about.simplest())]
        with ball_precision():
            for there, back in _KINDS:
                low = rational_ends(there(arb(about.low))).low
                high = rational_ends(there(arb(about.high))).high
                if low is None or high is None or low > high:
                    continue
                r = Interval(low, high).simplest()
                if r != 0 and max(abs(r.p), r.q) < LARGEST_DENOMINATOR:
                    found.append(back(number(r)))
        for point in found:
            if point not in seen:
                seen.add(point)
                yield point


class _Leading(NamedTuple):
    """The first derivative that does not vanish, and all below it."""

    order: int
    derivatives: list[Expr]

    @property
    def last(self) -> Expr:
        """The derivative itself."""
        return self.derivatives[-1]


def sign_at_contact(e: Expr, name: str, point: Expr, side: int) -> tuple[int, fmpq] | None:
    """The sign of ``e`` beside a point where it vanishes, by its first derivative that does not.

    Returns:
        The sign and r: it holds for 0 < side·(x − point) ≤ r. None where a derivative is neither
        shown to be zero nor seen to differ from it, or ``e`` is not smooth there.
    """
    first = _leading(e, name, point)
    return None if first is None else _reach(first, name, point, side)


def _reach(first: _Leading, name: str, point: Expr, side: int) -> tuple[int, fmpq] | None:
    """How far the last of the derivatives keeps its sign, all of them being finite there."""
    with ball_precision():
        at = evaluate(point, {})
        for reach in REACHES:
            hull = {name: at.union(at + side * arb(reach))}
            last = evaluate(first.last, hull)
            finite = all(evaluate(d, hull).is_finite() for d in first.derivatives)
            if (last > 0 or last < 0) and finite:
                return (1 if last > 0 else -1) * side**first.order, reach
    return None


def decide_smooth(
    kind: str, left: Expr, right: Expr, name: str, point: Expr, side: int
) -> Judgement:
    """O, o or ~ from one side of ``point``; UNDECIDED where the functions are not smooth there."""
    f, g = _leading(left, name, point), _leading(right, name, point)
    if f is None or g is None:
        return Judgement(Verdict.UNDECIDED)
    with ball_precision():
        at = evaluate(point, {})
        top = evaluate(f.last, {name: at}) * side**f.order / factorial(f.order)
        bottom = evaluate(g.last, {name: at}) * side**g.order / factorial(g.order)
        power = f.order - g.order
        sizes = Size(top / bottom, fmpq(power)), Size(top, fmpq(f.order))
        holds = {"O": power >= 0, "o": power > 0, "~": power == 0}[kind]
        if kind == "~" and holds:
            holds = equal_at(f.last, g.last, {name: point})
            if not holds and (top / bottom).contains(1):
                return Judgement(Verdict.UNDECIDED)
        for reach in REACHES:
            hull = at.union(at + side * arb(reach))
            if not all(
                evaluate(d, {name: hull}).is_finite() for d in f.derivatives + g.derivatives
            ):
                continue
            whole = [evaluate(x.last, {name: hull}) / factorial(x.order) for x in (f, g)]
            if whole[1].contains(0):
                continue
            if not holds:
                return Judgement(Verdict.REFUTED, *sizes, points={"t": reach / 16})
            constant = None
            if kind == "O":
                upper = (abs(whole[0]) / abs(whole[1])).upper() * arb(reach) ** power
                lower = abs(top / bottom).lower() if power == 0 else arb(0)
                constant = lower.union(upper)
            return Judgement(Verdict.ENCLOSED, *sizes, constant=constant, upto=reach)
    return Judgement(Verdict.UNDECIDED)


def _leading(e: Expr, name: str, point: Expr) -> _Leading | None:
    derivatives = [e]
    with ball_precision():
        at = evaluate(point, {})
        for order in range(MAX_ORDER + 1):
            value = evaluate(derivatives[-1], {name: at})
            if not value.is_finite():
                return None
            if not value.contains(0):
                return _Leading(order, derivatives)
            try:
                if not equal_at(derivatives[-1], ZERO, {name: point}):
                    return None
                derivatives.append(differentiate(derivatives[-1], name))
            except InputError:
                return None
            if derivatives[-1].size > MAX_SIZE:
                return None
    return None


def enclosure(point: Expr) -> tuple[fmpq, fmpq]:
    """Rationals on both sides of the constant, equal to it where it is rational."""
    if point.op == "number":
        return point.args[0], point.args[0]
    with ball_precision(2 * WORKING):
        value = evaluate(point, {})
        return value.lower().fmpq(), value.upper().fmpq()
