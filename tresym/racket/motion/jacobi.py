"""Jacobi's sn, cn, dn of a real argument in balls, for a parameter given with its complement.

Theta series (DLMF 20.2, 22.2) in the nome of the smaller of k² and 1 − k² are used, which converge
at least as fast as e^(−πn²). For k² > ½ they are combined with Jacobi's imaginary transformation
(DLMF 22.6.iv), where the sines become hyperbolic. No digits are lost as k → 1, since k² and 1 − k²
are given separately.
"""

from __future__ import annotations

from typing import NamedTuple

from flint import arb, ctx

from tresym.racket.motion.carlson import Amplitude


class Jacobi(NamedTuple):
    """The quantities that the functions of one parameter share, at the precision of their creation.

    ``nome`` is None for the elementary cases k = 0 and k = 1. ``scales`` are the factors of the
    three quotients of theta functions; ``unit`` converts u to their argument.
    """

    modulus: arb
    complement: arb
    hyperbolic: bool
    nome: arb | None
    unit: arb
    scales: tuple[arb, arb, arb]


def parameter(modulus: arb, complement: arb) -> Jacobi:
    """Return the data for k² = ``modulus``, 1 − k² = ``complement``, at the working precision."""
    one = arb(1)
    hyperbolic = not bool(modulus < complement)
    if modulus.is_zero() or complement.is_zero():
        return Jacobi(modulus, complement, hyperbolic, None, one, (one, one, one))
    k, k1 = modulus.sqrt(), complement.sqrt()
    # agm(1, k′) = π/(2K) and agm(1, k) = π/(2K′).
    direct, dual = one.agm(k1), one.agm(k)
    if hyperbolic:
        nome = (-arb.pi() * dual / direct).exp()
        root = nome.root(4)
        scales = (1 / k.sqrt(), (k1 / k).sqrt() / root, k1.sqrt() / root)
        return Jacobi(modulus, complement, True, nome, dual, scales)
    nome = (-arb.pi() * direct / dual).exp()
    root = nome.root(4)
    scales = (root / k.sqrt(), root * (k1 / k).sqrt(), k1.sqrt())
    return Jacobi(modulus, complement, False, nome, direct, scales)


def functions(of: Jacobi, time: arb) -> Amplitude:
    """Return sn, cn, dn at u = ``time`` for |u| ≤ K (reduce by periods first)."""
    if of.nome is None:
        if of.hyperbolic:
            return Amplitude(time.tanh(), time.sech(), time.sech(), of.modulus)
        return Amplitude(time.sin(), time.cos(), arb(1), of.modulus)
    argument = of.unit * time
    sin, cos = argument.sinh_cosh() if of.hyperbolic else argument.sin_cos()
    one, two, three, four = thetas(of.nome, sin, cos, of.hyperbolic)
    first, second, third = of.scales
    if of.hyperbolic:
        return Amplitude(first * one / two, second * four / two, third * three / two, of.modulus)
    return Amplitude(first * one / four, second * two / four, third * three / four, of.modulus)


def thetas(q: arb, sin: arb, cos: arb, hyperbolic: bool) -> tuple[arb, arb, arb, arb]:
    """Return θ₁/q^(1/4), θ₂/q^(1/4), θ₃, θ₄ from sine and cosine of the argument.

    If ``hyperbolic``, θ₁/i is returned in place of θ₁. Term n of all four is at most 2 q^(n²) c_n,
    with c_n = cosh((2n+1)y), or 1 for circular functions; c_(n+1) ≤ 2 cosh(2y) c_n. So once
    q^(2n+1) 2 cosh(2y) ≤ ρ < ¼ the remainder after term n is below 2 q^(n²) c_n ρ/(1 − ρ) < 3
    q^(n²) c_n ρ.

    Raises:
        ArithmeticError: the balls are too wide to show q < ½ or, if hyperbolic, cosh > ½.
    """
    # cosh y ≥ 1. If the ball does not even show cosh y > ½ and q < ½, it is too wide to be useful,
    # and the loop below might not end.
    if not q < 0.5 or (hyperbolic and not (cos > 0.5 and cos.is_finite())):
        raise ArithmeticError("the argument of the theta functions is too wide")
    sign = -1 if hyperbolic else 1
    # Sine and cosine of multiples of the argument, by the addition theorem.
    turn_sin, turn_cos = 2 * sin * cos, 1 - 2 * sign * sin * sin
    odd_sin, odd_cos, even_sin, even_cos = sin, cos, turn_sin, turn_cos
    growth = 2 * turn_cos if hyperbolic else arb(1)
    one, two, three, four = sin, cos, arb(1) / 2, arb(1) / 2
    power, qn, sigma = q, q, -1
    # A number, not a ball: a wide ball might contain 0, and no term would ever be smaller.
    small = arb((1, -ctx.prec - 4)) * (cos.abs_lower() if hyperbolic else 1)
    while True:
        odd_sin, odd_cos = (
            odd_sin * turn_cos + odd_cos * turn_sin,
            odd_cos * turn_cos - sign * odd_sin * turn_sin,
        )
        even, odd = power * even_cos, power * qn
        three += even
        four += sigma * even
        one += sigma * odd * odd_sin
        two += odd * odd_cos
        step = qn * qn * q
        ratio = step * growth
        if ratio < 0.25:
            bound = power * ratio * (odd_cos if hyperbolic else 1)
            if bound < small:
                rest = arb(0, 3 * bound.abs_upper())
                return 2 * one + rest, 2 * two + rest, 2 * three + rest, 2 * four + rest
        even_sin, even_cos = (
            even_sin * turn_cos + even_cos * turn_sin,
            even_cos * turn_cos - sign * even_sin * turn_sin,
        )
        power, qn, sigma = power * step, qn * q, -sigma
