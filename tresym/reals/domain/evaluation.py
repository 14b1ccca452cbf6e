"""Evaluate an expression in any arithmetic; NaN where it is not proved to be defined.

For example, at the ball 2 ± 0.1 the expression √(x − 1)/x has a value in the ball 0.50 ± 0.08, and
√(1 − x)/x has none. Each operation of a tree becomes one operation on balls, whose result contains
every value for points in the operands (the inclusion property of interval arithmetic; R. E. Moore,
R. B. Kearfott, M. J. Cloud, *Introduction to Interval Analysis*, SIAM 2009, chapter 5). A tree that
is evaluated at many points is compiled first, see :mod:`.compiled`.

The cross-check and the ball evaluation of the ledger have evaluators of their own on purpose, so
that an error here cannot mislead both.
"""

from __future__ import annotations

import operator
from collections import ChainMap
from collections.abc import Callable, Iterable, Mapping
from functools import reduce
from typing import Any

from flint import arb, fmpq

from tresym.reals.functions.elementary import root_of_ball
from tresym.reals.functions.table import TABLE
from tresym.reals.language.expression import MINUS_ONE, UNWORKED, ZERO, Expr, symbols
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
        value = self.known.get(e)
        if value is None:
            value = self.known[e] = self._computed(e)
        return value

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
        return InBalls(point, known=known).value(e)
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
    walker = InBalls(point)
    try:
        return [walker.value(e) for e in expressions]
    except UndefinedError:
        return walker.broken


def undefined_parts(expressions: Iterable[Expr], point: Mapping[str, arb | fmpq]) -> set[Expr]:
    """Return the innermost subexpressions without a proven real value at ``point``."""
    walker = InBalls(point)
    done: dict[Expr, bool] = {}
    without_value: set[Expr] = set()

    def has_value(node: Expr) -> bool:
        if node not in done:
            inner = [has_value(arg) for arg in node.args if isinstance(arg, Expr)]
            done[node] = all(inner)
            if done[node]:
                try:
                    walker.value(node)
                except UndefinedError:
                    without_value.add(node)
                    done[node] = False
        return done[node]

    for e in expressions:
        has_value(e)
    return without_value


def _natural_power(x: arb, n: int) -> arb:
    """Return ``x**n`` for a ball that contains 0; FLINT returns NaN if the midpoint is 0."""
    if n == 0:
        return arb(1)
    if n % 2:
        return (x.lower() ** n).union(x.upper() ** n)
    return arb(0).union(x.abs_upper() ** n)


Rule = Callable[[Expr, "InBalls"], arb]
"""Enclose an operation in an evaluation; it raises ``UndefinedError`` where no value is proved."""

NO_RULES: Mapping[str, Rule] = {}


class InBalls(Walker):
    """Evaluate in balls and require every value to be finite.

    Operations that bind variables, such as integrals, have a value only by a rule, see
    :mod:`tresym.reals.domain.binder_values`.

    Attributes:
        rules: how operations are enclosed, by their name.
        broken: the innermost subexpression that was found to have no value.
    """

    def __init__(
        self,
        at: Mapping[str, Any],
        rules: Mapping[str, Rule] = NO_RULES,
        known: dict[Expr, arb] | None = None,
        outer: InBalls | None = None,
    ) -> None:
        """Prepare an evaluation.

        Args:
            at: the values of the variables; the mapping may compute them on demand.
            rules: how operations are enclosed, by their name.
            known: values of subexpressions; they are used, and new ones are added.
            outer: an evaluation whose values are used for the parts without variables of ``at``.
        """
        super().__init__(balls, at if outer is None else ChainMap(at, outer.at), known)  # type: ignore[arg-type]
        self.rules, self.outer, self.broken = rules, outer, ZERO
        self._own_names = at.keys()

    def inner(self, more: dict[str, arb], rules: Mapping[str, Rule] | None = None) -> InBalls:
        """Return an evaluation with further variables, which takes the other values from here."""
        return InBalls(more, self.rules if rules is None else rules, outer=self)

    def value(self, e: Expr) -> arb:
        """Return the value of ``e``.

        Raises:
            UndefinedError: the value is not proved to exist; ``broken`` is then the part without
                one.
        """
        ball = self.known.get(e)
        if ball is None:
            if self.outer is not None and self._own_names.isdisjoint(symbols(e)):
                ball = self.known[e] = self.outer.value(e)
                return ball
            try:
                ball = self._computed(e)
            except UndefinedError:
                self.broken = e if self.broken is ZERO else self.broken
                raise
            if not ball.is_finite():
                self.broken = e
                raise UndefinedError
            self.known[e] = ball
        return ball

    def _computed(self, e: Expr) -> arb:
        op = e.op
        if op in self.rules:
            return self.rules[op](e, self)
        if op in UNWORKED or e.loose:  # it has bound variables
            raise UndefinedError
        if op == "*":
            return self._quotient(e)
        ball: arb = super()._computed(e)
        return ball

    def _quotient(self, e: Expr) -> arb:
        """Return a product as one quotient, so that a fraction of integers is rounded only once."""
        above: arb | None = None
        below: arb | None = None
        for factor in e.args:
            if factor.op == "^" and factor.args[1] == MINUS_ONE:
                y = self.value(factor.args[0])
                if y.contains(0):
                    self.broken = factor
                    raise UndefinedError
                below = y if below is None else below * y
            else:
                x = self.value(factor)
                above = x if above is None else above * x
        if below is None:
            assert above is not None
            return above
        return (1 if above is None else above) / below

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
