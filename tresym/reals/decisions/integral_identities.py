"""Identities of integrals that hold whatever their values are: linearity, and intervals joined.

An integrand is a sum of terms c g, with c independent of the variable of integration. If each g is
proved to be smooth on the interval, ∫ c g from a to b is c (G(b) − G(a)) for an antiderivative G of
g, and a new variable replaces each value of each G. A claim that holds for all values of these
variables is proved. The antiderivative of f′ is f, that of an arbitrary function f is another
arbitrary function. A claim that fails for some values of the variables is not thereby refuted.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from tresym.reals.decisions.identity import decide
from tresym.reals.decisions.leibniz import between, is_smooth
from tresym.reals.domain.conditions import Given
from tresym.reals.language.binders import elementary, outermost
from tresym.reals.language.expression import (
    ONE,
    Expr,
    add,
    bind,
    instantiate,
    multiply,
    opened,
    replaced,
    symbol,
    symbols,
    unknown,
)
from tresym.reals.language.like_terms import collected
from tresym.reals.verdict import Verdict


@dataclass
class Antiderivatives:
    """Values of antiderivatives, as they are met.

    Attributes:
        known: the integrand as a body, the point, and the variable for the value there.
        any_values: whether none of them stands for the value of an integral that is not worked out.
    """

    given: Given
    known: list[tuple[Expr, Expr, Expr]] = field(default_factory=list)
    any_values: bool = True

    def put_in(self, e: Expr) -> Expr | None:
        """``e`` with variables for the values of its integrals; None where one is not smooth."""
        values: dict[Expr, Expr] = {}
        for node in dict.fromkeys(outermost(e)):
            if node.op == "unknown":
                continue
            value = self._integral(node) if node.op == "integral" else None
            if value is None:
                return None
            values[node] = value
        return replaced(e, values)

    def _integral(self, node: Expr) -> Expr | None:
        (t,), f = opened(node, self.given.names)
        low, high = node.args[1:]
        if not elementary(low, high) or "oo" in symbols(low) | symbols(high):
            return None
        whole, values = collected(f), []
        for term in whole.args if whole.op == "+" else (whole,):
            factors = term.args if term.op == "*" else (term,)
            rest = [factor for factor in factors if t in symbols(factor)]
            scale = multiply(*(factor for factor in factors if t not in symbols(factor)))
            g = multiply(*rest) if rest else ONE
            if any(inner.op != "unknown" for inner in outermost(g, scale)):
                return None
            regions = between(t, low, high, self.given)
            if not (is_smooth(g, Given()) or all(is_smooth(g, inside) for inside in regions)):
                return None
            values.append(scale * (self._at(g, t, high) - self._at(g, t, low)))
        return add(*values)

    def _at(self, g: Expr, t: str, point: Expr) -> Expr:
        """The value of an antiderivative of ``g``, a function of ``t``, at the point."""
        if g == ONE:
            return point
        if g.op == "unknown" and g.args[1:] == (symbol(t),):
            name, (order,) = g.args[0].args
            if order:
                return unknown(name, (point,), (order - 1,))
            self.any_values = False  # a point says nothing of the integral of f
            return unknown(f"∫{name}", (point,))
        self.any_values = False
        body = bind(g, (t,))
        for other, end, variable in self.known:
            is_there = end == point or _are_equal(end, point)
            if is_there and (other == body or _are_equal(instantiate(other, (symbol(t),)), g)):
                return variable
        self.known.append((body, point, symbol(f"[∫ {g} d{t} at {point}]")))
        return self.known[-1][2]


def _are_equal(one: Expr, other: Expr) -> bool:
    return elementary(one, other) and decide(one, other).verdict is Verdict.PROVED
