"""Compute the expansion of a solution with boundary layers, order by order.

Example: for e*y'' + y' + y == 0, y(0) == 0, y(1) == 1 the outer solution satisfies O' + O = 0,
O(1) = 1, so that O = exp(1 − x); the layer is U = −e·exp(−s) with s = x/e, since U'' + U' = 0,
U(0) = −O(0) and U vanishes for large s. Their sum is the composite expansion.

In the normal form tⁿ y'' + a y' + b y = f of :mod:`tresym.asymptotics.layers` both are power series
in t. The terms of the layer are polynomials P(s) times exp(−λs), and P'' − κP' = Q is solved for
polynomials. Nothing is proved here: the residual of the sum is checked there.

Source: C. M. Bender and S. A. Orszag, *Advanced Mathematical Methods for Scientists and Engineers*,
1978, chapter 9.
"""

from __future__ import annotations

from math import factorial

from flint import fmpq

from tresym.asymptotics.differential_problem import OpenError, Problem, Value
from tresym.asymptotics.explicit_solutions import solutions
from tresym.asymptotics.layer_problems import (
    DAMPED,
    FIRST,
    ONE_LAYER,
    SECOND,
    TWO_LAYERS,
    Condition,
    Layer,
)
from tresym.asymptotics.layer_sums import Part, Reader
from tresym.reals.decisions.readable_witnesses import tidied
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ONE,
    ZERO,
    Expr,
    apply,
    number,
    substitute,
    symbol,
)
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.signs.interior import is_zero

Polynomial = list[Expr]
"""Coefficients of the powers of s."""


class Composite:
    """The outer solution and the layers of a problem, order by order."""

    def __init__(self, layer: Layer, order: int) -> None:
        """Begin with no terms, for at most ``order`` of them."""
        if layer.kind == DAMPED:
            raise OpenError("layers inside the interval are not computed")
        self.layer, self.order = layer, order
        r = layer.reader
        self.a, self.b, self.f = (_series(r, part, order) for part in (layer.a, layer.b, layer.f))
        self.terms: list[Expr] = []
        self.slopes: list[Expr] = []
        self.curves: list[Expr] = []
        self.values = [self._value(c) for c in layer.conditions]
        ends = {c.end for c in layer.conditions} if layer.kind == TWO_LAYERS else {0}
        self.inner = {end: _Inner(layer, end, order) for end in ends}

    def _value(self, condition: Condition) -> dict[int, Expr]:
        found = self.layer.reader.read(condition.value).get((), Part(0, ZERO))
        return dict(self.layer.reader.coefficients(found, self.order))

    def step(self) -> None:
        """Compute the terms of the next order."""
        i, layer = len(self.terms), self.layer
        pairs = list(zip(layer.conditions, self.values, strict=True))
        if layer.kind == SECOND:
            for condition, value in pairs:
                if condition.order:
                    self._bend(condition, value, i)
            (start,) = (
                value.get(i, ZERO) - self.inner[0].found[i][0]
                for condition, value in pairs
                if not condition.order
            )
            self._outer(i, (layer.low, start))
            return
        if layer.kind == ONE_LAYER:
            (start,) = (value.get(i, ZERO) for condition, value in pairs if condition.end)
            self._outer(i, (layer.place(1), start))
        else:
            self._outer(i, None)
        for condition, value in pairs:
            if condition.end not in self.inner:
                continue
            if condition.order:
                self._bend(condition, value, i)
                continue
            there = self._at(self.terms[i], condition.end)
            self.inner[condition.end].step(i, value.get(i, ZERO) - there)

    def _at(self, e: Expr, end: int) -> Expr:
        return substitute(e, {self.layer.x: self.layer.place(end)})

    def _bend(self, condition: Condition, value: dict[int, Expr], i: int) -> None:
        """Add the term of a layer whose slope makes up for that of the outer solution."""
        j = i - self.layer.width
        slope = value.get(j, ZERO)
        if 0 <= j < len(self.slopes):
            slope = slope - self._at(self.slopes[j], condition.end)
        self.inner[condition.end].step(i, None, slope)

    def _outer(self, i: int, start: tuple[Expr, Expr] | None) -> None:
        layer, given = self.layer, self.layer.fixed
        rest = self.f[i]
        for j in range(1, i + 1):
            rest = rest - self.b[j] * self.terms[i - j] - self.a[j] * self.slopes[i - j]
        if i >= layer.n and layer.kind != FIRST:
            rest = rest - self.curves[i - layer.n]
        rest = tidied(normal_form(rest, given))
        if start is None:
            term = rest / self.b[0]
        else:
            factor = tidied(normal_form(self.b[0] / self.a[0], given))
            force = tidied(normal_form(rest / self.a[0], given))
            term = self._linear(factor, force, start[0], tidied(normal_form(start[1], given)))
        term = tidied(normal_form(term, given))
        self.terms.append(term)
        self.slopes.append(differentiate(term, layer.x))
        self.curves.append(differentiate(self.slopes[-1], layer.x))

    def _linear(self, factor: Expr, force: Expr, point: Expr, value: Expr) -> Expr:
        """Return the solution of y' + factor*y = force with a value at a point.

        Raises:
            OpenError: none is found.
        """
        x, y, given = self.layer.x, "[O]", self.layer.closed
        right = force - factor * symbol(y)
        problem = Problem(x, {y: right}, (Value(point, y, value),), {(y, 0): y})
        for curve in solutions(problem, self.layer.fixed):
            e = curve[y]
            if not is_zero(differentiate(e, x) + factor * e - force, given):
                continue
            gap = tidied(normal_form(value - substitute(e, {x: point}), given))
            if is_zero(gap, given):
                return e
            if is_zero(force, given):  # a multiple of the solution was found
                return e * value / substitute(e, {x: point})
            return e + self._linear(factor, ZERO, point, gap)
        raise OpenError(
            f"no explicit solution of the equation without the small parameter was found: "
            f"derivative {right}"
        )

    def total(self) -> Expr:
        """Return the sum of all terms, as an expression in x and t."""
        t = symbol(self.layer.t)
        total: Expr = ZERO
        for i, term in enumerate(self.terms):
            total = total + (term * t**i if i else term)
        for inner in self.inner.values():
            total = total + inner.total()
        return total


