"""Convert exact numbers: text to rationals, printed decimals to intervals, balls to text.

Numbers from users are exact decimals or fractions and never pass through ``float`` or ``eval``.
Lengths and exponents are checked before a number is converted. Long integers are converted by
FLINT, which has none of Python's limits on digits.
"""

from __future__ import annotations

import decimal
import re
from numbers import Rational
from operator import index
from typing import NamedTuple

from flint import arb, fmpq, fmpz

MAX_CHARACTERS = 10_000
MAX_EXPONENT = 10_000

_TENS = [10**n for n in range(19)]
_ZERO = fmpq(0)
_DECIMAL = re.compile(r"([+-]?)(\d*)(?:\.(\d*))?(?:[eE]([+-]?\d+))?", re.ASCII)


class InputError(ValueError):
    """Raised for input that tresym rejects; the message is one line that says what is allowed.

    Example:
        >>> import tresym
        >>> tresym.flip_defect(0.5, "1/2")
        Traceback (most recent call last):
        tresym.reals.numbers.exact.InputError: not exact
    """


class AmbiguityError(InputError):
    """Raised for input that has two readings; the message gives both."""


def shortened(text: str, length: int = 40) -> str:
    """Return a text, truncated to ``length`` characters if it is longer."""
    return text if len(text) <= length else text[: length - 3] + "..."


def quoted(found: object) -> str:
    """Return bad input as quoted in an error message: short and in ASCII."""
    text = found if isinstance(found, str) else repr(found)
    return ascii(shortened(text, 40 if text.isascii() else 12))


def _split(text: str, what: str) -> tuple[int, int]:
    """Return the decimal ``text`` as ``(coefficient, exponent of ten)``."""
    match = _DECIMAL.fullmatch(text)
    if match is None or not (match[2] or match[3]):
        raise InputError(
            f"{what}: {quoted(text)} is not a number; give a decimal such as 0.0629 or 1e-4, "
            "or a fraction such as 16380/1210"
        )
    sign, whole, part, power = match[1], match[2], match[3] or "", match[4] or "0"
    size = power.lstrip("+-").lstrip("0") or "0"
    if len(size) > 6 or int(size) > MAX_EXPONENT:
        raise InputError(
            f"{what}: the exponent of {quoted(text)} is beyond the limit of ±{MAX_EXPONENT}"
        )
    coefficient = fmpz((whole + part).lstrip("0") or "0")
    exponent = -int(size) if power.startswith("-") else int(size)
    return (-coefficient if sign == "-" else coefficient), exponent - len(part)


def _scaled(coefficient: int, exponent: int) -> fmpq:
    ten = fmpz(10)
    if exponent >= 0:
        return fmpq(coefficient * ten**exponent)
    return fmpq(coefficient, ten ** (-exponent))


def _decimal(text: str, what: str) -> fmpq:
    return _scaled(*_split(text.strip(" \t"), what))


def _at_once(text: str) -> fmpq | None:
    """Parse a short decimal or fraction in few steps, as most texts are; None for others."""
    if len(text) < len(_TENS) and text.isascii():
        whole, point, part = text.partition(".")
        if point:
            if (digits := whole + part).isdecimal():
                return fmpq(int(digits), _TENS[len(part)])
        elif text.isdecimal():
            return fmpq(int(text)) if text != "0" else _ZERO
        top, slash, bottom = text.partition("/")
        if slash and top.isdecimal() and bottom.isdecimal() and (below := int(bottom)):
            return fmpq(int(top), below)
        top, _, power = text.partition("e-")
        if top.isdecimal() and power.isdecimal() and (places := int(power)) < len(_TENS):
            return fmpq(int(top), _TENS[places])
        if text[:1] == "-" and text[1:2].isdecimal() and (size := _at_once(text[1:])) is not None:
            return -size
    return None


def parse_number(text: str, what: str = "number") -> fmpq:
    """Return the exact rational of a decimal (``1e-400``) or a fraction (``16380/1210``).

    Args:
        text: ASCII text of at most 10 000 characters, with exponents within ±10 000.
        what: the name of the number in error messages.

    Raises:
        InputError: the text is anything else, such as NaN, infinity or a fraction with denominator
            0.

    Example:
        >>> parse_number("0.125")
        1/8
    """
    if len(text) > MAX_CHARACTERS:
        raise InputError(f"{what}: {len(text)} characters are beyond the limit of {MAX_CHARACTERS}")
    numerator, slash, denominator = text.partition("/")
    if not slash:
        return _decimal(text, what)
    top, bottom = _decimal(numerator, what), _decimal(denominator, what)
    if bottom == 0:
        raise InputError(f"{what}: {quoted(text)} divides by zero")
    return top / bottom


