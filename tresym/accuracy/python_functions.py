"""Read a Python function as the formula that it computes, with the rounding of its operations.

A function such as ::

    def my_sin(x):
        z = x * x
        r = -0.00018363
        for c in (0.00830629, -0.16664824, 0.9999966):
            r = r * z + c
        return r * x

is read from its source, not run: assignments, arithmetic, loops over known numbers and the
functions of ``math``. Its constants are the numbers that a program stores. Where all operations are
+ − · / √ and | |, which IEEE 754 rounds to the nearest number, a running error analysis bounds what
rounding adds on a whole interval (N. J. Higham, *Accuracy and Stability of Numerical Algorithms*,
chapter 3).
How ``exp`` or a power is rounded no standard says: then the function is computed in floating point
at many points, and the largest difference seen is no bound.
"""

from __future__ import annotations

import ast
import inspect
import math
import textwrap
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, NamedTuple, TypeAlias

from flint import arb, fmpq

from tresym.accuracy.stored_numbers import nearest, readable
from tresym.asymptotics.constants import rounded
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.expression import (
    Expr,
    add,
    apply,
    multiply,
    number,
    power,
    sqrt,
    symbol,
)
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError, quoted

PIECES = 256
"""Parts of an interval on which rounding is bounded."""
SAMPLES = 2001
LONGEST = 1_000
"""Steps of all loops together."""
BITS = {"double": 53, "single": 24}
LEAST = {"double": -1074, "single": -149}
_OPERATORS = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/", ast.Pow: "**"}
_ROUNDED = frozenset(("+", "-", "*", "/", "neg", "sqrt", "abs", "x", "number"))
"""Operations whose rounding IEEE 754 prescribes."""
_KNOWN = {"fabs": "abs", "abs": "abs", "ln": "log", "arcsin": "asin", "arccos": "acos"} | {
    "arctan": "atan"
}
_CALLS = ("sqrt", "exp", "log", "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh")
_CONSTANTS = {
    f"{module}.{name}": value
    for module in ("math", "np", "numpy")
    for name, value in (("pi", math.pi), ("e", math.e))
}


@dataclass(frozen=True, eq=False)
class Operation:
    """A step of a computation: ``x``, ``number``, an operator or the name of a function.

    A step that is used twice is one object.
    """

    op: str
    args: tuple[Operation, ...] = ()
    value: Fraction = Fraction(0)


Value: TypeAlias = Operation | list[Any]


class Program(NamedTuple):
    """A function of one variable as the operations that it performs.

    Attributes:
        name: of the function.
        result: the last operation.
    """

    name: str
    result: Operation

    def expression(self, x: str) -> Expr:
        """Return the formula, computed exactly with the constants that are stored."""
        return _expression(self.result, symbol(x), {})

    @property
    def is_rounded(self) -> bool:
        """Whether IEEE 754 prescribes how every operation is rounded."""
        return all(step.op in _ROUNDED for step in _steps(self.result))


def read_function(source: str | Callable[..., Any], stored: str = "double") -> Program:
    """Return a Python function as the operations that it performs.

    Args:
        source: ``FILE.py:FUNCTION``, or a function that was defined in a file.
        stored: ``"double"`` or ``"single"``, the precision of its constants.

    Raises:
        InputError: there is no such function, or it is not straight arithmetic in one variable.
    """
    known: dict[str, Value] = {}
    if callable(source):
        name = getattr(source, "__name__", "")
        try:
            text = textwrap.dedent(inspect.getsource(source))
        except (OSError, TypeError):
            raise InputError(f"{name or source!r} has no source to read") from None
        around = getattr(source, "__globals__", {})
        for key, value in around.items():
            found = _of_value(value, stored)
            if found is not None:
                known[key] = found
    else:
        file, _, name = source.rpartition(":")
        try:
            with open(file, encoding="utf-8") as opened:
                text = opened.read()
        except (OSError, UnicodeDecodeError) as error:
            raise InputError(f"{file}: {error}") from None
    try:
        body = ast.parse(text).body
    except (SyntaxError, ValueError) as error:
        raise InputError(f"{name}: {error}") from None
    reader = _Reader(stored, known)
    for node in body:
        if isinstance(node, ast.FunctionDef) and node.name == name:
            return Program(name, reader.function(node))
        if isinstance(node, ast.Assign | ast.AnnAssign):
            reader.constant(node)
    raise InputError(f"{quoted(name)} is no function of the file")


