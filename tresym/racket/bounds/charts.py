"""Functions whose positivity implies the bounds on ε₀, in coordinates without singular corners.

All follow from the exact equation log(ε₀/ε*) = Q(ε₀). It expresses ε* explicitly in terms of ε₀, so
that statements about ε₀/ε* become statements about functions of ε₀, b and √(b/a), which are
enclosed on boxes. And since log e − Q(e) increases on (0, π/2), "ε₀ ≤ e" is equivalent to one
inequality at an explicit e, so that no root has to be found on a box. Two coordinate systems
(charts) are sufficient:

- (b, κ) with κ = 1/√(ab): then r = √(b/a) = bκ, and ε*² is flat at κ = 0;
- (b, k, …) with k = √(ab): then r tanh kP = bP tanh(kP)/(kP), so that a → 0 and b → 0 are edges.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

from flint import arb

from tresym.racket.flip.series import exponent_values, majorant
from tresym.reals.balls.gradient import Divided, Gradient, gradients
from tresym.reals.balls.tracing import Named, Part, traced
from tresym.reals.language.expression import PI, Expr, number, trees
from tresym.reals.numbers.arithmetic import balls

sine_over = Divided(lambda s: s.sin())
"""sin x / x."""
sine_rest = Divided(lambda s: s.sin(), 3)
"""(sin x − x)/x³."""
sine_further = Divided(lambda s: s.sin(), 5)
"""(sin x − x + x³/6)/x⁵."""
log1p_over = Divided(lambda s: (1 + s).log())
"""log(1 + x)/x."""
log1p_rest = Divided(lambda s: (1 + s).log(), 2)
"""(log(1 + x) − x)/x²."""
expm1_over = Divided(lambda s: s.exp())
"""(exp x − 1)/x."""
expm1_rest = Divided(lambda s: s.exp(), 2)
"""(exp x − 1 − x)/x²."""
expm1_further = Divided(lambda s: s.exp(), 3)
"""(exp x − 1 − x − x²/2)/x³."""
arcsine_over = Divided(lambda s: s.asin())
"""arcsin x / x."""
arcsine_rest = Divided(lambda s: s.asin(), 3)
"""(arcsin x − x)/x³."""
arctangent_over = Divided(lambda s: s.atan())
"""arctan x / x."""


@Part
def exponent_rate(defect: Any, b: Any, r: Any, m: Any) -> Any:
    """Return Q(e)/e², regular at e = 0 with value c₁; e = ``defect``, r = √(b/a).

    Q(e) = log(e/sin e) + log((cos e + ρ)/2) + √(ab)(arcsin μ − arcsin(μ cos e)),
    ρ = √(1 + r² sin²e). The last difference, of two angles, is computed from its sine.
    """
    sinc, half, cosine = sine_over(defect), sine_over(defect / 2), m.cos(defect)
    square = defect * defect
    root = m.sqrt(1 + r * r * square * sinc * sinc)
    mean = (r * r * sinc * sinc / (1 + root) - half * half / 2) / 2
    short = -sine_rest(defect)
    turn = sinc * sinc / (root + cosine)
    return (
        mean * log1p_over(square * mean)
        + short * log1p_over(-square * short)
        + b * turn * arcsine_over(r * square * turn)
    )


@Part
def exponent_bend(defect: Any, b: Any, r: Any, m: Any) -> Any:
    """Return (Q(e)/e² − c₁)/e², regular at e = 0: every difference in ``exponent_rate`` over e²."""
    R, square = r * r, defect * defect
    sinc, half, cosine = sine_over(defect), sine_over(defect / 2), m.cos(defect)
    short, root = -sine_rest(defect), m.sqrt(1 + R * square * sinc * sinc)
    rise, fall = R * sinc * sinc / (1 + root), -short * (1 + sinc)  # of the root, of (sin e/e)²
    mean = (rise - half * half / 2) / 2
    turn = sinc * sinc / (root + cosine)
    mean_bend = R * (2 * fall - rise) / (4 * (1 + root)) - sine_rest(defect / 2) * (1 + half) / 16
    turn_bend = (2 * fall - rise + half * half / 2) / (2 * (root + cosine))
    cube = turn * turn * turn
    return (
        mean_bend
        + mean * mean * log1p_rest(square * mean)
        - sine_further(defect)
        - short * short * log1p_rest(-square * short)
        + b * (turn_bend + R * square * cube * arcsine_rest(r * square * turn))
    )


def _flat(x: Any, rate: Any) -> Any:
    """exp(−rate/x) for x ≥ 0, with value 0 and slope 0 at x = 0; it increases with x.

    The slope rate/x² · exp(−rate/x) increases up to x = rate/2, where it is 4 e^{−2}/rate
    (`flat_bends`).
    """
    if isinstance(x, Gradient):
        at = x.value
        top = 4 * arb(-2).exp() / rate
        if at > 0:
            value = (-rate / at).exp()
            return x.chain(value, rate / at**2 * value)
        end = at.upper()
        highest = rate / end**2 * (-rate / end).exp() if end < rate / 2 else top
        return x.chain(_flat(at, rate), arb(0).union(highest))
    if x > 0:
        return (-rate / x).exp()
    end = x.upper()
    return arb(0).union((-rate / end).exp()) if end > 0 else arb(0)


def _ratio_is_positive(x: Expr, rate: Expr) -> tuple[Expr, ...]:
    return x, rate


flat = Named(_flat, lambda x, rate: trees.exp(-rate / x), asks=_ratio_is_positive)
"""exp(−rate/x) for x ≥ 0."""


class Shape(NamedTuple):
    """A shape in a chart: ε*, b and r = √(b/a), as balls or gradients."""

    leading: Any
    b: Any
    r: Any


def by_kappa(b: Any, kappa: Any, m: Any) -> Shape:
    """Return the shape in the chart (b, κ): a = 1/(bκ²)."""
    r = b * kappa
    small = flat(kappa, m.pi) * m.exp(-b * arctangent_over(r))
    return Shape(2 / m.sqrt(1 + r * r) * small, b, r)


def by_root(b: Any, k: Any, m: Any) -> Shape:
    """Return the shape in the chart (b, k) away from k = 0: a = k²/b."""
    r = b / k
    return Shape(2 / m.sqrt(1 + r * r) * m.exp(-k * (m.pi + m.atan(r))), b, r)


class Root(NamedTuple):
    """The exact defect ε₀ of a shape in a chart, with b and r = √(b/a)."""

    defect: Any
    b: Any
    r: Any


def root_by_kappa(b: Any, kappa: Any, m: Any) -> Root:
    """Return ε₀ in the chart (b, κ) as a ball: tan ε₀ = cos θ/sinh(P/κ), flat at κ = 0."""
    return Root(defect_by_kappa(b, kappa, m), b, b * kappa)


@Part
def defect_by_kappa(b: Any, kappa: Any, m: Any) -> Any:
    """Return ε₀ in the chart (b, κ)."""
    r = b * kappa
    small = flat(kappa, phase_by_kappa(b, kappa))
    tangent = 2 / m.sqrt(1 + r * r) * small / (1 - small * small)
    return m.atan(tangent)


def root_by_k(k: Any, alpha: Any, m: Any) -> Root:
    """Return ε₀ in the chart (k, α), α = 1/a, as a ball."""
    r = alpha * k
    b = r * k
    return Root(defect_by_k(b, k, m), b, r)


@Part
def defect_by_k(b: Any, k: Any, m: Any) -> Any:
    """Return ε₀ in the chart (b, k)."""
    return m.pi / 2 - m.atan(cotangent(b, k, phase_over(b, k), m))


def first_excess(root: Root, m: Any) -> Any:
    """Return (ε₀/ε* − 1)/ε*² in terms of ε₀: ε₀/ε* = exp Q and ε*² = ε₀² exp(−2Q)."""
    rate = exponent_rate(root.defect, root.b, root.r, m)
    exponent = root.defect * root.defect * rate
    return m.exp(2 * exponent) * rate * expm1_over(exponent)


def second_excess(root: Root, m: Any) -> Any:
    """Return (ε₀/ε* − 1 − c₁ε*²)/ε*⁴; exp Q − 1 − c₁ε₀² exp(−2Q) is expanded."""
    first = (6 * root.b + 3 * root.r * root.r - 1) / 12
    square, bend = root.defect * root.defect, exponent_bend(root.defect, root.b, root.r, m)
    rate = first + square * bend
    exponent = square * rate
    rest = rate * rate * expm1_rest(exponent) + 2 * first * rate * expm1_over(-2 * exponent)
    return m.exp(4 * exponent) * (bend + rest)


def gap_over(a: Any, root_b: Any, order: int, m: Any) -> tuple[Any, Any]:
    """Return (ε₀ − ε*(1 + …), ε*^{2·order+3}) with ``order`` = 0 or 1 terms, in the chart (a, √b).

    It subtracts two numbers and is for a where ε* is not small.
    """
    root_a = m.sqrt(a)
    k, b, r = root_a * root_b, root_b * root_b, root_b / root_a
    leading = 2 / m.sqrt(1 + b / a) * m.exp(-k * (m.pi + m.atan(r)))
    square = leading * leading
    series = 1 + order * square * (6 * b + 3 * b / a - 1) / 12
    defect = defect_by_k(b, k, m)
    return defect - leading * series, leading * square * (square if order else 1)


def growth(b: Any, kappa: Any, m: Any) -> tuple[Any, Any]:
    """Return τ = ε*² e^{2q}/ρ and e^q in the chart (b, κ), ρ = 1/(1 + 9R/4).

    They bound the terms of the series: |c_n| ε*^{2n} ≤ e^q τⁿ/(2n + 1); see
    :mod:`tresym.racket.flip.series`.
    """
    shape = by_kappa(b, kappa, m)
    R = shape.r * shape.r
    rho = 4 / (4 + 9 * R)
    half = m.exp(majorant(rho, b, R, m))
    return shape.leading * shape.leading * half * half / rho, half


TERMS = 8
"""Coefficients of Q that ``exponent_twist`` uses."""


def _exponent_twist(defect: arb, b: arb, r: arb) -> arb:
    """``exponent_twist`` term by term: |q_n| ≤ q/ρⁿ with ``majorant`` q at ρ = 1/(1 + 9R/4).

    The remainder after ``TERMS`` is bounded by a geometric series.
    """
    R, square = r * r, defect * defect
    rho = 4 / (4 + 9 * R)
    values, ratio = exponent_values(TERMS, b, R, balls), square / rho
    if not ratio < 1:
        return arb.nan()
    total = majorant(rho, b, R, balls) / rho**3 * ratio ** (TERMS - 2) / (1 - ratio) * arb(0, 1)
    powers = arb(1)
    for q in values[3:]:
        total, powers = total + q * powers, powers * square
    return total


def _steady(b: Any, R: Any) -> Any:
    """q₂ = c₂ − 5c₁²/2."""
    first = (6 * b + 3 * R - 1) / 12
    second = (50 * b * b + 40 * b * R + 5 * R * R - 20 * b - 10 * R + 1) / 80
    return second - first * first * 5 / 2


def _twist_meant(defect: Expr, b: Expr, r: Expr) -> Expr:
    def special(op: Any, args: tuple[Expr, ...], body: Any = None) -> Expr:
        found: Expr = op.meaning(*args)
        return found

    bend = traced(exponent_bend.formula, 3).meaning((defect, b, r), special)
    return (bend - _steady(b, r * r)) / defect**2


exponent_twist = Named(_exponent_twist, _twist_meant, asks=lambda defect, b, r: (defect, b, r))
"""((Q(e)/e² − c₁)/e² − q₂)/e², regular at e = ``defect`` = 0."""


def third_excess(root: Root, m: Any) -> Any:
    """Return (ε₀/ε* − 1 − c₁ε*² − c₂ε*⁴)/ε*⁶, expanded as in ``second_excess``."""
    R, square = root.r * root.r, root.defect * root.defect
    first, steady = (6 * root.b + 3 * R - 1) / 12, _steady(root.b, R)
    twist = exponent_twist(root.defect, root.b, root.r)
    bend = steady + square * twist
    rate = first + square * bend
    exponent = square * rate
    rest = twist + bend * (rate + first) / 2 + rate * rate * rate * expm1_further(exponent)
    rest = rest + 2 * first * (bend - 2 * rate * rate * expm1_rest(-2 * exponent))
    second = steady + first * first * 5 / 2
    return m.exp(6 * exponent) * (rest + 4 * second * rate * expm1_over(-4 * exponent))


def _between_ends(x: arb, function: Callable[[arb], arb]) -> arb:
    """An even function, monotone on x ≥ 0, over the ball ``x``: the hull of its end values."""
    low, high = x.lower(), x.upper()
    if low < 0:
        low, high = arb(0), high.max(-low)
    return function(low).union(function(high))


def _sine_point(x: arb) -> arb:
    return x.sinh() / x if x > 0 else arb(1)


def _sine_slope(x: arb) -> arb:
    """The derivative of sinh x/x at a point x ≥ 0; between x/3 and x cosh(x)/3, used when small."""
    if x > arb("1e-5"):
        return (x.cosh() - x.sinh() / x) / x
    return (x / 3).union(x * x.cosh() / 3)


def _hyperbolic_sine_over(x: Any) -> Any:
    """sinh x/x, an even function."""
    if not isinstance(x, Gradient):
        return _between_ends(abs(x), _sine_point)
    slope = _between_ends(abs(x.value), _sine_slope)
    if not x.value > 0:
        slope = -slope if x.value < 0 else slope.union(-slope)
    return x.chain(_between_ends(abs(x.value), _sine_point), slope)


hyperbolic_sine_over = Named(_hyperbolic_sine_over, lambda x: trees.sinh(x) / x)
"""sinh x/x."""


def _hyperbolic_tangent_over(x: Any) -> Any:
    """tanh x/x for x ≥ 0."""
    at = x.value if isinstance(x, Gradient) else x
    value = _between_ends(at, lambda t: t.tanh() / t if t > 0 else arb(1))
    if not isinstance(x, Gradient):
        return value
    quotient = hyperbolic_sine_over(x) / gradients.cosh(x)
    return Gradient(value, quotient.slopes)


hyperbolic_tangent_over = Named(
    _hyperbolic_tangent_over, lambda x: trees.tanh(x) / x, asks=lambda x: (x,)
)
"""tanh x/x for x ≥ 0."""


def _spread(b: Any, k: Any, phase: Any, m: Any) -> Any:
    """D = cosh²kP + r² sinh²kP in the chart (b, k)."""
    return m.cosh(k * phase) ** 2 + (b * phase * hyperbolic_sine_over(k * phase)) ** 2


def _phase_over(b: Any, k: Any) -> Any:
    """A ball (or gradient) that contains the phase of every shape in the chart (b, k).

    Every root of P = π + arctan(bP tanhc kP) lies in [π, 3π/2], and in the image of every interval
    that contains it; so it lies in all iterates. The derivatives are those of the implicit
    function.
    """
    b0 = b.value if isinstance(b, Gradient) else b
    k0 = k.value if isinstance(k, Gradient) else k
    phase = balls.pi.union(3 * balls.pi / 2)
    while True:
        image = _phase_image(b0, k0, phase, balls).intersection(phase)
        if not image.rad() < phase.rad() * arb("0.9"):
            break
        phase = image
    if not isinstance(b, Gradient):
        return phase
    partial = _phase_image(b, k, phase, gradients)
    return Gradient(phase, (partial / (1 - b0 / _spread(b0, k0, phase, balls))).slopes)


ENDS = PI, 3 * PI / 2
"""The phase of every shape lies between them."""
phase_over = Named(
    _phase_over,
    image=lambda phase, b, k: PI + trees.atan(b / k * trees.tanh(k * phase)),
    between=ENDS,
    asks=lambda b, k: (b, k),
)
"""The phase P = π + arctan(r tanh kP), r = b/k, in the chart (b, k)."""


def _phase_image(b: Any, k: Any, phase: Any, m: Any) -> Any:
    return m.pi + m.atan(b * phase * hyperbolic_tangent_over(k * phase))


def _root_above(x: Any) -> Any:
    """√x of a number that is known to be non-negative, even if its ball is not."""
    return gradients.sqrt(x) if isinstance(x, Gradient) else x.nonnegative_part().sqrt()


root_above = Named(_root_above, trees.sqrt)


@Part
def cotangent(b: Any, k: Any, phase: Any, m: Any) -> Any:
    """Return cot ε₀ = √(1 + r²) sinh kP = √(k² + b²) P sinhc kP in the chart (b, k)."""
    square = k * k + b * b
    return root_above(square) * phase * hyperbolic_sine_over(k * phase)


@Part
def angle_difference(tangent_error: Any, cotangent_: Any, m: Any) -> Any:
    """Return ε − ε₀ from tan ε/tan ε₀ − 1 and cot ε₀, as a single arctangent."""
    w, e = cotangent_, tangent_error
    return m.atan(e * w / (w * w + 1 + e))


@Part
def angle_of(cotangent_: Any, m: Any) -> Any:
    """Return the angle between 0 and π/2 with this cotangent."""
    return m.pi / 2 - m.atan(cotangent_)


def angle_error(tangent_error: Any, cotangent_: Any, m: Any) -> Any:
    """Return ε/ε₀ − 1 from tan ε/tan ε₀ − 1 and cot ε₀."""
    return angle_difference(tangent_error, cotangent_, m) / angle_of(cotangent_, m)


@Part
def tangent_error(difference: Any, phase: Any, k: Any, m: Any) -> Any:
    """Return sinh kP / sinh kP₁ − 1 from P − P₁ and P, without cancellation."""
    other = phase - difference
    ratio = hyperbolic_sine_over(k * difference / 2) / hyperbolic_sine_over(k * other)
    return difference / other * ratio * m.cosh(k * (phase + other) / 2)


@Part
def sweep_difference(b: Any, k: Any, phase: Any, start: Any, m: Any) -> Any:
    """Return P − P₁ for P₁ = π + arctan(r tanh(start·k)), with the factor P − start."""
    gap = phase - start
    x = b * phase * hyperbolic_tangent_over(k * phase)
    y = b * start * hyperbolic_tangent_over(k * start)
    top = b * gap * hyperbolic_sine_over(k * gap)
    return m.atan(top / (m.cosh(k * phase) * m.cosh(k * start) * (1 + x * y)))


def sweep_error(b: Any, k: Any, start: Any, m: Any) -> Any:
    """Return ε/ε₀ − 1 of one sweep from ``start``."""
    phase = phase_over(b, k)
    error = tangent_error(sweep_difference(b, k, phase, start, m), phase, k, m)
    return angle_error(error, cotangent(b, k, phase, m), m)


def _phase_bend(b: arb, k: arb, phase: arb, other: arb) -> arb:
    """Minus half the second derivative at a point between the two, by Taylor's theorem."""
    at = phase.union(other)
    rise = balls.cosh(k * at) * at * hyperbolic_sine_over(k * at) * (k * k + b * b)
    return b * rise / _spread(b, k, at, balls) ** 2


