"""Laplace's method and Watson's lemma: integrals of e^(−λ(x) p(t)) q(t) with λ → ∞.

Let p have its minimum p₀ at t₀ alone. On each side, with t = t₀ ± s, put v = (p − p₀)^(1/μ), where
p − p₀ behaves like s^μ; so p − p₀ = v^μ and q dt = φ dv with φ = q/v′. If |φ − Σ_(k<n) aₖ v^eₖ| is
at most C v^eₙ on the whole side, then

    |∫ e^(−λp) q dt − e^(−λp₀) Σ aₖ G(eₖ)| ≤ C e^(−λp₀) G(eₙ),
    G(e) = Γ((e + 1)/μ)/(μ λ^((e + 1)/μ)),

for every λ > 0, since G(e) = ∫₀^∞ e^(−λ v^μ) v^e dv; no inverse function is needed. Where a side
ends at v = V, φ is 0 beyond, and C is also at least Σ |aₖ| V^(eₖ − eₙ). With p = t this is Watson's
lemma. If no C is found, it is enough for the order that the bound holds near t₀, that p > p₀ on
the rest, at its end too, and that the integral converges for some λ.

Example: ``integral(exp(-x*t)/(1+t), t, 0, oo) == 1/x - 1/x**2 + O(1/x**3)`` needs
``abs(1/(1+t) - 1 + t) <= t**2 given t > 0``, and the constant is 2.

Sources: F. W. J. Olver, *Asymptotics and Special Functions* (1974), ch. 3, §§3 and 7;
N. G. de Bruijn, *Asymptotic Methods in Analysis* (1958), ch. 4; DLMF 2.3(ii), 2.3(iii).
"""

from __future__ import annotations

from itertools import pairwise
from math import factorial
from typing import NamedTuple

from flint import arb, fmpq

from tresym.asymptotics.integrands import Exponential, exponentials
from tresym.asymptotics.lemma import (
    SLACK,
    Bound,
    End,
    Expansion,
    Obligations,
    exact_upper,
    rounded_up,
    supremum,
)
from tresym.reals.decisions.identity import decide
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.expansions.limit_values import limit_of
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ONE,
    PI,
    ZERO,
    Expr,
    add,
    apply,
    fresh,
    multiply,
    number,
    opened,
    power,
    sqrt,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.solve import solutions
from tresym.reals.normal.to_expression import in_lowest_terms, normal_form
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.signs.sign import sign
from tresym.reals.verdict import Verdict

WATSON = "Watson's lemma (Olver 1974, ch. 3, §3)"
LAPLACE = "Laplace's method (Olver 1974, ch. 3, §7)"
DEGREES = tuple(fmpq(*r) for r in ((1, 1), (2, 1), (3, 1), (4, 1), (6, 1), (1, 2), (3, 2), (1, 3)))
STEPS = (fmpq(1), fmpq(1, 2), fmpq(1, 3))
"""Distances between exponents that are tried."""
LOWEST = fmpq(-11, 12)
MOST = 9
"""Coefficients that are computed."""
SCALES = tuple(
    fmpq(*r) for r in ((1, 1), (1, 2), (-1, 2), (-1, 1), (1, 3), (-1, 3), (2, 1), (2, 3))
)
"""Powers of the variable by which the variable of integration is rescaled, for moving maxima."""
UNKNOWN, BOUNDS = 7, arb((1, -40))
"""Terms whose values of Γ are looked at, and how closely these are bounded."""
EXTRA = (ONE, number(10))


class Side(NamedTuple):
    """The integral over 0 < s < width of e^(−λ(p0 + p)) q, times a factor; p(0) = 0.

    Attributes:
        width: where the side ends, None for infinity.
    """

    factor: Expr
    rate: Expr
    least: Expr
    p: Expr
    q: Expr
    name: str
    width: Expr | None

    @property
    def inside(self) -> Given:
        """Return the conditions on s."""
        s = symbol(self.name)
        upper = () if self.width is None else ((s, "<", self.width),)
        return Given(((s, ">", ZERO), *upper))


