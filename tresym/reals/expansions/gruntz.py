"""Gruntz's algorithm: rewrite a function in its most rapidly varying subexpressions.

For u → ±∞, exp u becomes a product of powers of scale elements times the exponential of a bounded
function; a new element is added if none has this order of growth. log u is expanded in the elements
of u. sin u and cos u become functions of a phase about which nothing is assumed.

Example: e^(x + e^(−x)) − e^x for x → ∞. The most rapidly varying subexpression is w = e^(−x), which
becomes the first element of the scale; e^x is 1/w, and e^(x + w) is e^w/w, as w is bounded. The
expansion of e^w/w − 1/w in w begins with 1, so that the limit is 1.

Source: D. Gruntz, *On Computing Limits in a Symbolic Manipulation System*, thesis, ETH Zürich 1996,
chapters 3 and 4.
"""

from __future__ import annotations

from functools import reduce

from flint import fmpq

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.operation_domains import analytic_of
from tresym.reals.expansions.expansions import Expansions
from tresym.reals.expansions.scale import Leading, Scale, T, UnresolvedError
from tresym.reals.expansions.truncated_series import plus, quotient, times
from tresym.reals.functions.row import Function
from tresym.reals.functions.table import SPECIAL, TABLE
from tresym.reals.language.expression import (
    ONE,
    PI,
    ZERO,
    Expr,
    apply,
    as_expr,
    integer,
    multiply,
    number,
    off_the_cut,
    power,
    rebuild,
    sqrt,
    symbol,
    symbols,
    trees,
)
from tresym.reals.language.like_terms import collected
from tresym.reals.normal.special_forms import reduced, tidy
from tresym.reals.normal.to_expression import normal_form

MAX_ROUNDS = 8
MAX_TURNS = 60
CUBE_ROOT = number(fmpq(1, 3))


class _FinerPhaseError(Exception):
    """Two waves have arguments of a rational ratio: they are functions of one finer phase."""


