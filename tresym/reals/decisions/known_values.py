"""Values of definite integrals, sums and products by quoted theorems.

An integrand, summand or factor matches a row of :mod:`tresym.reals.decisions.theorems` if one exact
identity proves it and the conditions of the row are proved for its parameters, whose candidates are
the coefficients of the expression. A power series is recognised by the ratio of its terms.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from itertools import product
from typing import NamedTuple

from flint import fmpq

from tresym.reals.decisions.hypergeometric import Series, folded, out_of_range, root, series_of
from tresym.reals.decisions.identity import decide
from tresym.reals.decisions.theorems import POWER_SERIES, TABLES
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.operation_domains import preorder
from tresym.reals.language.binders import elementary, total
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    MINUS_ONE,
    ONE,
    ZERO,
    Expr,
    add,
    multiply,
    number,
    replaced,
    sqrt,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.parsing import parse, parse_given
from tresym.reals.normal.to_expression import in_lowest_terms
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.signs.interior import PROVING
from tresym.reals.signs.sign import sign
from tresym.reals.verdict import Verdict

SIGN = "[(-1)^n]"
"""Stands for (−1)^n in summands."""
CANDIDATES = 10
"""Values of each of two parameters that are tried."""


class Known(NamedTuple):
    """The value of an integral, sum or product, and the theorem that states it."""

    value: Expr
    source: str


def known_value(kind: str, f: Expr, name: str, low: Expr, high: Expr, given: Given) -> Known | None:
    """Return the value of an integral, sum or product of ``f``, or None if no theorem gives it.

    Args:
        kind: ``"integral"``, ``"sum"`` or ``"product"``.
        name: the variable, which ranges from ``low`` to ``high``.
        given: the conditions on the parameters.
    """
    try:
        if low == -INFINITY and high == INFINITY:
            return _on_both_sides(kind, f, name, given)
        if kind == "integral" or high != INFINITY:
            return _matched(kind, f, name, (low, high), given)
        whole = low.op == "number" and low.args[0].q == 1
        return _from_one(kind, f, name, int(low.args[0].p), given) if whole else None
    except InputError:
        return None


def _on_both_sides(kind: str, f: Expr, name: str, given: Given) -> Known | None:
    """By a theorem about all numbers or integers, or as twice the value on the positive ones."""
    known = _matched(kind, f, name, (-INFINITY, INFINITY), given)
    mirrored = substitute(f, {name: -symbol(name)})
    if known or kind == "product" or not _same(f, mirrored, given):
        return known
    low = ZERO if kind == "integral" else ONE
    half = known_value(kind, f, name, low, INFINITY, given)
    middle = ZERO if kind == "integral" else substitute(f, {name: ZERO})
    return half and Known(middle + 2 * half.value, half.source)


def _from_one(kind: str, f: Expr, name: str, low: int, given: Given) -> Known | None:
    """By theorems about n = 1, 2, …, with up to two terms more or less at the beginning."""
    for more in (0, 1, 2, -1, -2):
        found, start = None, low - more
        if kind == "sum":
            s = series_of(total(kind, f, name, number(start), INFINITY), given.names)
            found = None if s is None else _power_series(s, given)
        if found is None and elementary(f):
            moved = substitute(f, {name: symbol(name) + (start - 1)})
            found = _matched(kind, moved, name, (ONE, INFINITY), given)
        if found is None or not (symbols(found.value) or _is_number(found.value)):
            continue
        indices = range(start, low) if more > 0 else range(low, start)
        terms = [folded(substitute(f, {name: number(k)})) for k in indices]
        known = [term for term in terms if term is not None]
        if len(known) < len(terms):
            return None
        up = -1 if more > 0 else 1
        if kind == "product":
            return found._replace(value=found.value * multiply(*known) ** number(up))
        return found._replace(value=found.value + up * add(*known) if known else found.value)
    return None


def _is_number(e: Expr) -> bool:
    """Whether a constant has a value: at removable singularities of a theorem it has none."""
    with ball_precision():
        return bool(evaluate(e, {}).is_finite())


def _same(left: Expr, right: Expr, given: Given) -> bool:
    return left == right or decide(left, right, given).verdict is Verdict.PROVED


# Rows of the tables


def _matched(kind: str, f: Expr, name: str, ends: tuple[Expr, Expr], given: Given) -> Known | None:
    """Return the value by a row for this range, or None."""
    fixed = {}
    key = f"{kind} {ends[0]} {ends[1]}"
    if kind == "product" and ends[1] != INFINITY and (ends[1] + 1).op == "symbol":
        fixed, key = {"a": ends[1] + 1}, f"{kind} {ends[0]} a - 1"
    if key not in TABLES or not elementary(f):
        return None
    f, x = _with_sign(f, name), symbol(name)
    bounds = [] if ends[0] == -INFINITY else [(x, ">" if kind == "integral" else ">=", ends[0])]
    bounds += [] if ends[1] == INFINITY else [(x, "<", ends[1] + int(kind != "integral"))]
    inside = given & Given(tuple(bounds))
    candidates = list(dict.fromkeys(_candidates(f, name)))
    for row in TABLES[key]:
        body, value = parse(row.body), parse(row.value)
        free = sorted({"a", "b"} & symbols(body) - {*fixed})
        few = candidates[: CANDIDATES if len(free) > 1 else None]
        for values in product(few, repeat=len(free)):
            at = {"t": x, "n": x, **fixed, **dict(zip(free, values, strict=True))}
            pattern = _with_sign(substitute(body, at), name)
            for up in (1, -1) if kind == "product" else (1,):
                c = _factor(f ** number(up), pattern, name, inside)
                if c is None or (kind == "product" and c != ONE):
                    continue
                if c == ZERO:
                    return Known(ZERO, "its normal form, which is 0")
                if _hold(row.given, at, given):
                    value_there = c * substitute(value, at) ** number(up)
                    return Known(value_there, row.source.replace("GR", "Gradshteyn and Ryzhik"))
    return None


def _with_sign(e: Expr, name: str) -> Expr:
    """``e`` with a variable for (−1)^n, which is (−1)^(−n)."""
    powers = (node for node in preorder(e) if node.op == "^" and node.args[0] == MINUS_ONE)
    return replaced(
        e,
        {
            node: symbol(SIGN) * MINUS_ONE ** substitute(node.args[1], {name: ZERO})
            for node in powers
            if differentiate(node.args[1], name) in (ONE, MINUS_ONE)
        },
    )


def _factor(f: Expr, pattern: Expr, name: str, inside: Given) -> Expr | None:
    """c where f is c times the pattern, and c is free of the variable."""
    ratio = f / pattern
    point = next(inside.points(symbols(ratio) | {name}, 1), None)
    if point is None:
        return None
    with ball_precision():
        values = [evaluate(ratio, point | {name: point[name] * fmpq(k, 7)}) for k in (7, 5, 3)]
    if not all(v.is_finite() and v.overlaps(values[0]) for v in values):
        return None
    c = in_lowest_terms(ratio)
    if symbols(c) & {name, SIGN}:
        with ball_precision():
            whole = (values[0] * 5040).unique_fmpz()
        if whole is None:
            return None
        c = number(fmpq(int(whole), 5040))
    return c if _same(f, c * pattern, inside) else None


def _hold(conditions: str, at: dict[str, Expr], given: Given) -> bool:
    """Whether the conditions of a theorem are proved of its parameters."""
    for left, relation, right in parse_given(conditions):
        if relation in ("<", "<="):
            left, right, relation = right, left, relation.replace("<", ">")
        gap = substitute(left - right, at)
        if sign(gap, given, relation) not in PROVING[relation]:
            return False
    return True


def _candidates(f: Expr, name: str) -> Iterator[Expr]:
    """What the parameters of a theorem may be: variables, coefficients, roots of them, and 1."""
    names = [symbol(other) for other in sorted(symbols(f) - {name, SIGN})]
    constants = {c: None for c in _coefficients(f, name) if c != ZERO and name not in symbols(c)}
    small = [c for c in constants if c not in names]
    yield from (*names, *small, ONE, *(-c for c in (*names, *small)))


def _coefficients(f: Expr, name: str) -> Iterator[Expr]:
    for e in preorder(f):
        if name not in symbols(e):
            continue
        try:
            slope = differentiate(e, name)
            bend = differentiate(slope, name)
            if name not in symbols(bend):
                yield in_lowest_terms(substitute(slope, {name: ZERO}))
                yield in_lowest_terms(bend / 2)
        except InputError:
            continue
        if e.op == "+":
            rest = add(*(arg for arg in e.args if name not in symbols(arg)))
            scales = [_scale(arg, name) for arg in e.args if name in symbols(arg)]
            yield from (rest, _root(rest), *scales)
            for c in map(_root, scales):
                yield from (c, _root(rest) / c)
        if e.op == "^":
            yield from (e.args[1], in_lowest_terms(e.args[1] + 1))


def _scale(e: Expr, name: str) -> Expr:
    """The factors without the variable."""
    if name not in symbols(e):
        return e
    if e.op == "^" and e.args[1].op == "number":
        return _scale(e.args[0], name) ** e.args[1]
    return multiply(*(_scale(arg, name) for arg in e.args)) if e.op == "*" else ONE


def _root(e: Expr) -> Expr:
    """The square root of the size of ``e``, with bases for roots of their squares."""
    if e.op == "*":
        return multiply(*map(_root, e.args))
    if e.op == "^" and e.args[1].op == "number":
        return e.args[0] ** (e.args[1] / 2)
    return root(abs(e.args[0]), 2) if e.op == "number" else sqrt(e)


# Power series


@cache
def _templates() -> list[tuple[Series, str]]:
    series = [(series_of(parse(f"sum({term}, k, 0, oo)")), value) for term, value in POWER_SERIES]
    return [(s, value) for s, value in series if s is not None]


def _power_series(s: Series, given: Given) -> Known | None:
    """By the ratio of terms, which determines the series up to the scale of its variable."""
    if out_of_range(s, given):
        return None
    for t, function in _templates():
        one, other = s.above * t.below, s.below * t.above
        scale = one[one.degree()] / other[other.degree()]
        whole = t.step == s.step or s.u == ONE
        if one != scale * other or not whole or (scale < 0 and t.step == 2):
            continue
        y = root(abs(scale), t.step) * s.u
        y = -y if scale < 0 else y
        value = substitute(parse(function), {"y": y})
        head = s.head * s.u ** number(s.start) / y ** number(t.start)
        return Known(in_lowest_terms(head * value), f"the power series of {function}")
    return None
