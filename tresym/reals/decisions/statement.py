"""Statements: comparisons, the path and the conditions of a claim that was read."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, NamedTuple

from flint import fmpq

from tresym.reals.domain.conditions import Given
from tresym.reals.language.calls import FACTORIAL, INFINITY, INTEGERS
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    MINUS_ONE,
    ONE,
    ZERO,
    Expr,
    integer,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.parsing import Compared

if TYPE_CHECKING:
    pass


_ENDS = (INFINITY, -INFINITY)


class Derivative(NamedTuple):
    """A derivative that was written: of which function, by which variable, how often; its value."""

    function: Expr
    by: str
    order: int
    value: Expr


@dataclass(frozen=True)
class Comparison:
    """``left relation right``; for an order the right side is the gauge, for ``->`` the limit.

    Attributes:
        derivatives: those that were written: a derivative is one where its function is real, there
            and beside it.
        primitives: functions whose values at a point were written, as bodies of one variable: of an
            integral they may be antiderivatives.
    """

    left: Expr
    relation: str
    right: Expr
    derivatives: tuple[Derivative, ...] = ()
    primitives: tuple[Expr, ...] = ()

    @property
    def differentiated(self) -> tuple[Expr, ...]:
        """The functions whose derivatives were written."""
        return tuple(dict.fromkeys(found.function for found in self.derivatives))

    @property
    def by(self) -> frozenset[str]:
        """The variables by which."""
        return frozenset(found.by for found in self.derivatives)

    def solved(self, node: Expr) -> tuple[Expr, Expr] | None:
        """Solve the equation for ``node``; None if it is not linear in it.

        Returns:
            The value, and the coefficient that was divided by: where that is 0, the value says
            nothing, and the claim must be decided by itself.
        """
        mark = symbol("[S]")
        left, right = (replaced(side, {node: mark}) for side in (self.left, self.right))
        gap = left - right
        slope = differentiate(gap, "[S]")
        if "[S]" in symbols(slope) or slope == ZERO:
            return None
        rest = substitute(gap, {"[S]": ZERO})
        return rest * (-1 / slope), slope

    def mapped(self, change: Callable[[Expr], Expr]) -> Comparison:
        """The comparison of changed sides, their derivatives with them."""
        derivatives = (
            d._replace(function=change(d.function), value=change(d.value)) for d in self.derivatives
        )
        left, right = change(self.left), change(self.right)
        return replace(self, left=left, right=right, derivatives=tuple(derivatives))


@dataclass(frozen=True)
class Path:
    """A variable that tends to a point.

    Attributes:
        name: the variable.
        point: where it tends, None for infinity.
        sides: +1 for from above or to +∞, −1 for from below or to −∞.
        reach: the constant of an order is asked for where |x − point|, or 1/|x|, is at most this.
        together, points: the variables that tend to a point together, and the point; the name is
            then empty.
        expression: what tends there in place of the variable, such as a*b; a variable of it was
            eliminated.
    """

    name: str
    point: Expr | None
    sides: tuple[int, ...]
    reach: fmpq | None = None
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


@dataclass(frozen=True)
class Statement:
    """A claim as it was read.

    Attributes:
        comparisons: all of them are claimed.
        given: the conditions that are inequalities.
        path: for orders, limits, and what holds near its end alone.
        equations: the conditions that are equations, a pair of sides each.
        integers: the variables that take the values of integers alone.
        uniformly: whether one constant is asked for all values of the parameters.
        text: how it was written.
        read_as: the same in the grammar of expressions, conditions and path included.
    """

    comparisons: tuple[Comparison, ...]
    given: Given
    path: Path | None
    text: str
    read_as: str = ""
    equations: tuple[tuple[Expr, Expr], ...] = ()
    integers: tuple[str, ...] = ()
    uniformly: bool = False

    def __str__(self) -> str:
        return self.text

    @property
    def has_initial_values(self) -> bool:
        """Whether there are differential equations and values of their functions at a point."""
        nodes = [f for pair in self.equations for e in pair for f in functions(e)]
        slopes = {f.args[0].args[0]: f.args[1:] for f in nodes if any(f.args[0].args[1])}
        moving = {name for args in slopes.values() for e in args for name in symbols(e)}
        return any(
            f.args[0].args[0] in slopes and moving.isdisjoint(*map(symbols, f.args[1:]))
            for f in nodes
        )

    @property
    def implicit(self) -> bool:
        """Whether equations determine a variable as a function of that of the path."""
        path = self.path
        return (
            path is not None
            and bool(self.equations)
            and any(path.name in symbols(e) for e in self.said)
        )

    @property
    def said(self) -> list[Expr]:
        """Both sides of every condition."""
        pairs = (*((left, right) for left, _, right in self.given.comparisons), *self.equations)
        return [side for pair in pairs for side in pair]

    def mapped(self, change: Callable[[Expr], Expr]) -> Statement:
        """The statement under changed conditions, and where it tends to."""
        path = self.path
        if path is not None and path.point is not None:
            path = replace(path, point=change(path.point))
        equations = tuple((change(x), change(y)) for x, y in self.equations)
        return replace(self, given=self.given.mapped(change), equations=equations, path=path)

    @property
    def under(self) -> str:
        """The conditions as text, separated by commas."""
        equal = ((left, "==", right) for left, right in self.equations)
        whole = ((symbol(name), "in", INTEGERS) for name in self.integers)
        return chained((*self.given.comparisons, *equal, *whole))


def chained(comparisons: Iterable[Compared]) -> str:
    """Return comparisons as text, with a common side written once, as in ``0 < x <= 1``."""
    text = ""
    last: tuple[Expr | None, str] = (None, "")
    for left, relation, right in comparisons:
        goes_on = left is last[0] and relation[0] == last[1][0]
        joint = "" if goes_on else f"{', ' if text else ''}{left}"
        text += f"{joint} integer" if relation == "in" else f"{joint} {relation} {right}"
        last = right, relation
    return text


def functions(e: Expr) -> Iterator[Expr]:
    """Yield the applications of arbitrary functions in ``e``, such as f(x)."""
    if e.hidden:
        for arg in e.args:
            yield from functions(arg)
        if e.op == "unknown":
            yield e


def factorial_arguments(trees: Iterable[Expr]) -> list[Expr]:
    """Return the arguments of factorials without bound variables, also those inside sums.

    A claim says nothing where one of them is negative, even if it stands in an empty sum.
    """
    found: dict[Expr, None] = {}
    for e in trees:
        for node in functions(e):
            if node.args[0].args[0] == FACTORIAL and not node.args[1].loose:
                found[node.args[1]] = None
    return list(found)


def implied_integers(trees: Iterable[Expr], known: Iterable[str] = ()) -> tuple[str, ...]:
    """Return the variables that must be integers: in ends of sums, orders and factorials.

    Args:
        known: those that are integers already.
    """
    places = [place for e in trees for place in _integer_places(e)]
    found = dict.fromkeys(known)
    for _ in places:
        for e in places:
            new = sorted(symbols(e) - {*found})
            slopes = [differentiate(e, name) for name in sorted(symbols(e))]
            linear = all(slope in (ONE, MINUS_ONE) for slope in slopes)
            rest = integer(substitute(e, dict.fromkeys(symbols(e), ZERO)))
            if linear and len(new) == 1 and rest is not None:
                found[new[0]] = None
    return tuple(found)


def _integer_places(e: Expr) -> Iterator[Expr]:
    """What must be an integer where ``e`` has a value."""
    if not e.hidden:
        return
    if e.op in ("sum", "product"):
        yield from (end for end in e.args[1:] if not end.loose and end not in _ENDS)
    elif e.op == "nth":
        yield e.args[2]
    elif e.op == "unknown" and e.args[0].args[0] == FACTORIAL and not e.args[1].loose:
        yield e.args[1]
    for arg in e.args:
        yield from _integer_places(arg)
