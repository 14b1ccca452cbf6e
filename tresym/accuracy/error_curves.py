"""The errors of several approximations along a path, for a chart.

The points are certified; floating point enters only where a position in the picture is computed
from a ball.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from flint import fmpq

from tresym.accuracy.error_table import ErrorTable, error_table
from tresym.accuracy.sampled import sampled_table
from tresym.accuracy.values import Exact, certified, constant
from tresym.reals.decisions.path_regions import conditions_of
from tresym.reals.domain.conditions import Given
from tresym.reals.language.expression import substitute
from tresym.reals.language.parsing import parse
from tresym.reals.language.paths import Path, read_path
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError

STEPS = tuple(fmpq(m, 10**k) for k in range(1, 5) for m in (10, 5, 2))
"""The distances from the end of the path: 1, 1/2, 1/5, 1/10, …."""
DIGITS = 12


class ErrorCurve(NamedTuple):
    """One approximation: its table, the points (x, |error|), and the proved bound as a line."""

    table: ErrorTable
    points: tuple[tuple[float, float], ...]
    bound: tuple[tuple[float, float], ...]


def error_curves(
    exact: str,
    approximations: Sequence[str],
    path: str,
    at: Sequence[Exact] = (),
    given: str = "",
    order: str | None = None,
    region: str = "",
) -> list[ErrorCurve]:
    """Return the errors of several approximations.

    Args:
        exact: the exact expression.
        approximations: the approximate ones.
        path, at, given, order, region: as for :func:`tresym.error_table`; without ``at``, points
            along the path at which the expressions have values.

    Raises:
        InputError: as for :func:`tresym.error_table`.
    """
    points = list(at) or _points_along(read_path(path))
    found = []
    for approx in approximations:
        kept = [x for x in points if at or has_value(exact, approx, path, x, given)]
        if not kept:
            kept = points[:1]  # for its message
        table = error_table(exact, approx, path, kept, given, DIGITS, order, region)
        found.append(ErrorCurve(table, tuple(_points(table)), tuple(_bound(table))))
    return found


def _points_along(way: Path) -> list[Exact]:
    side = way.sides[0]
    points: list[Exact] = [str(side / step if way.point is None else side * step) for step in STEPS]
    if way.point is not None:
        points = [way.point + constant(x, way.name) for x in points]
    return points


def sampled_points(
    function: str, exact: str, path: str, at: Sequence[Exact] = (), given: str = ""
) -> list[tuple[float, float]]:
    """Return the errors of a function of the user as points (distance from the end, |error|).

    Args:
        function: ``file.py:function`` or ``module:function``.
        exact, path, at, given: as for :func:`error_curves`.

    Raises:
        InputError: as for :func:`tresym.accuracy.sampled.sampled_table`.
    """
    way = read_path(path)
    points = [x for x in at or _points_along(way) if at or has_value(exact, exact, path, x, given)]
    table = sampled_table(function, exact, points, way.name, given)
    rows = [(x, row.error) for x, row in zip(points, table.rows, strict=True)]
    sizes = [(_distance(path, x), abs(float(e.mid))) for x, e in rows if e is not None]
    return [(x, size) for x, size in sizes if size > 0]


def has_value(exact: str, approx: str, path: str, x: Exact, given: str = "") -> bool:
    """Whether both expressions have certified values at a point of a path."""
    try:
        error_table(exact, approx, path, [x], given, DIGITS, decide=False)
    except InputError:
        return False
    return True


def _distance(path: str, x: Exact) -> float:
    way = read_path(path)
    gap = constant(x, way.name)
    if way.point is not None:
        gap = gap - way.point
    return abs(float(certified(gap, 12).mid()))


def _points(table: ErrorTable) -> list[tuple[float, float]]:
    rows = [(row.at, row.error) for row in table.rows if row.error is not None]
    found = []
    for at, error in rows:
        (x,) = at.values()
        size = abs(float(error.mid))
        if size > 0:
            found.append((_distance(table.path, x), size))
    return found


def _bound(table: ErrorTable) -> list[tuple[float, float]]:
    """Return the line high·|gauge| at the points of the region."""
    if table.constant is None:
        return []
    way = read_path(table.path)
    gauge, high = parse(table.gauge), float(table.constant.high)
    inside = Given(conditions_of(table.constant.region))
    found = []
    for row in table.rows:
        (text,) = row.at.values()
        x = constant(text, way.name)
        with ball_precision():
            value = certified(x, 15)
            fits = all(c.holds_exactly({way.name: value}) for c in inside.conditions)
        if fits:
            size = abs(float(certified(substitute(gauge, {way.name: x}), 12).mid()))
            found.append((_distance(table.path, text), high * size))
    return sorted(found)