class _Series:
    """The expansion of φ in powers of v on a side, coefficient by coefficient."""

    def __init__(self, side: Side, end: End) -> None:
        self.side, self.end = side, end
        s, p = symbol(side.name), side.p
        self.degree = next(
            (
                mu
                for mu in DEGREES
                if (c := self._limit(p / power(s, number(mu)))) not in (None, ZERO, *_INFINITE)
                and sign(c, end.given) == "+"
            ),
            None,
        )
        self.found: list[tuple[fmpq, Expr]] = []
        self.exact = self.ended = self.degree is None
        if self.degree is None:
            return
        mu = number(self.degree)
        lead = self._limit(p / power(s, mu))
        assert lead is not None
        self.straight = decide(p, lead * power(s, mu), side.inside & end.given).verdict
        if self.straight is Verdict.PROVED:
            self.v, self.rate, self.phi = s, side.rate * lead, side.q
        else:
            self.v, self.rate = power(p, 1 / mu), side.rate
            self.phi = mu * side.q * raised(p, 1 - 1 / self.degree) / differentiate(p, side.name)
        self.rest = self.phi

    def _limit(self, e: Expr) -> Expr | None:
        return limit_of(e, self.side.name, ZERO, 1, self.end.given)

    def upto(self, order: int) -> list[tuple[fmpq, Expr]]:
        """Return the first terms, exponents with nonzero coefficients; fewer where it ends."""
        while len(self.found) < order and not self.ended:
            following = self._next()
            if following is None:
                self.ended = True
                break
            self.found.append(following)
            exponent, a = following
            self.rest = self.rest - a * raised(self.v, exponent)
            at_rest = decide(self.rest, ZERO, self.side.inside & self.end.given)
            if at_rest.verdict is Verdict.PROVED:
                self.exact = self.ended = True
        return self.found[:order]

    def _next(self) -> tuple[fmpq, Expr] | None:
        for step in STEPS:
            start = self.found[-1][0] + step if self.found else _first(step)
            for k in range(MOST if self.found else int(8 / step)):
                exponent = start + k * step
                a = self._limit(self.rest / raised(self.v, exponent))
                if a is None or a in _INFINITE:
                    break  # an exponent in between, or a logarithm
                if a != ZERO:
                    return exponent, in_lowest_terms(a) if not symbols(a) else a
        return None

    def given_terms(self, order: int) -> Expr:
        """Return the sum of the first terms in s."""
        return add(ZERO, *(a * raised(self.v, e) for e, a in self.found[:order]))

    def integral(self, exponent: fmpq) -> Expr:
        """Return ∫₀^∞ e^(−λ v^μ) v^e dv."""
        assert self.degree is not None
        at = (exponent + 1) / self.degree
        value = gamma(at) or symbol(unknown_gamma(at))
        return value / number(self.degree) * power(self.rate, number(-at))

    def size(self, exponent: fmpq) -> tuple[Expr, fmpq]:
        """Return λ^(−(e + 1)/μ), and a bound of the factor before it in the integral."""
        assert self.degree is not None
        at = (exponent + 1) / self.degree
        with ball_precision():
            factor = exact_upper(arb(at).gamma() / self.degree)
        exact = gamma(at)
        if exact is not None and exact.op == "number":
            factor = exact.args[0] / self.degree
        return power(self.rate, number(-at)), factor


_INFINITE = (INFINITY, -INFINITY)


def _first(step: fmpq) -> fmpq:
    """Return the lowest exponent above −1 on the grid of this step."""
    k = (-1 / step).floor() + 1
    return fmpq(k) * step if fmpq(k) * step > -1 else fmpq(k + 1) * step


def shortened(x: fmpq) -> fmpq:
    """Return x itself, or a decimal of four digits that is at least x."""
    return x if x.q < 10**6 else rounded_up(arb(x), 4)


def raised(v: Expr, exponent: fmpq) -> Expr:
    """Return v^e; powers of roots of integers are powers of what is under the root."""
    if exponent == 0:
        return ONE
    own = v.args[1].args[0] if v.op == "^" and v.args[1].op == "number" else fmpq(1)
    if own.q != 1 and (own * exponent).q == 1:  # of a root, whose radicand is not negative
        return power(v.args[0], number(own * exponent))
    return power(v, number(exponent))


