"""ε(γ) for every γ in [−b, a], as a ball to any digits.

ε(γ) is read on the symmetric trajectory through ψ = π/2 at φ = 0, half a turn before: with the
phase φ(u) of :mod:`tresym.flip.orbit`, ε = ψ(u) where φ(u) = −π. It exists and is unique, as φ(u)
increases strictly. Where the trajectory has not turned this is the paper's F(ε, γ) = π, and one
evaluation of F is enough (:func:`quick`); everywhere else φ is inverted.
"""

from __future__ import annotations

import math
from contextlib import suppress
from typing import NamedTuple

from flint import arb, fmpq

from tresym.arithmetic import ball_precision, balls, bits
from tresym.exact import InputError, fraction_text
from tresym.flip.carlson import amplitude, ball_stop, by_flint, by_gauss, turn
from tresym.flip.orbit import Level, angle_at, exact_level, orbit, time_of
from tresym.flip.result import proves
from tresym.flip.separatrix import float_phase

PRECISION_LIMIT = 400_000
"""Bits of working precision at which a request is given up."""


class Defect(NamedTuple):
    """Balls around ε and the flip Δψ = π − 2ε (radians)."""

    defect: arb
    flip: arb


def checked_gamma(a: fmpq, b: fmpq, gamma: fmpq) -> fmpq:
    """``gamma`` if it is in [−b, a]; InputError otherwise."""
    if not -b <= gamma <= a:
        raise InputError(
            "gamma: must be between -b and a, here between "
            f"{fraction_text(-b)} and {fraction_text(a)}"
        )
    return gamma


def solve(a: fmpq, b: fmpq, gamma: fmpq, digits: int) -> Defect:
    """ε(γ) and the flip, each to ``digits`` certified digits: :func:`quick`, or :func:`inverted`.

    Raises:
        InputError: γ outside [−b, a].
        ArithmeticError: the precision limit is reached.
    """
    checked_gamma(a, b, gamma)
    return quick(a, b, gamma, digits) or inverted(a, b, gamma, digits)


def inverted(a: fmpq, b: fmpq, gamma: fmpq, digits: int) -> Defect:
    """ε(γ) at any γ in [−b, a], by inverting the phase at rising precision.

    At γ = −b, which is the stable rotation ψ = π/2, the flip is 0. Elsewhere one that cannot be
    told from 0 at eight times the precision the digits need is only shown to be below 10^−digits.

    Raises:
        ArithmeticError: the precision limit is reached.
    """
    precision = bits(digits, 48)
    if gamma == -b:
        with ball_precision(precision):
            return Defect(arb.pi() / 2, arb(0))
    while precision < PRECISION_LIMIT:
        with ball_precision(precision), suppress(ArithmeticError):
            angle = defect_on(a, b, exact_level(a, b, gamma))
            found = Defect(angle, arb.pi() - 2 * angle)
            if all(settled(x, digits, precision) for x in found):
                return found
        precision += precision // 2
    raise ArithmeticError("the precision limit is reached")


def settled(x: arb, digits: int, precision: int) -> bool:
    """Whether ``x`` proves the digits, or cannot be told from 0 at eight times what they need."""
    if proves(x, digits):
        return True
    small = arb(fmpq(1, 10) ** digits)
    return precision > 8 * bits(digits, 48) and x.contains(0) and bool(x.rad() < small)


def defect_on(a: fmpq, b: fmpq, level: Level) -> arb:
    """ε of a level −b < γ ≤ a, at the working precision, by inverting the phase.

    Raises:
        ArithmeticError: the precision does not suffice.
    """
    on = orbit(a, b, level)
    return arb.pi() / 2 - angle_at(on, time_of(on, arb.pi()))


def quick(a: fmpq, b: fmpq, gamma: fmpq, digits: int) -> Defect | None:
    """ε(γ) > 0 on a trajectory that has not turned, from one evaluation of F; else None.

    A float64 solution e is corrected by the Taylor series of the flow dψ/dφ, of which the phase
    F(e, γ) − π is the argument; each round quadruples the digits.
    """
    start = float_defect(float(arb(a)), float(arb(b)), float(arb(gamma)))
    if start is None:
        return None
    known, goal, near = 44, bits(digits, 20), arb(start)
    with suppress(ArithmeticError):
        while True:
            known = min(4 * known - 12, goal)
            with ball_precision(known + 24):
                angle = _corrected(arb(a), arb(b), exact_level(a, b, gamma), near)
                found = Defect(angle, arb.pi() - 2 * angle)
            if proves(found.defect, digits) and proves(found.flip, digits):
                return found
            if known == goal:
                return None
            near = angle.mid()
    return None


