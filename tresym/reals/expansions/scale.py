"""An asymptotic scale: functions of t → 0+, each smaller than every power of the next.

Its elements are t, 1/log(1/t), 1/log log(1/t), …, and exponentials exp(−h), h → ∞, as they occur;
log(1/w) is called the height h of an element w. A product of powers of elements tends to 0, to ∞,
or equals 1; the exponent of the fastest element decides (G. H. Hardy, *Orders of Infinity*, 1910).
sin u and cos u with u → ±∞ are functions of a phase about which nothing is assumed.

Exponents are constants. Their signs are proved by balls, their vanishing by the normal form.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cmp_to_key
from itertools import pairwise
from math import prod
from typing import Any, NamedTuple, TypeAlias

from flint import arb

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.expression import (
    LEAVES,
    ONE,
    ZERO,
    Expr,
    apply,
    multiply,
    number,
    power,
    rebuild,
    symbol,
    symbols,
)
from tresym.reals.language.like_terms import collected
from tresym.reals.normal.field import ALL_THEORIES, Field
from tresym.reals.normal.locally_constant import equal_constants
from tresym.reals.normal.ring import UndefinedError
from tresym.reals.numbers.arithmetic import WORKING, ball_precision
from tresym.reals.numbers.factoring import TooLargeError
from tresym.reals.signs.sign import sign

Powers: TypeAlias = dict[str, Expr]
"""The exponents of a product of elements, none of them 0."""

T = "_t"
LOGARITHMS = tuple(f"_l{k}" for k in range(1, 7))
CHAIN = (T, *LOGARITHMS)
"""t and its iterated logarithms, the reciprocals of them; of the last the height is not known."""
MAX_ELEMENTS = 16
WHOLE_PERIOD = 4
SOMEWHERE = arb("0.0123"), arb("0.37")


class UnresolvedError(ArithmeticError):
    """A sign or a zero could not be determined, or the range is too long."""


class Leading(NamedTuple):
    """coefficient · Π element^power, to which a function is asymptotic; the coefficient not 0.

    Where the coefficient has phases of waves in it, the function is (coefficient + o(1)) · Π ….
    """

    coefficient: Expr
    powers: Powers


class Scale:
    """The elements met so far, the fastest first, and what was shown of them."""

    def __init__(self, given: Given = Given()) -> None:  # noqa: B008 - frozen
        """t and its logarithms alone; ``given`` speaks of parameters, which are fixed."""
        self.given = given
        self.order = list(CHAIN)
        self.heights = {w: 1 / symbol(v) for w, v in pairwise(CHAIN)}
        self.steepness = {w: Leading(ONE, {v: number(-1)}) for w, v in pairwise(CHAIN)}
        self.waves: list[Expr] = []
        """The arguments of waves: the phase ``_u0`` stands for the first modulo 2π."""
        self.leading: dict[Expr, Leading | None] = {}
        self._signs: dict[Expr, int] = {}
        self._zeros: dict[Expr, bool] = {}

    def elements(self, e: Expr) -> list[str]:
        """The elements in ``e``, the fastest first."""
        found = symbols(e)
        return [w for w in self.order if w in found]

    def phases(self, e: Expr) -> list[str]:
        """The phases of waves in ``e``."""
        return [name for k in range(len(self.waves)) if (name := f"_u{k}") in symbols(e)]

    # -- constants --------------------------------------------------------------------------

    def sign(self, c: Expr) -> int:
        """The sign of a constant, or of a function of phases that is the same for all phases.

        Raises:
            UnresolvedError: it is not shown.
        """
        if c.op == "number":
            return (c.args[0] > 0) - (c.args[0] < 0)
        if c not in self._signs:
            self._signs[c] = self._sign(c)
        return self._signs[c]

    def difference(self, c: Expr, d: Expr) -> int:
        """The sign of the difference of two constants."""
        if c.op == d.op == "number":
            x, y = c.args[0], d.args[0]
            return (x > y) - (x < y)
        return self.sign(c - d)

    def parameters(self, c: Expr) -> bool:
        """Whether there is more in a constant than numbers and phases."""
        return bool(symbols(c).difference(self.phases(c)))

    def _sign(self, c: Expr) -> int:
        if self.parameters(c):
            found = {"+": 1, "-": -1, "0": 0}.get(sign(c, self.given, "!=") or "")
            if self.phases(c) or found is None:
                raise UnresolvedError(f"the sign of {c} could not be determined")
            return found
        for bits in (WORKING, 8 * WORKING):
            with ball_precision(bits):
                value = self.ball(c)
            if value > 0 or value < 0:
                return 1 if value > 0 else -1
        if self.is_zero(c):
            return 0
        if c.op == "*":
            return prod(map(self.sign, c.args))
        if c.op == "^" and c.args[1].op == "number":  # its ball may be wider than its base's
            base, r = self.sign(c.args[0]), c.args[1].args[0]
            if base and (base > 0 or r.q == 1):
                return base if r.p % 2 else 1
        raise UnresolvedError(f"the sign of {c} could not be determined")

    def ball(self, c: Expr) -> arb:
        """The values of a constant, for all phases."""
        return evaluate(c, dict.fromkeys(self.phases(c), arb(0, WHOLE_PERIOD)))

    def is_zero(self, e: Expr) -> bool:
        """Whether ``e`` is shown to be 0 for all positive values of its elements."""
        if e.op == "number":
            return bool(e.args[0] == 0)
        if e not in self._zeros:
            self._zeros[e] = self._is_zero(e)
        return self._zeros[e]

    def _is_zero(self, e: Expr) -> bool:
        names = sorted(symbols(e))
        with ball_precision():
            value = evaluate(e, dict(zip(names, SOMEWHERE * len(names), strict=False)))
            if not value.contains(0):  # NaN contains 0
                return False
        if not names:
            return value.is_finite() and equal_constants(e, ZERO, ALL_THEORIES)
        positive = Given(tuple((symbol(w), ">", ZERO) for w in self.elements(e)))
        try:
            return bool(Field(self.given & positive).normal(e)[0].num.is_zero())
        except (TooLargeError, UndefinedError):
            return False

    # -- products of powers -----------------------------------------------------------------

    def times(self, p: Powers, q: Powers, sign: int = 1) -> Powers:
        """The product, or for ``sign`` −1 the quotient."""
        if not q or (not p and sign == 1):
            return q or p
        found = dict(p)
        for w, x in q.items():
            total = found.get(w, ZERO) + sign * x
            if self.sign(total):
                found[w] = total
            else:
                found.pop(w, None)
        return found

    def growth(self, p: Mapping[str, Expr]) -> int:
        """1 where the product tends to ∞, −1 where to 0, and 0 where it is 1."""
        return next((-self.sign(p[w]) for w in self.order if w in p), 0)

    def compare(self, p: Powers, q: Powers) -> int:
        """1 where p is of a larger order than q, −1 where of a smaller, 0 where of the same."""
        return self.growth(self.times(p, q, -1))

    def written(self, first: Leading, small: Expr, large: Expr) -> Expr:
        """A leading term as a function of t, which is ``small``, and 1/t, which is ``large``."""
        at = {T: (small, large)}
        for w in LOGARITHMS:
            large = apply("log", large)
            at[w] = 1 / large, large

        def walk(e: Expr) -> Expr:
            base, r = e.args if e.op == "^" else (e, ONE)
            if base.op != "symbol":
                return e if e.op in LEAVES else rebuild(e, tuple(map(walk, e.args)))
            (w,) = base.args
            if w in at:
                falls = r.op == "number" and r.args[0] < 0 and at[w][1].op != "^"
                return power(at[w][1], -r) if falls else power(at[w][0], r)
            if w not in self.heights:  # a parameter
                return e
            return apply("exp", collected(-r * walk(self.heights[w])))

        powers = (power(symbol(w), x) for w, x in first.powers.items())
        return multiply(walk(first.coefficient), *map(walk, powers))

    # -- new elements -----------------------------------------------------------------------

    def like(self, steep: Leading) -> str | None:
        """The element whose height is of the order of ``steep``."""
        for w, own in self.steepness.items():
            if own.powers == steep.powers or not self.compare(own.powers, steep.powers):
                return w
        return None

    def insert(self, height: Expr, steep: Leading) -> str:
        """A new element exp(−height), the height → ∞ like ``steep``."""
        if len(self.order) >= MAX_ELEMENTS:
            raise UnresolvedError("too many exponentials of different growth rates")
        name = f"_w{len(self.order)}"
        self.heights[name], self.steepness[name] = height, steep
        steepness: dict[Any, Leading] = self.steepness
        others = [w for w in self.order if w in self.steepness]
        known = sorted(
            [name, *others],
            key=cmp_to_key(lambda v, w: self.compare(steepness[w].powers, steepness[v].powers)),
        )
        self.order = [*known, *(w for w in self.order if w not in known)]
        return name

    def wave(self, argument: Expr) -> Expr:
        """The phase of a new wave."""
        self.waves.append(argument)
        return symbol(f"_u{len(self.waves) - 1}")
