"""Enclose the supremum of |f/g| on a range 0 < t ≤ r from both sides.

That f = O(g) as t → 0 is known when this is asked; what is sought is a constant worth quoting. The
range is divided into intervals. On those away from 0 the Taylor coefficients of f, with the
remainder of the last one in balls, enclose the ratio. On the interval that begins at 0 there are
two ways:

- If f and g are analytic at 0 and g vanishes there to order p, then so does f, since f = O(g). The
  ratio is the quotient of the Taylor polynomials after division by t^p, with their remainders.
- Otherwise the certified leading terms bound the ratio (leading_terms.py).

The interval with the largest upper bound is halved until that bound exceeds the largest value at a
point by at most one per cent. Example: (tanh t − t + t³/3)/t⁵ on 0 < t ≤ 1 has the supremum 2/15,
which it approaches as t → 0. If the range is too long for this, half of it is tried.
"""

from __future__ import annotations

import heapq
from collections.abc import Callable, Iterator, Mapping
from functools import partial
from itertools import count
from typing import Any, NamedTuple

from flint import arb, arb_series, ctx, fmpq

from tresym.reals.balls.gradient import horner
from tresym.reals.balls.taylor import InSeries, taylor_value
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.expansions.scale import T
from tresym.reals.language.expression import Expr
from tresym.reals.numbers.arithmetic import ball_precision

PRECISION = 320
MARGIN = arb("1.01")
PIECES = 120
"""The number of intervals that are bounded before a shorter range is tried."""
MOST = 360
"""The number of intervals on all ranges."""
TERMS = (8, 28)
AT_END = 40
"""Taylor coefficients of an explicit function that is analytic at the end."""
SHORTER = 7
"""How often the range is halved."""
NEAREST = fmpq(1, 2**40)
Near = Callable[[fmpq], "tuple[arb, arb] | None"]
"""Bounds of the supremum of the ratio on 0 < t ≤ r: a lower one, and an upper one."""


class Evaluation(NamedTuple):
    """How expressions are evaluated: the explicit ones, or also roots and integrals.

    Attributes:
        series: returns a walker that computes Taylor coefficients with these variables.
        value: encloses an expression.
        at_end: the number of Taylor coefficients at the end.
        terms: the numbers of Taylor coefficients on an interval that are tried.
    """

    series: Callable[[dict[str, Any]], Any]
    value: Callable[[Expr, Mapping[str, arb]], arb]
    at_end: int
    terms: tuple[int, ...]


class Supremum(NamedTuple):
    """The supremum of a ratio on 0 < t ≤ upto.

    Attributes:
        low, high: bounds of it; ``high`` is at most 1 % above ``low``.
        upto: the range.
        at: a point at which the ratio is at least ``low``; None if it is approached as t → 0.
    """

    low: arb
    high: arb
    upto: fmpq
    at: fmpq | None


EXPLICIT = Evaluation(partial(InSeries, None), evaluate, AT_END, TERMS)


def supremum(
    f: Expr,
    g: Expr,
    order: int | None,
    near: Near | None,
    upto: fmpq,
    shorter: int = SHORTER,
    how: Evaluation = EXPLICIT,
) -> Supremum | None:
    """Return the supremum of |f/g|, where f = O(g) as the variable ``T`` tends to 0 from above.

    Args:
        f, g: expressions in ``T``.
        order: the order to which g vanishes at 0, if that is a natural number.
        near: bounds near 0 where f or g is not analytic there.
        upto: the longest range.
        shorter: how often the range may be halved.
        how: how the expressions are evaluated.
    """
    ratio = f / g
    with ball_precision(PRECISION):
        germ = None if order is None else _germ(f, g, order, how)
        if germ is None and near is None:
            return None
        spent = count()
        for n in range(shorter + 1):
            found = _on(ratio, f, g, germ, near, upto / 2**n, spent, how)
            if found is not None:
                return found
    return None


def _germ(f: Expr, g: Expr, order: int, how: Evaluation) -> Near | None:
    """Return bounds of |f/g| on 0 < t ≤ r by Taylor coefficients at 0; None if f is not analytic.

    The coefficients of t^k for k < ``order`` are zero.
    """
    start = [_coefficients(e, arb(0), how) for e in (f, g)]
    if start[0] is None or start[1] is None or order >= len(start[1]):
        return None
    if start[1][order].contains(0):
        return None
    limit = abs(start[0][order] / start[1][order])

    def bounds(reach: fmpq) -> tuple[arb, arb] | None:
        x = _interval(fmpq(0), reach)
        parts = []
        for e, first in zip((f, g), start, strict=True):
            over = _coefficients(e, x, how)
            if over is None or first is None:
                return None
            parts.append(horner(first[order:-1], x, over[-1]))
        found = abs(parts[0] / parts[1])
        return (limit.lower(), found.upper()) if found.is_finite() else None

    return bounds


