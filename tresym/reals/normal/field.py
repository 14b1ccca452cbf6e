"""Compute the exact normal form of a real expression, a fraction in independent generators.

Every rewriting step is valid at each real point where the expression is defined and where no factor
that occurs on the way vanishes. Such points are dense in the open part of the domain, and
elementary functions are continuous there except for jumps of sign and atan2. So a difference with
normal form zero is zero wherever it is defined, except at such jumps.

The generators are:

- sin, cos, …: t = tan(angle/2) for each angle of a rational basis of the angles that occur.
- exp and powers: y = exp(exponent) for each exponent of a rational basis of the exponents.
- roots and abs: |f|^(1/n) for each irreducible factor f, and a sign σ_f with σ_f² = 1. A positive
  radicand gives a linear equation over GF(2) between the signs, and what it decides is used in
  another pass.
- log: log|f| for each irreducible factor f. asin and acos are written with atan, the hyperbolic
  functions and their inverses with exp and log.
- atan2(y, x) is an arc tangent where y is not 0 on a region; otherwise it is 0 or π, by the sign of
  x.
- A function outside the allowed theories is an opaque generator of its normalised argument.

A field is put together from parts, each of which knows only those before it: a ring (the tower of
generators), a prover of signs, equations between signs, powers, and angles. What is learnt on the
way, such as a sign or the order of a root, may begin another pass over the expressions.

Which generators are independent is what Risch's structure theorem says (Risch, *Algebraic
properties of the elementary functions of analysis*, Amer. J. Math. 101, 1979; Bronstein, *Symbolic
Integration I*, chapter 9).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from math import prod

from flint import arb, fmpq

from tresym.reals.domain.conditions import Given
from tresym.reals.functions.table import SPECIAL, TABLE
from tresym.reals.language.expression import UNWORKED, Expr
from tresym.reals.normal.angles import Angles
from tresym.reals.normal.powers import Powers
from tresym.reals.normal.ring import AgainError, Fraction, Ring, UndefinedError
from tresym.reals.normal.sign_equations import SignEquations
from tresym.reals.normal.sign_proofs import SignProver
from tresym.reals.normal.special_forms import exponential, reduced
from tresym.reals.numbers.factoring import TooLargeError

ALL_THEORIES = frozenset({"roots", "trigonometry", "exponentials", "inverses"})

MAX_PASSES = 40


class Field:
    """Normal forms under the conditions ``given``, with the functions of ``theories`` interpreted.

    Attributes:
        ring: the tower of generators.
        given: the conditions.
        signs: proves signs of polynomials in the generators.
        equations: the signs of factors that are learnt.
        powers: roots, exponentials and logarithms.
        angles: cosines and sines.

    Example:
        >>> from tresym.reals.language.expression import apply, symbol
        >>> x = symbol("x")
        >>> (value,) = Field(Given()).normal(apply("sin", x) ** 2 + apply("cos", x) ** 2 - 1)
        >>> value.num.is_zero()
        True
    """

    def __init__(
        self,
        given: Given,
        theories: frozenset[str] = ALL_THEORIES,
        size: int = 24,
        points: Callable[[], Iterable[Mapping[str, fmpq]]] = tuple,
    ):
        """Create a field without generators.

        Args:
            given: the conditions.
            theories: the names of function families that are interpreted, see :data:`ALL_THEORIES`.
            size: the maximal number of generators.
            points: a function that yields points of the domain, used to skip hopeless proofs of
                signs.
        """
        self.given = given
        self.theories = theories
        self.ring = Ring(size)
        self.signs = SignProver(self.ring, given, points)
        self.equations = SignEquations(self.signs)
        self.powers = Powers(self.equations)
        self.angles = Angles(self.powers)
        self._memo: dict[Expr, Fraction] = {}

    def normal(self, *expressions: Expr) -> list[Fraction]:
        """Return the normal forms of ``expressions`` on their common domain and under ``given``.

        Raises:
            UndefinedError: one of them is nowhere defined.
            TooLargeError: a normal form has more terms or generators than allowed.
        """
        for _ in range(MAX_PASSES):
            self._memo.clear()
            self.equations.begin_pass()
            try:
                for condition in self.given.beyond_box:
                    value = self._walk(condition.expression)
                    if condition.relation != "!=":
                        self.equations.require_positive(value, strict=condition.relation == ">")
                result = [self._walk(e) for e in expressions]
            except AgainError:
                continue
            except (TooLargeError, UndefinedError):
                if not self.equations.learn():
                    raise
                continue
            if not self.equations.learn() or self._are_equal(result):
                return result
        raise TooLargeError(f"a normal form that still changes after {MAX_PASSES} passes")

    def _are_equal(self, values: list[Fraction]) -> bool:
        """Return whether ``values`` are two equal ones, which nothing learnt later can change."""
        return len(values) == 2 and (values[0] - values[1]).num.is_zero()

    def _walk(self, node: Expr) -> Fraction:
        value = self._memo.get(node)
        if value is None:
            value = self._node(node)
            self._memo[node] = value
        return value

    def _node(self, node: Expr) -> Fraction:
        op, args = node.op, node.args
        if op == "number":
            return self.ring.fraction(args[0])
        if op == "symbol":
            return self.ring.fraction(self.ring.symbol(args[0]))
        if op == "pi":
            return self.ring.fraction(self.ring.generator("pi", None))
        if op == "^":
            return self._power(*args)
        if op in UNWORKED or op == "bound":
            raise TooLargeError("an operation that binds a variable, which has no normal form")
        if op in SPECIAL and (found := reduced(node)) is not None:
            return self._walk(found)
        if op == "exp" and (found := exponential(node)) is not None:
            return self._walk(found)
        values = [self._walk(arg) for arg in args]
        if op == "+":
            return sum(values, self.ring.zero)
        if op == "*":
            return prod(values[1:], start=values[0])
        if not TABLE[op].theory or not TABLE[op].theory <= self.theories:
            return self._opaque(op, *values)
        return self._angle(*values) if op == "atan2" else self._function(op, values[0])

    def _function(self, name: str, x: Fraction) -> Fraction:
        row = TABLE[name]
        if row.family == "trigonometric":
            return _quotient(name, *self.angles.turn(x))
        if row.family != "hyperbolic":
            own: Callable[[Fraction], Fraction] = getattr(self, f"_{name}_of")
            return own(x)
        y = self.powers.exp(x)
        z = 1 / y
        return _quotient(name.removesuffix("h"), (y + z) / 2, (y - z) / 2)

    def _power(self, base: Expr, exponent: Expr) -> Fraction:
        r = self.ring.rational(self._walk(exponent))
        if r is not None and r.q == 1 and r < 0 and base.op == "*":  # shorter, factor by factor
            return prod((self._walk(f) ** int(r.p) for f in base.args), start=self.ring.one)
        x = self._walk(base)
        if r is not None and r.q == 1:
            return x ** int(r.p)
        if r is not None:
            if "roots" not in self.theories:
                return self._opaque("^", x, self.ring.fraction(r))
            return self.powers.root(x, r)
        if "exponentials" not in self.theories:
            return self._opaque("^", x, self._walk(exponent))
        return self.powers.exp(self._walk(exponent) * self.powers.log(x))

    def _opaque(self, name: str, *args: Fraction) -> Fraction:
        """Return a generator for a function about which only the arguments are known."""
        key = (name, *(arg.key for arg in args))
        return self.ring.fraction(self.ring.generator("opaque", key, (name, *args)))

    # Inverse functions

    def _angle(self, y: Fraction, x: Fraction) -> Fraction:
        """Return ``atan2(y, x)``; whether y is 0 must be the same on the whole domain."""
        if y.num.is_zero():
            return self.angles.pi(fmpq(1, 2)) * (1 - self.equations.sign_function(1 / x))
        if self.ring.is_mixed(y.num):
            return self._opaque("atan2", y, x)
        if self.signs.product_sign(x.num) * self.signs.product_sign(x.den) > 0:
            return self.atan(y / x)
        side = self.signs.product_sign(y.num) * self.signs.product_sign(y.den)
        if side:
            return self.angles.pi(fmpq(side, 2)) - self.atan(x / y)
        return self.atan(y / (self.powers.root(x**2 + y**2, fmpq(1, 2)) + x)) * 2

    def atan(self, u: Fraction) -> Fraction:
        """Return ``atan u``, which is odd; atan(1/u) = ±π/2 − atan u selects one of u and 1/u."""
        if u.num.is_zero():
            return self.ring.zero
        special = self._special_atan(u)
        if special is not None:
            return special
        if u.num.leading_coefficient() < 0:
            return -self.atan(-u)
        signed = self.ring.sign_content(u)
        if signed is not None:
            return signed[0] * self.atan(signed[1])
        if not self.ring.is_mixed(u.num):
            inverse = 1 / u
            if self._rank(inverse) < self._rank(u):
                sign = self.equations.sign_function(u)
                return sign * self.angles.pi(fmpq(1, 2)) - self.atan(inverse)
        return self.ring.fraction(self.ring.generator("atan", u.key, (u,)))

    def _rank(self, u: Fraction) -> tuple[bool, int, int, str]:
        """Return a sort key that prefers, of u and 1/u, one without poles."""
        return not self.signs.product_sign(u.den), len(u.den), int(u.den.total_degree()), str(u.den)

    def _special_atan(self, u: Fraction) -> Fraction | None:
        """Return ``atan u`` if it is a multiple of π/12, else None."""
        if not self.ring.is_constant(u):
            return None
        value = self.ring.ball(u).atan() * 12 / arb.pi()
        k = value.unique_fmpz()
        if k is None or abs(k) >= 6:
            return None
        c, s = self.angles.turn_of_pi(fmpq(k, 12))
        if not (u - s / c).num.is_zero():
            return None
        return self.angles.pi(fmpq(k, 12))

    # The functions of one argument

    def _exp_of(self, x: Fraction) -> Fraction:
        return self.powers.exp(x)

    def _log_of(self, x: Fraction) -> Fraction:
        return self.powers.log(x)

    def _atan_of(self, x: Fraction) -> Fraction:
        return self.atan(x)

    def _sign_of(self, x: Fraction) -> Fraction:
        return self.equations.sign_function(x)

    def _abs_of(self, x: Fraction) -> Fraction:
        return x * self.equations.sign_function(x)

    def _cbrt_of(self, x: Fraction) -> Fraction:
        return self.powers.root(x, fmpq(1, 3), signed=True)

    def _acos_of(self, x: Fraction) -> Fraction:
        return self.angles.pi(fmpq(1, 2)) - self._asin_of(x)

    def _asin_of(self, u: Fraction) -> Fraction:
        below, above = 1 - u, 1 + u
        if below.num.is_zero() or above.num.is_zero():
            return self.angles.pi(fmpq(1 if below.num.is_zero() else -1, 2))
        self.equations.require_positive(below)
        self.equations.require_positive(above)
        c = self.powers.root(below * above, fmpq(1, 2))
        if self.ring.is_mixed(below.num) or self.ring.is_mixed(above.num):
            # c may be 0 on a region; 1 + c is not
            return self.atan(u / (1 + c)) * 2
        return self.atan(u / c)

    def _asinh_of(self, u: Fraction) -> Fraction:
        square = 1 + u**2
        self.equations.require_positive(square)
        return self.powers.log(u + self.powers.root(square, fmpq(1, 2)))

    def _acosh_of(self, u: Fraction) -> Fraction:
        below, above = u - 1, u + 1
        if below.num.is_zero():
            return self.ring.zero
        self.equations.require_positive(below)
        self.equations.require_positive(above)
        return self.powers.log(u + self.powers.root(below * above, fmpq(1, 2)))

    def _atanh_of(self, u: Fraction) -> Fraction:
        below, above = 1 - u, 1 + u
        return (self.powers.log(above) - self.powers.log(below)) / 2


def _quotient(name: str, c: Fraction, s: Fraction) -> Fraction:
    """Return sin, cos, tan, … from cosine and sine (circular or hyperbolic)."""
    match name:
        case "sin":
            return s
        case "cos":
            return c
        case "tan":
            return s / c
        case "cot":
            return c / s
        case "sec":
            return 1 / c
        case _:
            return 1 / s
