"""Parse expressions and conditions from text, through Python's ``ast`` with a whitelist.

Nothing is evaluated. The length and nesting of the text are checked before it is parsed. Decimals
are converted from the text itself and are exact.

Grammar: ``+ - * / **`` (also ``^``), parentheses, decimals and fractions, names, ``pi``, ``E``, the
functions of :data:`tresym.reals.language.expression.FUNCTIONS` with ``sqrt``, ``ln``, ``Abs``, the
``arc…`` names and ``atan2(y, x)``, and operations that bind a variable: ``diff(f, x[, n])``,
``integral(f, x, low, high)``, ``at(f, x, value)``, ``limit(f, x, point[, side])``,
``root(f, x, low, high)``, the only zero of f strictly between the ends, and
``coefficient(f, z, n)``, that of z**n. Conditions and
claims are comparisons; ``O(…)`` and ``o(…)`` may occur only at the right end of a claim.
"""

from __future__ import annotations

import ast
import re
import unicodedata
import warnings
from collections.abc import Callable

from tresym.reals.language.binders import (
    at,
    elementary,
    nth_derivative,
    order,
    outermost,
    repeated_derivative,
    worked_out,
)
from tresym.reals.language.brackets import split
from tresym.reals.language.calls import (
    FACTORIAL,
    INFINITE,
    INFINITY,
    INTEGERS,
    KNOWN,
    NAMED_CONSTANTS,
    SPECIAL_NAMES,
    UNKNOWN,
    call,
    unknown_function_error,
)
from tresym.reals.language.ellipsis import meant
from tresym.reals.language.expression import (
    DOTS,
    MAX_DEPTH,
    MAX_DERIVATIVES,
    ORDERS,
    PI,
    E,
    Expr,
    add,
    multiply,
    number,
    power,
    symbol,
    symbols,
    unknown,
)
from tresym.reals.language.formula import Compared
from tresym.reals.language.operators import CALLED, ENDS, Range, applied
from tresym.reals.language.suggestions import about_name, hint
from tresym.reals.numbers.exact import InputError, parse_number, printed

MAX_CHARACTERS = 30_000
_NOT_REAL = frozenset(("I", "oo", "zoo", "nan", "inf", "infinity", "Infinity"))
_INTEGER = re.compile(r"\b(\w+)\s+(?:is\s+)?(?:an\s+)?integer\b")
_RECURRENCE = re.compile(
    r"(?:^|,|=)\s*([A-Za-z]\w*)\(\s*([A-Za-z]\w*)\s*\+\s*[1-9]\s*\)\s*(?==|,|$)"
)
_RECURRENCE_DOWN = re.compile(r"(?:^|,|=)\s*([A-Za-z]\w*)\(\s*([A-Za-z]\w*)\s*\)\s*(?==)")
_EQUALS = re.compile(r"(?<![=<>!~:])=(?![=<>])")
_LONG_INTEGER = re.compile(r"(?<![\w.])(\d{4000,})(?![\w.])")
"""Python's parser rejects integers with more digits, but accepts them as decimals."""
ORDER_NAMES = frozenset("jkmnN")
"""Names allowed as the order of a derivative; with others diff(f, x, y) may be a mixed one."""


def parse(text: str) -> Expr:
    """Parse an expression, carry out its derivatives and substitute its values at points.

    Raises:
        InputError: the text is outside the grammar or its bounds; the message is one line.

    Example:
        >>> str(parse("diff(x^3, x)"))
        '3*x**2'
    """
    e = worked_out(as_written(text))
    for node in outermost(e):
        if node.op == "unknown":
            raise unknown_function_error(node.args[0].args[0])
    return e


