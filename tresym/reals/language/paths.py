"""Paths: a variable that tends to a point, as in ``x -> 0+``, ``a*b -> oo``, ``(x, y) -> (0, 0)``.

Example:
    >>> path = read_path("x -> pi/2-")
    >>> path.name, str(path.point), path.sides
    ('x', 'pi/2', (-1,))
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING

from flint import fmpq

from tresym.reals.language.binders import elementary
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.expression import ZERO, Expr, symbol, symbols
from tresym.reals.language.parsing import parse
from tresym.reals.language.unicode_input import plain
from tresym.reals.numbers.exact import InputError

if TYPE_CHECKING:
    from tresym.reals.language.formula import Compared
    from tresym.reals.language.latex import Relations

MAX_PATH = 200
_PATH = re.compile(r"\s*([A-Za-z_]\w*)\s*->\s*(.+?)\s*")
_TOGETHER = re.compile(r"\s*\(([\w\s,]+)\)\s*->\s*\((.+)\)\s*")
_SEVERAL_WORDS = re.compile(r"\w\s+\w|\w[+-]\s+[^\W\d]")
"""Words beside one another, and a name behind the side of the end, as in ``0+ uniformly``."""
_INFINITE = re.compile(r"([-+]?)(?:oo|inf|infinity)")
_CONSTANTS = frozenset(("E", "I", "pi", "oo", "EulerGamma", "Catalan", "GoldenRatio"))
_SIDES = {"+": (1,), "-": (-1,), "": (1, -1)}


@dataclass(frozen=True)
class Path:
    """A variable that tends to a point.

    Attributes:
        name: the variable.
        point: where it tends, None for infinity.
        sides: +1 for from above or to +∞, −1 for from below or to −∞.
        reach: the constant of an order is asked for where |x − point|, or 1/|x|, is at most this.
        region: conditions under which it is asked for instead, where they are an interval of
            another kind that reaches the end, as x > 0 for x -> oo, or abs(x) <= pi/2 for x -> 0.
        together, points: the variables that tend to a point together, and the point; the name is
            then empty.
        expression: what tends there in place of the variable, such as a*b; a variable of it was
            eliminated.
    """

    name: str
    point: Expr | None
    sides: tuple[int, ...]
    reach: fmpq | None = None
    region: tuple[Compared, ...] = ()
    together: tuple[str, ...] = ()
    points: tuple[Expr, ...] = ()
    expression: Expr | None = None

    def __str__(self) -> str:
        if self.together:
            return f"({', '.join(self.together)}) -> ({', '.join(map(str, self.points))})"
        name = self.name if self.expression is None else str(self.expression)
        side = "" if len(self.sides) > 1 else "+-"[self.sides[0] < 0]
        end = f"{self.point}{side}" if self.point is not None else f"{side.strip('+')}oo"
        return f"{name} -> {end}"


def read_path(text: str) -> Path:
    """``x -> 0``, ``0+``, ``0-``, ``pi/2``, ``oo`` or ``-oo``, for any variable and any constant.

    Raises:
        InputError: anything else.
    """
    match = _PATH.fullmatch(plain(text)) if len(text) <= MAX_PATH else None
    several = _TOGETHER.fullmatch(plain(text)) if len(text) <= MAX_PATH else None
    if several is not None:
        return _several(several[1], several[2])
    if match is None and len(text) <= MAX_PATH and plain(text).count("->") == 1:
        left, _, right = plain(text).partition("->")
        what = parse(left)
        far = _INFINITE.fullmatch(right.replace(" ", ""))
        if symbols(what) and far is not None and not far[1].startswith("-") and elementary(what):
            return Path("", None, (1,), expression=what)
    if match is None or _SEVERAL_WORDS.search(match[2]):
        raise InputError("write a path like x -> 0+ (or 0, 0-, 1/2, pi, oo, -oo)")
    name, end = match[1], match[2].replace(" ", "")
    infinite = _INFINITE.fullmatch(end)
    if infinite:
        return ending(name, -INFINITY if infinite[1] == "-" else INFINITY, "")
    side = end[-1:] if end.endswith(("+", "-")) else ""
    return ending(name, parse(end.removesuffix(side).removesuffix("^") if side else end), side)


def _several(names: str, points: str) -> Path:
    """Return the path of several variables that tend to a point together."""
    variables = tuple(name.strip() for name in names.split(","))
    ends = tuple(parse(part) for part in points.split(","))
    if len({*variables}) < len(variables) or len(ends) != len(variables) or len(ends) < 2:
        raise InputError("write a path in several variables like (x, y) -> (0, 0)")
    if not all(name.isidentifier() and symbol(name) == parse(name) for name in variables):
        raise InputError("write a path in several variables like (x, y) -> (0, 0)")
    for name in variables:
        ending(name, ZERO, "")
    if any(symbols(e) or not elementary(e) for e in ends):
        raise InputError("a path in several variables must end at constants")
    return Path("", ZERO, (1,), together=variables, points=ends)


def path_in_latex(chain: Relations) -> Path:
    """A path that LaTeX states as ``x \\to 0^+``."""
    if len(chain.ops) != 1 or not chain.ops[0].startswith("->") or chain.terms[0].op != "symbol":
        raise InputError("LaTeX: write a path like x \\to 0^+")
    return ending(str(chain.terms[0]), chain.terms[1], chain.ops[0][2:])


def ending(name: str, point: Expr, side: str) -> Path:
    """Return the path of one variable to a point or to infinity, from the side "+", "-" or both."""
    if name in _CONSTANTS:
        raise InputError(f"{name} is a constant and tends nowhere: name the variable differently")
    if point in (INFINITY, -INFINITY):
        return Path(name, None, (1 if point == INFINITY else -1,))
    if name in symbols(point) or not elementary(point):
        raise InputError("a path must end at a constant, at a parameter or at oo")
    return Path(name, point, _SIDES[side])
