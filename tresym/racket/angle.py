"""Exact angles: a rational multiple of π, or a rational number of radians."""

from __future__ import annotations

import re
from typing import NamedTuple

from flint import arb, fmpq

from tresym.racket.body import Exact
from tresym.reals.numbers.exact import (
    MAX_CHARACTERS,
    InputError,
    as_rational,
    fraction_text,
    parse_number,
)

_MULTIPLE = re.compile(
    r"\s*([+-]?)\s*(?:([^*\s+-][^*]*?)\s*\*\s*)?pi\s*(?:/\s*([^*/]*))?\s*", re.ASCII
)

# sin² of the multiples of π at which it is rational (Niven's theorem), by position in a period.
_RATIONAL_SQUARES = {
    (0, 1): fmpq(0),
    (1, 6): fmpq(1, 4),
    (1, 4): fmpq(1, 2),
    (1, 3): fmpq(3, 4),
    (1, 2): fmpq(1),
    (2, 3): fmpq(3, 4),
    (3, 4): fmpq(1, 2),
    (5, 6): fmpq(1, 4),
}


class Angle(NamedTuple):
    """The angle ``halves``·π + ``radians``, both exact; at least one of them is zero."""

    halves: fmpq
    radians: fmpq

    def ball(self) -> arb:
        """Return the angle in radians as a ball at the working precision."""
        return self.halves * arb.pi() + self.radians

    def sin_cos(self) -> tuple[arb, arb]:
        """Return sine and cosine as balls; they are exact where they are 0 or ±1."""
        if self.halves == 0:
            return arb(self.radians).sin_cos()
        return arb.sin_pi_fmpq(self.halves), arb.cos_pi_fmpq(self.halves)

    def rational_square(self) -> fmpq | None:
        """Return sin² of the angle if it is rational, else None.

        The sine of a non-zero rational number of radians is transcendental (Lindemann). For a
        rational multiple of π, sin² is rational only at multiples of π/6 and π/4 (Niven).
        """
        if self.radians != 0:
            return None
        part = self.halves - self.halves.floor()
        return _RATIONAL_SQUARES.get((int(part.p), int(part.q)) if part.q <= 6 else (-1, 1))

    @property
    def is_zero(self) -> bool:
        """Whether this is the angle 0."""
        return bool(self.halves == 0 and self.radians == 0)

    def __neg__(self) -> Angle:
        """Return the opposite angle."""
        return Angle(-self.halves, -self.radians)

    def __str__(self) -> str:
        """Return the angle as one would type it."""
        if self.halves == 0:
            return fraction_text(self.radians)
        top = {1: "", -1: "-"}.get(int(self.halves.p), f"{self.halves.p}*")
        return f"{top}pi" + ("" if self.halves.q == 1 else f"/{self.halves.q}")


def parse_angle(text: str, what: str = "angle") -> Angle:
    """Parse an exact angle such as ``0.1``, ``1/3``, ``pi/2`` or ``-3*pi/4``.

    Args:
        text: a number of radians, or a rational multiple of ``pi``.
        what: what the angle is, for the error message.

    Raises:
        InputError: anything else.

    Example:
        >>> str(parse_angle("-3*pi/4"))
        '-3*pi/4'
    """
    if len(text) > MAX_CHARACTERS:
        raise InputError(f"{what}: {len(text)} characters are beyond the limit of {MAX_CHARACTERS}")
    match = _MULTIPLE.fullmatch(text)
    if match is None:
        try:
            return Angle(fmpq(0), parse_number(text, what))
        except InputError as error:
            raise InputError(f"{error}; an angle may also be pi/2 or -3*pi/4") from None
    sign, factor, divisor = match.groups()
    halves = fmpq(1) if factor is None else parse_number(factor, what)
    if divisor is not None:
        below = parse_number(divisor, what)
        if below == 0:
            raise InputError(f"{what}: pi/0 divides by zero")
        halves = halves / below
    return Angle(-halves if sign == "-" else halves, fmpq(0))


def as_angle(x: Exact | Angle, what: str = "angle") -> Angle:
    """Return ``x`` as an exact angle in radians.

    Args:
        x: text as for :func:`parse_angle`, an integer, a fraction, or an angle.
        what: what the angle is, for the error message.

    Raises:
        InputError: a float or another type.
    """
    if isinstance(x, Angle):
        return x
    if isinstance(x, str):
        return parse_angle(x, what)
    return Angle(fmpq(0), as_rational(x, what))
