"""Prove that an expression is defined, or smooth, wherever the conditions hold.

A proof divides only where the denominator is shown non-zero and takes roots and logarithms only
where their arguments are shown to allow it, everywhere under the conditions given. What is not
worked out, such as an integral, has conditions of its own, and is not shown to be smooth; a value
at a point is looked at in place, and so is a derivative, whose function must be smooth there.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.operation_domains import analytic_of, bound, needs, needs_of, operations
from tresym.reals.language.binders import generalised, outermost
from tresym.reals.language.expression import (
    LEAVES,
    MINUS_ONE,
    ONE,
    UNWORKED,
    ZERO,
    Expr,
    opened,
    rebuild,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.parsing import FACTORIAL
from tresym.reals.signs.interior import PROVING, is_zero, jumps
from tresym.reals.signs.sign import Prover, sign_by

Table = Callable[[Expr], list[tuple[Expr, str]]]


def undefined(e: Expr, given: Given, prover: Prover | None = None) -> Expr | None:
    """The first part of ``e`` that is not shown to be defined under ``given``, or None.

    What is returned is what is not shown to have the sign that its operation needs.

    Args:
        prover: dear methods, if any may be tried.
    """
    return _missing(e, given, needs_of, prover)


def continuous_on(e: Expr, given: Given, prover: Prover | None = None) -> Expr | None:
    """As :func:`undefined`, but off every singularity, so that ``e`` is smooth there."""
    return _missing(e, given, analytic_of, prover)


_ENDS = {"asin": (ONE, MINUS_ONE), "acos": (ONE, MINUS_ONE), "acosh": (ONE,), "^": (ZERO,)}
"""Where the domain of a function ends, and the function has a value."""


def at_domain_ends(sides: tuple[Expr, ...], given: Given) -> tuple[tuple[Expr, ...], Given] | None:
    """The sides with 1 for R/R in asin(R/R), and where such operands are defined; None without.

    Such an operand is at the end of the domain at every point, so that balls around it leave it.
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
    """Whether the sides are defined for all values of some variables if they are for one.

    An induction needs it: what it is said of at n = 20 alone says nothing at 22 where 21 is left
    out. So each part with ``moving`` variables must be shown, under the others. A function that is
    left unknown is defined wherever its arguments are.
    """
    nodes = [node for node in outermost(*sides) if not symbols(node).isdisjoint(moving)]
    inner = [arg for node in nodes for arg in node.args[1:]]
    if any(node.op != "unknown" for node in nodes) or next(iter(outermost(*inner)), None):
        return False
    factorials = [node for node in nodes if node.args[0].args == (FACTORIAL, (0,))]
    put = {node: symbol(f"[{i}]") for i, node in enumerate(nodes)}  # no name of anybody's
    names = {*moving, *(str(mark) for mark in put.values())}
    sides = [replaced(side, put) for side in sides]
    plain = needs(sides, powers=False)
    fixed = [(e, relation, ZERO) for e, relation in plain if not symbols(e) & names]
    inside = given & Given((*fixed, *((put[node], ">=", ONE) for node in factorials)))
    parts = [part for part in needs((*sides, *inner)) if symbols(part[0]) & names]
    parts += [(node.args[1], ">=") for node in factorials]
    return all(_holds(e, relation, inside, None) for e, relation in parts)


def _differentiable_of(node: Expr) -> list[tuple[Expr, str]]:
    """Where an operation can be differentiated: as far as is asked here, where it is analytic."""
    return analytic_of(node)


def _missing(e: Expr, given: Given, table: Table, prover: Prover | None) -> Expr | None:
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
    """The same of a value, or of a derivative: its function must be smooth where it is taken."""
    names, body = opened(e)
    points = e.args[1:]
    there = substitute(body, dict(zip(names, points, strict=True)))
    asked = _differentiable_of if e.op == "derivative" else table
    missing = (_missing(point, given, needs_of, prover) for point in points)
    return next(filter(None, missing), None) or _missing(there, given, asked, prover)


def _holds(e: Expr, relation: str, given: Given, prover: Prover | None) -> bool:
    (e,) = generalised(e)
    return sign_by(e, given, relation, prover) in PROVING[relation]
