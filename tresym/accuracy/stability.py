"""Find where double precision loses digits of an expression, and a form that loses fewer.

The expression is evaluated by numpy at a grid of double-precision points of a region in one or two
parameters, and compared with balls at exactly those points. The digits lost are 15.95 minus the
true digits. Where digits are lost by subtraction, a few rewritings are tried, each of which is
proved to be the same function by :func:`tresym.check`: 1 − cos u as 2 sin²(u/2), eᵘ − 1 as
2 sinh(u/2) e^(u/2), √a − √b as (a − b)/(√a + √b), log(1 + u) as 2 atanh(u/(2 + u)), and
differences of fractions on one denominator. The one with the least mean loss is the stable form.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

from flint import arb, fmpq

from tresym.accuracy.other_libraries import InDoubles, loaded
from tresym.accuracy.values import read
from tresym.checking import check
from tresym.reals.decisions.closed_values import certified_evaluation
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import UndefinedError
from tresym.reals.language.binders import elementary
from tresym.reals.language.expression import (
    LEAVES,
    MINUS_ONE,
    ONE,
    ZERO,
    Expr,
    add,
    apply,
    factors_in,
    multiply,
    number,
    power,
    replaced,
    symbols,
)
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError

DOUBLE = 53 * math.log10(2)
"""The decimal digits of double precision."""
PRECISIONS = (160, 640)
LINE, MAP = 240, 48
"""The number of points of a line, and along each side of a map."""
DECADES = 2.0
"""A range of more decades than these has a logarithmic scale."""
NEAR = 1e-12
"""The end that stands for an excluded 0."""
FAR = 1e12
TRIED = 12
SECONDS = 3.0


class Axis(NamedTuple):
    """One parameter: its name, its values, and whether its scale is logarithmic."""

    name: str
    values: tuple[float, ...]
    logarithmic: bool


class Form(NamedTuple):
    """An expression or a function with the digits lost at each point; NaN outside the region.

    Attributes:
        text: the expression, or the name of the function.
        lost: rows over the second parameter (one row if there is none), columns over the first.
        verdict: how a rewriting was proved to be the same function; empty for the first form.
    """

    text: str
    lost: tuple[tuple[float, ...], ...]
    verdict: str = ""

    @property
    def mean(self) -> float:
        """The mean number of digits lost."""
        known = [x for row in self.lost for x in row if not math.isnan(x)]
        return sum(known) / len(known) if known else math.nan

    @property
    def worst(self) -> float:
        """The largest number of digits lost."""
        return max((x for row in self.lost for x in row if not math.isnan(x)), default=math.nan)


class Stability(NamedTuple):
    """The digits that double precision loses over a region.

    Attributes:
        axes: one or two parameters.
        given: the region.
        forms: the expression as it was given, or the user's function; then the stable form, if one
            was found.
    """

    axes: tuple[Axis, ...]
    given: str
    forms: tuple[Form, ...]


def stability(expression: str | Expr, given: str, mine: str | None = None) -> Stability:
    """Measure the digits that double precision loses over a region.

    Args:
        expression: an elementary expression in one or two parameters.
        given: the region, such as ``"0 < x <= 1"``; every parameter needs a range, where 0 and
            infinity may be excluded ends.
        mine: a function of the user to measure in place of the expression.

    Raises:
        InputError: the expression is not of this kind, or the region has no points.
    """
    e = read(expression)
    names = sorted(symbols(e))
    if not elementary(e) or not 1 <= len(names) <= 2:
        raise InputError("stability: give an elementary expression in one or two parameters")
    region = Given.parse(given)
    axes = tuple(_axis(name, region, LINE if len(names) == 1 else MAP) for name in names)
    truth = _truth(e, axes, region)
    if all(ball is None for row in truth for ball in row):
        raise InputError("stability: the expression has no value at any point of the region")
    if mine is not None:
        function = loaded(mine)
        first = Form(mine, _lost(_of_function(function, axes), truth))
    else:
        first = Form(str(e), _lost(_of_expression(e, axes), truth))
    best: Form | None = None
    for other in _rewritings(e, region):
        answer = check(f"{e} == {other}", given, limit=SECONDS)
        if not answer.verdict.holds:
            continue
        form = Form(str(other), _lost(_of_expression(other, axes), truth), answer.verdict.value)
        if form.mean < (best or first).mean - 0.2:
            best = form
    return Stability(axes, given, (first,) if best is None else (first, best))


def _axis(name: str, region: Given, count: int) -> Axis:
    """Return the values of a parameter, on a logarithmic scale if it spans decades."""
    where = region.box.get(name)
    if where is None or where.low is None or (where.high is None and where.low < 0):
        raise InputError(f"stability: give a range of {name}, as in --given '0 < {name} <= 1'")
    low = float(int(where.low.p) / int(where.low.q))
    high = FAR if where.high is None else float(int(where.high.p) / int(where.high.q))
    if low == 0 and high > 0:
        low = NEAR * min(high, 1.0)
    logarithmic = low > 0 and math.log10(high / low) > DECADES
    steps = [(n + 0.5) / count for n in range(count)]
    if logarithmic:
        values = tuple(low * (high / low) ** s for s in steps)
    else:
        values = tuple(low + (high - low) * s for s in steps)
    return Axis(name, values, logarithmic)


def _points(axes: tuple[Axis, ...]) -> list[list[dict[str, float]]]:
    first, *second = axes
    rows = second[0].values if second else (None,)
    return [
        [{first.name: x} | ({second[0].name: y} if y is not None else {}) for x in first.values]
        for y in rows
    ]


def _truth(e: Expr, axes: tuple[Axis, ...], region: Given) -> list[list[arb | None]]:
    """Return a ball at every point of the region, None elsewhere."""
    return [[_ball(e, point, region) for point in row] for row in _points(axes)]


def _ball(e: Expr, point: dict[str, float], region: Given) -> arb | None:
    exact = {name: arb(x).fmpq() for name, x in point.items()}
    for precision in PRECISIONS:
        with ball_precision(precision):
            if not all(c.holds_exactly(exact) for c in region.conditions):
                return None
            try:
                found = certified_evaluation(exact).value(e)
            except UndefinedError:
                return None
            if found.rel_accuracy_bits() > 70:
                return found
    return None


def _of_expression(e: Expr, axes: tuple[Axis, ...]) -> list[list[float]]:
    import numpy as np

    points = _points(axes)
    names = points[0][0].keys()
    at = {name: np.array([[p[name] for p in row] for row in points]) for name in names}
    with np.errstate(all="ignore"):
        found = np.asarray(InDoubles(np, at).value(e), dtype=float) + 0 * next(iter(at.values()))
    return [[float(x) for x in row] for row in found]


def _of_function(function: Callable[..., Any], axes: tuple[Axis, ...]) -> list[list[float]]:
    def value(point: dict[str, float]) -> float:
        try:
            return float(function(**point))
        except (ArithmeticError, ValueError):
            return math.nan
        except TypeError as error:
            raise InputError(f"--mine: {' '.join(str(error).split())}") from None

    return [[value(point) for point in row] for row in _points(axes)]


def _lost(found: list[list[float]], truth: list[list[arb | None]]) -> tuple[tuple[float, ...], ...]:
    """Return the digits lost at each point: 0 to 15.95; NaN where there is no true value."""
    return tuple(tuple(map(_lost_at, row, balls)) for row, balls in zip(found, truth, strict=True))


def _lost_at(x: float, ball: arb | None) -> float:
    if ball is None:
        return math.nan
    if not math.isfinite(x):
        return DOUBLE
    with ball_precision(PRECISIONS[-1]):
        error = (abs(arb(x) - ball) / abs(ball)).upper()
        if error.is_zero() or error < arb((1, -53)):
            return 0.0
        return min(DOUBLE, max(0.0, DOUBLE + float(error.log().mid()) / math.log(10)))


# Rewritings


def _rewritings(e: Expr, region: Given) -> Iterator[Expr]:
    """Yield other forms of an expression, each once."""
    seen = {e}
    waiting = [e]
    while waiting and len(seen) <= TRIED:
        here = waiting.pop(0)
        for node in _nodes(here):
            for other in _forms(node):
                new = replaced(here, {node: other})
                if new not in seen:
                    seen.add(new)
                    waiting.append(new)
                    yield new
    try:
        plain = normal_form(e, region)
    except InputError:
        return
    if plain not in seen:
        yield plain


def _nodes(e: Expr) -> Iterator[Expr]:
    yield e
    if e.op not in LEAVES:
        for arg in e.args:
            yield from _nodes(arg)


def _forms(e: Expr) -> Iterator[Expr]:
    """Yield stable forms of a sum of two terms, or of log(1 + u)."""
    if e.op == "log" and e.args[0].op == "+":
        terms = e.args[0].args
        if ONE in terms:
            u = add(*(t for t in terms if t != ONE))
            yield 2 * apply("atanh", u / (2 + u))
    if e.op != "+":
        return
    for n, first in enumerate(e.args):
        for second in e.args[n + 1 :]:
            rest = add(*(t for t in e.args if t is not first and t is not second))
            for other in _of_two(first, second):
                yield other if rest == ZERO else add(other, rest)


def _of_two(first: Expr, second: Expr) -> Iterator[Expr]:
    for one, other in ((first, second), (second, first)):
        sign, head = _signed(one)
        if other.op == "number" and other.args[0] == -sign:
            if head.op == "cos":  # s(cos u − 1)
                yield -sign * 2 * apply("sin", head.args[0] / 2) ** 2
            if head.op == "cosh":
                yield sign * 2 * apply("sinh", head.args[0] / 2) ** 2
            if head.op == "exp":
                half = head.args[0] / 2
                yield sign * 2 * apply("sinh", half) * apply("exp", half)
        opposite, tail = _signed(other)
        if sign > 0 and opposite < 0:
            if _is_root(head) or _is_root(tail):
                u, v = (t.args[0] if _is_root(t) else t**2 for t in (head, tail))
                yield normal_or(u - v) / (head + tail)
            if head.op == tail.op == "exp":
                u, v = head.args[0], tail.args[0]
                yield 2 * apply("exp", (u + v) / 2) * apply("sinh", (u - v) / 2)
            if head.op == tail.op == "log":
                u, v = head.args[0], tail.args[0]
                yield 2 * apply("atanh", normal_or(u - v) / (u + v))
            if head.op == tail.op == "atan":
                u, v = head.args[0], tail.args[0]
                yield apply("atan", normal_or(u - v) / (1 + u * v))
            if head.op in ("sin", "cos") and head.op == tail.op:
                u, v = head.args[0], tail.args[0]
                half = normal_or(u - v) / 2
                if head.op == "sin":
                    yield 2 * apply("cos", (u + v) / 2) * apply("sin", half)
                else:
                    yield -2 * apply("sin", (u + v) / 2) * apply("sin", half)
        if _denominator(one) != ONE or _denominator(other) != ONE:
            yield normal_or(one + other)


def normal_or(e: Expr) -> Expr:
    """Return the normal form of an expression, or the expression itself."""
    try:
        return normal_form(e, Given())
    except InputError:
        return e


def _signed(e: Expr) -> tuple[int, Expr]:
    if e.op == "*" and e.args[0] == MINUS_ONE:
        return -1, multiply(*e.args[1:])
    return 1, e


def _is_root(e: Expr) -> bool:
    return e.op == "^" and e.args[1] == number(fmpq(1, 2))


def _denominator(e: Expr) -> Expr:
    factors = factors_in(e)
    return multiply(
        *(power(f, MINUS_ONE) for f in factors if f.op == "^" and f.args[1] == MINUS_ONE)
    )
