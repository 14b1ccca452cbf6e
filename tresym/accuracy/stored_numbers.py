"""Numbers as programs store and print them: the nearest floating-point number, short decimals.

Example: the nearest number of binary32 to 0.1 is 13421773/134217728.
"""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction


def readable(decimal: str) -> str:
    """Return a decimal with an exponent where it has many zeros: 4.87e-8."""
    x = Decimal(decimal).normalize()
    return decimal if -5 < x.adjusted() < 9 else f"{x:e}".replace("e+", "e")


def nearest(x: Fraction, bits: int, least: int) -> Fraction:
    """Return the floating-point number nearest to x, to even in a tie.

    Args:
        x: a number.
        bits: the bits of the mantissa.
        least: the smallest positive number is 2 to this power.
    """
    if not x:
        return x
    size = abs(x)
    power = size.numerator.bit_length() - size.denominator.bit_length()
    if Fraction(2) ** power > size:
        power -= 1
    unit = Fraction(2) ** max(power - bits + 1, least)
    return round(x / unit) * unit
