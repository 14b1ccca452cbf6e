"""Bound the error of an approximation with boundary layers by one number, for all small e.

Example: for e*y'' + y' + y == 0, y(0) == 0, y(1) == 1 the residual of Y = exp(1 − x) − exp(1 − x/e)
is e·exp(1 − x) − exp(1 − x/e). A positive function W with LW = e*W'' + W' + W <= −|residual| that
is at least the errors at the ends bounds the error of Y (generalized maximum principle). For

    L y = tⁿ y'' + a y' + b y,   a > 0,   W = tᵏ (V(x) + K exp(−β(x − l)/tⁿ)),

V is a polynomial close to the solution of aV' + bV = −M outside the layer, and the layer needs
K(β(a − β) − tⁿb) >= S, where M tᵏ and S tᵏ⁻ⁿ e^{−βs} bound the two parts of the residual. With
b < 0 a constant serves. All bounds are Taylor coefficients in balls, over pieces of the interval
and over the whole range of t at once.

Source: M. H. Protter and H. F. Weinberger, *Maximum Principles in Differential Equations*, 1984,
section 1.5.
"""

from __future__ import annotations

import heapq
from collections.abc import Callable
from itertools import count
from typing import NamedTuple

from flint import arb, arb_poly, arb_series, ctx, fmpq

from tresym.asymptotics.differential_problem import OpenError
from tresym.asymptotics.layer_problems import FIRST, ONE_LAYER, Layer, at_point, kind_of
from tresym.asymptotics.layer_sums import Exponent, Layered, Part
from tresym.reals.balls.taylor import InSeries
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import ZERO, Expr, substitute, symbols
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.signs.interior import is_zero

BITS = 64
PIECES = 160
"""The most pieces of the interval on which a function is bounded."""
NEAR = arb("1.02")
"""A bound is accepted up to this factor of a value that is attained."""
SHARES = tuple(fmpq(k, 20) for k in (6, 8, 10, 12, 14, 16, 18, 19))
"""The rates of decay of the barrier, as parts of the largest possible one."""
DEGREE = 12
STEPS = 16
"""The degree of V, and the steps of the numerical integration between its points."""
MARGINS = (1.03, 1.15, 1.5, 2.5, 5.0)
"""V is computed for a residual that is larger by these factors, so as to bear tⁿV''."""


class Piece(NamedTuple):
    """|part| <= size * sᵐ in the layer, with s the distance over its width."""

    size: arb
    m: int


class Bounds(NamedTuple):
    """Bounds of all errors, each to be multiplied by tᵏ.

    Attributes:
        outside: of the residual.
        layer: of the part that is tᵏ⁻ⁿ times decays, with its rate; empty if there is none.
        rate: of decay.
        ends: of the errors at both ends.
    """

    outside: arb
    layer: list[Piece]
    rate: arb
    ends: tuple[arb, arb]


def error_constant(layer: Layer, curve: Layered, order: int, reach: fmpq) -> arb | None:
    """Return C with |y − Y| <= C tᵏ between the ends for all t with 0 < t^q <= reach, or None.

    Args:
        layer: the problem, without parameters.
        curve: the approximation, whose orders are shown already.
        order: k.
        reach: of the small parameter.
    """
    before = ctx.cap
    try:
        with ball_precision(BITS):
            top = arb(reach).root(layer.reader.q)
            work = _Work(layer, order, arb(top.upper()))
            bounds = work.bounds(curve)
            return work.one(bounds) if layer.kind == ONE_LAYER else work.both(bounds)
    except (OpenError, ZeroDivisionError, ValueError, OverflowError, KeyError, TypeError):
        return None
    finally:
        ctx.cap = before


def largest(f: Callable[[arb], arb], low: arb, high: arb) -> arb:
    """Return an upper bound of a function on an interval.

    Raises:
        OpenError: none is found.
    """
    number = count()
    heap: list[tuple[float, int, arb, arb, arb]] = []

    def add(a: arb, b: arb) -> None:
        value = f(a.union(b))
        key = -float(value.upper()) if value.is_finite() else -1e300
        heapq.heappush(heap, (key, next(number), value, a, b))

    add(low, high)
    seen = None
    for _ in range(PIECES):
        _, _, value, a, b = heap[0]
        middle = arb(((a + b) / 2).mid())
        there = f(middle)
        if there.is_finite():
            seen = there.lower() if seen is None else arb(seen).max(arb(there.lower()))
        if value.is_finite() and seen is not None:
            gap = value.upper() - seen
            if gap <= (NEAR - 1) * abs(arb(seen)) or gap < arb("1e-12"):
                break
        heapq.heappop(heap)
        add(a, middle)
        add(middle, b)
    if not heap[0][2].is_finite():
        raise OpenError("a function is not bounded in balls")
    return arb(max(value.upper() for _, _, value, _, _ in heap))