def _bend_meant(share: Expr, rate: Callable[[Expr], Expr], phase: Expr, other: Expr) -> Expr:
    """The function that ``phase_bend`` encloses, for A(x) = arctan(``share`` tanh ``rate``(x))."""

    def turn(x: Expr) -> Expr:
        return trees.atan(share * trees.tanh(rate(x)))

    spread = trees.cosh(rate(other)) ** 2 + share**2 * trees.sinh(rate(other)) ** 2
    slope = rate(share) / spread
    rest = turn(phase) - turn(other) - slope * (phase - other)
    return -rest / (phase - other) ** 2


phase_bend = Named(
    _phase_bend,
    lambda b, k, *ends: _bend_meant(b / k, lambda x: k * x, *ends),
    asks=lambda b, k, *_: (b, k),
)
"""The height of the tangent at ``other`` to A(P) = arctan(r tanh kP) above A at ``phase``, over the
square of their distance, in the chart (b, k)."""


@Part
def newton_excess(b: Any, k: Any, phase: Any, start: Any, m: Any) -> Any:
    """Return P₂ − P of one Newton step after one sweep from ``start``, P₁; A′ = b/D."""
    difference = sweep_difference(b, k, phase, start, m)
    swept = m.pi + m.atan(b * start * hyperbolic_tangent_over(k * start))
    bend = phase_bend(b, k, phase, swept)
    return bend * difference * difference / (1 - b / _spread(b, k, swept, m))


