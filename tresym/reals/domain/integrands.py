"""Compile integrands to a list of steps that run in real and complex balls.

Parts without the variable are evaluated in advance, and equal parts share a step. In complex balls
every step is holomorphic or not finite, as FLINT requires of integrands. In real balls a step
without a proven value makes the result NaN.
"""

from __future__ import annotations

import operator
from collections.abc import Callable
from functools import partial, reduce
from typing import Any

from flint import acb, arb, fmpq

from tresym.reals.domain.evaluation import UndefinedError, applied, rational_power, real_power
from tresym.reals.functions.table import TABLE, names
from tresym.reals.language.expression import MINUS_ONE, UNWORKED, Expr, symbols

MEROMORPHIC = names(lambda row: row.theory and (row.entire or row.quotient))
OFF_CUTS = {row.name: row.off_cuts for row in TABLE.values() if row.off_cuts is not None}
"""Whether a complex ball avoids the branch cuts, where they are analytic."""
Done = Callable[..., Any]
HALF = fmpq(1, 2)


class Integrand:
    """An expression as a function of one variable."""

    def __init__(self, e: Expr, name: str, known: Callable[[Expr], arb]) -> None:
        """Compile an expression.

        Args:
            e: the integrand.
            name: its variable.
            known: a function that returns the values of the parts without the variable.

        Raises:
            UndefinedError: a part that binds variables depends on the variable.
        """
        self.name, self.known = name, known
        self.start: list[Any] = [None]
        self.places: dict[Expr, int] = {}
        self.steps: list[tuple[int, tuple[int, ...], Done, Done]] = []
        self.end = self._place(e)

    def _place(self, e: Expr) -> int:
        """Return the slot of the value of a part."""
        if e.op == "symbol" and e.args[0] == self.name:
            return 0
        if e not in self.places:
            if self.name not in symbols(e):
                self.start.append(self.known(e))
            elif e.op in UNWORKED:
                raise UndefinedError
            else:
                args, real, holomorphic = _step(e)
                places = tuple(map(self._place, args))
                self.steps.append((len(self.start), places, real, holomorphic))
                self.start.append(None)
            self.places[e] = len(self.start) - 1
        return self.places[e]

    def real(self, x: arb) -> arb:
        """Return the value at a real ball; NaN where none is proved."""
        values = [x, *self.start[1:]]
        try:
            for place, args, done, _ in self.steps:
                if len(args) == 1:  # written out, as this is where quadrature spends its time
                    found = done(values[args[0]])
                elif len(args) == 2:
                    found = done(values[args[0]], values[args[1]])
                else:
                    found = done(*[values[n] for n in args])
                values[place] = found
                if not found.is_finite():
                    return arb.nan()
        except UndefinedError:
            return arb.nan()
        return values[self.end]

    def holomorphic(self, z: acb) -> acb:
        """Return the value at a complex ball; not finite unless proved holomorphic on it."""
        values = [z, *self.start[1:]]
        for place, args, _, done in self.steps:
            if len(args) == 1:
                values[place] = done(values[args[0]])
            elif len(args) == 2:
                values[place] = done(values[args[0]], values[args[1]])
            else:
                values[place] = done(*[values[n] for n in args])
        return acb(values[self.end])

    def __call__(self, z: acb, analytic: bool) -> acb:
        """Evaluate as FLINT's quadrature requires."""
        if analytic:
            return self.holomorphic(z)
        return acb(self.real(z.real) if z.imag.is_zero() else arb.nan())


def _step(e: Expr) -> tuple[tuple[Expr, ...], Done, Done]:
    """Return the operands of a part, and its operation in real and in complex balls."""
    if e.op == "+":
        add = operator.add if len(e.args) == 2 else _sum
        return e.args, add, add
    if e.op == "*":
        below = [factor.args[0] for factor in e.args if _is_reciprocal(factor)]
        above = [factor for factor in e.args if not _is_reciprocal(factor)]
        quotient: Done = partial(_quotient, len(above))
        if len(e.args) == 2 and above:
            quotient = operator.truediv if below else operator.mul
        return (*above, *below), quotient, quotient
    if e.op == "^" and e.args[1].op == "number":
        r = e.args[1].args[0]
        real = _square_root if r == HALF else _reciprocal if r == -1 else None
        return (
            e.args[:1],
            real or (lambda x: rational_power(x, r)),
            lambda z: _power(acb(z), r),
        )
    if e.op == "^":
        return e.args, real_power, lambda z, w: (w * acb(z).log(analytic=True)).exp()
    row = TABLE.get(e.op)
    real = partial(applied, e.op) if row is None or row.ball is None else row.ball
    return e.args, real, partial(_holomorphic, e.op)


def _square_root(x: arb) -> arb:
    if not x >= 0:
        raise UndefinedError
    return x.sqrt()


def _reciprocal(x: arb) -> arb:
    if x.contains(0):
        raise UndefinedError
    return 1 / x


def _is_reciprocal(e: Expr) -> bool:
    return e.op == "^" and e.args[1] == MINUS_ONE


def _sum(*values: Any) -> Any:
    return reduce(operator.add, values)


def _quotient(above: int, *values: Any) -> Any:
    """Return a product divided by the remaining values; a fraction is thus rounded only once."""
    product = reduce(operator.mul, values[:above], arb(1))
    return product / reduce(operator.mul, values[above:]) if values[above:] else product


def _power(z: acb, r: fmpq) -> acb:
    p, q = int(r.p), int(r.q)
    if q == 1:
        return z**p
    return (z.sqrt(analytic=True) if q == 2 else z.pow(acb(fmpq(1, q)), analytic=True)) ** p


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
