"""An integral up to h(x) → ∞ as its value to infinity less what is beyond h(x).

If ∫ f from a to ∞ is known, by an antiderivative or a table, then

    ∫_a^h f = ∫_a^∞ f − ∫_h^∞ f,

and the last integral has an expansion by Laplace's method or by integration by parts.

Example: ``integral(sin(t)/t, t, 0, x) == pi/2 - cos(x)/x + O(1/x**2)``.

Source: additivity of the integral; values by Gradshteyn and Ryzhik.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable

from tresym.asymptotics.lemma import Bound, End, Expansion, Obligations
from tresym.reals.decisions.integrals import without_integrals
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.expression import Expr, rebuild, symbols
from tresym.reals.numbers.exact import InputError


class Complement(Expansion):
    """The value of the whole integral less the expansion of its tail."""

    def __init__(self, value: Expr, tail: Expansion) -> None:
        """Expand an integral with a known value to infinity."""
        self.value, self.tail = value, tail
        self.lemma, self.unknown, self.constants = tail.lemma, tail.unknown, tail.constants

    def terms(self, order: int) -> tuple[Expr, Expr] | None:
        """Return the value less the terms of the tail, and the error of these."""
        found = self.tail.terms(order)
        return None if found is None else (self.value - found[0], found[1])

    def prove(self, order: int, ask: Obligations) -> Bound | None:
        """Prove the bound of the tail."""
        return self.tail.prove(order, ask)


def complement(
    node: Expr, end: End, lemmas: Iterable[Callable[[Expr, End], Expansion | None]]
) -> Complement | None:
    """Return the expansion of an integral with a fixed lower end, or None.

    Args:
        lemmas: what may expand the tail.
    """
    if node.op != "integral":
        return None
    body, low, high = node.args
    fixed = end.name not in symbols(body) | symbols(low)
    if not fixed or low == -INFINITY or high == INFINITY or not end.tends_to_infinity(high):
        return None
    try:
        tails = (lemma(rebuild(node, (body, high, INFINITY)), end) for lemma in lemmas)
        tail = next((found for found in tails if found is not None), None)
        if tail is None:
            return None
        whole = without_integrals([rebuild(node, (body, low, INFINITY))], end.given, ())
    except (InputError, ZeroDivisionError, OverflowError):
        return None
    if whole is None or INFINITY.args[0] in symbols(whole[0][0]):
        return None
    return Complement(whole[0][0], tail)
