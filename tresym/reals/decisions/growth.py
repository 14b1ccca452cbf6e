"""Order claims by growth: the leading terms of both sides on one scale of functions.

All of it speaks of t → 0+. f = O(g), f = o(g) and f ~ g are read off the leading terms of f and g;
the range, and the constant of O, come from the same expansions with bounds. Where waves stand in a
leading coefficient, f and g are those of a sequence t → 0 on which a phase is 0, π/2, π, −π/2 or 1
modulo 2π, which a phase u → ±∞ is again and again: what fails there fails.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from itertools import product

from flint import arb, fmpq

from tresym.reals.balls.ends import sign_beside
from tresym.reals.balls.order import MOST_HALVINGS, Judgement, Order, judge_order
from tresym.reals.balls.run import formula
from tresym.reals.growth.rewritten import Rewritten
from tresym.reals.growth.scale import T, UnresolvedError
from tresym.reals.growth.series import Expansions
from tresym.reals.language.expression import (
    ONE,
    PI,
    ZERO,
    Expr,
    multiply,
    power,
    substitute,
    symbol,
)
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict

HALVINGS = (1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 128, 256, 512, 2048, 8192)
PHASES = (ZERO, PI / 2, PI, -PI / 2, ONE)

_OPEN = Judgement(Verdict.UNDECIDED)
_FAILS = (UnresolvedError, InputError, ZeroDivisionError, OverflowError)


def judged_by_expansion(
    kind: str,
    left: Expr,
    right: Expr,
    name: str,
    upto: fmpq = fmpq(1),  # noqa: B008
    halvings: int = MOST_HALVINGS,
) -> Judgement:
    """The order statement by expansions in powers of t or of 1/log(1/t) alone."""
    f, g = formula(left, name), formula(right, name)
    try:
        return judge_order(Order(kind, f, g, upto=upto), halvings=halvings)
    except (ZeroDivisionError, OverflowError, InputError):
        return _OPEN


def judged_by_growth(
    kind: str,
    left: Expr,
    right: Expr,
    name: str,
    upto: fmpq = fmpq(1),  # noqa: B008
) -> Judgement:
    """The order statement for ``name`` → 0+, on a range of at most ``upto``."""
    found = Rewritten(name)
    try:
        with ball_precision():
            f, g = found.of(left), found.of(right)
            truth = _truth(kind, f, g, found)
            if truth is None:
                truth = False if _fails_at_a_phase(kind, f, g, found) else None
            if truth:
                return _on_a_range(kind, f, g, found, upto)
    except _FAILS:
        return _OPEN
    return _OPEN if truth is None else Judgement(Verdict.REFUTED, points={"t": upto / 16})


def sign_towards(e: Expr, name: str, point: Expr | None, side: int) -> tuple[int, fmpq] | None:
    """As :func:`tresym.reals.balls.ends.sign_beside`, and by growth where that settles nothing."""
    beside = sign_beside(e, name, point, side)
    if beside is not None:
        return beside
    t = symbol(T)
    return sign_near(substitute(e, {name: side / t if point is None else point + side * t}), T)


def sign_near(e: Expr, name: str) -> tuple[int, fmpq] | None:
    """The sign of ``e`` for 0 < t ≤ r, and r."""
    found = Rewritten(name)
    with ball_precision():
        try:
            f = found.of(e)
            first = found.expansions.leading(f)
            sign = 0 if first is None else found.scale.sign(first.coefficient)
        except _FAILS:
            return None
        for expansions, reach in _ranges(found, fmpq(1)):
            with suppress(*_FAILS):
                if first is None or expansions.enclosure(f).low > 0:
                    return sign, reach
    return None


def _truth(kind: str, f: Expr, g: Expr, found: Rewritten) -> bool | None:
    """Whether the statement holds as t → 0; None where waves leave that open."""
    scale, leading = found.scale, found.expansions.leading
    first, second = leading(f), leading(g)
    if kind == "~":
        phases = first and second and scale.phases(first.coefficient + second.coefficient)
        if first is None or second is None or phases:
            return _truth("o", f - g, g, found)
        same = scale.compare(first.powers, second.powers) == 0
        return same and scale.sign(first.coefficient - second.coefficient) == 0
    if first is None:
        return True
    if second is None:
        return False
    growth = scale.compare(first.powers, second.powers)
    if not scale.ball(first.coefficient).is_finite():
        return None
    try:
        scale.sign(second.coefficient)
        if growth < 0 or (growth == 0 and kind == "O"):
            return True
        scale.sign(first.coefficient)
    except UnresolvedError:
        return None
    return False


def _fails_at_a_phase(kind: str, f: Expr, g: Expr, found: Rewritten) -> bool:
    """Whether the statement fails on a sequence on which one of the phases is known.

    The others are not: two need not be what one likes at once. Both sides are multiplied by their
    denominators: what is bounded beside a point is so there.
    """
    (f, above), (g, below) = _over(f), _over(g)
    f, g = multiply(f, below), multiply(g, above)
    for name, phase in product(found.scale.phases(f + g), PHASES):
        x, y = (substitute(e, {name: phase}) for e in (f, g))
        with suppress(*_FAILS):
            if _truth(kind, x, y, found) is False:
                return True
    return False


def _over(e: Expr) -> tuple[Expr, Expr]:
    """Numerator and denominator of a product."""
    parts = e.args if e.op == "*" else (e,)
    negative = [
        x for x in parts if x.op == "^" and x.args[1].op == "number" and x.args[1].args[0] < 0
    ]
    denominators = (power(x.args[0], -x.args[1]) for x in negative)
    return multiply(*(x for x in parts if x not in negative)), multiply(*denominators)


def _on_a_range(kind: str, f: Expr, g: Expr, found: Rewritten, upto: fmpq) -> Judgement:
    """What holds as t → 0, with a range, and for O a constant."""
    vanishes = found.expansions.leading(f) is None
    for expansions, reach in _ranges(found, upto):
        try:
            below = expansions.enclosure(g)
            if vanishes:
                expansions.size(f)
                constant = arb(0)
            else:
                above = expansions.enclosure(f)
                ratio = found.scale.times(above.powers, below.powers, -1)
                high = above.high / below.low
                low = above.k / below.k if not ratio else arb(0)
                high = high * expansions.largest(ratio) if kind == "O" else high
                constant = arb(low.abs_lower()).union(arb(high.upper()))
        except _FAILS:
            continue
        if below.low > 0 and constant.is_finite():
            return Judgement(
                Verdict.ENCLOSED,
                constant=constant if kind == "O" else None,
                upto=reach,
                real=found.real,
            )
    return _OPEN


def _ranges(found: Rewritten, upto: fmpq) -> Iterator[tuple[Expansions, fmpq]]:
    """Shorter and shorter ranges on which the rewritten functions stand for those given."""
    for n in HALVINGS:
        reach = fmpq(1, 2**n)
        if reach > upto:
            continue
        expansions = Expansions(found.scale, reach)
        try:
            if all(expansions.enclosure(u).low > 0 for u in found.signed):
                yield expansions, reach
        except _FAILS:
            continue
