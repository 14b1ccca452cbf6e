"""Enclose the largest value of |f| on an interval from both sides, for any function in balls.

The function is a quotient f = u/v of expressions in one variable. On a piece [m − h, m + h] it is
a polynomial of degree about 40 and a small remainder:

- Where FLINT evaluates f in complex balls, it is found from values on a circle
  (:mod:`tresym.reals.balls.circle`).
- Otherwise its coefficients are Taylor coefficients in power series, with Lagrange's remainder;
  so it is for roots of equations and integrals with a parameter.

The polynomials are bisected, the piece with the largest bound first, until that bound is within
the tolerance of the value at a point. At a common zero of u and v the polynomials of both are
divided by the power that vanishes, whose coefficients are proved to be 0. At an end where neither
works, such as that of √(1 − x) or infinity, certified leading terms bound |f| beside it.

Example: |sin x − x + x³/6| on [0, 1] is largest at 1, where it is 0.00813765….
"""

from __future__ import annotations

import heapq
from collections.abc import Callable
from contextlib import suppress
from functools import partial
from itertools import count, pairwise
from math import lcm
from typing import Any, NamedTuple

from flint import arb, arb_poly, arb_series, ctx, fmpq

from tresym.reals.balls.circle import on_a_circle
from tresym.reals.balls.taylor import InSeries
from tresym.reals.domain.compiled import Compiled
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import UndefinedError, evaluate
from tresym.reals.domain.operation_domains import operations
from tresym.reals.expansions.leading_terms import is_unbounded, near_end, written_term
from tresym.reals.expansions.scale import T
from tresym.reals.expansions.suprema import Near
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import ONE, ZERO, Expr, number, substitute, symbol, symbols
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError, near
from tresym.reals.signs.interior import is_zero

PRECISIONS = (192, 640)
TERMS = (40, 96)
"""The number of coefficients of a polynomial."""
SHORT = 10
"""The same in power series."""
PIECES = 8
MOST = 1500
"""How many polynomials are computed at most."""
STEPS = 20_000
"""How many pieces are bounded at most."""
HALVINGS = 120
"""How often a piece is halved at most."""
SLIVER = 100
"""An end such as π is replaced by a rational number that is about 2^−100 away."""
BESIDE = 6
"""How often a piece beside an end is halved before leading terms are asked."""
FAR = 8
DOUBLINGS = 24
"""How often a finite part of an unbounded interval is doubled."""
LEVELS = 12
"""How many terms are taken beside an infinite end; pieces beside a finite one become short."""
HIGHEST = 12
"""The highest order of a common zero."""
SAMPLES = 64
"""Where changes of sign of a denominator are looked for."""

JUMPS = frozenset(("sign", "atan2"))
"""Functions with a value where they are not continuous."""
Value = Callable[[Expr, dict[str, arb]], arb]
Walks = Callable[[dict[str, Any]], Any]


class Maximum(NamedTuple):
    """The largest value of |f| on an interval, or its supremum.

    Attributes:
        low, high: bounds of it; ``high`` is infinite where |f| is not bounded, or not shown to be.
        at: a point at which |f| is at least ``low``; None if it is approached at an end.
        unbounded: whether |f| is proved to be unbounded, beside ``at`` or at an infinite end.
    """

    low: arb
    high: arb
    at: fmpq | None
    unbounded: bool = False

    def within(self, tolerance: fmpq) -> bool:
        """Return whether the bounds differ by at most a part of the value."""
        return bool(self.high <= self.low * (1 + arb(tolerance)))


class Evaluations(NamedTuple):
    """How an expression is evaluated where it is not compiled: as a value, and in power series."""

    value: Value
    series: Walks


EXPLICIT = Evaluations(evaluate, partial(InSeries, None))
PART = fmpq(1, 200)


def largest(
    above: Expr,
    below: Expr,
    name: str,
    low: fmpq | None,
    high: fmpq | None,
    tolerance: fmpq = PART,
    how: Evaluations = EXPLICIT,
    known: Expr | None = None,
) -> Maximum:
    """Return the largest value of |above/below| on an interval.

    Args:
        above, below: expressions in the variable ``name`` alone.
        low, high: the ends; None for infinity.
        tolerance: by how much the bounds may differ, relative to the value; they differ by more
            where the search does not end.
        how: how the expressions are evaluated.
        known: a point at which above = O(below) is known, though not that coefficients vanish.
    """
    found = None
    for precision in PRECISIONS:
        with ball_precision(precision):
            search = _Search(above, below, name, tolerance, how)
            search.known = known
            one = search.over(low, high)
        if found is None or one.high < found.high or not found.high.is_finite():
            found = one
        if found.within(tolerance) or found.unbounded:
            break
    assert found is not None
    return found


