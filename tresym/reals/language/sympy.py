"""Convert SymPy's expressions and relations to trees; SymPy is imported only when needed."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from flint import fmpq, fmpz

from tresym.reals.language.binders import (
    at,
    derivative,
    integral,
    limit,
    order,
    outermost,
    root,
    worked_out,
)
from tresym.reals.language.calls import INTEGERS, KNOWN, NAMED_CONSTANTS, call
from tresym.reals.language.expression import (
    MAX_DERIVATIVES,
    ORDERS,
    PI,
    ZERO,
    E,
    Expr,
    add,
    multiply,
    number,
    power,
    symbol,
)
from tresym.reals.language.formula import Compared, Conjunction, Equivalence, Formula, Relation
from tresym.reals.language.parsing import NO_DERIVATIVE
from tresym.reals.numbers.exact import InputError, shortened


def from_sympy(e: Any) -> Expr:
    """Convert a SymPy expression in real symbols to a tree, with derivatives carried out.

    Derivatives are formal and computed by :func:`differentiate`, since SymPy's depend on
    assumptions about symbols.

    Raises:
        InputError: the expression contains floats, complex numbers or unsupported operations.
    """
    tree = worked_out(unworked(e))
    for node in outermost(tree):
        raise InputError(
            f"{node.op} is outside the expressions that tresym decides; write it as text"
        )
    return tree


def unworked(e: Any, any_value: bool = False) -> Expr:
    """Convert a SymPy expression, with integrals, derivatives, values, limits and orders as nodes.

    Args:
        e: the expression.
        any_value: accept the value at a point of a symbol that stands for a function of it, which
            a paper prints and no prover may work out.

    Raises:
        InputError: as for :func:`from_sympy`; also for integrals without ends, and for values at a
            point of an expression that does not contain the variable.
    """
    import sympy

    done: dict[Any, Expr] = {}

    def walk(node: Any) -> Expr:
        if node not in done:
            name = type(node).__name__
            if name == "Subs" and not any_value:
                _need_dependence(node)
            known = _UNWORKED.get(name)
            done[node] = known(node, walk) if known else _from_sympy_node(sympy, node, walk)
        return done[node]

    if isinstance(e, str):
        raise InputError("text is not a SymPy expression; parse it with parse instead")
    return walk(sympy.sympify(e))


def formula(e: Any) -> Formula:
    """Convert a SymPy relation, a tuple or conjunction of relations, or an equivalence of two.

    An equation of matrices becomes the conjunction of the equations of its entries. What SymPy has
    evaluated to true becomes the empty conjunction, and false becomes a relation that always fails.

    Raises:
        InputError: ``e`` is anything else.
    """
    kind = type(e).__name__
    if kind in ("Tuple", "And"):
        return Conjunction(tuple(map(formula, e.args)))
    if kind == "Equivalent" and len(e.args) == 2:
        return Equivalence(*map(formula, e.args))
    if kind == "BooleanTrue":
        return Conjunction(())
    if kind == "BooleanFalse":
        return Relation(ZERO, "!=", ZERO)
    if kind not in RELATIONS:
        raise InputError(f"{e} is not a relation such as a > 0")
    if hasattr(e.lhs, "shape") and getattr(e.rhs, "shape", None) == e.lhs.shape:
        sides = zip(map(unworked, e.lhs), map(unworked, e.rhs), strict=True)
        return Conjunction(tuple(Relation(p, RELATIONS[kind], q) for p, q in sides))
    return Relation(unworked(e.lhs), RELATIONS[kind], unworked(e.rhs))


RELATIONS = {
    "Equality": "==",
    "Unequality": "!=",
    "StrictGreaterThan": ">",
    "GreaterThan": ">=",
    "StrictLessThan": "<",
    "LessThan": "<=",
}
"""The relations by SymPy's names."""


def atoms(e: Any, kind: str) -> list[Any]:
    """Return the parts of a SymPy expression that belong to a class, sorted by their text."""
    import sympy

    return sorted(e.atoms(getattr(sympy, kind)), key=str)


def _from_sympy_node(sympy: Any, node: Any, walk: Any) -> Expr:
    if node.is_Rational:
        return number(fmpq(fmpz(str(node.p)), fmpz(str(node.q))))
    if type(node).__name__ in NAMED_CONSTANTS:
        return NAMED_CONSTANTS[type(node).__name__]
    if node.is_Symbol:
        return symbol(node.name)
    if node is sympy.pi:
        return PI
    if node is sympy.E:
        return E
    if node.is_Add:
        return add(*map(walk, node.args))
    if node.is_Mul:
        return multiply(*map(walk, node.args))
    if node.is_Pow:
        return power(*map(walk, node.args))
    name = type(node).__name__
    if isinstance(node, sympy.core.function.AppliedUndef):
        raise InputError(f"{name} is an unknown function to SymPy, whatever its name")
    if name in KNOWN:
        return call(name, [walk(arg) for arg in node.args])
    if node is sympy.I:
        raise InputError("I is not a real number or variable; all values are real")
    raise InputError(f"{name} is outside the expressions that tresym decides")


def _variables(node: Any) -> Iterator[str]:
    """Yield the variables of a SymPy derivative, one for each differentiation."""
    for variable, times in node.variable_count:
        if not (variable.is_Symbol and times.is_Integer and 0 < times <= MAX_DERIVATIVES):
            raise InputError(f"a derivative is of order 1 to {MAX_DERIVATIVES}, by a symbol")
        yield from (variable.name for _ in range(int(times)))


