"""Where an expression is defined, as conditions that its points satisfy."""

from __future__ import annotations

from collections.abc import Iterable

from tresym.reals.language.expression import (
    ZERO,
    Expr,
    apply,
    differentiate,
    number,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.places.conditions import Given

_MIRRORED = {">": "<", ">=": "<="}


def with_domain(given: Given, *expressions: Expr) -> Given:
    """``given`` and what holds at every point where the expressions are defined.

    A claim speaks of those points alone, so a proof may use it.
    """
    parts = (part for part in needs(expressions) if symbols(part[0]))
    return Given(given.comparisons + tuple(bound(*part) for part in parts))


def needs(expressions: Iterable[Expr]) -> list[tuple[Expr, str]]:
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
