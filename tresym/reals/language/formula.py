"""Formulas: relations between expressions, conjunctions and equivalences."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import NamedTuple, TypeAlias

from tresym.reals.language.expression import Expr, symbols

Compared: TypeAlias = tuple[Expr, str, Expr]
"""``left relation right`` as written."""
MIRRORED = {"==": "==", "!=": "!=", ">": "<", "<": ">", ">=": "<=", "<=": ">="}
"""The relation of y to x for each relation of x to y."""
NEGATED = {"==": "!=", "!=": "==", ">": "<=", "<": ">=", ">=": "<", "<=": ">"}


class Relation(NamedTuple):
    """The relation ``left sign right``, with the sign ``==``, ``!=``, ``>``, ``>=``, ``<`` or
    ``<=``.
    """

    left: Expr
    sign: str
    right: Expr

    @property
    def mirrored(self) -> Relation:
        """Return the relation with its sides exchanged."""
        return Relation(self.right, MIRRORED[self.sign], self.left)

    @property
    def negated(self) -> Relation:
        """Return the relation that holds if this one fails and both sides are defined."""
        return Relation(self.left, NEGATED[self.sign], self.right)

    @property
    def upward(self) -> Relation:
        """Return the relation with ``>`` or ``>=`` in place of ``<`` or ``<=``."""
        return self.mirrored if self.sign in ("<", "<=") else self

    def __str__(self) -> str:
        return f"{self.left} {self.sign} {self.right}"


class Conjunction(NamedTuple):
    """The conjunction of ``parts``; without parts it is always true."""

    parts: tuple[Formula, ...]

    def __str__(self) -> str:
        return " and ".join(map(str, self.parts))


class Equivalence(NamedTuple):
    """The statement that ``first`` holds if and only if ``second`` does."""

    first: Formula
    second: Formula

    def __str__(self) -> str:
        return f"{self.first} <=> {self.second}"


Formula: TypeAlias = Relation | Conjunction | Equivalence


def relations(formula: Formula) -> Iterator[Relation]:
    """Yield the relations in a formula, in order."""
    if isinstance(formula, Relation):
        yield formula
    else:
        parts = formula.parts if isinstance(formula, Conjunction) else formula
        for part in parts:
            yield from relations(part)


def names(formula: Formula) -> frozenset[str]:
    """Return the names of the free variables in a formula."""
    sides = (side for relation in relations(formula) for side in (relation.left, relation.right))
    return frozenset().union(*map(symbols, sides))


def chained(comparisons: Iterable[Compared]) -> str:
    """Return comparisons as text, with a common side written once, as in ``0 < x <= 1``."""
    text = ""
    last: tuple[Expr | None, str] = (None, "")
    for left, relation, right in comparisons:
        goes_on = left is last[0] and relation[0] == last[1][0]
        joint = "" if goes_on else f"{', ' if text else ''}{left}"
        text += f"{joint} integer" if relation == "in" else f"{joint} {relation} {right}"
        last = right, relation
    return text
