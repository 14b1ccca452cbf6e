r"""An order beside a printed range: ``1/(1 - x) = 1 + O(x), 0 < x \le 1/2`` has one constant there.

An order without a path has one that its terms suggest, x → 0 for O(x). A range that the display or
its sentence states then says more than the path: the constant serves on all of it, so it becomes
the region of the claim, and it may tell the side. ``1/x = O(1), x \ge 1`` is an order as x → ∞. A
range that reaches no end of a path is not understood, rather than dropped.
"""

from __future__ import annotations

from collections.abc import Sequence

from tresym.manuscript.mentions import names_in
from tresym.reals.decisions.path_regions import reach_of
from tresym.reals.language.expression import ZERO, symbol
from tresym.reals.language.formula import Compared, chained
from tresym.reals.language.parsing import parse
from tresym.reals.language.paths import read_path
from tresym.reals.numbers.exact import InputError

_BOUNDS = frozenset(("<", "<=", ">", ">="))


def path_on_range(path: str, stated: bool, conditions: Sequence[Compared]) -> str | None:
    """Return the path of an order with the range that its display states; None if that is no end.

    Args:
        path: the path, as in ``x -> 0``.
        stated: whether the text says the path; else it was guessed from the terms.
        conditions: what the display and its sentence state.

    Example:
        >>> from tresym.reals.language.parsing import parse_given
        >>> path_on_range("x -> 0", False, parse_given("0 < x, x <= 1/2"))
        'x -> 0+ on 0 < x <= 1/2'
        >>> path_on_range("x -> 0", True, parse_given("x > 0"))
        'x -> 0+'
        >>> path_on_range("x -> 0", False, parse_given("x > 0")) is None
        True
        >>> path_on_range("x -> 0", False, parse_given("x >= 1"))
        'x -> oo on x >= 1'
    """
    name, _, end = path.partition(" -> ")
    own = [link for link in conditions if name in names_in((link,)) and link[1] != "in"]
    if not own:
        return path
    region = list(dict.fromkeys(own))
    if names_in(region) != {name} or not all(link[1] in _BOUNDS for link in region):
        return None
    x, sides = symbol(name), [side for side in "+-" if _is_beyond(region, name, end, side)]
    ends = [end, *(f"{end}{side}" for side in sides)]
    if not stated:
        ends += [far for far in ("oo", "-oo") if far != end]
    for to in ends:
        try:
            reach_of(region, read_path(f"{name} -> {to}"))
        except InputError:
            continue
        return f"{name} -> {to} on {chained(region)}"
    half_line = all({link[0], link[2]} == {x, ZERO} for link in region)
    if not (stated and half_line and len(sides) == 1):
        return None
    return f"{path}{sides[0]}" if end == "0" else path


def _is_beyond(region: Sequence[Compared], name: str, end: str, side: str) -> bool:
    """Return whether the range is said to lie on one side of the end of the path, or of 0."""
    point = ZERO if end.endswith("oo") else parse(end.rstrip("+-"))
    if end.endswith("+-".replace(side, "")):
        return False
    x, above = symbol(name), ">" if side == "+" else "<"
    below = "<" if side == "+" else ">"
    return any(
        (left, right, relation[0]) in ((x, point, above), (point, x, below))
        for left, relation, right in region
    )
