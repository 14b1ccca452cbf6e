"""Sample floating-point points that satisfy the conditions of a claim, and test relations there."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from tresym.reals.domain.conditions import Given
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.expression import Expr, substitute, symbols
from tresym.reals.language.formula import Compared
from tresym.repair.floating import Points, Row, UnsupportedError

_LINE: tuple[float, ...] = (
    0.37,
    1.71,
    -0.62,
    2.43,
    -1.31,
    0.83,
    3.19,
    -2.77,
    0.14,
    5.9,
    -0.21,
    1.13,
)
_LINE += (12.3, 0.55, -4.6, 2.05, -0.87, 0.71, -6.4, 4.4, 0.29, 1.37)
"""The values of an unbounded variable: in (0, 1), in (1, 2.5), negative and large."""
_SPECIAL = (0.0, 1.0, -1.0)
_SHARES = (0.37, 0.71, 0.13, 0.55, 0.91, 0.24, 0.83, 0.04, 0.62, 0.47)
_WHOLE = (1, 2, 3, -1, 4, 0, -2, 5, 6, -3, 7)
TRIES = 240
CLOSE, TINY = 1e-8, 1e-12


def sampled(
    names: Sequence[str], given: Sequence[Compared], most: int, largest: float = math.inf
) -> Points | None:
    """Return at most ``most`` points that satisfy the conditions, or None if none is found.

    Args:
        names: the variables.
        given: the conditions.
        most: the maximal number of points.
        largest: the largest value, unless a condition requires larger ones.

    Raises:
        UnsupportedError: a condition cannot be evaluated in floating point.
    """
    integers = {str(left) for left, relation, _ in given if relation == "in"}
    values, rest = _put_in([link for link in given if link[1] != "in"])
    bounds = Given(tuple(link for link in rest if link[1] != "==")).unfolded()
    free = sorted({*names, *_names(rest)} - values.keys())
    if not free and not values:
        return Points({})
    pools = [_pool(bounds, name, name in integers) for name in free]
    pools = [[x for x in pool if abs(x) <= largest] or pool for pool in pools]
    rows: list[Mapping[str, float]] = []
    for k in range(TRIES):
        at = {
            name: pool[(k * (1 + 2 * j) + 3 * j + k // len(pool)) % len(pool)]
            for j, (name, pool) in enumerate(zip(free, pools, strict=True))
        }
        here = _with(values, at)
        if here is not None and here not in rows and satisfied(Points(_single(here)), rest)[0]:
            rows.append(here)
            if len(rows) == most:
                break
    if not rows:
        exact = bounds.points(free, most) if not integers and not values else ()
        rows = [{name: int(v.p) / int(v.q) for name, v in point.items()} for point in exact]
    if not rows:
        return None
    return Points({name: [row[name] for row in rows] for name in rows[0]})


def _single(here: Mapping[str, float]) -> dict[str, list[float]]:
    return {name: [value] for name, value in here.items()}


def _names(links: Sequence[Compared]) -> frozenset[str]:
    sides = (side for left, _, right in links for side in (left, right))
    return frozenset().union(*map(symbols, sides)) - symbols(INFINITY)


def _put_in(given: Sequence[Compared]) -> tuple[dict[str, Expr], list[Compared]]:
    """Return the values of symbols that equations state, and the other conditions."""
    values: dict[str, Expr] = {}
    rest: list[Compared] = []
    for left, relation, right in given:
        one, other = substitute(left, values), substitute(right, values)
        for side, value in ((one, other), (other, one)):
            name = str(side)
            if relation == "==" and side.op == "symbol" and name not in symbols(value):
                values = {n: substitute(v, {name: value}) for n, v in values.items()}
                values[name] = value
                break
        else:
            rest.append((left, relation, right))
    return values, rest


def _with(values: Mapping[str, Expr], at: Mapping[str, float]) -> dict[str, float] | None:
    here, points = dict(at), Points(_single(at), 1)
    for name, value in values.items():
        (here[name],) = points.values(value)
    return here if all(map(math.isfinite, here.values())) else None


def _pool(given: Given, name: str, whole: bool) -> list[float]:
    """Return the values that are tried for a variable, by its bounds."""
    where = given.box.get(name)
    low, high = (None, None) if where is None else (where.low, where.high)
    if whole:
        least = None if low is None else math.ceil(int(low.p) / int(low.q))
        if least is None:
            return [float(n) for n in _WHOLE]
        return [float(least + n) for n in range(7)]
    ends = [None if end is None else int(end.p) / int(end.q) for end in (low, high)]
    found = [*_LINE]
    if ends[0] is not None and ends[1] is not None:
        found = [ends[0] + (ends[1] - ends[0]) * share for share in (*_SHARES, 0.0, 1.0)]
    elif ends[0] is not None:
        found = [*(ends[0] + abs(x) for x in _LINE), ends[0]]
    elif ends[1] is not None:
        found = [*(ends[1] - abs(x) for x in _LINE), ends[1]]
    return [*found, *(x for x in _SPECIAL if x not in found and _within(x, ends))]


def _within(x: float, ends: Sequence[float | None]) -> bool:
    low, high = ends
    return (low is None or low <= x) and (high is None or x <= high)


def satisfied(points: Points, given: Sequence[Compared]) -> list[bool]:
    """Return for each point whether all conditions hold."""
    found = [True] * points.count
    for link in given:
        if link[1] == "in":
            continue
        for n, holds in enumerate(held(points, link)):
            found[n] = found[n] and holds is True
    return found


def held(points: Points, link: Compared, close: float = CLOSE) -> list[bool | None]:
    """Return for each point whether a comparison holds; None if a side has no value.

    Raises:
        UnsupportedError: a side cannot be evaluated in floating point.
    """
    left, relation, right = link
    rows = points.values(left), points.values(right)
    return [_holds(x, relation, y, close) for x, y in zip(*rows, strict=True)]


def _holds(x: float, relation: str, y: float, close: float) -> bool | None:
    if not (math.isfinite(x) and math.isfinite(y)):
        return None
    gap, near = x - y, close * max(abs(x), abs(y)) + TINY
    if close > CLOSE:
        near += close
    if relation in ("==", "~"):
        return abs(gap) <= near
    if relation == "!=":
        return abs(gap) > near
    if relation in ("<=", ">="):
        return gap <= near if relation == "<=" else gap >= -near
    if relation in ("<", ">"):
        return gap < 0 if relation == "<" else gap > 0
    raise UnsupportedError(relation)


def near_end(points: Points, name: str, end: Expr, side: int, step: float) -> Points:
    """Return the points with one variable near the end of its path."""
    at = {other: row for other, row in points.at.items() if other != name}
    if end in (INFINITY, -INFINITY):
        sign = 1 if end == INFINITY else -1
        places: Row = [sign / step] * points.count
    else:
        places = [x + (side or 1) * step for x in points.values(end)]
    return Points({**at, name: places})
