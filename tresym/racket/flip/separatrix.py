"""The flip defect ε₀ on the separatrix (γ = 0), as a ball of any width.

The paper's exponential equation loses its digits long before its root does, so it is solved in the
phase P (:mod:`tresym.racket.formulas.stable`), for which nothing cancels:

    g(P) = P − π − arctan(√(b/a) tanh(√(ab) P)) = 0.

*Uniqueness.* g′ = 1 − b/(cosh² T + (b/a) sinh² T) with T = √(ab) P is positive for every P > 0, as
b ≤ 1 < cosh² T; g(π) ≤ 0 < g(3π/2). So there is one root, and an interval Newton step that lands
inside its starting interval encloses it.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from flint import arb, ctx, fmpq

from tresym.racket.formulas import stable
from tresym.racket.result import GUARD_BITS
from tresym.reals.numbers.arithmetic import Balls, ball_precision, balls, bits

LARGEST_ARGUMENT = 10**17
"""Beyond T = √(ab) P of this size ε₀ < 10^(−4·10^16) is not told from 0."""

FLOAT_BITS = 48
"""Bits of the float64 start that are taken to be right; nothing rests on it but speed."""

SPARE = 8
"""Bits of the working precision that the last step may leave: with them a whole step is saved."""


class Separatrix(NamedTuple):
    """Balls around the phase P, the defect ε₀ and the flip Δψ = π − 2ε₀ (radians)."""

    phase: arb
    defect: arb
    flip: arb


def float_phase(k: float, b: float) -> tuple[float, float]:
    """The phase P and the slope g′(P) in float64, from ``k`` = √(ab) (0 and ∞ allowed) and ``b``.

    Newton's method from P = π: g is convex, so the steps are monotone after the first.
    """
    phase = math.pi
    for _ in range(8):
        argument = k * phase
        tangent = math.tanh(argument)
        ratio = b * phase * (tangent / argument if argument > 1e-9 else 1.0)
        residual = phase - math.pi - math.atan(ratio)
        slope = 1 - b * (1 - tangent * tangent) / (1 + ratio * ratio)
        phase -= residual / slope
        if abs(residual) < 1e-9:
            break
    return phase, slope


def interval_newton(phase: arb, k: arb, r: arb) -> arb:
    """A ball that contains the one root, from a near exact point ``phase``.

    g′ ≥ 0.86 at the root of every shape, so an interval of eight times the residual (its rounding
    errors included) leaves room.

    Raises:
        ArithmeticError: the step does not land inside its starting interval, so nothing is shown.
    """
    residual = phase - stable.phase_map(phase, k, r, balls)
    interval = arb(phase, 8 * residual.abs_upper())
    with ball_precision(ctx.prec // 2 + 16):
        slope = stable.phase_slope(interval, k, r, balls)
    image = phase - residual / slope
    if not interval.contains_interior(image):
        raise ArithmeticError("interval Newton did not contract; the precision is too low")
    return image


def enclose_phase(k: arb, r: arb, precision: int) -> arb:
    """The phase as a ball some 2^(``SPARE`` − precision) wide, at that working precision.

    Newton's method doubles the correct bits of the float64 start, so that the last doubling, the
    interval Newton step, ends there.
    """
    guess, slope = map(arb, float_phase(float(k), float(k * r)))
    for rising in _roundings(precision - SPARE):
        if rising > 2 * FLOAT_BITS:
            with ball_precision(rising // 2 + 16):
                slope = stable.phase_slope(guess, k, r, balls)
        with ball_precision(rising + 16):
            residual = guess - stable.phase_map(guess, k, r, balls)
            guess = (guess - residual / slope).mid()
    return interval_newton(guess, k, r)


def _roundings(precision: int) -> list[int]:
    """Correct bits after each Newton step that leads from the float64 start to ``precision``/2."""
    steps = []
    while (precision := precision // 2 + 2) > FLOAT_BITS:
        steps.append(precision)
    return steps[::-1]


def defect_over(a: arb, b: arb, m: Balls = balls) -> arb:
    """A ball that contains ε₀ for every shape in the balls ``a`` and ``b``.

    Every root lies in [π, 3π/2] and in the image of what contains it, and so in the iterates.
    """
    k, r = m.sqrt(a * b), m.sqrt(b / a)
    phase = m.pi.union(3 * m.pi / 2)
    while True:
        image = stable.phase_map(phase, k, r, m).intersection(phase)
        if not image.rad() < phase.rad() * arb("0.99"):
            return stable.defect_at(image, k, r, m)
        phase = image


def solve(a: fmpq, b: fmpq, digits: int) -> Separatrix:
    """ε₀ and the flip, each to ``digits`` certified digits; the precision rises until it is so.

    Where T is beyond ``LARGEST_ARGUMENT`` the defect is only shown to lie below 10^−digits.
    """
    precision = bits(digits, 20)
    while True:
        with ball_precision(precision):
            p, q = arb(a), arb(b)
            k, r = (p * q).sqrt(), (q / p).sqrt()
            if k > LARGEST_ARGUMENT:
                return _unresolved(digits)
            phase = enclose_phase(k, r, precision)
            defect = stable.defect_at(phase, k, r, balls)
            # π − 2ε₀ cancels only where ε₀ is near π/2.
            flip = arb.pi() - 2 * defect if defect < 1 else stable.flip_at(phase, k, r, balls)
        if min(defect.rel_accuracy_bits(), flip.rel_accuracy_bits()) >= bits(digits, GUARD_BITS):
            return Separatrix(phase, defect, flip)
        precision += 16 + precision // 4


def _unresolved(digits: int) -> Separatrix:
    """0 < ε₀ < 10^−(digits+2) by far: tan ε₀ < 1/sinh T with T > π·LARGEST_ARGUMENT."""
    with ball_precision(bits(digits, 64)):
        tiny = arb(fmpq(1, 10) ** (digits + 2))
        between = arb(0).union(arb.pi() / 2)
        return Separatrix(arb.pi() + between, arb(0, tiny), arb.pi() + arb(0, 2 * tiny))
