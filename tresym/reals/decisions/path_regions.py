"""Regions that reach to the end of a path, such as ``0 < e <= 1/2`` for ``e -> 0+``."""

from __future__ import annotations

from collections.abc import Iterable

from flint import fmpq

from tresym.reals.domain.conditions import Given
from tresym.reals.expansions.scale import T
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ZERO,
    Expr,
    apply,
    substitute,
    symbol,
)
from tresym.reals.language.formula import Compared
from tresym.reals.language.paths import Path
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.exact import InputError

EXAMPLES = {0: "0 < {} <= 1/2", 1: "{} >= 10", -1: "{} <= -10"}


def along(path: Path, side: int) -> Expr:
    """Return the variable of the path in the small parameter t."""
    t = symbol(T)
    return side / t if path.point is None else path.point + side * t


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
