"""Taylor series in h of expressions with functions left unknown, such as f(t + h/2, y(t) + h*k).

A smooth function has arbitrary derivatives at a point, and they are all that its values near that
point have in common: with f, f′, f″, … at x as variables, f(x + h) is the series
f + f′ h + f″ h²/2 + …, and whatever is made of such values is a power series in h whose
coefficients are polynomials in these variables. Three kinds of conditions are put in. A
differential equation ``diff(y(t), t) == f(t, y(t))`` gives all derivatives of y by the chain rule.
An equation of a stage, ``k == f(t + h/2, y(t) + h/2*k)``, gives k as a series, one power of h after
the other. And ``F(h) == (f(x+h) - f(x))/h`` is a definition, so that F(2*h) has a value too.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from typing import NamedTuple, TypeAlias

from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx

from tresym.reals.decisions.statement import functions
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.calls import FACTORIAL, INFINITY
from tresym.reals.language.expression import (
    DOTS,
    ZERO,
    Expr,
    add,
    apply,
    fresh,
    instantiate,
    integer,
    multiply,
    number,
    power,
    symbol,
    symbols,
    unknown,
)
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.arithmetic import ball_precision

VARIABLES = 240
"""Derivatives at a point and parameters that one claim may have."""
LARGEST = 40
"""Larger exponents of h are not read."""
TERMS = 20_000
"""A coefficient with more terms is given up."""
Polynomial: TypeAlias = fmpq_mpoly
Equation: TypeAlias = tuple[Expr, Expr]


class UnreadError(Exception):
    """The claim is not a scheme, for the reason that is said."""


@cache
def _ring() -> fmpq_mpoly_ctx:
    return fmpq_mpoly_ctx.get([f"v{k}" for k in range(VARIABLES)], Ordering.lex)


@dataclass(frozen=True)
class Series:
    """A Laurent series in h: the coefficients below h**known, those that are not zero."""

    terms: Mapping[int, Polynomial]
    known: int

    @property
    def first(self) -> int:
        """The exponent of the first term, or where it may begin at the earliest."""
        return min(self.terms, default=self.known)

    def upto(self, known: int) -> Series:
        """Return the series with the terms from h**known on forgotten."""
        if self.known <= known:
            return self
        return Series({n: c for n, c in self.terms.items() if n < known}, known)

    def __add__(self, other: Series) -> Series:
        known = min(self.known, other.known)
        total = {n: c for n, c in self.terms.items() if n < known}
        for n, c in other.terms.items():
            if n < known:
                total[n] = total[n] + c if n in total else c
        return Series({n: c for n, c in total.items() if not c.is_zero()}, known)

    def __mul__(self, other: Series) -> Series:
        known = min(self.known + other.first, other.known + self.first)
        total: dict[int, Polynomial] = {}
        for n, c in self.terms.items():
            for m, d in other.terms.items():
                if n + m < known:
                    total[n + m] = total[n + m] + c * d if n + m in total else c * d
                    if len(total[n + m]) > TERMS:
                        raise UnreadError("its Taylor coefficients have too many terms")
        return Series({n: c for n, c in total.items() if not c.is_zero()}, known)

    def times(self, c: Polynomial | fmpq) -> Series:
        """Return the product with a coefficient."""
        terms = {n: d * c for n, d in self.terms.items()}
        return Series({n: d for n, d in terms.items() if not d.is_zero()}, self.known)


class Variable(NamedTuple):
    """What a variable of the coefficients stands for: a parameter, or a derivative at a point."""

    name: str
    orders: tuple[int, ...] = ()
    base: tuple[str, ...] = ()


class _Rule(NamedTuple):
    """A differential equation: the derivative of this order by the variable at ``place``."""

    names: tuple[str, ...]
    place: int
    order: int
    right: Expr


class Jets:
    """Reads expressions as series in h.

    Attributes:
        h: the variable of the series.
        variables: what the variables of the coefficients stand for, in their order.
        constants: the numbers that are not rational, by the names of their variables.
        divisors: what is divided by, by the variables that stand for 1 over it.
        implicit: whether a stage depends on itself.
        rules: the functions that differential equations determine.
    """

    def __init__(self, h: str, equations: tuple[Equation, ...] = ()) -> None:
        self.h = h
        self.variables: list[Variable] = []
        self.bases: dict[Variable, tuple[Polynomial, ...]] = {}
        self.rules: dict[str, _Rule] = {}
        self.definitions: dict[str, Expr] = {}
        self.equations: dict[str, Expr] = {}
        self.stages: dict[str, Series] = {}
        self.constants: dict[str, Expr] = {}
        self.divisors: dict[Variable, Polynomial] = {}
        self.implicit = False
        self.top = 0
        self._numbers: dict[Variable, int] = {}
        self._right_sides: dict[str, Polynomial] = {}
        self._derived: dict[tuple[str, tuple[int, ...]], Polynomial] = {}
        for left, right in equations:
            self._said(left, right)
        self._check()

    # What is said of functions and stages

    def _said(self, left: Expr, right: Expr) -> None:
        """Read one condition."""
        for one, other in ((left, right), (right, left)):
            if one.op == "symbol" and one.args[0] not in (self.h, *self.equations):
                self.equations[one.args[0]] = other
                return
            if one.op != "unknown":
                continue
            (name, orders), args = one.args[0].args, one.args[1:]
            if name in self.rules or name in self.definitions:
                continue
            if not any(orders) and args == (symbol(self.h),):
                self.definitions[name] = other
                return
            names = tuple(arg.args[0] for arg in args if arg.op == "symbol")
            places = [k for k, order in enumerate(orders) if order]
            distinct = len(set(names)) == len(args) and self.h not in names
            if len(places) == 1 and distinct and self.h not in symbols(other):
                self.rules[name] = _Rule(names, places[0], orders[places[0]], other)
                return
        raise UnreadError(
            f"the condition {left} == {right} is neither a differential equation nor a stage"
        )

    def _check(self) -> None:
        """Refuse equations that do not determine derivatives one after the other."""
        known: set[str] = set()
        for name, e in self.definitions.items():
            called = {f.args[0].args[0] for f in functions(e)}
            if called & (set(self.definitions) - known) or symbols(e) & set(self.equations):
                raise UnreadError(f"{name} is not defined by what is known before it")
            known.add(name)
        for name, rule in self.rules.items():
            if not symbols(rule.right) & set(rule.names):
                raise UnreadError(f"what is said of {name} may be meant at one point only")
            others = {other.names[other.place] for other in self.rules.values()}
            for f in functions(rule.right):
                called = f.args[0].args[0]
                if called in self.definitions:
                    raise UnreadError(f"{called} is defined as a function of {self.h} alone")
                if called not in self.rules:
                    continue
                plain = tuple(map(symbol, rule.names)) == f.args[1:]
                other = self.rules[called]
                if not plain or f.args[0].args[1][other.place] >= other.order or len(others) > 1:
                    raise UnreadError(f"the equation for {name} is not solved for its derivative")
            fixed = (symbols(rule.right) - set(rule.names)) & set(self.equations)
            if fixed:
                raise UnreadError(f"{min(fixed)} is a parameter of a differential equation")

    def solve(self, top: int) -> None:
        """Find the series of the stages, and work below h**top from now on."""
        self.top = top
        self.stages = {name: Series({}, 0) for name in self.equations}
        needed = {name: symbols(e) & set(self.equations) for name, e in self.equations.items()}
        for _ in needed:
            for name, others in needed.items():
                needed[name] = others.union(*(needed[other] for other in others))
        self.implicit = any(name in others for name, others in needed.items())
        while any(stage.known < top for stage in self.stages.values()):
            before = sum(stage.known for stage in self.stages.values())
            for name, e in self.equations.items():
                if self.stages[name].known < top:
                    found = self.read(e).upto(top)
                    if found.known >= self.stages[name].known:
                        self.stages[name] = found
            if sum(stage.known for stage in self.stages.values()) <= before:
                names = ", ".join(n for n, stage in self.stages.items() if stage.known < top)
                raise UnreadError(f"the equations do not give {names} as a series in {self.h}")

    # Coefficients

    def _variable(self, which: Variable, base: tuple[Polynomial, ...] = ()) -> Polynomial:
        if which not in self._numbers:
            if len(self.variables) == VARIABLES:
                raise UnreadError("it depends on too many derivatives")
            self._numbers[which] = len(self.variables)
            self.variables.append(which)
            self.bases[which] = base
        return _ring().gen(self._numbers[which])

    def _derivative_at(
        self, name: str, orders: tuple[int, ...], base: tuple[Polynomial, ...]
    ) -> Polynomial:
        """Return a derivative of a function at a point."""
        if name in PERIODIC:
            (n,) = orders
            sign = PERIODIC[name]
            if sign == 0:
                return self._variable(Variable(name, (0,), tuple(map(str, base))), base)
            which = Variable(name, (n % 2,), tuple(map(str, base)))
            return self._variable(which, base) * fmpq(sign ** (n // 2))
        rule = self.rules.get(name)
        if rule is None or orders[rule.place] < rule.order:
            return self._variable(Variable(name, orders, tuple(map(str, base))), base)
        found = self._by_rule(name, orders)
        own = tuple(self._variable(Variable(x)) for x in rule.names)
        return (
            found if own == base else self._moved(found, dict(zip(rule.names, base, strict=True)))
        )

    def _by_rule(self, name: str, orders: tuple[int, ...]) -> Polynomial:
        """Return a derivative that a differential equation determines, at its own variables."""
        if (name, orders) in self._derived:
            return self._derived[name, orders]
        rule = self.rules[name]
        least = tuple(rule.order if k == rule.place else 0 for k in range(len(orders)))
        if orders == least:
            top, self.top = self.top, 1
            found = self.read(rule.right).terms.get(0, _ring().constant(0))
            self.top = top
        else:
            k = next(k for k, n in enumerate(orders) if n > least[k])
            lower = tuple(n - (j == k) for j, n in enumerate(orders))
            found = self._differentiated(self._by_rule(name, lower), rule.names[k])
        if len(found) > TERMS:
            raise UnreadError("its Taylor coefficients have too many terms")
        self._derived[name, orders] = found
        return found

    def _differentiated(self, p: Polynomial, name: str) -> Polynomial:
        """Return the total derivative by a variable, by the chain rule."""
        total = _ring().constant(0)
        for k, used in enumerate(p.degrees()):
            if used <= 0:  # -1 for the polynomial 0
                continue
            which = self.variables[k]
            slope = self._slope(which, name)
            if not slope.is_zero():
                total += p.derivative(k) * slope
        return total

    def _slope(self, which: Variable, name: str) -> Polynomial:
        """Return the total derivative of a variable of the coefficients by a symbol."""
        if which in self.divisors:
            inverse = _ring().gen(self._numbers[which])
            return -self._differentiated(self.divisors[which], name) * inverse**2
        if not which.orders:
            return _ring().constant(int(which.name == name))
        base = self.bases[which]
        slope = _ring().constant(0)
        for j, b in enumerate(base):
            inner = self._differentiated(b, name)
            if not inner.is_zero():
                orders = tuple(n + (i == j) for i, n in enumerate(which.orders))
                slope += inner * self._derivative_at(which.name, orders, base)
        return slope

    def _moved(self, p: Polynomial, to: Mapping[str, Polynomial]) -> Polynomial:
        """Return a coefficient at other values of its variables."""
        images = list(_ring().gens())
        for k, used in enumerate(p.degrees()):
            if used > 0:
                which = self.variables[k]
                images[k] = (
                    self._image(which, to) if which.orders else to.get(which.name, images[k])
                )
        return p.compose(*images, ctx=_ring())

    def _image(self, which: Variable, to: Mapping[str, Polynomial]) -> Polynomial:
        """Return a derivative at other values of the variables of the point where it is taken."""
        base = tuple(self._moved(b, to) for b in self.bases[which])
        return self._derivative_at(which.name, which.orders, base)

    # Series

    @property
    def one(self) -> Polynomial:
        """The coefficient 1."""
        return _ring().constant(1)

    def constant(self, c: Polynomial | fmpq | int) -> Series:
        """Return a series that does not depend on h."""
        p = c if isinstance(c, fmpq_mpoly) else _ring().constant(c)
        return Series({} if p.is_zero() else {0: p}, self.top)

    def read(self, e: Expr, bound: Mapping[str, Series] | None = None) -> Series:
        """Return an expression as a series.

        Args:
            bound: series for symbols that stand for something else here.
        """
        bound = bound or {}
        if e.op == "number":
            return self.constant(e.args[0])
        if e.op == "symbol":
            return self._symbol(e.args[0], bound)
        if e.op == "+":
            total = self.constant(0)
            for arg in e.args:
                total += self.read(arg, bound)
            return total
        if e.op == "*":
            found = self.constant(1)
            for arg in e.args:
                found = self._product(found, self.read(arg, bound))
            return found
        if e.op == "^":
            return self._power(e, bound)
        if e.op == "unknown" and e.args[0].args[0] != FACTORIAL:
            return self._call(e, bound)
        if e.op == "integral":
            return self._integral(e, bound)
        if not symbols(e) and not e.hidden:
            return self._constant_value(e)
        if e.op in _TAYLOR and symbols(e):
            return self._elementary(e, bound)
        raise UnreadError(f"{e} is not a value of a function, an integral or a power of {self.h}")

    def _symbol(self, name: str, bound: Mapping[str, Series]) -> Series:
        if name in bound:
            return bound[name]
        if name == self.h:
            return Series({1: _ring().constant(1)}, self.top)
        if name in self.stages:
            return self.stages[name]
        if name in (DOTS.args[0], INFINITY.args[0]) or name in self.equations:
            raise UnreadError(f"{name} is not a parameter")
        return self.constant(self._variable(Variable(name)))

    def _constant_value(self, e: Expr) -> Series:
        """Return a constant such as pi or sqrt(3), which becomes a parameter with a value.

        Of square roots it is known that their squares are rational; see :meth:`reduced`.
        """
        value = normal_form(e, Given())
        if value.op in ("number", "+", "*"):
            return self.read(value)
        with ball_precision():
            if not evaluate(value, {}).is_finite():
                raise UnreadError(f"{e} is no number")
        name = str(value)
        self.constants[name] = value
        return self.constant(self._variable(Variable(name)))

    def reduced(self, series: Series) -> Series:
        """Return a series without the coefficients that vanish by what is known of variables."""
        terms = {n: self._simpler(c) for n, c in series.terms.items()}
        return Series({n: c for n, c in terms.items() if not self._vanishes(c)}, series.known)

    def _simpler(self, c: Polynomial) -> Polynomial:
        """Return a coefficient with products of a variable and its inverse replaced by 1."""
        for which, divisor in self.divisors.items():
            (exponents, *more) = divisor.monoms()
            if not more and sum(exponents) == 1:
                k, other = self._numbers[which], next(j for j, n in enumerate(exponents) if n)
                total = _ring().constant(0)
                for powers, factor in c.terms():
                    lower = list(powers)
                    both = min(lower[k], lower[other])
                    lower[k], lower[other] = lower[k] - both, lower[other] - both
                    total += _ring().from_dict({tuple(lower): factor})
                c = total
        return c

    def _vanishes(self, c: Polynomial) -> bool:
        """Return whether a coefficient is 0 by roots of numbers, divisors, sines and cosines."""
        for which, divisor in self.divisors.items():
            k = self._numbers[which]
            most = _degree(c, k)
            c = self._replaced(c, k, [divisor ** (most - n) for n in range(most + 1)])
        for name, value in self.constants.items():
            square = _square(value)
            if square is not None:
                c = self._squared(c, Variable(name), _ring().constant(square))
        for which in list(self.variables):
            if which.name in PERIODIC and which.orders == (1,):
                base = self.bases[which]
                sine = self._variable(which._replace(orders=(0,)), base)
                c = self._squared(c, which, sine**2 * fmpq(PERIODIC[which.name]) + 1)
        return bool(c.is_zero())

    def _squared(self, c: Polynomial, which: Variable, square: Polynomial) -> Polynomial:
        """Return a coefficient with the square of a variable replaced."""
        k = self._numbers[which]
        one = _ring().gen(k)
        powers = [square ** (n // 2) * one ** (n % 2) for n in range(_degree(c, k) + 1)]
        return self._replaced(c, k, powers)

    def _replaced(self, c: Polynomial, k: int, values: list[Polynomial]) -> Polynomial:
        """Return a coefficient with other values of the powers of a variable."""
        parts: dict[int, dict[tuple[int, ...], fmpq]] = {}
        for powers, factor in c.terms():
            rest = tuple(0 if j == k else int(n) for j, n in enumerate(powers))
            parts.setdefault(int(powers[k]), {})[rest] = factor
        total = _ring().constant(0)
        for n, part in parts.items():
            total += _ring().from_dict(part) * values[n]
        return total

    def _power(self, e: Expr, bound: Mapping[str, Series]) -> Series:
        n = integer(e.args[1])
        if not symbols(e) and not e.hidden and (n is None or e.args[0].op != "number"):
            return self._constant_value(e)
        if n is None or abs(n) > LARGEST:
            raise UnreadError(f"the exponent of {e} is not a small integer")
        base = self.read(e.args[0], bound)
        found = self.constant(1)
        factor = self._reciprocal(base, e.args[0]) if n < 0 else base
        for _ in range(abs(n)):
            found = self._product(found, factor)
        return found

    def _product(self, one: Series, other: Series) -> Series:
        """Return the product of two values."""
        return one * other

    def _reciprocal(self, series: Series, e: Expr) -> Series:
        """Return 1/e by a geometric series."""
        n = series.first
        lead = series.terms.get(n)
        if lead is None:
            raise UnreadError(f"the denominator {e} does not begin with a power of {self.h}")
        one = Series({-n: self._inverse(lead)}, series.known - 2 * n)
        rest = Series({m: c for m, c in series.terms.items() if m != n}, series.known)
        small = (rest * one).times(fmpq(-1))  # 1/e = one (1 + small + small**2 + …)
        total = term = self.constant(1)
        while small.first > 0 and term.first < series.known - n and term.terms:
            term = self.reduced((term * small).upto(series.known - n))
            total += term
        return total.upto(series.known - n) * one

    def _inverse(self, lead: Polynomial) -> Polynomial:
        """Return 1/p as a product of variables, one for each parameter that divides p."""
        if lead.is_constant():
            return _ring().constant(fmpq(1) / lead.leading_coefficient())
        least = [min(int(n) for n in powers) for powers in zip(*lead.monoms(), strict=True)]
        rest = _ring().from_dict(
            {
                tuple(int(n) - m for n, m in zip(powers, least, strict=True)): c
                for powers, c in lead.terms()
            }
        )
        found = self.one
        for k, n in enumerate(least):
            if n:
                found *= self._over(_ring().gen(k)) ** n
        if rest.is_constant():
            return found * (fmpq(1) / rest.leading_coefficient())
        return found * self._over(rest)

    def _over(self, divisor: Polynomial) -> Polynomial:
        """Return the variable that stands for 1/p."""
        which = Variable(f"1/({divisor})")
        self.divisors[which] = divisor
        return self._variable(which)

    def _call(self, e: Expr, bound: Mapping[str, Series]) -> Series:
        (name, orders), args = e.args[0].args, [self.read(arg, bound) for arg in e.args[1:]]
        if name in self.definitions:
            if any(orders) or args[0].first < 1:
                raise UnreadError(f"{name} is only defined for small {self.h}")
            return self.read(self.definitions[name], {self.h: args[0]})
        if any(arg.first < 0 for arg in args):
            raise UnreadError(f"the arguments of {e} are not near one point")
        known = min(arg.known for arg in args)
        if known < 1:
            return Series({}, 0)
        base = tuple(arg.terms.get(0, _ring().constant(0)) for arg in args)
        steps = [Series({n: c for n, c in arg.terms.items() if n}, arg.known) for arg in args]
        total = Series({}, known)
        for more, size in self._monomials(steps, known):
            at = tuple(n + m for n, m in zip(orders, more, strict=True))
            total += self._step(name, at, base, size)
        return total

    def _step(
        self, name: str, orders: tuple[int, ...], base: tuple[Polynomial, ...], size: Series
    ) -> Series:
        """Return a term of a Taylor series: a derivative applied to powers of steps."""
        return size.times(self._derivative_at(name, orders, base))

    def _monomials(
        self, steps: list[Series], known: int
    ) -> Iterator[tuple[tuple[int, ...], Series]]:
        """Yield exponents k and the products of steps**k/k! that matter below h**known."""
        if not steps:
            yield (), self.constant(1).upto(known)
            return
        for rest, product in self._monomials(steps[1:], known):
            size, n = product, 0
            while size.terms:
                yield (n, *rest), size
                n += 1
                size = (size * steps[0]).upto(known).times(fmpq(1, n))

    def _integral(self, e: Expr, bound: Mapping[str, Series]) -> Series:
        """Return an integral between ends near one point, by its integrand's Taylor series."""
        name = fresh("s", {*symbols(e), *bound, self.h, *self.equations})
        body = instantiate(e.args[0], (symbol(name),))
        low, high = (self.read(end, bound) for end in e.args[1:])
        begin = low.terms.get(0, _ring().constant(0))
        near = begin == high.terms.get(0, _ring().constant(0)) and low.first >= 0 <= high.first
        if not near or min(low.known, high.known) < 1:
            raise UnreadError(f"the ends of {e} are not near one point")
        if symbols(body) & {self.h, *self.equations, *bound}:
            raise UnreadError(f"the integrand of {e} depends on {self.h}")
        near_begin = self.constant(begin) + Series({1: _ring().constant(1)}, self.top)
        values = self.read(body, {name: near_begin})
        if values.first < 0:
            raise UnreadError(f"the integrand of {e} is not smooth")
        known = min(low.known, high.known, values.known + 1)
        low, high = (end + self.constant(-begin) for end in (low, high))
        total, powers = Series({}, known), (low, high)
        for n in range(values.known):
            if n in values.terms:
                difference = powers[1] + powers[0].times(fmpq(-1))
                total += difference.times(values.terms[n] * fmpq(1, n + 1)).upto(known)
            powers = ((powers[0] * low).upto(known), (powers[1] * high).upto(known))
        return total

    def _elementary(self, e: Expr, bound: Mapping[str, Series]) -> Series:
        """Return exp, sin, … of a series, by their derivatives at its first term."""
        step = self.read(e.args[0], bound)
        if step.known < 1:
            return Series({}, 0)
        if step.first < 0:
            raise UnreadError(f"the argument of {e} does not tend to a point")
        base = step.terms.get(0, _ring().constant(0))
        step = Series({n: c for n, c in step.terms.items() if n}, step.known)
        name, first = _DERIVATIVES.get(e.op, (e.op, 0))
        total, size, n = Series({}, step.known), self.constant(1).upto(step.known), 0
        while size.terms:
            if base.is_zero():
                total += size.times(fmpq(_TAYLOR[e.op][n % 4], 1))
            else:
                total += size.times(self._derivative_at(name, (first + n,), (base,)))
            n += 1
            size = (size * step).upto(step.known).times(fmpq(1, n))
        return total

    # Back to expressions

    def expression(self, p: Polynomial) -> Expr:
        """Return a coefficient as an expression."""
        terms: list[Expr] = []
        for exponents, c in p.terms():
            factors = [number(Fraction(int(c.p), int(c.q)))]
            for k, n in enumerate(exponents):
                if n:
                    value = self.meaning(self.variables[k])
                    factors.append(value if n == 1 else power(value, number(int(n))))
            terms.append(multiply(*factors))
        return add(*terms) if terms else ZERO

    def meaning(self, which: Variable) -> Expr:
        """Return what a variable of the coefficients stands for."""
        if which in self.divisors:
            return power(self.expression(self.divisors[which]), number(-1))
        if which.name in PERIODIC:
            names = {name: key for key, name in _DERIVATIVES.items()}
            op = names[which.name, 1] if which.orders[0] else which.name
            return apply(op, *self.place(which))
        if which.orders:
            return unknown(which.name, self.place(which), which.orders)
        return self.constants.get(which.name) or symbol(which.name)

    def place(self, which: Variable) -> tuple[Expr, ...]:
        """Return the point at which a derivative is taken."""
        return tuple(map(self.expression, self.bases[which]))

    def letters(self, which: Variable) -> list[str]:
        """Return names for the arguments of a function: t and y for f(t, y(t))."""
        names = [
            e.args[0] if e.op == "symbol" else e.args[0].args[0] if e.op == "unknown" else ""
            for e in self.place(which)
        ]
        clear = all(len(n) == 1 for n in names) and len({*names, which.name}) == len(names) + 1
        count = range(1, len(names) + 1)
        return names if clear else [f"u{k}" if len(names) > 1 else "s" for k in count]

    def used(self, p: Polynomial) -> list[Variable]:
        """Return the derivatives and parameters in a coefficient."""
        return [self.variables[k] for k, n in enumerate(p.degrees()) if n > 0]

    def behind(self, p: Polynomial) -> list[Variable]:
        """Return the variables of a coefficient and of the points at which it is taken."""
        found = dict.fromkeys(self.used(p))
        for which in list(found):
            if which in self.divisors:
                found |= dict.fromkeys(self.behind(self.divisors[which]))
            for b in self.bases.get(which, ()):
                found |= dict.fromkeys(self.behind(b))
        return list(found)

    def is_linear(self, name: str) -> bool:
        """Return whether the equation of a function is linear, with constant coefficients."""
        rule = self.rules[name]
        orders = tuple(rule.order * (k == rule.place) for k in range(len(rule.names)))
        right = self._by_rule(name, orders)
        used = self.used(right)
        free = {v.name for v in used if not v.orders}
        solved = all(v.name in self.rules for v in used if v.orders)
        functions = [k for k, v in enumerate(self.variables) if v.orders]
        degrees = (sum(m[k] for k in functions) for m in right.monoms())
        return solved and not free & set(rule.names) and all(n <= 1 for n in degrees)


def _degree(c: Polynomial, k: int) -> int:
    """Return the degree in a variable."""
    return max((int(powers[k]) for powers in c.monoms()), default=0)


def _square(e: Expr) -> fmpq | None:
    """Return the square of a square root of a number, or None."""
    if e.op != "^" or e.args[0].op != "number" or e.args[1].op != "number":
        return None
    return fmpq(e.args[0].args[0]) if e.args[1].args[0] == fmpq(1, 2) else None


PERIODIC = {"exp": 0, "sin": -1, "sinh": 1}
"""Functions whose second derivative is this multiple of them; 0 for the exponential function."""
_DERIVATIVES = {"cos": ("sin", 1), "cosh": ("sinh", 1)}
_TAYLOR = {
    "exp": (1, 1, 1, 1),
    "sin": (0, 1, 0, -1),
    "cos": (1, 0, -1, 0),
    "sinh": (0, 1, 0, 1),
    "cosh": (1, 0, 1, 0),
}
"""The derivatives at 0, which repeat after four."""
