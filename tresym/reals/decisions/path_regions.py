"""Regions that reach to the end of a path, such as ``0 < e <= 1/2`` for ``e -> 0+``."""

from __future__ import annotations

from collections.abc import Iterable

from flint import fmpq

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.expansions.scale import T
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ZERO,
    Expr,
    apply,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import MIRRORED, Compared
from tresym.reals.language.paths import Path
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError

ORDERED = ("<", "<=", ">", ">=")
EXAMPLES = {0: "0 < {} <= 1/2", 1: "{} >= 10", -1: "{} <= -10"}


def along(path: Path, side: int) -> Expr:
    """Return the variable of the path in the small parameter t."""
    t = symbol(T)
    return side / t if path.point is None else path.point + side * t


def interval_of(region: Iterable[Compared]) -> tuple[str, Expr | None, Expr | None] | None:
    """Return the variable of conditions that are an interval, and its ends; None if they are not.

    Raises:
        InputError: no number satisfies the conditions.

    Example:
        >>> from tresym.reals.language.parsing import parse_conditions
        >>> [str(e) for e in interval_of(parse_conditions("abs(x - 1) <= pi"))]
        ['x', '-pi + 1', 'pi + 1']
    """
    given = Given(tuple(region))
    if len(given.names) != 1:
        return None
    (name,) = given.names
    ends: dict[int, Expr] = {}
    for left, sign, right in given.unfolded().comparisons:
        if sign not in ORDERED or name in symbols(left) & symbols(right):
            return None
        for side, relation, bound in ((left, sign, right), (right, MIRRORED[sign], left)):
            if name not in symbols(side):
                continue
            shift = normal_form(side - symbol(name), Given())
            if symbols(shift):
                return None
            end, way = bound - shift if shift != ZERO else bound, 1 if relation[0] == "<" else -1
            with ball_precision():
                kept = ends.get(way)
                if kept is None or way * (evaluate(end, {}) - evaluate(kept, {})) < 0:
                    ends[way] = end
    low, high = ends.get(-1), ends.get(1)
    with ball_precision():
        if low is not None and high is not None and evaluate(low, {}) > evaluate(high, {}):
            raise InputError(f"{given}: no number satisfies these conditions")
    return name, low, high


def reaches_end(region: Iterable[Compared], path: Path) -> bool:
    """Return whether an interval lies on every side of the end of a path, as x > 0 for x -> oo."""
    found = interval_of(region)
    if found is None or found[0] != path.name:
        return False
    _, low, high = found
    if path.point is None:
        return (high if path.sides == (1,) else low) is None
    with ball_precision():
        at = evaluate(path.point, {})
        return all(
            end is None or side * (evaluate(end, {}) - at) > 0
            for side, end in ((1, high), (-1, low))
            if side in path.sides
        ) and all(
            end is None or side * (evaluate(end, {}) - at) >= 0 or end == path.point
            for side, end in ((1, high), (-1, low))
            if side not in path.sides
        )


def conditions_of(region: str) -> tuple[Compared, ...]:
    """Return the conditions that the region of an answer consists of, ``|x|`` read as abs(x).

    Example:
        >>> conditions_of("0 < |x - 1| <= 1/2")[1]
        (Expr('abs(x - 1)'), '<=', Expr('1/2'))

    Raises:
        InputError: the region is said in words.
    """
    while region.count("|") >= 2:
        before, inside, after = region.split("|", 2)
        region = f"{before}abs({inside}){after}"
    return Given.parse(region).comparisons


def reach_of(region: Iterable[Compared], path: Path) -> fmpq:
    """Return the largest value of the small parameter of a path in a region.

    Raises:
        InputError: the conditions are no region that reaches to the end of the path.
    """
    example = f"abs({path.name} - {path.point}) <= 1/2"
    if path.point is None or path.point == ZERO:
        example = EXAMPLES[0 if path.point == ZERO else path.sides[0]].format(path.name)
    wrong = InputError(f"write a region that reaches the end of the path, such as {example}")
    reaches: dict[int, fmpq] = {}
    for link in region:
        for side in path.sides:
            bound = _bound(link, path, side, wrong)
            if bound is not None:
                reaches[side] = min(bound, reaches.get(side, bound))
    if set(reaches) != set(path.sides) or len({*reaches.values()}) > 1:
        raise wrong  # on both sides of a point the region is symmetric
    return next(iter(reaches.values()))


def _bound(link: Compared, path: Path, side: int, wrong: InputError) -> fmpq | None:
    """Return what a condition says of the small parameter on a side; None if nothing."""
    left, relation, right = link
    if relation in (">", ">="):
        left, right = right, left
    elif relation not in ("<", "<="):
        raise wrong
    if path.point is not None:
        distance = apply("abs", symbol(path.name) - path.point)
        left, right = (symbol(T) if e == distance else e for e in (left, right))
    put = along(path, side) if path.point is not None else side * symbol(T)
    gap = substitute(left - right, {path.name: put})  # is negative in the region
    a, b = (_value(e) for e in (substitute(gap, {T: ZERO}), differentiate(gap, T)))
    if a is None or b is None:
        raise wrong
    if path.point is None:  # T stands for |x|, which is large
        if b < 0:
            return -b / a if a > 0 else None
    elif a < 0:
        return -a / b if b > 0 else None
    elif a == 0 and b < 0:
        return None
    raise wrong


def _value(e: Expr) -> fmpq | None:
    form = normal_form(e, Given())
    return form.args[0] if form.op == "number" else None
