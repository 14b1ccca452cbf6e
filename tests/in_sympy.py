"""Trees as SymPy expressions, to compare the one with the other."""

from typing import Any

from tresym.reals.functions.table import CONSTANTS, TABLE
from tresym.reals.language.expression import ORDERS, UNWORKED, Expr, opened


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
    if node.op in UNWORKED:
        return _unworked_to_sympy(sympy, node, walk)
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
    return getattr(sympy, TABLE[node.op].sympy)(*args)


def _unworked_to_sympy(sympy: Any, node: Expr, walk: Any) -> Any:
    if node.op in ORDERS:
        return sympy.Function(node.op)(walk(node.args[0]))
    names, body = opened(node)
    inner, points = walk(body), [walk(arg) for arg in node.args[1:]]
    variables = [sympy.Symbol(name, real=True) for name in names]
    if node.op == "integral":
        return sympy.Integral(inner, (variables[0], *points))
    if node.op == "limit":
        side = {1: "+", -1: "-", 0: "+-"}[int(node.args[2].args[0].p)]
        return sympy.Limit(inner, variables[0], points[0], side)
    if node.op == "at":
        return sympy.Subs(inner, variables, points)
    return sympy.Subs(sympy.Derivative(inner, variables[0], evaluate=False), variables, points)
