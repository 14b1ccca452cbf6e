"""Comparisons in the form in which they were typed, for print.

    as_typed("(1 + t)**n == 1 + n*t + O(t**2)", links)

Expressions are kept with their terms in one fixed order and with like terms collected, which is
good for deciding and bad for reading: ``(t + 1)**n``, ``O(t**2) + n*t + 1``. The trees made here
keep the order and the form of the text. They are for print only, since nothing that computes
expects them. Each is compared with what is decided: where the text does not say exactly that, the
comparison is printed as it is decided.
"""

from __future__ import annotations

import ast
import re

from tresym.reals.language.expression import HALF, Expr, number, symbol
from tresym.reals.language.formula import Compared
from tresym.reals.language.parsing import parse, parse_claim, tidy, tree
from tresym.reals.language.readings import read_as
from tresym.reals.numbers.exact import InputError

_CLAUSE = re.compile(r"\s(?:given|as|at|on|uniformly|expect|using|from|instead|assumed)\b|\s---")
"""The words that end the formula of a claim."""
_SIGNS = {ast.Add: 1, ast.Sub: -1}


def as_typed(text: str, links: tuple[Compared, ...]) -> tuple[Compared, ...]:
    """Return the comparisons of a claim in the form of its text.

    Args:
        text: the claim as it was typed, with its conditions and other clauses.
        links: what it was read as.

    Returns:
        The comparisons with trees for print; ``links`` itself where the text says something else.
    """
    formula = _CLAUSE.split(text, maxsplit=1)[0]
    sides = [side for side in re.split(r"\s*(?:==|<=|>=|!=|~=|->|[<>~])\s*", formula) if side]
    if len(sides) != len(links) + 1:
        return links
    decided = [links[0][0], *(link[2] for link in links)] if links else []
    try:
        if [_read(side) for side in sides] != decided:
            return links
    except InputError:
        return links
    shown = [_typed(side, e) for side, e in zip(sides, decided, strict=True)]
    return tuple((shown[n], relation, shown[n + 1]) for n, (_, relation, _) in enumerate(links))


def _read(side: str) -> Expr:
    """Return a side of a comparison as it is decided; some notations are spelled out first."""
    try:
        return parse(side)
    except InputError:
        ((left, _, _), *_) = parse_claim(read_as(f"{side} == 0"))
        return left


def _typed(text: str, decided: Expr) -> Expr:
    try:
        source = tidy(text)
        return _tree(tree(source), source)
    except InputError:  # notations of other kinds, such as n!
        return decided


def _tree(node: ast.expr, source: str) -> Expr:
    """Return the tree of a part of the text; of what binds a variable, that which is decided."""
    match node:
        case ast.Constant():
            return symbol(ast.get_source_segment(source, node) or "")
        case ast.Name():
            return parse(node.id)
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return _minus(_tree(operand, source))
        case ast.BinOp(left=left, op=ast.Add() | ast.Sub() as op, right=right):
            first, last = _tree(left, source), _tree(right, source)
            last = last if _SIGNS[type(op)] > 0 else _minus(last)
            return Expr("+", (*_parts("+", first, left), last))
        case ast.BinOp(left=left, op=ast.Mult(), right=right):
            first, last = _tree(left, source), _tree(right, source)
            return Expr("*", (*_parts("*", first, left), *_parts("*", last, right)))
        case ast.BinOp(left=left, op=ast.Div(), right=right):
            below = Expr("^", (_tree(right, source), number(-1)))
            first = _tree(left, source)
            above = () if first == symbol("1") else _parts("*", first, left)
            return Expr("*", (*above, below))
        case ast.BinOp(left=left, op=ast.Pow(), right=right):
            exponent = parse(ast.get_source_segment(source, right) or "")
            if exponent.op != "number":
                exponent = _tree(right, source)
            return Expr("^", (_tree(left, source), exponent))
        case ast.Call(func=ast.Name(id=name), args=args, keywords=[]):
            return _call(name, args, ast.get_source_segment(source, node) or "", source)
    return parse(ast.get_source_segment(source, node) or "")


def _call(name: str, args: list[ast.expr], text: str, source: str) -> Expr:
    if name == "binomial" and len(args) == 2:
        return Expr("binomial", tuple(_tree(arg, source) for arg in args))
    decided = parse(text)
    if decided.names or (decided.hidden and decided.op != "unknown" and decided.op != "O"):
        return decided
    inside = tuple(_tree(arg, source) for arg in args)
    if name == "sqrt":
        return Expr("^", (*inside, HALF))
    if decided.op == name and len(decided.args) == len(inside):
        return Expr(name, inside)
    if decided.op == "unknown" and len(decided.args) == len(inside) + 1:
        return Expr("unknown", (decided.args[0], *inside))
    return decided


def _parts(op: str, e: Expr, node: ast.expr) -> tuple[Expr, ...]:
    """Return the terms or factors of what was typed without parentheses around it."""
    return e.args if e.op == op and isinstance(node, ast.BinOp) else (e,)


def _minus(e: Expr) -> Expr:
    return Expr("*", (number(-1), *(e.args if e.op == "*" else (e,))))
