"""Formulas: relations between expressions, conjunctions and equivalences."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple, TypeAlias

from tresym.reals.language.expression import Expr, symbols

MIRRORED = {"==": "==", "!=": "!=", ">": "<", "<": ">", ">=": "<=", "<=": ">="}
"""The relation of y to x, for each that x may have to y."""
NEGATED = {"==": "!=", "!=": "==", ">": "<=", "<": ">=", ">=": "<", "<=": ">"}


class Relation(NamedTuple):
    """``left sign right``; the sign is one of ``== != > >= < <=``."""

    left: Expr
    sign: str
    right: Expr

    @property
    def mirrored(self) -> Relation:
        """The same, read from right to left."""
        return Relation(self.right, MIRRORED[self.sign], self.left)

    @property
    def negated(self) -> Relation:
        """What holds where both sides have values and the relation fails."""
        return Relation(self.left, NEGATED[self.sign], self.right)

    @property
    def upward(self) -> Relation:
        """The same, with ``>`` or ``>=`` for ``<`` and ``<=``."""
        return self.mirrored if self.sign in ("<", "<=") else self

    def __str__(self) -> str:
        return f"{self.left} {self.sign} {self.right}"


class Conjunction(NamedTuple):
    """All of ``parts``; with none, what always holds."""

    parts: tuple[Formula, ...]

    def __str__(self) -> str:
        return " and ".join(map(str, self.parts))


class Equivalence(NamedTuple):
    """``first`` wherever ``second``, and the other way round."""

    first: Formula
    second: Formula

    def __str__(self) -> str:
        return f"{self.first} <=> {self.second}"


Formula: TypeAlias = Relation | Conjunction | Equivalence


def relations(formula: Formula) -> Iterator[Relation]:
    """The relations that a formula consists of, in order."""
    if isinstance(formula, Relation):
        yield formula
    else:
        parts = formula.parts if isinstance(formula, Conjunction) else formula
        for part in parts:
            yield from relations(part)


def names(formula: Formula) -> frozenset[str]:
    """The names of the free variables in a formula."""
    sides = (side for relation in relations(formula) for side in (relation.left, relation.right))
    return frozenset().union(*map(symbols, sides))