def newton_error(b: Any, k: Any, start: Any, m: Any) -> Any:
    """Return ε/ε₀ − 1 of one Newton step after one sweep from ``start``."""
    phase = phase_over(b, k)
    error = tangent_error(-newton_excess(b, k, phase, start, m), phase, k, m)
    return angle_error(error, cotangent(b, k, phase, m), m)


@Part
def far_difference(b: Any, kappa: Any, phase: Any, start: Any, m: Any) -> Any:
    """Return T − T₁ of one sweep in the chart (b, κ), from f = e^{−2T}, g = e^{−2·start/κ}.

    tanh T − tanh(start/κ) = 2(g − f)/((1 + f)(1 + g)), and r/κ = b.
    """
    r, f, g = b * kappa, flat(kappa, 2 * phase), flat(kappa, 2 * start)
    gap = 2 * (g - f) / ((1 + f) * (1 + g))
    gap = gap / (1 + r * r * (1 - f) / (1 + f) * (1 - g) / (1 + g))
    return b * gap * arctangent_over(r * gap)


@Part
def far_error(difference: Any, phase: Any, kappa: Any, m: Any) -> Any:
    """Return sinh T/sinh(T − ``difference``) − 1 in the chart (b, κ), that is tan ε/tan ε₀ − 1."""
    f, growth = flat(kappa, 2 * phase), m.exp(difference)
    return m.expm1(difference) * (1 + f * growth) / (1 - f * growth * growth)


