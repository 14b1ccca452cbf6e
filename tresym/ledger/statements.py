"""Statements for which SymPy has no class, as unevaluated expressions.

A statement is a relation, several in a `Tuple`, an equivalence, or one of these. Its free symbols
are meant for all their values under the conditions of the claim, but for those that are defined.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from sympy import Basic, Eq, Expr, Integer, Symbol, Tuple
from sympy.core.symbol import Str
from sympy.core.sympify import _sympify


class Statement(Basic):
    """A statement with a head of its own."""

    def __new__(cls, *args: Any) -> Statement:
        """The head over these arguments, SymPy's or Python's numbers."""
        made: Statement = Basic.__new__(cls, *map(_sympify, args))
        return made


class Binding:
    """``(x, low, high, φ)``: the name x is bound in φ, and only there; the ends do not count."""

    args: tuple[Any, ...]

    @property
    def variables(self) -> tuple[Symbol]:
        """The name that is bound."""
        return (self.args[0],)

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


class ExactlyOne(Binding, Statement):
    """``ExactlyOne(x, low, high, φ)``: one x between the ends, and no other, is such that φ."""


class AtMostOne(Binding, Statement):
    """``AtMostOne(x, low, high, φ)``: no two x between the ends are such that φ."""


class TheRoot(Binding, Expr):
    """``TheRoot(x, low, high, φ)``, a number: the x of which φ, an equation, is true, where there
    is one and no other. To have it takes a claim that there is one at most."""

    is_commutative = True
    is_real = True

    def __new__(cls, *args: Any) -> TheRoot:
        """As written."""
        made: TheRoot = Expr.__new__(cls, *map(_sympify, args))
        return made


class Rounds(Statement):
    """``Rounds(e, "0.1150")``: e lies within half a unit of the last place that is printed.

    As a condition on a symbol it is an input as it is printed. What is stated under such conditions
    is that some inputs that round to those printed give what rounds to what is printed.
    """

    def __new__(cls, term: Any, text: Any, half_units: Any = 1) -> Rounds:
        """The text as it is printed, digits and all."""
        text = text if isinstance(text, Str) else Str(text)
        made: Rounds = Basic.__new__(cls, _sympify(term), text, _sympify(half_units))
        return made

    @property
    def term(self) -> Expr:
        """What is printed a number for."""
        return self.args[0]

    @property
    def text(self) -> str:
        """The number as it is printed."""
        return str(self.args[1])

    @property
    def half_units(self) -> int:
        """Half the width of what is meant, in half units of the last place."""
        return int(self.args[2])


class Under(Statement):
    """``Under(φ, (condition, …))``: φ wherever the conditions hold; a part of a conjunction."""


class ForSome(Statement):
    """``ForSome(φ)``: φ at one point at least under the conditions of the claim."""


class As(Statement):
    """``As(φ, e, p, side)``: the order φ as e tends to p: from above (1), below (−1), or both (0).

    φ is an equation with one O(…) or o(…); it holds uniformly in what else is free under the
    conditions of the claim.
    """


def order(relation: Basic, x: Basic, point: Any = 0, side: int = 1) -> As:
    """``relation``, an equation with one O(…) or o(…), as ``x`` tends to ``point``.

    Several things may tend at once: then both are tuples. Infinity is reached from below.
    """
    return As(relation, x, point, Integer(side))


def together_under(parts: Iterable[tuple[Basic, tuple[Basic, ...]]]) -> Tuple:
    """A conjunction, each of its parts under its own conditions, each part once."""
    whole: dict[Basic, None] = {}
    for says, given in parts:
        conjoined = isinstance(says, Tuple) and all(isinstance(p, Under) for p in says.args)
        part = says.args if conjoined and not given else (Under(says, Tuple(*given)),)
        whole.update(dict.fromkeys(part))
    return Tuple(*whole)
