"""Reading expressions and conditions from text, through Python's ``ast`` on a whitelist.

Nothing is evaluated. Text is bounded in length and nesting before it is parsed; decimals are read
from the text itself and are exact.

Grammar: ``+ - * / **`` (also ``^``), parentheses, decimals and fractions, names, ``pi``, ``E``, the
functions of :data:`tresym.reals.language.expression.FUNCTIONS` with ``sqrt``, ``ln``, ``Abs``, the
``arc…`` names and ``atan2(y, x)``, and ``diff(expression, x[, n])``. Comparisons make conditions
and claims; ``O(…)`` and ``o(…)`` stand at the right end of a claim.
"""

from __future__ import annotations

import ast
import re
import unicodedata
import warnings
from collections.abc import Callable
from typing import NamedTuple

from tresym.reals.language.expression import (
    FUNCTIONS,
    MAX_DEPTH,
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
    sqrt,
    symbol,
)
from tresym.reals.language.hints import about_function, about_name, hint
from tresym.reals.numbers.exact import InputError, parse_number

MAX_CHARACTERS = 30_000

_ALIASES = {"ln": "log", "Abs": "abs", "sgn": "sign"} | {
    f"arc{name}": f"a{name}"
    for name in (
        *("sin", "cos", "tan", "cot", "sec", "csc"),
        *("sinh", "cosh", "tanh", "coth", "sech", "csch"),
    )
}
_NOT_REAL = frozenset(("I", "oo", "zoo", "nan", "inf"))
_RECIPROCALS = {
    "asec": "acos",
    "acsc": "asin",
    "acot": "atan",
    "asech": "acosh",
    "acsch": "asinh",
    "acoth": "atanh",
}
_FOLDED = {"max": 1, "min": -1, "Max": 1, "Min": -1}
_KNOWN = FUNCTIONS | _ALIASES.keys() | _RECIPROCALS.keys() | _FOLDED.keys()
_KNOWN |= {"sqrt", "atan2", "diff", "Derivative"}


class Derivative(NamedTuple):
    """A derivative that was written: of which function, by which variable, how often; its value."""

    function: Expr
    by: str
    order: int
    value: Expr


def parse(text: str) -> Expr:
    """The expression that ``text`` writes.

    Raises:
        InputError: text outside the grammar or its bounds; one line says which.
    """
    source = tidy(text)
    return _Reader(source).read(tree(source))


def tidy(text: str) -> str:
    """``text`` with ``^`` as ``**``, its length and nesting checked.

    Raises:
        InputError: empty, too long, not ASCII, or nested too deeply.
    """
    if len(text) > MAX_CHARACTERS:
        raise InputError(f"{len(text)} characters are beyond the limit of {MAX_CHARACTERS}")
    if not text.strip():
        raise InputError("an expression is expected, the text is empty")
    if not text.isascii() or "\0" in text:
        strange = next((c for c in text if not c.isascii() or c == "\0"), "")
        name = unicodedata.name(strange, "control").lower()
        raise InputError(f"the character {strange!a} ({name}) is not read")
    depth = deepest = 0
    for character in text:
        depth += (character in "([{") - (character in ")]}")
        deepest = max(deepest, depth)
    if deepest > MAX_DEPTH or re.search(r"([-+~]\s*){50}", text):
        raise InputError(f"the expression is nested deeper than {MAX_DEPTH} levels")
    return " ".join(text.split()).replace("^", "**")


def tree(source: str) -> ast.expr:
    """Python's syntax tree of ``source``.

    Raises:
        InputError: not an expression, or too deep for the parser.
    """
    try:
        with warnings.catch_warnings():  # of text such as 1or 2, which is refused in our words
            warnings.simplefilter("ignore", SyntaxWarning)
            warnings.simplefilter("ignore", DeprecationWarning)
            return ast.parse(source, mode="eval").body
    except SyntaxError:
        advice = hint(source, _KNOWN)
        raise InputError(f"{_quoted(source)} is not an expression{advice}") from None
    except (RecursionError, MemoryError, ValueError):
        raise InputError("the expression is nested too deeply or a number is too long") from None


def _quoted(source: str) -> str:
    return ascii(source if len(source) <= 60 else source[:57] + "...")