@Part
def tangent_by_kappa(b: Any, kappa: Any, phase: Any, m: Any) -> Any:
    """Return tan ε₀ in the chart (b, κ)."""
    r, small = b * kappa, flat(kappa, phase)
    return 2 / m.sqrt(1 + r * r) * small / (1 - small * small)


@Part
def far_angle_error(tangent_error_: Any, tangent: Any, m: Any) -> Any:
    """Return ε/ε₀ − 1 from tan ε/tan ε₀ − 1 and tan ε₀."""
    share = tangent_error_ / (1 + tangent * tangent * (1 + tangent_error_))
    return share * arctangent_over(tangent * share) / arctangent_over(tangent)


def far_sweep_error(b: Any, kappa: Any, start: Any, m: Any) -> Any:
    """Return ε/ε₀ − 1 of one sweep from ``start`` in the chart (b, κ)."""
    phase = phase_by_kappa(b, kappa)
    error = far_error(far_difference(b, kappa, phase, start, m), phase, kappa, m)
    return far_angle_error(error, tangent_by_kappa(b, kappa, phase, m), m)


def _far_bend(b: arb, kappa: arb, phase: arb, other: arb) -> arb:
    r, between = b * kappa, flat(kappa, 2 * phase.union(other))
    spread = (1 + between) ** 2 + r * r * (1 - between) ** 2
    return 4 * b * (1 + r * r) * between * (1 - between * between) / spread**2


