"""The table of domains: where each operation is defined, and where it is analytic.

Only the advocate and the walkers of balls know it once more: the first shares nothing with the
provers, the others find by a ball that has no value that a point may be outside.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from tresym.reals.domain.conditions import Given
from tresym.reals.language.expression import (
    LEAVES,
    ZERO,
    Expr,
    apply,
    differentiate,
    number,
    sqrt,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import MIRRORED


def with_domain(given: Given, *expressions: Expr) -> Given:
    """``given`` and what holds at every point where the expressions are defined.

    A claim speaks of those points alone, so a proof may use it.
    """
    parts = (part for part in needs(expressions) if symbols(part[0]))
    return Given(given.comparisons + tuple(bound(*part) for part in parts))


def needs(expressions: Iterable[Expr], powers: bool = True) -> list[tuple[Expr, str]]:
    """What is ``>``, ``>=`` or ``!=`` zero wherever all of ``expressions`` are defined.

    Args:
        powers: whether powers with a variable as exponent ask for a positive base.
    """
    nodes = (e for e in operations(expressions) if powers or e.op != "^" or not symbols(e.args[1]))
    return list(dict.fromkeys(part for node in nodes for part in needs_of(node)))


def denominators(e: Expr) -> list[Expr]:
    """What must not vanish for ``e`` to be defined."""
    return [part for part, relation in needs((e,)) if relation != ">="]


def singularities(e: Expr) -> list[tuple[Expr, bool]]:
    """Expressions off whose zeros ``e`` is analytic; True where they must be positive."""
    parts = dict.fromkeys(part for node in operations((e,)) for part in analytic_of(node))
    return [(part, relation == ">") for part, relation in parts]


def operations(expressions: Iterable[Expr]) -> Iterator[Expr]:
    """Every operation in the expressions, once."""
    seen: set[Expr] = set()
    stack = list(expressions)
    while stack:
        node = stack.pop()
        if node in seen or node.op in LEAVES:
            continue
        seen.add(node)
        stack.extend(node.args)
        yield node


def needs_of(node: Expr) -> list[tuple[Expr, str]]:
    """Expressions that are ``>``, ``>=`` or ``!=`` zero just where the operation is defined."""
    x = node.args[0]
    match node.op:
        case "^":
            exponent = node.args[1]
            if exponent.op != "number":
                return [(x, ">")]
            r = exponent.args[0]
            if r.q != 1:
                return [(x, ">" if r < 0 else ">=")]
            return [(x, "!=")] if r < 0 else []
        case "log":
            return [(x, ">")]
        case "coth" | "csch":
            return [(x, "!=")]
        case "tan" | "sec":
            return [(apply("cos", x), "!=")]
        case "cot" | "csc":
            return [(apply("sin", x), "!=")]
        case "asin" | "acos":
            return [(1 - x, ">="), (1 + x, ">=")]
        case "atanh":
            return [(1 - x, ">"), (1 + x, ">")]
        case "acosh":
            return [(x - 1, ">=")]
        case "atan2":
            return [(x**2 + node.args[1] ** 2, ">")]
    return []


def analytic_of(node: Expr) -> list[tuple[Expr, str]]:
    """The same for where it is analytic: ``>`` or ``!=`` zero."""
    x = node.args[0]
    if node.op in ("abs", "sign", "cbrt"):
        return [(x, "!=")]
    if node.op == "atan2":  # zero on the half line where it jumps
        return [(sqrt(node.args[1] ** 2 + x**2) + node.args[1], "!=")]
    return [(part, relation.replace(">=", ">")) for part, relation in needs_of(node)]


def bound(e: Expr, relation: str) -> tuple[Expr, str, Expr]:
    """``e relation 0``, written as a bound of one symbol where ``e`` is affine in it alone."""
    if e.op == "abs" and relation in (">", "!="):
        return bound(e.args[0], "!=")
    names = sorted(symbols(e))
    if len(names) == 1 and e.op in ("+", "*", "symbol"):
        name = names[0]
        slope = differentiate(e, name)
        start = substitute(e, {name: ZERO})
        if slope.op == "number" and start.op == "number" and slope != ZERO:
            a, b = slope.args[0], start.args[0]
            relation = relation if a > 0 else MIRRORED[relation]
            return symbol(name), relation, number(-b / a)
    return e, relation, ZERO
