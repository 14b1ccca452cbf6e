"""Compile trees to lists of steps that run in real and in complex balls.

For example, x·exp(y)/(x + 1) as a function of x becomes the steps s₁ = x + 1, s₂ = x·c and
s₃ = s₂/s₁, with the value c of exp(y), which is computed in advance. Equal parts share a step. In
real balls a step without a proven value makes the result NaN. In complex balls every step is
holomorphic or not finite, as FLINT requires of the integrands of its quadrature (F. Johansson,
*Numerical integration in arbitrary-precision ball arithmetic*, ICMS 2018).
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Sequence
from functools import partial
from itertools import repeat
from operator import methodcaller
from typing import Any

from flint import acb, arb, ctx, fmpq

from tresym.reals.domain.evaluation import InBalls, UndefinedError, rational_power, real_power
from tresym.reals.functions.table import TABLE, names
from tresym.reals.language.expression import (
    MINUS_ONE,
    ONE,
    UNWORKED,
    Expr,
    symbol,
    symbols,
)

MEROMORPHIC = names(lambda row: row.theory and (row.entire or row.quotient))
OFF_CUTS = {row.name: row.off_cuts for row in TABLE.values() if row.off_cuts is not None}
"""Whether a complex ball avoids the branch cuts, where they are analytic."""
Operation = Callable[..., Any]
_CHAINED = (operator.add, operator.mul)
"""Operations whose results need no check: those of finite balls are finite."""
_NAN = arb.nan()


class Compiled:
    """An expression as a function of some of its variables."""

    def __init__(
        self, e: Expr, variables: Sequence[str], known: Callable[[Expr], arb] | None = None
    ) -> None:
        """Compile an expression.

        Args:
            e: the expression.
            variables: the variables, in the order of the coordinates of a point.
            known: returns the values of the parts without these variables. Without it they have
                no variables at all, and are computed anew if the precision changes.

        Raises:
            UndefinedError: a part that binds variables depends on ``variables``, or ``known`` has
                no value of a part.
        """
        self._variables = frozenset(variables)
        self._places = {symbol(name): n for n, name in enumerate(variables)}
        self._constants: list[tuple[int, Expr]] = []
        self._values: list[Any] = [None] * len(variables)
        self._steps: list[tuple[Operation, Operation, int, int | tuple[int, ...] | None, int]] = []
        self._known = known
        self._bits = 0
        self._end = self._place(e)
        if known is not None:
            self._fill()

    def real(self, *point: arb) -> arb:
        """Return the value at a real point; NaN where none is proved."""
        try:
            if self._bits != ctx.prec:
                self._fill()
            values = [*point, *self._values[len(point) :]]
            for operation, _, i, j, k in self._steps:
                if j is None:
                    values[k] = value = operation(values[i])
                    if not value.is_finite():
                        return _NAN
                elif isinstance(j, int):
                    values[k] = operation(values[i], values[j])
                else:
                    values[k] = operation(values[i], *[values[n] for n in j])
        except UndefinedError:
            return _NAN
        value = values[self._end]
        return value if value.is_finite() else _NAN

    def holomorphic(self, *point: acb) -> acb:
        """Return the value at a complex point; not finite unless proved holomorphic on it."""
        if self._bits != ctx.prec:
            self._fill()
        values = [*point, *self._values[len(point) :]]
        for _, operation, i, j, k in self._steps:
            if j is None:
                values[k] = operation(values[i])
            elif isinstance(j, int):
                values[k] = operation(values[i], values[j])
            else:
                values[k] = operation(values[i], *[values[n] for n in j])
        return acb(values[self._end])

    def reals(self, points: list[arb]) -> list[arb] | None:
        """Return the values of a function of one variable at real points; None if one has none."""
        if self._bits != ctx.prec:
            self._fill()
        values: list[Any] = [points, *self._values[1:]]
        try:
            for operation, _, i, j, k in self._steps:
                values[k] = found = _over(_QUICK.get(operation, operation), values, i, j)
                if operation not in _CHAINED and not _all_finite(found):
                    return None
        except UndefinedError:
            return None
        found = values[self._end]
        found = found if isinstance(found, list) else [found] * len(points)
        return found if _all_finite(found) else None

    def holomorphics(self, points: list[acb]) -> list[acb]:
        """Return the values at complex points, each not finite unless proved holomorphic there."""
        if self._bits != ctx.prec:
            self._fill()
        values: list[Any] = [points, *self._values[1:]]
        for _, operation, i, j, k in self._steps:
            values[k] = _over(operation, values, i, j)
        found = values[self._end]
        return list(map(acb, found if isinstance(found, list) else [found] * len(points)))

    def __call__(self, z: acb, analytic: bool) -> acb:
        """Evaluate a function of one variable as FLINT's quadrature requires."""
        if analytic:
            return self.holomorphic(z)
        return acb(self.real(z.real) if z.imag.is_zero() else _NAN)

    def _fill(self) -> None:
        """Compute the parts without the variables, at the working precision."""
        known = self._known or InBalls({}).value
        for place, part in self._constants:
            self._values[place] = known(part)
        self._bits = ctx.prec

    def _place(self, e: Expr) -> int:
        """Return the place of the value of ``e``."""
        place = self._places.get(e)
        if place is None:
            place = self._places[e] = self._compiled(e)
        return place

    def _compiled(self, e: Expr) -> int:
        op, args = e.op, e.args
        if self._variables.isdisjoint(symbols(e)):
            self._constants.append((self._new(), e))
            return self._constants[-1][0]
        if op == "+":
            return self._chain(operator.add, args)
        if op == "*":
            below = [factor.args[0] for factor in args if _is_reciprocal(factor)]
            above = [factor for factor in args if not _is_reciprocal(factor)] or [ONE]
            product = self._chain(operator.mul, above)
            if not below:
                return product
            divisor = self._chain(operator.mul, below)
            return self._step(_divided, operator.truediv, product, divisor)
        if op in UNWORKED or (op != "^" and TABLE[op].ball is None):
            raise UndefinedError
        if op == "^" and args[1].op == "number":
            return self._step(*_power_steps(args[1].args[0]), self._place(args[0]))
        real = real_power if op == "^" else TABLE[op].ball
        holomorphic = _complex_real_power if op == "^" else _in_complex_balls(op)
        first, *others = map(self._place, args)
        if not others:
            return self._step(real, holomorphic, first)
        more = others[0] if len(others) == 1 else tuple(others)
        return self._step(partial(_finite, real), holomorphic, first, more)

    def _chain(self, operation: Operation, parts: Sequence[Expr]) -> int:
        """Return the place of a sum or product, which needs no check: finite balls have one."""
        place = self._place(parts[0])
        for part in parts[1:]:
            place = self._step(operation, operation, place, self._place(part))
        return place

    def _step(
        self,
        real: Operation,
        holomorphic: Operation,
        i: int,
        j: int | tuple[int, ...] | None = None,
    ) -> int:
        place = self._new()
        self._steps.append((real, holomorphic, i, j, place))
        return place

    def _new(self) -> int:
        self._values.append(None)
        return len(self._values) - 1


