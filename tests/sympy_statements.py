"""Statements of claims in SymPy, as tests write them; a claim takes their trees.

A statement is a relation, a `Tuple` of relations, an equivalence, or an instance of one of the
classes below. It is meant for all values of its free symbols that satisfy the conditions of the
claim; symbols with a definition have the value that the definition gives them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any

from sympy import Basic, Derivative, Eq, Expr, Integer, Subs, Symbol, Tuple
from sympy.core.symbol import Str
from sympy.core.sympify import _sympify

from tresym.ledger import formulas
from tresym.ledger.formulas import Rounded, Tending, in_trees, parts_of
from tresym.reals.language import named_claims
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.compound import Count, Shape, Somewhere
from tresym.reals.language.expression import ZERO
from tresym.reals.language.paths import Path
from tresym.reals.numbers.exact import InputError

SIDES = {1: (1,), -1: (-1,), 0: (1, -1)}


def equal(left: Any, right: Any) -> Eq:
    """Return the equation ``left = right``, which SymPy is not allowed to evaluate."""
    return Eq(left, right, evaluate=False)


def equations(left: Any, right: Any) -> Tuple:
    """Return the system of equations ``left[i] = right[i]``; both have the same length."""
    return Tuple(*(equal(p, q) for p, q in zip(left, right, strict=True)))


def at(e: Expr, values: Mapping[Symbol, Any]) -> Subs:
    """Return ``e`` with its symbols replaced by ``values``, as an unevaluated `Subs`."""
    if e.has(Derivative) and len(set(values.values())) < len(values):
        raise ValueError(
            "two symbols get the same value inside a derivative; substitute one after the other"
        )
    return Subs(e, tuple(values), tuple(values.values()))


class Statement(Basic):
    """Base class of the statements in this module."""

    def as_tree(self) -> Any:
        """Return the statement of the ledger."""
        return _STATEMENTS[type(self).__name__](self)

    def __new__(cls, *args: Any) -> Statement:
        """Create the statement, unevaluated; Python numbers become SymPy numbers."""
        made: Statement = Basic.__new__(cls, *map(_sympify, args))
        return made


class Binding:
    """Mixin for nodes ``(x, low, high, φ)`` that bind x in φ, for x in the open interval."""

    args: tuple[Any, ...]

    @property
    def variables(self) -> tuple[Symbol]:
        """The bound variable, as a tuple of one."""
        return (self.args[0],)

    @property
    def free_symbols(self) -> set[Basic]:
        """The free symbols: those of the ends, and those of φ other than x."""
        inner: Basic = self.args[3]
        return self.low.free_symbols | self.high.free_symbols | inner.free_symbols - {self.variable}

    @property
    def variable(self) -> Symbol:
        """The bound variable x."""
        return self.args[0]

    @property
    def low(self) -> Expr:
        """The lower end of the interval."""
        return self.args[1]

    @property
    def high(self) -> Expr:
        """The upper end of the interval."""
        return self.args[2]

    @property
    def difference(self) -> Expr | None:
        """Left minus right side of φ; None if φ is not an equation."""
        inner = self.args[3]
        return inner.lhs - inner.rhs if isinstance(inner, Eq) else None


class ExactlyOne(Binding, Statement):
    """``ExactlyOne(x, low, high, φ)``: exactly one x between the ends satisfies φ."""


class AtMostOne(Binding, Statement):
    """``AtMostOne(x, low, high, φ)``: at most one x between the ends satisfies φ."""


class TheRoot(Binding, Expr):
    """``TheRoot(x, low, high, φ)``: the number x between the ends that solves the equation φ.

    It has a value only if there is exactly one root; a claim must state that there is at most one.
    """

    is_commutative = True
    is_real = True

    def __new__(cls, *args: Any) -> TheRoot:
        """Create the root, unevaluated."""
        made: TheRoot = Expr.__new__(cls, *map(_sympify, args))
        return made


class Rounds(Statement):
    """``Rounds(e, "0.1150")``: e lies within half a unit of the last printed decimal place.

    As a condition on a symbol, it states an input as the paper prints it. A statement under such
    conditions means: some inputs that round to the printed inputs give a value that rounds to the
    printed value.
    """

    def __new__(cls, term: Any, text: Any, half_units: Any = 1) -> Rounds:
        """Create the statement.

        Args:
            term: the number.
            text: the decimal as printed, with trailing zeros.
            half_units: the tolerance in half units of the last place: 1, or 2 for a whole unit.
        """
        text = text if isinstance(text, Str) else Str(text)
        made: Rounds = Basic.__new__(cls, _sympify(term), text, _sympify(half_units))
        return made

    @property
    def term(self) -> Expr:
        """The expression whose value is printed."""
        return self.args[0]

    @property
    def text(self) -> str:
        """The decimal as printed."""
        return str(self.args[1])

    @property
    def half_units(self) -> int:
        """The tolerance on each side, in half units of the last place."""
        return int(self.args[2])


class Under(Statement):
    """``Under(φ, (condition, …))``: φ holds wherever the conditions do; part of a conjunction."""


class ForSome(Statement):
    """``ForSome(φ)``: φ holds for at least one point that satisfies the claim's conditions."""


class StrictlyIncreasing(Statement):
    """``StrictlyIncreasing(e, x)``: a larger x gives a larger e, everything else unchanged.

    For all values x < x′ that satisfy the conditions, with the same values of the other symbols:
    e(x) < e(x′). Symbols that are defined by x change with it.
    """