def _of_value(value: Any, stored: str) -> Value | None:
    """Return a number or a list of numbers of a module."""
    if isinstance(value, tuple | list):
        parts = [_of_value(part, stored) for part in value]
        return None if None in parts else parts
    if type(value) not in (int, float) or not math.isfinite(value):
        return None
    return Operation("number", value=_stored(value, stored))


def _stored(value: float, stored: str) -> Fraction:
    """Return a constant as a program stores it."""
    if type(value) is int and abs(value) < 2 ** BITS[stored]:
        return Fraction(value)
    if not math.isfinite(value):
        raise InputError(f"{value} is not a number")
    if stored == "double":
        return Fraction(float(value))
    return nearest(Fraction(repr(value)), BITS[stored], LEAST[stored])


class _Reader:
    """Reads statements of a function, with what its names stand for."""

    def __init__(self, stored: str, known: dict[str, Value]) -> None:
        self.stored = stored
        self.known = known
        self.steps = 0

    def constant(self, node: ast.Assign | ast.AnnAssign) -> None:
        """Read an assignment of a module, if it is one of numbers."""
        try:
            self.assign(node)
        except InputError:  # what else a module computes does not matter
            return

    def function(self, node: ast.FunctionDef) -> Operation:
        """Return what a function returns."""
        given = node.args
        plain = len(given.args) + len(given.posonlyargs) == 1
        if not plain or given.vararg or given.kwarg or given.kwonlyargs:
            raise InputError(f"{node.name} is not a function of one variable")
        (x,) = (*given.posonlyargs, *given.args)
        self.known[x.arg] = Operation("x")
        found = self.block(node.body)
        if not isinstance(found, Operation):
            raise InputError(f"{node.name} does not return a number")
        return found

    def block(self, body: list[ast.stmt]) -> Value | None:
        """Run statements; return what is returned, or None."""
        for node in body:
            if isinstance(node, ast.Return) and node.value is not None:
                return self.value(node.value)
            if isinstance(node, ast.Assign | ast.AnnAssign):
                self.assign(node)
            elif isinstance(node, ast.AugAssign) and isinstance(node.target, ast.Name):
                both = (self.value(node.target), self.value(node.value))
                self.known[node.target.id] = self.operation(node, node.op, *both)
            elif isinstance(node, ast.For) and isinstance(node.target, ast.Name):
                if node.orelse:
                    raise _unread(node)
                for item in self.sequence(node.iter):
                    self.steps += 1
                    if self.steps > LONGEST:
                        raise InputError(f"line {node.lineno}: more than {LONGEST} steps of loops")
                    self.known[node.target.id] = item
                    found = self.block(node.body)
                    if found is not None:
                        return found
            elif not (isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)):
                raise _unread(node)
        return None

    def assign(self, node: ast.Assign | ast.AnnAssign) -> None:
        """Read an assignment to names."""
        targets = node.targets if isinstance(node, ast.Assign) else [node.target]
        if node.value is None or not all(isinstance(target, ast.Name) for target in targets):
            raise _unread(node)
        value = self.value(node.value)
        for target in targets:
            assert isinstance(target, ast.Name)
            self.known[target.id] = value

    def sequence(self, node: ast.expr) -> list[Value]:
        """Return the values over which a loop runs."""
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and not node.keywords:
            if node.func.id == "reversed" and len(node.args) == 1:
                return self.sequence(node.args[0])[::-1]
            if node.func.id == "range":
                ends = range(*(self.whole(arg) for arg in node.args))
                return [Operation("number", value=Fraction(n)) for n in ends[: LONGEST + 1]]
        found = self.value(node)
        if not isinstance(found, list):
            raise _unread(node)
        return found

    def whole(self, node: ast.expr) -> int:
        """Return a number that must be an integer."""
        found = self.value(node)
        if isinstance(found, list) or found.op != "number" or found.value.denominator != 1:
            raise _unread(node)
        return int(found.value)

    def value(self, node: ast.expr) -> Value:
        """Return an expression as operations."""
        if isinstance(node, ast.Constant) and type(node.value) in (int, float):
            assert isinstance(node.value, int | float)
            return Operation("number", value=_stored(node.value, self.stored))
        if isinstance(node, ast.Name) and node.id in self.known:
            return self.known[node.id]
        if isinstance(node, ast.Tuple | ast.List):
            return [self.value(part) for part in node.elts]
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub | ast.UAdd):
            inner = self.number(node.operand)
            if isinstance(node.op, ast.UAdd):
                return inner
            if inner.op == "number":
                return Operation("number", value=-inner.value)
            return Operation("neg", (inner,))
        if isinstance(node, ast.BinOp):
            return self.operation(node, node.op, self.value(node.left), self.value(node.right))
        if isinstance(node, ast.Subscript):
            return self.part(node)
        if isinstance(node, ast.Attribute) and ast.unparse(node) in _CONSTANTS:
            value = _stored(_CONSTANTS[ast.unparse(node)], self.stored)
            return Operation("number", value=value)
        if isinstance(node, ast.Call) and not node.keywords and len(node.args) == 1:
            name = node.func.attr if isinstance(node.func, ast.Attribute) else None
            name = node.func.id if isinstance(node.func, ast.Name) else name
            name = _KNOWN.get(name or "", name)
            if name in _CALLS or name == "abs":
                return Operation(str(name), (self.number(node.args[0]),))
            if name == "float":
                return self.number(node.args[0])
        raise _unread(node)

    def part(self, node: ast.Subscript) -> Value:
        """Return an element of a list, or a slice such as ``c[::-1]``."""
        found = self.value(node.value)
        if not isinstance(found, list):
            raise _unread(node)
        if isinstance(node.slice, ast.Slice):
            ends = (node.slice.lower, node.slice.upper, node.slice.step)
            return found[slice(*(None if end is None else self.whole(end) for end in ends))]
        try:
            element: Value = found[self.whole(node.slice)]
        except IndexError:
            raise _unread(node) from None
        return element

    def number(self, node: ast.expr) -> Operation:
        """Return an expression that must not be a list."""
        found = self.value(node)
        if isinstance(found, list):
            raise _unread(node)
        return found

    def operation(self, node: Any, op: ast.operator, left: Value, right: Value) -> Operation:
        """Return an arithmetic operation."""
        sign = _OPERATORS.get(type(op))
        if sign is None or isinstance(left, list) or isinstance(right, list):
            raise _unread(node)
        if sign == "**" and (right.op != "number" or (right.value * 2).denominator != 1):
            raise _unread(node)
        whole = left.op == right.op == "number" and left.value.denominator == 1
        if whole and right.value.denominator == 1 and sign in "+-*":  # integers are exact
            a, b = left.value, right.value
            return Operation(
                "number", value=a + b if sign == "+" else a - b if sign == "-" else a * b
            )
        return Operation(sign, (left, right))


