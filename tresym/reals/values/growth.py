"""Bound an explicit function of t for all t from a number on: tails of integrals and of series.

A function is enclosed, at once for all t ≥ T, by a finite sum

    f(t) = B₁ m₁(t) + … + Bₙ mₙ(t),    m = exp(c₁ t^r₁ + …) · t^p · (log t)^q,

where the scales m are ordered by growth and the coefficients are balls: B(t) ∈ B for every t ≥ T.
Sums, products, powers, logarithms and exponentials of f(t) have the same form. A ratio of
scales that decreases from T on lies between 0 and its value at T, so small terms are folded into
larger ones. An analytic function of c + v(t), where v tends to 0, is its Taylor polynomial at c
with Lagrange's remainder over the range of v. Coefficients that are rational stay exact, so that a
leading term that cancels is seen to do so: sin(x)/x − 1 is O(x²) at 0.

The variable is t itself, or u = 1/t for an end at 0. On a disc |u| ≤ 1/T of complex numbers the
scales are whole powers of u and the ratio of two scales is a disc. A function that is bounded there
is analytic at 0 after all (Riemann), as sin(u)/u is.

Example: for 1/(exp(t) − 1) the sum is B·exp(−t) with B = [1, 1/(1 − exp(−T))].

The arguments are the ones of Hardy's logarithmico-exponential functions (G. H. Hardy, *Orders of
Infinity*, 1910). A leading coefficient that is an irrational number minus itself, and nested
logarithms, are beyond it; then no bound is given.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from contextlib import suppress
from functools import cmp_to_key
from typing import Any, NamedTuple

from flint import acb, acb_series, arb, arb_series, ctx, fmpq

from tresym.reals.domain.binder_values import jumps
from tresym.reals.domain.evaluation import UndefinedError, applied
from tresym.reals.language.expression import (
    UNWORKED,
    ZERO,
    Expr,
    apply,
    multiply,
    power,
    substitute,
    symbols,
)
from tresym.reals.values.exact_values import rational

KEPT = 4
"""The number of terms of a sum that are kept apart."""
TAYLOR = 4
"""The number of Taylor coefficients of an analytic function."""
EXACT_BITS = 512
"""A coefficient of at most this size that is exact stays a rational number."""

QUOTIENTS: dict[str, Callable[[Expr], Expr]] = {
    "tan": lambda x: apply("sin", x) / apply("cos", x),
    "cot": lambda x: apply("cos", x) / apply("sin", x),
    "sec": lambda x: 1 / apply("cos", x),
    "csc": lambda x: 1 / apply("sin", x),
}
"""Functions with poles, as quotients of functions without."""


class FartherError(UndefinedError):
    """Raised if the bounds hold only from a larger T on."""


class DivergesError(UndefinedError):
    """Raised if the integral to infinity is proved to diverge."""


class Scale(NamedTuple):
    """The function exp(Σ c t^r) t^p (log t)^q.

    Attributes:
        exps: pairs (r, c), r positive and decreasing, c not 0.
        p: the exponent of t.
        q: the exponent of log t.
    """

    exps: tuple[tuple[fmpq, Any], ...]
    p: Any
    q: Any

    def __mul__(self, other: Scale) -> Scale:  # type: ignore[override]
        found: dict[Any, Any] = {}
        for r, c in (*self.exps, *other.exps):
            key = (int(r.p), int(r.q))
            found[key] = found[key] + c if key in found else c
        exps = [(fmpq(*key), c) for key, c in found.items() if not _is_zero(c)]
        exps.sort(key=lambda pair: -float(pair[0].p) / float(pair[0].q))
        return Scale(tuple(exps), exact(self.p + other.p), exact(self.q + other.q))

    def __pow__(self, r: Any) -> Scale:
        exps = tuple((s, exact(c * r)) for s, c in self.exps)
        return Scale(exps, exact(self.p * r), exact(self.q * r))

    def growth(self) -> int:
        """Return 1 if it tends to infinity, −1 if it tends to 0, and 0 if it is 1.

        Raises:
            UndefinedError: a coefficient has no proved sign.
        """
        for c in (*(c for _, c in self.exps), self.p, self.q):
            if not _is_zero(c):
                return _sign(c)
        return 0


ONE = Scale((), fmpq(0), fmpq(0))


class Term(NamedTuple):
    """A coefficient in a ball times a scale; ``fixed`` if the coefficient does not depend on t."""

    coefficient: Any
    scale: Scale
    fixed: bool


Sum = tuple[Term, ...]


def exact(x: Any) -> Any:
    """Return an exact ball as a rational number, any other unchanged."""
    if isinstance(x, arb) and x.is_exact() and x.is_finite():
        mantissa, power = x.man_exp()
        if abs(int(power)) + int(abs(mantissa)).bit_length() < EXACT_BITS:
            return x.fmpq()
    return x


def _is_zero(x: Any) -> bool:
    return bool(x == 0) if isinstance(x, fmpq) else bool(x.is_zero())


def _sign(x: Any) -> int:
    if x > 0:
        return 1
    if x < 0:
        return -1
    raise UndefinedError


def _real_part(x: Any) -> Any:
    return x.real if isinstance(x, acb) else x


def _ball(x: Any) -> Any:
    return x if isinstance(x, arb | acb) else arb(x)


def _up_to(x: arb) -> arb:
    """Return the ball [0, x]."""
    return arb(0).union(x.upper())


class Growth:
    """The enclosure of expressions in one variable for all its values from ``start`` on."""

    def __init__(
        self,
        name: str,
        start: fmpq,
        known: Callable[[Expr], arb],
        at_zero: bool = False,
        disc: bool = False,
        turn: acb | None = None,
        vanishes: Callable[[Expr], bool] = lambda e: False,
    ) -> None:
        """Prepare the enclosure.

        Args:
            name: the variable.
            start: the number T, at least 3.
            known: the values of the parts without the variable.
            at_zero: whether the variable is 1/t rather than t.
            disc: whether 1/t stands for all complex numbers of that modulus.
            turn: a ball around points of the unit circle; the variable is then t times such a
                point, and the bounds hold for all of them.
            vanishes: decides whether an expression without the variable is exactly 0.
        """
        self.name, self.start, self.known = name, start, known
        self.at_zero, self.disc, self.turn, self.vanishes = at_zero, disc, turn, vanishes
        self.complex = disc or turn is not None
        self.top = arb(start)
        self.log = self.top.log()
        self.done: dict[Expr, Sum] = {}
        self.cuts: dict[tuple[int, int, int], tuple[arb, arb]] = {}

    # Scales

    def slope(self, m: Scale, start: arb | None = None) -> arb:
        """Return an upper bound of t·m′(t)/m(t) for t ≥ T, for a scale that does not grow.

        Raises:
            FartherError: exponentials do not dominate from T on.
        """
        top = self.top if start is None else start
        p = arb(0).max(m.p) if m.exps else m.p
        rest = p + (m.q / top.log() if m.q > 0 else 0)
        if not m.exps:
            return arb(rest)
        (r, c), *others = m.exps
        if _sign(c) > 0:
            return arb.pos_inf()
        lead = c * r
        for s, d in others:
            if not d < 0:
                lead += abs(d) * s * top ** (s - r)
        if not lead < 0:
            raise FartherError
        return lead * top**r + rest

    def at_start(self, m: Scale, start: arb | None = None) -> arb:
        """Return the value of a scale at T."""
        top = self.top if start is None else start
        found = arb(1)
        for r, c in m.exps:
            found *= (c * top**r).exp()
        if not _is_zero(m.p):
            found *= top**m.p
        if not _is_zero(m.q):
            found *= top.log() ** m.q
        return found

    def ratio(self, small: Scale, large: Scale) -> arb:
        """Return the ball of small/large for all t ≥ T."""
        m = small * large**-1
        if m == ONE:
            return arb(1)
        if m.growth() > 0:
            raise UndefinedError
        if not self.slope(m) <= 0:
            raise FartherError
        most = _up_to(self.at_start(m))
        return _disc(most) if self.disc else most

    # Sums

    def sum(self, terms: Iterable[Term]) -> Sum:
        """Return the terms joined by scale, ordered by growth, small ones folded into larger."""
        found: dict[Any, Term] = {}
        for term in terms:
            key = _key(term.scale)
            if key in found:
                other = found[key]
                total = exact(term.coefficient + other.coefficient)
                term = Term(total, term.scale, term.fixed and other.fixed)
            found[key] = term
        kept = [t for t in found.values() if not _is_zero(t.coefficient)]
        kept.sort(key=cmp_to_key(_larger_first))
        if len(kept) > KEPT:
            first, last = kept[: KEPT - 1], kept[KEPT - 1]
            total = _ball(last.coefficient)
            for t in kept[KEPT:]:
                total += t.coefficient * self.ratio(t.scale, last.scale)
            kept = [*first, Term(total, last.scale, False)]
        return tuple(kept)

    def product(self, f: Sum, g: Sum) -> Sum:
        """Return the product of two sums."""
        return self.sum(
            Term(exact(x.coefficient * y.coefficient), x.scale * y.scale, x.fixed and y.fixed)
            for x in f
            for y in g
        )

    def scaled(self, factor: Any, f: Sum) -> Sum:
        """Return a number times a sum."""
        return self.sum(Term(exact(factor * c), m, fixed) for c, m, fixed in f)

    def range(self, f: Sum) -> Any:
        """Return the ball of all values of a sum whose terms do not grow."""
        total: Any = arb(0)
        for c, m, _ in f:
            total += c * self.ratio(m, ONE)
        return total

    def lead(self, f: Sum) -> tuple[Any, Scale]:
        """Return a sum as one coefficient times the scale that dominates."""
        if not f:
            raise UndefinedError
        total: Any = _ball(f[0].coefficient)
        for c, m, _ in f[1:]:
            total += c * self.ratio(m, f[0].scale)
        return total, f[0].scale

    def parted(self, f: Sum) -> tuple[list[Term], Term, Sum]:
        """Return the terms that grow, the constant term, and those that tend to 0."""
        large = [t for t in f if t.scale.growth() > 0]
        constant = next((t for t in f if t.scale == ONE), Term(fmpq(0), ONE, True))
        return large, constant, tuple(t for t in f if t.scale.growth() < 0)

    # Functions

    def terms(self, e: Expr) -> Sum:
        """Return the enclosure of an expression.

        Raises:
            UndefinedError: none is found, or the expression is not proved to be defined.
            FartherError: none is found from this T on; try a larger one.
        """
        if e not in self.done:
            self.done[e] = self._cancelled(e, self._terms(e))
        return self.done[e]

    def _terms(self, e: Expr) -> Sum:
        if e.op == "symbol" and e.args[0] == self.name:
            one = fmpq(1) if self.turn is None else self.turn
            place = Scale((), fmpq(-1 if self.at_zero else 1), fmpq(0))
            return (Term(one, place, self.turn is None),)
        if self.name not in symbols(e):
            value = rational(e)
            return self.sum([Term(exact(self.known(e)) if value is None else value, ONE, True)])
        if e.op in UNWORKED:
            raise UndefinedError
        if e.op == "+":
            return self.sum(t for arg in e.args for t in self.terms(arg))
        if e.op == "*":
            found: Sum = (Term(fmpq(1), ONE, True),)
            for arg in e.args:
                found = self.product(found, self.terms(arg))
            return found
        if e.op == "^":
            if e.args[1].op == "number":
                if self.complex and e.args[0].op == "*" and e.args[1].args[0].q == 1:
                    return self.terms(multiply(*(power(f, e.args[1]) for f in e.args[0].args)))
                return self._power(self.terms(e.args[0]), e.args[1].args[0])
            return self._exp(self.product(self.terms(e.args[1]), self._log(self.terms(e.args[0]))))
        if e.op in QUOTIENTS:
            return self.terms(QUOTIENTS[e.op](e.args[0]))
        return self._function(e.op, *map(self.terms, e.args))

    def _cancelled(self, e: Expr, f: Sum) -> Sum:
        """Return a sum without its constant term, if that is exactly 0 and balls do not show it."""
        if not self.at_zero or not f or f[0].scale != ONE or not f[0].fixed:
            return f
        c = f[0].coefficient
        if isinstance(c, fmpq) or not c.contains(0) or jumps(e):
            return f
        return f[1:] if self.vanishes(substitute(e, {self.name: ZERO})) else f

    def _function(self, name: str, *args: Sum) -> Sum:
        f = args[0]
        match name:
            case "exp":
                return self._exp(f)
            case "log":
                return self._log(f)
            case "sinh" | "cosh" | "tanh" | "coth" | "sech" | "csch":
                return self._hyperbolic(name, f)
            case "abs" | "sign":
                c, m = self.lead(f)
                if self.complex:
                    raise UndefinedError
                if c > 0 or c < 0:
                    side = fmpq(1 if c > 0 else -1)
                    return (Term(side, ONE, True),) if name == "sign" else self.scaled(side, f)
                if name == "sign":
                    return (Term(arb(0, 1), ONE, False),)
                return (Term(abs(c), m, False),)
            case "cbrt" if not self.complex:
                side = _sign(self.lead(f)[0])
                root = self._power(self.scaled(fmpq(side), f), fmpq(1, 3))
                return self.scaled(fmpq(side), root)
        large, constant, small = self.parted(f) if len(args) == 1 else ([], None, ())
        if constant is None:
            raise UndefinedError
        if large:
            return self._of_large(name, f)
        if name in ("sin", "cos", "tan", "atan", "asin", "acos"):
            try:
                return self._taylor(name, constant, small)
            except FartherError:
                raise
            except UndefinedError:
                pass
        if self.complex:
            raise UndefinedError
        value = applied(name, _ball(constant.coefficient) + self.range(small))
        if not value.is_finite():
            raise FartherError
        return self.sum([Term(value, ONE, constant.fixed and not small)])

    def _of_large(self, name: str, f: Sum) -> Sum:
        """Return a function of an argument that tends to infinity."""
        if not self.complex and name in ("sin", "cos", "erf", "erfc"):
            return (Term(arb(1, 1) if name == "erfc" else arb(0, 1), ONE, False),)
        if not self.complex and name == "atan":
            c, _ = self.lead(f)
            inverse = self._function("atan", self._power(f, fmpq(-1)))
            half = Term(_sign(c) * arb.pi() / 2, ONE, True)
            return self.sum([half, *self.scaled(fmpq(-1), inverse)])
        if not self.complex and name in ("asinh", "acosh"):
            side = fmpq(_sign(self.lead(f)[0]))
            g = self.scaled(side, f)
            square = self.sum(
                [*self.product(g, g), Term(fmpq(1 if name == "asinh" else -1), ONE, True)]
            )
            return self.scaled(side, self._log(self.sum([*g, *self._power(square, fmpq(1, 2))])))
        raise UndefinedError

    def _taylor(self, name: str, constant: Term, v: Sum) -> Sum:
        """Return name(c + v) by Taylor's polynomial at c, with Lagrange's remainder."""
        c = _ball(constant.coefficient)
        if isinstance(c, acb):
            raise UndefinedError
        if name in ("asin", "acos") and not abs(c) < 1:
            return self._at_branch_point(name, constant, v)
        if not v:
            value = applied(name, c)
            if not value.is_finite():
                raise UndefinedError
            return self.sum([Term(exact(value), ONE, constant.fixed)])
        around = c + self.range(v)
        known = [Term(exact(a), ONE, constant.fixed) for a in _coefficients(name, c, TAYLOR)]
        last = _coefficients(name, around, TAYLOR + 1)[TAYLOR]
        if not last.is_finite():
            raise FartherError
        last = _disc(last) if self.complex else last
        return self._composed([*known, Term(last, ONE, False)], v)

    def _at_branch_point(self, name: str, constant: Term, v: Sum) -> Sum:
        """Return acos(1 − w) as 2 asin √(w/2), and what follows for asin and at −1."""
        side = constant.coefficient
        if not (isinstance(side, fmpq) and abs(side) == 1):
            raise UndefinedError
        half = self._power(self.scaled(-side / 2, v), fmpq(1, 2)) if v else ()
        arc = self.scaled(fmpq(2), self._function("asin", half))
        if name == "acos" and side == 1:
            return arc
        turn = Term(arb.pi() if name == "acos" else side * arb.pi() / 2, ONE, True)
        return self.sum([turn, *self.scaled(fmpq(-1) if name == "acos" else -side, arc)])

    def _composed(self, coefficients: list[Term], v: Sum) -> Sum:
        """Return Σ aₖ vᵏ by Horner's rule."""
        found: Sum = ()
        for a in reversed(coefficients):
            found = self.sum([*self.product(found, v), a])
        return found

    def _exp(self, f: Sum) -> Sum:
        large, constant, v = self.parted(f)
        if large and self.disc:
            raise UndefinedError
        if any(isinstance(t.coefficient, acb) for t in large):
            return self._exp_bound(f)
        scale, factor, fixed = ONE, arb(1), True
        for c, m, is_fixed in large:
            if m.exps or (m.q != 0 and (m.p != 0 or m.q != 1)):
                if len(large) > 1 or not c < 0:
                    raise UndefinedError
                # exp(−c m) ≤ exp(−c t²) where t² ≤ m
                square = Scale((), fmpq(2), fmpq(0))
                if not self.ratio(square, m) <= 1:
                    raise FartherError
                m = square
                is_fixed = False
            number, exponent = c, m.p
            if not is_fixed:
                number, factor, fixed = exact(arb(c).upper()), _up_to(arb(1)) * factor, False
            if _is_zero(number):
                continue
            if m.q != 0:
                scale *= Scale((), number, fmpq(0))
            elif isinstance(exponent, fmpq):
                scale *= Scale(((exponent, number),), fmpq(0), fmpq(0))
            else:
                raise UndefinedError
        front = constant.coefficient
        value = factor if _is_zero(front) else _ball(front).exp() * factor
        head = Term(exact(value), scale, fixed and constant.fixed)
        if not v:
            return self.sum([head])
        return self.product((head,), self._exp_taylor(v))

    def _exp_taylor(self, v: Sum) -> Sum:
        a = [Term(fmpq(1), ONE, True)]
        for k in range(1, TAYLOR):
            a.append(Term(a[-1].coefficient / k, ONE, True))
        around = self.range(v)
        rest = around.real.exp().upper() if isinstance(around, acb) else around.exp()
        last = rest * a[-1].coefficient / TAYLOR
        if isinstance(around, acb):
            last = _disc(last)
        return self._composed([*a, Term(last, ONE, False)], v)

    def _exp_bound(self, f: Sum) -> Sum:
        """Return a bound of |exp f| for complex coefficients: the exponential of the real part."""
        real = self._exp(self.sum(Term(exact(_real_part(c)), m, False) for c, m, _ in f))
        return tuple(Term(_disc(c), m, False) for c, m, _ in real)

    def _relative(self, f: Sum) -> tuple[Term, Sum]:
        """Return the leading term, and h of f = term·(1 + h)."""
        first, *rest = f
        if _ball(first.coefficient).contains(0):
            raise FartherError
        inverse = first.scale**-1
        h = self.sum(
            Term(exact(c / first.coefficient), m * inverse, fixed and first.fixed)
            for c, m, fixed in rest
        )
        return first, h

    def _power(self, f: Sum, r: fmpq) -> Sum:
        if r.q == 1 and 0 <= r <= TAYLOR and (len(f) != 1 or not self.complex):
            found: Sum = (Term(fmpq(1), ONE, True),)
            for _ in range(int(r.p)):
                found = self.product(found, f)
            return found
        if not f:
            if r > 0 and r.q == 1:
                return ()
            raise UndefinedError
        first, h = self._relative(f)
        c = first.coefficient
        if self.disc and (first.scale.p * r).q != 1:
            raise UndefinedError
        if r.q != 1 and not _real_part(_ball(c)) > 0:
            raise UndefinedError if len(f) == 1 or not _ball(c).contains(0) else FartherError
        if isinstance(c, acb) and not c.is_exact():  # sharper for a wide ball
            value: Any = (c.log() * r).exp() if c.real > 0 else c ** int(r.p)
        else:
            value = c ** int(r.p) if r.q == 1 else _ball(c) ** r
        head = Term(exact(value), first.scale**r, first.fixed)
        if not h:
            return self.sum([head])
        coefficients, binomial = [], fmpq(1)
        for k in range(TAYLOR):
            coefficients.append(Term(binomial, ONE, True))
            binomial = binomial * (r - k) / (k + 1)
        around = 1 + self.range(h)
        if not _real_part(around) > 0:
            raise FartherError
        last = binomial * _size(around) ** (r - TAYLOR)
        if isinstance(around, acb):
            last = _disc(last)
        return self.product((head,), self._composed([*coefficients, Term(last, ONE, False)], h))

    def _log(self, f: Sum) -> Sum:
        if not f:
            raise UndefinedError
        first, h = self._relative(f)
        c, m = first.coefficient, first.scale
        if not _real_part(_ball(c)) > 0 or (self.disc and m != ONE):
            raise UndefinedError
        found = [Term(number, Scale((), r, fmpq(0)), True) for r, number in m.exps]
        found.append(Term(m.p, Scale((), fmpq(0), fmpq(1)), True))
        if not _is_zero(m.q):  # 0 ≤ log log t ≤ log t
            found.append(Term(m.q * arb(0.5, 0.5), Scale((), fmpq(0), fmpq(1)), False))
        if not (isinstance(c, fmpq) and c == 1):
            found.append(Term(_ball(c).log(), ONE, first.fixed))
        if h:
            a = [Term(fmpq(0), ONE, True)]
            a += [Term(fmpq((-1) ** (k + 1), k), ONE, True) for k in range(1, TAYLOR)]
            around = 1 + self.range(h)
            if not _real_part(around) > 0:
                raise FartherError
            last = fmpq((-1) ** (TAYLOR + 1), TAYLOR) * _size(around) ** -TAYLOR
            if isinstance(around, acb):
                last = _disc(last)
            found += self._composed([*a, Term(last, ONE, False)], h)
        return self.sum(found)

    def _hyperbolic(self, name: str, f: Sum) -> Sum:
        one, other = self._exp(f), self._exp(self.scaled(fmpq(-1), f))
        half, minus = fmpq(1, 2), self.scaled(fmpq(-1), other)
        above, below = {
            "sinh": ((*one, *minus), None),
            "cosh": ((*one, *other), None),
            "tanh": ((*one, *minus), (*one, *other)),
            "coth": ((*one, *other), (*one, *minus)),
            "sech": (None, (*one, *other)),
            "csch": (None, (*one, *minus)),
        }[name]
        found: Sum = (Term(fmpq(1), ONE, True),)
        if above is not None:
            found = self.product(found, self.scaled(half, self.sum(above)))
        if below is not None:
            found = self.product(found, self._power(self.scaled(half, self.sum(below)), fmpq(-1)))
        return found

    # Tails

    def tail(self, f: Sum, start: arb) -> arb:
        """Return an upper bound of ∫ |f| from ``start`` ≥ T to infinity.

        A scale with t·m′/m ≤ −β, β > 1, is at most m(T)·(T/t)^β.

        Raises:
            DivergesError: the integral of f is proved to diverge.
            UndefinedError: the bound is not integrable.
            FartherError: the bound is integrable, as is seen from a larger T on.
        """
        total = arb(0)
        for n, (c, m, _) in enumerate(f):
            if not self._integrable(m):
                if n == 0 and self._is_at_least(f):
                    raise DivergesError
                raise UndefinedError
            beta = -self.slope(m, start)
            if not beta > 1:
                raise FartherError
            total += abs(_ball(c)) * start * self.at_start(m, start) / (beta - 1)
        return total.abs_upper()

    def cut(
        self, f: Sum, first: arb, farther: Callable[[arb], arb], most: arb | int
    ) -> tuple[arb, arb] | None:
        """Return the first cut whose tail is small at this precision, with the tail.

        A cut that was found is kept, for the one sum whose tails are asked for.

        Args:
            f: the sum.
            first: the first cut that is tried, an exact number.
            farther: the next cut after one.
            most: the farthest cut.
        """
        key = (ctx.prec, *map(int, first.man_exp()))
        if key not in self.cuts:
            cut, small = first, arb((1, -ctx.prec))
            while cut < most:
                with suppress(FartherError):
                    rest = self.tail(f, cut)
                    if rest < small:
                        self.cuts[key] = cut, rest
                        break
                cut = farther(cut)
            else:
                return None
        return self.cuts[key]

    def _integrable(self, m: Scale) -> bool:
        if m.exps:
            return _sign(m.exps[0][1]) < 0
        return bool(m.p < -1)

    def _is_at_least(self, f: Sum) -> bool:
        """Return whether f has one sign and is not integrable, from some number on."""
        c, m = self.lead(f)
        if not (c > 0 or c < 0):
            return False
        if m.exps:
            return _sign(m.exps[0][1]) > 0
        return bool(m.p > -1 or (m.p == -1 and m.q >= -1))