far_bend = Named(
    _far_bend,
    lambda b, kappa, *ends: kappa * _bend_meant(b * kappa, lambda x: x / kappa, *ends),
    asks=lambda b, kappa, phase, other: (b, kappa, phase, other),
)
"""κ ``phase_bend`` in the chart (b, κ)."""


@Part
def far_newton_excess(b: Any, kappa: Any, phase: Any, start: Any, m: Any) -> Any:
    """Return T₂ − T of one Newton step after one sweep from ``start`` in the chart (b, κ).

    As in ``newton_excess``; D = [(1 + φ)² + r²(1 − φ)²]/(4φ), φ = e^{−2P₁/κ}.
    """
    difference = far_difference(b, kappa, phase, start, m)
    swept = phase - kappa * difference
    r, at = b * kappa, flat(kappa, 2 * swept)
    spread = (1 + at) ** 2 + r * r * (1 - at) ** 2
    bend = far_bend(b, kappa, phase, swept)
    return bend * difference * difference / (1 - 4 * b * at / spread)


def far_newton_error(b: Any, kappa: Any, start: Any, m: Any) -> Any:
    """Return ε/ε₀ − 1 of one Newton step after one sweep, in the chart (b, κ)."""
    phase = phase_by_kappa(b, kappa)
    error = far_error(-far_newton_excess(b, kappa, phase, start, m), phase, kappa, m)
    return far_angle_error(error, tangent_by_kappa(b, kappa, phase, m), m)


