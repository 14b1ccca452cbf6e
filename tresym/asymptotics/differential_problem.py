"""Read initial and boundary value problems as systems of first order.

Example: ``diff(y(t), t, 2) == -y(t), y(0) == 0, diff(y(0), t) == 1`` is the system y_0' = y_1,
y_1' = -y_0 with y_0(0) = 0 and y_1(0) = 1. Each equation must be linear in the highest derivative
of one function, with a factor that does not vanish.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from tresym.reals.decisions.readable_witnesses import tidied
from tresym.reals.decisions.statement import Statement, functions
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.operation_domains import operations
from tresym.reals.language.binders import elementary
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ZERO,
    Expr,
    replaced,
    substitute,
    symbol,
    symbols,
    unknown,
)
from tresym.reals.language.formula import Compared
from tresym.reals.language.paths import Path
from tresym.reals.signs.interior import PROVING, is_zero
from tresym.reals.signs.sign import sign


class OpenError(Exception):
    """A lemma is not shown to apply; the text says what is missing."""


class Value(NamedTuple):
    """A variable of the system has a value at a point."""

    point: Expr
    variable: str
    value: Expr


class Problem(NamedTuple):
    """A system of first order with values of its variables at one point or at two.

    Attributes:
        time: the independent variable.
        right: for each variable of the system, its derivative.
        given: the values, one for each variable if the problem is well posed.
        state: the variables, by function and order of the derivative.
    """

    time: str
    right: dict[str, Expr]
    given: tuple[Value, ...]
    state: dict[tuple[str, int], str]

    @property
    def start(self) -> Expr:
        """The initial point, or the first boundary point."""
        return self.given[0].point

    @property
    def is_initial(self) -> bool:
        """Whether all values are given at one point."""
        return len({value.point for value in self.given}) == 1

    @property
    def values(self) -> dict[str, Expr]:
        """The initial values."""
        return {value.variable: value.value for value in self.given}


def problem_of(statement: Statement) -> Problem:
    """Return the system of first order that the equations of the statement state."""
    gaps = [left - right for left, right in statement.equations]
    nodes = [list(functions(gap)) for gap in gaps]
    times = {
        node.args[1]
        for part in nodes
        for node in part
        if any(node.args[0].args[1]) and len(node.args) == 2 and node.args[1].op == "symbol"
    }
    if len(times) != 1 or any(len(node.args) != 2 for part in nodes for node in part):
        raise OpenError("the equations must contain functions of one and the same variable")
    time = str(next(iter(times)))
    equations, initial = [], []
    for gap, part in zip(gaps, nodes, strict=True):
        at = {node.args[1] for node in part}
        if at == {symbol(time)}:
            equations.append(gap)
        elif part and time not in symbols(gap):
            initial.append(gap)
        else:
            raise OpenError(f"{gap} == 0 is neither a differential equation nor an initial value")
    highest: dict[str, int] = {}
    for gap in equations:
        for node in functions(gap):
            name, (order,) = node.args[0].args
            highest[name] = max(order, highest.get(name, 0))
    if len(equations) != len(highest) or min(highest.values(), default=0) < 1:
        raise OpenError("there must be one differential equation for each function")
    taken = symbols_of(statement)
    state: dict[tuple[str, int], str] = {}
    for name, order in highest.items():
        for j in range(order):
            state[name, j] = fresh_name(f"{name}_{j}", taken)
            taken.add(state[name, j])
    put = {
        unknown(name, (symbol(time),), (j,)): symbol(variable)
        for (name, j), variable in state.items()
    }
    right: dict[str, Expr] = {}
    for gap in equations:
        tops = [
            n
            for n, order in highest.items()
            if unknown(n, (symbol(time),), (order,)) in set(functions(gap))
        ]
        if len(tops) != 1:
            raise OpenError("each equation must contain the highest derivative of one function")
        (name,) = tops
        top = unknown(name, (symbol(time),), (highest[name],))
        mark = symbol("[D]")
        e = replaced(gap, put | {top: mark})
        slope = tidied(differentiate(e, "[D]"))
        if "[D]" in symbols(slope) or not elementary(e):
            raise OpenError(f"the equation {gap} == 0 is not linear in the highest derivative")
        if slope.op != "number" and sign(slope, statement.given, "!=") not in PROVING["!="]:
            need_no_layer((1 / slope,), time, statement.path)
            raise OpenError(f"the factor {slope} of the highest derivative may vanish")
        solved = tidied(-substitute(e, {"[D]": ZERO}) / slope)
        for j in range(highest[name]):
            variable = state[name, j]
            if variable in right:
                raise OpenError(f"there are two equations for {name}")
            right[variable] = symbol(state[name, j + 1]) if j + 1 < highest[name] else solved
    values: list[Value] = []
    for gap in initial:
        found = list(functions(gap))
        if len(set(found)) != 1:
            raise OpenError(f"{gap} == 0 must give one value of one function or derivative")
        node = found[0]
        name, (j,) = node.args[0].args
        mark = symbol("[V]")
        e = replaced(gap, {node: mark})
        slope = tidied(differentiate(e, "[V]"))
        if (name, j) not in state or slope.op != "number" or slope == ZERO:
            raise OpenError(f"{gap} == 0 is no initial value of the equations")
        if any(v.variable == state[name, j] and v.point == node.args[1] for v in values):
            raise OpenError(f"there are two values of {node}")
        value = tidied(-substitute(e, {"[V]": ZERO}) / slope)
        values.append(Value(node.args[1], state[name, j], value))
    if len(values) != len(right):
        raise OpenError(
            f"a problem of order {len(right)} needs {len(right)} initial or boundary values; "
            f"{len(values)} are given"
        )
    points = {value.point for value in values}
    if len(points) > 2 or (len(points) == 1 and {v.variable for v in values} != set(right)):
        raise OpenError("the values must be given at one point, or at two")
    return Problem(time, right, tuple(values), state)


def need_no_layer(rights: Iterable[Expr], time: str, path: Path | None) -> None:
    """Require that nothing is divided by 0 where a small parameter has its limit.

    In e*y'' + y' + y == 0 the highest derivative drops out as e -> 0, so that the solution changes
    fast in a thin layer.

    Raises:
        OpenError: something is.
    """
    if path is None or path.point is None or path.name in ("", time):
        return
    for node in operations(rights):
        if node.op != "^" or path.name not in symbols(node.args[0]):
            continue
        base, exponent = node.args
        if exponent.op != "number" or exponent.args[0] > 0:
            continue
        if is_zero(substitute(base, {path.name: path.point}), Given()):
            raise OpenError(
                f"a derivative has the factor {base}, which tends to 0 as {path}: boundary layers "
                "(singular perturbations) are not supported yet"
            )


def symbols_of(statement: Statement) -> set[str]:
    """Return all variables of a statement."""
    trees = [side for c in statement.comparisons for side in (c.left, c.right)]
    return set().union(*map(symbols, (*trees, *statement.said)))


def fresh_name(name: str, taken: set[str]) -> str:
    """Return a name that is not taken."""
    while name in taken:
        name += "_"
    return name


def domain_of(problem: Problem, statement: Statement) -> Given:
    """Return the conditions, which must keep the variable in an interval with the initial point."""
    t = symbol(problem.time)
    links = []
    for link in statement.given.comparisons:
        left, relation, right = link
        names = symbols(left) | symbols(right)
        if statement.path is not None and statement.path.name in names:
            raise OpenError("conditions on the small parameter are not supported")
        if problem.time in names:
            ends = [side for side in (left, right) if side != t]
            if len(ends) != 1 or problem.time in symbols(ends[0]) or relation == "!=":
                raise OpenError(f"the conditions must keep {t} in an interval")
            below = (relation[0] == "<") == (left == t)
            gap = ends[0] - problem.start if below else problem.start - ends[0]
            if sign(gap, statement.given, ">=") not in PROVING[">="]:
                raise OpenError(f"the interval of {t} must contain the initial point")
        links.append(link)
    return Given(tuple(links))


def with_initial_point(domain: Given, problem: Problem) -> Given:
    """Return the conditions with the initial point in the interval of the variable."""
    t = symbol(problem.time)

    def with_start(x: Expr, relation: str, y: Expr) -> Compared:
        end = y if x == t else x if y == t else None
        if end is None or relation.endswith("=") or not is_zero(end - problem.start, domain):
            return x, relation, y
        return x, f"{relation}=", y

    return Given(tuple(with_start(*link) for link in domain.comparisons))


def residuals(problem: Problem, curve: dict[str, Expr]) -> list[Expr]:
    """Return what is left of the equations when a curve is put in."""
    return [
        differentiate(curve[n], problem.time) - substitute(right, curve)
        for n, right in problem.right.items()
    ]
