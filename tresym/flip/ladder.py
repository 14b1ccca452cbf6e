"""Which model answers: the cheapest rung that meets the digits asked for.

On the separatrix these are `asymptotic`, a closed formula with a proved bound on its error, and
`separatrix`, the scalar equation solved to any number of digits.
"""

from __future__ import annotations

import time
from typing import NamedTuple

from flint import arb, fmpq

from tresym.arithmetic import BITS_PER_DIGIT, ball_precision, bits
from tresym.body import Shape
from tresym.exact import InputError
from tresym.flip import asymptotic, separatrix
from tresym.flip.result import Flip, proves

MAX_DIGITS = 10_000

RUNGS = ("asymptotic", "separatrix")
"""The rungs, cheapest first."""


class Answer(NamedTuple):
    """What one rung has to say: balls for ε and Δψ in radians, and why they are enough."""

    defect: arb
    turn: arb
    why: str


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
    used = rung or RUNGS[0]
    answer = _asymptotic(shape, digits) if used == "asymptotic" else None
    if answer is None or not (proves(answer.defect, digits) and proves(answer.turn, digits)):
        if rung == "asymptotic":
            raise InputError(_shortfall(answer, digits))
        used, answer = "separatrix", _separatrix(shape, digits)
    seconds = time.perf_counter() - start
    return Flip(shape, fmpq(gamma), digits, answer.defect, answer.turn, used, answer.why, seconds)


def _asymptotic(shape: Shape, digits: int) -> Answer | None:
    defect = asymptotic.enclose(shape.a, shape.b, digits)
    if defect is None:
        return None
    with ball_precision(bits(digits, 84)):
        return Answer(
            defect, arb.pi() - 2 * defect, "closed formula with a proved bound on its error"
        )


def _separatrix(shape: Shape, digits: int) -> Answer:
    found = separatrix.solve(shape.a, shape.b, digits)
    why = "scalar equation at gamma = 0, its one root enclosed by interval Newton"
    if found.defect.contains(0):
        why = "the defect is positive but below every number that is told from 0 here"
    return Answer(found.defect, found.flip, why)


def _shortfall(answer: Answer | None, digits: int) -> str:
    """Why the closed formula cannot answer."""
    reached = 0
    if answer is not None and answer.defect.is_finite():
        worst = min(answer.defect.rel_accuracy_bits(), answer.turn.rel_accuracy_bits())
        reached = max(0, int((worst - 4) / BITS_PER_DIGIT))
    return f"rung: asymptotic reaches {reached} digits for this shape, not {digits}; try separatrix"
