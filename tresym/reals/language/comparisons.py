"""What a comparison states: an order by its gauge, a limit by its body, a derivative by its value.

``sin(x) == x + O(x**3)`` states that ``sin(x) - x`` is O of the gauge x³, ``limit(f, x, 0) == 1``
that f tends to 1 as x -> 0, and ``integral(2*x, x) == x**2`` that the derivative of x² is 2x. Which
derivatives and values at points were written is kept, because a derivative is one only where its
function is real.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cache
from typing import NamedTuple

from tresym.reals.language import expression
from tresym.reals.language.binders import elementary, is_infinite, outermost, worked_out
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    LEAVES,
    ZERO,
    Expr,
    add,
    factors_in,
    instantiate,
    multiply,
    opened,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import Compared
from tresym.reals.language.parsing import NO_INFINITY
from tresym.reals.language.paths import Path, ending
from tresym.reals.numbers.exact import InputError

ORDERS = ("O", "o", "~", "Theta", "omega")
LIMIT = "->"
_LONE = "a limit must stand alone on one side and be compared by == with its value"
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
VALUED = ("integral", "nth", "sum", "product", "root", "unknown", "coefficient")
"""What may stand in a claim and is worked out when it is decided."""


class Derivative(NamedTuple):
    """A derivative that was written: of which function, by which variable, how often; its value."""

    function: Expr
    by: str
    order: int
    value: Expr


@dataclass(frozen=True)
class Comparison:
    """``left relation right``; for an order the right side is the gauge, for ``->`` the limit.

    Attributes:
        derivatives: those that were written: a derivative is one where its function is real, there
            and beside it.
        primitives: functions whose values at a point were written, as bodies of one variable: of an
            integral they may be antiderivatives.
    """

    left: Expr
    relation: str
    right: Expr
    derivatives: tuple[Derivative, ...] = ()
    primitives: tuple[Expr, ...] = ()

    @property
    def differentiated(self) -> tuple[Expr, ...]:
        """The functions whose derivatives were written."""
        return tuple(dict.fromkeys(found.function for found in self.derivatives))

    @property
    def by(self) -> frozenset[str]:
        """The variables by which."""
        return frozenset(found.by for found in self.derivatives)

    def solved(self, node: Expr) -> tuple[Expr, Expr] | None:
        """Solve the equation for ``node``; None if it is not linear in it.

        Returns:
            The value, and the coefficient that was divided by: where that is 0, the value says
            nothing, and the claim must be decided by itself.
        """
        mark = symbol("[S]")
        left, right = (replaced(side, {node: mark}) for side in (self.left, self.right))
        gap = left - right
        slope = differentiate(gap, "[S]")
        if "[S]" in symbols(slope) or slope == ZERO:
            return None
        rest = substitute(gap, {"[S]": ZERO})
        return rest * (-1 / slope), slope

    def mapped(self, change: Callable[[Expr], Expr]) -> Comparison:
        """The comparison of changed sides, their derivatives with them."""
        derivatives = (
            d._replace(function=change(d.function), value=change(d.value)) for d in self.derivatives
        )
        left, right = change(self.left), change(self.right)
        return replace(self, left=left, right=right, derivatives=tuple(derivatives))


def comparison_of(left: Expr, relation: str, right: Expr) -> Comparison:
    """What is decided of a comparison: derivatives carried out, an order as its gauge."""
    right = spread(right)
    terms = right.args if right.op == "+" else (right,)
    orders = [term for term in terms if term.op in expression.ORDERS]
    if relation == "==" and len(orders) == 1:
        rest = [term for term in terms if term is not orders[0]]
        left = left - add(*rest) if rest else left
        relation, right = orders[0].op, orders[0].args[0]
    if any(n.op == "antiderivative" for n in outermost(left, right)) and relation == "==":
        return _without_ends(left, right)
    if relation == LIMIT and right in (INFINITY, -INFINITY):
        return replace(comparison_of(left, relation, ZERO), right=right)
    if relation == "==" and right in (INFINITY, -INFINITY) and left.op in ("integral", "sum"):
        return replace(comparison_of(left, relation, ZERO), right=right)
    work = cache(worked_out)
    written = tuple(
        dict.fromkeys(d for side in (left, right) for d in read_derivatives(side, work))
    )
    values = (node for node in outermost(left, right) if node.op == "at" and len(node.names) == 1)
    primitives = tuple(dict.fromkeys(node.args[0] for node in values))
    return Comparison(work(left), relation, work(right), written, primitives)


def spread(e: Expr) -> Expr:
    """``c (f + O(g))`` as ``c f + O(c g)``."""
    if e.op == "+":
        return add(*map(spread, e.args))
    parts = e.args if e.op == "*" and not elementary(e) else ()
    factors = [part for part in parts if not elementary(part)]
    summands = terms(factors[0]) if len(factors) == 1 else ()
    rest = multiply(*(part for part in parts if part is not factors[0]))
    if not any(term.op in ("O", "o") for term in summands):
        return e
    return add(
        *(
            Expr(term.op, (rest * term.args[0],)) if term.op in ("O", "o") else rest * term
            for term in summands
        )
    )


def terms(e: Expr) -> tuple[Expr, ...]:
    """Return the terms of a sum; of anything else itself."""
    return e.args if e.op == "+" else (e,)


def is_order(parts: tuple[Compared, ...]) -> bool:
    """Whether a claim is an order with a constant, O(…) at its right end."""
    right = spread(parts[0][2])
    return len(parts) == 1 and any(term.op == "O" for term in terms(right))


def limit_of(left: Expr, relation: str, right: Expr, path: Path | None) -> tuple[Comparison, Path]:
    """``limit(f, x, p) == L`` as ``f -> L`` on its path."""
    if path is not None:
        raise InputError("limit(…) states its own path: leave out the other one")
    left, value = (left, right) if left.op == "limit" else (right, left)
    if relation != "==" or not (elementary(value) or is_infinite(value)):
        raise InputError(_LONE)
    (name,), body = opened(left, symbols(value))
    side = {1: "+", -1: "-"}.get(int(left.args[2].args[0].p), "")
    return comparison_of(body, LIMIT, value), ending(name, left.args[1], side)


def _without_ends(left: Expr, right: Expr) -> Comparison:
    """An equation of integrals without ends as one of derivatives."""
    names, known, rest = set(), [], []
    for term in (*terms(left), *(-term for term in terms(right))):
        nodes = [node for node in outermost(term) if node.op == "antiderivative"]
        if not nodes:
            rest.append(-term)
            continue
        (node, *others), name = nodes, str(nodes[0].args[1])
        parts = factors_in(term)
        factors = [part for part in parts if part != node]
        if others or len(factors) != len(parts) - 1 or name in symbols(multiply(*factors)):
            raise InputError(NOT_DECIDED["antiderivative"])
        names.add(name)
        known.append(multiply(*factors, instantiate(node.args[0], (node.args[1],))))
    if len(names) != 1:
        raise InputError(
            "all indefinite integrals of a claim must have the same variable of integration"
        )
    (by,) = names
    f, function = (worked_out(add(*terms)) for terms in (known, rest))
    for side in (f, function):
        tuple(read_derivatives(side, worked_out))
    value = differentiate(function, by)
    return Comparison(value, "==", f, (Derivative(function, by, 1, value),))


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
