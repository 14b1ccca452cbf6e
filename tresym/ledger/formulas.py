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

from flint import fmpq

from tresym.reals.language import sympy as sympy_reader
from tresym.reals.language.binders import ordered, outermost
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.compound import Count, Equivalent, Shape, Somewhere, Together
from tresym.reals.language.expression import (
    HALF,
    LEAVES,
    ONE,
    PI,
    ZERO,
    Expr,
    add,
    as_expr,
    factors_in,
    integer,
    multiply,
    number,
    power,
    rebuild,
    symbols,
)
from tresym.reals.language.formula import Relation
from tresym.reals.language.like_terms import scaled
from tresym.reals.language.named_claims import Conserved, Equilibrium, Extremum
from tresym.reals.language.paths import Path
from tresym.reals.numbers.exact import InputError

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

    def __post_init__(self) -> None:
        if [*map(len, self.left)] != [*map(len, self.right)]:
            raise InputError("matrices of different sizes are not equal")

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


def in_order(e: Expr) -> Expr:
    """Return an expression in the form in which the ledger compares expressions.

    Like terms and factors are collected and stand in one order, a number is multiplied into a sum,
    reciprocals of products and of roots are written as products and powers, sine and cosine of an
    arctangent, a right angle from it too, are roots, and those of right angles numbers. The form is
    defined where the expression is.

    Example:
        >>> from tresym.reals.language.parsing import parse
        >>> in_order(parse("2*(y + x)")) == in_order(parse("2*x + 2*y"))
        True
        >>> in_order(parse("1/(a*sqrt(b))")) == in_order(parse("b**(-1/2)/a"))
        True
    """
    return ordered(_multiplied(e), _place)


def _place(op: str, e: Expr) -> tuple[bool, int]:
    """The place of a term or a factor: 4*a - b, 1 - x, a*sqrt(b)*sin(x)."""
    negative = e.op == "number" and e.args[0] < 0
    negative = negative or (e.op == "*" and e.args[0].op == "number" and e.args[0].args[0] < 0)
    kinds = {"number": 0 if op == "*" else 3, "pi": 1, "symbol": 1, "*": 2, "^": 2, "+": 4}
    if op == "*" and e.op == "^" and e.args[0].op != "symbol":
        return False, 3
    return op == "+" and negative, kinds.get(e.op, 3 if op == "*" else 2)


def _multiplied(e: Expr) -> Expr:
    if e.op in LEAVES:
        return e
    args = tuple(map(_multiplied, e.args))
    if e.op == "^" and (n := integer(args[1])) is not None:
        base, exponent = args
        if base.op == "*" and n != 0:
            return multiply(*(_multiplied(power(f, exponent)) for f in base.args))
        if base.op == "^" and base.args[1].op == "number":
            inner, r = base.args[0], base.args[1].args[0]
            if r.q > 1 and (r > 0 and (r * n).q > 1 if n < 0 else _is_positive(inner)):
                return power(inner, number(r * n))
    if e.op in ("+", "*"):
        args = factors_in(_alike(e.op, args)) if e.op == "*" else args
        e = _alike(e.op, args)
        if e.op not in ("+", "*"):
            return e
        args = e.args
    if e.op == "*" and len(args) == 2:
        factor, total = args
        if factor.op == "number" and factor != ZERO and total.op == "+":
            return add(*(multiply(factor, term) for term in total.args))
    if e.op in ("sin", "cos"):
        turns = _right_angles(args[0])
        if turns is not None:
            return number((0, 1, 0, -1)[(turns + (e.op == "cos")) % 4])
        if (root := _of_arctangent(e.op, args[0])) is not None:
            return root
    return rebuild(e, args)