def exact_ends(
    above: Expr,
    below: Expr,
    name: str,
    low: Expr | None,
    high: Expr | None,
    tolerance: fmpq = PART,
    how: Evaluations = EXPLICIT,
    known: Expr | None = None,
) -> Maximum:
    """Return the largest value of |above/below| on an interval with ends such as π/2."""
    ends = [end for end in (low, high) if end is not None]
    if all(end.op == "number" for end in ends):
        first, last = (None if end is None else end.args[0] for end in (low, high))
        return largest(above, below, name, first, last, tolerance, how, known)
    found = _beside_exact_ends(above, below, name, low, high, tolerance, how)
    if found is not None:
        return found
    first, last = (None if end is None else ZERO for end in (low, high))  # something is singular
    if low is not None and high is not None:
        put, last = low + (high - low) * symbol(name), ONE
    else:
        put = ends[0] + symbol(name)
    u, v = (substitute(e, {name: put}) for e in (above, below))
    found = exact_ends(u, v, name, first, last, tolerance, how)
    if found.at is not None:
        with ball_precision():
            found = found._replace(at=evaluate(put, {name: arb(found.at)}).mid().fmpq())
    return found


def _beside_exact_ends(
    above: Expr,
    below: Expr,
    name: str,
    low: Expr | None,
    high: Expr | None,
    tolerance: fmpq,
    how: Evaluations,
) -> Maximum | None:
    """Return the largest ratio between rational numbers very close to the ends, and on the rest.

    The rest is bounded in balls. None if it has no bound there, as where something is singular.
    """
    inner: list[fmpq | None] = []
    rest: list[tuple[arb, ...]] = []
    with ball_precision(PRECISIONS[0]):
        for side, end in ((1, low), (-1, high)):
            if end is None or end.op == "number":
                inner.append(None if end is None else end.args[0])
                continue
            exact = evaluate(end, {})
            if not exact.is_finite():
                return None
            scaled = (exact * arb(2) ** SLIVER).mid().fmpq()
            inner.append((scaled.floor() + 2 * side) / fmpq(2) ** SLIVER)
            over = (exact, exact.union(arb(inner[-1])))
            rest.append(tuple(abs(how.value(above / below, {name: x})) for x in over))
    if not all(value.is_finite() for pair in rest for value in pair):
        return None
    found = largest(above, below, name, inner[0], inner[1], tolerance, how)
    if not found.unbounded:
        for at_end, over_rest in rest:
            if at_end.lower() > found.low:
                found = found._replace(low=at_end.lower(), at=None)
            found = found._replace(high=found.high.max(over_rest.upper()))
    return found


class _Piece(NamedTuple):
    """A part of the interval: f is ``series(s)`` ± ``rest`` at middle + s·half for |s| ≤ 1."""

    middle: fmpq
    half: fmpq
    series: arb_poly | None
    rest: arb

    def halves(self) -> list[_Piece]:
        """Return both halves."""
        quarter = self.half / 2
        return [
            _Piece(
                self.middle + side * quarter,
                quarter,
                None if self.series is None else self.series(arb_poly([side * HALF, HALF])),
                self.rest,
            )
            for side in (-1, 1)
        ]

    def bound(self) -> tuple[arb, fmpq, float]:
        """Return an upper bound of |f|, a point at which it is large, and about its value there."""
        assert self.series is not None
        c = [self.series[k] for k in range(max(3, self.series.length()))]
        tail = sum((abs(x) for x in c[3:]), self.rest)
        ends = [(fmpq(side), c[0] + side * c[1] + c[2]) for side in (-1, 1)]
        if not abs(c[1]) > 2 * abs(c[2]):
            top = abs(c[0]) + abs(c[1]) + abs(c[2])
            if not c[2].contains(0):
                s = -c[1] / (2 * c[2])
                ends.append((_short(s), c[0] + c[1] * s / 2))
                top = arb(0)
        else:
            top = arb(0)
        for _, value in ends:
            top = top.max(abs(value).upper())
        s, best = max(ends, key=lambda one: abs(float(one[1].mid())))
        s = max(min(s, fmpq(1)), fmpq(-1))
        return (top + tail).upper(), self.middle + self.half * s, abs(float(best.mid()))


