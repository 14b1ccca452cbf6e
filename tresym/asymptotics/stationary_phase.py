"""Oscillating integrals ∫ q(t) cos(λ(x) p(t) + φ(x)) dt with λ → ∞: ends, and stationary points.

*Ends.* Where p′ ≠ 0, integration by parts gives for u₀ = q/p′ and u_(j+1) = u_j′/p′

    ∫ q cos θ dt = Σ_(j<n) λ^(−j−1) [u_j sin(θ + jπ/2)] + R,
    |R| ≤ λ^(−n−1) (|u_n| at both ends + ∫ |u_n′|),

with θ = λp + φ; at infinity all u_j must tend to 0, and u_n′ must be integrable.

*Stationary points.* Where p′(t₀) = 0 and p″(t₀) ≠ 0, put v = √|p − p₀| on each side and φ = q/v′.
If (φ − φ(0))/v has bounded variation on the side, it adds

    φ(0) ½ √(π/λ) cos(λp₀ + φ ± π/4) + O(1/λ).

The range is cut between stationary points. Sines are cosines of θ − π/2.

Example: ``integral(cos(x*cos(t)), t, 0, pi) == sqrt(2*pi/x)*cos(x - pi/4) + O(1/x)``.

Sources: Olver 1974, ch. 3, §§2, 5 and 11–13; DLMF 2.3(i), 2.3(iv).
"""

from __future__ import annotations

from itertools import pairwise
from typing import NamedTuple

from flint import arb, fmpq

from tresym.asymptotics.integrands import separated
from tresym.asymptotics.laplace import SCALES, is_between
from tresym.asymptotics.lemma import Bound, End, Expansion, Obligations
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
    factors_in,
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
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.signs.sign import sign
from tresym.reals.verdict import Verdict

ENDS = "integration by parts of an oscillating integral (Olver 1974, ch. 3, §2)"
PHASE = "the method of stationary phase (Olver 1974, ch. 3, §11)"
MOST_POINTS = 4
_INFINITE = (INFINITY, -INFINITY)


class Wave(NamedTuple):
    """The integrand ``factor``·q·cos(``rate``·p + ``phase``), where ``rate`` tends to +∞."""

    factor: Expr
    rate: Expr
    p: Expr
    phase: Expr
    q: Expr
    t: str
    low: Expr
    high: Expr


class Ends(Expansion):
    """The contributions of both ends, where the phase is nowhere stationary."""

    lemma = ENDS

    def __init__(self, wave: Wave, end: End) -> None:
        """Expand an integral whose phase has p′ ≠ 0."""
        self.wave, self.end = wave, end
        self.slope = differentiate(wave.p, wave.t)
        self.u = [wave.q / self.slope]

    def _u(self, n: int) -> Expr:
        while len(self.u) <= n:
            following = differentiate(self.u[-1], self.wave.t) / self.slope
            near = self.closed
            form = normal_form(following, near) if following.size > 40 else following
            self.u.append(form if form.size < following.size else following)
        return self.u[n]

    @property
    def closed(self) -> Given:
        """Return the conditions on the variable of integration, ends included."""
        w, t = self.wave, symbol(self.wave.t)
        lower = () if w.low in _INFINITE else ((t, ">=", w.low),)
        upper = () if w.high in _INFINITE else ((t, "<=", w.high),)
        return self.end.given & Given((*lower, *upper))

    def terms(self, order: int) -> tuple[Expr, Expr] | None:
        """Return the first terms of both ends, and the power of λ of the first omitted one."""
        w, parts = self.wave, []
        for j in range(order):
            for place, side in ((w.high, 1), (w.low, -1)):
                if place in _INFINITE:
                    continue
                value = substitute(self._u(j), {w.t: place})
                theta = w.rate * substitute(w.p, {w.t: place}) + w.phase
                kind, flip = (("sin", 1), ("cos", 1), ("sin", -1), ("cos", -1))[j % 4]
                term = side * flip * value * apply(kind, theta)
                parts.append(term * power(w.rate, number(-j - 1)))
        size = power(w.rate, number(-order - 1))
        return w.factor * add(ZERO, *parts), _size(w.factor, self.end) * size

    def prove(self, order: int, ask: Obligations) -> Bound | None:
        """Prove that p′ ≠ 0, and that the last function has bounded variation."""
        w = self.wave
        closed = self.closed
        if not (
            ask.continuous(w.q, closed)
            and ask.continuous(w.p, closed)
            and any(ask.holds(self.slope, relation, ZERO, closed) for relation in "><")
        ):
            return None
        for place, side in ((w.low, -1), (w.high, 1)):
            if place not in _INFINITE:
                continue
            far = End(w.t, None, side, self.end.given)
            if any(far.limit(self._u(j)) != ZERO for j in range(order + 1)):
                return None
            last = differentiate(self._u(order), w.t)
            gauges = (power(side * symbol(w.t), number(-r)) for r in (fmpq(2), fmpq(3, 2)))
            if not any(ask.holds(last, "O", gauge, far.given, far.path) for gauge in gauges):
                return None
        return Bound()


