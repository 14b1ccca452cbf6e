"""Write leading terms as readable text: ``-exp(-1)*t**2*exp(pi/t)/3`` as −t² e^{π/t}/(3e).

Findings contain leading terms as products in the grammar of claims. Here equal factors are
collected; no verdict depends on this.
"""

from __future__ import annotations

import ast
import operator
import re
from collections.abc import Callable
from typing import Any

import sympy
from sympy import Expr

_FUNCTIONS = ("exp", "log", "sqrt", "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh")
_SIGNS: dict[type[ast.operator], Callable[[Any, Any], Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Pow: operator.pow,
}


def size(text: str) -> str:
    """Return the leading term as readable text, or unchanged if it cannot be parsed."""
    try:
        # lambda is a keyword of Python.
        tree = ast.parse(text.strip().replace("lambda", "lambda_"), mode="eval")
        return _written(_expression(tree.body)).replace("lambda_", "lambda")
    except (SyntaxError, ValueError):
        return text


def _expression(node: ast.expr) -> Expr:
    match node:
        case ast.Constant(value=int(value)):
            return sympy.Integer(value)
        case ast.Name(id="pi"):
            return sympy.pi
        case ast.Name(id=name):
            # The parameter t of a path is positive; nothing is assumed about other symbols.
            return sympy.Symbol(name, **({"positive": True} if name == "t" else {"real": True}))
        case ast.UnaryOp(op=ast.USub(), operand=of):
            return -_expression(of)
        case ast.BinOp(left=left, op=sign, right=right) if type(sign) in _SIGNS:
            return _SIGNS[type(sign)](_expression(left), _expression(right))
        case ast.Call(func=ast.Name(id=name), args=[of]) if name in _FUNCTIONS:
            return getattr(sympy, name)(_expression(of))
    raise ValueError("not a leading term")


def _written(e: Expr) -> str:
    share, rest = e.as_coeff_Mul()
    above = [str(abs(share.p))] if abs(share.p) != 1 else []
    below = [str(share.q)] if share.q != 1 else []
    for base, power in rest.as_powers_dict().items():
        if base == sympy.E:
            fixed, moving = power.as_independent(*power.free_symbols, as_Add=True)
            if moving != 0:
                above.append(f"e^{{{moving}}}")
            base, power = base, fixed
        if power != 0:
            down = power.could_extract_minus_sign()
            (below if down else above).append(_power(base, -power if down else power))
    over, under = _product(above) or "1", _product(below)
    bottom = f"({under})" if len(below) > 1 else under
    return ("−" if share < 0 else "") + over + (f"/{bottom}" if bottom else "")


def _product(factors: list[str]) -> str:
    """The factors side by side, with no space after a number."""
    return re.sub(r"(?<=^\d) ", "", " ".join(factors))


def _power(base: Expr, power: Expr) -> str:
    name = "e" if base == sympy.E else str(base)
    if power == sympy.Rational(1, 2):
        return f"sqrt({name})"
    name = name if base.is_Symbol or base.is_Number or base == sympy.E else f"({name})"
    return name if power == 1 else f"{name}^{{{power}}}"