def _derivative_as_written(node: Any, walk: Any) -> Expr:
    result = walk(node.expr)
    for name in _variables(node):
        result = derivative(result, name)
    return result


def _integral_as_written(node: Any, walk: Any) -> Expr:
    result = walk(node.function)
    for variable, *ends in node.limits:
        if len(ends) != 2:
            raise InputError(f"{node} is not a number: an integral needs two ends")
        result = integral(result, variable.name, *map(walk, ends))
    return result


def _need_dependence(node: Any) -> None:
    if not node.expr.has(*node.variables):
        raise InputError(f"{node.expr} does not say how it depends on {node.variables[0]}")


def _value_as_written(node: Any, walk: Any) -> Expr:
    pairs = zip(node.variables, node.point, strict=True)
    return at(walk(node.expr), {variable.name: walk(point) for variable, point in pairs})


def _limit_as_written(node: Any, walk: Any) -> Expr:
    inner, variable, point, side = node.args
    return limit(walk(inner), variable.name, walk(point), {"+": 1, "-": -1}.get(str(side), 0))


def _root_as_written(node: Any, walk: Any) -> Expr:
    variable, low, high, equation = node.args
    return root(walk(equation.lhs) - walk(equation.rhs), variable.name, walk(low), walk(high))


def _order_as_written(node: Any, walk: Any) -> Expr:
    if len(node.args) != 1:
        raise InputError(f"{node} is no order of one expression")
    return order(type(node).__name__, *map(walk, node.args))


def _own_order_as_written(node: Any, walk: Any) -> Expr:
    """Return SymPy's own O(f, (x, a)); where it is meant belongs to the path of the claim."""
    if len(node.args) != 2:
        raise InputError(f"{node} is an order in several variables")
    return order("O", walk(node.args[0]))


def order_paths(e: Any) -> list[tuple[str, Expr | None, int]]:
    """Return where the orders O(f, (x, a)) of a SymPy expression are meant.

    Returns:
        The variable, the point (None for infinity), and the sign of an infinite point, else 0.
    """
    found = []
    for node in atoms(e, "Order"):
        for variable, point in node.args[1:]:
            infinite = point.is_infinite
            sign = (1 if point.is_extended_positive else -1) if infinite else 0
            found.append((variable.name, None if infinite else unworked(point), sign))
    return list(dict.fromkeys(found))


_UNWORKED: dict[str, Callable[[Any, Any], Expr]] = {
    "Derivative": _derivative_as_written,
    "Integral": _integral_as_written,
    "Subs": _value_as_written,
    "Limit": _limit_as_written,
    "TheRoot": _root_as_written,
    "Order": _own_order_as_written,
    **dict.fromkeys(ORDERS, _order_as_written),
}


_ASSUMPTIONS = {
    "is_extended_positive": ">",
    "is_extended_negative": "<",
    "is_extended_nonnegative": ">=",
    "is_extended_nonpositive": "<=",
    "is_extended_nonzero": "!=",
}


def relation_from_sympy(claim: Any) -> tuple[Compared, tuple[Compared, ...]]:
    """A SymPy relation, and the assumptions its symbols carry."""
    name = type(claim).__name__
    if name not in RELATIONS:
        hint = (
            "; SymPy evaluated the relation: pass evaluate=False"
            if name.startswith("Boolean")
            else ""
        )
        raise InputError(
            f"{name} is not a claim: give text or a SymPy relation such as Eq(f, g){hint}"
        )
    comparison = unworked(claim.lhs), RELATIONS[name], unworked(claim.rhs)
    conditions = []
    names: set[str] = set()
    for variable in _real_variables(claim):
        if variable.name in names:
            raise InputError(f"two different SymPy symbols are both called {variable.name}")
        names.add(variable.name)
        for assumption, sign in _ASSUMPTIONS.items():
            if getattr(variable, assumption):
                conditions.append((symbol(variable.name), sign, ZERO))
        if variable.is_integer:
            conditions.append((symbol(variable.name), "in", INTEGERS))
    return comparison, tuple(conditions)


def _real_variables(claim: Any) -> list[Any]:
    """The symbols of a relation, those of its derivatives too, all of them real variables.

    Raises:
        InputError: a symbol that may not take every real value that its sign allows.
    """
    found = atoms(claim, "Symbol")
    for variable in found:
        if variable.is_extended_real is False or variable.is_finite is False:
            raise InputError(f"{variable.name} is not real: only real variables are supported")
        for kind in () if variable.is_integer else ("integer", "rational", "algebraic"):
            if variable.assumptions0.get(kind) is not None:
                raise InputError(
                    f"the SymPy assumption about whether {variable.name} is "
                    f"{kind} is not supported: only "
                    "signs and integer=True are"
                )
    return found


def conditions_from_sympy(*relationals: Any) -> tuple[Compared, ...]:
    """Convert SymPy relationals (``Gt``, ``Ge``, ``Lt``, ``Le``, ``Ne``, and ``And`` of them).

    Raises:
        InputError: an argument is another condition or contains a derivative.
    """
    result: list[Compared] = []
    for item in relationals:
        name = type(item).__name__
        if name == "And":
            result += conditions_from_sympy(*item.args)
        elif RELATIONS.get(name, "==") != "==":
            if atoms(item, "Derivative"):
                raise InputError(NO_DERIVATIVE)
            left, right = from_sympy(item.lhs), from_sympy(item.rhs)
            result.append((left, RELATIONS[name], right))
        elif name != "BooleanTrue":
            raise InputError(
                f"{shortened(str(item))} is not a condition; give an inequality such as a > 0"
            )
    return tuple(result)