def _all_finite(found: Any) -> bool:
    return all(map(arb.is_finite, found)) if isinstance(found, list) else bool(found.is_finite())


def _over(operation: Operation, values: list[Any], i: int, j: int | tuple[int, ...] | None) -> Any:
    """Return an operation at each point: of lists a list, of numbers alone a number."""
    places = (i,) if j is None else (i, j) if isinstance(j, int) else (i, *j)
    operands = [values[n] for n in places]
    if not any(isinstance(x, list) for x in operands):
        return operation(*operands)
    return list(map(operation, *[x if isinstance(x, list) else repeat(x) for x in operands]))


def _rational_power(r: fmpq, x: arb) -> arb:
    return rational_power(x, r)


def _divided(x: arb, y: arb) -> arb:
    if y.contains(0):
        raise UndefinedError
    return x / y


def _finite(ball: Callable[..., arb], *values: arb) -> arb:
    """Return a function of several balls; the loop checks those of one ball alone."""
    value = ball(*values)
    if not value.is_finite():
        raise UndefinedError
    return value


def _is_reciprocal(e: Expr) -> bool:
    return e.op == "^" and e.args[1] == MINUS_ONE


def _complex_power(r: fmpq, z: Any) -> acb:
    z, p, q = acb(z), int(r.p), int(r.q)
    if q == 1:
        return z**p
    return (z.sqrt(analytic=True) if q == 2 else z.pow(acb(fmpq(1, q)), analytic=True)) ** p


def _power_steps(r: fmpq) -> tuple[Operation, Operation]:
    """Return the real and the holomorphic operation of a power with a written exponent."""
    p, q = int(r.p), int(r.q)
    if q == 1:
        return lambda x: rational_power(x, r) if x.contains(0) else x**p, lambda z: z**p
    if q == 2 and p in (1, -1):
        name = "sqrt" if p == 1 else "rsqrt"
        return getattr(arb, name), methodcaller(name, analytic=True)
    return partial(_rational_power, r), partial(_complex_power, r)


def _complex_real_power(z: Any, w: Any) -> acb:
    return (w * acb(z).log(analytic=True)).exp()


_QUICK: dict[Operation, Operation] = {_divided: operator.truediv}
"""Operations without their own check, where the result is checked to be finite."""


def _in_complex_balls(name: str) -> Operation:
    """Return a function in complex balls."""
    plain = name in MEROMORPHIC and TABLE[name].holomorphic is None and name not in OFF_CUTS
    return getattr(acb, name) if plain else partial(_holomorphic, name)


def _holomorphic(name: str, *values: Any) -> acb:
    if name == "log":
        return acb(values[0]).log(analytic=True)
    if name == "abs":
        return acb(values[0]).real_abs(analytic=True)
    row = TABLE.get(name)
    if row is not None and row.holomorphic is not None:
        return row.holomorphic(*values)
    if name in OFF_CUTS:
        z = acb(values[0])
        return getattr(z, name)() if OFF_CUTS[name](z) else acb(arb.nan())
    if name in ("sign", "cbrt"):
        z = acb(values[0])
        side = 1 if z.real > 0 else -1 if z.real < 0 else None
        if side is None:
            return acb(arb.nan())
        return acb(side) if name == "sign" else side * (side * z).pow(acb(fmpq(1, 3)))
    return getattr(values[0], name)() if name in MEROMORPHIC else acb(arb.nan())
