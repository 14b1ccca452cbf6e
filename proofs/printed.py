"""The numbers the paper prints, and what they are compared with.

The numbers are text: nothing here is rounded, converted or corrected.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tresym.ledger.vocabulary import *
from tresym.racket.flip.separatrix import defect_over
from tresym.racket.formulas import printed

TABLE_1 = {
    "str": ("1210", "16380", "17480", "12.54", "0.06", "0.1150", "0.0732"),
    "racket-1": ("886", "16336", "18270", "17.44", "0.11", "0.0251", "0.0160"),
    "racket-2": ("1319", "14445", "16175", "9.95", "0.11", "0.0699", "0.0445"),
    "racket-3": ("448", "7126", "1818", "14.88", "0.12", "0.0255", "0.0162"),
    "book": (None, None, None, "1.11", "0.31", "0.2139", "0.1362"),
}
"""Rows of Table 1: I₁, I₂, I₃, a, b, ε₀, and the x of Δψ = π(1 − x)."""

ROW_LINES = {"str": 302, "racket-1": 303, "racket-2": 304, "racket-3": 305, "book": 306}
"""Line of the source on which each row stands."""


def exact_defect(a: arb, b: arb, m: Any) -> arb:
    """ε₀ by the exact equation."""
    return defect_over(a, b, m)


def formula_defect(a: arb, b: arb, m: Any) -> arb:
    """ε₀ by the asymptotic formula of the theorem."""
    return printed.asymptotic_defect(a, b, m)


def share_of_pi(defect: Callable[..., arb]) -> Callable[..., arb]:
    """The x of Δψ = π − 2ε₀ = π(1 − x)."""
    return lambda a, b, m: 2 * defect(a, b, m) / m.pi


def of_moments(quantity: Callable[..., arb]) -> Callable[..., arb]:
    """A function of the shape, as a function of the moments; each occurs once in its ratio."""
    return lambda I1, I2, I3, m: quantity(I2 / I1 - 1, 1 - I2 / I3, m)
