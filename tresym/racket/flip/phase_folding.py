"""Fold ε(γ) into the first quarter of its orbit, and locate it in float64.

Let Q be the phase of a quarter: from ψ = π/2 to ψ = 0 where γ > 0, to the turning point where
γ < 0. The phase is odd about ψ = π/2 and goes on by reflection at the far end, so that for every
integer j, and whatever the sign of π − 2jQ,

    ψ(π) = ψ(π − 2jQ) − jπ  (γ > 0),   ψ(π − 2jQ), by π − ψ where j is odd  (γ < 0),

and ψ(−φ) = π − ψ(φ). With j nearest to π/(2Q) the angle e with F(e, γ) = |π − 2jQ| is in the
quarter. Newton's method looks for it in a variable T, 0 at ψ = π/2 and ∞ at the far end, in which F
is nearly linear next to the separatrix, and dF/dT < 1/ω:

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
"""Rounds of Newton's method at most; one to five do but for b near 1."""


class Fold(NamedTuple):
    """How ψ(π) is folded: by ``halves`` = j half periods, and ``back`` where π < 2jQ is taken."""

    rotating: bool
    halves: int
    back: bool

    def phase(self, half_turn: arb, quarter: Callable[[], arb]) -> arb:
        """The phase of the folded angle: F, or 2Q − F on the way back; ``quarter`` gives Q."""
        before = self.halves - self.back
        return half_turn - 2 * before * quarter() if before else half_turn

    @property
    def unfolding(self) -> tuple[int, int]:
        """s and n with ε = s e + nπ."""
        if self.rotating:
            return (-1, 1 - self.halves) if self.back else (1, -self.halves)
        return (-1, 1) if (self.halves % 2 == 1) != self.back else (1, 0)


class Quarter(NamedTuple):
    """The first quarter of an orbit in float64."""

    a: float
    b: float
    gamma: float

    def at(self, time: float) -> tuple[float, float, float]:
        """tan e, (γ + b sin²e)/cos²e and dF/dT at T = ``time``."""
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
        """T of an angle in the quarter."""
        tangent = math.tan(angle)
        if self.gamma < 0:
            rest = self.gamma + (self.gamma + self.b) * tangent * tangent
            return math.asinh(math.sqrt(self.b / rest))
        return math.asinh(math.sqrt(self.a / (self.a + self.b)) / tangent)

    def turn(self, tangent: float, rest: float) -> float:
        """F from tan e and (γ + b sin²e)/cos²e."""
        return float(turn_by_gauss(tangent, rest, *self, math, FLOAT_ENDING))

    def whole(self) -> float:
        """Q."""
        if self.gamma < 0:
            return self.turn(math.sqrt(-self.gamma / (self.gamma + self.b)), 0.0)
        return self.turn(0.0, self.gamma)

    def angle(self, time: float, phase: float) -> float | None:
        """The angle e with F(e) = ``phase``, by Newton's method in a bracket; None if it fails."""
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
    """ε(γ) in float64 where 0 < ε and the trajectory has not turned; else None."""
    quarter = Quarter(a, b, gamma)
    try:
        k = math.sqrt(a * b)
        near = math.atan(math.sqrt(a / (a + b)) / math.sinh(k * float_phase(k, b)[0]))
        near -= gamma / (4 * b * near)
        return quarter.angle(quarter.time(near), math.pi) if near > 0 else None
    except (ArithmeticError, ValueError):
        return None


def folded(a: float, b: float, gamma: float) -> tuple[Fold, float] | None:
    """How ε(γ) is folded, and the folded angle in float64; None where it is not found."""
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
