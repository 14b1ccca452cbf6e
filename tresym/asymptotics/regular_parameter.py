"""A regular parameter under an integral or a sum: Taylor's formula, integrated term by term.

If |∂ⁿf/∂εⁿ(t, ε)| ≤ C w(t) for all t of the range and 0 < |ε| ≤ ε₀, and w has a finite integral W,

    |∫ f(t, ε) dt − Σ_(k<n) ε^k ∫ ∂^k f/∂ε^k(t, 0)/k! dt| ≤ C W |ε|^n/n!.

The same holds for sums. At infinity ε is 1/x. Where ∂ⁿf is continuous on the closed finite range
for |ε| ≤ ε₀, it is bounded, and no C is sought (DLMF 1.5(iv), 1.9; Olver 1974, ch. 3, §1).

Example: ``integral(sqrt(1 - k**2*sin(t)**2), t, 0, pi/2) == pi/2 - pi*k**2/8 + O(k**4) as k -> 0``.
"""

from __future__ import annotations

from itertools import islice, product
from math import factorial

from flint import arb, fmpq

from tresym.asymptotics.lemma import (
    SLACK,
    Bound,
    End,
    Expansion,
    Obligations,
    rounded_up,
    supremum,
)
from tresym.reals.decisions.integrals import without_integrals
from tresym.reals.decisions.known_values import known_value
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.binders import integral
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    MINUS_ONE,
    ONE,
    PI,
    ZERO,
    Expr,
    add,
    apply,
    fresh,
    number,
    opened,
    power,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError, Interval

LEMMA = "Taylor's formula under the integral sign (DLMF 1.5(iv))"
LONG = 120
"""Derivatives of more operations get no constant."""
GRID, FEW = 24, 6
"""Points in each direction at which the largest derivative is looked for, and beside parameters."""
VALUES = 12
"""Values of the parameters at which it is looked for."""
RANGES = (fmpq(1, 2), fmpq(1, 10), fmpq(1, 100))
_INFINITE = (INFINITY, -INFINITY)


