"""How far from a perfect flip: the answer as a value, with its balls and the rung it came from."""

from __future__ import annotations

from typing import Any, NamedTuple

from flint import arb, fmpq

from tresym.racket.body import Shape
from tresym.reals.numbers.arithmetic import ball_precision, bits
from tresym.reals.numbers.exact import decimal_ball, fraction_text

GUARD_BITS = 4
"""Bits beyond the digits promised that a ball must have, so that rounding to decimal is covered."""


class Flip(NamedTuple):
    """The flip of one body after one full turn Δφ = 2π, on the symmetric trajectory, certified.

    ``defect`` (ε) and ``turn`` (Δψ) are balls in radians that contain the truth; ``rung`` is the
    model that gave them and ``why`` says why that one was enough.
    """

    shape: Shape
    gamma: fmpq
    digits: int
    defect: arb
    turn: arb
    rung: str
    why: str
    seconds: float

    @property
    def realizable(self) -> bool:
        """Whether a rigid body can have this shape (I₃ ≤ I₁ + I₂)."""
        return self.shape.realizable

    def as_json(self) -> dict[str, Any]:
        """The answer under the keys of ``tresym flip --json``; numbers are decimal strings."""
        return _answer_json(self, ball_json(self.defect, self.digits), None, None)


class Journey(NamedTuple):
    """Where one start comes to, certified: Δψ, ψ and θ in radians, as balls.

    ``gamma`` is an exact rational where the start makes it one, else a ball.
    """

    shape: Shape
    gamma: fmpq | arb
    digits: int
    turn: arb
    psi: arb
    theta: arb
    rung: str
    why: str
    seconds: float

    @property
    def realizable(self) -> bool:
        """Whether a rigid body can have this shape (I₃ ≤ I₁ + I₂)."""
        return self.shape.realizable

    def as_json(self) -> dict[str, Any]:
        """The same keys as for a flip; there is no defect away from the symmetric trajectory."""
        psi, theta = (ball_json(x, self.digits) for x in (self.psi, self.theta))
        return _answer_json(self, None, psi, theta)


def _answer_json(
    answer: Flip | Journey,
    defect: dict[str, Any] | None,
    psi: dict[str, Any] | None,
    theta: dict[str, Any] | None,
) -> dict[str, Any]:
    gamma = answer.gamma
    return {
        "a": fraction_text(answer.shape.a),
        "b": fraction_text(answer.shape.b),
        "gamma": fraction_text(gamma)
        if isinstance(gamma, fmpq)
        else ball_json(gamma, answer.digits),
        "digits": answer.digits,
        "defect": defect,
        "flip": ball_json(answer.turn, answer.digits),
        "psi": psi,
        "theta": theta,
        "rung": answer.rung,
        "why": answer.why,
        "realizable": answer.realizable,
        "seconds": answer.seconds,
    }


def proves(x: arb, digits: int) -> bool:
    """Whether the ball is narrow enough to be printed with ``digits`` certified digits."""
    return bool(x.is_zero() or x.rel_accuracy_bits() >= bits(digits, GUARD_BITS))


def ball_json(x: arb, digits: int) -> dict[str, Any]:
    """A ball as ``{"mid", "rad"}``, outward; ``"relative": false`` where it is not told from 0."""
    with ball_precision(bits(digits, 64)):
        mid, rad = decimal_ball(x, digits)
    if proves(x, digits):
        return {"mid": mid, "rad": rad}
    return {"mid": mid, "rad": rad, "relative": False}