def unknown_gamma(x: fmpq) -> str:
    """Return the name of a symbol for the value of Γ at a number."""
    return f"Gamma_{x.p}_{x.q}"


def gamma(x: fmpq) -> Expr | None:
    """Return Γ at a positive multiple of 1/2 (DLMF 5.4.1, 5.4.6), or None."""
    if x.q == 1:
        return number(factorial(int(x.p) - 1))
    if x.q != 2:
        return None
    value, half = sqrt(PI), fmpq(1, 2)
    while half < x:
        value, half = number(half) * value, half + 1
    return value


class Laplace(Expansion):
    """The expansion of an integral that is a sum of sides of minima."""

    def __init__(self, sides: list[Side], end: End, lemma: str) -> None:
        """Prepare the series of every side."""
        self.sides, self.end, self.lemma = sides, end, lemma
        self.series = [_Series(side, end) for side in sides]
        for series in self.series:
            for exponent, _ in series.upto(UNKNOWN) if series.degree is not None else ():
                at = (exponent + 1) / series.degree
                if gamma(at) is None:
                    self._know(at)

    def _know(self, x: fmpq) -> None:
        """Take a symbol for the value of Γ at a number, with bounds by balls."""
        name = unknown_gamma(x)
        self.unknown |= {name}
        with ball_precision():
            value = arb(x).gamma()
            low, high = -exact_upper(-value * (1 - BOUNDS)), exact_upper(value * (1 + BOUNDS))
        bounds = ((symbol(name), ">", number(low)), (symbol(name), "<", number(high)))
        self.constants = self.constants & Given(bounds)

    def terms(self, order: int) -> tuple[Expr, Expr] | None:
        """Return the first terms of all sides together, and the size of the first omitted one."""
        main, errors = [], []
        for side, series in zip(self.sides, self.series, strict=True):
            if series.degree is None:
                return None
            found = series.upto(order + 1)
            if len(found) < order + 1 and not series.exact:
                return None
            before = multiply(side.factor, apply("exp", -side.rate * side.least))
            before = side.factor if side.least == ZERO else before
            for exponent, a in found[:order]:
                main.append(a * before * series.integral(exponent))
            if len(found) > order:
                size, _ = series.size(found[order][0])
                plain = sign(before, Given(((symbol(self.end.name), ">", ZERO),)) & self.end.given)
                errors.append((before if plain in ("+", ">=0") else apply("abs", before)) * size)
            elif side.width is not None:
                size, _ = series.size(found[-1][0] + 3)
                errors.append(apply("abs", before) * size)
        return add(ZERO, *main), add(ZERO, *dict.fromkeys(errors))

    def prove(self, order: int, ask: Obligations) -> Bound | None:
        """Prove the bound on the whole of every side, or else near the minimum and beyond."""
        parameters = any(
            symbols(e) - {side.name} for side in self.sides for e in (side.p, side.q)
        ) or any(side.width is not None and symbols(side.width) for side in self.sides)
        positive = (
            all(
                sign(s.rate, Given(((symbol(self.end.name), ">", ZERO),)) & self.end.given) == "+"
                for s in self.series
            )
            and self.end.point in (None, ZERO)
            and self.end.side == 1
        )
        constant: fmpq | None = fmpq(0)
        for side, series in zip(self.sides, self.series, strict=True):
            found = None
            before = list(ask.found), ask.verdict
            if not parameters and positive and constant is not None:
                found = _everywhere(side, series, order, ask)
            if found is None:
                ask.found[:], ask.verdict = before
                if not _nearby(side, series, order, ask, self.end):
                    return None
            constant = None if found is None or constant is None else constant + found
        return Bound(None if constant is None else shortened(constant), None)


