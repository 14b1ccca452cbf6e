"""The functions whose positivity the bounds on ε₀ come down to, in charts where no corner is left.

Everything rests on the exact equation log(ε₀/ε*) = Q(ε₀): since log e − Q(e) increases on (0, π/2),
ε₀ ≤ e exactly when Q(e) ≤ log(e/ε*). A bound on ε₀ is therefore one sign at an explicit candidate e
and no root is solved in a box. Two charts cover what is needed:

- (b, κ) with κ = 1/√(ab): then r = √(b/a) = bκ, and ε*² is flat at κ = 0;
- (b, k, …) with k = √(ab): then r tanh kP = bP tanh(kP)/(kP), so that a → 0 and b → 0 are edges.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from flint import arb

from tresym.arithmetic import balls
from tresym.claims.gradient import Divided, Gradient
from tresym.flip.series import coefficient_values, tail

sine_over = Divided(lambda s: s.sin())
"""sin x / x."""
sine_rest = Divided(lambda s: s.sin(), 3)
"""(sin x − x)/x³."""
log1p_over = Divided(lambda s: (1 + s).log())
"""log(1 + x)/x."""
arcsine_over = Divided(lambda s: s.asin())
"""arcsin x / x."""
arctangent_over = Divided(lambda s: s.atan())
"""arctan x / x."""


def exponent_rate(defect: Any, b: Any, r: Any, m: Any) -> Any:
    """Q(e)/e², regular at e = 0 where it is c₁; e = ``defect``, r = √(b/a).

    Q(e) = log(e/sin e) + log((cos e + ρ)/2) + √(ab)(arcsin μ − arcsin(μ cos e)),
    ρ = √(1 + r² sin²e); the last difference is that of two angles, taken by its sine.
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


def flat(x: Any, rate: Any) -> Any:
    """exp(−rate/x) for x ≥ 0, with its value 0 and slope 0 at x = 0; increasing.

    The slope rate/x² · exp(−rate/x) increases up to x = rate/2, where it is 4 e^{−2}/rate.
    """
    if isinstance(x, Gradient):
        at = x.value
        top = 4 * arb(-2).exp() / rate
        if at > 0:
            value = (-rate / at).exp()
            return x.chain(value, rate / at**2 * value)
        end = at.upper()
        highest = rate / end**2 * (-rate / end).exp() if end < rate / 2 else top
        return x.chain(flat(at, rate), arb(0).union(highest))
    if x > 0:
        return (-rate / x).exp()
    end = x.upper()
    return arb(0).union((-rate / end).exp()) if end > 0 else arb(0)


class Shape(NamedTuple):
    """A shape in a chart: ε*, b and r = √(b/a), as balls or gradients."""

    leading: Any
    b: Any
    r: Any


def by_kappa(b: Any, kappa: Any, m: Any) -> Shape:
    """The chart (b, κ): a = 1/(bκ²)."""
    r = b * kappa
    small = flat(kappa, balls.pi) * m.exp(-b * arctangent_over(r))
    return Shape(2 / m.sqrt(1 + r * r) * small, b, r)


def by_k(k: Any, alpha: Any, m: Any) -> Shape:
    """The chart (k, α) with α = 1/a: b = αk², so that a → ∞ and ab → 0 are edges."""
    r = alpha * k
    return Shape(2 / m.sqrt(1 + r * r) * m.exp(-k * (m.pi + m.atan(r))), alpha * k * k, r)


def above(shape: Shape, constant: Any, m: Any) -> Any:
    """Positive where ε₀ < ε*(1 + K ε*²); divided by ε*²."""
    y = shape.leading * shape.leading
    growth = 1 + constant * y
    rate = exponent_rate(shape.leading * growth, shape.b, shape.r, m)
    return constant * log1p_over(constant * y) - growth * growth * rate


def below(shape: Shape, constant: Any, m: Any) -> Any:
    """Positive where ε₀ > ε*(1 − K ε*²); divided by ε*²."""
    y = shape.leading * shape.leading
    growth = 1 - constant * y
    rate = exponent_rate(shape.leading * growth, shape.b, shape.r, m)
    return growth * growth * rate + constant * log1p_over(-constant * y)


def above_anywhere(shape: Shape, constant: Any, m: Any) -> Any:
    """As ``above`` (balls only), also where the candidate is beyond π/2 and nothing is to show."""
    candidate = shape.leading * (1 + constant * shape.leading**2)
    beyond = candidate - m.pi / 2
    return beyond if beyond > 0 else above(shape, constant, m).max(beyond)


def below_anywhere(shape: Shape, constant: Any, m: Any) -> Any:
    """As ``below`` (balls only), also where the candidate is negative and nothing is to show.

    log(1 − z)/(−z) increases with z, so that it is bounded below by its value at min(z, 1/2).
    """
    part = constant * shape.leading**2
    if part > 1:
        return part - 1
    growth = 1 - part
    rate = exponent_rate(shape.leading * growth, shape.b, shape.r, m)
    least = log1p_over(-part.min(arb(1) / 2))
    return (growth * growth * rate + constant * least).max(part - 1)


def remainder(shape: Shape, order: int, terms: int, m: Any) -> tuple[Any, Any]:
    """(ε₀/ε* − Σ_{n≤order} c_n ε*^{2n})/ε*^{2(order+1)}: the middle and the radius it is within.

    The middle is the series up to ``terms``, the radius its truncation bound with ρ = 1/10, which
    applies on ab ≥ 1/4.
    """
    y, R = shape.leading * shape.leading, shape.r * shape.r
    values = coefficient_values(terms, shape.b, R, m)[order + 1 :]
    middle = values[-1]
    for c in reversed(values[:-1]):
        middle = middle * y + c
    return middle, tail(terms, y, shape.b, R, arb(1) / 10, m, order + 1)
