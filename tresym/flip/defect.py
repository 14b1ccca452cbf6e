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
from tresym.exact import InputError, fraction_text, shortened
from tresym.flip.carlson import amplitude, by_flint, turn
from tresym.flip.gauss import FLOAT_ENDING, ball_ending, turn_by_gauss
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
        low, high = (shortened(fraction_text(end)) for end in (-b, a))
        raise InputError(f"gamma: must be between -b and a, here between {low} and {high}")
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
            with ball_precision(known + 20):
                angle = _corrected(arb(a), arb(b), arb(gamma), near)
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
            tangent, size = root / slant, math.hypot(slant, root)
            rest = gamma + (gamma + b) * tangent * tangent
            value = turn_by_gauss(tangent, rest, a, b, gamma, math, FLOAT_ENDING)
            part = b * (root / size) ** 2
            rate = (1 - part) * size / (slant * math.sqrt((a + part) * rest))
            step = (value - math.pi) / (rate * root * math.cosh(time) / (size * size))
            time -= step
            if abs(step) < 1e-7 * time:
                return math.atan2(root, math.sinh(time))
    except (ArithmeticError, ValueError):
        pass
    return None


def _corrected(a: arb, b: arb, gamma: arb, near: arb) -> arb:
    """ε from the exact point ``near``, at the working precision.

    ψ(φ) solves ψ′ = √G(ψ), G = (a + bs²)(γ + bs²)/(1 − bs²)²; with h = F(near, γ) − π the
    solution from ``near`` is at ε after h. Picard: if near + h √G(E) lies inside E it stays in E,
    which also holds the points of Taylor's remainder.

    Raises:
        ArithmeticError: nothing is shown (turning point, or precision too low).
    """
    sine, cosine = near.sin_cos()
    square = b * sine * sine
    z = gamma + square
    if not z > 0:
        raise ArithmeticError("not above the turning point at this precision")
    phase = _turn(sine, cosine, z, a, b, gamma) - arb.pi()
    by_v, _, _, inverse = _flow(1 - square, a, gamma)
    slope = by_v * (-2 * b * sine * cosine)
    speed = ((a + square) * z).sqrt() * inverse
    wide = arb(near, 4 * (phase * speed).abs_upper())
    G, G1, G2, G3 = _flow_by_angle(wide, a, b, gamma)
    if not (G > 0 and wide.contains_interior(near + phase * G.sqrt())):
        raise ArithmeticError("the flow is not enclosed")
    fourth = phase * (G3 * G / 2 + G1 * G2 / 4)
    return near + phase * (speed + phase * (slope / 4 + phase * (2 * G2 * speed + fourth) / 24))


def _turn(sine: arb, cosine: arb, z: arb, a: arb, b: arb, gamma: arb) -> arb:
    """F: by the Gauss transformation, but where the angle is near π/2."""
    tangent = sine / cosine
    square = tangent * tangent
    if (a + b) * square < 100 * a:
        return turn_by_gauss(tangent, z * (1 + square), a, b, gamma, balls, ball_ending())
    at = amplitude(sine, cosine, z, a, b, gamma, balls)
    return turn(by_flint(at, b / a), a, b, gamma, balls)


def _flow(v: arb, a: arb, gamma: arb) -> tuple[arb, arb, arb, arb]:
    """The first three derivatives of G by v = 1 − b sin²ψ, and 1/v.

    G = (1 + a − v)(1 + γ − v)/v² = AC/v² − (A + C)/v + 1.
    """
    A, C = 1 + a, 1 + gamma
    inverse = 1 / v
    product, total, square = 2 * A * C * inverse, A + C, inverse * inverse
    return (
        (total - product) * square,
        (3 * product - 2 * total) * square * inverse,
        6 * (total - 2 * product) * square * square,
        inverse,
    )


def _flow_by_angle(angle: arb, a: arb, b: arb, gamma: arb) -> tuple[arb, arb, arb, arb]:
    """G = (dψ/dφ)² and its first three derivatives by ψ, for the remainder: no digits are kept."""
    sine, cosine = (2 * angle).sin_cos()
    square = b * (1 - cosine) / 2
    by_v, by_vv, by_vvv, inverse = _flow(1 - square, a, gamma)
    first, second = -b * sine, -2 * b * cosine
    part = first * first
    return (
        (a + square) * (gamma + square) * inverse * inverse,
        by_v * first,
        by_vv * part + by_v * second,
        (by_vvv * part + 3 * by_vv * second - 4 * by_v) * first,
    )
