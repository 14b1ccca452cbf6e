"""Points at which the two sides may touch, and the sign of the difference beside them.

At a point of contact the difference and its first derivatives vanish. That they do is shown
exactly; the first derivative that does not has a sign, in balls, on a whole neighbourhood.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from flint import arb, fmpq

from tresym.arithmetic import ball_precision
from tresym.checking.domain import equal_at
from tresym.exact import InputError, Interval, simplest_between
from tresym.identity.evaluation import evaluate
from tresym.identity.expression import PI, ZERO, E, Expr, apply, differentiate, number, sqrt

PRECISION = 128
LARGEST_DENOMINATOR = 1_000
MAX_ORDER = 6
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
        with ball_precision(PRECISION):
            if evaluate(point, {}).overlaps(worst.ball()):
                seen.add(point)
                yield point
    for wider in (1, 2**12, 2**24):
        gap = wider * ((worst.high - worst.low) or fmpq(1, 2**40))
        low, high = worst.low - gap, worst.high + gap
        found = [number(simplest_between(low, high))]
        with ball_precision(PRECISION):
            for there, back in _KINDS:
                ends = there(arb(low)).lower(), there(arb(high)).upper()
                if not (ends[0].is_finite() and ends[1].is_finite() and ends[0] <= ends[1]):
                    continue
                r = simplest_between(*map(rational, ends))
                if r != 0 and max(abs(r.p), r.q) < LARGEST_DENOMINATOR:
                    found.append(back(number(r)))
        for point in found:
            if point not in seen:
                seen.add(point)
                yield point


def sign_at_contact(e: Expr, name: str, point: Expr, side: int) -> tuple[int, fmpq] | None:
    """The sign of ``e`` beside a point where it vanishes, by its first derivative that does not.

    Returns:
        The sign and r: it holds for 0 < side·(x − point) ≤ r. None where a derivative is neither
        shown to be zero nor seen to differ from it, or ``e`` is not smooth there.
    """
    derivatives = [e]
    with ball_precision(PRECISION):
        at = evaluate(point, {})
        for order in range(MAX_ORDER + 1):
            value = evaluate(derivatives[-1], {name: at})
            if not value.is_finite():
                return None
            if not value.contains(0):
                return _reach(derivatives, name, at, side, order)
            try:
                if not equal_at(derivatives[-1], ZERO, {name: point}):
                    return None
                derivatives.append(differentiate(derivatives[-1], name))
            except InputError:
                return None
            if derivatives[-1].size > MAX_SIZE:
                return None
    return None


def _reach(
    derivatives: list[Expr], name: str, at: arb, side: int, order: int
) -> tuple[int, fmpq] | None:
    """How far the last of the derivatives keeps its sign, all of them being finite there."""
    for reach in REACHES:
        hull = {name: at.union(at + side * arb(reach))}
        last = evaluate(derivatives[-1], hull)
        if (last > 0 or last < 0) and all(evaluate(d, hull).is_finite() for d in derivatives):
            return (1 if last > 0 else -1) * side**order, reach
    return None


def enclosure(point: Expr) -> tuple[fmpq, fmpq]:
    """Rationals on both sides of the constant, equal to it where it is rational."""
    if point.op == "number":
        return point.args[0], point.args[0]
    with ball_precision(2 * PRECISION):
        value = evaluate(point, {})
        return rational(value.lower()), rational(value.upper())


def rational(x: arb) -> fmpq:
    """The exact value of a ball of radius zero."""
    mantissa, exponent = x.man_exp()
    if exponent >= 0:
        return fmpq(mantissa * 2 ** int(exponent))
    return fmpq(mantissa, 2 ** int(-exponent))
