"""Differentiate expressions."""

from __future__ import annotations

from typing import Any

from tresym.reals.functions.table import TABLE
from tresym.reals.language.expression import (
    ONE,
    ORDERS,
    UNWORKED,
    ZERO,
    Expr,
    add,
    apply,
    bind,
    fresh,
    instantiate,
    multiply,
    number,
    power,
    substitute,
    symbol,
    symbols,
    trees,
    unknown,
)
from tresym.reals.numbers.exact import InputError


def differentiate(e: Expr, name: str) -> Expr:
    """Return the formal derivative of ``e`` with respect to the variable ``name``.

    Formal means that ``log u`` gives ``u'/u`` and ``atanh u`` gives ``u'/(1 − u²)`` whatever the
    sign, so that the derivative may have a larger domain than ``e``. The derivative of an integral,
    a derivative or a limit stays a node of the tree, since nothing here proves that this derivative
    exists. A root is differentiated by the implicit function theorem; the result has no value where
    the slope vanishes.

    Raises:
        InputError: ``e`` contains an order such as O(x), which is not a function.
    """
    done: dict[Expr, Expr | None] = {}

    def walk(node: Expr) -> Expr | None:
        """Return the derivative, or None for zero."""
        if name not in symbols(node):
            return None
        if node not in done:
            if node.op == "root":
                done[node] = _root_derivative(node, name)
                return done[node]
            hidden = node.op in UNWORKED and node.op != "unknown"
            hidden = hidden or _has_no_formula(node, name)
            done[node] = _kept_derivative(node, name) if hidden else _derivative(node, walk)
        return done[node]

    return walk(e) or ZERO


def _derivative(node: Expr, walk: Any) -> Expr | None:
    if node.op == "symbol":
        return ONE
    parts = [walk(arg) for arg in node.args]
    if node.op == "+":
        return add(*(part for part in parts if part is not None))
    if node.op == "*":
        return add(
            *(
                multiply(*node.args[:i], part, *node.args[i + 1 :])
                for i, part in enumerate(parts)
                if part is not None
            )
        )
    if node.op == "^":
        return _power_derivative(*node.args, *parts)
    if node.op == "unknown":
        return _unknown_derivative(node, parts)
    if node.op == "atan2":
        y, x = node.args
        dy, dx = (ZERO if part is None else part for part in parts)
        return (x * dy - y * dx) / (x**2 + y**2)
    return _function_derivative(node, parts)


def _has_no_formula(node: Expr, name: str) -> bool:
    """Whether a function depends on ``name`` in an argument by which its derivative is not known.

    Such a derivative is a node, as that of an integral.
    """
    if node.op not in TABLE:
        return False
    pairs = zip(TABLE[node.op].derivatives, node.args, strict=True)
    return any(formula is None and name in symbols(arg) for formula, arg in pairs)


def _function_derivative(node: Expr, parts: list[Expr | None]) -> Expr:
    """Apply the chain rule to a function of the table."""
    formulas = TABLE[node.op].derivatives
    terms = []
    for n, part in enumerate(parts):
        if part is None:
            continue
        formula = formulas[n]
        assert formula is not None
        terms.append(multiply(formula(*node.args, trees), part))
    return add(*terms)


def _unknown_derivative(node: Expr, parts: list[Expr | None]) -> Expr:
    """Apply the chain rule to an arbitrary function."""
    name, orders = node.args[0].args
    return add(
        *(
            multiply(
                unknown(name, node.args[1:], (*orders[:i], orders[i] + 1, *orders[i + 1 :])), part
            )
            for i, part in enumerate(parts[1:])
            if part is not None
        )
    )


def _kept_derivative(node: Expr, name: str) -> Expr:
    if node.op in ORDERS:
        raise InputError(f"{node} is an order and has no derivative")
    return Expr("derivative", (bind(node, (name,)), symbol(name)), (name,))


def _root_derivative(node: Expr, name: str) -> Expr:
    """Return −F_a/F_y at the root y of F(y, a); the ends between which it lies do not matter."""
    own = fresh(node.names[0], symbols(node) | {name})
    body = instantiate(node.args[0], (symbol(own),))
    slope = -differentiate(body, name) / differentiate(body, own)
    return substitute(slope, {own: node})


def _power_derivative(base: Expr, exponent: Expr, db: Expr | None, de: Expr | None) -> Expr:
    terms = []
    if db is not None:
        lower = power(base, exponent - 1) if exponent != number(2) else base
        terms.append(multiply(exponent, lower, db))
    if de is not None:
        terms.append(multiply(power(base, exponent), apply("log", base), de))
    return add(*terms)
