"""The numbers the paper prints, and what they are compared with.

The numbers are stored as text: nothing is rounded, converted or corrected.
"""

from __future__ import annotations

from typing import Any

from tresym.ledger.vocabulary import *

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

MOMENTS = ("I1", "I2", "I3")
"""Names of the first three columns."""


def inputs(**printed: str | Rational | int) -> tuple[Basic, ...]:
    """Return the conditions that symbols round to their printed values, or equal exact values."""
    symbols = ((Symbol(name, real=True), is_) for name, is_ in printed.items())
    return tuple(Rounds(x, is_) if isinstance(is_, str) else equal(x, is_) for x, is_ in symbols)


def moments(row: str, *names: str) -> tuple[Basic, ...]:
    """Return the conditions that moments (all, or those named) are as printed in Table 1."""
    texts = dict(zip(MOMENTS, TABLE_1[row][:3], strict=True))
    return inputs(**{name: str(texts[name]) for name in names or MOMENTS})


SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def typeset(text: str) -> str:
    """Return a decimal as it is printed in a sentence."""
    mantissa, _, exponent = text.partition("e")
    power = f"·10{str(int(exponent)).translate(SUPERSCRIPTS)}" if exponent else ""
    return mantissa.replace("-", "−") + power


def number(
    says: str,
    formula: Expr,
    text: str,
    given: tuple[Basic, ...],
    *claims: Claim,
    half_units: int = 1,
    **rest: Any,
) -> Claim:
    """Return a claim that states a printed number; it replaces ``{}`` in the sentence.

    The claims say what its symbols are.
    """
    means = Rounds(formula, text, half_units)
    return Claim(
        says=says.replace("{}", typeset(text)),
        means=means,
        given=given,
        proof=Printed(claims),
        **rest,
    )


def share_of_pi(defect: Expr) -> Expr:
    """The x of Δψ = π − 2ε₀ = π(1 − x)."""
    return 2 * defect / pi
