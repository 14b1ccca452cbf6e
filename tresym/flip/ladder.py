"""Which model answers: the cheapest rung that meets the digits asked for."""

from __future__ import annotations

import time

from flint import fmpq

from tresym.body import Shape
from tresym.exact import InputError
from tresym.flip import separatrix
from tresym.flip.result import Flip

MAX_DIGITS = 10_000

RUNGS = ("separatrix",)


def parse_digits(text: str) -> int:
    """The number of digits that ``text`` asks for; InputError unless it is 1 to 10 000."""
    word = text.strip(" ")
    if not (word.isascii() and word.isdecimal() and len(word) <= len(str(MAX_DIGITS))):
        raise InputError(f"digits: must be an integer from 1 to {MAX_DIGITS}")
    return checked_digits(int(word))


def checked_digits(digits: int) -> int:
    """``digits`` if it is between 1 and 10 000; InputError otherwise."""
    if isinstance(digits, bool) or not isinstance(digits, int) or not 1 <= digits <= MAX_DIGITS:
        raise InputError(f"digits: must be an integer from 1 to {MAX_DIGITS}")
    return digits


def climb(shape: Shape, gamma: fmpq | int, digits: int, rung: str | None = None) -> Flip:
    """The flip of ``shape`` at ``gamma`` to ``digits`` certified digits, on ``rung`` if given.

    Raises:
        InputError: digits out of range, an unknown rung, or one that cannot deliver.
    """
    checked_digits(digits)
    if rung is not None and rung not in RUNGS:
        raise InputError(f"rung: {rung!a} is not known; known: {', '.join(RUNGS)}")
    if gamma != 0:
        raise InputError("gamma: only the separatrix, gamma = 0, is within reach")
    start = time.perf_counter()
    answer = separatrix.solve(shape.a, shape.b, digits)
    return Flip(
        shape,
        fmpq(gamma),
        digits,
        answer.defect,
        answer.flip,
        "separatrix",
        "scalar equation at gamma = 0, enclosed by interval Newton",
        time.perf_counter() - start,
    )