class Rewritten:
    """Functions of the variable ``name`` → 0+ in one scale.

    Attributes:
        turns: the phase of a wave is its argument divided by this whole number, so that waves
            whose arguments have a rational ratio are functions of one phase.
    """

    def __init__(self, name: str, given: Given = Given(), turns: int = 1) -> None:  # noqa: B008
        """An empty scale; ``given`` speaks of parameters."""
        self.name, self.turns = name, turns
        self.scale = Scale(given)
        self.expansions = Expansions(self.scale)
        self.signed: set[Expr] = set()
        """What must keep its sign where the rewritten function stands for the function itself."""
        self.real = True
        """Whether all functions are real and finite where what is signed keeps its sign."""
        self._known: dict[Expr, Expr] = {}

    def all_of(self, *expressions: Expr) -> list[Expr]:
        """The expressions in the elements.

        Raises:
            UnresolvedError: a sign or a limit on the way is not found.
        """
        while True:
            try:
                return [self.of(e) for e in expressions]
            except _FinerPhaseError as error:
                turns = self.turns * error.args[0]
                if turns > MAX_TURNS:
                    raise UnresolvedError(
                        "the common period of the sines and cosines is too large"
                    ) from error
                self.__init__(self.name, self.scale.given, turns)  # type: ignore[misc]

    def of(self, e: Expr) -> Expr:
        """``e`` in the elements."""
        if self.name not in symbols(e):
            return e
        if e not in self._known:
            self._known[e] = self._rewritten(e)
        return self._known[e]

    def _rewritten(self, e: Expr) -> Expr:
        if e.op == "symbol":
            return symbol(T)
        if e.op == "atan2":
            y, x = map(self.of, e.args)
            self._way(sqrt(x**2 + y**2) + x)
            return self.of(off_the_cut(e))
        row = TABLE.get(e.op)
        if row and row.by_others:
            return self.of(row.by_others(*e.args, trees))
        if e.op in SPECIAL:
            return self._special(e)
        if e.names or e.op == "unknown":
            raise UnresolvedError(f"{e.op} has no expansion here")
        args = tuple(map(self.of, e.args))
        if e.op == "+":
            return collected(rebuild(e, args))
        if e.op == "*":
            return reduce(times, args)
        if e.op == "^":
            base, exponent = args
            if exponent.op != "number":
                return self._exp(times(exponent, self._log(base)))
            return self._power(base, exponent.args[0])
        return getattr(self, "_" + e.op)(*args)

    def _way(self, u: Expr) -> int:
        """The sign of u near t = 0, which must be the same on all of a range."""
        first = self.expansions.leading(u)
        if first is None:
            return 0
        found = self.scale.sign(first.coefficient)
        self.signed.add(u)
        return found

    def _power(self, base: Expr, r: fmpq) -> Expr:
        """The power, real and finite on a range if the sign of its base is that."""
        if r.q != 1 or r <= 0:
            try:
                way = self._way(base)
            except UnresolvedError:  # a wave, such as that of tan x
                self.real = False
            else:
                if (way == 0 and r <= 0) or (way < 0 and r.q != 1):
                    raise UnresolvedError("a power that is not a real number")
        return ONE if r == 0 else power(base, number(r))

    def _is_bounded(self, u: Expr) -> bool:
        """Whether u does not tend to ±∞; its leading coefficient may be a parameter."""
        try:
            return self.expansions.growth(u) <= 0
        except UnresolvedError:
            if isinstance(self.expansions.limit(u), int):
                raise
            return True

    # -- what tends to infinity -------------------------------------------------------------

    def _exp(self, u: Expr) -> Expr:
        found = ONE
        for _ in range(MAX_ROUNDS):
            fixed, rest = self._with_sign(u)
            if rest is None:
                return found if self.scale.is_zero(u) else multiply(found, apply("exp", u))
            steep = self.expansions.leading(rest)
            if steep is None or self.scale.phases(steep.coefficient):
                raise UnresolvedError("the exponential of an unbounded oscillation")
            w = self.scale.like(steep) or self._new(rest, steep)
            own = quotient(steep.coefficient, self.scale.steepness[w].coefficient)
            ratio = times(fixed, own)
            u = plus(u, multiply(-ratio, self.scale.heights[w]))
            found = multiply(found, Expr("^", (symbol(w), -ratio)))
        raise UnresolvedError("an exponent whose expansion does not terminate")

    def _with_sign(self, u: Expr) -> tuple[Expr, Expr | None]:
        """A constant of any sign and what tends to ±∞, whose product is ``u``; None if bounded."""
        try:
            return ONE, None if self._is_bounded(u) else u
        except UnresolvedError:
            parts = u.args if u.op == "*" else ()
            fixed = [part for part in parts if not self.scale.elements(part)]
            rest = multiply(*(part for part in parts if part not in fixed))
            if not fixed or self.expansions.growth(rest) <= 0:
                raise
            return multiply(*fixed), rest

    def _new(self, u: Expr, steep: Leading) -> str:
        """A new element for the part of ``u`` that is unbounded."""
        parts = [
            part for part in (u.args if u.op == "+" else (u,)) if self.expansions.growth(part) > 0
        ]
        height = collected(sum(parts[1:], parts[0])) if parts else u
        own = self.expansions.leading(height)
        if own is None or self.scale.compare(own.powers, steep.powers):
            height, own = u, steep
        scale = own.coefficient  # of exp(3/t) the element is exp(-1/t)
        height = collected(height / scale)
        return self.scale.insert(height, Leading(ONE, own.powers))

    def _log(self, u: Expr) -> Expr:
        first = self.expansions.leading(u)
        if first is None or self._way(u) <= 0:
            raise UnresolvedError("the logarithm of an expression that is not positive")
        terms = []
        for w, x in first.powers.items():
            if w not in self.scale.heights:
                raise UnresolvedError("logarithms are nested too deeply")
            u = times(u, power(symbol(w), -x))
            terms.append(multiply(-x, self.scale.heights[w]))
        return sum(terms, ZERO if u == ONE else apply("log", u))

    def _wave(self, u: Expr) -> Expr:
        """``u``, or what is equal to it modulo 2π as long as its phase is not known."""
        if self._is_bounded(u):
            return u
        for k, other in enumerate(self.scale.waves):
            first, steep = self.expansions.leading(other), self.expansions.leading(u)
            if first is None or steep is None or self.scale.compare(first.powers, steep.powers):
                continue
            ratio = quotient(steep.coefficient, first.coefficient)
            if ratio.op != "number" and not symbols(ratio):
                ratio = normal_form(ratio, Given())
            rest = plus(u, -ratio * other)
            if ratio.op != "number" or self.expansions.growth(rest) > 0:
                continue
            if ratio.args[0].q != 1:
                raise _FinerPhaseError(int(ratio.args[0].q))
            return ratio * symbol(f"_u{k}") + (ZERO if self.scale.is_zero(rest) else rest)
        return self.turns * self.scale.wave(u / self.turns)

    # -- special functions ------------------------------------------------------------------

    def _special(self, e: Expr) -> Expr:
        """A special function: as it is where it is analytic, else by a formula of its row."""
        row, parameters = TABLE[e.op], e.args[:-1]
        if any(self.name in symbols(parameter) for parameter in parameters):
            raise UnresolvedError(f"{e.op} in an argument other than the last")
        u = self.of(e.args[-1])
        if row.internal and row.remainder is not None:
            return Expr(e.op, (*parameters, u))  # regular where it is used
        end = self.expansions.limit(u)
        if isinstance(end, int):
            self._way(u)
            found = self._near(row, "oo" if end > 0 else "-oo", e)
            if found is None:
                raise UnresolvedError(f"the behaviour of {e.op} at infinity is not known")
            return self.of(found)
        for place in row.near:
            if place[0].isdigit() and self.scale.is_zero(end - number(int(place[:-1]))):
                side = self._way(u - int(place[:-1]))
                found = self._near(row, f"{place[:-1]}{'+' if side > 0 else '-'}", e)
                if found is not None:
                    return self.of(found)
        n = integer(normal_form(end, Given())) if row.poles and row.raising else None
        if n is not None and n <= 0 and row.raising:
            self._way(u - n)
            return self.of(tidy(as_expr(row.raising(*e.args, trees))))
        at = Expr(e.op, (*parameters, end))
        for part, relation in analytic_of(at):
            side = self.scale.sign(part)
            if side == 0 or (side < 0 and relation == ">"):
                found = reduced(e)
                if found is None:
                    raise UnresolvedError(f"{e.op} is not analytic at the limit of its argument")
                return self.of(found)
        return Expr(e.op, (*parameters, u))

    def _near(self, row: Function, place: str, e: Expr) -> Expr | None:
        """The formula of a row near a place, or the function by its recurrence."""
        formula = row.near.get(place)
        if formula and row.near_needs is not None and "oo" not in place:
            needed = row.near_needs(*e.args, trees)
            if needed is not None and self.scale.sign(needed) <= 0:
                raise UnresolvedError(f"{needed} could not be shown to be positive")
        found = formula(*e.args, trees) if formula else None
        return reduced(e) if found is None else as_expr(found)

    # -- functions -----------------------------------------------------------------------------

    def _sin(self, u: Expr) -> Expr:
        return apply("sin", self._wave(u))

    def _cos(self, u: Expr) -> Expr:
        return apply("cos", self._wave(u))

    def _atan(self, u: Expr) -> Expr:
        if self._is_bounded(u):
            return apply("atan", u)
        return self._way(u) * PI / 2 - apply("atan", 1 / u)

    def _abs(self, u: Expr) -> Expr:
        try:
            return self._way(u) * u
        except UnresolvedError:
            return apply("abs", u)

    def _sign(self, u: Expr) -> Expr:
        return number(self._way(u))

    def _cbrt(self, u: Expr) -> Expr:
        sign = self._way(u)
        return sign * power(sign * u, CUBE_ROOT) if sign else ZERO