def sequences_of(text: str) -> frozenset[str]:
    """Return the names for which conditions state a recurrence, as a in ``a(n + 1) == sin(a(n))``.

    The recurrence may also lead to a(n), as in ``T(n) == 2*T(n - 1) + 1`` and
    ``T(n) == T(floor(n/2)) + T(ceiling(n/2)) + n``.

    Any name that is not a known function may denote a sequence.
    """
    up = {(match[1], match[2]) for match in _RECURRENCE.finditer(text)}
    found = {name for name, n in up if re.search(rf"(?<![A-Za-z_]){name}\(\s*{n}\s*\)", text)}
    down = list(_RECURRENCE_DOWN.finditer(text))
    for match, end in zip(down, (*(m.start() for m in down[1:]), len(text)), strict=False):
        said = re.split(r",\s*[A-Za-z]\w*\s*\([^,()]*\)\s*=", text[match.end() : end])[0]
        name, n = match.groups()
        if re.search(rf"(?<![A-Za-z_]){name}\(\s*(?!{n}\s*\))(?=[^=,]*\b{n}\b)", said):
            found.add(name)
    return frozenset(found - KNOWN)


def as_written(text: str, sequences: frozenset[str] = frozenset()) -> Expr:
    """Parse an expression, with derivatives and values at a point as nodes.

    ``str`` converts the result back to text.

    Args:
        text: the expression.
        sequences: names that denote sequences beside the usual names of functions.

    Raises:
        InputError: the text is outside the grammar or its bounds; the message is one line.
    """
    source = tidy(text)
    return _Reader(source, sequences).read(tree(source))


def tidy(text: str) -> str:
    """Return ``text`` with ``^`` as ``**``, after checking its length and nesting.

    Raises:
        InputError: the text is empty, too long, not ASCII, or nested too deeply.
    """
    if len(text) > MAX_CHARACTERS:
        raise InputError(f"{len(text)} characters are beyond the limit of {MAX_CHARACTERS}")
    if not text.strip():
        raise InputError("the text is empty; write an expression")
    if not text.isascii() or "\0" in text:
        strange = next((c for c in text if not c.isascii() or c == "\0"), "")
        name = unicodedata.name(strange, "control").lower()
        raise InputError(f"the character {strange!a} ({name}) is not supported")
    depth = deepest = 0
    for character in text:
        depth += (character in "([{") - (character in ")]}")
        deepest = max(deepest, depth)
    if deepest > MAX_DEPTH or re.search(r"([-+~]\s*){50}", text):
        raise InputError(f"the expression is nested deeper than {MAX_DEPTH} levels")
    return _LONG_INTEGER.sub(r"\1.", " ".join(text.split()).replace("^", "**"))


def tree(source: str) -> ast.expr:
    """Return Python's syntax tree of ``source``.

    Raises:
        InputError: the text is not an expression, or is nested too deeply for the parser.
    """
    try:
        with (
            warnings.catch_warnings()
        ):  # for text such as 1or 2, which is rejected with our message
            warnings.simplefilter("ignore", SyntaxWarning)
            warnings.simplefilter("ignore", DeprecationWarning)
            return ast.parse(source, mode="eval").body
    except SyntaxError:
        advice = hint(source, KNOWN)
        raise InputError(f"{_quoted(source)} is not an expression{advice}") from None
    except (RecursionError, MemoryError, ValueError):
        raise InputError("the expression is nested too deeply or a number is too long") from None


def _quoted(source: str) -> str:
    return ascii(source if len(source) <= 60 else source[:57] + "...")


