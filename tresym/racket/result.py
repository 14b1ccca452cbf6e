"""The result of a flip computation: the defect as a ball, and the model that computed it."""

from __future__ import annotations

import re
from typing import Any, NamedTuple

from flint import arb, fmpq

from tresym.racket.body import Shape
from tresym.racket.formulas import printed
from tresym.reals.notebook import html_table
from tresym.reals.numbers.arithmetic import ball_precision, balls, bits
from tresym.reals.numbers.exact import decimal_ball, fraction_text

GUARD_BITS = 4
"""Extra bits that a ball must have, so that rounding to decimal keeps the promised digits."""


class Flip(NamedTuple):
    """The certified flip of a body in one full turn Δφ = 2π, on the symmetric trajectory.

    ``defect`` (ε) and ``flip`` (Δψ = π − 2ε) are balls in radians that contain the true values.
    ``model`` names the model that computed them, and ``why`` says why that model was sufficient.

    Example:
        >>> import tresym
        >>> tresym.flip_defect("1", "1/10").flip.str(20, radius=False)
        '1.8667941433597176388'
    """

    shape: Shape
    gamma: fmpq
    digits: int
    defect: arb
    flip: arb
    model: str
    why: str
    seconds: float

    @property
    def rung(self) -> str:
        """The old name of ``model``.

        Example:
            >>> import tresym
            >>> tresym.flip_defect("1", "1/10", digits=6).rung
            'separatrix'
        """
        return self.model

    @property
    def realizable(self) -> bool:
        """Whether a rigid body can have this shape (I₃ ≤ I₁ + I₂).

        Example:
            >>> import tresym
            >>> tresym.flip_defect("1", "1/10").realizable
            True
        """
        return self.shape.realizable

    @property
    def degrees(self) -> arb:
        """The defect ε in degrees.

        Example:
            >>> import tresym
            >>> round(float(tresym.flip_defect("1", "1/10").degrees), 3)
            36.52
        """
        with ball_precision(bits(self.digits, 64)):
            return self.defect * 180 / arb.pi()

    @property
    def turn(self) -> arb:
        """The old name of ``flip``.

        Example:
            >>> import tresym
            >>> tresym.flip_defect("1", "1/10").turn.str(6, radius=False)
            '1.86679'
        """
        return self.flip

    @property
    def paper(self) -> arb | None:
        """The old name of ``printed_estimate``.

        Example:
            >>> import tresym
            >>> tresym.flip_defect("1", "1/10", digits=6).paper.str(4, radius=False)
            '0.6419'
        """
        return self.printed_estimate

    @property
    def printed_estimate(self) -> arb | None:
        """The defect by the paper's asymptotic formula, or None if γ ≠ 0, for which it has none.

        Example:
            >>> import tresym
            >>> found = tresym.flip_defect(tresym.bodies["str"])
            >>> round(float(found.printed_estimate / found.defect - 1), 5)
            0.00072
        """
        if self.gamma != 0:
            return None
        with ball_precision(bits(self.digits, 64)):
            return printed.asymptotic_defect(arb(self.shape.a), arb(self.shape.b), balls)

    def __repr__(self) -> str:
        return _line_of(self)

    def _repr_html_(self) -> str:
        """A small table for notebooks."""
        return html_table("Flip", (*_shown(self), ("model", f"{self.model}: {self.why}")))

    def _repr_latex_(self) -> str:
        """Defect and flip in LaTeX."""
        return _latex_of(self)

    def as_json(self) -> dict[str, Any]:
        """Return the result under the keys of ``tresym flip --json``; numbers are decimal strings.

        Example:
            >>> import tresym
            >>> tresym.flip_defect("1", "1/10", digits=6).as_json()["model"]
            'separatrix'
        """
        return _answer_json(self, ball_json(self.defect, self.digits), None, None)


