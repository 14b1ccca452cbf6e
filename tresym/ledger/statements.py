"""What statements are made of that SymPy has no name for: heads that nobody works out.

A statement is a relation, several in a `Tuple`, an equivalence, or one of these. Its free symbols
are meant for all their values under the conditions of the claim, but for those that are defined.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from sympy import Basic, Eq, Expr, Integer, Symbol, Tuple, sympify


class Statement(Basic):
    """A statement with a head of its own."""

    def __new__(cls, *args: Any) -> Statement:
        """The head over these arguments, SymPy's or Python's numbers."""
        made: Statement = Basic.__new__(cls, *map(sympify, args))
        return made


class ExactlyOne(Statement):
    """``ExactlyOne(x, low, high, φ)``: one x between the ends, and no other, is such that φ.

    The ends do not count. The name x is bound in φ, and only there.
    """

    @property
    def free_symbols(self) -> set[Basic]:
        """The symbols of which it speaks."""
        inner: Basic = self.args[3]
        return self.low.free_symbols | self.high.free_symbols | inner.free_symbols - {self.variable}

    @property
    def variable(self) -> Symbol:
        """What is bound."""
        return self.args[0]

    @property
    def low(self) -> Expr:
        """The end below."""
        return self.args[1]

    @property
    def high(self) -> Expr:
        """The end above."""
        return self.args[2]

    @property
    def difference(self) -> Expr | None:
        """What vanishes at the one, where φ is an equation."""
        inner = self.args[3]
        return inner.lhs - inner.rhs if isinstance(inner, Eq) else None


class Under(Statement):
    """``Under(φ, (condition, …))``: φ wherever the conditions hold; a part of a conjunction."""


class ForSome(Statement):
    """``ForSome(φ)``: φ at one point at least under the conditions of the claim."""


class As(Statement):
    """``As(φ, x, p, side)``: the order φ as x tends to p: from above (1), below (−1), or both (0).

    φ is an equation that ends in O(…) or o(…); what else is free in it is held.
    """


def order(relation: Basic, x: Symbol, point: Any = 0, side: int = 1) -> As:
    """``relation``, an equation that ends in O(…) or o(…), as ``x`` tends to ``point``."""
    return As(relation, x, point, Integer(side))


def together_under(parts: Iterable[tuple[Basic, tuple[Basic, ...]]]) -> Tuple:
    """A conjunction, each of its parts under its own conditions, each part once."""
    whole: dict[Basic, None] = {}
    for says, given in parts:
        conjoined = isinstance(says, Tuple) and all(isinstance(p, Under) for p in says.args)
        part = says.args if conjoined and not given else (Under(says, Tuple(*given)),)
        whole.update(dict.fromkeys(part))
    return Tuple(*whole)
