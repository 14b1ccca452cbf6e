"""The limit of an expression with parameters as t → 0+, exactly.

An expression is t^m g after its powers of t are taken out of it, which t > 0 allows; t is replaced
by a power of it where m would be a fraction. Then

- what is continuous at 0 has its value as limit;
- limits are added, multiplied and put into functions, where that is no indeterminate form;
- N/D with N and D analytic at 0 has the limit of the quotient of their first derivatives of one
  order that do not both vanish (Taylor's theorem);
- exp(−c/t^r) vanishes beyond all powers of t and of logarithms, and t^p beyond those of logarithms.

What is not shown by these rules has no limit here: the answer is None. Signs of what is free of t
are those that :func:`tresym.reals.signs.sign.sign` proves under the conditions.
"""

from __future__ import annotations

from collections.abc import Iterable
from math import lcm

from flint import fmpq

from tresym.reals.decisions.simple import tidied
from tresym.reals.language.expression import (
    LEAVES,
    MINUS_ONE,
    ONE,
    PI,
    ZERO,
    Expr,
    add,
    apply,
    differentiate,
    multiply,
    number,
    power,
    rebuild,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.parsing import INFINITY
from tresym.reals.numbers.exact import InputError
from tresym.reals.places.conditions import Given
from tresym.reals.places.domain import singularities
from tresym.reals.signs.defined import continuous_on, undefined
from tresym.reals.signs.inside import PROVING, is_zero
from tresym.reals.signs.sign import sign

T = symbol("_t")
MINUS_INFINITY = -INFINITY
MOST_TERMS = 8
"""How often numerator and denominator are differentiated."""
MAX_SIZE = 2000
NEAR = number(fmpq(1, 1000))
"""What is asked of small t is asked up to there."""
_QUOTIENTS = {"tan": ("sin", "cos"), "cot": ("cos", "sin"), "sec": ("", "cos"), "csc": ("", "sin")}
_JUMPING = ("sign", "atan2")
_AT_INFINITY = {
    "exp": (INFINITY, ZERO),
    "atan": (PI / 2, -PI / 2),
    "tanh": (ONE, MINUS_ONE),
    "sinh": (INFINITY, MINUS_INFINITY),
    "asinh": (INFINITY, MINUS_INFINITY),
    "cosh": (INFINITY, INFINITY),
    "abs": (INFINITY, INFINITY),
    "cbrt": (INFINITY, MINUS_INFINITY),
}
"""The limits of functions as their argument goes to oo and to −oo."""


def limit_of(e: Expr, name: str, point: Expr | None, side: int, given: Given) -> Expr | None:
    """The limit of ``e`` on a path, ``oo`` and ``-oo`` among the values; None where none is shown.

    Args:
        name: the variable.
        point: where it goes, which may hold parameters; None for infinity.
        side: +1 from above or to +∞, −1 from below or to −∞.
        given: conditions on the parameters, which are fixed.
    """
    along = side / T if point is None else point + side * T
    try:
        found = _Approach(given).limit(in_powers(substitute(e, {name: along})))
        return None if found is None else tidied(found)
    except InputError:  # an expression on the way is too large
        return None


def in_powers(e: Expr) -> Expr:
    """``e`` for t > 0 with the powers of t taken out, and t a power of itself so they are whole."""
    found = {fmpq(1)}
    _taken_out(e, found, 1)
    whole = lcm(*(int(m.q) for m in found))
    m, g = _taken_out(e, set(), whole)
    return multiply(_power_of_t(m), g)


def _taken_out(e: Expr, found: set[fmpq], whole: int) -> tuple[fmpq, Expr]:
    """m and g with e(t^whole) = t^m g."""
    if e == T:
        return fmpq(whole), ONE
    if e.op in LEAVES or T.args[0] not in symbols(e):
        return fmpq(0), e
    parts = [_taken_out(arg, found, whole) for arg in e.args]
    if e.op == "*":
        return sum((m for m, _ in parts), fmpq(0)), multiply(*(g for _, g in parts))
    if e.op == "+":
        least = min(m for m, _ in parts)
        return least, add(*(multiply(_power_of_t(m - least), g) for m, g in parts))
    if e.op == "^" and e.args[1].op == "number":
        (m, g), r = parts[0], e.args[1].args[0]
        found.add(m * r)
        if g.op == "^" and g.args[0] == T:
            return m * r, power(T, multiply(e.args[1], g.args[1]))
        return m * r, power(g, e.args[1])
    if e.op == "atan" and parts[0][0] < 0 and parts[0][1].op == "number":
        m, g = parts[0]  # atan u is a right angle less atan 1/u
        turn = PI / 2 if g.args[0] > 0 else -PI / 2
        return fmpq(0), turn - apply("atan", multiply(_power_of_t(-m), 1 / g))
    args = [multiply(_power_of_t(m), g) for m, g in parts]
    if e.op == "^" and parts[0][1] == ONE:  # t^m to a power that is no number
        return fmpq(0), power(T, multiply(number(parts[0][0]), args[1]))
    return fmpq(0), rebuild(e, tuple(args))


def _power_of_t(m: fmpq) -> Expr:
    return ONE if m == 0 else power(T, number(m))


class _Approach:
    """Limits as t → 0+ under conditions on what else occurs."""

    def __init__(self, given: Given) -> None:
        self.given = given
        self.beside = given & Given(((T, ">", ZERO), (T, "<", NEAR)))
        self.known: dict[Expr, Expr | None] = {}

    def limit(self, e: Expr) -> Expr | None:
        """The limit of ``e``, whose powers of t have been taken out."""
        if e not in self.known:
            self.known[e] = None  # what leads back to itself has no answer
            self.known[e] = None if e.size > MAX_SIZE else self._limit(e)
        return self.known[e]

    def _limit(self, e: Expr) -> Expr | None:
        if T.args[0] not in symbols(e):
            return e if undefined(e, self.given) is None else None
        value = self._by_continuity(e)
        if value is None:
            rule = {"+": self._sum, "*": self._product, "^": self._power}.get(e.op, self._function)
            value = rule(e)
        if value is None and e.op in ("+", "*"):
            value = self._by_taylor(*_fraction(e))
        if value is None and e.op in ("*", "^"):
            value = self._by_dominance(_factors(e))
        return self._distributed(e) if value is None and e.op == "*" else value

    def _by_continuity(self, e: Expr) -> Expr | None:
        at = {T.args[0]: ZERO}
        for part, positive in singularities(e):  # of e itself: 0**0 is 1 where it is put in
            relation = ">" if positive else "!="
            if sign(substitute(part, at), self.given, relation) not in PROVING[relation]:
                return None
        return substitute(e, at)

    def _sum(self, e: Expr) -> Expr | None:
        values = [self.limit(arg) for arg in e.args]
        ends = {value for value in values if _is_infinite(value)}
        if None in values or len(ends) > 1:
            return self._of_logarithms(e.args)
        return ends.pop() if ends else add(*(value for value in values if value is not None))

    def _of_logarithms(self, terms: tuple[Expr, ...]) -> Expr | None:
        """The limit of a sum of which the logarithms, joined to one, have a limit."""
        scaled: dict[Expr, list[tuple[Expr, fmpq]]] = {}
        rest = []
        for term in terms:
            factors = _factors(term)
            logs = [factor for factor in factors if factor.op == "log"]
            if len(logs) == 1 and self._sign_beside(logs[0].args[0]) == 1:
                plain = (factor for factor in factors if factor.op not in ("log", "number"))
                sizes = [factor.args[0] for factor in factors if factor.op == "number"]
                size = sizes[0] if sizes else fmpq(1)
                scaled.setdefault(multiply(*plain), []).append((logs[0].args[0], size))
            else:
                rest.append(term)
        if not scaled or max(map(len, scaled.values())) < 2:
            return None
        joined = []
        for scale, parts in scaled.items():
            whole = lcm(*(int(size.q) for _, size in parts))
            inner = multiply(*(power(u, number(size * whole)) for u, size in parts))
            joined.append(
                multiply(number(fmpq(1, whole)), scale, apply("log", in_powers_of(inner)))
            )
        values = [self.limit(part) for part in (*rest, *joined)]
        known = [value for value in values if value is not None and not _is_infinite(value)]
        return add(*known) if len(known) == len(values) else None

    def _product(self, e: Expr) -> Expr | None:
        values = [self.limit(arg) for arg in e.args]
        if any(
            value is not None and not _is_infinite(value) and self._is_zero(value)
            for value in values
        ) and all(self._is_bounded(arg, value) for arg, value in zip(e.args, values, strict=True)):
            return ZERO
        known = [value for value in values if value is not None]
        if len(known) < len(values):
            return None
        if not any(map(_is_infinite, known)):
            return multiply(*known)
        signs = [self._sign(value) for value in known]
        if not set(signs) <= {1, -1}:
            return None
        return INFINITY if signs.count(-1) % 2 == 0 else MINUS_INFINITY

    def _distributed(self, e: Expr) -> Expr | None:
        """The limit of a product with a sum in it, term by term."""
        (inner, *_), others = [*(a for a in e.args if a.op == "+"), None], list(e.args)
        if inner is None:
            return None
        others.remove(inner)
        return self._sum(Expr("+", tuple(multiply(*others, term) for term in inner.args)))

    def _is_bounded(self, e: Expr, value: Expr | None) -> bool:
        if value is not None:
            return not _is_infinite(value)
        return e.op in ("sin", "cos") and undefined(e, self.beside) is None

    def _power(self, e: Expr) -> Expr | None:
        base, exponent = e.args
        if exponent.op != "number":
            if T.args[0] not in symbols(base) and self._sign(base) != 1:
                return None
            return self._function(apply("exp", in_powers_product(exponent, base)))
        value, r = self.limit(base), exponent.args[0]
        if value is None:
            return None
        odd = -1 if r.p % 2 else 1
        if value == INFINITY:
            return INFINITY if r > 0 else ZERO
        if value == MINUS_INFINITY:
            return None if r.q != 1 else ZERO if r < 0 else INFINITY if odd > 0 else value
        at = self._sign(value)
        if at == 1 or (r.q == 1 and (at == -1 or r > 0)):
            return power(value, exponent)
        if at != 0:
            return None
        beside = self._sign_beside(base)
        if beside == 1 or (beside == -1 and r.q == 1):
            far = INFINITY if beside == 1 or odd > 0 else MINUS_INFINITY
            return ZERO if r > 0 else far
        return None

    def _function(self, e: Expr) -> Expr | None:
        if len(e.args) != 1:
            return None
        if e.op in _QUOTIENTS:
            parts = [apply(name, e.args[0]) if name else ONE for name in _QUOTIENTS[e.op]]
            return self._by_taylor(*parts)
        value = self.limit(e.args[0])
        if value is None:
            return None
        if e.op == "log" and value == INFINITY:
            return INFINITY
        if e.op == "log" and self._sign(value) == 0:
            return MINUS_INFINITY if self._sign_beside(e.args[0]) == 1 else None
        if _is_infinite(value):
            ends = _AT_INFINITY.get(e.op)
            return None if ends is None else ends[value == MINUS_INFINITY]
        image = rebuild(e, (value,))
        if continuous_on(image, self.given) is None:
            return image
        # it is continuous where it is real, and real on the way and at its end
        real = undefined(image, self.given) is None and undefined(e, self.beside) is None
        return image if real and e.op not in _JUMPING else None

    def _by_taylor(self, above: Expr, below: Expr) -> Expr | None:
        """The limit of a quotient of functions that are analytic at 0."""
        if any(self._by_continuity(part) is None for part in (above, below)):
            return None
        for _ in range(MOST_TERMS):
            n, d = (substitute(part, {T.args[0]: ZERO}) for part in (above, below))
            at = self._sign(d)
            if at in (1, -1):
                return n / d
            if at != 0:
                return None
            if not self._is_zero(n):
                ahead, under = self._sign(n), self._sign_beside(below)
                if ahead in (1, -1) and under in (1, -1):
                    return INFINITY if ahead == under else MINUS_INFINITY
                return None
            above, below = (differentiate(part, T.args[0]) for part in (above, below))
            if max(above.size, below.size) > MAX_SIZE:
                return None
        return None

    def _by_dominance(self, factors: Iterable[Expr]) -> Expr | None:
        """The limit of a product of an exponential, powers of t and of logarithms, and more."""
        exponents: list[Expr] = []
        powers: list[Expr] = []
        others: list[Expr] = []
        for factor in factors:
            base, exponent = factor.args if factor.op == "^" else (factor, ONE)
            if factor.op == "exp":
                exponents.append(factor.args[0])
            elif base.op == "exp" and exponent.op == "number":
                exponents.append(multiply(exponent, base.args[0]))
            elif base == T and T.args[0] not in symbols(exponent):
                powers.append(exponent)
            elif exponent.op != "number":
                exponents.append(in_powers_product(exponent, base))
            elif not (base.op == "log" and self._is_logarithmic(base) and _is_natural(exponent)):
                others.append(factor)
        if any(self._is_unbounded(factor) for factor in others):
            return None
        exponent = in_powers(add(*exponents))
        far, strength = self.limit(exponent), add(*powers)
        if far is not None and not _is_infinite(far):
            return ZERO if self._sign(strength) == 1 else None
        if far == MINUS_INFINITY and self._is_power(exponent):
            return ZERO
        return None

    def _is_unbounded(self, e: Expr) -> bool:
        return not self._is_bounded(e, self.limit(e))

    def _is_logarithmic(self, e: Expr) -> bool:
        """Whether log u is at most a multiple of log t: u is t^m times what has a limit not 0."""
        _, g = _leading(e.args[0])
        value = self.limit(g)
        return value is not None and not _is_infinite(value) and self._sign(value) == 1

    def _is_power(self, e: Expr) -> bool:
        """Whether ``e`` is t^−r times what has a limit not 0, with r > 0."""
        m, g = _leading(e)
        value = self.limit(g)
        return m < 0 and value is not None and (_is_infinite(value) or self._sign(value) in (1, -1))

    def _is_zero(self, e: Expr) -> bool:
        return not _is_infinite(e) and (e == ZERO or is_zero(e, self.given))

    def _sign(self, e: Expr) -> int | None:
        """The proven sign of what is free of t, infinities among them; None where it is open."""
        if _is_infinite(e):
            return 1 if e == INFINITY else -1
        if self._is_zero(e):
            return 0
        return {"+": 1, "-": -1, "0": 0}.get(sign(e, self.given, "!=") or "")

    def _sign_beside(self, e: Expr) -> int | None:
        """The sign of ``e`` for small t > 0, if it is not 0 there."""
        found = {"+": 1, "-": -1}.get(sign(e, self.beside, dear=False) or "")
        if found is not None:
            return found
        _, g = _leading(e)
        value = self.limit(g)
        if value is None:
            return None
        if not _is_infinite(value) and self._is_zero(value) and self._by_continuity(g) is not None:
            for _ in range(MOST_TERMS):
                g = differentiate(g, T.args[0])
                if g.size > MAX_SIZE:
                    return None
                value = substitute(g, {T.args[0]: ZERO})
                if not self._is_zero(value):
                    break
        return self._sign(value) or None


def in_powers_of(e: Expr) -> Expr:
    """``e`` with its power of t in front; t stays as it is."""
    m, g = _leading(e)
    return multiply(_power_of_t(m), g)


def in_powers_product(exponent: Expr, base: Expr) -> Expr:
    """``exponent * log(base)``, the powers of t in front."""
    m, g = _leading(exponent)
    return multiply(_power_of_t(m), g, apply("log", base))


def _leading(e: Expr) -> tuple[fmpq, Expr]:
    return _taken_out(e, set(), 1)


def _is_natural(e: Expr) -> bool:
    return bool(e.op == "number" and e.args[0].q == 1 and e.args[0] > 0)


def _is_infinite(e: Expr | None) -> bool:
    return e in (INFINITY, MINUS_INFINITY)


def _factors(e: Expr) -> tuple[Expr, ...]:
    return e.args if e.op == "*" else (e,)


def _fraction(e: Expr) -> tuple[Expr, Expr]:
    """Numerator and denominator, sums brought to a common one."""
    if e.op == "*":
        parts = [_fraction(arg) for arg in e.args]
        return multiply(*(n for n, _ in parts)), multiply(*(d for _, d in parts))
    if e.op == "+":
        parts = [_fraction(arg) for arg in e.args]
        below = list(dict.fromkeys(d for _, d in parts if d != ONE))
        above = [multiply(n, *(d for d in below if d != own)) for n, own in parts]
        return add(*above), multiply(*below)
    if e.op == "^" and e.args[1].op == "number" and e.args[1].args[0].q == 1:
        n, d = _fraction(e.args[0])
        r = int(e.args[1].args[0].p)
        return (n**r, d**r) if r > 0 else (d**-r, n**-r)
    return e, ONE