def float_defect(a: float, b: float, gamma: float) -> float | None:
    """ε(γ) in float64 where 0 < ε and the trajectory has not turned, by Newton's method; else None.

    The variable is T with tan ε = √(a/(a+b))/sinh T, in which F is nearly linear.
    """
    try:
        root, k = math.sqrt(a / (a + b)), math.sqrt(a * b)
        time = k * float_phase(k, b)[0]
        guess = math.atan(root / math.sinh(time))
        guess -= gamma / (4 * b * guess)
        if guess <= 0:
            return None
        time = math.asinh(root / math.tan(guess))
        for _ in range(12):
            slant = math.sinh(time)
            size = math.hypot(slant, root)
            sine, cosine = root / size, slant / size
            z = gamma + b * sine * sine
            at = amplitude(sine, cosine, z, a, b, gamma, math)
            value = turn(by_gauss(at, b / a, math, _float_stop), a, b, gamma, math)
            rate = (1 - b * sine * sine) / math.sqrt((a + b * sine * sine) * z)
            step = (value - math.pi) / (rate * root * math.cosh(time) / (size * size))
            time -= step
            if abs(step) < 1e-8 * time:
                return math.atan2(root, math.sinh(time))
    except (ArithmeticError, ValueError):
        pass
    return None


def _float_stop(ratio: float) -> float | None:
    return 1.0 if abs(ratio) < 1e-8 else None


def _corrected(a: arb, b: arb, level: Level, near: arb) -> arb:
    """ε from the exact point ``near``, at the working precision.

    ψ(φ) solves ψ′ = √G(ψ), G = (a + bs²)(γ + bs²)/(1 − bs²)²; with h = F(near, γ) − π the
    solution from ``near`` is at ε after h. Picard: if near + h √G(E) lies inside E it stays in E,
    which also holds the point of Taylor's remainder.

    Raises:
        ArithmeticError: nothing is shown (turning point, or precision too low).
    """
    sine, cosine = near.sin_cos()
    z = level.gamma + b * sine * sine
    if not z > 0:
        raise ArithmeticError("not above the turning point at this precision")
    at = amplitude(sine, cosine, z, a, b, level.gamma, balls)
    n = b / a
    found = by_gauss(at, n, balls, ball_stop) if at.sn > 0.1 else by_flint(at, n)
    phase = turn(found, a, b, level.gamma, balls) - arb.pi()
    g0, g1, g2, _ = _flow(near, a, b, level.gamma)
    wide = arb(near, 4 * (phase * g0.abs_upper().sqrt()).abs_upper())
    G, G1, G2, G3 = _flow(wide, a, b, level.gamma)
    if not (G > 0 and wide.contains_interior(near + phase * G.sqrt())):
        raise ArithmeticError("the flow is not enclosed")
    speed = g0.sqrt()
    fourth = phase * (G3 * G / 2 + G1 * G2 / 4) / 24
    return near + phase * (speed + phase * (g1 / 4 + phase * (g2 * speed / 12 + fourth)))


def _flow(angle: arb, a: arb, b: arb, gamma: arb) -> tuple[arb, arb, arb, arb]:
    """G = (dψ/dφ)² and its first three derivatives by ψ.

    With v = 1 − b sin²ψ, G = (1 + a − v)(1 + γ − v)/v² = AC/v² − (A + C)/v + 1.
    """
    sine, cosine = angle.sin_cos()
    square = b * sine * sine
    v = 1 - square
    first, second = -2 * b * sine * cosine, -2 * b * (cosine * cosine - sine * sine)
    third = -4 * first
    A, C = 1 + a, 1 + gamma
    inverse = 1 / v
    product, total = A * C * inverse, A + C
    by_v = inverse * inverse * (total - 2 * product)
    by_vv = inverse**3 * (6 * product - 2 * total)
    by_vvv = inverse**4 * (6 * total - 24 * product)
    return (
        (a + square) * (gamma + square) * inverse * inverse,
        by_v * first,
        by_vv * first * first + by_v * second,
        by_vvv * first**3 + 3 * by_vv * first * second + by_v * third,
    )
