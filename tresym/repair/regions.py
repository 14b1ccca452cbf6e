"""List natural parts of the line and plane on which a claim may hold that fails elsewhere."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations

from tresym.reals.language.expression import symbols
from tresym.reals.language.formula import Compared
from tresym.reals.language.parsing import parse_given
from tresym.repair.floating import Points
from tresym.repair.samples import held, satisfied

_LINE: tuple[str, ...] = (
    "{x} != 0",
    "{x} >= 0",
    "{x} > 0",
    "{x} <= 0",
    "{x} < 0",
    "abs({x}) <= 1",
    "abs({x}) < 1",
)
_LINE += ("{x} >= 1", "{x} > 1", "abs({x}) >= 1", "abs({x}) > 1", "{x} <= 1", "{x} < 1", "{x} != 1")
_LINE += ("{x} >= -1", "{x} > -1", "-pi/2 < {x}, {x} < pi/2", "-pi/2 <= {x}, {x} <= pi/2")
_LINE += ("0 < {x}, {x} < pi", "0 <= {x}, {x} <= pi", "-pi < {x}, {x} < pi", "0 < {x}, {x} < pi/2")
_LINE += ("0 <= {x}, {x} <= 1", "0 < {x}, {x} < 1")
_WHOLE = ("{x} >= 0", "{x} >= 1", "{x} >= 2", "{x} != 0")
_PLANE: tuple[str, ...] = (
    "{x} <= {y}",
    "{x} < {y}",
    "{y} <= {x}",
    "{y} < {x}",
    "{x} != {y}",
    "{x} + {y} != 0",
)
_PLANE += ("{x} + {y} >= 0", "{x} + {y} > 0", "{x}*{y} > 0", "{x}*{y} >= 0", "{x}*{y} < 1")
_ALL = ("{x} > 0", "{x} >= 0")
FEWEST = 3
"""The least number of points of a region at which the claim must be seen to hold."""


def regions(names: Sequence[str], integers: Sequence[str]) -> Iterator[str]:
    """Yield conditions on these variables, as text."""
    for name in names:
        for text in _WHOLE if name in integers else _LINE:
            yield text.format(x=name)
    for x, y in combinations(names, 2):
        for text in _PLANE:
            yield text.format(x=x, y=y)
    for text in _ALL if len(names) > 1 else ():
        yield ", ".join(text.format(x=name) for name in names)


def holding(comparisons: Sequence[Compared], points: Points, integers: Sequence[str]) -> list[str]:
    """Return the conditions under which comparisons are seen to hold, the most general first.

    Raises:
        UnsupportedError: a side cannot be evaluated in floating point.
    """
    rows = [held(points, link) for link in comparisons]
    seen = [_together(column) for column in zip(*rows, strict=True)]
    if seen.count(True) < FEWEST or False not in seen:
        return []
    spoken = frozenset().union(*(symbols(a) | symbols(b) for a, _, b in comparisons))
    names = sorted(spoken & points.at.keys())
    found: list[tuple[int, str]] = []
    for text in regions(names, integers) if len(names) <= 4 else ():
        inside = satisfied(points, parse_given(text))
        values = [value for value, within in zip(seen, inside, strict=True) if within]
        if False not in values and values.count(True) >= FEWEST:
            found.append((-sum(inside), text))
    return [text for _, text in sorted(found, key=lambda pair: pair[0])]


def _together(values: Sequence[bool | None]) -> bool | None:
    if None in values:
        return None
    return all(values)