def _unread(node: Any) -> InputError:
    shown = quoted(ast.unparse(node).splitlines()[0])
    return InputError(
        f"line {node.lineno}: {shown} is not read: a function is given by assignments, + - * / **, "
        "functions of math and loops over known numbers"
    )


def _steps(last: Operation) -> dict[Operation, None]:
    """Return all operations, those that are needed first."""
    found: dict[Operation, None] = {}

    def visit(step: Operation) -> None:
        if step not in found:
            for arg in step.args:
                visit(arg)
            found[step] = None

    visit(last)
    return found


def _expression(step: Operation, x: Expr, known: dict[Operation, Expr]) -> Expr:
    for one in _steps(step):
        args = [known[arg] for arg in one.args]
        match one.op:
            case "x":
                value = x
            case "number":
                value = number(one.value)
            case "+":
                value = add(*args)
            case "-":
                value = args[0] - args[1]
            case "*":
                value = multiply(*args)
            case "/":
                value = args[0] / args[1]
            case "**":
                value = power(*args)
            case "neg":
                value = -args[0]
            case "sqrt":
                value = sqrt(args[0])
            case name:
                value = apply(name, *args)
        known[one] = value
    return known[step]


class Rounding(NamedTuple):
    """What rounding adds to the error of a formula on a region.

    Attributes:
        size: a decimal, rounded up.
        bounded: whether it is a bound; else it is the largest difference at some points.
        stored: the precision.
    """

    size: str
    bounded: bool
    stored: str

    def __str__(self) -> str:
        if self.bounded:
            return f"at most {self.size} in {self.stored} precision (bounded)"
        return (
            f"{self.size} seen at {SAMPLES} points in {self.stored} precision (sampled, no bound)"
        )