class _Inner:
    """A layer: polynomials P(s), for each order, times exp(−λs)."""

    def __init__(self, layer: Layer, end: int, order: int) -> None:
        self.layer, self.point = layer, layer.place(end)
        self.direction = 1 if end == 0 else -1
        n, width = layer.n, layer.width
        shift = 0 if layer.kind == FIRST else width - n
        first = self._stretched(layer.a, shift, order)
        if layer.kind == FIRST:
            first = [[ZERO]] * order
        self.second = self._stretched(layer.b, 0 if layer.kind == FIRST else 2 * width - n, order)
        self.first = [[self.direction * c for c in p] for p in first]
        alpha, beta = _constant(self.first[0]), _constant(self.second[0])
        half = number(fmpq(1, 2))
        given = layer.fixed
        if layer.kind == FIRST:
            rate = beta
        else:
            rate = alpha if beta == ZERO else half * (alpha + (alpha**2 - 4 * beta) ** half)
        self.rate = tidied(normal_form(rate, given))
        self.kappa = tidied(normal_form(2 * self.rate - alpha, given))
        self.found: list[Polynomial] = []

    def step(self, i: int, value: Expr | None, slope: Expr = ZERO) -> None:
        """Add the term of an order with a value at s = 0, or with a slope by x there."""
        right: Polynomial = []
        for j in range(1, i + 1):
            p = self.found[i - j]
            bent = [c - self.rate * d for c, d in zip([*_slope(p), ZERO], p, strict=False)]
            right = _plus(right, _times(self.first[j], bent), -1)
            right = _plus(right, _times(self.second[j], p), -1)
        first = self.layer.kind == FIRST  # then P' = Q
        slopes = right if first else _particular(right, self.kappa)
        if value is None:
            value = (_constant(slopes) - self.direction * slope) / self.rate
        p = [value, *(c * number(fmpq(1, k + 1)) for k, c in enumerate(slopes))]
        self.found.append([tidied(normal_form(c, self.layer.fixed)) for c in p])

    def total(self) -> Expr:
        """Return the sum of the terms, as an expression in x and t."""
        layer = self.layer
        t, away = symbol(layer.t), self.direction * (symbol(layer.x) - self.point)
        s = away / t**layer.width
        total: Expr = ZERO
        for i, p in enumerate(self.found):
            for k, c in enumerate(p):
                if c == ZERO:
                    continue
                shift = i - k * layer.width
                power = (away**k if k else ONE) * (t**shift if shift else ONE)
                total = total + c * power
        return total if total == ZERO else total * apply("exp", -self.rate * s)

    def _stretched(self, part: Part, shift: int, order: int) -> list[Polynomial]:
        """Return a smooth part times t to a power, near the end of the layer, as a series in t."""
        reader, width = self.layer.reader, self.layer.width
        found: list[Polynomial] = [[] for _ in range(order)]
        for power, c in reader.coefficients(part, order - shift):
            d = 0
            while power + shift + d * width < order:
                value = substitute(c, {reader.x: self.point})
                value = value * number(fmpq(self.direction**d, factorial(d)))
                value = tidied(normal_form(value, self.layer.fixed))
                place = power + shift + d * width
                if place >= 0 and value != ZERO:
                    found[place] = _plus(found[place], [*[ZERO] * d, value])
                c = differentiate(c, reader.x)
                d += 1
        return found


def _series(reader: Reader, part: Part, order: int) -> list[Expr]:
    found = [ZERO] * max(order, 1)
    for power, c in reader.coefficients(part, order):
        found[power] = tidied(c)
    return found


def _constant(p: Polynomial) -> Expr:
    return p[0] if p else ZERO


def _plus(p: Polynomial, r: Polynomial, factor: int = 1) -> Polynomial:
    size = max(len(p), len(r))
    p, r = [*p, *[ZERO] * (size - len(p))], [*r, *[ZERO] * (size - len(r))]
    return [x + factor * y for x, y in zip(p, r, strict=True)]


def _times(p: Polynomial, r: Polynomial) -> Polynomial:
    found: Polynomial = [ZERO] * max(len(p) + len(r) - 1, 0)
    for i, x in enumerate(p):
        for j, y in enumerate(r):
            found[i + j] = found[i + j] + x * y
    return found


def _slope(p: Polynomial) -> Polynomial:
    return [k * c for k, c in enumerate(p)][1:]


def _particular(right: Polynomial, kappa: Expr) -> Polynomial:
    """Return the derivative of a polynomial P with P'' − κP' = ``right``."""
    slope: Polynomial = []
    rest, power = right, ONE
    while rest:
        power = power * kappa
        slope = _plus(slope, [-c / power for c in rest])
        rest = _slope(rest)
    return slope