def _coefficients(e: Expr, x: arb, how: Evaluation) -> list[arb] | None:
    """Return the first Taylor coefficients over a ball; None if they are not finite."""
    before = ctx.cap
    ctx.cap = how.at_end + 1
    try:
        series = how.series({T: arb_series([x, 1], ctx.cap)}).value(e)
        if series.prec <= how.at_end:
            return None
        found = [series[j] for j in range(how.at_end + 1)]
    except (ValueError, ZeroDivisionError, AttributeError, TypeError):
        return None
    finally:
        ctx.cap = before
    return found if all(c.is_finite() for c in found) else None


def _on(
    ratio: Expr,
    f: Expr,
    g: Expr,
    germ: Near | None,
    near: Near | None,
    upto: fmpq,
    spent: Iterator[int],
    how: Evaluation,
) -> Supremum | None:
    """Return the supremum on one range, or None if too many intervals would be needed."""
    low, at = arb(0), None
    order = count()
    heap: list[tuple[float, int, arb, fmpq, fmpq]] = []

    def add(first: fmpq, last: fmpq) -> bool:
        nonlocal low, at
        if first == 0:
            found = None
            for bounds in (germ, near):
                found = found or (bounds(last) if bounds is not None else None)
            if found is None:
                return last > NEAREST and add(fmpq(0), last / 2) and add(last / 2, last)
            if found[0] > low:
                low, at = found[0], None
            high = found[1]
        else:
            high = _bound(ratio, f, g, first, last, low, how)
            if not high.is_finite():
                return last - first > last * fmpq(1, 2**8) and all(
                    add(*ends) for ends in _halves(first, last)
                )
        for point in (last, (first + last) / 2):
            here = abs(how.value(ratio, {T: arb(point)})).lower()
            if here > low:
                low, at = here, point
        heapq.heappush(heap, (-float(high.mid()), next(order), high, first, last))
        return next(made) < PIECES and next(spent) < MOST

    made = count()
    first = upto if how is EXPLICIT else _short_below(upto)
    if not (add(fmpq(0), first) and (first == upto or add(first, upto))):
        return None
    while True:
        _, _, high, first, last = heap[0]
        if high <= low * MARGIN or high.is_zero():
            top = max((part[2] for part in heap), key=lambda x: float(x.mid()))
            return Supremum(low, top.upper().max(low), upto, at)
        heapq.heappop(heap)
        if last < NEAREST or not all(add(*ends) for ends in _halves(first, last)):
            return None


def _short_below(x: fmpq) -> fmpq:
    """Return a binary fraction of few bits at most x and more than x/2.

    The ball from 0 to it has no negative points, as the ball from 0 to 1/3 has.
    """
    scale = fmpq(1)
    while x * scale < 2**8:
        scale *= 2
    return (x * scale).floor() / scale


def _interval(first: fmpq, last: fmpq) -> arb:
    """Return the ball of an interval, exact for binary fractions of few bits.

    FLINT rounds the radius of a union up, by which the ball from 0 to 1 has negative points.
    """
    middle, radius = (first + last) / 2, (last - first) / 2
    if any(int(x.q) & (int(x.q) - 1) for x in (middle, radius)):
        return arb(first).union(arb(last))
    return arb(_binary(middle), _binary(radius))


def _binary(x: fmpq) -> tuple[int, int]:
    return int(x.p), 1 - int(x.q).bit_length()


def _halves(first: fmpq, last: fmpq) -> tuple[tuple[fmpq, fmpq], tuple[fmpq, fmpq]]:
    middle = (first + last) / 2
    return (first, middle), (middle, last)


def _bound(
    ratio: Expr, f: Expr, g: Expr, first: fmpq, last: fmpq, low: arb, how: Evaluation
) -> arb:
    """Return an upper bound of |ratio| on an interval; not finite if there is none."""
    x = _interval(first, last)
    best = arb("inf")
    for terms in (0, *how.terms, -1):
        if terms == 0:
            value = how.value(ratio, {T: x})
        elif terms > 0:
            value = taylor_value(ratio, T, x, terms, how.series)
        else:
            value = taylor_value(f, T, x, how.terms[-1], how.series) / how.value(g, {T: x})
        if value.is_finite():
            best = best.min(abs(value).upper())
            if best <= low * MARGIN:
                break
    return best
