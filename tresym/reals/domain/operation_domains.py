"""List where each operation is defined, and where it is analytic.

This is the only such table for the provers. The independent cross-check has its own, so that it
shares no code with the provers. The evaluators in ball arithmetic need none: they return NaN at a
point that may lie outside the domain.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from tresym.reals.domain.conditions import Given
from tresym.reals.functions.table import TABLE
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    LEAVES,
    ZERO,
    Expr,
    number,
    substitute,
    symbol,
    symbols,
    trees,
)
from tresym.reals.language.formula import MIRRORED


def with_domain(given: Given, *expressions: Expr) -> Given:
    """Return ``given`` with the conditions under which the expressions are defined.

    A claim is a statement about the points where its sides are defined, so that a proof may use
    these conditions.
    """
    parts = (part for part in needs(expressions) if symbols(part[0]))
    return Given(given.comparisons + tuple(bound(*part) for part in parts))


def needs(expressions: Iterable[Expr], powers: bool = True) -> list[tuple[Expr, str]]:
    """Return the conditions that hold wherever all of ``expressions`` are defined.

    Args:
        expressions: the expressions.
        powers: whether a power with a variable exponent requires a positive base.

    Returns:
        Pairs of an expression and its relation to zero: ``>``, ``>=`` or ``!=``.

    Example:
        >>> [(str(e), relation) for e, relation in needs([apply("log", symbol("x"))])]
        [('x', '>')]
    """
    nodes = (e for e in operations(expressions) if powers or e.op != "^" or not symbols(e.args[1]))
    return list(dict.fromkeys(part for node in nodes for part in needs_of(node)))


def denominators(e: Expr) -> list[Expr]:
    """Return the expressions that must not vanish for ``e`` to be defined."""
    return [part for part, relation in needs((e,)) if relation != ">="]


def singularities(e: Expr) -> list[tuple[Expr, bool]]:
    """Return expressions such that ``e`` is analytic where none of them vanishes.

    Returns:
        Pairs of an expression and whether it must be positive.
    """
    parts = dict.fromkeys(part for node in operations((e,)) for part in analytic_of(node))
    return [(part, relation == ">") for part, relation in parts]


def operations(expressions: Iterable[Expr]) -> Iterator[Expr]:
    """Yield every operation in the expressions once."""
    seen: set[Expr] = set()
    stack = list(expressions)
    while stack:
        node = stack.pop()
        if node in seen or node.op in LEAVES:
            continue
        seen.add(node)
        stack.extend(node.args)
        yield node


def preorder(e: Expr) -> Iterator[Expr]:
    """Yield every operation in ``e``, each before its operands and as often as it occurs."""
    if e.op not in LEAVES:
        yield e
        for arg in e.args:
            yield from preorder(arg)


def needs_of(node: Expr) -> list[tuple[Expr, str]]:
    """Return the expressions, with relations to zero, that state where the operation is defined."""
    x = node.args[0]
    if node.op == "^":
        exponent = node.args[1]
        if exponent.op != "number":
            return [(x, ">")]
        r = exponent.args[0]
        if r.q != 1:
            return [(x, ">" if r < 0 else ">=")]
        return [(x, "!=")] if r < 0 else []
    row = TABLE.get(node.op)
    return list(row.needs(*node.args, trees)) if row else []


def analytic_of(node: Expr) -> list[tuple[Expr, str]]:
    """Return the same for where the operation is analytic, with relations ``>`` and ``!=``."""
    row = TABLE.get(node.op)
    if row and row.singular:
        return list(row.singular(*node.args, trees))
    return [(part, relation.replace(">=", ">")) for part, relation in needs_of(node)]


def bound(e: Expr, relation: str) -> tuple[Expr, str, Expr]:
    """Return ``e relation 0``, solved for its symbol if ``e`` is affine in a single one."""
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
