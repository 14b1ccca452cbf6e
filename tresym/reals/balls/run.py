"""An expression as a formula that runs in balls, gradients and germs."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

from flint import arb, fmpq, fmpq_poly

from tresym.reals.balls.germ import Germ, UnresolvedError
from tresym.reals.balls.gradient import Gradient
from tresym.reals.language.cancellation import scaled, without_cancellation
from tresym.reals.language.expression import ONE, Expr, differentiate, off_the_cut
from tresym.reals.numbers.arithmetic import side
from tresym.reals.places.values import Walker, evaluate

_RECIPROCALS = {"sec": "cos", "csc": "sin", "sech": "cosh", "csch": "sinh", "coth": "tanh"}


def formula(e: Expr, name: str) -> Callable[[Any, Any], Any]:
    """``e`` as a function of the variable ``name`` and the arithmetic.

    Over balls it is :func:`tresym.reals.evaluate`, NaN where it is not shown to be defined.
    """

    def run(x: Any, m: Any) -> Any:
        if isinstance(x, arb):
            return evaluate(e, {name: x})
        if isinstance(x, Gradient):
            at, known = {name: x.value}, dict[Expr, arb]()
            return x.chain(evaluate(e, at, known), evaluate(slope(), at, known))
        return _InGerms(m, {name: x}).value(e)

    @cache
    def slope() -> Expr:
        return differentiate(e, name)

    return run


class _InGerms(Walker):
    """Expansions, with care for what cancels in them."""

    def _number(self, x: Any) -> Any:
        return self.m.germ(x)

    def _computed(self, e: Expr) -> Any:
        if e.op == "atan2":
            return self.value(off_the_cut(e))
        if e.op == "+":
            return self._sum(without_cancellation(e))
        small = self._flat_above_one(e.args[0]) if e.op == "log" else None
        return super()._computed(e) if small is None else self.m.log1p(small)

    def _power(self, base: Expr, exponent: Expr) -> Any:
        x = self.value(base)
        if exponent.op != "number":
            return self.m.exp(self.value(exponent) * self.m.log(x))
        return self._root(x, exponent.args[0])

    def _apply(self, name: str, *values: Germ) -> Any:
        (x,) = values
        if name in _RECIPROCALS:
            return 1 / self._apply(_RECIPROCALS[name], x)
        if name == "cot":
            return self._apply("cos", x) / self._apply("sin", x)
        if name in ("asin", "acos"):
            return self._arc(name, x)
        if name in ("sin", "cos", "tan"):
            return self._wave(name, x)
        if name == "abs":
            return abs(x)
        if name in ("sign", "cbrt"):
            way = side(x.range())
            if way is None:
                raise UnresolvedError("the sign of an argument is not certain")
            cbrt = name == "cbrt"
            return self.m.power(x * way, fmpq(1, 3)) * way if cbrt else self.m.constant(way)
        return super()._apply(name, x)

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
        for end in (1, -1):
            gap = (1 - end * x) / 2
            if gap.vanishes or gap.growth() >= 0:
                continue
            angle = 2 * m.asin(self._root(gap, fmpq(1, 2)))  # acos(end·x)
            if name == "acos":
                return angle if end > 0 else m.pi - angle
            return end * (m.pi / 2 - angle)
        return getattr(m, name)(x)

    def _root(self, x: Germ, r: fmpq) -> Any:
        if x.vanishes:
            if r > 0:
                return x
            raise UnresolvedError("a negative power of zero")
        if r.q != 1 and not x.range() > 0:
            raise UnresolvedError("the argument of a root is not certainly positive")
        return self.m.power(x, r)

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