arctangent_rest = Divided(lambda s: s.atan(), 3)
"""(arctan x − x)/x³."""


def printed_excess(r: Any, m: Any) -> Any:
    """Return (arctan r/r − 1/√(1 + r²))/r² = log(printed/ε*)/(b r²); it is 1/6 at r = 0."""
    root = m.sqrt(1 + r * r)
    return arctangent_rest(r) + 1 / (root * (root + 1))


def _flat_over(x: arb) -> arb:
    """exp(−2π/x)/x² for 0 ≤ x ≤ 3; it increases up to x = π."""

    def at(end: arb) -> arb:
        return (-2 * balls.pi / end).exp() / end**2 if end > 0 else arb(0)

    return _between_ends(x, at) if x <= 3 else arb.nan()


flat_over = Named(
    _flat_over, lambda x: trees.exp(-2 * PI / x) / x**2, asks=lambda x: (x, number(3) - x)
)


@Part
def leading_square_over(b: arb, kappa: arb, m: Any) -> arb:
    """Return ε*²/κ² in the chart (b, κ), κ ≤ 3; exp(−2π/κ)/κ² increases up to κ = π."""
    r = b * kappa
    return 4 / (1 + r * r) * flat_over(kappa) * m.exp(-2 * b * arctangent_over(r))


