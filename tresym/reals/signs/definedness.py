"""Prove that an expression is defined, or smooth, wherever the conditions hold.

For example, log(x − y)/x is defined under x > y, y > 0. A division is accepted only where the
denominator is proved non-zero, and a root or logarithm only where its argument is proved to lie in
the domain, everywhere under the conditions. An operation that binds a variable and is not
evaluated, such as an integral, has conditions of its own and is never shown to be smooth. A value
at a point, ``f`` at ``x = c``, is checked after substitution. A derivative at a point is checked in
the same way, and its function must be smooth there.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.operation_domains import analytic_of, bound, needs, needs_of, operations
from tresym.reals.functions.table import TABLE
from tresym.reals.language.binders import generalised, outermost
from tresym.reals.language.calls import FACTORIAL
from tresym.reals.language.expression import (
    LEAVES,
    ONE,
    UNWORKED,
    ZERO,
    Expr,
    number,
    opened,
    rebuild,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.signs.interior import PROVING, is_zero, jumps
from tresym.reals.signs.sign import Prover, sign_by

Table = Callable[[Expr], list[tuple[Expr, str]]]


def undefined(e: Expr, given: Given, prover: Prover | None = None) -> Expr | None:
    """Return the first part of ``e`` that is not shown to be defined under ``given``.

    Args:
        e: the expression.
        given: the conditions.
        prover: expensive methods that may be tried, or None for none.

    Returns:
        The expression that is not shown to have the sign that its operation needs, such as a
            denominator
        that may vanish; None if ``e`` is proved to be defined.
    """
    return _missing(e, given, needs_of, prover)


def continuous_on(e: Expr, given: Given, prover: Prover | None = None) -> Expr | None:
    """Return the first part of ``e`` that is not shown to stay away from singularities.

    It is :func:`undefined` with the stronger requirement that every operation is analytic. If the
    result is None, ``e`` is smooth wherever ``given`` holds.
    """
    return _missing(e, given, analytic_of, prover)


_ENDS = {
    **{name: tuple(map(number, row.ends)) for name, row in TABLE.items() if row.ends},
    "^": (ZERO,),
}
"""The ends of the domain that belong to it, for each function."""


def at_domain_ends(sides: tuple[Expr, ...], given: Given) -> tuple[tuple[Expr, ...], Given] | None:
    """Replace operands that always lie at an end of a domain, such as R/R in asin(R/R), by it.

    Such an operand equals the end at every point, so that every ball around it leaves the domain
    and ball arithmetic could not evaluate it.

    Args:
        sides: the sides of the claim.
        given: the conditions.

    Returns:
        The rewritten sides and the conditions under which the replaced operands are defined; None
            if there is no such operand.
    """
    known: dict[Expr, Expr] = {}
    moved: list[Expr] = []
    for node in operations(sides):
        if node.hidden or node.loose or not any(relation == ">=" for _, relation in needs_of(node)):
            continue
        inner = node.args[0]
        for end in _ENDS.get(node.op, ()) if inner.op != "number" else ():
            if is_zero(inner - end, given) and not jumps((inner,), given):
                known[node] = rebuild(node, (end, *node.args[1:]))
                moved.append(inner)
    if not known:
        return None
    inside = given & Given(tuple(bound(*part) for part in needs(moved)))
    return tuple(replaced(side, known) for side in sides), inside


def is_lasting(sides: Sequence[Expr], given: Given, *moving: str) -> bool:
    """Return whether the sides are defined at all values of the moving variables if at one value.

    An induction needs this: a sum that is defined at n = 20 and n = 22 but not at n = 21 has no
    induction step. So every part that contains a variable in ``moving`` must be shown to be defined
    under the conditions of the other parts. An arbitrary function is defined wherever its arguments
    are.

    Args:
        sides: the sides of the claim.
        given: the conditions.
        moving: the names of the variables whose value changes in the induction.
    """
    nodes = [node for node in outermost(*sides) if not symbols(node).isdisjoint(moving)]
    inner = [arg for node in nodes for arg in node.args[1:]]
    if any(node.op != "unknown" for node in nodes) or next(iter(outermost(*inner)), None):
        return False
    factorials = [node for node in nodes if node.args[0].args == (FACTORIAL, (0,))]
    put = {
        node: symbol(f"[{i}]") for i, node in enumerate(nodes)
    }  # not a name that users can write
    names = {*moving, *(str(mark) for mark in put.values())}
    sides = [replaced(side, put) for side in sides]
    plain = needs(sides, powers=False)
    fixed = [(e, relation, ZERO) for e, relation in plain if not symbols(e) & names]
    inside = given & Given((*fixed, *((put[node], ">=", ONE) for node in factorials)))
    parts = [part for part in needs((*sides, *inner)) if symbols(part[0]) & names]
    parts += [(node.args[1], ">=") for node in factorials]
    return all(_holds(e, relation, inside, None) for e, relation in parts)


def _differentiable_of(node: Expr) -> list[tuple[Expr, str]]:
    """Return where an operation is differentiable; here this means where it is analytic."""
    return analytic_of(node)


def _missing(e: Expr, given: Given, table: Table, prover: Prover | None) -> Expr | None:
    """Return the first condition from ``table`` that is not proved for ``e`` or its parts."""
    if e.op in LEAVES:
        return None
    if e.op in UNWORKED:
        if table is analytic_of:
            return e
        return _missing_at(e, given, table, prover) if e.op in ("at", "derivative") else None
    parts = table(e)
    missing = [part for part, relation in parts if not _holds(part, relation, given, prover)]
    if missing and len(parts) == 2:  # 1 − x and 1 + x: not both are negative
        (first, relation), (second, _) = parts
        missing = [] if _holds(first * second, relation, given, prover) else missing
    inner = (_missing(arg, given, table, prover) for arg in e.args)
    return missing[0] if missing else next(filter(None, inner), None)


def _missing_at(e: Expr, given: Given, table: Table, prover: Prover | None) -> Expr | None:
    """Check a value or derivative at a point: its function must be defined, or smooth, there."""
    names, body = opened(e)
    points = e.args[1:]
    there = substitute(body, dict(zip(names, points, strict=True)))
    asked = _differentiable_of if e.op == "derivative" else table
    missing = (_missing(point, given, needs_of, prover) for point in points)
    return next(filter(None, missing), None) or _missing(there, given, asked, prover)


def _holds(e: Expr, relation: str, given: Given, prover: Prover | None) -> bool:
    (e,) = generalised(e)
    return sign_by(e, given, relation, prover) in PROVING[relation]
