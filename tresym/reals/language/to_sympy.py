"""Convert trees to SymPy's expressions; SymPy is imported only when needed.

``x**2 + 1`` becomes ``Add(Pow(x, 2), 1)`` in the symbol ``x``, which carries the one assumption
``real``. SymPy brings sums and products into its own order and works out what it works out by
itself; derivatives, values at a point, integrals and limits stay as they are.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tresym.reals.functions.table import CONSTANTS, TABLE
from tresym.reals.language.expression import (
    ORDERS,
    UNWORKED,
    Expr,
    instantiate,
    opened,
    symbol,
    symbols,
)
from tresym.reals.numbers.exact import InputError


def to_sympy(e: Expr, root: Callable[..., Any] | None = None) -> Any:
    """Return a tree as a SymPy expression in real symbols.

    Args:
        e: the tree.
        root: returns the root of a function, as ``root(x, low, high, f)``; None if there is no such
            expression.

    Raises:
        InputError: SymPy has no such expression, as for the root of an equation.
    """
    import sympy

    done: dict[Expr, Any] = {}

    def walk(node: Expr) -> Any:
        if node not in done:
            done[node] = _node(sympy, node, walk, root)
        return done[node]

    return walk(e)


def _node(sympy: Any, node: Expr, walk: Any, root: Callable[..., Any] | None) -> Any:
    if node.op == "number":
        return sympy.Rational(int(node.args[0].p), int(node.args[0].q))
    if node.op == "symbol":
        return sympy.Symbol(node.args[0], real=True)
    if node.op == "pi":
        return sympy.pi
    if node.op in UNWORKED:
        return _unworked(sympy, node, walk, root)
    args = [walk(arg) for arg in node.args]
    if node.op == "+":
        return sympy.Add(*args)
    if node.op == "*":
        return sympy.Mul(*args)
    if node.op == "^":
        return sympy.Pow(*args)
    if node.op == "cbrt":
        return sympy.sign(args[0]) * sympy.Abs(args[0]) ** sympy.Rational(1, 3)
    if node.op in CONSTANTS:
        return getattr(sympy, node.op)
    if node.op not in TABLE:
        raise InputError(f"'{node}' is no expression of SymPy")
    return getattr(sympy, TABLE[node.op].sympy)(*args)


def _unworked(sympy: Any, node: Expr, walk: Any, root: Callable[..., Any] | None) -> Any:
    if node.op in ORDERS:
        return sympy.Function(node.op)(walk(node.args[0]))
    if node.op == "derivative" and node.args[1] == symbol(node.names[0]):
        inner = walk(instantiate(node.args[0], (node.args[1],)))
        return sympy.Derivative(inner, walk(node.args[1]), evaluate=False)
    names, body = opened(node)
    if node.op in ("at", "derivative") and not {*node.names} & symbols(node.args[0]):
        names = node.names  # the values may contain the variable: it is another one there
        body = instantiate(node.args[0], tuple(map(symbol, names)))
    inner, points = walk(body), [walk(arg) for arg in node.args[1:]]
    variables = [sympy.Symbol(name, real=True) for name in names]
    if node.op == "integral":
        return sympy.Integral(inner, (variables[0], *points))
    if node.op == "limit":
        side = {1: "+", -1: "-", 0: "+-"}[int(node.args[2].args[0].p)]
        return sympy.Limit(inner, variables[0], points[0], side)
    if node.op == "root" and root is not None:
        return root(variables[0], *points, inner)
    if node.op == "at":
        return sympy.Subs(inner, variables, points)
    if node.op == "derivative":
        return sympy.Subs(sympy.Derivative(inner, variables[0], evaluate=False), variables, points)
    raise InputError(f"'{node}' is no expression of SymPy")
