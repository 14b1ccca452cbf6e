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
from tresym.asymptotics.layer_sums import Part, Reader
from tresym.reals.decisions.readable_witnesses import tidied
from tresym.reals.domain.conditions import Given
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

Polynomial = list[Expr]
"""Coefficients of the powers of s."""


def outer(
    reader: Reader,
    parts: tuple[Part, Part, Part],
    n: int,
    order: int,
    given: Given,
    start: tuple[Expr, Expr] | None,
) -> list[Expr]:
    """Return the terms of the outer solution.

    Args:
        reader: the names of the variables.
        parts: a, b and f.
        n: the power of t at the second derivative.
        order: the number of terms.
        given: conditions on the parameters.
        start: the point and the value there, for a layer at one end; None for layers at both.

    Raises:
        OpenError: no explicit solution is found.
    """
    x = reader.x
    a, b, f = ([*_series(reader, part, order)] for part in parts)
    value = _series(reader, reader.read(start[1])[()], order) if start else []
    found: list[Expr] = []
    slopes: list[Expr] = []
    curves: list[Expr] = []
    for i in range(order):
        rest = f[i]
        for j in range(1, i + 1):
            rest = rest - b[j] * found[i - j] - a[j] * slopes[i - j]
        if i >= n:
            rest = rest - curves[i - n]
        rest = tidied(normal_form(rest, given))
        if start is None:
            term = rest / b[0]
        else:
            y = "[O]"
            right = tidied(normal_form((rest - b[0] * symbol(y)) / a[0], given))
            problem = Problem(x, {y: right}, (Value(start[0], y, value[i]),), {(y, 0): y})
            curve = next(iter(solutions(problem, given)), None)
            if curve is None:
                raise OpenError(
                    f"no explicit solution of the equation without the small "
                    f"parameter was found: derivative {right}"
                )
            term = curve[y]
        term = tidied(normal_form(term, given))
        found.append(term)
        slopes.append(differentiate(term, x))
        curves.append(differentiate(slopes[-1], x))
    return found


def inner(
    reader: Reader,
    a: Part,
    b: Part,
    n: int,
    width: int,
    point: Expr,
    direction: int,
    starts: list[Expr],
    given: Given,
) -> Expr:
    """Return the sum of the terms of a layer, as an expression in x and t.

    Args:
        reader: the names of the variables.
        a, b: the parts of the equation.
        n: the power of t at the second derivative.
        width: the power of t that is the width of the layer.
        point: its end of the interval.
        direction: 1 at the lower, −1 at the upper end.
        starts: the values at that end, one for each order.
        given: conditions on the parameters.
    """
    order = len(starts)
    first = _stretched(reader, a, width, point, direction, width - n, order, given)
    second = _stretched(reader, b, width, point, direction, 2 * width - n, order, given)
    first = [[direction * c for c in p] for p in first]
    alpha, beta = _constant(first[0]), _constant(second[0])
    half = number(fmpq(1, 2))
    rate = alpha if beta == ZERO else half * (alpha + (alpha**2 - 4 * beta) ** half)
    rate = tidied(normal_form(rate, given))
    kappa = tidied(normal_form(2 * rate - alpha, given))
    found: list[Polynomial] = []
    for i, start in enumerate(starts):
        right: Polynomial = []
        for j in range(1, i + 1):
            p = found[i - j]
            slope = [tidied(c - rate * d) for c, d in zip([*_slope(p), ZERO], p, strict=False)]
            right = _plus(right, _times(first[j], slope), -1)
            right = _plus(right, _times(second[j], p), -1)
        found.append([tidied(normal_form(c, given)) for c in _solved(right, kappa, start)])
    s = direction * (symbol(reader.x) - point) / symbol(reader.t) ** width
    total: Expr = ZERO
    for i, p in enumerate(found):
        for k, c in enumerate(p):
            power = (s**k if k else ONE) * (symbol(reader.t) ** i if i else ONE)
            total = total + c * power
    return total * apply("exp", -rate * s)


def _series(reader: Reader, part: Part, order: int) -> list[Expr]:
    found = [ZERO] * max(order, 1)
    for power, c in reader.coefficients(part, order):
        found[power] = tidied(c)
    return found


def _stretched(
    reader: Reader,
    part: Part,
    width: int,
    point: Expr,
    direction: int,
    shift: int,
    order: int,
    given: Given,
) -> list[Polynomial]:
    """Return a smooth part times t to a power, at a point of the layer, as a series in t."""
    found: list[Polynomial] = [[] for _ in range(order)]
    for power, c in reader.coefficients(part, order - shift):
        d = 0
        while power + shift + d * width < order:
            value = substitute(c, {reader.x: point})
            value = tidied(normal_form(value * number(fmpq(direction**d, factorial(d))), given))
            place = power + shift + d * width
            if place >= 0 and value != ZERO:
                found[place] = _plus(found[place], [*[ZERO] * d, value])
            c = differentiate(c, reader.x)
            d += 1
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


def _solved(right: Polynomial, kappa: Expr, start: Expr) -> Polynomial:
    """Return the polynomial P with P'' − κP' = ``right`` and P(0) = ``start``."""
    slope: Polynomial = []
    rest, power = right, ONE
    while rest:
        power = power * kappa
        slope = _plus(slope, [-c / power for c in rest])
        rest = _slope(rest)
    return [start, *(c * number(fmpq(1, k + 1)) for k, c in enumerate(slope))]