class _Reader:
    """Convert a syntax tree to an expression, taking exact numbers from the text."""

    def __init__(self, source: str, sequences: frozenset[str] = frozenset()) -> None:
        self.source, self.sequences = source, sequences

    def read(self, node: ast.expr) -> Expr:
        try:
            return self._read(node)
        except RecursionError:
            raise InputError(f"the expression is nested deeper than {MAX_DEPTH} levels") from None

    def _read(self, node: ast.expr) -> Expr:
        match node:
            case ast.Constant(value=value) if value is ...:
                raise InputError("dots must be a term of a sum, as in 1 + x + x**2/2 + ...")
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
                    raise InputError(
                        f"{name} is not a real number or variable; all values are real"
                    )
                if name in NAMED_CONSTANTS:
                    return NAMED_CONSTANTS[name]
                if name in KNOWN - SPECIAL_NAMES:
                    raise InputError(about_name(name))
                if name.startswith("__"):
                    raise InputError(f"{name} cannot be the name of a variable")
                return symbol(name)
            case ast.UnaryOp(op=ast.USub()):
                return -self._read(node.operand)
            case ast.UnaryOp(op=ast.UAdd()):
                return self._read(node.operand)
            case ast.BinOp(op=ast.Add() | ast.Sub()):
                return self._chain(node, (ast.Add, ast.Sub), sum_of, lambda e: -e)
            case ast.BinOp(op=ast.Mult() | ast.Div()):
                return self._chain(node, (ast.Mult, ast.Div), multiply, lambda e: 1 / e)
            case ast.BinOp(op=ast.Pow()):
                base, exponent = self._read(node.left), self._read(node.right)
                if base == symbol("e") and symbols(exponent):
                    raise InputError(
                        f"two readings remain: write exp({exponent}), or the variable e by "
                        "another name"
                    )
                return power(base, exponent)
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
        """Convert a left-nested chain such as ``a - b + c`` without recursion along it."""
        parts: list[Expr] = []
        left: ast.expr = node
        while isinstance(left, ast.BinOp) and isinstance(left.op, ops):
            dots = isinstance(left.right, ast.Constant) and left.right.value is ...
            right = DOTS if dots and join is sum_of else self._read(left.right)
            parts.append(invert(right) if isinstance(left.op, ops[1]) else right)
            left = left.left
        parts.append(self._read(left))
        return join(*reversed(parts))

    def _call(self, name: str, args: list[ast.expr]) -> Expr:
        if name in ("diff", "Derivative"):
            return self._diff(args)
        if name in ORDERS and len(args) == 1:
            return order(name, self._read(args[0]))
        if name in CALLED and (operator := self._operator(CALLED[name], args)):
            return operator
        if name == "at" and len(args) > 2 and len(args) % 2:
            pairs = zip(args[1::2], args[2::2], strict=True)
            return at(self._read(args[0]), {self._name(x): self._read(p) for x, p in pairs})
        unknown_here = UNKNOWN.fullmatch(name) or name in self.sequences
        if args and unknown_here and not self._stands_alone(name):
            if name == FACTORIAL:
                return call(name, [self._read(arg) for arg in args])
            return unknown(name, tuple(self._read(arg) for arg in args))
        if name in SPECIAL_NAMES and self._stands_alone(name):
            raise InputError(
                f"two readings remain: {name} is a variable and a function here; write {name}*(…) "
                "for a product, or give the variable another name"
            )
        return call(name, [self._read(arg) for arg in args])

    def _operator(self, kind: str, args: list[ast.expr]) -> Expr | None:
        """Return an integral, a sum, a product, a limit or a root; None if the ends are missing."""
        side = ""
        if kind == "limit" and len(args) == 4:
            *args, last = args
            side = str(self._whole(last, range(-1, 2), "the side of a limit is 1, -1 or 0"))
        if len(args) - 2 not in ENDS[kind]:
            return None
        body, name = self._read(args[0]), self._name(args[1])
        return applied(kind, Range(name, tuple(map(self._end, args[2:])), side), body)

    def _stands_alone(self, name: str) -> bool:
        """Return whether a name is also used as a variable."""
        return re.search(rf"\b{name}\b(?!\s*\()", self.source) is not None

    def _diff(self, args: list[ast.expr]) -> Expr:
        if len(args) not in (2, 3):
            raise InputError("diff takes an expression, a variable and optionally an order")
        e, name, times = self._read(args[0]), self._name(args[1]), 1
        if len(args) == 3 and (names := symbols(order := self._read(args[2]))):
            if not names <= ORDER_NAMES - symbols(e):
                raise InputError(
                    f"an order of diff is a number or one of {', '.join(sorted(ORDER_NAMES))}; "
                    f"for a mixed derivative write diff(diff(f, x), y)"
                )
            return nth_derivative(e, name, order)
        if len(args) == 3:
            expected = f"the order of diff is an integer from 1 to {MAX_DERIVATIVES}"
            times = self._whole(args[2], range(1, MAX_DERIVATIVES + 1), expected)
        return repeated_derivative(e, name, times)

    def _name(self, node: ast.expr) -> str:
        """Return the name of a bound variable or of a variable of differentiation."""
        e = self._read(node)
        if e.op != "symbol":
            raise InputError(
                f"{e} is not a variable: write the variable second, as in integral(f, x, a, b)"
            )
        return str(e.args[0])

    def _whole(self, node: ast.expr, allowed: range, expected: str) -> int:
        e = self._read(node)
        if e.op != "number" or e.args[0].q != 1 or int(e.args[0].p) not in allowed:
            raise InputError(expected)
        return int(e.args[0].p)

    def _end(self, node: ast.expr) -> Expr:
        """Return an expression, ``oo`` or ``-oo``."""
        return INFINITE.get(self._segment(node).replace(" ", "")) or self._read(node)

    def _segment(self, node: ast.expr) -> str:
        return self.source[node.col_offset : node.end_col_offset]

    def _refuse(self, node: ast.expr) -> InputError:
        text = self._segment(node)
        advice = hint(text, KNOWN)
        if isinstance(node, ast.Call):
            advice = " (write * between factors)"
        elif isinstance(node, ast.Tuple):
            advice = " (decimals have a point; one claim at a time)"
        return InputError(
            f"{_quoted(text)} is not allowed in an expression{advice}; allowed are numbers, names, "
            "+ - * / **, parentheses and the documented functions"
        )


