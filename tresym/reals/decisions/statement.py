"""Statements: comparisons, the path and the conditions of a claim that was read."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from math import lcm

from flint import fmpq, fmpz_mat

from tresym.reals.domain.conditions import Given, linear_form
from tresym.reals.language.calls import FACTORIAL, INFINITY, INTEGERS
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    MINUS_ONE,
    ONE,
    ZERO,
    Expr,
    integer,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import chained
from tresym.reals.language.parsing import without_order
from tresym.reals.language.paths import Path

_ENDS = (INFINITY, -INFINITY)


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
            f.args[0].args[0] in slopes
            and len(f.args) == 2
            and moving.isdisjoint(symbols(f.args[1]))
            for f in nodes
        )

    @property
    def bounds_derivatives(self) -> bool:
        """Whether derivatives of arbitrary functions are compared, as is meant for all points."""
        sides = (e for link in self.given.comparisons for e in link[::2])
        return any(any(f.args[0].args[1]) for e in sides for f in functions(e))

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
    def premises(self) -> tuple[tuple[Expr, Expr], ...]:
        """The conditions that bound the error of an approximation, such as ``y == x + O(1)``."""
        return tuple(pair for pair in self.equations if without_order(pair[1]) is not pair[1])

    @property
    def recurrences(self) -> tuple[tuple[Expr, Expr], ...]:
        """The conditions that give a sequence step by step, such as ``a(n + 1) == sin(a(n))``."""
        path = self.path
        if path is None:
            return ()
        return tuple(
            pair
            for pair in self.equations
            for node in pair
            if node.op == "unknown"
            and len(node.args) == 2
            and path.name in symbols(node.args[1])
            and not any(node.args[0].args[1])
            and any(f.args[0] == node.args[0] and f != node for e in pair for f in functions(e))
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
    arguments: dict[Expr, None] = {}
    for e in trees:
        for node in functions(e):
            if node.args[0].args[0] == FACTORIAL and not node.args[1].loose:
                arguments[node.args[1]] = None
    return list(arguments)


def implied_integers(trees: Iterable[Expr], known: Iterable[str] = ()) -> tuple[str, ...]:
    """Return the variables that must be integers: in ends of sums, orders and factorials.

    Args:
        known: those that are integers already.
    """
    places = [place for e in trees for place in _integer_places(e)]
    names = dict.fromkeys(known)
    for _ in places:
        for e in places:
            new = sorted(symbols(e) - {*names})
            slopes = [differentiate(e, name) for name in sorted(symbols(e))]
            linear = all(slope in (ONE, MINUS_ONE) for slope in slopes)
            rest = integer(substitute(e, dict.fromkeys(symbols(e), ZERO)))
            if linear and len(new) == 1 and rest is not None:
                names[new[0]] = None
    return tuple(names)


def never_integers(trees: Iterable[Expr], known: Iterable[str] = ()) -> list[Expr]:
    """Return what must be an integer but is one nowhere together; an empty list if it can be.

    With an integer n, ``factorial(n + 3/2)/factorial(n + 1/2)`` has no value at all, and a claim
    about it would hold for want of points. For linear places ``A v + b`` with unknown v, the rows
    of a unimodular matrix that cancel A must make b an integer; such a matrix comes with the
    Hermite normal form of (A | 1). Places that are not linear are left out.

    Args:
        known: the variables that are integers.

    Example:
        >>> from tresym.reals.language.parsing import parse
        >>> [str(e) for e in never_integers([parse("factorial(n + 1/2)")], ["n"])]
        ['n', 'n + 1/2']
        >>> never_integers([parse("factorial(n/2)")], ["n"])
        []
    """
    places = dict.fromkeys([symbol(name) for name in known])
    places |= dict.fromkeys(place for e in trees for place in _integer_places(e))
    forms = [(place, form) for place in places if (form := linear_form(place)) is not None]
    names = sorted({name for _, form in forms for name in form if name})
    if not forms:
        return []
    scale = lcm(*(int(c.q) for _, form in forms for c in form.values()))
    rows = [[int(form.get(name, 0) * scale) for name in names] for _, form in forms]
    ones = [[int(i == j) for j in range(len(forms))] for i in range(len(forms))]
    for row in fmpz_mat([a + b for a, b in zip(rows, ones, strict=True)]).hnf().tolist():
        combined = row[len(names) :]
        total = sum((c * form[""] for c, (_, form) in zip(combined, forms, strict=True)), fmpq(0))
        if not any(row[: len(names)]) and total.q != 1:
            return [place for c, (place, _) in zip(combined, forms, strict=True) if c]
    return []


def _integer_places(e: Expr) -> Iterator[Expr]:
    """What must be an integer where ``e`` has a value."""
    if not e.hidden:
        return
    if e.op == "coefficient":
        yield e.args[1]
    if e.op in ("sum", "product"):
        yield from (end for end in e.args[1:] if not end.loose and end not in _ENDS)
    elif e.op == "nth":
        yield e.args[2]
    elif e.op == "unknown" and e.args[0].args[0] == FACTORIAL and not e.args[1].loose:
        yield e.args[1]
    for arg in e.args:
        yield from _integer_places(arg)