class StrictlyDecreasing(Statement):
    """``StrictlyDecreasing(e, x)``: for all x < x′ that satisfy the conditions, e(x) > e(x′)."""


class Conserved(Statement):
    """``Conserved(e, (x, …), (f, …))``: e is constant along every solution of dx/dt = f, ….

    A solution is followed for as long as it satisfies the conditions of the claim.
    """


class StableEquilibrium(Statement):
    """``StableEquilibrium((x, …), (f, …), (p, …))``: p is stable for the system dx/dt = f, ….

    For every neighbourhood U of p there is one from which no solution leaves U (Lyapunov).
    """


class UnstableEquilibrium(Statement):
    """``UnstableEquilibrium((x, …), (f, …), (p, …))``: an equilibrium that is not stable."""


class Infimum(Statement):
    """``Infimum(e, v)``: e > v where the conditions hold, and e < v + δ somewhere, for all δ > 0.

    So v is the greatest lower bound of e, and e does not attain it.
    """


class As(Statement):
    """``As(φ, e, p, side)``: the order φ as e tends to p from above (1), below (−1) or both (0).

    φ is an equation with one O(…) or o(…). It holds uniformly in all other free symbols, under the
    conditions of the claim.
    """


def order(relation: Basic, x: Basic, point: Any = 0, side: int = 1) -> As:
    """Return the statement that ``relation`` holds as ``x`` tends to ``point``.

    Args:
        relation: an equation with one O(…) or o(…).
        x: the expression that tends to ``point``, or a tuple of several.
        point: the limit, or a tuple of as many limits.
        side: 1 from above, −1 from below, 0 from both sides.
    """
    return As(relation, x, point, Integer(side))


def together_under(parts: Iterable[tuple[Basic, tuple[Basic, ...]]]) -> Tuple:
    """Return the conjunction of pairs of a statement and its conditions, without repeats."""
    whole: dict[Basic, None] = {}
    for says, given in parts:
        conjoined = isinstance(says, Tuple) and all(isinstance(p, Under) for p in says.args)
        part = says.args if conjoined and not given else (Under(says, Tuple(*given)),)
        whole.update(dict.fromkeys(part))
    return Tuple(*whole)


def _count(how: str) -> Callable[[Any], Count]:
    def made(says: Any) -> Count:
        x, low, high, inner = says.args
        return Count(
            how, x.name, in_trees(low), in_trees(high), (False, False), in_trees(inner), ()
        )

    return made


def _shape(how: str) -> Callable[[Any], Shape]:
    return lambda says: Shape(how, in_trees(says.args[0]), str(says.args[1]), ())


def _equilibrium(how: str) -> Callable[[Any], named_claims.Equilibrium]:
    def made(says: Any) -> named_claims.Equilibrium:
        names, rates, point = says.args
        return named_claims.Equilibrium(
            how,
            tuple(map(str, names.args)),
            tuple(map(in_trees, point.args)),
            tuple(map(in_trees, rates.args)),
            None,
            (),
        )

    return made


def _tending(says: Any) -> Tending:
    inner, what, point, side = says.args
    return Tending(in_trees(inner), path_to(_several(what), _several(point), int(side)))


def _several(e: Any) -> Any:
    return tuple(map(in_trees, e.args)) if type(e).__name__ == "Tuple" else in_trees(e)


def path_to(what: Any, point: Any, side: int = 1) -> Path:
    """Return the path of an expression, or of several variables, that tends to a point.

    Raises:
        InputError: several variables do not tend from all sides, or an expression not to oo.
    """
    if isinstance(what, tuple):
        if side != 0:
            raise InputError("several variables tend to a point from all sides")
        names = tuple(str(x) for x in what)
        return Path("", ZERO, (1,), together=names, points=point)
    if what.op == "symbol":
        name = str(what.args[0])
        if point in (INFINITY, -INFINITY):
            return Path(name, None, (1 if point == INFINITY else -1,))
        return Path(name, point, SIDES[side])
    if point != INFINITY:
        raise InputError("an expression is supported that tends to oo")
    return Path("", None, (1,), expression=what)


_STATEMENTS: dict[str, Callable[[Any], Any]] = {
    "ExactlyOne": _count("exactly one"),
    "AtMostOne": _count("at most one"),
    "StrictlyIncreasing": _shape("increasing"),
    "StrictlyDecreasing": _shape("decreasing"),
    "StableEquilibrium": _equilibrium("stable"),
    "UnstableEquilibrium": _equilibrium("unstable"),
    "Infimum": lambda says: named_claims.Extremum(
        "infimum", in_trees(says.args[0]), (), in_trees(says.args[1]), ()
    ),
    "Conserved": lambda says: named_claims.Conserved(
        in_trees(says.args[0]),
        tuple(map(str, says.args[1].args)),
        tuple(map(in_trees, says.args[2].args)),
        (),
    ),
    "ForSome": lambda says: Somewhere(parts_of(in_trees(says.args[0])), ()),
    "Under": lambda says: formulas.Under(
        in_trees(says.args[0]), tuple(map(in_trees, says.args[1].args))
    ),
    "As": _tending,
    "Rounds": lambda says: Rounded(in_trees(says.term), says.text, says.half_units),
}
"""How the statements that are written in SymPy become trees."""