def sum_of(*terms: Expr) -> Expr:
    """Return the sum of terms, one of which may be dots.

    Dots before the last term stand for the terms of a finite sum, and dots after numbers for those
    of a series. Other dots remain a term that is not known.

    Raises:
        InputError: the general term is not found.
    """
    if DOTS not in terms and -DOTS not in terms:
        return add(*terms)
    return meant([DOTS if term == -DOTS else term for term in terms])


_RELATIONS: dict[type[ast.cmpop], str] = {
    ast.Eq: "==",
    ast.Gt: ">",
    ast.GtE: ">=",
    ast.Lt: "<",
    ast.LtE: "<=",
    ast.NotEq: "!=",
    ast.In: "in",
}


def parse_conditions(text: str) -> list[Compared]:
    """Parse comma-separated chains of comparisons as ``(left, relation, right)``.

    Raises:
        InputError: the text contains anything but ``> >= < <= !=`` between expressions.

    Example:
        >>> [(str(x), sign, str(y)) for x, sign, y in parse_conditions("0 < x <= 1")]
        [('0', '<', 'x'), ('x', '<=', '1')]
    """
    return [condition(*part) for part in parse_given(text)]


def parse_given(text: str) -> list[Compared]:
    """Parse conditions as :func:`parse_conditions` does, also equations and ``n integer``.

    The condition ``n integer`` becomes ``(n, "in", ZZ)``, and ``x ~= 1.5`` the two conditions
    ``1.45 <= x <= 1.55``. An equation may end in an order, as
    ``y == x + O(1)``, and ``y ~ a + b`` becomes ``y == a + b + o(a)`` and ``y == a + b + o(b)``.

    Raises:
        InputError: the text contains anything but ``== ~ > >= < <= !=`` between expressions.
    """
    if not text.strip():
        return []
    if "~=" in text:  # a rounded number stands for all that round to it
        parts = split(text, ",")
        return [
            link
            for part in parts
            for link in (_printed(tidy(part)) if "~=" in part else parse_given(part))
        ]
    if "~" in text and _TILDE in text:
        raise InputError("a condition uses one of == ~ > >= < <= !=, as in 0 < x <= 1")
    source = tidy(_INTEGER.sub(r"\1 in ZZ", _EQUALS.sub("==", text)).replace("~", _TILDE))
    try:
        body = tree(source)
    except InputError:
        if "~" not in text:
            raise
        shown = _quoted(text.strip())
        raise InputError(f"{shown} is not a condition such as y ~ x or a > 0") from None
    reader = _Reader(source, sequences_of(text))
    result: list[Compared] = []
    for part in body.elts if isinstance(body, ast.Tuple) else [body]:
        if not isinstance(part, ast.Compare):
            advice = "" if not isinstance(part, ast.BoolOp) else "; separate conditions by commas"
            shown = _quoted(reader._segment(part))
            raise InputError(f"{shown} is not a condition such as a > 0{advice}")
        if isinstance(part.ops[0], ast.IsNot) and len(part.ops) == 1 and "~" in text:
            left, right = reader._end(part.left), reader._end(part.comparators[0])
            terms = right.args if right.op == "+" else (right,)
            result += [(left, "==", right + order("o", term)) for term in terms]
            continue
        result += _chain(reader, part)
    result = [part for part in result if not _is_below_infinity(*part)]
    result = [_slopes_at(*part) if _has_slopes(*part) else part for part in result]
    for left, relation, right in result:
        if (relation == "in" or right == INTEGERS) and (
            relation != "in" or right != INTEGERS or left.op != "symbol"
        ):
            raise InputError("write n integer for a variable n with integer values")
        if {INFINITY.args[0], DOTS.args[0]} & (symbols(left) | symbols(right)):
            raise InputError(NO_INFINITY)
        explicit = right if relation != "==" else without_order(right)
        if not all(map(_algebraic, (left, explicit))):
            raise InputError(NO_DERIVATIVE)
    return result