def as_rational(x: str | int | Rational | fmpq, what: str = "number") -> fmpq:
    """Return ``x`` (text, integer or fraction) as an exact rational.

    Args:
        x: the number.
        what: its name in error messages.

    Raises:
        InputError: ``x`` is a float (which is not the decimal it prints as), a boolean or of
            another type.

    Example:
        >>> as_rational("1/3")
        1/3
    """
    if isinstance(x, str):
        found = _at_once(x)
        return parse_number(x, what) if found is None else found
    return exact_number(x, what)


def exact_number(x: int | Rational | fmpq, what: str = "number") -> fmpq:
    """Return ``x`` (integer or fraction) as an exact rational.

    Args:
        x: the number.
        what: its name in error messages.

    Raises:
        InputError: ``x`` is text, a float, a boolean or of another type.
    """
    if isinstance(x, fmpq):
        return x
    if type(x) is int or isinstance(x, fmpz):
        return fmpq(x) if x else _ZERO
    if type(x).__module__ == "decimal":  # exact already, so not imported for this question
        return parse_number(str(x), what)
    if isinstance(x, bool):
        raise InputError(f"{what}: a truth value is not a number")
    if isinstance(x, Rational):
        return fmpq(int(x.numerator), int(x.denominator))
    raise InputError(
        f"{what}: {type(x).__name__} is not exact; give a string, an integer or a Fraction"
    )


class Interval(NamedTuple):
    """An interval with rational ends.

    Attributes:
        low: the lower end, or None for −∞.
        high: the upper end, or None for ∞.
        low_open: whether a finite lower end is excluded.
        high_open: whether a finite upper end is excluded.
    """

    low: fmpq = None
    high: fmpq = None
    low_open: bool = False
    high_open: bool = False

    @property
    def middle(self) -> fmpq:
        """Return the midpoint of two finite ends."""
        return (self.low + self.high) / 2

    @property
    def width(self) -> fmpq:
        """Return the distance of two finite ends."""
        return self.high - self.low

    def __and__(self, other: Interval) -> Interval:
        """Return the intersection."""
        both = (self, other)
        lows = ((i.low, i.low_open) for i in both if i.low is not None)
        highs = ((i.high, not i.high_open) for i in both if i.high is not None)
        low, low_open = max(lows, default=(None, False))
        high, closed = min(highs, default=(None, True))
        return Interval(low, high, low_open, not closed)

    def ball(self) -> arb:
        """Return the smallest ball at working precision that contains a bounded interval."""
        return arb(self.low).union(arb(self.high))

    def holds(self, x: fmpq) -> bool:
        """Return whether ``x`` lies in the interval."""
        return (self.low is None or x > self.low or (x == self.low and not self.low_open)) and (
            self.high is None or x < self.high or (x == self.high and not self.high_open)
        )

    def first_integer(self) -> int | None:
        """Return the least integer that the lower end allows; None if there is no lower end.

        Example:
            >>> Interval(fmpq(3, 2)).first_integer(), Interval(fmpq(2), None, True).first_integer()
            (2, 3)
        """
        if self.low is None:
            return None
        return int(self.low.floor()) + 1 if self.low_open else int(self.low.ceil())

    def simplest(self) -> fmpq:
        """Return the rational of least denominator in a nonempty interval (Stern–Brocot tree).

        Example:
            >>> Interval(fmpq(3, 10), fmpq(4, 10)).simplest()
            1/3
        """
        low, high, low_open, high_open = self
        if self.holds(fmpq(0)):
            return fmpq(0)
        if low is None or low < 0:
            above = Interval(-high, None if low is None else -low, high_open, low_open)
            return -above.simplest()
        whole = fmpq(self.first_integer())
        if self.holds(whole):
            return whole
        base = whole - 1
        far = None if low == base else 1 / (low - base)
        return base + 1 / Interval(1 / (high - base), far, high_open, low_open).simplest()


LARGEST = 1 << 20
"""The maximal size of a rational in bits: FLINT aborts the process if memory does not suffice."""


def rational_ends(x: arb) -> Interval:
    """Return rational ends of a ball, rounded outward if they would be too long.

    An end that is not finite is None.
    """
    low, high = _lower_end(x.lower()), _lower_end((-x).lower())
    return Interval(low, None if high is None else -high)