def _everywhere(side: Side, series: _Series, order: int, ask: Obligations) -> fmpq | None:
    """Prove |φ − Σ| ≤ C v^e on the whole side; return the constant of the error."""
    found = series.upto(order + 1)
    if not (ask.continuous(side.p, side.inside) and ask.continuous(side.q, side.inside)):
        return None  # an inequality says nothing where its sides are not defined
    if len(found) <= order and side.width is None:
        return fmpq(0)
    given = side.inside
    if series.straight is not Verdict.PROVED and not ask.holds(
        differentiate(side.p, side.name), ">", ZERO, given
    ):
        return None
    exponent = found[order][0] if len(found) > order else found[-1][0] + 3
    rest = series.phi - series.given_terms(order)
    gauge = raised(series.v, exponent)
    constant = fmpq(0)
    if len(found) > order:
        largest = supremum(rest / gauge, side.name, side.width)
        if largest is None:
            return None
        with ball_precision():
            top = abs(evaluate(found[order][1], {}))
            largest = largest.max(top)
        for slack in (SLACK, SLACK**5):
            constant = rounded_up(largest * slack, 4)
            if ask.holds(apply("abs", rest), "<=", number(constant) * gauge, given):
                break
        else:
            return None
    if side.width is not None:
        with ball_precision():
            last = limit_of(series.v, side.name, side.width, -1, Given())
            if last is None:
                return None
            if last != INFINITY:
                far, beyond = evaluate(last, {}), arb(0)
                for e, a in found[:order]:
                    beyond += abs(evaluate(a, {})) * far ** arb(e - exponent)
                if not beyond.is_finite():
                    return None
                constant = max(constant, rounded_up(beyond))
    return constant * series.size(exponent)[1]


def _nearby(side: Side, series: _Series, order: int, ask: Obligations, end: End) -> bool:
    """Prove the expansion near s = 0, and that the rest of the side adds less than any term."""
    s, given = side.name, side.inside & end.given
    found = series.upto(order + 1)
    start = End(s, ZERO, 1, end.given)
    if len(found) > order:
        rest = series.phi - series.given_terms(order)
        gauge = raised(series.v, found[order][0])
        if not ask.holds(rest, "O", gauge, end.given, start.path):
            return False
    if not (
        ask.holds(side.p, ">", ZERO, given)
        and ask.continuous(side.p, given)
        and ask.continuous(side.q, given)
    ):
        return False
    if side.width is None:
        far = End(s, None, 1, end.given)
        last = far.limit(side.p)
        if last is None or last == ZERO or (last != INFINITY and sign(last, end.given) != "+"):
            return False
        return any(
            ask.holds(
                side.q * apply("exp", -k * side.p),
                "O",
                power(symbol(s), number(-2)),
                end.given,
                far.path,
            )
            for k in EXTRA
        )
    last = limit_of(side.p, s, side.width, -1, end.given)
    if last is None or (last != INFINITY and sign(last, end.given) != "+"):
        return False
    beside = End(s, side.width, -1, end.given)
    room = side.width - symbol(s)
    weights = (ONE, power(room, number(fmpq(-1, 2))), power(room, number(fmpq(-9, 10))))
    return any(
        limit_of(abs(side.q) / w, s, side.width, -1, end.given) not in (None, *_INFINITE)
        and ask.holds(side.q, "O", w, end.given, beside.path)
        for w in weights
    )


# From an integral to sides


def laplace(node: Expr, end: End) -> Laplace | None:
    """Return the expansion of an integral ∫ c(x) e^(−λ(x) p(t)) q(t) dt, or None for others."""
    try:
        for alpha in (None, *SCALES):
            sides = _sides(node, end, alpha)
            if sides is not None:
                plain = all(_is_straight(side) for side in sides) and alpha is None
                found = Laplace(sides, end, WATSON if plain else LAPLACE)
                if found.terms(1) is not None:
                    return found
    except (InputError, ZeroDivisionError, OverflowError):
        return None
    return None


def _is_straight(side: Side) -> bool:
    slope = differentiate(side.p, side.name)
    return side.name not in symbols(slope) and side.least == ZERO


def _sides(node: Expr, end: End, alpha: fmpq | None) -> list[Side] | None:
    """Return the sides of all minima, of every exponential in the integrand."""
    (t,), body = opened(node, end.taken)
    low, high = node.args[1:]
    if alpha is not None:
        if end.point not in (None, ZERO) or end.side != 1:
            return None
        stretch = power(symbol(end.name), number(alpha))
        body = substitute(body, {t: stretch * symbol(t)}) * stretch
        low, high = (
            e if e in (ZERO, *_INFINITE) else normal_form(e / stretch, _beyond(end))
            for e in (low, high)
        )
    if any(end.name in symbols(e) for e in (low, high)):
        return None
    found: list[Side] = []
    parts = exponentials(body, t, end)
    if not parts:
        return None
    for part in parts:
        sides = _around_minimum(part, t, low, high, end)
        if sides is None:
            return None
        found += sides
    return found


