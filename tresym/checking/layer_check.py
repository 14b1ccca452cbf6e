"""Check claims about boundary layers by solving the boundary value problem with differences.

Example: for e*y'' + y' == 0, y(0) == 0, y(1) == 1 the equation is replaced by differences on points
that crowd at both ends, for three small values of e, and the largest error of an approximation over
all of these points is compared with the comparison function. It must not outgrow it.

Nothing is proved here. Two meshes, one twice as fine, tell the error of the differences; the result
is the extrapolated one (L. F. Richardson). The module shares the expression trees with
:mod:`tresym.asymptotics.layers`, and nothing else.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from tresym.reals.language.expression import Expr

COARSE = 500
"""Points of the coarse mesh in each half of the interval."""
LENGTH = 2.0
"""How far initial value problems are solved."""
STEP = 0.06
"""The step for oscillations."""
RESOLVED = 0.3
"""The most that the phase of an oscillation may change in one step."""
FIRST = 1e-4
"""The first step, as a multiple of the small parameter."""

_PLAIN = ("exp", "log", "sin", "cos", "tan", "sinh", "cosh", "tanh", "sqrt")


class UnsupportedError(Exception):
    """An expression has no value here, so that nothing is contradicted."""


def value(e: Expr, at: Mapping[str, Any]) -> Any:
    """Return an expression in doubles, for numbers and arrays.

    Raises:
        UnsupportedError: a function is not known here.
    """
    import numpy as np

    op, args = e.op, e.args
    if op == "symbol":
        if args[0] not in at:
            raise UnsupportedError
        return at[args[0]]
    if op == "number":
        return float(int(args[0].p)) / float(int(args[0].q))
    if op == "pi":
        return math.pi
    parts = [value(arg, at) for arg in args]
    with np.errstate(all="ignore"):
        if op == "+":
            return sum(parts[1:], parts[0])
        if op == "*":
            return math.prod(parts[1:], start=parts[0])
        if op == "^":
            return np.power(parts[0], parts[1])
        if op == "abs":
            return np.abs(parts[0])
        if op == "erf":
            return np.vectorize(math.erf)(parts[0])
        if op in _PLAIN:
            return getattr(np, op)(parts[0])
    raise UnsupportedError


def solved(
    equation: Expr,
    marks: tuple[str, str, str],
    at: Mapping[str, float],
    x: str,
    ends: tuple[float, float],
    values: tuple[float, float],
    small: float,
) -> tuple[Any, Any, Any]:
    """Return points, the solution there and an estimate of its error, as arrays.

    Args:
        equation: an expression that is 0, linear in the marks.
        marks: symbols for the function and its first two derivatives.
        at: values of the other variables.
        x: the variable.
        ends: of the interval.
        values: of the function at the ends.
        small: the small parameter, for the mesh.

    Raises:
        UnsupportedError: there is no result.
    """
    import numpy as np

    half = (ends[1] - ends[0]) / 2
    fine = half * np.expm1(np.linspace(0, math.log1p(1 / (FIRST * small)), 2 * COARSE + 1))
    fine = fine * FIRST * small
    points = np.concatenate([ends[0] + fine, ends[1] - fine[-2::-1]])
    points[0], points[-1] = ends
    one, other = (_solved(equation, marks, at, x, points[::step], values) for step in (2, 1))
    gap = other[::2] - one
    return points[::2], other[::2] + gap / 3, abs(gap) / 3 + 1e-9


def _solved(
    equation: Expr,
    marks: tuple[str, str, str],
    at: Mapping[str, float],
    x: str,
    points: Any,
    values: tuple[float, float],
) -> Any:
    import numpy as np

    inner = points[1:-1]
    zero = dict.fromkeys(marks, 0.0)
    here = {**at, x: inner}
    free = value(equation, {**here, **zero}) + 0 * inner
    b, a, p = (value(equation, {**here, **zero, mark: 1.0}) - free for mark in marks)
    twice = value(equation, {**here, **zero, marks[2]: 2.0}) - free
    if not np.allclose(twice, 2 * p):
        raise UnsupportedError
    left, right = np.diff(points)[:-1], np.diff(points)[1:]
    low = (2 * p - a * right) / (left * (left + right))
    high = (2 * p + a * left) / (right * (left + right))
    middle = b - 2 * p / (left * right) + a * (right - left) / (left * right)
    rest = -free
    y = _tridiagonal(low.tolist(), middle.tolist(), high.tolist(), rest.tolist(), values)
    found = np.array([values[0], *y, values[1]])
    if not np.isfinite(found).all():
        raise UnsupportedError
    return found


def marched(
    equation: Expr,
    marks: tuple[str, ...],
    at: Mapping[str, float],
    x: str,
    start: float,
    values: tuple[float, ...],
    small: float,
) -> tuple[Any, Any, Any]:
    """Return points, the solution of an initial value problem there and an estimate of its error.

    Args:
        equation: an expression that is 0, linear in the marks.
        marks: symbols for the function and its first, or first two, derivatives.
        at: values of the other variables.
        x: the variable.
        start: the initial point.
        values: of the function, and of its derivative, there.
        small: the small parameter, for the mesh.

    Raises:
        UnsupportedError: there is no result.
    """
    import numpy as np

    fine = np.expm1(np.linspace(0, math.log1p(LENGTH / (FIRST * small)), 4 * COARSE + 1))
    points = start + fine * FIRST * small
    one, other = (_marched(equation, marks, at, x, points[::step], values) for step in (2, 1))
    gap = other[::2] - one
    return points[::2], other[::2] + gap / 3, abs(gap) / 3 + 1e-9


def _marched(
    equation: Expr,
    marks: tuple[str, ...],
    at: Mapping[str, float],
    x: str,
    points: Any,
    values: tuple[float, ...],
) -> Any:
    import numpy as np

    zero = dict.fromkeys(marks, 0.0)
    here = {**at, x: points}
    free = value(equation, {**here, **zero}) + 0 * points
    factors = [value(equation, {**here, **zero, mark: 1.0}) - free for mark in marks]
    twice = value(equation, {**here, **zero, marks[-1]: 2.0}) - free
    if not np.allclose(twice, 2 * factors[-1]):
        raise UnsupportedError
    with np.errstate(all="ignore"):
        b, a = (-factor / factors[-1] for factor in (factors[0], factors[-2]))
        g = -free / factors[-1]
    if not all(np.isfinite(part).all() for part in (a, b, g)):
        raise UnsupportedError
    turning = np.where(a**2 + 4 * b < 0, -b, 0)[1:]
    if len(marks) == 3 and (np.diff(points) ** 2 * turning).max() > RESOLVED**2:
        raise UnsupportedError  # an oscillation is not resolved
    steps = np.diff(points).tolist()
    rows = list(zip(a.tolist(), b.tolist(), g.tolist(), strict=True))
    found = [values[0]]
    y, v = values[0], values[-1]
    for k, h in enumerate(steps):  # the trapezoidal rule
        (a0, b0, g0), (a1, b1, g1), h = rows[k], rows[k + 1], h / 2
        if len(marks) == 2:
            y = (y * (1 + h * b0) + h * (g0 + g1)) / (1 - h * b1)
        else:
            p, r = y + h * v, v + h * (b0 * y + a0 * v + g0 + g1)
            v = (r + h * b1 * p) / (1 - h * a1 - h * h * b1)
            y = p + h * v
        found.append(y)
    result = np.array(found)
    if not np.isfinite(result).all():
        raise UnsupportedError
    return result


def swung(
    equation: Expr,
    marks: tuple[str, ...],
    at: Mapping[str, float],
    t: str,
    values: tuple[float, ...],
    end: float,
) -> tuple[list[float], list[float]]:
    """Return times from 0 to an end, and the solution of an initial value problem at them.

    Args:
        equation: an expression that is 0, linear in the last mark.
        marks: symbols for the function and its first, or first two, derivatives.
        at: values of the other variables.
        t: the variable.
        values: of the function, and of its derivative, at 0.
        end: the last time.

    Raises:
        UnsupportedError: there is no result.
    """
    steps = max(1, int(end / STEP))
    h = end / steps

    def right(time: float, state: tuple[float, ...]) -> tuple[float, ...]:
        here = {**at, t: time, **dict(zip(marks, state, strict=False))}
        free = value(equation, {**here, marks[-1]: 0.0})
        return (*state[1:], float(free / (free - value(equation, {**here, marks[-1]: 1.0}))))

    times, found, state = [0.0], [values[0]], values
    for k in range(steps):
        time = k * h
        one = right(time, state)
        two = right(time + h / 2, _moved(state, one, h / 2))
        three = right(time + h / 2, _moved(state, two, h / 2))
        four = right(time + h, _moved(state, three, h))
        rows = zip(state, one, two, three, four, strict=True)
        state = tuple(x + h / 6 * (a + 2 * b + 2 * c + d) for x, a, b, c, d in rows)
        if not math.isfinite(state[0]):
            raise UnsupportedError
        times.append(time + h)
        found.append(state[0])
    return times, found


def _moved(state: tuple[float, ...], slope: tuple[float, ...], h: float) -> tuple[float, ...]:
    return tuple(x + h * y for x, y in zip(state, slope, strict=True))


def _tridiagonal(
    low: list[float],
    middle: list[float],
    high: list[float],
    rest: list[float],
    values: tuple[float, float],
) -> list[float]:
    """Solve the equations for three neighbours each, by elimination."""
    rest[0] -= low[0] * values[0]
    rest[-1] -= high[-1] * values[1]
    try:
        for k in range(1, len(middle)):
            factor = low[k] / middle[k - 1]
            middle[k] -= factor * high[k - 1]
            rest[k] -= factor * rest[k - 1]
        y = [rest[-1] / middle[-1]]
        for k in range(len(middle) - 2, -1, -1):
            y.append((rest[k] - high[k] * y[-1]) / middle[k])
    except (ZeroDivisionError, OverflowError):
        raise UnsupportedError from None
    return y[::-1]