def _is_below_infinity(left: Expr, relation: str, right: Expr) -> bool:
    """Return whether a condition is like ``x < oo`` or ``-oo < x``, which every number fulfils."""
    low, high = (left, right) if relation in ("<", "<=") else (right, left)
    if relation not in ("<", "<=", ">", ">="):
        return False
    mark = INFINITY.args[0]
    below = high == INFINITY and mark not in symbols(low)
    return below or (low == -INFINITY and mark not in symbols(high))


def without_order(e: Expr) -> Expr:
    """Return the right side of an equation without its one term O(…) or o(…), if it has one."""
    terms = e.args if e.op == "+" else (e,)
    rest = [term for term in terms if term.op not in ("O", "o")]
    return e if len(rest) + 1 != len(terms) else add(*rest) if rest else number(0)


def _has_slopes(left: Expr, relation: str, right: Expr) -> bool:
    """Return whether a condition is an equation, or compares derivatives of arbitrary functions."""
    found = [node for node in outermost(left, right) if node.op == "derivative"]
    return relation == "==" or (bool(found) and all(map(_is_slope, found)))


def _is_slope(e: Expr) -> bool:
    """Return whether a derivative is one of an arbitrary function of plain variables."""
    while e.op == "derivative":
        e = e.args[0]
    return e.op == "unknown" and all(arg.op in ("bound", "symbol") for arg in e.args[1:])


def _slopes_at(left: Expr, relation: str, right: Expr) -> Compared:
    """Return an equation with the derivatives of arbitrary functions as nodes of their own."""
    if elementary(left, right) or without_order(right) is not right:
        return left, relation, right
    return worked_out(left), relation, worked_out(right)


def _algebraic(e: Expr) -> bool:
    """Return whether ``e`` contains no unevaluated node except arbitrary functions."""
    return all(node.op == "unknown" and all(map(_algebraic, node.args)) for node in outermost(e))