class StationaryPoints(Expansion):
    """The leading terms of stationary points; the ends are in the error."""

    lemma = PHASE

    def __init__(self, wave: Wave, points: list[Expr], end: End) -> None:
        """Expand an integral with these stationary points, in increasing order."""
        self.wave, self.end = wave, end
        self.parts: list[tuple[Expr, int, Expr, Expr, Expr, Expr | None]] = []
        cuts = [normal_form((a + b) / 2, end.given) for a, b in pairwise(points)]
        starts, stops = [wave.low, *cuts], [*cuts, wave.high]
        self.s = fresh("s" if wave.t != "s" else "u", {wave.t, *end.taken})
        for point, start, stop in zip(points, starts, stops, strict=True):
            for direction, far in ((1, stop), (-1, start)):
                if far != point:
                    self._add(point, direction, far)

    def _add(self, point: Expr, direction: int, far: Expr) -> None:
        w, s = self.wave, symbol(self.s)
        put = {w.t: point + direction * s}
        p0 = substitute(w.p, {w.t: point})
        p, q = substitute(w.p, put) - p0, substitute(w.q, put)
        bend = limit_of(p / s**2, self.s, ZERO, 1, self.end.given)
        side = 0 if bend is None or bend in _INFINITE else _sign(bend, self.end.given)
        if not side:
            raise InputError("the phase is not stationary of second order")
        p = p if side > 0 else -p
        width = None if far in _INFINITE else normal_form(direction * (far - point), self.end.given)
        phi = 2 * q * sqrt(p) / differentiate(p, self.s)
        first = limit_of(phi, self.s, ZERO, 1, self.end.given)
        if first is None or first in _INFINITE:
            raise InputError("the integrand is singular at a stationary point")
        self.parts.append((first, side, p0, p, q, width))

    def terms(self, order: int) -> tuple[Expr, Expr] | None:
        """Return the leading terms, at order 1 alone."""
        if order != 1:
            return None
        w = self.wave
        found = [
            first * sqrt(PI / w.rate) / 2 * apply("cos", w.rate * p0 + w.phase + side * PI / 4)
            for first, side, p0, _, _, _ in self.parts
        ]
        return w.factor * add(ZERO, *found), _size(w.factor, self.end) / w.rate

    def prove(self, order: int, ask: Obligations) -> Bound | None:
        """Prove on every side that the phase is monotone and the variation is bounded."""
        s = symbol(self.s)
        for first, _, _, p, q, width in self.parts:
            upper = () if width is None else ((s, "<=", width),)
            given = self.end.given & Given(((s, ">", ZERO), *upper))
            if not (
                ask.continuous(p, given)
                and ask.continuous(q, given)
                and ask.holds(differentiate(p, self.s), ">", ZERO, given)
            ):
                return None
            phi = 2 * q * sqrt(p) / differentiate(p, self.s)
            if decide(phi, first, given).verdict is Verdict.PROVED:
                continue
            rest = (phi - first) / sqrt(p)
            slope = differentiate(rest, self.s)
            near = [limit_of(e, self.s, ZERO, 1, self.end.given) for e in (rest, slope)]
            if any(value is None or value in _INFINITE for value in near):
                return None
            ask.keep(f"{rest} has bounded variation near {self.s} = 0", given, Verdict.PROVED)
            if width is None:
                far = End(self.s, None, 1, self.end.given)
                gauges = (power(s, number(-r)) for r in (fmpq(2), fmpq(3, 2)))
                if far.limit(rest) != ZERO or not any(
                    ask.holds(slope, "O", gauge, far.given, far.path) for gauge in gauges
                ):
                    return None
        return Bound()


