"""Reduce ε(γ) to the first quarter of its orbit, and compute it in float64.

Let Q be the phase of a quarter: from ψ = π/2 to ψ = 0 if γ > 0, to the turning point if γ < 0. The
phase is odd about ψ = π/2 and is continued by reflection at the far end, so that for every integer
j, whatever the sign of π − 2jQ,

    ψ(π) = ψ(π − 2jQ) − jπ  (γ > 0),   ψ(π − 2jQ), by π − ψ if j is odd  (γ < 0),

and ψ(−φ) = π − ψ(φ). For the j nearest to π/(2Q), the angle e with F(e, γ) = |π − 2jQ| is in the
first quarter. Newton's method finds it in a variable T, which is 0 at ψ = π/2 and ∞ at the far end.
F is nearly linear in T near the separatrix, and dF/dT < 1/ω:

    tan e = √(a/(a+b))/sinh T,  ω² = a(γ+b)  (γ ≥ 0);   (γ + b sin²e)/cos²e = b/sinh²T,  ω² = ab.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

from flint import arb

from tresym.racket.flip.separatrix import float_phase
from tresym.racket.motion.gauss import FLOAT_ENDING, turn_by_gauss

ROUNDS = 16
"""Most steps of Newton's method; five are enough unless b is near 1."""


class Fold(NamedTuple):
    """How ψ(π) is reduced: by ``halves`` = j half periods; ``back`` is True if π < 2jQ."""

    rotating: bool
    halves: int
    back: bool

    def phase(self, half_turn: arb, quarter: Callable[[], arb]) -> arb:
        """Return the phase of the reduced angle: F, or 2Q − F on the way back.

        Args:
            half_turn: π.
            quarter: returns Q; called only if it is needed.
        """
        before = self.halves - self.back
        return half_turn - 2 * before * quarter() if before else half_turn

    @property
    def unfolding(self) -> tuple[int, int]:
        """The numbers s and n with ε = s e + nπ."""
        if self.rotating:
            return (-1, 1 - self.halves) if self.back else (1, -self.halves)
        return (-1, 1) if (self.halves % 2 == 1) != self.back else (1, 0)


class Quarter(NamedTuple):
    """The first quarter of an orbit in float64."""

    a: float
    b: float
    gamma: float

    def at(self, time: float) -> tuple[float, float, float]:
        """Return tan e, (γ + b sin²e)/cos²e and dF/dT at T = ``time``."""
        a, b, gamma = self
        slant, cosh = math.sinh(time), math.cosh(time)
        above = gamma + b
        if gamma < 0:
            square = (above - gamma * cosh * cosh) / (above * slant * slant)
            part = b * square / (1 + square)
            rate = (1 - part) / (math.sqrt(part * (a + part)) * cosh)
            return math.sqrt(square), b / (slant * slant), rate
        root = math.sqrt(a / (a + b))
        tangent, size = root / slant, slant * slant + root * root
        rest, part = gamma + above * tangent * tangent, b * root * root / size
        speed = slant * math.sqrt((a + part) * rest * size)
        return tangent, rest, (1 - part) * root * cosh / speed

    def time(self, angle: float) -> float:
        """Return T of an angle in the quarter."""
        tangent = math.tan(angle)
        if self.gamma < 0:
            rest = self.gamma + (self.gamma + self.b) * tangent * tangent
            return math.asinh(math.sqrt(self.b / rest))
        return math.asinh(math.sqrt(self.a / (self.a + self.b)) / tangent)

    def turn(self, tangent: float, rest: float) -> float:
        """Return F from tan e and (γ + b sin²e)/cos²e."""
        return float(turn_by_gauss(tangent, rest, *self, math, FLOAT_ENDING))

    def whole(self) -> float:
        """Return Q."""
        if self.gamma < 0:
            return self.turn(math.sqrt(-self.gamma / (self.gamma + self.b)), 0.0)
        return self.turn(0.0, self.gamma)

    def angle(self, time: float, phase: float) -> float | None:
        """Return the angle e with F(e) = ``phase`` by Newton's method, or None if it fails."""
        low = 0.99 * math.sqrt(self.a * (self.b + max(self.gamma, 0.0))) * phase
        time, high = max(time, low), math.inf
        for _ in range(ROUNDS):
            tangent, rest, rate = self.at(time)
            excess = self.turn(tangent, rest) - phase
            low, high = (low, time) if excess > 0 else (time, high)
            step = excess / rate
            time -= step
            if abs(step) < 1e-7 * time:
                return math.atan(self.at(time)[0])
            if not low < time < high:
                if high == math.inf:
                    return None
                time = (low + high) / 2
        return None


def float_defect(a: float, b: float, gamma: float) -> float | None:
    """Return ε(γ) in float64 if ε > 0 and there is no turning point before it, else None."""
    quarter = Quarter(a, b, gamma)
    try:
        k = math.sqrt(a * b)
        near = math.atan(math.sqrt(a / (a + b)) / math.sinh(k * float_phase(k, b)[0]))
        near -= gamma / (4 * b * near)
        return quarter.angle(quarter.time(near), math.pi) if near > 0 else None
    except (ArithmeticError, ValueError):
        return None


def folded(a: float, b: float, gamma: float) -> tuple[Fold, float] | None:
    """Return how ε(γ) is reduced, and the reduced angle in float64; None if it is not found."""
    unfolded = float_defect(a, b, gamma)
    if unfolded is not None:
        return Fold(gamma >= 0, 0, False), unfolded
    quarter = Quarter(a, b, gamma)
    try:
        whole = quarter.whole()
        halves = round(math.pi / (2 * whole))
        phase = math.pi - 2 * halves * whole
        time = math.asinh(math.tan(math.pi * abs(phase) / (2 * whole)))
        angle = quarter.angle(time, abs(phase))
    except (ArithmeticError, ValueError):
        return None
    return None if angle is None else (Fold(gamma >= 0, halves, phase < 0), angle)
