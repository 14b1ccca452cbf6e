"""Work out a written comparison, and keep which derivatives and values at points were written."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from tresym.reals.decisions.statement import (
    Derivative,
)
from tresym.reals.language import expression
from tresym.reals.language.binders import elementary, outermost
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.expression import (
    LEAVES,
    Expr,
    instantiate,
    symbols,
)
from tresym.reals.language.parsing import NO_INFINITY
from tresym.reals.numbers.exact import InputError

if TYPE_CHECKING:
    pass


NOT_DECIDED = {
    "antiderivative": (
        "an indefinite integral must be compared with an antiderivative: integral(f, x) == F"
    ),
    "limit": "a limit must stand alone on its side: write limit(f, x, a) == L, or f -> L as x -> a",
    "at": "a value at a point is not supported here: substitute the point yourself",
    "derivative": "the value of a derivative at a point is not supported: write the derivative out",
    **dict.fromkeys(
        expression.ORDERS, "O(…) and o(…) belong on the right side of a claim: f == g + O(h)"
    ),
}
VALUED = ("integral", "nth", "sum", "product", "root", "unknown")
"""What may stand in a claim and is worked out when it is decided."""


def read_derivatives(e: Expr, work: Callable[[Expr], Expr]) -> Iterator[Derivative]:
    """The derivatives that are written in ``e``, inner ones first, worked out by ``work``.

    Raises:
        InputError: what else binds a variable and is not decided.
    """
    if _is_infinite(e):
        raise InputError(NO_INFINITY)
    for node in outermost(e):
        place = node.args[-1]
        if node.op in VALUED:
            if not all(map(_is_valued, work(node).args)):
                raise InputError(
                    "an integrand or summand cannot contain a derivative, a "
                    "limit or an order term here"
                )
            continue
        if _is_slope_of_unknown(node):
            continue
        if node.op == "at" and elementary(*node.args) and node.args[0].loose:
            continue
        fixed = place.op != "symbol" or bool(symbols(place) & symbols(node.args[0]))
        if node.op != "derivative" or fixed:
            raise InputError(NOT_DECIDED[node.op])
        function, times = node, 0
        while function.op == "derivative" and function.args[1] == place:
            function, times = instantiate(function.args[0], (place,)), times + 1
        yield from read_derivatives(function, work)
        yield Derivative(work(function), place.args[0], times, work(node))


def _is_infinite(e: Expr) -> bool:
    """Whether oo stands in it elsewhere than at the end of an integral."""
    if e.op in LEAVES or INFINITY.args[0] not in symbols(e):
        return e == INFINITY
    ends = (INFINITY, -INFINITY) if e.op in ("integral", "sum", "product", "root") else ()
    return any(_is_infinite(arg) for arg in e.args if arg not in ends)


def _is_slope_of_unknown(node: Expr) -> bool:
    """Whether it is a derivative of a function left unknown, at some point."""
    points: list[Expr] = []
    while node.op in ("derivative", "at"):
        points += node.args[1:]
        node = node.args[0]
    return node.op == "unknown" and all(map(_is_valued, (*points, *node.args)))


def _is_valued(e: Expr) -> bool:
    """Whether nothing that binds is in it but what may be."""
    if e.op in LEAVES:
        return True
    return (e.op in VALUED or e.op not in expression.UNWORKED) and all(map(_is_valued, e.args))