class Journey(NamedTuple):
    """The certified end of a motion from a given start: ``flip`` (Δψ), ψ and θ as balls (radians).

    ``gamma`` is an exact rational if the start makes it rational, else a ball.

    Example:
        >>> import tresym
        >>> tresym.flip_angle("1", "1/10", "1", rate="0", digits=6).model
        'planar'
    """

    shape: Shape
    gamma: fmpq | arb
    digits: int
    flip: arb
    psi: arb
    theta: arb
    model: str
    why: str
    seconds: float

    @property
    def rung(self) -> str:
        """The old name of ``model``.

        Example:
            >>> import tresym
            >>> tresym.flip_angle("1", "1/10", "1", rate="0", digits=6).rung
            'planar'
        """
        return self.model

    @property
    def turn(self) -> arb:
        """The old name of ``flip``.

        Example:
            >>> import tresym
            >>> tresym.flip_angle("1", "1/10", "1", rate="0", digits=6).turn.is_zero()
            False
        """
        return self.flip

    @property
    def realizable(self) -> bool:
        """Whether a rigid body can have this shape (I₃ ≤ I₁ + I₂).

        Example:
            >>> import tresym
            >>> tresym.flip_angle("1", "1", "1", rate="0").realizable
            False
        """
        return self.shape.realizable

    def __repr__(self) -> str:
        return _line_of(self)

    def _repr_html_(self) -> str:
        """A small table for notebooks."""
        return html_table("Journey", (*_shown(self), ("model", f"{self.model}: {self.why}")))

    def _repr_latex_(self) -> str:
        """Δψ, ψ and θ in LaTeX."""
        return _latex_of(self)

    def as_json(self) -> dict[str, Any]:
        """Return the result under the keys of ``tresym flip --json``; ``defect`` is None.

        Example:
            >>> import tresym
            >>> tresym.flip_angle("1", "1/10", "1", rate="0").as_json()["defect"] is None
            True
        """
        psi, theta = (ball_json(x, self.digits) for x in (self.psi, self.theta))
        return _answer_json(self, None, psi, theta)


MOST_DIGITS = 50
"""Most digits of a ball in a one-line representation."""


def _shown(answer: Flip | Journey) -> list[tuple[str, str]]:
    """The names and values of a result, the balls first."""
    if isinstance(answer, Flip):
        found = [("ε", answer.defect), ("Δψ", answer.flip)]
    else:
        found = [("Δψ", answer.flip), ("ψ", answer.psi), ("θ", answer.theta)]
    few = min(answer.digits, MOST_DIGITS)
    with ball_precision(bits(answer.digits, 64)):
        rows = [(name, radians(x, few)) for name, x in found]
        for name, y in (("a", answer.shape.a), ("b", answer.shape.b), ("γ", answer.gamma)):
            exact = fraction_text(y) if isinstance(y, fmpq) else ""
            rows.append((name, exact if 0 < len(exact) < 40 else arb(y).str(12, radius=False)))
    return rows


def radians(x: arb, digits: int) -> str:
    """Return a ball as text in radians, with as many digits as it proves.

    Args:
        x: the ball.
        digits: the digits wanted. If the ball proves fewer, midpoint and radius are shown.
    """
    if not proves(x, digits):
        mid, rad = decimal_ball(x, digits)
        return f"{mid} ± {rad} rad"
    return x.str(max(digits, 2)).strip("[]").replace("+/-", "±") + " rad"


def _line_of(answer: Flip | Journey) -> str:
    parts = ", ".join(f"{name} = {text}" for name, text in _shown(answer))
    return f"{type(answer).__name__}({parts})"


_POWER = re.compile(r"e([-+]?)0*(\d+)")


def _power(found: re.Match[str]) -> str:
    return rf"\cdot 10^{{{found[1].strip('+')}{found[2]}}}"


def _latex_of(answer: Flip | Journey) -> str:
    named = {"ε": "\\varepsilon", "Δψ": "\\Delta\\psi", "ψ": "\\psi", "θ": "\\theta"}
    parts = [
        f"{named[name]} = " + _POWER.sub(_power, text.removesuffix(" rad").replace("±", "\\pm"))
        for name, text in _shown(answer)
        if name in named
    ]
    return "$" + ",\\ ".join(parts) + "$"


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
        "flip": ball_json(answer.flip, answer.digits),
        "psi": psi,
        "theta": theta,
        "model": answer.model,
        "rung": answer.model,  # the old name of the same key
        "why": answer.why,
        "realizable": answer.realizable,
        "seconds": answer.seconds,
    }


def proves(x: arb, digits: int) -> bool:
    """Return whether the ball is narrow enough to be printed with ``digits`` certified digits."""
    return bool(x.is_zero() or x.rel_accuracy_bits() >= bits(digits, GUARD_BITS))


def ball_json(x: arb, digits: int) -> dict[str, Any]:
    """Return a ball as ``{"mid": …, "rad": …}`` in decimal, rounded outward.

    ``"relative": false`` is added if the ball does not prove ``digits`` significant digits.
    """
    with ball_precision(bits(digits, 64)):
        mid, rad = decimal_ball(x, digits)
    if proves(x, digits):
        return {"mid": mid, "rad": rad}
    return {"mid": mid, "rad": rad, "relative": False}
