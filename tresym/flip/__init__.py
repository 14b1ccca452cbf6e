"""The flip defect of a freely rotating rigid body, certified to any number of digits."""

from __future__ import annotations

from tresym.body import Exact, shape
from tresym.exact import as_rational
from tresym.flip.ladder import climb
from tresym.flip.result import Flip

__all__ = ["Flip", "flip_defect"]


def flip_defect(
    a: Exact, b: Exact, gamma: Exact = 0, digits: int = 50, *, rung: str | None = None
) -> Flip:
    """The flip defect ε of the shape (a, b) at γ, as a ball with ``digits`` certified digits.

    Args:
        a: I₂/I₁ − 1 > 0; text, an integer or a fraction, like ``b`` and ``gamma``.
        b: 1 − I₂/I₃, in (0, 1].
        gamma: distance from the separatrix.
        digits: 1 to 10 000.
        rung: force one model of the ladder instead of the cheapest that will do.

    Raises:
        InputError: anything outside these ranges.
    """
    return climb(shape(a, b), as_rational(gamma, "gamma"), digits, rung)