def rounding(program: Program, low: arb, high: arb, stored: str) -> Rounding | None:
    """Return what rounding adds on an interval; None if nothing can be said."""
    with ball_precision(200):
        found = _bound(program, low, high, stored) if program.is_rounded else None
        bounded = found is not None
        if found is None:
            found = _sampled(program, low, high, stored)
        if found is None:
            return None
        return Rounding(readable(rounded(found, 1)), bounded, stored)


def _bound(program: Program, low: arb, high: arb, stored: str) -> arb | None:
    """Return a bound of the rounding error by a running analysis on each piece of an interval."""
    worst = arb(0)
    for k in range(PIECES):
        ends = [low + (high - low) * j / PIECES for j in (k, k + 1)]
        error = _running(program.result, ends[0].union(ends[1]), stored)
        if not error.is_finite():
            return None
        worst = worst.max(error)
    return worst


def _running(last: Operation, x: arb, stored: str) -> arb:
    """Return a bound of the rounding error where the variable is in a ball."""
    unit, least = arb(2) ** -BITS[stored], arb(2) ** (LEAST[stored] - 1)
    largest = arb(2) ** (1024 if stored == "double" else 128)
    values: dict[Operation, tuple[arb, arb]] = {}
    for step in _steps(last):
        parts = [values[arg] for arg in step.args]
        (v, e), (w, d) = (*parts, (arb(0), arb(0)), (arb(0), arb(0)))[:2]
        match step.op:
            case "x":
                values[step] = (x, arb(0))
                continue
            case "number":
                values[step] = (arb(fmpq(*step.value.as_integer_ratio())), arb(0))
                continue
            case "neg" | "abs":
                values[step] = (-v if step.op == "neg" else abs(v), e)
                continue
            case "+":
                value, error = v + w, e + d
            case "-":
                value, error = v - w, e + d
            case "*":
                value, error = v * w, abs(v) * d + abs(w) * e + e * d
            case "/":
                value = v / w
                error = (e + abs(value) * d) / (arb(abs(w).lower()) - d)
                if not (arb(abs(w).lower()) - d > 0):
                    error = arb("inf")
            case _:  # a square root
                below = arb(v.lower()) - e
                value = v.sqrt()
                error = e / (2 * below.sqrt()) if below > 0 else (arb("inf") if e > 0 else arb(0))
        size = arb((abs(value) + error).upper())
        if not (size < largest):
            return arb("inf")
        small = least if step.op in "*/" else arb(0)
        values[step] = (value, arb((error + unit * size + small).upper()))
    return values[last][1]


def _sampled(program: Program, low: arb, high: arb, stored: str) -> arb | None:
    """Return the largest rounding error at points of an interval."""
    formula = program.expression("x")
    worst: arb | None = None
    for k in range(SAMPLES):
        place = low + (high - low) * k / (SAMPLES - 1)
        x = _rounded(float(place.mid()), stored)
        if not (low <= x <= high):
            continue
        try:
            value = _computed(program.result, x, stored)
        except (ArithmeticError, ValueError):
            continue
        exact = evaluate(formula, {"x": arb(x)})
        if exact.is_finite() and math.isfinite(value):
            error = arb(abs(exact - arb(value)).upper())
            worst = error if worst is None else worst.max(error)
    return worst


def _rounded(value: float, stored: str) -> float:
    """Return a number in the precision."""
    if stored == "double" or not math.isfinite(value):
        return value
    return float(nearest(Fraction(value), BITS[stored], LEAST[stored]))


def _computed(last: Operation, x: float, stored: str) -> float:
    """Return what a program computes."""
    values: dict[Operation, float] = {}
    for step in _steps(last):
        args = [values[arg] for arg in step.args]
        match step.op:
            case "x":
                value = x
            case "number":
                value = float(step.value)
            case "+":
                value = args[0] + args[1]
            case "-":
                value = args[0] - args[1]
            case "*":
                value = args[0] * args[1]
            case "/":
                value = args[0] / args[1]
            case "**":
                value = math.pow(args[0], args[1])
            case "neg":
                value = -args[0]
            case "abs":
                value = abs(args[0])
            case name:
                value = getattr(math, name)(args[0])
        values[step] = _rounded(value, stored)
    return values[last]