class RegularParameter(Expansion):
    """∫ or Σ of f(t, ε) over a fixed range, where ε → 0."""

    lemma = LEMMA

    def __init__(self, node: Expr, f: Expr, t: str, small: str, in_x: Expr, end: End) -> None:
        """Expand an integral or a sum.

        Args:
            f: its body in the symbols t and ``small``.
            in_x: ε in the variable of the path.
        """
        self.node, self.f, self.t, self.small, self.in_x, self.end = node, f, t, small, in_x, end
        self.low, self.high = node.args[1:]
        self.values: list[Expr | None] = []
        self.derivatives = [f]

    def _derivative(self, n: int) -> Expr:
        while len(self.derivatives) <= n:
            self.derivatives.append(differentiate(self.derivatives[-1], self.small))
        return self.derivatives[n]

    @property
    def inside(self) -> Given:
        """Return the conditions on the variable of integration."""
        t, strict = symbol(self.t), self.node.op == "integral"
        low = () if self.low in _INFINITE else ((t, ">" if strict else ">=", self.low),)
        high = () if self.high in _INFINITE else ((t, "<" if strict else "<=", self.high),)
        return self.end.given & Given((*low, *high))

    def _value(self, k: int) -> Expr | None:
        """Return the k-th coefficient, an explicit constant."""
        while len(self.values) <= k:
            n = len(self.values)
            e = substitute(self._derivative(n), {self.small: ZERO})
            e = normal_form(e, self.inside) / factorial(n)
            self.values.append(self._total(e))
        return self.values[k]

    def _total(self, e: Expr) -> Expr | None:
        if self.t not in symbols(e) and normal_form(e, self.end.given) == ZERO:
            return ZERO
        if self.node.op == "integral":
            found = without_integrals(
                [integral(e, self.t, self.low, self.high)], self.end.given, ()
            )
            value = None if found is None else found[0][0]
        else:
            known = known_value("sum", e, self.t, self.low, self.high, self.end.given)
            value = None if known is None else known.value
        if value is None or INFINITY.args[0] in symbols(value):
            return None
        return normal_form(value, self.end.given)

    def terms(self, order: int) -> tuple[Expr, Expr] | None:
        """Return the Taylor polynomial of degree ``order`` − 1, and ε^order."""
        try:
            found = [self._value(k) for k in range(order)]
        except (InputError, ZeroDivisionError, OverflowError):
            return None
        if any(value is None for value in found):
            return None
        powers = [ONE, *(power(self.in_x, number(k)) for k in range(1, order))]
        main = [a * p for a, p in zip(found, powers, strict=True) if a is not None and a != ZERO]
        size = power(self.in_x, number(order))
        return add(ZERO, *main), size if self._is_positive() else apply("abs", size)

    def _is_positive(self) -> bool:
        return self.end.side > 0

    def prove(self, order: int, ask: Obligations) -> Bound | None:
        """Bound the derivative of this order on the whole range."""
        e, t, small = self._derivative(order), symbol(self.t), symbol(self.small)
        sign, path = self.end.side, ask.statement.path
        wanted = None if path is None else path.reach
        for reach in RANGES if wanted is None else (wanted, *RANGES):
            near = ((sign * small, ">=", ZERO), (sign * small, "<=", number(reach)))
            closed = self._closed()
            if closed is not None and ask.continuous(self.f, closed & Given(near)):
                constant = self._largest(e, reach, closed & Given(near), order, ask)
                return Bound() if constant is None else Bound(constant, reach, True)
            inside = self.inside & Given(near)
            if not ask.continuous(self.f, inside):
                continue
            majorised = self._majorised(e, t, inside, ask)
            if majorised is not None:
                whole = self._whole(*majorised)
                if whole is None:
                    return Bound()
                return Bound(rounded_up(whole / factorial(order), 4), reach, True)
        return None

    def _whole(self, c: fmpq, w: Expr) -> arb | None:
        """Return a bound of the integral or sum of c·w over the range; None if none is known."""
        finite = {self.low, self.high} - {INFINITY}
        if self.low in _INFINITE or any(symbols(end) for end in finite):
            return None
        t, low = symbol(self.t), self.low
        whole_squares = 1 / low + 1 / low**2 if low.op == "number" and low.args[0] > 0 else None
        known = {
            apply("exp", -t / 2): 2 * apply("exp", -self.low / 2),
            power(1 + t * t, MINUS_ONE): PI / 2 - apply("atan", self.low),
            power(t, number(-2)): whole_squares,
            ONE: self.high - self.low if self.high not in _INFINITE else None,
        }
        whole = known.get(w)
        with ball_precision():
            found = None if whole is None else arb(c) * evaluate(whole, {})
            return found if found is not None and found.is_finite() else None

    def _closed(self) -> Given | None:
        if self.node.op != "integral" or self.low in _INFINITE or self.high in _INFINITE:
            return None
        t = symbol(self.t)
        return self.end.given & Given(((t, ">=", self.low), (t, "<=", self.high)))

    def _largest(
        self, e: Expr, reach: fmpq, closed: Given, order: int, ask: Obligations
    ) -> fmpq | None:
        """Return a constant for a finite range, if one is proved for a bound found by numbers."""
        if symbols(self.low) | symbols(self.high) or e.size > LONG:
            return None
        points = self._values_of_parameters(e)
        grid = GRID if points == [{}] else FEW
        with ball_precision():
            low, high = evaluate(self.low, {}), evaluate(self.high, {})
            largest = arb(0)
            for i, j, at in product(range(grid + 1), range(grid + 1), points):
                x = arb(reach) * j / grid * self.end.side
                place = {self.t: (low + (high - low) * i / grid).mid(), self.small: x.mid()}
                value = abs(evaluate(e, {name: arb(v) for name, v in at.items()} | place))
                if value.is_finite():
                    largest = largest.max(value.mid())
            bound = rounded_up(largest * arb(SLACK), 4)
            if not ask.holds(apply("abs", e), "<=", number(bound), closed):
                return None
            return rounded_up(arb(bound) * (high - low) / factorial(order), 4)

    def _values_of_parameters(self, e: Expr) -> list[dict[str, fmpq]]:
        """Return values of the other variables of ``e`` and the ends of their ranges."""
        names = sorted(symbols(e) - {self.t, self.small})
        points = list(islice(self.end.given.points(names, VALUES), VALUES)) if names else [{}]
        ranges = [self.end.given.box.get(name, Interval()) for name in names]
        ends = [[x for x in (where.low, where.high) if x is not None] for where in ranges]
        return points + [dict(zip(names, at, strict=True)) for at in islice(product(*ends), VALUES)]

    def _majorised(
        self, e: Expr, t: Expr, inside: Given, ask: Obligations
    ) -> tuple[fmpq, Expr] | None:
        """Prove |∂ⁿf| ≤ C w for a function w whose integral or sum converges; return C and w."""
        at_zero = substitute(e, {self.small: ZERO})
        reach = inside.box[self.small]
        places = [ZERO, *(number(end) for end in (reach.low, reach.high) if end is not None)]
        values = self._values_of_parameters(e)
        for w in self._majorants(at_zero, t):
            ratios = (
                substitute(e / w, {name: number(v) for name, v in at.items()} | {self.small: place})
                for place in places
                for at in values
            )
            sizes = [self._supremum(ratio) for ratio in ratios]
            known = [size for size in sizes if size is not None]
            if len(known) < len(sizes):
                continue
            c = max(rounded_up(size * arb(SLACK), 4) for size in known)
            if ask.holds(apply("abs", e), "<=", number(c) * w, inside):
                return c, w
        return None

    def _supremum(self, e: Expr) -> arb | None:
        """Return about the largest |e| on the range of the variable of integration."""
        if symbols(e) - {self.t} or self.low in _INFINITE:
            return None
        moved = substitute(e, {self.t: self.low + symbol(self.t)})
        width = None if self.high in _INFINITE else normal_form(self.high - self.low, Given())
        return supremum(moved, self.t, width)

    def _majorants(self, at_zero: Expr, t: Expr) -> list[Expr]:
        """Return nonnegative functions with a finite integral over the range."""
        found = []
        if self.node.op == "integral" and not {self.low, self.high} & {*_INFINITE}:
            found.append(ONE)
        far = End(self.t, None, 1, self.end.given)
        infinite = self.high == INFINITY and self.low not in _INFINITE
        size = apply("abs", at_zero)
        if infinite and self.node.op == "integral":
            found += [apply("exp", -t / 2), power(1 + t * t, MINUS_ONE)]
        elif infinite:
            found.append(power(t, number(-2)))
        last = far.limit(size * t**2) if infinite else None
        if last is not None and last not in _INFINITE and self.node.op == "sum":
            found.append(size)
        return found


def regular_parameter(node: Expr, end: End) -> RegularParameter | None:
    """Return the Taylor expansion of an integral or a series in its parameter, or None."""
    if node.op not in ("integral", "sum"):
        return None
    (t,), body = opened(node, end.taken)
    low, high = node.args[1:]
    if body.hidden or any(end.name in symbols(e) for e in (low, high)):
        return None
    if end.name not in symbols(body) or (node.op == "sum" and high != INFINITY):
        return None
    small = fresh("e", {t, *symbols(body), *end.taken})
    x = symbol(end.name)
    if end.point is None:
        in_x, put = 1 / x, 1 / symbol(small)
    else:
        in_x = x if end.point == ZERO else x - end.point
        put = symbol(small) if end.point == ZERO else end.point + symbol(small)
    try:
        near = end.given & Given(((end.side * symbol(small), ">", ZERO),))
        f = substitute(body, {end.name: put})
        f = normal_form(f, near) if end.point is None else f
        found = RegularParameter(node, f, t, small, in_x, end)
        return found if found.terms(1) is not None else None
    except (InputError, ZeroDivisionError, OverflowError):
        return None