class _Reader:
    """Turns a syntax tree into an expression; keeps the text for exact numbers.

    Attributes:
        derivatives: each with its variable, its order, and its derivative.
    """

    def __init__(self, source: str) -> None:
        self.source = source
        self.derivatives: list[Derivative] = []

    def read(self, node: ast.expr) -> Expr:
        try:
            return self._read(node)
        except RecursionError:
            raise InputError(f"the expression is nested deeper than {MAX_DEPTH} levels") from None

    def _read(self, node: ast.expr) -> Expr:
        match node:
            case ast.Constant():
                if type(node.value) not in (int, float):
                    raise self._refuse(node)
                return number(parse_number(self._segment(node)))
            case ast.Name(id="pi"):
                return PI
            case ast.Name(id="E"):
                return E
            case ast.Name(id=name):
                if name in _NOT_REAL:
                    raise InputError(f"{name} is no real number or variable, and all here are real")
                if name in _KNOWN:
                    raise InputError(about_name(name))
                if name.startswith("__"):
                    raise InputError(f"{name} cannot be the name of a variable")
                return symbol(name)
            case ast.UnaryOp(op=ast.USub()):
                return -self._read(node.operand)
            case ast.UnaryOp(op=ast.UAdd()):
                return self._read(node.operand)
            case ast.BinOp(op=ast.Add() | ast.Sub()):
                return self._chain(node, (ast.Add, ast.Sub), add, lambda e: -e)
            case ast.BinOp(op=ast.Mult() | ast.Div()):
                return self._chain(node, (ast.Mult, ast.Div), multiply, lambda e: 1 / e)
            case ast.BinOp(op=ast.Pow()):
                return power(self._read(node.left), self._read(node.right))
            case ast.Call(func=ast.Name(id=name), keywords=[]):
                return self._call(name, node.args)
        raise self._refuse(node)

    def _chain(
        self,
        node: ast.BinOp,
        ops: tuple[type[ast.operator], type[ast.operator]],
        join: Callable[..., Expr],
        invert: Callable[[Expr], Expr],
    ) -> Expr:
        """A left-nested chain such as ``a - b + c``, without recursion along it."""
        parts: list[Expr] = []
        left: ast.expr = node
        while isinstance(left, ast.BinOp) and isinstance(left.op, ops):
            right = self._read(left.right)
            parts.append(invert(right) if isinstance(left.op, ops[1]) else right)
            left = left.left
        parts.append(self._read(left))
        return join(*reversed(parts))

    def _call(self, name: str, args: list[ast.expr]) -> Expr:
        if name in ("diff", "Derivative"):
            return self._diff(args)
        values = [self._read(arg) for arg in args]
        name = _ALIASES.get(name, name)
        if name == "atan2" and len(values) == 2:
            return angle(*values)
        if name == "log" and len(values) == 2:
            return apply("log", values[0]) / apply("log", values[1])
        if name in _FOLDED and len(values) > 1:
            return extreme(_FOLDED[name], values)
        if name not in _KNOWN:
            raise InputError(f"unknown function {name}: {about_function(name, _KNOWN)}")
        if len(values) != 1:
            raise InputError(f"{name} takes one argument, {len(values)} given")
        if name == "sqrt":
            return sqrt(values[0])
        if name in _RECIPROCALS:
            return apply(_RECIPROCALS[name], 1 / values[0])
        return apply(name, values[0])

    def _diff(self, args: list[ast.expr]) -> Expr:
        if len(args) not in (2, 3) or (name := self._read(args[1])).op != "symbol":
            raise InputError("diff takes an expression, a variable and perhaps an order")
        variable = str(name.args[0])
        result = self._read(args[0])
        order = 1
        if len(args) == 3:
            last = args[2]
            if not (isinstance(last, ast.Constant) and type(last.value) is int):
                raise InputError("the order of diff is a positive integer")
            order = last.value
        if not 1 <= order <= MAX_DERIVATIVES:
            raise InputError(f"the order of diff goes from 1 to {MAX_DERIVATIVES}")
        function = result
        for _ in range(order):
            result = differentiate(result, variable)
        self.derivatives.append(Derivative(function, variable, order, result))
        return result

    def _segment(self, node: ast.expr) -> str:
        return self.source[node.col_offset : node.end_col_offset]

    def _refuse(self, node: ast.expr) -> InputError:
        text = self._segment(node)
        advice = hint(text, _KNOWN)
        if isinstance(node, ast.Call):
            advice = " (write * between factors)"
        elif isinstance(node, ast.Tuple):
            advice = " (decimals have a point; one claim at a time)"
        return InputError(
            f"{_quoted(text)} is not allowed in an expression{advice}; allowed are numbers, names, "
            "+ - * / **, parentheses and the documented functions"
        )