HALF = arb(1) / 2


class _Search:
    """The search on one interval, at one precision."""

    def __init__(
        self, above: Expr, below: Expr, name: str, tolerance: fmpq, how: Evaluations
    ) -> None:
        self.above, self.below, self.name = above, below, name
        self.ratio, self.how = above / below, how
        self.factor, self.part = 1 + arb(tolerance), arb(tolerance) / 4
        self.compiled = {e: _compiled(e, name) for e in (self.ratio, above, below)}
        self.low = arb(0)
        self.at: fmpq | None = None
        self.jumps = any(node.op in JUMPS for node in operations((above, below)))
        self.beyond = arb(0)
        """A bound beside infinite ends."""
        self.heap: list[tuple[float, int, arb, _Piece]] = []
        self.order, self.steps, self.made = count(), 0, 0
        self.ends: dict[tuple[fmpq | None, int], _AtEnd] = {}
        self.zeros: dict[fmpq, int] = {}
        self.known: Expr | None = None
        self.plain = False
        """Whether leading terms are not asked."""
        self.asked: dict[tuple[fmpq, int], fmpq] = {}
        self.kinks: set[fmpq] = set()
        """Where the denominator may vanish without a derivative, besides the ends."""

    def over(self, low: fmpq | None, high: fmpq | None) -> Maximum:
        """Return the largest value on an interval with finite or infinite ends."""
        if low is not None and low == high:
            value = abs(self._value(arb(low)))
            return Maximum(value.lower(), value.upper(), low)
        for side, end in ((-1, low), (1, high)):
            if end is None and not self._end(None, side).known:
                unbounded = is_unbounded(self.above, self.below, self.name, None, side)
                return Maximum(self.low, arb("inf"), None, unbounded)
        first = low if low is not None else min(-FAR, (high or 0) - FAR)
        last = high if high is not None else max(FAR, (low or 0) + FAR)
        self.finite = fmpq(first), fmpq(last)
        pole = self._find_zeros(*self.finite, low, high)
        if pole is not None:
            return Maximum(self.low, arb("inf"), pole, True)
        inner = sorted({*self.finite, *(x for x in {*self.zeros, *self.kinks} if first < x < last)})
        for start, stop in pairwise(inner):
            self._fill(start, stop)
        self._close()
        for side, end in ((-1, low), (1, high)):
            if end is None and not self._to_infinity(side):
                self.beyond = arb("inf")
        self._close()
        if not self.heap[0][2].is_finite():
            for side, x in zip((1, -1), self.finite, strict=True):
                if is_unbounded(self.above, self.below, self.name, number(x), side):
                    return Maximum(self.low, arb("inf"), x, True)
        top = max((one[2] for one in self.heap), key=lambda x: float(x.mid()), default=arb(0))
        return Maximum(self.low, top.max(self.beyond).upper().max(self.low), self.at)

    def _fill(self, start: fmpq, stop: fmpq) -> None:
        step = (stop - start) / (2 * PIECES)
        for k in range(PIECES):
            self._add(_Piece(start + (2 * k + 1) * step, step, None, arb(0)))

    def _close(self) -> None:
        """Halve the piece with the largest bound until it is close to a value."""
        smallest = (self.finite[1] - self.finite[0]) / 2**HALVINGS
        while self.heap:
            high, piece = self.heap[0][2:]
            if high <= self.low * self.factor or high <= arb(2) ** (-ctx.prec // 2):
                return
            if self.steps > STEPS or self.made > MOST or piece.half < smallest:
                return
            heapq.heappop(self.heap)
            for half in piece.halves():
                keeps = piece.series is not None and piece.rest <= self.low * self.part
                self._add(half if keeps else half._replace(series=None))

    def _add(self, piece: _Piece) -> None:
        """Bound |f| on a piece, by a new polynomial if it has none."""
        self.steps += 1
        if piece.series is None:
            wide = abs(self._value(_ball(piece)))
            high = wide.upper() if wide.is_finite() else arb("inf")
            if not high <= self.low * self.factor:
                self.made += 1
                made = self._polynomial(piece)
                if made is not None:
                    piece = made
                else:
                    high = high.min(self._beside_an_end(piece))
                    self._try(piece.middle)
        if piece.series is not None:
            high, point, about = piece.bound()
            if about > float(self.low.mid()):
                self._try(point)
        heapq.heappush(self.heap, (-float(high), next(self.order), high, piece))

    def _try(self, point: fmpq) -> None:
        """Take the value at a point as a lower bound; at an end that may be excluded, if f is
        continuous.
        """
        if self.jumps and point in self.finite:
            return
        here = abs(self._value(arb(point)))
        if here.is_finite() and here.lower() > self.low:
            self.low, self.at = here.lower(), point

    def _value(self, x: arb) -> arb:
        compiled = self.compiled[self.ratio]
        if compiled is not None:
            return compiled.real(x)
        return self.how.value(self.ratio, {self.name: x})

    # -- polynomials ----------------------------------------------------------------------------

    def _polynomial(self, piece: _Piece) -> _Piece | None:
        """Return a piece with a polynomial that approximates the ratio on it, or None."""
        for terms in TERMS:
            found = self._coefficients(self.ratio, piece.middle, piece.half, terms)
            if found is None:
                break
            if found[1] <= self.low * self.part:
                return piece._replace(series=found[0], rest=found[1])
        else:
            assert found is not None
            return piece._replace(series=found[0], rest=found[1])
        for zero, order in self.zeros.items():
            if abs(zero - piece.middle) == piece.half:
                return self._divided(piece, zero, order)
        return None

    def _coefficients(
        self, e: Expr, middle: fmpq, half: fmpq, terms: int
    ) -> tuple[arb_poly, arb] | None:
        compiled = self.compiled[e]
        found = None
        if compiled is not None:
            found = on_a_circle(compiled, middle, half, terms)
        return found or _in_series(self.how.series, e, self.name, middle, half)

    def _divided(self, piece: _Piece, zero: fmpq, order: int) -> _Piece | None:
        """Return the polynomial of a quotient beside a common zero of its two parts."""
        width = 2 * piece.half
        parts = [self._coefficients(e, zero, width, TERMS[-1]) for e in (self.above, self.below)]
        if parts[0] is None or parts[1] is None:
            return None
        (u, u_rest), (v, v_rest) = parts[0], parts[1]
        length = max(u.length(), v.length()) - order
        u, v = (arb_poly([p[k + order] for k in range(length)]) for p in (u, v))
        least = abs(v[0]) - sum((abs(v[k]) for k in range(1, length)), v_rest)
        if not least > 0:
            return None
        before = ctx.cap
        ctx.cap = length
        try:
            quotient = arb_series(u.coeffs(), length) / arb_series(v.coeffs(), length)
            q = arb_poly([quotient[k] for k in range(length)])
        finally:
            ctx.cap = before
        left = u - q * v
        size = sum((abs(x) for x in q.coeffs()), arb(0))
        rest = sum((abs(x) for x in left.coeffs()), u_rest + size * v_rest) / least
        if not rest.is_finite():
            return None
        side = 1 if piece.middle > zero else -1
        return piece._replace(series=q(arb_poly([side * HALF, HALF])), rest=rest.upper())

    # -- ends and zeros -------------------------------------------------------------------------

    def _find_zeros(
        self, first: fmpq, last: fmpq, low: fmpq | None, high: fmpq | None
    ) -> fmpq | None:
        """Find rational zeros of the denominator and their order; return one that is a pole."""
        self._find_quotients(first, last)
        if not self.varies(self.below):
            return None
        candidates = {x for x in (low, high) if x is not None}
        candidates |= {fmpq(x) for x in (-1, 0, 1) if first < x < last}
        changes = self._sign_changes(first, last)
        for left, right in changes:
            over = arb(left).union(arb(right))
            u, v = (self.how.value(e, {self.name: over}) for e in (self.above, self.below))
            if u.is_finite() and v.is_finite() and not u.contains(0):
                return right
        candidates |= {near(right, (right - left) * 4) for left, right in changes}
        for x in sorted(candidates):
            order = self._order(self.below, x)
            if order == 0:
                continue
            if order is None:
                self.kinks.add(x)
                continue
            is_known = self.known is not None and self.known == number(x)
            other = order if is_known else self._order(self.above, x, order)
            if other is not None and other < order and self._is_smooth(x):
                return x
            if other == order:
                self.zeros[x] = order
        return None

    def _find_quotients(self, first: fmpq, last: fmpq) -> None:
        """Find where a quotient inside, such as sin(x)/x, has no value as it is written."""
        for node in operations((self.above, self.below)):
            if node.op != "^" or not self.varies(node.args[0]):
                continue
            exponent = node.args[1]
            if exponent.op != "number" or exponent.args[0] > 0:
                continue
            for x in (fmpq(-1), fmpq(0), fmpq(1)):
                value = self.how.value(node.args[0], {self.name: arb(x)})
                if first < x < last and value.is_zero():
                    self.kinks.add(x)

    def varies(self, e: Expr) -> bool:
        """Return whether an expression depends on the variable."""
        return e.op != "number" and self.name in symbols(e)

    def _is_smooth(self, x: fmpq) -> bool:
        """Whether both parts are analytic at a point, so that orders of zeros tell the limit."""
        small = (self.finite[1] - self.finite[0]) / 2**20
        return all(
            self._coefficients(e, x, small, TERMS[0]) is not None for e in (self.above, self.below)
        )

    def _order(self, e: Expr, x: fmpq, most: int = HIGHEST) -> int | None:
        """Return the order of a zero, at most ``most``; None if it is not shown."""
        for order in range(most + 1):
            there = substitute(e, {self.name: number(x)})
            with suppress(UndefinedError, ZeroDivisionError):
                value = self.how.value(there, {})
                if value.is_finite() and not value.contains(0):
                    return order
            if order == most:
                return most if most < HIGHEST else None
            with suppress(InputError, ZeroDivisionError, UndefinedError):
                if is_zero(there, Given()):
                    e = differentiate(e, self.name)
                    continue
            return None
        return None

    def _sign_changes(self, first: fmpq, last: fmpq) -> list[tuple[fmpq, fmpq]]:
        """Return short intervals at whose ends the denominator has opposite signs."""
        step = (last - first) / SAMPLES
        found = []
        points = [first + k * step for k in range(SAMPLES + 1)]
        values = [self.how.value(self.below, {self.name: arb(x)}) for x in points]
        for a, b, u, v in zip(points, points[1:], values, values[1:], strict=False):
            if not ((u < 0 and v > 0) or (u > 0 and v < 0)):
                continue
            left, right, rising = a, b, bool(u < 0)
            for _ in range(44):
                middle = (left + right) / 2
                value = self.how.value(self.below, {self.name: arb(middle)})
                if value.contains(0):
                    break
                if bool(value < 0) == rising:
                    left = middle
                else:
                    right = middle
            found.append((left, right))
        return found

    def _beside_an_end(self, piece: _Piece) -> arb:
        """Return a bound by leading terms on a piece that touches an end."""
        if self.plain or piece.half * 2**BESIDE > self.finite[1] - self.finite[0]:
            return arb("inf")
        for end in (*self.finite, *self.kinks):
            if abs(end - piece.middle) == piece.half:
                side = 1 if piece.middle > end else -1
                if 4 * piece.half > self.asked.get((end, side), 8 * piece.half):
                    continue
                self.asked[end, side] = piece.half
                bounds = self._near(number(end), side, 2 * piece.half)
                if bounds is not None:
                    if bounds[0] > self.low:
                        self.low, self.at = bounds[0], None
                    return bounds[1]
        return arb("inf")

    def _near(self, end: Expr | None, side: int, reach: fmpq) -> tuple[arb, arb] | None:
        return self._end(end, side).bounds(reach, self.low * self.factor)

    def _end(self, end: Expr | None, side: int) -> _AtEnd:
        key = (None if end is None else end.args[0], side)
        if key not in self.ends:
            self.ends[key] = _AtEnd(self.above, self.below, self.name, end, side)
        return self.ends[key]

    def _to_infinity(self, side: int) -> bool:
        """Bound |f| beside an infinite end, and on what lies before."""
        here = self.finite[1 if side > 0 else 0]
        for _ in range(DOUBLINGS):
            bounds = self._near(None, side, fmpq(1) / abs(here)) if abs(here) >= 1 else None
            if bounds is not None:
                if bounds[0] > self.low:
                    self.low, self.at = bounds[0], None
                if bounds[1] <= self.low * self.factor:
                    self.beyond = self.beyond.max(bounds[1])
                    return True
            further = 2 * here
            self._fill(*sorted((here, further)))
            self._close()
            here = further
        return False


class _AtEnd:
    """Bounds of |f| beside an end: its first terms as they are, and the rest by leading terms."""

    def __init__(self, above: Expr, below: Expr, name: str, end: Expr | None, side: int) -> None:
        self.below, self.name, self.end, self.side = below, name, end, side
        self.rest, self.terms = above, ZERO
        self.levels: list[tuple[Expr, Near | None]] = []
        self.more = True
        self.known = False
        """Whether |f| is shown to be bounded near the end."""
        self._add()
        self.known = self.more

    def bounds(self, reach: fmpq, enough: arb) -> tuple[arb, arb] | None:
        """Return bounds of the supremum up to a distance; more terms are taken if it pays."""
        low, high = arb(0), arb("inf")
        for level in range(LEVELS if self.end is None else 1):
            if level == len(self.levels) and not (self.more and self._add()):
                break
            terms, near = self.levels[level]
            found = None if near is None else near(reach)
            if found is None:
                continue
            if level == 0:
                low, high = found
                enough = enough.max(low)
            else:
                high = high.min((_sum_of_powers(terms, reach) + found[1]).upper())
            if high <= enough:
                break
        return (low, high) if high.is_finite() else None

    def _add(self) -> bool:
        near = near_end(self.rest, self.below, self.name, self.end, self.side)
        self.levels.append((self.terms, near))
        self.more = near is not None
        if near is None:
            return False
        found = written_term(self.rest, self.name, self.end, self.side, Given())
        self.more = found is not None
        if found is not None:
            t = symbol(T)
            put = {self.name: self.side / t if self.end is None else self.end + self.side * t}
            positive = Given(((t, ">", ZERO),))
            self.terms += normal_form(substitute(found[0] / self.below, put), positive)
            self.rest -= found[0]
        return True


def _sum_of_powers(e: Expr, reach: fmpq) -> arb:
    """Return an upper bound of a sum of powers of ``T`` on 0 < t ≤ reach; they may be roots."""
    t = symbol(T)
    if any(node.op not in ("+", "*", "^", "pi") for node in operations((e,))):
        return arb("inf")
    parts = [
        int(node.args[1].args[0].q)
        for node in operations((e,))
        if node.op == "^" and node.args[0] == t and node.args[1].op == "number"
    ]
    q = lcm(*parts) if parts else 1
    if q > 1:
        e = normal_form(substitute(e, {T: t**q}), Given(((t, ">", ZERO),)))
        root = arb(reach).root(q).upper() if reach < 1 else arb(reach)
        reach = (root * 2**40).fmpq().ceil() / fmpq(2**40)
    search = _Search(e, ONE, T, PART, EXPLICIT)
    search.plain = True
    return search.over(fmpq(0), fmpq(reach)).high


def _compiled(e: Expr, name: str) -> Compiled | None:
    try:
        return Compiled(e, (name,))
    except UndefinedError:
        return None


def _ball(piece: _Piece) -> arb:
    first, last = piece.middle - piece.half, piece.middle + piece.half
    return arb(first).union(arb(last))


def _short(s: arb) -> fmpq:
    """Return a number of few bits close to a ball."""
    return fmpq(round(float(s.mid()) * 2**20), 2**20) if abs(s) < 2 else fmpq(1)


def _in_series(
    walks: Walks, e: Expr, name: str, middle: fmpq, half: fmpq
) -> tuple[arb_poly, arb] | None:
    """Return Taylor coefficients, and a bound of Lagrange's remainder."""
    before = ctx.cap
    ctx.cap = SHORT + 1
    m, h = arb(middle), arb(half)
    over = m + arb(0, h.upper())
    try:
        series = [walks({name: arb_series([at, 1], ctx.cap)}).value(e) for at in (m, over)]
        if min(one.prec for one in series) <= SHORT:
            return None
        kept = [series[0][k] * h**k for k in range(SHORT)]
        rest = abs(series[1][SHORT]) * h**SHORT
    except (ValueError, ZeroDivisionError, UndefinedError, AttributeError, TypeError):
        return None
    finally:
        ctx.cap = before
    if not rest.is_finite() or not all(c.is_finite() for c in kept):
        return None
    return arb_poly(kept), rest.upper()