def _sign(e: Expr, given: Given) -> int:
    return {"+": 1, "-": -1}.get(sign(e, given, "!=") or "", 0)


def _size(factor: Expr, end: End) -> Expr:
    near = Given(((symbol(end.name), ">", ZERO),)) & end.given
    return factor if sign(factor, near) == "+" else apply("abs", factor)


def stationary_phase(node: Expr, end: End) -> Expansion | None:
    """Return the expansion of an integral with one cosine or sine of λ(x) p(t), or None."""
    if node.op != "integral":
        return None
    for alpha in (None, *SCALES):
        try:
            wave = _wave(node, end, alpha)
            found = None if wave is None else _expansion(wave, end)
        except (InputError, ZeroDivisionError, OverflowError):
            continue
        if found is not None and found.terms(1) is not None:
            return found
    return None


def _expansion(wave: Wave, end: End) -> Expansion | None:
    slope = differentiate(wave.p, wave.t)
    places = [ZERO, *(e for e in (wave.low, wave.high) if e not in _INFINITE)]
    places += [normal_form(e, end.given) for e in solutions(slope, wave.t)]
    found: dict[Expr, arb] = {}
    if symbols(wave.p) - {wave.t} or any(symbols(e) - {"oo"} for e in (wave.low, wave.high)):
        return Ends(wave, end)
    with ball_precision():
        for e in dict.fromkeys(places):
            inner = e in (wave.low, wave.high) or is_between(e, wave.low, wave.high, {})
            value = evaluate(substitute(slope, {wave.t: e}), {}) if inner else arb(1)
            at = evaluate(e, {}) if e not in _INFINITE else arb.nan()
            if value.contains(0) and not any(at.overlaps(other) for other in found.values()):
                found[e] = at
    points = sorted(found, key=lambda e: found[e].mid())
    if not points:
        return Ends(wave, end)
    return StationaryPoints(wave, points, end) if len(points) <= MOST_POINTS else None


def _wave(node: Expr, end: End, alpha: fmpq | None) -> Wave | None:
    """Return the integrand with its variable rescaled by a power of x, if it has the shape."""
    (t,), body = opened(node, end.taken)
    low, high = node.args[1:]
    near = end.given & Given(((symbol(end.name), ">", ZERO),))
    if alpha is not None:
        if end.point not in (None, ZERO) or end.side != 1:
            return None
        stretch = power(symbol(end.name), number(alpha))
        body = substitute(body, {t: stretch * symbol(t)}) * stretch
        low, high = (
            e if e in (ZERO, *_INFINITE) else normal_form(e / stretch, near) for e in (low, high)
        )
    if any(end.name in symbols(e) for e in (low, high)):
        return None
    outside, weight, waves = [], [], []
    for f in factors_in(body):
        if t not in symbols(f):
            outside.append(f)
        elif end.name not in symbols(f):
            weight.append(f)
        elif f.op in ("cos", "sin"):
            waves.append(f)
        else:
            split = separated(f, t, end)
            if split is None or len(split) != 1:
                return None
            outside.append(split[0][0])
            weight.append(split[0][1])
    if len(waves) != 1:
        return None
    terms = separated(waves[0].args[0], t, end)
    if terms is None:
        return None
    phase = ZERO if waves[0].op == "cos" else -PI / 2
    groups: list[tuple[Expr, list[Expr]]] = []
    for of_x, of_t in terms:
        if t not in symbols(of_t):
            phase = phase + of_x * of_t
        elif end.name not in symbols(of_x):
            return None
        elif groups and end.name not in symbols(ratio := normal_form(of_x / groups[0][0], near)):
            groups[0][1].append(ratio * of_t)
        else:
            groups.append((of_x, [of_t]))
    if len(groups) != 1:
        return None
    rate, parts = groups[0]
    last, p = end.limit(rate), add(*parts)
    if last == -INFINITY:
        rate, p = -rate, -p
    elif last != INFINITY:
        return None
    factor = normal_form(multiply(*outside), near) if outside else ONE
    return Wave(factor, rate, p, phase, multiply(*weight), t, low, high)
