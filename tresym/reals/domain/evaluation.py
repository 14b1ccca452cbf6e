"""Evaluate an expression in any arithmetic; NaN where it is not proved to be defined.

The cross-check and the ball evaluation of the ledger have evaluators of their own on purpose, so
that an error here cannot mislead both.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial, reduce
from typing import Any

from flint import arb, ctx, fmpq

from tresym.reals.functions.elementary import root_of_ball
from tresym.reals.functions.table import TABLE
from tresym.reals.language.expression import UNWORKED, ZERO, Expr, symbol
from tresym.reals.numbers.arithmetic import balls

_NAN = arb.nan()


class Walker:
    """Evaluate a tree in an arithmetic ``m``, with values ``at`` for the variables.

    Sums and products use the operators of the values; subclasses may evaluate other operations in
    their own way.
    """

    _number: Any = arb

    def __init__(self, m: Any, at: Mapping[str, Any], known: dict[Expr, Any] | None = None) -> None:
        """Prepare an evaluation.

        Args:
            m: the arithmetic, a namespace of functions.
            at: the value of each variable.
            known: values of subexpressions; they are used, and new ones are added.
        """
        self.m, self.at = m, at
        self.known = {} if known is None else known

    def value(self, e: Expr) -> Any:
        """Return the value of ``e``."""
        found = self.known.get(e)
        if found is None:
            found = self.known[e] = self._computed(e)
        return found

    def _computed(self, e: Expr) -> Any:
        op, args = e.op, e.args
        if op == "number":
            return self._number(args[0])
        if op == "symbol":
            return self._number(self.at[args[0]])
        if op == "pi":
            return self.m.pi
        if op == "^":
            return self._power(*args)
        values = [self.value(arg) for arg in args]
        if op in ("+", "*"):
            return reduce(operator.add if op == "+" else operator.mul, values)
        return self._apply(op, *values)

    def _power(self, base: Expr, exponent: Expr) -> Any:
        return self.value(base) ** self.value(exponent)

    def _apply(self, name: str, *values: Any) -> Any:
        return getattr(self.m, name)(*values)


class UndefinedError(Exception):
    """Raised if a point lies outside the real domain, or the ball is too wide to decide."""


def evaluate(e: Expr, point: Mapping[str, arb | fmpq], known: dict[Expr, arb] | None = None) -> arb:
    """Return a ball that contains ``e`` at ``point``, at working precision.

    The result is NaN if ``e`` is undefined over the reals (radicand < 0, argument of ``log`` ≤ 0,
    argument of ``asin`` out of range, division by a ball that contains 0), or if balls cannot
    decide this.

    Args:
        e: the expression.
        point: a ball or an exact number for each variable.
        known: values of subexpressions at the point; they are used, and new ones are added.

    Raises:
        KeyError: a variable of ``e`` is not in ``point``.

    Example:
        >>> from tresym.reals.language.expression import number, sqrt
        >>> evaluate(sqrt(number(-1)), {}).is_nan()
        True
    """
    try:
        return InBalls(balls, point, known).value(e)
    except UndefinedError:
        return _NAN


def stands(difference: arb, relation: str) -> bool:
    """Return whether a ball proves its ``relation`` to zero."""
    return bool(_STANDS[relation](difference, 0))


_STANDS: dict[str, Callable[[arb, int], object]] = {
    ">": operator.gt,
    ">=": operator.ge,
    "<": operator.lt,
    "<=": operator.le,
    "!=": lambda x, _: x.is_finite() and not x.contains(0),
    "==": lambda x, _: x.is_zero(),
}


def values_or_broken(
    expressions: Iterable[Expr], point: Mapping[str, arb | fmpq]
) -> list[arb] | Expr:
    """Return the values of ``expressions``, or a subexpression without a value.

    A part without a value at one point is likely to have none at the next, so callers test it first
    there.
    """
    walker = InBalls(balls, point)
    try:
        return [walker.value(e) for e in expressions]
    except UndefinedError:
        return walker.broken


def undefined_parts(expressions: Iterable[Expr], point: Mapping[str, arb | fmpq]) -> set[Expr]:
    """Return the innermost subexpressions without a proven real value at ``point``."""
    walker = InBalls(balls, point)
    done: dict[Expr, bool] = {}
    found: set[Expr] = set()

    def has_value(node: Expr) -> bool:
        if node not in done:
            inner = [has_value(arg) for arg in node.args if isinstance(arg, Expr)]
            done[node] = all(inner)
            if done[node]:
                try:
                    walker.value(node)
                except UndefinedError:
                    found.add(node)
                    done[node] = False
        return done[node]

    for e in expressions:
        has_value(e)
    return found


def _natural_power(x: arb, n: int) -> arb:
    """Return ``x**n`` for a ball that contains 0; FLINT returns NaN if the midpoint is 0."""
    if n == 0:
        return arb(1)
    if n % 2:
        return (x.lower() ** n).union(x.upper() ** n)
    return arb(0).union(x.abs_upper() ** n)


class InBalls(Walker):
    """Evaluate in balls and require every value to be finite."""

    broken: Expr = ZERO
    """The innermost subexpression that was found to have no value."""

    def value(self, e: Expr) -> arb:
        """Return the value of ``e``.

        Raises:
            UndefinedError: the value is not proved to exist; ``broken`` is then the part without
                one.
        """
        found = self.known.get(e)
        if found is None:
            try:
                found = self._computed(e)
            except UndefinedError:
                self.broken = e if self.broken is ZERO else self.broken
                raise
            if not found.is_finite():
                self.broken = e
                raise UndefinedError
            self.known[e] = found
        return found

    def _computed(self, e: Expr) -> arb:
        if e.op in UNWORKED or e.loose:  # it has bound variables
            raise UndefinedError
        found: arb = super()._computed(e)
        return found

    def _apply(self, name: str, *values: arb) -> arb:
        return applied(name, *values)

    def _power(self, base: Expr, exponent: Expr) -> arb:
        x = self.value(base)
        if exponent.op != "number":
            return real_power(x, self.value(exponent))
        return rational_power(x, exponent.args[0])


def applied(name: str, *values: arb) -> arb:
    """Return a function of balls; not finite, or undefined, where it has no value."""
    return TABLE[name].ball(*values)


def real_power(x: arb, y: arb) -> arb:
    """Return ``x**y`` for an exponent that is not a written number."""
    return (y * x.log()).exp()


def rational_power(x: arb, r: fmpq) -> arb:
    """Return ``x**r``.

    Raises:
        UndefinedError: the ball does not prove that the power exists.
    """
    p, q = int(r.p), int(r.q)
    if p < 0 and x.contains(0):
        raise UndefinedError
    if q == 1:
        return _natural_power(x, p) if x.contains(0) else x**p
    if not x >= 0:
        raise UndefinedError
    root = x.sqrt() if q == 2 else root_of_ball(x, q)
    return root if p == 1 else root**p


class Tape:
    """A tree compiled for evaluation at many points, with the values of :func:`evaluate`."""

    def __init__(self, e: Expr, names: Sequence[str]) -> None:
        """Compile ``e``.

        Args:
            e: the expression.
            names: its variables, in the order of the coordinates of a point.
        """
        self._places = {symbol(name): n for n, name in enumerate(names)}
        self._numbers: list[tuple[int, Expr]] = []
        self._steps: list[tuple[Callable[..., arb], int, int | None, int]] = []
        self._slots: list[Any] = [None] * len(names)
        self._bits = 0
        self._end = self._place(e)

    def __call__(self, point: Sequence[arb]) -> arb:
        """Return the value at a point; NaN where it is not proved to be defined."""
        if self._bits != ctx.prec:
            self._bits = ctx.prec
            for k, leaf in self._numbers:
                self._slots[k] = arb(leaf.args[0]) if leaf.args else arb.pi()
        values = [*point, *self._slots[len(point) :]]
        try:
            for function, i, j, k in self._steps:
                if j is not None:
                    values[k] = function(values[i], values[j])
                else:
                    values[k] = value = function(values[i])
                    if not value.is_finite():
                        return _NAN
        except UndefinedError:
            return _NAN
        found: arb = values[self._end]
        return found if found.is_finite() else _NAN

    def _place(self, e: Expr) -> int:
        """Return the slot of the value of ``e``."""
        if e in self._places:
            return self._places[e]
        if e.op in ("number", "pi"):
            k = self._slot()
            self._numbers.append((k, e))
        elif e.op == "^" and e.args[1].op == "number":
            r = e.args[1].args[0]
            k = self._step(lambda x: rational_power(x, r), self._place(e.args[0]))
        elif len(e.args) == 1:
            k = self._step(TABLE[e.op].ball, self._place(e.args[0]))
        elif e.op in TABLE:
            k = self._step(partial(_of_two, TABLE[e.op].ball), *map(self._place, e.args))
        else:
            function = self._power if e.op == "^" else _OF_TWO[e.op]
            k = self._place(e.args[0])
            for arg in e.args[1:]:
                k = self._step(function, k, self._place(arg))
        self._places[e] = k
        return k

    @staticmethod
    def _power(x: arb, y: arb) -> arb:
        """Return ``x**y`` for an exponent that is not a written number."""
        found = real_power(x, y)
        if not found.is_finite():
            raise UndefinedError
        return found

    def _step(self, function: Callable[..., arb], i: int, j: int | None = None) -> int:
        k = self._slot()
        self._steps.append((function, i, j, k))
        return k

    def _slot(self) -> int:
        self._slots.append(None)
        return len(self._slots) - 1


def _of_two(ball: Callable[[arb, arb], arb], x: arb, y: arb) -> arb:
    found = ball(x, y)
    if not found.is_finite():
        raise UndefinedError
    return found


_OF_TWO: dict[str, Callable[..., arb]] = {"+": operator.add, "*": operator.mul}