def condition(left: Expr, relation: str, right: Expr) -> Compared:
    """Return the comparison if it can be a condition.

    Raises:
        InputError: it is an equation or contains an order, a derivative, an integral or a limit.
    """
    if relation not in _RELATIONS.values() or relation == "==":
        raise InputError("a condition uses one of > >= < <= !=, as in 0 < x <= 1")
    if not elementary(left, right):
        raise InputError(NO_DERIVATIVE)
    return left, relation, right


def _chain(reader: _Reader, node: ast.Compare) -> list[Compared]:
    """Return the links of ``a < b <= c``; each end may be infinite, for limits and integrals."""
    result = []
    left = reader._end(node.left)
    for op, other in zip(node.ops, node.comparators, strict=True):
        if type(op) not in _RELATIONS or (isinstance(op, ast.In) and not _is_integers(other)):
            raise InputError("a relation is one of == != > >= < <=, as in 0 < x <= 1")
        right = reader._end(other)
        result.append((left, _RELATIONS[type(op)], right))
        left = right
    return result


def _is_integers(node: ast.expr) -> bool:
    return isinstance(node, ast.Name) and node.id == INTEGERS.args[0]


_TILDE = " is not "
"""What stands for ``~`` in a syntax tree."""
NO_INFINITY = (
    "oo is not a real number: leave out < oo, which holds for every real number, and write a limit "
    "as f -> oo with a path"
)
NO_DERIVATIVE = (
    "a condition cannot contain a derivative: write it out, with its domain as a condition"
)


def _printed(source: str) -> list[Compared]:
    """Return ``x ~= 0.1150`` as ``0.11495 <= x <= 0.11505``: equality with a printed number.

    A printed number stands for every number within half a unit in its last place, its ends
    included.
    """
    match = re.fullmatch(r"(.+?)~=\s*([-+]?[\d.]+(?:[eE][-+]?\d+)?)\s*", source)
    if match is None or "~" in match[1]:
        raise InputError(
            "write ~= between an expression and a printed decimal, as in log(2) ~= 0.6931"
        )
    where, left = printed(match[2]), as_written(match[1])
    return [(number(where.low), "<=", left), (left, "<=", number(where.high))]


def parse_claim(text: str, sequences: frozenset[str] = frozenset()) -> list[Compared]:
    """Parse a chain of comparisons, or one asymptotic statement.

    The relations are ``== != > >= < <=``, with ``=`` for ``==``, ``f ~ g``, and ``f -> L`` for a
    limit. In ``f == h + O(g)`` the right side contains a node for the order. ``x ~= 0.1150``
    compares with a printed number, to half a unit in its last place.

    Args:
        text: the claim without its conditions.
        sequences: names that denote sequences, for which the conditions state a recurrence.

    Raises:
        InputError: the text is anything else; the message says in one line what is expected.

    Example:
        >>> [(str(x), sign, str(y)) for x, sign, y in parse_claim("sin(x)^2 + cos(x)^2 = 1")]
        [('sin(x)**2 + cos(x)**2', '==', '1')]
    """
    source = tidy(text)
    if "~=" in source:
        return _printed(source)
    if source.count("~") == 1:
        left, right = (as_written(side, sequences) for side in source.split("~"))
        return [(left, "~", right)]
    if source.count("->") == 1 and not re.search("[<=>]", source.replace("->", "")):
        start, end = source.split("->")
        value = INFINITE.get(end.replace(" ", "")) or as_written(end, sequences)
        return [(as_written(start, sequences), "->", value)]
    source = _EQUALS.sub("==", source)
    body = tree(source)
    if not isinstance(body, ast.Compare):
        apart = isinstance(body, ast.Tuple | ast.BoolOp)
        advice = " (one claim at a time; decimals have a point)" if apart else ""
        raise InputError(
            f"{_quoted(source)} is not a claim{advice}; compare two expressions with one of "
            "== != > >= < <= ~, as in sin(x)**2 + cos(x)**2 == 1"
        )
    return _chain(_Reader(source, sequences), body)
