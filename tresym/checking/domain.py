"""Where an expression is defined, as conditions that its points satisfy."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from flint import arb, fmpq

from tresym.exact import InputError
from tresym.identity.bounds import PROVING, sign
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
    parts = (part for part in _conditions(expressions) if symbols(part[0]))
    return Given(given.comparisons + tuple(bound(*part) for part in parts))


def where_real(
    given: Given, functions: Iterable[Expr], by: Iterable[str] = ()
) -> tuple[Given, Given]:
    """``given`` and that the functions are real, to refute at a point and to prove everywhere.

    A claim that holds derivatives speaks of the points beside which, in the variables ``by``, what
    is differentiated is real. ``x**(3/2)`` is real at 0 and not beside it: a proof counts such a
    point in, and a refutation leaves it out.
    """
    parts = [part for part in _conditions(functions) if not _holds_everywhere(*part)]
    whole = tuple(bound(*part) for part in parts)
    opened = tuple(
        bound(e, ">" if relation == ">=" and symbols(e) & set(by) else relation)
        for e, relation in parts
    )
    return Given(given.comparisons + opened), Given(given.comparisons + whole)


def _holds_everywhere(e: Expr, relation: str) -> bool:
    return sign(e, Given()) in PROVING[relation]


def _conditions(expressions: Iterable[Expr]) -> list[tuple[Expr, str]]:
    """What is ``>``, ``>=`` or ``!=`` zero wherever all of ``expressions`` are defined."""
    found: dict[tuple[Expr, str], None] = {}
    seen: set[Expr] = set()
    stack = list(expressions)
    while stack:
        node = stack.pop()
        if node in seen or node.op in ("number", "symbol", "pi"):
            continue
        seen.add(node)
        stack.extend(node.args)
        found |= dict.fromkeys(_needs(node))
    return list(found)


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
            relation = relation if a > 0 else _MIRRORED.get(relation, relation)
            return symbol(name), relation, number(-b / a)
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
