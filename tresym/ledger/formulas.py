"""What a claim of the ledger says, as trees.

A statement is a formula of everyone's language (:mod:`tresym.reals.language.compound`): a relation,
several of them `Together`, an equivalence, a count of solutions, that a function is monotone or a
quantity conserved. A paper needs four more: a part under conditions of its own (`Under`), an order
along a path (`Tending`), a printed number (`Rounded`), and an equation of matrices
(`EqualMatrices`). It is meant for all values of its free variables that satisfy the conditions of
the claim; symbols with a definition have the value that the definition gives them.

Example: ``x**2 > 0 given x != 0`` beside ``x**2 >= 0`` is ``Together((Under(x**2 > 0, (x != 0,)),
x**2 >= 0))``.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any, TypeAlias

from tresym.reals.language import sympy as sympy_reader
from tresym.reals.language.binders import ordered
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.compound import Count, Equivalent, Shape, Somewhere, Together
from tresym.reals.language.expression import ONE, ZERO, Expr, as_expr, symbols
from tresym.reals.language.formula import Relation
from tresym.reals.language.named_claims import Conserved, Equilibrium, Extremum
from tresym.reals.language.paths import Path
from tresym.reals.numbers.exact import InputError

SIDES = {1: (1,), -1: (-1,), 0: (1, -1)}
FALSE = Relation(ZERO, "==", ONE)
"""A statement that holds nowhere."""


@dataclass(frozen=True)
class Under:
    """A part of a conjunction, which holds wherever conditions of its own do."""

    formula: Says
    given: tuple[Condition, ...]

    def __str__(self) -> str:
        return f"({self.formula} given {', '.join(map(str, self.given))})"


@dataclass(frozen=True)
class Tending:
    """An equation with one O(…) or o(…), as something tends to a point; uniform in all else."""

    relation: Relation
    path: Path

    def __str__(self) -> str:
        return f"{self.relation} as {self.path}"


@dataclass(frozen=True)
class Rounded:
    """A number lies within half a unit of the last printed decimal place, or a whole one.

    As a condition on a symbol, it states an input as the paper prints it. A statement under such
    conditions means: some inputs that round to the printed inputs give a value that rounds to the
    printed value.

    Attributes:
        term: the number.
        text: the decimal as printed, with trailing zeros.
        half_units: the tolerance in half units of the last place: 1, or 2 for a whole unit.
    """

    term: Expr
    text: str
    half_units: int = 1

    def __str__(self) -> str:
        return f"{self.term} ~= {self.text}"


@dataclass(frozen=True)
class EqualMatrices:
    """An equation of matrices, each given by its rows."""

    left: tuple[tuple[Expr, ...], ...]
    right: tuple[tuple[Expr, ...], ...]

    @property
    def entries(self) -> tuple[Relation, ...]:
        """The equations of the entries, row by row."""
        rows = zip(self.left, self.right, strict=True)
        return tuple(
            Relation(p, "==", q) for one, other in rows for p, q in zip(one, other, strict=True)
        )

    def __str__(self) -> str:
        sides = ("; ".join(", ".join(map(str, row)) for row in m) for m in (self.left, self.right))
        return " == ".join(f"({side})" for side in sides)


Condition: TypeAlias = Relation | Rounded
Says: TypeAlias = (
    Relation
    | Together
    | Equivalent
    | Count
    | Shape
    | Somewhere
    | Conserved
    | Equilibrium
    | Extremum
    | Under
    | Tending
    | Rounded
    | EqualMatrices
)


def parts_of(says: Says) -> tuple[Any, ...]:
    """Return the parts of a conjunction, or the statement itself."""
    return says.parts if isinstance(says, Together) else (says,)


def together(parts: Iterable[Says]) -> Says:
    """Return one statement for several, or the only one."""
    found = tuple(parts)
    return found[0] if len(found) == 1 else Together(found)  # type: ignore[arg-type]


def is_equation(says: Any) -> bool:
    """Return whether a statement is an equation of numbers or of matrices."""
    return isinstance(says, EqualMatrices) or (isinstance(says, Relation) and says.sign == "==")


def is_bound(says: Any) -> bool:
    """Return whether a statement compares two numbers, but not as equal."""
    return isinstance(says, Relation) and says.sign != "=="


def relations_of(says: Says) -> Iterator[Relation]:
    """Yield the relations of which a statement consists, those of the entries of matrices too.

    Raises:
        InputError: a part is no relation.
    """
    for part in parts_of(says):
        if isinstance(part, Together):
            yield from relations_of(part)
        elif isinstance(part, EqualMatrices):
            yield from part.entries
        elif isinstance(part, Relation):
            yield part
        else:
            raise InputError(f"{part} is not a relation such as a > 0")


def mapped(says: Any, change: Callable[[Expr], Expr]) -> Any:
    """Return a statement with each of its expressions changed, those of conditions too."""

    def over(item: Any) -> Any:
        if isinstance(item, Expr):
            return change(item)
        if isinstance(item, Relation):
            return Relation(change(item.left), item.sign, change(item.right))
        if isinstance(item, Path):
            point = None if item.point is None else change(item.point)
            what = None if item.expression is None else change(item.expression)
            return replace(
                item, point=point, points=tuple(map(change, item.points)), expression=what
            )
        if hasattr(item, "_fields"):
            return type(item)(*map(over, item))
        if hasattr(item, "__dataclass_fields__"):
            return type(item)(*(over(getattr(item, name)) for name in item.__dataclass_fields__))
        return tuple(map(over, item)) if isinstance(item, tuple) else item

    return over(says)


def sides_of(says: Any) -> Iterator[Expr]:
    """Yield the expressions in a statement, those of its own conditions too."""
    if isinstance(says, Expr):
        yield says
    elif isinstance(says, Path):
        yield from (*says.points, *filter(None, (says.point, says.expression)))
    elif hasattr(says, "__dataclass_fields__"):
        for name in says.__dataclass_fields__:
            yield from sides_of(getattr(says, name))
    elif isinstance(says, tuple):
        for item in says:
            yield from sides_of(item)


def bound_names(says: Any) -> frozenset[str]:
    """Return the variables that a statement binds: those that are counted or move."""
    if isinstance(says, Together | Equivalent):
        return frozenset().union(*map(bound_names, says.parts))
    if isinstance(says, Under):
        return bound_names(says.formula)
    return frozenset((says.name,)) if isinstance(says, Count) else frozenset()


def names_of(*says: Any) -> frozenset[str]:
    """Return the names of the free variables in statements, conditions or expressions."""
    return frozenset().union(*map(_names, says))


def _names(says: Any) -> frozenset[str]:
    if isinstance(says, Expr):
        return symbols(says) - {"oo"}
    if isinstance(says, Together | Equivalent):
        return names_of(*says.parts)
    if isinstance(says, Under):
        return names_of(says.formula, *says.given)
    if isinstance(says, Count):
        inner = names_of(*says.equation[::2]) - {says.name}
        return inner | names_of(says.low, says.high)
    own: tuple[str, ...] = ()
    if isinstance(says, Shape):
        own = (says.name,)
    elif isinstance(says, Conserved | Equilibrium):
        own = says.names
    elif isinstance(says, Tending):
        own = (*says.path.together, *filter(None, (says.path.name,)))
    return frozenset(own).union(*(symbols(e) for e in sides_of(says))) - {"oo"}


def together_under(parts: Iterable[tuple[Says, tuple[Condition, ...]]]) -> Together:
    """Return the conjunction of pairs of a statement and its conditions, without repeats."""
    whole: dict[Any, None] = {}
    for says, given in parts:
        conjoined = isinstance(says, Together) and all(isinstance(p, Under) for p in says.parts)
        whole.update(
            dict.fromkeys(
                parts_of(says) if conjoined and not given else (Under(says, tuple(given)),)
            )
        )
    return Together(tuple(whole))


# From SymPy


@lru_cache(maxsize=4096)
def in_trees(says: Any) -> Any:
    """Return a statement of SymPy, or an expression, as trees; trees are returned as they are.

    Raises:
        InputError: there is no such statement.
    """
    if isinstance(says, int):
        return as_expr(says)
    if not hasattr(says, "free_symbols"):  # it is none of SymPy's
        return says
    kind = type(says).__name__
    known = _STATEMENTS.get(kind)
    if known is not None:
        return known(says)
    if kind in ("Tuple", "And"):
        return Together(tuple(map(in_trees, says.args)))
    if kind in ("Infinity", "NegativeInfinity"):
        return INFINITY if kind == "Infinity" else -INFINITY
    if kind == "BooleanTrue":
        return Together(())
    if kind == "BooleanFalse":
        return FALSE
    if kind == "Equivalent":
        return Equivalent(tuple(map(in_trees, says.args)))
    if kind in sympy_reader.RELATIONS:
        if hasattr(says.lhs, "shape"):
            return EqualMatrices(
                *(tuple(tuple(map(in_trees, row)) for row in m.tolist()) for m in says.args)
            )
        return Relation(in_trees(says.lhs), sympy_reader.RELATIONS[kind], in_trees(says.rhs))
    return ordered(sympy_reader.unworked(says, any_value=True))


def _count(how: str) -> Callable[[Any], Count]:
    def made(says: Any) -> Count:
        x, low, high, inner = says.args
        return Count(
            how, x.name, in_trees(low), in_trees(high), (False, False), in_trees(inner), ()
        )

    return made


def _shape(how: str) -> Callable[[Any], Shape]:
    return lambda says: Shape(how, in_trees(says.args[0]), str(says.args[1]), ())


def _equilibrium(how: str) -> Callable[[Any], Equilibrium]:
    def made(says: Any) -> Equilibrium:
        names, rates, point = says.args
        return Equilibrium(
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
    "Infimum": lambda says: Extremum(
        "infimum", in_trees(says.args[0]), (), in_trees(says.args[1]), ()
    ),
    "Conserved": lambda says: Conserved(
        in_trees(says.args[0]),
        tuple(map(str, says.args[1].args)),
        tuple(map(in_trees, says.args[2].args)),
        (),
    ),
    "ForSome": lambda says: Somewhere(parts_of(in_trees(says.args[0])), ()),
    "Under": lambda says: Under(in_trees(says.args[0]), tuple(map(in_trees, says.args[1].args))),
    "As": _tending,
    "Rounds": lambda says: Rounded(in_trees(says.term), says.text, says.half_units),
}
"""How the statements that are written in SymPy become trees."""
