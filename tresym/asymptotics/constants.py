"""Enclose the constant of an order from both sides: the supremum of a ratio on a region.

``exact == approx + O(gauge)`` on a region has as its best constant the supremum of
|exact − approx|/|gauge| there. It is computed by Taylor coefficients with remainders in balls (see
:mod:`tresym.reals.expansions.suprema`), to one per cent. Example: for ``tanh(x) == x - x**3/3 +
O(x**5) as x -> 0`` on ``0 < abs(x) <= 1`` it is 2/15, which the ratio approaches as x → 0.

A region reaches to the end of the path: ``0 < e <= 1/2`` for ``e -> 0+``, ``x >= 10`` for ``x ->
oo``, ``abs(x - 1) <= 1/4`` for ``x -> 1``.
"""

from __future__ import annotations

from dataclasses import replace
from decimal import Decimal
from typing import NamedTuple

from flint import arb, fmpq

from tresym.asymptotics.order_claims import region as region_text
from tresym.reals.decisions.path_regions import along, reach_of
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.expansions.leading_terms import sharp_constant
from tresym.reals.expansions.suprema import SHORTER, Supremum
from tresym.reals.language.binders import elementary
from tresym.reals.language.expression import (
    Expr,
    substitute,
    symbols,
)
from tresym.reals.language.parsing import parse, parse_given
from tresym.reals.language.paths import Path, read_path
from tresym.reals.numbers.arithmetic import ball_precision

LONGEST = fmpq(1)
"""The longest range in the small parameter that is tried if no region is asked for."""
DIGITS = 6


class Constant(NamedTuple):
    """The best constant of an order on a region.

    Attributes:
        low, high: decimal bounds of the supremum, rounded outward; ``high`` is the constant to
            quote, at most 2 % above the supremum.
        region: where it holds, as a condition on the variable of the path.
        where: a point at which the ratio is at least ``low``, or the end of the path.
    """

    low: str
    high: str
    region: str
    where: str


def constant(
    difference: Expr | str, gauge: Expr | str, path: Path | str, region: str = ""
) -> Constant | None:
    """Return the best constant of ``difference == O(gauge)`` along a path.

    Args:
        difference: exact minus approximate expression, in the variable of the path alone.
        gauge: the comparison function.
        path: such as ``"x -> 0+"``.
        region: such as ``"0 < x <= 1/2"``. If it is empty, the longest of a few ranges is chosen
            on which the supremum is found.

    Returns:
        The constant, or None if the order is not shown or the supremum is not found.

    Raises:
        InputError: the text cannot be parsed, or the region does not reach the end of the path.

    Example:
        >>> constant("tan(x) - x", "x**3", "x -> 0+", "0 < x <= 1").high
        '0.557603'
    """
    f, g = (parse(e) if isinstance(e, str) else e for e in (difference, gauge))
    path = read_path(path) if isinstance(path, str) else path
    if (symbols(f) | symbols(g)) - {path.name} or not elementary(f, g):
        return None
    asked = reach_of(parse_given(region), path) if region else path.reach
    found: list[tuple[int, Supremum]] = []
    reach = asked or LONGEST
    for side in path.sides:
        put = {path.name: along(path, side)}
        left, right = (substitute(e, put) for e in (f, g))
        one = sharp_constant(left, right, reach, 0 if asked else SHORTER)
        if one is None:
            return None
        if one.upto < reach and found:  # the other side again, on the shorter range
            return constant(f, g, replace(path, reach=one.upto))
        reach = one.upto
        found.append((side, one))
    return as_constant(found, path, reach)


def as_constant(found: list[tuple[int, Supremum]], path: Path, reach: fmpq) -> Constant:
    """Return the suprema on the sides of a path as one constant."""
    side, best = max(found, key=lambda item: float(item[1].low.mid()))
    high = max((one.high for _, one in found), key=lambda x: float(x.mid()))
    where = f"as {replace(path, sides=(side,))}"
    if best.at is not None:
        with ball_precision():
            at = -best.at if side < 0 else best.at
            shown = 1 / at if path.point is None else at
            start = arb(0) if path.point is None else evaluate(path.point, {})
            where = f"{path.name} = {_short(start + shown)}"
    return Constant(_down(best.low), _up(high), region_text(path, reach), where)


def _short(x: arb) -> str:
    """Return a number in decimal with few digits."""
    return x.str(8, radius=False)


def _up(x: arb) -> str:
    return rounded(x, 1)


def _down(x: arb) -> str:
    return rounded(x, -1)


def rounded(x: arb, side: int) -> str:
    """Return a bound in decimal with few digits, rounded to the side that keeps it one."""
    with ball_precision():
        if x.is_zero():
            return "0"
        end = x.upper() if side > 0 else x.lower()
        places = DIGITS - 1 - int(float(abs(end).log().mid()) // 2.302585092994046)
        scaled = end * arb(10) ** places
        digits = scaled.ceil() if side > 0 else scaled.floor()
        whole = digits.upper().fmpq() if side > 0 else digits.lower().fmpq()
        n = int(whole.p // whole.q)
        return format(Decimal(n).scaleb(-places).normalize(), "f")
