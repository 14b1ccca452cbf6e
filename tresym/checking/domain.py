"""Where an expression is defined, as conditions that its points satisfy."""

from __future__ import annotations

from collections.abc import Mapping

from flint import arb, fmpq

from tresym.exact import InputError
from tresym.identity.evaluation import evaluate
from tresym.identity.expression import (
    ZERO,
    Expr,
    apply,
    as_expr,
    differentiate,
    number,
    substitute,
    symbol,
    symbols,
)
from tresym.identity.field import ALL_THEORIES
from tresym.identity.given import Condition, Given
from tresym.identity.locally_constant import equal_constants

_MIRRORED = {">": "<", ">=": "<="}


def with_domain(given: Given, *expressions: Expr) -> Given:
    """``given`` and what holds at every point where the expressions are defined.

    A claim speaks of those points alone, so a proof may use it.
    """
    found: dict[tuple[Expr, str], None] = {}
    seen: set[Expr] = set()
    stack = list(expressions)
    while stack:
        node = stack.pop()
        if node in seen or node.op in ("number", "symbol", "pi"):
            continue
        seen.add(node)
        stack.extend(node.args)
        for part in _needs(node):
            if symbols(part[0]):
                found[part] = None
    extra = tuple(bound(part, relation) for part, relation in found)
    return Given(given.comparisons + extra)


def _needs(node: Expr) -> list[tuple[Expr, str]]:
    """Expressions that are ``>``, ``>=`` or ``!=`` zero where the node itself is defined."""
    x = node.args[0]
    if node.op == "^":
        exponent = node.args[1]
        if exponent.op != "number":
            return [(x, ">")]
        r = exponent.args[0]
        if r.q != 1:
            return [(x, ">" if r < 0 else ">=")]
        return [(x, "!=")] if r < 0 else []
    if node.op == "log":
        return [(x, ">")]
    if node.op in ("coth", "csch"):
        return [(x, "!=")]
    if node.op in ("tan", "sec"):
        return [(apply("cos", x), "!=")]
    if node.op in ("cot", "csc"):
        return [(apply("sin", x), "!=")]
    if node.op in ("asin", "acos"):
        return [(1 - x, ">="), (1 + x, ">=")]
    if node.op == "atanh":
        return [(1 - x, ">"), (1 + x, ">")]
    if node.op == "acosh":
        return [(x - 1, ">=")]
    if node.op == "atan2":
        return [(x**2 + node.args[1] ** 2, ">")]
    return []


def bound(e: Expr, relation: str) -> tuple[Expr, str, Expr]:
    """``e relation 0``, written as a bound of one symbol where ``e`` is affine in it alone."""
    names = sorted(symbols(e))
    if len(names) == 1 and e.op in ("+", "*", "symbol"):
        name = names[0]
        slope = differentiate(e, name)
        start = substitute(e, {name: ZERO})
        if slope.op == "number" and start.op == "number" and slope != ZERO:
            a, b = slope.args[0], start.args[0]
            sign = relation if a > 0 else _MIRRORED.get(relation, relation)
            return symbol(name), sign, number(-b / a)
    return e, relation, ZERO


def equal_at(left: Expr, right: Expr, point: Mapping[str, fmpq | Expr]) -> bool:
    """Whether both sides, defined at the exact ``point``, are exactly equal there."""
    at = {name: as_expr(value) for name, value in point.items()}
    try:
        return equal_constants(substitute(left, at), substitute(right, at), ALL_THEORIES)
    except InputError:  # a power that is too long to write
        return False


def satisfies(
    condition: Condition, point: Mapping[str, fmpq | Expr], at: Mapping[str, arb]
) -> bool:
    """Whether the exact ``point`` satisfies the condition, equality with it shown exactly.

    Args:
        at: the point in balls.
    """
    balls = dict(at)
    if condition.holds_exactly(balls):
        return True
    near = condition.relation == ">=" and evaluate(condition.expression, balls).contains(0)
    return near and equal_at(condition.expression, ZERO, point)
