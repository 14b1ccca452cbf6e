"""Write an expression in the one form in which the texts of the theorems have it.

Coq's proofs are stored for the texts of their theorems, so that a theorem must have one text
however its claim is written: ``1/(a*b)`` as ``1/a*1/b``, ``x*x`` as ``x**2``, and terms and factors
in one order. The form is that of SymPy, which wrote the first texts, and where SymPy has no such
expression, or works more out than the form, the order alone: numbers before pi, then symbols,
powers, products, sums, and functions by name; operands of one kind by the number of their own
operands, and then one by one. Only texts for Coq are made here; no verdict rests on them.

Source of the order: SymPy, ``Basic.compare``.
"""

from __future__ import annotations

from functools import cache
from typing import Any

from tresym.reals.functions.table import TABLE
from tresym.reals.language.binders import outermost
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.expression import (
    BINDERS,
    LEAVES,
    ZERO,
    E,
    Expr,
    add,
    bind,
    factors_in,
    instantiate,
    opened,
    rebuild,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import Relation
from tresym.reals.language.sympy import unworked
from tresym.reals.language.to_sympy import to_sympy
from tresym.reals.numbers.exact import InputError

_KINDS = (
    *("Zero", "One", "Half", "NegativeOne", "Integer", "Rational", "Exp1", "pi", "symbol"),
    *("^", "*", "+", "derivative", "integral", "abs"),
)
_RANKS = {kind: rank for rank, kind in enumerate(_KINDS)}
_NAMES = {"at": "Subs", "root": "TheRoot", "limit": "Limit", "sum": "Sum", "product": "Product"}
_SPECIAL = {"0": "Zero", "1": "One", "1/2": "Half", "-1": "NegativeOne"}


@cache
def arranged(e: Expr) -> Expr:
    """Return ``e`` in the form of the texts of theorems.

    It is taken from SymPy, on purpose and here alone: a proof is stored for the text that results.

    Example:
        >>> from tresym.reals.language.parsing import parse
        >>> str(arranged(parse("x*x + sin(a)/(b*a)")))
        'x**2 + 1/a/b*sin(a)'
    """
    if e in (INFINITY, -INFINITY):
        return e
    nodes = [node for node in outermost(e) if node.op == "root"]
    marks = {node: symbol(f"[{n}]") for n, node in enumerate(nodes)}
    try:
        plain = unworked(to_sympy(replaced(e, marks)))
    except InputError:  # SymPy has no such expression
        return in_one_order(e)
    back = {str(mark): _arranged_root(node) for node, mark in marks.items()}
    return in_one_order(substitute(plain, back)) if marks else plain


def _arranged_root(e: Expr) -> Expr:
    names, body = _opened(e)
    return Expr("root", (bind(arranged(body), names), *map(arranged, e.args[1:])), e.names)


def entry_of_a_matrix(e: Expr) -> Expr:
    """Return an entry of a product of matrices, in which terms with the factor 0 stay."""
    return in_one_order(e) if _has_zero(e) else arranged(e)


def first_one_first(sides: tuple[Relation, Relation]) -> tuple[Relation, Relation]:
    """Return the two sides of an equivalence in one order, that of the texts of theorems."""
    from sympy import Eq
    from sympy.core.sorting import ordered

    try:
        made = [Eq(*map(to_sympy, p[::2]), evaluate=False) for p in sides]
    except InputError:
        return sides
    return sides if next(iter(ordered(made))) == made[0] else (sides[1], sides[0])


def _has_zero(e: Expr) -> bool:
    """Return whether a product in the expression has the factor 0."""
    if e.op in LEAVES:
        return False
    return (e.op == "*" and e.args[0] == ZERO) or any(map(_has_zero, e.args))


def in_one_order(e: Expr) -> Expr:
    """Return ``e`` with the operands of sums and products in the order of the theorems.

    Example:
        >>> from tresym.reals.language.parsing import parse
        >>> str(in_one_order(parse("sin(a) + b + a**2")))
        'b + a**2 + sin(a)'
    """
    if e.op in LEAVES:
        return e
    if e.op in BINDERS:
        names, body = _opened(e)
        body = in_one_order(body)
        if e.op == "root" and body.op == "+":  # an equation: left side minus right side
            body = add(*sorted(body.args, key=_is_negative))
        inner = bind(body, names)
        return Expr(e.op, (inner, *map(in_one_order, e.args[1:])), e.names)
    args = tuple(in_one_order(arg) for arg in e.args)
    return rebuild(e, tuple(sorted(args, key=_key)) if e.op in ("+", "*") else args)


def _is_negative(term: Expr) -> bool:
    """Return whether a term has a negative number as a factor."""
    first = factors_in(term)[0]
    return first.op == "number" and first.args[0] < 0


def _opened(e: Expr) -> tuple[tuple[str, ...], Expr]:
    """Return the names and the body of a binder; its own names where they are free for it."""
    if symbols(e.args[0]).isdisjoint(e.names) and len({*e.names}) == len(e.names):
        return e.names, instantiate(e.args[0], tuple(map(symbol, e.names)))
    return opened(e)


@cache
def _key(e: Expr) -> tuple[Any, ...]:
    """Return what is compared: the kind, the number of operands, and the operands."""
    if e.op == "number":
        r = e.args[0]
        kind = _SPECIAL.get(str(r)) or ("Integer" if r.q == 1 else "Rational")
        return _made(kind, (int(r.p), int(r.q)))
    if e.op == "symbol":
        return _made("symbol", e.args)
    if e == E:
        return _made("Exp1", ())
    if e.op == "at" or (e.op == "derivative" and e.args[1].op != "symbol"):
        there = tuple(symbol(f"_{point}") for point in e.args[1:])  # named for the values
        inner = _key(in_one_order(instantiate(e.args[0], there)))
        slope = e.op == "derivative"
        return _made("at", (_made("derivative", (inner, _by(there))) if slope else inner,))
    if e.op in BINDERS:
        names, body = _opened(e)
        variables = tuple(map(symbol, names))
        ends = [_key(arg) for arg in e.args[1:]]
        if e.op == "derivative":
            return _made(e.op, (_key(body), _by(variables)))
        return _made(e.op, (_key(body), _made("Tuple", (*map(_key, variables), *ends))))
    args = e.args if e.op != "+" else sorted(e.args, key=lambda arg: arg.op != "number")
    return _made(e.op, [_key(arg) if isinstance(arg, Expr) else arg for arg in args])


def _by(variables: tuple[Expr, ...]) -> tuple[Any, ...]:
    """Return what is compared of the variables by which a derivative is taken once."""
    return _made("Tuple", (*map(_key, variables), _made("One", (1, 1))))


def _made(kind: str, content: Any) -> tuple[Any, ...]:
    row = TABLE.get(kind)
    name = row.sympy if row is not None and row.sympy else _NAMES.get(kind, kind)
    rank = _RANKS.get(kind)
    return (len(_RANKS), name) if rank is None else (rank, ""), len(content), *content