def _key(m: Scale) -> Any:
    """Return what equal scales have in common; equal balls need not be equal numbers."""
    numbers = (*(x for pair in m.exps for x in pair), m.p, m.q)
    return tuple((int(x.p), int(x.q)) if isinstance(x, fmpq) else id(x) for x in numbers)


def _larger_first(x: Term, y: Term) -> int:
    return -(x.scale * y.scale**-1).growth()


def _disc(x: Any) -> acb:
    """Return a square around 0 that contains all complex numbers as large as x."""
    radius = abs(_ball(x)).upper()
    return acb(arb(0, radius), arb(0, radius))


def _size(x: Any) -> Any:
    """Return a real ball itself, of a complex one a bound of its modulus from below and above."""
    return abs(x) if isinstance(x, acb) else x


def _coefficients(name: str, c: Any, n: int) -> list[Any]:
    """Return the first Taylor coefficients of a function at every point of a ball."""
    before = ctx.cap
    ctx.cap = n
    try:
        kind = acb_series if isinstance(c, acb) else arb_series
        s = kind([c, 1], n)
        if name in ("asin", "acos"):
            slope = (1 - s * s).rsqrt().integral()
            series = kind([getattr(c, name)()]) + (slope if name == "asin" else -slope)
        else:
            series = getattr(s, name)()
        return [series[k] for k in range(n)]
    except AttributeError:
        raise UndefinedError from None
    finally:
        ctx.cap = before
