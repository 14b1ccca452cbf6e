"""SymPy's expressions and relations as trees, and back: the one door, opened only when called."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from flint import fmpq, fmpz

from tresym.reals.language.expression import (
    FUNCTIONS,
    MAX_DERIVATIVES,
    PI,
    E,
    Expr,
    add,
    angle,
    apply,
    differentiate,
    extreme,
    multiply,
    number,
    power,
    symbol,
)
from tresym.reals.numbers.exact import InputError


def from_sympy(e: Any, derivative: Callable[[Any, Any], Expr] | None = None) -> Expr:
    """A SymPy expression of real symbols as a tree.

    Args:
        e: the expression.
        derivative: what to make of a derivative and the function that reads its parts; without it
            derivatives are carried out.

    Raises:
        InputError: floats, complex numbers, and functions outside :data:`FUNCTIONS`.
    """
    import sympy

    done: dict[Any, Expr] = {}

    def walk(node: Any) -> Expr:
        if node not in done:
            if isinstance(node, sympy.Derivative) and not node.has(sympy.Integral):
                done[node] = (derivative or _from_sympy_derivative)(node, walk)
            else:
                done[node] = _from_sympy_node(sympy, node, walk)
        return done[node]

    if isinstance(e, str):
        raise InputError("text is read by parse, never as a SymPy expression")
    return walk(sympy.sympify(e))


def atoms(e: Any, kind: str) -> list[Any]:
    """The parts of a SymPy expression of a class of SymPy's, in the order of their text."""
    import sympy

    return sorted(e.atoms(getattr(sympy, kind)), key=str)


_SYMPY_NAMES = {"Abs": "abs"} | {name: name for name in FUNCTIONS - {"abs", "cbrt"}}
_SYMPY_RECIPROCALS = {"asec": "acos", "acsc": "asin", "acot": "atan"} | {
    "asech": "acosh",
    "acsch": "asinh",
    "acoth": "atanh",
}


def _from_sympy_node(sympy: Any, node: Any, walk: Any) -> Expr:
    if node.is_Rational:
        return number(fmpq(fmpz(str(node.p)), fmpz(str(node.q))))
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
    if name in _SYMPY_NAMES and len(node.args) == 1:
        return apply(_SYMPY_NAMES[name], walk(node.args[0]))
    if name in _SYMPY_RECIPROCALS:
        return apply(_SYMPY_RECIPROCALS[name], 1 / walk(node.args[0]))
    if name == "atan2":
        return angle(*map(walk, node.args))
    if name in ("Max", "Min"):
        return extreme(1 if name == "Max" else -1, map(walk, node.args))
    if node is sympy.I:
        raise InputError("I is no real number or variable, and all here are real")
    raise InputError(f"{name} is outside the expressions that tresym decides")


def _from_sympy_derivative(node: Any, walk: Any) -> Expr:
    """The formal derivative, made by :func:`differentiate`: SymPy's asks whether symbols are real.

    Raises:
        InputError: derivatives beyond the tenth, or with respect to something else than a symbol.
    """
    result = walk(node.expr)
    for variable, order in node.variable_count:
        if not (variable.is_Symbol and order.is_Integer and 0 < order <= MAX_DERIVATIVES):
            raise InputError(f"a derivative is of order 1 to {MAX_DERIVATIVES}, by a symbol")
        for _ in range(int(order)):
            result = differentiate(result, variable.name)
    return result


def to_sympy(e: Expr) -> Any:
    """The tree as a SymPy expression; symbols carry the assumption ``real``."""
    import sympy

    done: dict[Expr, Any] = {}

    def walk(node: Expr) -> Any:
        if node not in done:
            done[node] = _to_sympy_node(sympy, node, walk)
        return done[node]

    return walk(e)


def _to_sympy_node(sympy: Any, node: Expr, walk: Any) -> Any:
    if node.op == "number":
        return sympy.Rational(int(node.args[0].p), int(node.args[0].q))
    if node.op == "symbol":
        return sympy.Symbol(node.args[0], real=True)
    if node.op == "pi":
        return sympy.pi
    args = [walk(arg) for arg in node.args]
    if node.op == "+":
        return sympy.Add(*args)
    if node.op == "*":
        return sympy.Mul(*args)
    if node.op == "^":
        return sympy.Pow(*args)
    if node.op == "cbrt":
        return sympy.sign(args[0]) * sympy.Abs(args[0]) ** sympy.Rational(1, 3)
    return getattr(sympy, "Abs" if node.op == "abs" else node.op)(*args)