def _phase_by_kappa(b: Any, kappa: Any) -> Any:
    """The phase P = π + arctan(r tanh P/κ) in the chart (b, κ) as a ball; see ``phase_over``."""
    phase = balls.pi.union(3 * balls.pi / 2)
    while True:
        small = flat(kappa, 2 * phase)
        image = balls.pi + balls.atan(b * kappa * (1 - 2 * small / (1 + small)))
        image = image.intersection(phase)
        if not image.rad() < phase.rad() * arb("0.9"):
            return phase
        phase = image


phase_by_kappa = Named(
    _phase_by_kappa,
    image=lambda phase, b, kappa: PI + trees.atan(b * kappa * trees.tanh(phase / kappa)),
    between=ENDS,
    asks=lambda b, kappa: (b, kappa),
)
"""The phase P = π + arctan(r tanh P/κ), r = bκ, in the chart (b, κ), a ball."""


def defect_over_kappa(b: arb, kappa: arb, m: Any) -> arb:
    """Return ε₀/κ = (ε*/κ) exp Q in the chart (b, κ), κ ≤ 3."""
    e, _, r = root_by_kappa(b, kappa, m)
    growth = m.exp(e * e * exponent_rate(e, b, r, m))
    return growth * root_above(leading_square_over(b, kappa, m))


def slope_rest(b: Any, kappa: Any, m: Any) -> Any:
    """Return κ(−4bε₀ dε/dγ − 1)/ε₀² at γ = 0 in the chart (b, κ), as a ball."""
    e, _, r = root_by_kappa(b, kappa, m)
    return slope_rest_at(e, b, r, kappa, phase_by_kappa(b, kappa), m)


def slope_rest_at(e: Any, b: Any, r: Any, kappa: Any, phase: Any, m: Any) -> Any:
    """Return ``slope_rest`` from known ε₀ = ``e`` and phase.

    −4bε dε/dγ = [(ε/s) c (1 + Rs²) + ε s (1 − R − 2b) T √(1 + Rs²)]/(1 − bs²) with s = sin ε₀,
    c = cos ε₀ and κT the phase.
    """
    sinc, half = sine_over(e), sine_over(e / 2)
    square = e * e * sinc * sinc
    root = m.sqrt(1 + r * r * square)
    cotangent_rest = (-half * half / 2 - sine_rest(e)) / sinc
    algebraic = cotangent_rest + m.cos(e) * r * r * sinc + b * sinc * sinc
    turning = sinc * (1 - r * r - 2 * b) * phase * root
    return (kappa * algebraic + turning) / (1 - b * square)


def cubic_gap(b: Any, k: Any, m: Any) -> tuple[Any, Any]:
    """Return (ε₀ − ε*, q³) with q = e^{−k(π + arctan r)} in the chart (b, k), away from k = 0."""
    shape = by_root(b, k, m)
    decay = m.exp(-k * (m.pi + m.atan(shape.r)))
    defect = defect_by_k(b, k, m)
    return defect - shape.leading, decay * decay * decay
