"""Statements of the ledger as claims made of claims, which the engine decides as a whole.

Example: ``Conserved(x**2 + v**2, (x, v), (v, -x))`` is the claim ``conserved(x**2 + v**2) along
(x, v)' == (v, -x)``, and ``ExactlyOne(x, 0, 1, Eq(x**3, a))`` is ``exactly one x in (0, 1): x**3 ==
a``. Definitions are put in on the way. Every side is shown to be defined, since the engine decides
a statement where its sides are.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from sympy import Basic, Symbol, Tuple
from sympy.core.relational import Relational

from tresym.ledger.conversion import Conditions, formula
from tresym.ledger.evidence.integrals import NotShownError, need
from tresym.ledger.evidence.sign_prover import undefined
from tresym.ledger.statements import (
    AtMostOne,
    Conserved,
    ExactlyOne,
    ForSome,
    StableEquilibrium,
    StrictlyDecreasing,
    StrictlyIncreasing,
    Under,
    UnstableEquilibrium,
)
from tresym.reals.language import named_claims
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
)
from tresym.reals.language.expression import Expr, symbols
from tresym.reals.language.formula import Compared, Relation

_COUNTS = {ExactlyOne: "exactly one", AtMostOne: "at most one"}
_SHAPES = {StrictlyIncreasing: "increasing", StrictlyDecreasing: "decreasing"}
_EQUILIBRIA = {StableEquilibrium: "stable", UnstableEquilibrium: "unstable"}


def whole_claim(says: Basic, put: Callable[[Basic], Expr], given: Conditions) -> Compound:
    """Return a statement as a claim of the language.

    Args:
        says: the statement.
        put: returns the tree of an expression, with definitions put in.
        given: the conditions, with definitions put in.

    Raises:
        NotShownError: the language has no such claim, or a side is not shown to be defined.
    """
    links = tuple((c.left, c.sign, c.right) for c in given)
    return Compound(_Statement(put).formula(says, links), links, text=str(says))


def bound_by(part: Leaf) -> tuple[str, ...]:
    """Return the variables that a part of a claim moves or counts."""
    if isinstance(part, Count | Shape):
        return (part.name,)
    return () if isinstance(part, Written | Somewhere) else part.names


class _Statement:
    """Convert the parts of a statement."""

    def __init__(self, put: Callable[[Basic], Expr]) -> None:
        self.put = put

    def formula(self, says: Basic, given: tuple[Compared, ...]) -> Formula:
        if isinstance(says, Tuple):
            return Together(tuple(self._flat(says, given)))
        if isinstance(says, Under):
            return self.formula(says.args[0], (*given, *map(self._link, says.args[1].args)))
        if type(says).__name__ == "Equivalent":
            return Equivalent(tuple(self.formula(part, given) for part in says.args))
        if isinstance(says, ForSome):
            links = tuple(self._link(part) for part in _parts(says.args[0]))
            return Somewhere(links, given)
        if isinstance(says, Relational):
            link = self._link(says)
            self._need_defined(link[::2], given)
            return Written((link,), given, None)
        return self._named(says, given)

    def _flat(self, says: Basic, given: tuple[Compared, ...]) -> Iterator[Formula]:
        for part in says.args:
            made = self.formula(part, given)
            yield from made.parts if isinstance(made, Together) else (made,)

    def _named(self, says: Basic, given: tuple[Compared, ...]) -> Formula:
        kind = type(says)
        if kind in _COUNTS:
            x, low, high = map(self.put, says.args[:3])
            name = str(says.args[0])
            about = frozenset().union(*(symbols(side) for c in given for side in c[::2]))
            need(name not in about, f"the conditions speak of {name}, which is bound")
            apart = name not in symbols(low) | symbols(high)
            need(apart, f"the ends of the interval must not depend on the bound variable {name}")
            link = self._link(says.args[3])
            need(link[1] == "==", "solutions are counted of an equation")
            self._need_defined(link[::2], (*given, (low, "<", x), (x, "<", high)))
            return Count(_COUNTS[kind], name, low, high, (False, False), link, given)
        if kind in _SHAPES:
            function = self.put(says.args[0])
            self._need_defined((function,), given)
            return Shape(_SHAPES[kind], function, str(says.args[1]), given)
        vectors = says.args[1:] if isinstance(says, Conserved) else says.args
        if isinstance(says, Conserved) or kind in _EQUILIBRIA:
            names = tuple(map(str, vectors[0].args))
            rates = tuple(map(self.put, vectors[1].args))
            plain = all(isinstance(x, Symbol) for x in vectors[0].args)
            once = len({*names}) == len(names) == len(rates) > 0
            need(plain and once, "a system of equations needs one rate for each variable")
            if isinstance(says, Conserved):
                function = self.put(says.args[0])
                self._need_defined((function, *rates), given)
                return named_claims.Conserved(function, names, rates, given)
            self._need_defined(rates, given)
            point = tuple(map(self.put, vectors[2].args))
            need(len(point) == len(names), "each variable needs one coordinate")
            how = _EQUILIBRIA[kind]
            return named_claims.Equilibrium(how, names, point, rates, None, given)
        need(False, f"{kind.__name__} is not a statement that the engine decides")
        raise AssertionError

    def _link(self, part: Basic) -> Compared:
        relation = formula(part) if isinstance(part, Relational) else None
        if not isinstance(relation, Relation):
            raise NotShownError(f"{part} is not a relation between numbers")
        return self.put(part.args[0]), relation.sign, self.put(part.args[1])

    def _need_defined(self, sides: tuple[Expr, ...], given: tuple[Compared, ...]) -> None:
        where = tuple(Relation(*link) for link in given if link[1] != "==")
        for side in sides:
            gap = undefined(worked_out(side), where)
            need(gap is None, f"could not show that {gap} lies in the domain of its operation")


def _parts(says: Basic) -> tuple[Basic, ...]:
    return says.args if isinstance(says, Tuple) else (says,)
