"""An expression as a formula that runs in balls, gradients and germs."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from flint import arb, fmpq, fmpq_poly

from tresym.reals.balls.germ import Germ, UnresolvedError
from tresym.reals.balls.gradient import Gradient
from tresym.reals.language.cancellation import scaled, without_cancellation
from tresym.reals.language.expression import ONE, Expr, off_the_cut
from tresym.reals.places.values import evaluate

_RECIPROCALS = {"sec": "cos", "csc": "sin", "sech": "cosh", "csch": "sinh"}


def formula(e: Expr, name: str) -> Callable[[Any, Any], Any]:
    """``e`` as a function of the variable ``name`` and the arithmetic.

    Over balls it is :func:`tresym.reals.evaluate`, NaN where it is not shown to be defined.
    """

    def run(x: Any, m: Any) -> Any:
        if isinstance(x, arb):
            return evaluate(e, {name: x})
        return _Run(name, x, m).value(e)

    return run


class _Run:
    """One run in gradients or germs; shared parts are computed once."""

    def __init__(self, name: str, x: Any, m: Any) -> None:
        self.name, self.x, self.m = name, x, m
        self.done: dict[Expr, Any] = {}

    def value(self, e: Expr) -> Any:
        if e not in self.done:
            self.done[e] = self._value(e)
        return self.done[e]

    def _value(self, e: Expr) -> Any:
        m = self.m
        if e.op == "symbol":
            return self.x
        if e.op == "number":
            return self._constant(e.args[0])
        if e.op == "pi":
            return m.pi
        if e.op == "^":
            return self._power(*e.args)
        if e.op == "atan2":
            return self.value(off_the_cut(e))
        if e.op == "+" and isinstance(self.x, Germ):
            return self._sum(without_cancellation(e))
        if e.op == "log" and isinstance(self.x, Germ):
            small = self._flat_above_one(e.args[0])
            if small is not None:
                return m.log1p(small)
        values = [self.value(arg) for arg in e.args]
        if e.op in ("+", "*"):
            total = values[0]
            for value in values[1:]:
                total = total + value if e.op == "+" else total * value
            return total
        if e.op in ("asin", "acos") and isinstance(self.x, Germ):
            return self._arc(e.op, values[0])
        return self._function(e.op, values[0])

    def _constant(self, value: fmpq) -> Any:
        return self.m.constant(value) if isinstance(self.x, Germ) else arb(value)

    def _sum(self, terms: list[Expr]) -> Any:
        """The sum of germs; an exponential less 1 is taken as one function."""
        total = self.m.constant(0)
        constant = terms[-1].args[0] if terms[-1].op == "number" else None
        for term in terms:
            scale, inner = scaled(term)
            exponent = (
                self._exponent(inner) if constant is not None and scale == -constant else None
            )
            if exponent is not None:
                total = total + self.m.constant(scale) * self.m.expm1(exponent)
                constant = None
            elif term.op != "number":
                total = total + self.value(term)
        return total if constant is None else total + self.m.constant(constant)

    def _exponent(self, e: Expr) -> Any:
        """u, where ``e`` is exp(u), a power with a variable exponent, or a root of 1 + flat."""
        if e.op == "exp":
            return self.value(e.args[0])
        if e.op != "^":
            return None
        base, exponent = e.args
        if exponent.op != "number":
            return self.value(exponent) * self.m.log(self.value(base))
        small = self._flat_above_one(base)
        return None if small is None else self.m.log1p(small) * self.m.constant(exponent.args[0])

    def _flat_above_one(self, e: Expr) -> Germ | None:
        """v of 1 + v where v is exponentially small, and lost in the sum."""
        if e.op != "+" or ONE not in e.args:
            return None
        rest = self._sum([term for term in e.args if term != ONE])
        return rest if len(rest.exponent) > 1 and rest.growth() < 0 else None

    def _arc(self, name: str, x: Germ) -> Any:
        """Arc sine or cosine, also of what tends to ±1: acos x = 2 asin √((1 − x)/2)."""
        m = self.m
        for side in (1, -1):
            gap = (1 - side * x) / 2
            if gap.vanishes or gap.growth() >= 0:
                continue
            angle = 2 * m.asin(self._germ_power(gap, fmpq(1, 2)))  # acos(side·x)
            if name == "acos":
                return angle if side > 0 else m.pi - angle
            return side * (m.pi / 2 - angle)
        return getattr(m, name)(x)

    def _power(self, base: Expr, exponent: Expr) -> Any:
        x, m = self.value(base), self.m
        if exponent.op != "number":
            return m.exp(self.value(exponent) * m.log(x))
        r = exponent.args[0]
        if r.q == 1 and isinstance(x, Gradient | arb):
            return x ** int(r.p) if r >= 0 else 1 / x ** int(-r.p)
        if isinstance(x, Germ):
            return self._germ_power(x, r)
        return m.sqrt(x) ** int(r.p) if r.q == 2 and r > 0 else m.exp(m.log(x) * arb(r))

    def _germ_power(self, x: Germ, r: fmpq) -> Any:
        if x.vanishes:
            if r > 0:
                return x
            raise UnresolvedError("a negative power of zero")
        if r.q != 1 and not x.range() > 0:
            raise UnresolvedError("the argument of a root is not certainly positive")
        return self.m.power(x, r)

    def _function(self, name: str, x: Any) -> Any:
        m = self.m
        if name in _RECIPROCALS:
            return 1 / self._function(_RECIPROCALS[name], x)
        if name == "cot":
            return self._function("cos", x) / self._function("sin", x)
        if name in ("sin", "cos", "tan") and isinstance(x, Germ):
            return self._wave(name, x)
        if name == "coth":
            return 1 / m.tanh(x)
        if name == "abs":
            return abs(x)
        if name in ("sign", "cbrt"):
            side = self._side(x)
            return self._constant(fmpq(side)) if name == "sign" else self._root(x * side) * side
        return getattr(m, name)(x)

    def _wave(self, name: str, x: Germ) -> Any:
        """Sine, cosine or tangent, turned back by a limit kπ/2, so that a zero there is exact."""
        m, limit = self.m, x.terms[0] if x.terms and x.power == 0 and not x.exponent else None
        if not isinstance(limit, fmpq_poly) or limit.degree() != 1 or limit[0] != 0:
            return getattr(m, name)(x)
        quarters = 2 * limit[1]
        if quarters.q != 1:
            return getattr(m, name)(x)
        k, y = int(quarters.p), x - m.constant(limit)
        if name == "tan":
            return -m.cos(y) / m.sin(y) if k % 2 else m.tan(y)
        k += name == "cos"
        value = m.cos(y) if k % 2 else m.sin(y)
        return -value if k % 4 >= 2 else value

    def _side(self, x: Any) -> int:
        """±1, the sign of ``x``.

        Raises:
            UnresolvedError: it is not certain.
        """
        size = x.range() if isinstance(x, Germ) else x.value if isinstance(x, Gradient) else x
        if size > 0 or size < 0:
            return 1 if size > 0 else -1
        raise UnresolvedError("the sign of an argument is not certain")

    def _root(self, x: Any) -> Any:
        if isinstance(x, Germ):
            return self.m.power(x, fmpq(1, 3))
        return self.m.exp(self.m.log(x) / 3)
