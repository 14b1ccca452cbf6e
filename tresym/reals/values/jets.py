"""Compute Taylor coefficients of expressions that contain roots and integrals.

In the body the coefficients are those of power series arithmetic (see
:mod:`tresym.reals.balls.taylor`). The base point may be a ball; the coefficients then are enclosed
for every point in it, which is what Lagrange's remainder asks for.

- *Root* y of F(y, x) = 0: y₀ is enclosed, and the coefficient of h^k follows from that of
  F(y₀ + … + c_{k−1} h^{k−1}, x + h), divided by −∂F/∂y.
- *Integral* over t: the k-th coefficient of the integral is the integral of the k-th coefficient of
  the integrand, which FLINT integrates. The integrand must be analytic in t and in x; this is shown
  by balls. The ends must not depend on x.

Example: K(k) at k = 0 has the coefficients π/2, 0, π/8, 0, 9π/128, ….
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from flint import acb, acb_series, arb, arb_series, ctx

from tresym.reals.balls.taylor import InSeries
from tresym.reals.domain.binder_values import enclosing, quadrature
from tresym.reals.domain.compiled import Compiled
from tresym.reals.domain.evaluation import InBalls, Rule, UndefinedError
from tresym.reals.language.binders import worked_out
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import Expr, opened, symbols

ACCURACY = 100
"""The accuracy in bits of integrals of coefficients."""


class Jets(InSeries):
    """Compute Taylor coefficients, including those of roots and of integrals."""

    def __init__(
        self, at: Mapping[str, Any], rules: Mapping[str, Rule], kind: Any = arb_series
    ) -> None:
        """Prepare a computation.

        Args:
            at: the variables as series.
            rules: how values of roots and of other operations are enclosed.
            kind: the type of the series.
        """
        super().__init__(None, at)
        self.rules, self.kind = rules, kind

    def _number(self, x: Any) -> Any:
        return x if isinstance(x, self.kind) else self.kind([x], ctx.cap)

    def _computed(self, e: Expr) -> Any:
        if e.op == "root":
            return self._root(e)
        if e.op == "integral":
            return self._integral(e)
        if e.names or e.op == "unknown":
            raise UndefinedError
        return super()._computed(e)

    def _base(self) -> dict[str, arb]:
        """Return the variables at the base point."""
        return {name: x[0] if isinstance(x, self.kind) else x for name, x in self.at.items()}

    def _outer(self) -> InBalls:
        if self.kind is not arb_series:
            raise UndefinedError
        return enclosing(self._base(), self.rules)

    def _root(self, e: Expr) -> Any:
        outer = self._outer()
        (name,), body = opened(e, tuple(self.at))
        start = outer.value(e)
        slope = outer.inner({name: start}).value(differentiate(body, name))
        if slope.contains(0):
            raise UndefinedError
        coefficients = [start]
        for k in range(1, ctx.cap):
            inner = Jets({**self.at, name: arb_series(coefficients, ctx.cap)}, self.rules)
            coefficients.append(-inner.value(body)[k] / slope)
        return arb_series(coefficients, ctx.cap)

    def _integral(self, e: Expr) -> Any:
        if not symbols(e) & self.at.keys():
            return self._number(self._outer().value(e))
        outer = self._outer()
        if any(symbols(end) for end in e.args[1:]):
            raise UndefinedError
        low, high = (outer.value(end) for end in e.args[1:])
        (name,), body = opened(e, tuple(self.at))
        compiled = Compiled(worked_out(body), (name,), outer.value)
        functions = [_Coefficient(compiled, body, name, self, k) for k in range(ctx.cap)]
        known: dict[str, Any] = {}
        values = []
        for function in functions:
            function.known = known
            values.append(quadrature(function, low, high, ACCURACY))
        if not all(value.is_finite() for value in values):
            raise UndefinedError
        return arb_series(values, ctx.cap)


class _Coefficient:
    """The k-th Taylor coefficient of an integrand, as a function of the variable of integration."""

    def __init__(self, compiled: Compiled, body: Expr, name: str, jets: Jets, k: int) -> None:
        self.compiled, self.body, self.name, self.jets, self.k = compiled, body, name, jets, k
        self.known: dict[str, Any] = {}

    def __call__(self, z: acb, analytic: bool) -> acb:
        key = repr(z)
        if key not in self.known:
            self.known[key] = self._coefficients(z)
        coefficients = self.known[key]
        return acb(arb.nan()) if coefficients is None else coefficients[self.k]

    def _coefficients(self, z: acb) -> list[acb] | None:
        if not self.compiled.holomorphic(z).is_finite():
            return None
        at: dict[str, Any] = {
            name: acb_series([x[j] for j in range(ctx.cap)], ctx.cap)
            if isinstance(x, arb_series)
            else acb(x)
            for name, x in self.jets.at.items()
        }
        at[self.name] = acb_series([z], ctx.cap)
        try:
            series = Jets(at, self.jets.rules, acb_series).value(self.body)
            coefficients = [series[j] for j in range(ctx.cap)]
        except (ValueError, ZeroDivisionError, AttributeError, TypeError, UndefinedError):
            return None
        return coefficients if all(c.is_finite() for c in coefficients) else None
