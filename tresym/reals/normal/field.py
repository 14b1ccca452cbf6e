"""The exact normal form: a real expression as a fraction in generators that are as free as known.

Every rewriting holds at each real point where the expression is defined and no factor met on the
way vanishes. Such points are dense in the open part of the domain, and elementary functions are
continuous, so a difference that reduces to zero is zero there, but where sign and atan2 jump.

- sin, cos, …: t = tan(angle/2) for each angle of a rational basis of the angles met.
- exp, powers: y = exp(exponent) for each exponent of a rational basis of the exponents met.
- roots, abs: |f|^(1/n) for each irreducible factor f, and a sign σ_f with σ_f² = 1. That a radicand
  is positive is a linear equation over GF(2) between the σ; what it decides is used in a new pass.
- log: log|f| for each irreducible factor f. asin and acos through atan; the hyperbolic functions
  through exp and log.
- atan2(y, x) is an arc tangent where y is not 0 on a region; else it is 0 or π, by the sign of x.
- A function outside the allowed theories is an opaque generator of its normalised argument.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from flint import arb, fmpq

from tresym.reals.language.expression import Expr
from tresym.reals.normal.angles import AngleRing
from tresym.reals.normal.ring import Fraction, UndefinedError
from tresym.reals.normal.sign_equations import AgainError
from tresym.reals.numbers.factoring import TooLargeError
from tresym.reals.places.conditions import Given

ALL_THEORIES = frozenset({"roots", "trigonometry", "exponentials", "inverses"})

_THEORY: dict[str, frozenset[str]] = (
    {name: frozenset({"roots"}) for name in ("abs", "sign", "cbrt")}
    | {
        name: frozenset({"exponentials"})
        for name in ("exp", "log", "sinh", "cosh", "tanh", "coth", "sech", "csch")
    }
    | {name: frozenset({"trigonometry"}) for name in ("sin", "cos", "tan", "cot", "sec", "csc")}
    | {name: frozenset({"inverses"}) for name in ("asin", "acos", "atan")}
    | {name: frozenset({"inverses"}) for name in ("asinh", "acosh", "atanh")}
    | {"atan2": frozenset({"inverses", "roots"})}
)

MAX_PASSES = 40


_CIRCULAR = {
    "sinh": "sin",
    "cosh": "cos",
    "tanh": "tan",
    "coth": "cot",
    "sech": "sec",
    "csch": "csc",
}


class Field(AngleRing):
    """Normal forms under ``given`` with the functions of ``theories`` known."""

    def __init__(
        self,
        given: Given,
        theories: frozenset[str] = ALL_THEORIES,
        size: int = 24,
        points: Callable[[], Sequence[Mapping[str, fmpq]]] = tuple,
    ):
        """The arguments of the base class, and what may be used beyond algebra."""
        super().__init__(given, size, points)
        self.theories = theories
        self._memo: dict[Expr, Fraction] = {}

    def normal(self, *expressions: Expr) -> list[Fraction]:
        """The normal forms of ``expressions``, on the domain of all of them and under ``given``.

        Raises:
            UndefinedError: one of them is nowhere defined.
            TooLargeError: a normal form outgrew its bounds.
        """
        for _ in range(MAX_PASSES):
            self._memo.clear()
            self.begin_pass()
            try:
                for condition in self.given.beyond_box:
                    value = self._walk(condition.expression)
                    if condition.relation != "!=":
                        self._require_positive(value, strict=condition.relation == ">")
                result = [self._walk(e) for e in expressions]
            except AgainError:
                continue
            except (TooLargeError, UndefinedError):
                if not self.learn():
                    raise
                continue
            if not self.learn() or self._are_equal(result):
                return result
        raise TooLargeError("the normal form did not settle")

    def _are_equal(self, values: list[Fraction]) -> bool:
        """Whether ``values`` are two equal ones, which nothing that is learnt can change."""
        return len(values) == 2 and self.subtract(*values).num.is_zero()

    def _walk(self, node: Expr) -> Fraction:
        value = self._memo.get(node)
        if value is None:
            value = self._node(node)
            self._memo[node] = value
        return value

    def _node(self, node: Expr) -> Fraction:
        op, args = node.op, node.args
        if op == "number":
            return self.constant(args[0])
        if op == "symbol":
            return self._fraction(self.symbol(args[0]))
        if op == "pi":
            return self._fraction(self.generator("pi", None))
        if op == "^":
            return self._power(*args)
        values = [self._walk(arg) for arg in args]
        if op == "+":
            return self.sum(values)
        if op == "*":
            total = values[0]
            for value in values[1:]:
                total = self.multiply(total, value)
            return total
        if not _THEORY[op] <= self.theories:
            return self._opaque(op, *values)
        return self._angle(*values) if op == "atan2" else self._function(op, values[0])

    def _function(self, name: str, x: Fraction) -> Fraction:
        simple: dict[str, Callable[[Fraction], Fraction]] = {
            "exp": self.exp,
            "log": self.log,
            "atan": self.atan,
            "asin": self._asin,
            "sign": self._sign_function,
            "asinh": self._asinh,
            "acosh": self._acosh,
            "atanh": self._atanh,
        }
        if name in simple:
            return simple[name](x)
        if name == "abs":
            return self.multiply(x, self._sign_function(x))
        if name == "cbrt":
            return self._root(x, fmpq(1, 3), signed=True)
        if name == "acos":
            return self.subtract(self.pi(fmpq(1, 2)), self._asin(x))
        if name in ("sin", "cos", "tan", "cot", "sec", "csc"):
            return self._quotient(name, *self._turn(x))
        y = self.exp(x)
        z = self.invert(y)
        half = self.constant(fmpq(1, 2))
        cosh = self.multiply(half, self.add(y, z))
        sinh = self.multiply(half, self.subtract(y, z))
        return self._quotient(_CIRCULAR[name], cosh, sinh)

    def _quotient(self, name: str, c: Fraction, s: Fraction) -> Fraction:
        """sin, cos, tan, … from cosine and sine (circular or hyperbolic)."""
        match name:
            case "sin":
                return s
            case "cos":
                return c
            case "tan":
                return self.divide(s, c)
            case "cot":
                return self.divide(c, s)
            case "sec":
                return self.invert(c)
            case _:
                return self.invert(s)

    def _power(self, base: Expr, exponent: Expr) -> Fraction:
        x = self._walk(base)
        r = self.rational(self._walk(exponent))
        if r is not None and r.q == 1:
            return self.power(x, int(r.p))
        if r is not None:
            if "roots" not in self.theories:
                return self._opaque("^", x, self.constant(r))
            return self._root(x, r)
        if "exponentials" not in self.theories:
            return self._opaque("^", x, self._walk(exponent))
        return self.exp(self.multiply(self._walk(exponent), self.log(x)))

    def _opaque(self, name: str, *args: Fraction) -> Fraction:
        """A generator of which nothing is known but its arguments."""
        key = (name, *(arg.key for arg in args))
        return self._fraction(self.generator("opaque", key, (name, *args)))

    # Inverse functions

    def _angle(self, y: Fraction, x: Fraction) -> Fraction:
        """``atan2(y, x)``: that y is 0, or not, must be so on the whole domain."""
        if y.num.is_zero():
            half_turns = self.subtract(self.one, self._sign_function(self.invert(x)))
            return self.multiply(self.pi(fmpq(1, 2)), half_turns)
        if self.is_mixed(y.num):
            return self._opaque("atan2", y, x)
        if self.product_sign(x.num) * self.product_sign(x.den) > 0:
            return self.atan(self.divide(y, x))
        side = self.product_sign(y.num) * self.product_sign(y.den)
        if side:
            return self.subtract(self.pi(fmpq(side, 2)), self.atan(self.divide(x, y)))
        square = self.add(self.power(x, 2), self.power(y, 2))
        below = self.add(self._root(square, fmpq(1, 2)), x)
        return self.multiply(self.constant(2), self.atan(self.divide(y, below)))

    def atan(self, u: Fraction) -> Fraction:
        """``atan u``, odd in u, with atan(1/u) = ±π/2 − atan u used to choose between the two."""
        if u.num.is_zero():
            return self.zero
        special = self._special_atan(u)
        if special is not None:
            return special
        if u.num.leading_coefficient() < 0:
            return self.negative(self.atan(self.negative(u)))
        signed = self._sign_content(u)
        if signed is not None:
            return self.multiply(signed[0], self.atan(signed[1]))
        if not self.is_mixed(u.num):
            inverse = self.invert(u)
            if self._rank(inverse) < self._rank(u):
                sign = self._sign_function(u)
                quarter = self.multiply(sign, self.pi(fmpq(1, 2)))
                return self.subtract(quarter, self.atan(inverse))
        return self._fraction(self.generator("atan", u.key, (u,)))

    def _rank(self, u: Fraction) -> tuple[bool, int, int, str]:
        """Least for the one of u and 1/u that is to be kept: where it can, it has no poles."""
        return not self.product_sign(u.den), len(u.den), int(u.den.total_degree()), str(u.den)

    def _special_atan(self, u: Fraction) -> Fraction | None:
        """``atan u`` where it is a multiple of π/12."""
        if not self.is_constant(u):
            return None
        value = self.ball(u).atan() * 12 / arb.pi()
        k = value.unique_fmpz()
        if k is None or abs(k) >= 6:
            return None
        c, s = self.turn_of_pi(fmpq(k, 12))
        if not self.subtract(u, self.divide(s, c)).num.is_zero():
            return None
        return self.pi(fmpq(k, 12))

    def _asin(self, u: Fraction) -> Fraction:
        below, above = self.subtract(self.one, u), self.add(self.one, u)
        if below.num.is_zero() or above.num.is_zero():
            return self.pi(fmpq(1 if below.num.is_zero() else -1, 2))
        self._require_positive(below)
        self._require_positive(above)
        c = self._root(self.multiply(below, above), fmpq(1, 2))
        if self.is_mixed(below.num) or self.is_mixed(above.num):
            # c may be 0 on a region; 1 + c is not
            half = self.atan(self.divide(u, self.add(self.one, c)))
            return self.multiply(self.constant(2), half)
        return self.atan(self.divide(u, c))

    def _asinh(self, u: Fraction) -> Fraction:
        square = self.add(self.one, self.power(u, 2))
        self._require_positive(square)
        return self.log(self.add(u, self._root(square, fmpq(1, 2))))

    def _acosh(self, u: Fraction) -> Fraction:
        below, above = self.subtract(u, self.one), self.add(u, self.one)
        if below.num.is_zero():
            return self.zero
        self._require_positive(below)
        self._require_positive(above)
        return self.log(self.add(u, self._root(self.multiply(below, above), fmpq(1, 2))))

    def _atanh(self, u: Fraction) -> Fraction:
        below, above = self.subtract(self.one, u), self.add(self.one, u)
        difference = self.subtract(self.log(above), self.log(below))
        return self.multiply(self.constant(fmpq(1, 2)), difference)