class _Work:
    def __init__(self, layer: Layer, order: int, top: arb) -> None:
        self.layer, self.order, self.top = layer, order, top
        self.t = arb(0).union(top)
        self.low, self.high = (evaluate(layer.place(k), {}) for k in (0, 1))
        if not (self.low.is_finite() and self.high.is_finite()):
            raise OpenError("the ends are not numbers")

    # Bounds of the parts

    def size(self, e: Expr, by: str, order: int, whole: bool = True) -> arb:
        """Return a bound of |Taylor coefficient| of an order in x or t, for all x and t."""
        x, t = self.layer.x, self.layer.t
        if symbols(e) - {x, t}:
            raise OpenError("there are parameters")

        def coefficient(at: arb) -> arb:
            ctx.cap = order + 1
            rows = {x: [at], t: [self.t if whole else arb(0)]}
            if order:
                rows[by].append(arb(1))
            series = {n: arb_series(row, ctx.cap) for n, row in rows.items()}
            try:
                value = InSeries(None, series).value(e)
            except (ValueError, ZeroDivisionError):
                return arb.nan()
            if value.prec <= order:
                return arb.nan()
            return abs(arb(value[order]))

        return largest(coefficient, self.low, self.high)

    def part(self, part: Part, target: int) -> arb:
        """Return a bound of tᵛ g over t to a power, if lower Taylor coefficients vanish."""
        n = max(0, target - part.power)
        more = self.top ** max(0, part.power - target)
        return self.size(part.factor, self.layer.t, n) * more

    def pieces(self, part: Part, target: int, end: int, scale: int) -> list[Piece]:
        """Return bounds of the factor of a layer over t to a power."""
        reader, found = self.layer.reader, []
        for power, c in reader.coefficients(part, target):
            m = -((power - target) // scale)
            excess = power + scale * m - target
            if not is_zero(c, reader.given):
                size = self.size(c, reader.x, m, whole=False)
                found.append(Piece(size * self.top**excess, m))
        found.append(Piece(self.part(part, target), 0))
        return found

    def decay(self, key: Exponent, end: int) -> arb:
        """Return a lower bound of the rate at which an exponential decays away from its end."""
        if len(key) != 1:
            raise OpenError("the exponent has several terms")
        slope = differentiate(key[0][1], self.layer.x)
        sign = -1 if end == 0 else 1
        fastest = largest(
            lambda at: -sign * evaluate(slope, {self.layer.x: at}), self.low, self.high
        )
        if not -fastest > 0:
            raise OpenError("the rate is not bounded below")
        return arb((-fastest).lower())

    def negligible(self, key: Exponent, part: Part, target: int) -> arb:
        """Return a bound of an exponential that vanishes faster than all powers."""
        if len(key) != 1:
            raise OpenError("the exponent has several terms")
        power, f = key[0]
        rate = -largest(lambda at: evaluate(f, {self.layer.x: at}), self.low, self.high)
        size = self.size(part.factor, self.layer.t, 0)
        if not rate > 0:
            raise OpenError("the exponential is not shown to be small")
        n = arb(target - part.power) / -power
        u = 1 / self.top**-power
        if n > rate * u:
            u = n / rate
        return arb((size * u**n * (-rate * u).exp()).upper())

    def bounds(self, curve: Layered) -> Bounds:
        """Return bounds of the residual and of the errors at the ends."""
        layer, k = self.layer, self.order
        outside, inside, rate = arb(0), [], None
        for key, whole in layer.residual(curve).items():
            shorter = normal_form(whole.factor, layer.reader.given)
            part = min(whole, whole._replace(factor=shorter), key=lambda p: len(str(p.factor)))
            kind = kind_of(layer, key)
            if kind is None:
                outside += self.negligible(key, part, k)
                continue
            end, scale = kind
            if end is None:
                outside += self.part(part, k)
                continue
            own = self.decay(key, end)
            if layer.kind == ONE_LAYER and end == 0 and scale == layer.n:
                inside += self.pieces(part, k - layer.n, end, scale)
                rate = own if rate is None else rate.min(own)
            else:
                outside += sum(
                    (p.size * _peak(p.m, own) for p in self.pieces(part, k, end, scale)), arb(0)
                )
        ends = [arb(0), arb(0)]
        for c in layer.conditions:
            there = at_point(layer, curve, layer.place(c.end))
            error = layer.reader.sum([there, layer.reader.read(-c.value)])
            for key, part in error.items():
                ends[c.end] += self.negligible(key, part, k) if key else self.part(part, k)
        return Bounds(
            arb(outside.upper()),
            inside,
            rate or arb(1),
            (arb(ends[0].upper()), arb(ends[1].upper())),
        )

    # Barriers

    def value(self, part: Part, at: arb) -> arb:
        """Return a smooth part at x for all t."""
        return evaluate(part.factor, {self.layer.x: at, self.layer.t: self.t}) * (
            self.t**part.power if part.power else arb(1)
        )

    def both(self, bounds: Bounds) -> arb | None:
        """Return the constant where a constant is a barrier."""
        side = -1 if self.layer.kind == FIRST else 1
        least = -largest(lambda at: side * self.value(self.layer.b, at), self.low, self.high)
        if not least > 0:
            return None
        most = (bounds.outside / least).max(bounds.ends[0]).max(bounds.ends[1])
        return arb(most.upper())

    def one(self, bounds: Bounds) -> arb | None:
        """Return the constant for a layer at the lower end."""
        layer = self.layer
        least = -largest(lambda at: -self.value(layer.a, at), self.low, self.high)
        if not least > 0:
            return None
        found = self.outer(bounds)
        if found is None:
            return None
        start, most = found
        rate = bounds.rate.min(least)
        best = None
        for share in SHARES:
            beta = arb((rate * arb(share)).mid())
            size = sum((p.size * _peak(p.m, bounds.rate - beta) for p in bounds.layer), arb(0))

            def damped(at: arb, beta: arb = beta) -> arb:
                small = self.t**layer.n * self.value(layer.b, at)
                return small - beta * (self.value(layer.a, at) - beta)

            gain = -largest(damped, self.low, self.high)
            if not gain > 0:
                continue
            height = arb(size / gain).max(bounds.ends[0] - start).max(arb(0))
            best = height if best is None or height < best else best
        return None if best is None else arb((most + best).upper())

    def outer(self, bounds: Bounds) -> tuple[arb, arb] | None:
        """Return a lower bound of V at the lower end and its maximum, after V is verified."""
        scale = float((bounds.outside + bounds.ends[0] + bounds.ends[1]).upper()) + sum(
            float(p.size.upper()) for p in bounds.layer
        )
        scale = max(scale, 1e-9)
        value = float(bounds.ends[1].upper()) * MARGINS[0] + 0.01 * scale
        for margin in MARGINS:
            forced = float(bounds.outside.upper()) * margin + 0.01 * margin * scale
            poly = self.numerical(forced, value)
            found = None if poly is None else self.verified(poly, bounds)
            if found is not None:
                return found
        return None

    def verified(self, poly: arb_poly, bounds: Bounds) -> tuple[arb, arb] | None:
        """Return a lower bound of V at the lower end and its maximum if V is a barrier."""
        slope = poly.derivative()
        curve, layer = slope.derivative(), self.layer
        small = self.t**layer.n

        def left_over(at: arb) -> arb:
            z = at - self.low
            total = small * curve(z) + self.value(layer.a, at) * slope(z)
            return total + self.value(layer.b, at) * poly(z) + bounds.outside

        def lowest(at: arb) -> arb:
            return -poly(at - self.low)

        if not largest(left_over, self.low, self.high) < 0:
            return None
        if not -largest(lowest, self.low, self.high) > 0:
            return None
        if not poly(self.high - self.low) > bounds.ends[1]:
            return None
        most = largest(lambda at: poly(at - self.low), self.low, self.high)
        return arb(poly(arb(0)).lower()), most

    def numerical(self, forced: float, value: float) -> arb_poly | None:
        """Return a polynomial in x − l close to the solution of aV' + bV = −forced."""
        import numpy as np

        layer, a, h = self.layer, float(self.low.mid()), float(self.high.mid())
        nodes = (h + a) / 2 + (h - a) / 2 * np.cos(
            np.pi * (np.arange(DEGREE + 1) + 0.5) / (DEGREE + 1)
        )
        v, x = value, h
        values = []
        flat = [substitute(p.factor, {layer.t: ZERO}) for p in (layer.a, layer.b)]
        smooth = [p.power == 0 for p in (layer.a, layer.b)]

        def right(x: float, v: float) -> float:
            first, second = (
                float(evaluate(e, {layer.x: arb(x)}).mid()) if kept else 0.0
                for e, kept in zip(flat, smooth, strict=True)
            )
            return (-forced - second * v) / first

        for node in nodes:
            step = (float(node) - x) / STEPS
            for _ in range(STEPS):
                one = right(x, v)
                two = right(x + step / 2, v + step / 2 * one)
                three = right(x + step / 2, v + step / 2 * two)
                four = right(x + step, v + step * three)
                v, x = v + step / 6 * (one + 2 * two + 2 * three + four), x + step
            values.append(v)
        fitted = np.polynomial.Polynomial.fit(nodes - a, values, DEGREE).convert()
        if not np.isfinite(fitted.coef).all():
            return None
        return arb_poly([arb(float(c)) for c in fitted.coef])


def _peak(m: int, rate: arb) -> arb:
    """Return the maximum of sᵐ e^{−rate s}."""
    if m == 0:
        return arb(1)
    return (arb(m) / (arb(1).exp() * rate)) ** m
