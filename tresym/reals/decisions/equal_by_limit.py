"""Prove an identity between special functions of one variable by its derivative and one limit.

If the derivative of the difference (or of the quotient) of two sides has normal form 0, then the
difference is constant on every interval on which both sides are analytic; a limit 0 at an end of
the interval, or an exact value inside it, shows that the constant is 0. So Legendre's relation
follows from its limit as m → 0+, and the Wronskian of J₀ and Y₀ from that as x → 0+.

The points at which a side is not analytic must be known rational numbers, which cut the line into
intervals. Of the quotient it is enough that it is 1 on a part of an interval: the left side minus
the right one is then analytic on the interval and vanishes on that part.
"""

from __future__ import annotations

from contextlib import suppress
from itertools import pairwise
from typing import Any, TypeAlias

from flint import fmpq

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.operation_domains import analytic_of, bound, operations
from tresym.reals.expansions.limit_values import limit_of
from tresym.reals.functions.table import SPECIAL
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import ONE, ZERO, Expr, number, substitute, symbol, symbols
from tresym.reals.normal.field import ALL_THEORIES, Field
from tresym.reals.normal.locally_constant import equal_constants
from tresym.reals.normal.ring import UndefinedError
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.numbers.factoring import TooLargeError
from tresym.reals.signs.interior import PROVING
from tresym.reals.signs.sign import sign_by

End: TypeAlias = Any
"""A rational number, or None for an infinite end."""
INSIDE = (fmpq(0), fmpq(1), fmpq(1, 2), fmpq(-1), fmpq(2))
MAX_SIZE = 300


def equal_by_limit(left: Expr, right: Expr, given: Given) -> str | None:
    """Prove that two sides are equal at almost all points, or return None.

    Args:
        left: one side.
        right: the other side.
        given: the conditions.

    Returns:
        A sentence that states the proof.
    """
    names = symbols(left) | symbols(right)
    parts = list(operations((left, right)))
    if (
        left.hidden
        or right.hidden
        or len(names) != 1
        or not any(node.op in SPECIAL for node in parts)
    ):
        return None
    if given.names - names or left.size + right.size > MAX_SIZE:
        return None
    (name,) = names
    pieces = _pieces(parts, given, name)
    if not pieces:
        return None
    ways = [("difference", left - right, ZERO)]
    if right != ZERO:
        ways.append(("quotient", left / right, ONE))
    for what, e, target in ways:
        with suppress(InputError, TooLargeError, UndefinedError):
            (slope,) = Field(given, ALL_THEORIES, 64).normal(differentiate(e, name))
            if not slope.num.is_zero():
                continue
            places = [_place(e, target, name, piece) for piece in pieces]
            if all(places):
                shown = "; ".join(str(place) for place in places)
                return f"the derivative of the {what} has normal form 0, and it is {target} {shown}"
    return None


def _pieces(parts: list[Expr], given: Given, name: str) -> list[tuple[End, End]]:
    """Return the intervals of the domain on which all parts are analytic; [] if not known."""
    conditions = [part for node in parts for part in analytic_of(node)]
    conditions += [(c.expression, c.relation) for c in given.conditions]
    walls: set[fmpq] = set()
    other: list[tuple[Expr, str]] = []
    for e, relation in dict.fromkeys(conditions):
        if not symbols(e):
            continue
        left, _, right = bound(e, relation)
        if left == symbol(name) and right.op == "number":
            walls.add(fmpq(right.args[0]))
        else:
            other.append((e, relation))
    pieces: list[tuple[End, End]] = []
    for low, high in pairwise([None, *sorted(walls), None]):
        here = _inside(low, high, name)
        middle = {name: _middle(low, high)}
        with ball_precision():
            outside = any(
                evaluate(e, middle) < 0 and relation != "!="
                for e, relation in dict.fromkeys(conditions)
            )
        if outside:
            continue
        if not all(
            sign_by(e, here, relation.replace(">=", ">")) in PROVING[relation.replace(">=", ">")]
            for e, relation in other
        ):
            return []
        pieces.append((low, high))
    return pieces


def _inside(low: End, high: End, name: str) -> Given:
    x = symbol(name)
    comparisons: list[tuple[Expr, str, Expr]] = []
    comparisons += [(x, ">", number(low))] if low is not None else []
    comparisons += [(x, "<", number(high))] if high is not None else []
    return Given(tuple(comparisons))


def _middle(low: End, high: End) -> fmpq:
    if low is None:
        return fmpq(1, 7) if high is None else high - fmpq(8, 7)
    return low + fmpq(8, 7) if high is None else low + (high - low) * fmpq(3, 7)


def _place(e: Expr, target: Expr, name: str, piece: tuple[End, End]) -> str | None:
    """Return where the expression is, or tends to, its constant value; None if not found."""
    low, high = piece
    for at in INSIDE:
        if (low is None or at > low) and (high is None or at < high):
            with suppress(InputError):
                there = substitute(e, {name: number(at)})
                with ball_precision():
                    defined = evaluate(there, {}).is_finite()
                if defined and equal_constants(there, target, ALL_THEORIES):
                    return f"at {name} = {at}"
    for end, side in ((low, 1), (high, -1)):
        point = None if end is None else number(end)
        way = (1 if end is not None else -1) if side > 0 else (-1 if end is not None else 1)
        with suppress(InputError):
            limit = limit_of(e, name, point, way, Given())
            if limit is not None and equal_constants(limit, target, ALL_THEORIES):
                where = (
                    f"{'-' if way < 0 else ''}oo"
                    if end is None
                    else f"{end}{'+' if way > 0 else '-'}"
                )
                return f"in the limit {name} -> {where}"
    return None
