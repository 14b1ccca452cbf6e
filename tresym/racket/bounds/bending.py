"""The curvature of ε(γ) near the separatrix, in coordinates for every shape with ab ≥ 1/4.

ε(γ) solves F(ε, γ) = π, and F decreases in ε: where H(v) = √(ab) (F(e(v), bε₀²v) − π) ≤ 0 the curve
lies below the comparison function e(v). For e = ε₀(1 + (pλ − 1/4)v + Cλv²), whose slope is the
exact one, and λ = √(ab) ε₀², H and H′ vanish at v = 0. So by Taylor's theorem H has the sign that
H″ has on an interval around 0. To leading order ε + √(ε² + γ/b) = 2ε₀, which is linear in γ: H″ is
of the order λ, and is divided by λ here algebraically. With u = γ/b, s = sin e, z = √(u + s²) and w
= s + z,

    √(ab) F = ∫ (1 − b sin²ψ)/(√(1 + R sin²ψ) √(u + sin²ψ)) dψ,      R = b/a,

is log((1 + √(1 + u))/w), from cos ψ in place of the bounded factor, plus an integral with
sin²ψ j(ψ), j bounded. Lengths with a hat below are divided by ε₀.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from flint import arb, fmpq

from tresym.racket.bounds import charts
from tresym.reals.numbers.arithmetic import balls
from tresym.reals.numbers.exact import Interval

PIECES = 4
"""The number of subintervals of 0 ≤ sin²ψ ≤ 1 on which the remainder of j is enclosed."""


def second_order_rest(b: arb, R: arb) -> arb:
    """Enclose (j(ψ) − j(0) cos ψ)/sin²ψ on 0 ≤ ψ ≤ π/2; x = sin²ψ, c = cos ψ, ρ = √(1 + Rx).

    j = −b/ρ − R/(ρ(1 + ρ)) + 1/(1 + c), and 1 − ρc = x(1 − R + Rx)/(1 + ρc).
    """
    total = None
    for i in range(PIECES):
        x = Interval(fmpq(i, PIECES), fmpq(i + 1, PIECES)).ball()
        c = (1 - arb(fmpq(i, PIECES))).sqrt().union((1 - arb(fmpq(i + 1, PIECES))).sqrt())
        rho = (1 + R * x).sqrt()
        gap = (1 - R + R * x) / (1 + rho * c)
        part = (2 + c) / (2 * (1 + c) ** 2) - b * gap / rho
        part -= R * (gap + 1 / (1 + c) - c * R) / (2 * rho * (1 + rho))
        total = part if total is None else total.union(part)
    assert total is not None
    return total


def fourth_moment(kappa: arb, v: arb, e: arb, q: arb, y: arb, w: arb, far: arb, f: arb) -> arb:
    """Bound κ ∫ sin⁴ψ (u + sin²ψ)^{−5/2} dψ from e to π/2, which is non-negative, from above.

    For u > 0 the integrand is at most 1/sin ψ. For u ≤ 0 it decreases in σ = sin ψ while dψ/dσ
    increases, so that the integral is at most the elementary one over σ, times
    (π/2 − e)/(1 − sin e): `mean_of_the_product` in the file of proofs on moments.

    Args:
        kappa: κ of the chart.
        v: v of the chart.
        e: the comparison function.
        q: √(1 + u).
        y: s/z.
        w: ŵ.
        far: κ log(2/ε₀).
        f: e/ε₀.
    """
    outer = far - kappa * f.log()
    over_sine = kappa * ((1 + q) / (2 * w)).log() + far
    over_sine += kappa * (y + y**3 / 3 - 1 / q - 1 / (3 * q**3))
    inner = (balls.pi / 2 - e) / (1 - e.sin()) * over_sine
    if v > 0:
        return outer
    return inner if v <= 0 else inner.max(outer)


class Candidate(NamedTuple):
    """The comparison function e = ε₀(1 − v/4 + …): quantities of it divided by ε₀ or by λ."""

    angle: arb
    """e."""
    part: arb
    """e/ε₀."""
    rate: arb
    """e′/ε₀."""
    sine: arb
    """ŝ = sin e/ε₀ = 1 − v/4 + λ · …"""
    root: arb
    """ẑ = √(v + ŝ²) = 1 + v/4 + λ · …"""
    sum: arb
    """ŵ = ŝ + ẑ."""
    bend: arb
    """(log w)″/λ."""


def candidate(e0: arb, lam: arb, kappa: arb, v: arb, p: arb, constant: arb, m: Any) -> Candidate:
    """Return ε₀(1 + (pλ − 1/4)v + ``constant`` λv²), with λ divided out of (log w)″.

    (log w)′ = n/(zw) with n = s′w + u′/2; n is a multiple of λ, and it is differentiated once more.
    """
    line, root_line, quarter = 1 - v / 4, 1 + v / 4, arb(fmpq(1, 4))
    gain, gain_rate = v * (p + constant * v), p + 2 * constant * v
    f = line + lam * gain
    e = e0 * f
    half, cosine = charts.sine_over(e / 2), m.cos(e)
    S = gain + kappa * f * f * f * charts.sine_rest(e)
    s = line + lam * S
    z = m.sqrt(root_line**2 + lam * S * (2 * line + lam * S))
    Z = S * (2 * line + lam * S) / (z + root_line)
    w = 2 + lam * (S + Z)
    rate = lam * gain_rate - quarter
    turning = gain_rate - kappa * f * f * half * half / 2 * rate
    sine_rate = lam * turning - quarter  # ŝ′
    n = 2 * turning - (S + Z) / 4 + lam * turning * (S + Z)
    sine_bend = 2 * constant * cosine - kappa * s * rate * rate
    bend = (sine_bend * w + sine_rate * n / z) / (z * w)
    bend -= n * (w * (s * sine_rate + arb(1) / 2) / z + lam * n) / (z * w) ** 2
    return Candidate(e, f, rate, s, z, w, bend)


def lower_end(c: Candidate, b: arb, R: arb, e0: arb, v: arb, turn: arb, m: Any) -> arb:
    """Return the contribution of the lower limit and of j(0) cos ψ to H″, divided by ε₀².

    Args:
        c: the comparison function.
        b: the shape parameter b.
        R: b/a.
        e0: ε₀.
        v: v of the chart.
        turn: 2 · constant · λ, which is e″/ε₀.
    """
    s, z, y = c.sine, c.root, c.sine / c.root
    cosine, q = m.cos(c.angle), m.sqrt(1 + e0 * e0 * v)
    square = e0 * e0 * s * s
    rho = m.sqrt(1 + R * square)
    j = 1 / (1 + cosine) - b / rho - R / (rho * (1 + rho))
    j0 = arb(1) / 2 - b - R / 2
    slope = 1 - cosine * (2 * b / rho + (1 - b * square) * R / rho**3)
    ends = c.rate * c.rate * y * (y * y * j * cosine - slope)
    ends += y * y * j * c.rate / z - turn * s * y * j
    return ends + j0 * cosine**2 * (1 / q**2 + y / q + y * y) / (4 * q * z * (z + s * q))


def curvature(b: arb, kappa: arb, v: arb, constant: arb, m: Any) -> arb:
    """Return H″(v)/λ for the comparison function with C = ``constant``, in the chart (b, κ, v)."""
    e0, _, r = charts.root_by_kappa(b, kappa, m)
    R, square = r * r, e0 * e0
    exponent = square * charts.exponent_rate(e0, b, r, m)
    lam = kappa * charts.leading_square_over(b, kappa, m) * m.exp(2 * exponent)
    phase = charts.phase_by_kappa(b, kappa)
    p = -charts.slope_rest_at(e0, b, r, kappa, phase, m) / 4
    c = candidate(e0, lam, kappa, v, p, constant, m)
    ends = lower_end(c, b, R, e0, v, 2 * constant * lam, m)
    q, y = m.sqrt(1 + square * v), c.sine / c.root
    far = m.pi + m.atan(r) + kappa * (m.log(1 + R) / 2 - exponent)
    moment = arb(0).union(fourth_moment(kappa, v, c.angle, q, y, c.sum, far, c.part))
    rest = 3 * square / 4 * second_order_rest(b, R) * moment
    upper_end = square * kappa * (1 + 2 * q) / (4 * q**3 * (1 + q) ** 2)
    return kappa * ends + rest - c.bend - upper_end
