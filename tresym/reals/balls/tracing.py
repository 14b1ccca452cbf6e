"""Trace a formula: record its steps in balls as an expression.

A formula is a plain function whose last argument is an arithmetic. It is called once, with
stand-ins for numbers that record every operation. The recorded steps are then replayed in balls and
in gradients, which gives the bounds, and in trees, which gives the meaning of the formula. So the
bounds and the displayed formula cannot disagree.

There are two special kinds of steps. A :class:`Named` function has a program of its own in balls
and a stated meaning; this pair is trusted. A :class:`Part` is a named formula. It is traced like
any other, but may be displayed in a shorter form once that form is proved.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any

from flint import arb, fmpq

from tresym.reals.functions.table import names
from tresym.reals.language.expression import Expr, number, trees

RECORDED = names(lambda row: row.slope is not None or row.quotient) | {"sqrt", "expm1", "log1p"}
"""The functions that formulas may apply; all are analytic in the interior of their domain."""
OPERATORS = {
    *(operator.add, operator.sub, operator.mul, operator.truediv, operator.pow, operator.neg)
}
Meaning = Callable[..., Expr]


class Traced:
    """A stand-in for a number that records an operation and its operands."""

    __slots__ = ("args", "op")

    def __init__(self, op: Any, args: tuple[Any, ...]) -> None:
        """Create a record; formulas do so only by computing with other records."""
        self.op, self.args = op, args

    def __getattr__(self, name: str) -> Callable[[], Traced]:
        """Return a function of this number, to be called as a method."""
        if name not in RECORDED:
            raise AttributeError(name)
        return lambda: Traced(name, (self,))

    def __add__(self, other: Any) -> Traced:
        return Traced(operator.add, (self, other))

    def __radd__(self, other: Any) -> Traced:
        return Traced(operator.add, (other, self))

    def __sub__(self, other: Any) -> Traced:
        return Traced(operator.sub, (self, other))

    def __rsub__(self, other: Any) -> Traced:
        return Traced(operator.sub, (other, self))

    def __mul__(self, other: Any) -> Traced:
        return Traced(operator.mul, (self, other))

    def __rmul__(self, other: Any) -> Traced:
        return Traced(operator.mul, (other, self))

    def __truediv__(self, other: Any) -> Traced:
        return Traced(operator.truediv, (self, other))

    def __rtruediv__(self, other: Any) -> Traced:
        return Traced(operator.truediv, (other, self))

    def __pow__(self, power: int) -> Traced:
        return Traced(operator.pow, (self, power))

    def __neg__(self) -> Traced:
        return Traced(operator.neg, (self,))

    def __bool__(self) -> bool:
        raise TypeError("a traced formula cannot branch on the values of its numbers")


class Tracing:
    """The arithmetic in which formulas are traced."""

    @property
    def pi(self) -> Traced:
        """Return the record of π."""
        return Traced("pi", ())

    def __getattr__(self, name: str) -> Callable[[Any], Traced]:
        """Return a function of one number."""
        if name not in RECORDED:
            raise AttributeError(name)
        return lambda x: Traced(name, (x,))


tracing = Tracing()


@dataclass(frozen=True, eq=False)
class Named:
    """A function with a trusted program of its own in balls.

    Attributes:
        program: maps balls or gradients to an enclosure of the value at every point of them.
        meaning: maps trees to the tree of the value; None for a root.
        image: for a root x, the expression it equals, as a function of x and the arguments. The
            ball contains every solution ``between`` the ends.
        between: for a root, the closed interval that contains it.
        asks: maps trees to expressions that must not be negative.
    """

    program: Callable[..., Any]
    meaning: Callable[..., Expr] | None = None
    image: Callable[..., Expr] | None = None
    between: tuple[Expr, Expr] | None = None
    asks: Callable[..., tuple[Expr, ...]] = lambda *_: ()

    def __call__(self, *args: Any) -> Any:
        """Return the value, or a record of this step."""
        if any(isinstance(x, Traced) for x in args):
            return Traced(self, args)
        return self.program(*args)


class Part:
    """A named formula; it is traced like any other, and known by its name and arguments."""

    def __init__(self, formula: Callable[..., Any]) -> None:
        """Name a formula, which is a function of numbers and the arithmetic."""
        self.formula = formula
        self.__doc__ = formula.__doc__
        self.__name__ = formula.__name__

    def __call__(self, *args: Any) -> Any:
        """Return the value, or a record of this step."""
        *numbers, m = args
        value = self.formula(*numbers, m)
        return Traced(self, (value, *numbers)) if m is tracing else value


@dataclass(frozen=True)
class Program:
    """A traced formula: steps from ``count`` numbers to one number, for any arithmetic.

    Each step has an operation and operands. An operand is an exact number or the index of an
    earlier value; the first ``count`` indices are the arguments.
    """

    count: int
    steps: tuple[tuple[Any, tuple[tuple[bool, Any], ...]], ...]
    end: int

    def __call__(self, *point: Any) -> Any:
        """Return the value at balls or gradients; the last argument is their arithmetic."""
        *values, m = point
        if m not in self._prepared:
            self._prepared[m] = [(_step(op, m), operands) for op, operands in self.steps]
        for step, operands in self._prepared[m]:
            values.append(step(*[values[x] if inner else x for inner, x in operands]))
        return values[self.end]

    @cached_property
    def _prepared(self) -> dict[Any, list[tuple[Callable[..., Any], tuple[tuple[bool, Any], ...]]]]:
        """The steps as functions of balls or gradients: looked up once, not at every point."""
        return {}

    def meaning(self, numbers: Sequence[Expr], special: Meaning) -> Expr:
        """Return the value as a tree.

        Args:
            numbers: the arguments as trees.
            special: returns the tree of a named step. Its arguments are the step, its arguments,
                and for a part a function that returns the tree of its formula.
        """
        known = dict(enumerate(numbers))

        def at(operand: tuple[bool, Any]) -> Any:
            inner, x = operand
            if not inner:
                return number(x)
            if x not in known:
                op, operands = self.steps[x - self.count]
                if isinstance(op, Part):
                    args = tuple(map(at, operands[1:]))
                    known[x] = special(op, args, lambda: at(operands[0]))
                else:
                    known[x] = _done(op, tuple(map(at, operands)), trees, special)
            return known[x]

        tree: Expr = at((True, self.end))
        return tree

    def run(self, numbers: Sequence[Any], m: Any, special: Callable[..., Any]) -> Any:
        """Return the value in an arithmetic, with ``special`` for the named steps."""
        values = list(numbers)
        for op, operands in self.steps:
            args = tuple([values[x] if inner else x for inner, x in operands])
            values.append(_done(op, args, m, special))
        return values[self.end]


def _done(op: Any, args: tuple[Any, ...], m: Any, special: Callable[..., Any]) -> Any:
    if isinstance(op, str):
        return m.pi if op == "pi" else _function(m, op)(*(_number(x, m) for x in args))
    return op(*args) if op in OPERATORS else special(op, args)


def _number(x: Any, m: Any) -> Any:
    """Convert an exact number to the arithmetic."""
    if not isinstance(x, int | fmpq):
        return x
    return number(x) if m is trees else arb(x)


def _step(op: Any, m: Any) -> Callable[..., Any]:
    """Return the function of balls or gradients that carries out a step."""
    if op == "pi":
        return lambda: m.pi  # at the working precision
    if isinstance(op, str):
        function = _function(m, op)
        return lambda x: function(_number(x, m))
    return _first if isinstance(op, Part) else op


def _first(value: Any, *_: Any) -> Any:
    return value


def _function(m: Any, name: str) -> Callable[[Any], Any]:
    if m is trees and name == "expm1":
        return lambda x: trees.exp(x) - 1
    if m is trees and name == "log1p":
        return lambda x: trees.log(1 + x)
    function: Callable[[Any], Any] = getattr(m, name)
    return function


@lru_cache(maxsize=4096)
def traced(formula: Callable[..., Any], count: int) -> Program:
    """Return the program of a formula of ``count`` numbers and the arithmetic.

    Raises:
        TypeError: the formula branches on the values of numbers, or uses inexact numbers.
    """
    return program(formula(*_places(count), tracing), count)


def _places(count: int) -> list[Traced]:
    return [Traced(None, (n,)) for n in range(count)]


def program(end: Any, count: int) -> Program:
    """Return the program that ends at a traced number; equal steps are executed once.

    Raises:
        TypeError: the formula contains an inexact number, or ``end`` was not traced.
    """
    steps: dict[tuple[Any, tuple[tuple[bool, Any], ...]], int] = {}
    known: dict[int, int] = {}

    def place(x: Traced) -> int:
        found = known.get(id(x))
        if found is None:
            found = known[id(x)] = x.args[0] if x.op is None else record(x)
        return found

    def record(x: Traced) -> int:
        step = (x.op, tuple(map(operand, x.args)))
        return steps.setdefault(step, count + len(steps))

    def operand(x: Any) -> tuple[bool, Any]:
        if isinstance(x, Traced):
            return True, place(x)
        if not isinstance(x, int | fmpq):
            raise TypeError(f"{type(x).__name__} in a traced formula: write an exact number")
        return False, x

    if not isinstance(end, Traced):
        raise TypeError("the formula does not depend on its coordinates")
    last = place(end)
    return Program(count, tuple(steps), last)