def _lower_end(x: arb) -> fmpq | None:
    """Return a rational at or below an exact number; None if there is none of admissible length."""
    if not x.is_finite():
        return None
    size = abs(x)
    if size > arb((1, LARGEST)):
        return fmpq(fmpz(1) << LARGEST) if x > 0 else None
    if 0 < size < arb((1, -LARGEST)):
        return fmpq(0) if x > 0 else fmpq(-1, fmpz(1) << LARGEST)
    return x.fmpq()


def near(x: fmpq, tolerance: fmpq) -> fmpq:
    """Return the rational of least denominator within ``tolerance`` of ``x``.

    Example:
        >>> near(fmpq(314159, 100000), fmpq(1, 100))
        22/7
    """
    return Interval(x - tolerance, x + tolerance).simplest()


def printed(text: str) -> Interval:
    """Return the interval that a printed decimal stands for: ± half a unit in its last place.

    Example:
        >>> printed("0.5")[:2]
        (9/20, 11/20)
    """
    coefficient, exponent = _split(text.strip(), "printed number")
    half = _scaled(1, exponent) / 2
    value = _scaled(coefficient, exponent)
    return Interval(value - half, value + half)


def _place_point(digits: str, exponent: int) -> str:
    """Return ``digits``·10^exponent in plain or scientific notation."""
    sign, digits = ("-", digits[1:]) if digits.startswith("-") else ("", digits)
    point = len(digits) + exponent
    if 0 < point <= len(digits):
        body = digits[:point] + ("." + digits[point:] if digits[point:] else "")
    elif -5 < point <= 0:
        body = "0." + "0" * (-point) + digits
    elif len(digits) < point <= 21:
        body = digits + "0" * (point - len(digits))
    else:
        body = digits[0] + ("." + digits[1:] if digits[1:] else "") + f"e{point - 1:+d}"
    return sign + body


class Decimal(NamedTuple):
    """A ball in decimal notation; the true value lies in ``[mid − rad, mid + rad]``.

    Attributes:
        mid: the midpoint as decimal text.
        rad: the radius as decimal text.
    """

    mid: str
    rad: str


def decimal_ball(x: arb, digits: int) -> Decimal:
    """Return the ball ``x`` in decimal notation, rounded outward, with ``digits`` + 3 digits.

    The radius is as small as the ball and those digits allow. The caller checks that it is small
    enough for the accuracy that was promised.
    """
    if x.is_zero():
        return Decimal("0", "0")
    mid, rad, exponent = x.mid_rad_10exp(digits + 3)
    text = _place_point(str(mid), int(exponent)) if mid else "0"
    return Decimal(text, _radius(rad, int(exponent)))


def _radius(rad: int, exponent: int) -> str:
    """Return the radius ``rad``·10^exponent to three digits, rounded up."""
    text = str(rad)
    if len(text) > 3:
        cut = len(text) - 3
        text, exponent = str(int(text[:3]) + 1), exponent + cut
    return "0" if text == "0" else _place_point(text, exponent)


def whole_number(x: object, least: int, most: int, what: str) -> int:
    """Return ``x`` as an integer from ``least`` to ``most``; NumPy integers are accepted.

    Args:
        x: the number.
        least: the smallest allowed value.
        most: the largest allowed value.
        what: its name in the error message.

    Raises:
        InputError: ``x`` is out of range, a boolean or not an integer.
    """
    try:
        found = index(x)  # type: ignore[arg-type]
    except TypeError:
        found = least - 1
    if isinstance(x, bool) or not least <= found <= most:
        raise InputError(f"{what}: must be an integer from {least} to {most}")
    return found


def decimal_above(x: fmpq, digits: int) -> str:
    """Return a decimal of so many digits that is at least ``x``.

    Example:
        >>> decimal_above(fmpq(1, 3), 6), decimal_above(fmpq(2), 6), decimal_above(fmpq(-1, 3), 2)
        ('0.333334', '2', '-0.33')
    """
    context = decimal.Context(prec=digits, rounding=decimal.ROUND_CEILING)
    found = context.divide(decimal.Decimal(int(x.p)), decimal.Decimal(int(x.q)))
    return f"{found:f}" if -digits < found.adjusted() < digits else str(found).replace("E", "e")


def fraction_text(x: fmpq) -> str:
    """Return an exact rational as ``p`` or ``p/q``.

    Example:
        >>> fraction_text(fmpq(6, 4))
        '3/2'
    """
    return str(x.p) if x.q == 1 else f"{x.p}/{x.q}"