def _alike(op: str, args: tuple[Expr, ...]) -> Expr:
    """A sum with equal terms as multiples, or a product with equal factors as powers.

    What cancels, as in x - x, stays, as it may have no value.
    """
    if op == "+":
        terms = [scaled(term) for term in args]
        found: dict[Expr, fmpq] = {}
        for share, rest in terms:
            found[rest] = found.get(rest, fmpq(0)) + share
        gone = {rest for rest, share in found.items() if share == 0}
        kept = [number(share) * rest for share, rest in terms if rest in gone]
        whole = (number(share) * rest for rest, share in found.items() if rest not in gone)
        return add(*whole, *kept)
    powers: dict[tuple[Expr, bool], int] = {}
    for factor in args:
        n = integer(factor.args[1]) if factor.op == "^" else None
        base, n = (factor.args[0], n) if n is not None and n != 0 else (factor, 1)
        key = base, n > 0
        powers[key] = powers.get(key, 0) + n if base.op != "number" else n
    return multiply(*(power(base, number(n)) for (base, _), n in powers.items()))


def _right_angles(angle: Expr) -> int | None:
    """Return how many right angles an angle is; None if it is not a whole number of them."""
    if angle == ZERO:
        return 0
    share = ONE if angle == PI else angle.args[0] if angle.op == "*" else ZERO
    if angle != PI and (share.op != "number" or angle != share * PI or share == ZERO):
        return None
    return integer(2 * share)


def _is_positive(e: Expr) -> bool:
    """Return whether an expression is one plus a square."""
    return (
        e.op == "+"
        and len(e.args) == 2
        and ONE in e.args
        and all(term == ONE or _is_square(term) for term in e.args)
    )


def _is_square(e: Expr) -> bool:
    return all(
        f.op == "^" and (n := integer(f.args[1])) is not None and n % 2 == 0 for f in factors_in(e)
    )


def _of_arctangent(op: str, angle: Expr) -> Expr | None:
    """Return sine or cosine of atan(w), or of pi/2 - atan(w), as a root; None of other angles."""
    terms = angle.args if angle.op == "+" else (angle,)
    rest = [term for term in terms if term != HALF * PI]
    if len(terms) > 2 or len(rest) != 1:
        return None
    turned = len(terms) == 2
    arc = -rest[0] if turned else rest[0]
    if arc.op != "atan":
        return None
    w = arc.args[0]
    cosine = power(_multiplied(1 + w**2), -HALF)
    return cosine if (op == "cos") != turned else w * cosine


def parts_of(says: Says) -> tuple[Any, ...]:
    """Return the parts of a conjunction, or the statement itself."""
    return says.parts if isinstance(says, Together) else (says,)


def together(parts: Iterable[Says]) -> Says:
    """Return one statement for several, or the only one."""
    found = tuple(parts)
    return found[0] if len(found) == 1 else Together(found)


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


def binders_in(*sides: Expr) -> Iterator[Expr]:
    """Yield the nodes that bind a variable, also those inside of others."""
    for node in outermost(*sides):
        yield node
        yield from binders_in(*node.args)


def all_bound(says: Any) -> frozenset[str]:
    """Return all variables that are bound in a statement, or in an expression of it."""
    return bound_names(says).union(*(node.names for node in binders_in(*sides_of(says))))


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
        return names_of(says.relation, says.path)
    elif isinstance(says, Path):
        own = (*says.together, *filter(None, (says.name,)))
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


def in_trees(says: Any) -> Any:
    """Return a statement of SymPy, or an expression, as trees; trees are returned as they are.

    Raises:
        InputError: there is no such statement.
    """
    if isinstance(says, int):
        return as_expr(says)
    return _from_sympy(says) if hasattr(says, "free_symbols") else says


@lru_cache(maxsize=4096)
def _from_sympy(says: Any) -> Any:
    if hasattr(says, "as_tree"):
        return says.as_tree()
    kind = type(says).__name__
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
    _need_no_assumptions(says)
    return in_order(sympy_reader.unworked(says, any_value=True))


def _need_no_assumptions(e: Any) -> None:
    """Refuse symbols of which SymPy knows more than that they are real.

    It would use what it knows without anybody saying so among the conditions.
    """
    for s in e.atoms(type(e)) if e.is_Symbol else sympy_reader.atoms(e, "Symbol"):
        if s not in (type(s)(s.name), type(s)(s.name, real=True)):
            raise InputError(
                f"SymPy assumes more about {s} than that it is real; state such assumptions as "
                "conditions (given)"
            )