def _beyond(end: End) -> Given:
    return end.given & Given(((symbol(end.name), ">", ZERO),))


def _around_minimum(
    part: Exponential, t: str, low: Expr, high: Expr, end: End
) -> list[Side] | None:
    """Return one side for a minimum at an end, two for one inside; equal minima are parted."""
    found = _minima(part.p, t, low, high, end.given)
    if found is None:
        return None
    points, least = found
    cuts = [normal_form((a + b) / 2, end.given) for a, b in pairwise(points)]
    starts, stops = [low, *cuts], [*cuts, high]
    sides = []
    for point, start, stop in zip(points, starts, stops, strict=True):
        for direction, far in ((1, stop), (-1, start)):
            if far != point:
                sides.append(_side(part, t, point, least, direction, far, end))
    return sides


def _side(
    part: Exponential, t: str, point: Expr, least: Expr, direction: int, far: Expr, end: End
) -> Side:
    """Return the part of the range between a minimum and another point, as a side."""
    width = None if far in _INFINITE else normal_form(direction * (far - point), end.given)
    if point == ZERO and direction == 1:
        p = part.p if least == ZERO else part.p - least
        return Side(part.factor, part.rate, least, p, part.q, t, width)
    s = fresh("s" if t != "s" else "u", {*symbols(part.p), *symbols(part.q), t, *end.taken})
    put = {t: point + direction * symbol(s)}
    p, q = substitute(part.p, put), substitute(part.q, put)
    p = p if least == ZERO else p - least
    return Side(part.factor, part.rate, least, p, q, s, width)


def _minima(p: Expr, t: str, low: Expr, high: Expr, given: Given) -> tuple[list[Expr], Expr] | None:
    """Return where p is least, as numbers tell, in increasing order, and its value there."""
    places: list[tuple[Expr, int]] = []
    if low not in _INFINITE:
        places.append((low, 1))
    if high not in _INFINITE:
        places.append((high, -1))
    slope = differentiate(p, t)
    inner = [*solutions(slope, t), *solutions(normal_form(slope, given), t)]
    inner = [ZERO, ONE, *(normal_form(e, given) for e in inner if t not in symbols(e))]
    places += [(e, 1) for e in dict.fromkeys(inner)]
    found: list[tuple[Expr, Expr, arb]] = []
    at = next(
        given.points(frozenset().union(*(symbols(e) for e, _ in places), symbols(p)) - {t}, 1), {}
    )
    with ball_precision():
        for e, side in places:
            if e not in (low, high) and not is_between(e, low, high, at):
                continue
            value = limit_of(p, t, e, side, given)
            if value is None or value in _INFINITE:
                if value == -INFINITY:
                    return None
                continue
            size = evaluate(value, at)
            if size.is_finite():
                found.append((e, value, size))
        if not found:
            return None
        best = min(found, key=lambda item: item[2].mid())
        equal = {e: value for e, value, size in found if size.overlaps(best[2])}
        if len(equal) > 1 and any(symbols(e) for e in equal):
            return None
        points = sorted(equal, key=lambda e: evaluate(e, at).mid())
        kept: list[Expr] = []
        for e in points:
            if not kept or evaluate(e, at) > evaluate(kept[-1], at):
                kept.append(e)
    return kept, equal[kept[0]]


def is_between(e: Expr, low: Expr, high: Expr, at: dict[str, fmpq]) -> bool:
    """Return whether numbers show that ``e`` lies strictly between two ends, perhaps infinite."""
    if low == INFINITY or high == -INFINITY:
        return False  # the ends are equal or exchanged: nothing lies between them
    value = evaluate(e, at)
    above = low == -INFINITY or value > evaluate(low, at)
    below = high == INFINITY or value < evaluate(high, at)
    return bool(value.is_finite() and above and below)