_RELATIONS: dict[type[ast.cmpop], str] = {
    ast.Gt: ">",
    ast.GtE: ">=",
    ast.Lt: "<",
    ast.LtE: "<=",
    ast.NotEq: "!=",
}


NO_DERIVATIVE = "a condition takes no derivative: write it out, and where its function is real"


def parse_conditions(text: str) -> list[tuple[Expr, str, Expr]]:
    """Comma-separated chains of comparisons as ``(left, relation, right)``.

    Raises:
        InputError: anything but ``> >= < <= !=`` between expressions.
    """
    if not text.strip():
        return []
    source = tidy(text)
    body = tree(source)
    reader = _Reader(source)
    result: list[tuple[Expr, str, Expr]] = []
    for part in body.elts if isinstance(body, ast.Tuple) else [body]:
        if not isinstance(part, ast.Compare):
            advice = "" if not isinstance(part, ast.BoolOp) else "; conditions go apart by commas"
            shown = _quoted(reader._segment(part))
            raise InputError(f"{shown} is not a condition such as a > 0{advice}")
        left = reader.read(part.left)
        for op, node in zip(part.ops, part.comparators, strict=True):
            if type(op) not in _RELATIONS:
                raise InputError("a condition uses one of > >= < <= !=, as in 0 < x <= 1")
            right = reader.read(node)
            result.append((left, _RELATIONS[type(op)], right))
            left = right
    if reader.derivatives:
        raise InputError(NO_DERIVATIVE)
    return result


_CLAIMS = _RELATIONS | {ast.Eq: "=="}


Claimed = tuple[Expr, str, Expr, tuple[Derivative, ...]]
"""``left relation right``, and the derivatives that were written."""


def parse_claim(text: str) -> list[Claimed]:
    """A chain of comparisons, or one order statement.

    Relations are ``== != > >= < <=``; ``f ~ g``; ``f == O(g)`` and ``f == h + o(g)``, which come
    out as ``(f - h, "o", g)``.

    Raises:
        InputError: anything else; one line says what is expected.
    """
    source = tidy(text)
    if source.count("~") == 1:
        readers = [_Reader(tidy(side)) for side in source.split("~")]
        left, right = (reader.read(tree(reader.source)) for reader in readers)
        return [_claimed((left, "~", right), *readers)]
    if re.search(r"(?<![=<>!~])=(?!=)", source):
        advice = hint(source, _KNOWN) if re.search("=[<>]", source) else ""
        raise InputError(f"write == for equality: {_quoted(source)}{advice}")
    body = tree(source)
    if not isinstance(body, ast.Compare):
        apart = isinstance(body, ast.Tuple | ast.BoolOp)
        advice = " (one claim at a time; decimals have a point)" if apart else ""
        raise InputError(
            f"{_quoted(source)} claims nothing{advice}; compare two expressions with one of "
            "== != > >= < <= ~, as in sin(x)**2 + cos(x)**2 == 1"
        )
    reader = _Reader(source)
    nodes = [body.left, *body.comparators]
    if isinstance(body.ops[0], ast.Eq) and len(nodes) == 2 and (order := _order_term(nodes[1])):
        return [_claimed(_order_claim(reader, nodes[0], nodes[1], order), reader)]
    result = []
    left_side = reader.read(nodes[0])
    for op, node in zip(body.ops, nodes[1:], strict=True):
        if type(op) not in _CLAIMS:
            raise InputError("a claim uses one of == != > >= < <= ~")
        right_side = reader.read(node)
        result.append((left_side, _CLAIMS[type(op)], right_side))
        left_side = right_side
    return [_claimed(part, reader) for part in result]


def _claimed(part: tuple[Expr, str, Expr], *readers: _Reader) -> Claimed:
    """A comparison with what its readers met."""
    found = (derivative for reader in readers for derivative in reader.derivatives)
    return *part, tuple(dict.fromkeys(found))


def _order_term(node: ast.expr) -> ast.Call | None:
    """The last term of a sum where it is ``O(…)`` or ``o(…)``."""
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
        node = node.right
    match node:
        case ast.Call(func=ast.Name(id="O" | "o"), args=[_], keywords=[]):
            return node
    return None


def _order_claim(
    reader: _Reader, left: ast.expr, right: ast.expr, order: ast.Call
) -> tuple[Expr, str, Expr]:
    function = reader.read(left)
    if isinstance(right, ast.BinOp):
        function = function - reader.read(right.left)
    name = order.func.id if isinstance(order.func, ast.Name) else ""
    return function, name, reader.read(order.args[0])
