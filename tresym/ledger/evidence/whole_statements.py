"""Statements of the ledger as claims made of claims, which the engine decides as a whole.

Example: where ``y := x**2``, the statement ``exactly one x in (0, 1): y == a`` is handed over as
``exactly one x in (0, 1): x**2 == a``. Definitions are put in on the way. Every side is shown to be
defined, since the engine decides a statement where its sides are.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from tresym.ledger.conversion import Conditions
from tresym.ledger.evidence.integrals import NotShownError, need
from tresym.ledger.evidence.sign_prover import undefined
from tresym.ledger.formulas import Says, Under
from tresym.reals.language.binders import worked_out
from tresym.reals.language.claims import Written
from tresym.reals.language.compound import (
    Compound,
    Count,
    Equivalent,
    Formula,
    Leaf,
    Shape,
    Somewhere,
    Together,
    mapped,
)
from tresym.reals.language.expression import Expr, symbol, symbols
from tresym.reals.language.formula import Compared, Relation
from tresym.reals.language.named_claims import Conserved, Equilibrium

_COUNTED = ("exactly one", "at most one")
_SHAPES = ("increasing", "decreasing")


def whole_claim(says: Says, put: Callable[[Expr], Expr], given: Conditions) -> Compound:
    """Return a statement as a claim of the language.

    Args:
        says: the statement.
        put: returns an expression with definitions put in.
        given: the conditions, with definitions put in.

    Raises:
        NotShownError: the engine decides no such claim, or a side is not shown to be defined.
    """
    links: tuple[Compared, ...] = tuple((c.left, c.sign, c.right) for c in given)
    return Compound(_Statement(put).formula(says, links), links, text=str(says))


def bound_by(part: Leaf) -> tuple[str, ...]:
    """Return the variables that a part of a claim moves or counts."""
    if isinstance(part, Count | Shape):
        return (part.name,)
    return () if isinstance(part, Written | Somewhere) else part.names


class _Statement:
    """Convert the parts of a statement."""

    def __init__(self, put: Callable[[Expr], Expr]) -> None:
        self.put = put

    def formula(self, says: Any, given: tuple[Compared, ...]) -> Formula:
        if isinstance(says, Together):
            return Together(tuple(self._flat(says, given)))
        if isinstance(says, Under):
            return self.formula(says.formula, (*given, *map(self._link, says.given)))
        if isinstance(says, Equivalent):
            return Equivalent(tuple(self.formula(part, given) for part in says.parts))
        if isinstance(says, Somewhere):
            return Somewhere(tuple(map(self._link, says.comparisons)), given)
        if isinstance(says, Relation):
            link = self._link(says)
            self._need_defined(link[::2], given)
            return Written((link,), given, None)
        return self._named(says, given)

    def _flat(self, says: Together, given: tuple[Compared, ...]) -> Iterator[Formula]:
        for part in says.parts:
            made = self.formula(part, given)
            yield from made.parts if isinstance(made, Together) else (made,)

    def _named(self, says: Any, given: tuple[Compared, ...]) -> Formula:
        named = isinstance(says, Count | Shape | Conserved | Equilibrium)
        need(named, f"{type(says).__name__} is not a statement that the engine decides")
        put: Any = mapped(says, self.put)
        put = put._replace(given=given)
        if isinstance(says, Count) and says.how in _COUNTED:
            name = says.name
            about = frozenset().union(*(symbols(side) for c in given for side in c[::2]))
            need(name not in about, f"the conditions speak of {name}, which is bound")
            apart = name not in symbols(says.low) | symbols(says.high)
            need(apart, f"the ends of the interval must not depend on the bound variable {name}")
            need(says.equation[1] == "==", "solutions are counted of an equation")
            within = ((put.low, "<", symbol(name)), (symbol(name), "<", put.high))
            self._need_defined(put.equation[::2], (*given, *within))
            return put
        if isinstance(says, Shape) and says.how in _SHAPES:
            self._need_defined((put.function,), given)
            return put
        if isinstance(says, Conserved | Equilibrium):
            once = len({*says.names}) == len(says.names) == len(says.rates) > 0
            need(once, "a system of equations needs one rate for each variable")
            if isinstance(put, Conserved):
                self._need_defined((put.function, *put.rates), given)
            else:
                self._need_defined(put.rates, given)
                need(len(put.point) == len(put.names), "each variable needs one coordinate")
            return put
        raise NotShownError(f"'{says.how}' is not what the engine decides here")

    def _link(self, part: Any) -> Compared:
        if not isinstance(part, tuple) or len(part) != 3:
            raise NotShownError(f"{part} is not a relation between numbers")
        left, sign, right = part
        return self.put(left), sign, self.put(right)

    def _need_defined(self, sides: tuple[Expr, ...], given: tuple[Compared, ...]) -> None:
        where = tuple(Relation(*link) for link in given if link[1] != "==")
        for side in sides:
            gap = undefined(worked_out(side), where)
            need(gap is None, f"could not show that {gap} lies in the domain of its operation")
