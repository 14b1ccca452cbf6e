"""All solutions of an equation for one variable, as cases.

An equation is solved if it is linear or quadratic in the variable, or if the variable occurs once,
inside invertible functions. For periodic functions the solutions contain a new integer variable.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from flint import fmpq

from tresym.reals.decisions.readable_witnesses import tidied
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.operation_domains import needs
from tresym.reals.functions.table import TABLE
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    HALF,
    PI,
    ZERO,
    Expr,
    add,
    apply,
    as_expr,
    fresh,
    multiply,
    number,
    power,
    sqrt,
    substitute,
    symbol,
    symbols,
    trees,
)
from tresym.reals.language.formula import Compared
from tresym.reals.signs.interior import PROVING, is_zero
from tresym.reals.signs.sign import sign


class Case(NamedTuple):
    """A solution for the variable, and the conditions and equations under which it is one.

    It holds for each value of the ``integers``, which are new.
    """

    value: Expr | None
    conditions: tuple[Compared, ...] = ()
    equations: tuple[tuple[Expr, Expr], ...] = ()
    integers: tuple[str, ...] = ()


def solved(e: Expr, name: str, statement: Statement) -> list[Case] | None:
    """Return all solutions of ``e = 0`` for the variable; None if it cannot be solved."""
    at, given = {name: ZERO}, statement.given
    slope = differentiate(e, name)
    if _is_free(slope, name):
        return _linear(tidied(substitute(slope, at)), tidied(substitute(e, at)), given)
    bend = differentiate(slope, name)
    if _is_free(bend, name):
        a, b, c = (tidied(substitute(part, at)) for part in (HALF * bend, slope, e))
        if sign(a, given, "!=") not in PROVING["!="]:
            return None
        under = b**2 - 4 * a * c  # not negative where the values are real
        return [Case((-b + side * sqrt(under)) / (2 * a)) for side in (1, -1)]
    return _undone(e, name, ZERO, statement)


def _is_free(e: Expr, name: str) -> bool:
    """Whether ``e`` is one expression in the other variables, defined wherever they are."""
    if name not in symbols(e):
        return True
    return not needs((e,)) and is_zero(e - substitute(e, {name: ZERO}), Given())


def _linear(p: Expr, q: Expr, given: Given) -> list[Case]:
    """All v with p v + q = 0."""
    if sign(p, given, "!=") in PROVING["!="]:
        return [Case(-q / p)]
    solved = Case(-q / p, ((p, "!=", ZERO),))
    if sign(q, given, "!=") in PROVING["!="]:
        return [solved]
    return [solved, Case(None, (), ((p, ZERO), (q, ZERO)))]


def _undone(e: Expr, name: str, value: Expr, statement: Statement) -> list[Case] | None:
    """All solutions of ``e = value`` where the variable stands in ``e`` once; None for others."""
    if e.op == "symbol":
        return [Case(value)] if e.args == (name,) else None
    inner = [arg for arg in e.args if isinstance(arg, Expr) and name in symbols(arg)]
    if len(inner) != 1:
        return None
    (arg,) = inner
    others = list(e.args)
    others.remove(arg)
    if e.op == "+":
        return _undone(arg, name, value - add(*others), statement)
    if e.op == "*":
        factor = multiply(*others)
        if sign(factor, statement.given, "!=") not in PROVING["!="]:
            return None
        return _undone(arg, name, value / factor, statement)
    steps = [Case(u, conditions) for u, conditions in _inverses(e, arg, value)]
    if e.op in TABLE and TABLE[e.op].branch:
        steps = _turned(e, arg, value, statement)
    found = []
    for step in steps:
        cases = _undone(arg, name, step.value or ZERO, statement)
        if cases is None:
            return None
        found += [
            case._replace(
                conditions=(*step.conditions, *case.conditions),
                integers=(*step.integers, *case.integers),
            )
            for case in cases
        ]
    return found or None


def _turned(e: Expr, arg: Expr, v: Expr, statement: Statement) -> list[Case]:
    """All values of ``arg`` with ``e = v``: the one in its range, or those that are turned."""
    branch = TABLE[e.op].branch
    assert branch is not None
    inverse, (turn, turns_on), ends = branch
    shift, low, high = (number(part) * PI if part else ZERO for part in (turns_on, *ends))
    first = apply(inverse, v)
    within = (sign(side, statement.given, ">=") for side in (arg - low, high - arg))
    if all(found in PROVING[">="] for found in within):
        return [Case(first)]
    if statement.path is not None:
        return []
    taken = symbols(arg) | symbols(v) | statement.given.names | {*statement.integers}
    taken = taken.union(*map(symbols, statement.said))
    k = fresh("k", taken)
    if e.op == "tan":
        return [Case(first + PI * symbol(k), integers=(k,))]
    turns = 2 * PI * symbol(k)
    return [Case(u + turns, integers=(k,)) for u in (first, shift + turn * first)]


def _inverses(e: Expr, arg: Expr, v: Expr) -> Iterator[tuple[Expr, tuple[Compared, ...]]]:
    """The values of ``arg`` with ``e = v``, each with the conditions on v; none if too many."""
    if e.op == "^" and e.args[1].op == "number" and arg is e.args[0]:
        yield from _roots(e.args[1].args[0], v)
    elif e.op == "abs":
        yield v, ((v, ">=", ZERO),)
        yield -v, ((v, ">", ZERO),)
    elif e.op == "cbrt":
        yield v**3, ()
    elif e.op in TABLE and (row := TABLE[e.op]).inverse and row.image:
        low, high, closed = row.image(trees)
        bounds = [(v, "<=" if closed else "<", as_expr(high))] if high is not None else []
        bounds += [(v, ">=" if closed else ">", as_expr(low))] if low is not None else []
        yield apply(row.inverse, v), tuple(bounds)


def _roots(r: fmpq, v: Expr) -> Iterator[tuple[Expr, tuple[Compared, ...]]]:
    """All u with ``u**r = v``."""
    exponent = number(r)
    value = exponent.args[0]
    if value.q != 1:  # u ≥ 0, and v too
        yield power(v, 1 / exponent), ((v, ">=" if value > 0 else ">", ZERO),)
    elif value.p % 2 == 0:
        bound: tuple[Compared, ...] = ((v, ">=" if value > 0 else ">", ZERO),)
        yield power(v, 1 / exponent), bound
        yield -power(v, 1 / exponent), bound
    elif abs(value.p) == 3:
        root = apply("cbrt", v)
        yield (root, ()) if value > 0 else (1 / root, ((v, "!=", ZERO),))
    elif value == -1:
        yield 1 / v, ((v, "!=", ZERO),)
