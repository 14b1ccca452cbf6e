"""Model selection: use the cheapest model that delivers the requested digits.

- ``asymptotic`` (γ = 0): a closed formula with a proved bound on its error.
- ``separatrix`` (γ = 0): the scalar equation for the defect.
- ``carlson`` (every γ except γ* and the ends of the range): F(ε, γ) in the first quarter of the
  orbit, by elliptic integrals.
- ``planar`` (every γ and every start): the solution of the planar system, its phase inverted.
"""

from __future__ import annotations

import math
from time import perf_counter

from flint import arb, fmpq

from tresym.racket.angle import Angle
from tresym.racket.body import Shape
from tresym.racket.flip import asymptotic, defect, separatrix
from tresym.racket.motion.trajectory import Start, travel
from tresym.racket.result import Flip, Journey, proves
from tresym.reals.numbers.arithmetic import BITS_PER_DIGIT, ball_precision, bits
from tresym.reals.numbers.exact import InputError, quoted, whole_number

MAX_DIGITS = 10_000

MODELS = ("asymptotic", "separatrix", "carlson", "planar")
"""The names of the models, cheapest first."""
WITHOUT_FORMULA = MODELS[1:]


ModelAnswer = tuple[arb, arb, str]
"""The result of one model: balls for ε and Δψ in radians, and why they are sufficient."""


def parse_digits(text: str) -> int:
    """Parse a number of digits.

    Raises:
        InputError: unless it is an integer from 1 to 10 000.
    """
    word = text.strip(" ")
    if not (word.isascii() and word.isdecimal() and len(word) <= len(str(MAX_DIGITS))):
        raise InputError(f"digits: must be an integer from 1 to {MAX_DIGITS}")
    return checked_digits(int(word))


def checked_digits(digits: int) -> int:
    """Return ``digits`` if it is an integer from 1 to 10 000.

    Raises:
        InputError: it is not.
    """
    return whole_number(digits, 1, MAX_DIGITS, "digits")


def climb(shape: Shape, gamma: fmpq | int, digits: int, model: str | None = None) -> Flip:
    """Compute the flip of ``shape`` at ``gamma`` to ``digits`` certified digits.

    Args:
        shape: the shape parameters.
        gamma: the level, from −b to a.
        digits: 1 to 10 000.
        model: the model to use; None selects the cheapest that delivers the digits.

    Raises:
        InputError: digits or γ out of range, an unknown model, or one that cannot deliver.
    """
    if type(digits) is not int or not 1 <= digits <= MAX_DIGITS:  # saves two calls in most cases
        digits = checked_digits(digits)
    level = gamma if isinstance(gamma, fmpq) else fmpq(gamma)
    if level:
        defect.checked_gamma(shape.a, shape.b, level)
    if model is not None:
        _checked_model(model)
    start = perf_counter()
    for used in (model,) if model is not None else _worth_trying(shape, level, digits):
        answer = _on_model(used, shape, level, digits)
        if answer is not None:
            angle, turn, why = answer
            seconds = perf_counter() - start
            return Flip(shape, level, digits, angle, turn, used, why, seconds)
    raise InputError(f"model: {_shortfall(used, shape, level, digits)}")


def follow(
    shape: Shape, start: Start, precession: Angle, digits: int, model: str | None = None
) -> Journey:
    """Compute the change of ψ of ``shape`` from ``start`` while φ grows by ``precession`` radians.

    Raises:
        InputError: digits out of range, a start that does not exist, or a model other than planar.
    """
    digits = checked_digits(digits)
    _checked_model(model)
    if model not in (None, "planar"):
        raise InputError(
            f"model: {model} computes symmetric trajectories only; for a start use planar"
        )
    began = perf_counter()
    found = travel(shape, start, precession, digits)
    seconds = perf_counter() - began
    why = "the planar system on the orbit of the start, its phase inverted in balls"
    return Journey(shape, found.gamma, digits, *found[1:], "planar", why, seconds)


def _checked_model(model: str | None) -> None:
    if model is not None and not (isinstance(model, str) and model in MODELS):
        raise InputError(f"model: {quoted(model)} is not known; known: {', '.join(MODELS)}")


def _worth_trying(shape: Shape, gamma: fmpq, digits: int) -> tuple[str, ...]:
    """The models to try, without those that a float64 estimate shows to be insufficient."""
    if gamma:
        return MODELS[2:]
    least = asymptotic.least_product(digits)
    if shape.a.floor() < least:  # and so is ab, as b <= 1
        return WITHOUT_FORMULA
    a, b = float(arb(shape.a)), float(arb(shape.b))
    reached = a > 0 and b > 0 and least <= a * b < math.inf
    in_reach = reached and asymptotic.reach(a, b) > digits
    return MODELS if in_reach else WITHOUT_FORMULA


def _on_model(model: str, shape: Shape, gamma: fmpq, digits: int) -> ModelAnswer | None:
    """The result of one model, or None if it cannot deliver."""
    if model == "separatrix" and not gamma:
        return _separatrix(shape, digits)
    if model == "carlson":
        return _carlson(shape, gamma, digits)
    if model == "planar":
        return _planar(shape, gamma, digits)
    if gamma:
        return None
    answer = _asymptotic(shape, digits)
    if answer is not None and proves(answer[0], digits) and proves(answer[1], digits):
        return answer
    return None


def _carlson(shape: Shape, gamma: fmpq, digits: int) -> ModelAnswer | None:
    found = defect.quick(*shape, gamma, digits)
    if found is None:
        return None
    why = "F(ε, γ) in Carlson's form, π folded into the first quarter of the orbit"
    return *found, why


def _planar(shape: Shape, gamma: fmpq, digits: int) -> ModelAnswer:
    found = defect.inverted(*shape, gamma, digits)
    return *found, "the phase on the orbit inverted, through turning points and turns"


def _asymptotic(shape: Shape, digits: int) -> ModelAnswer | None:
    found = asymptotic.enclose(shape.a, shape.b, digits)
    if found is None:
        return None
    why = "closed formula with a proved bound on its error"
    with ball_precision(bits(digits, 84)):
        return found, arb.pi() - 2 * found, why


def _separatrix(shape: Shape, digits: int) -> ModelAnswer:
    found = separatrix.solve(shape.a, shape.b, digits)
    why = "scalar equation at gamma = 0, its one root enclosed by Taylor's theorem"
    if not found.defect > 0:
        why = "the defect is positive, but too small to be distinguished from 0"
    return found.defect, found.flip, why


def _shortfall(model: str, shape: Shape, gamma: fmpq, digits: int) -> str:
    """Why a model cannot deliver."""
    if model == "carlson":
        return (
            f"carlson does not reach {digits} digits so close to a turning point or to an end of "
            "the range of gamma; try planar"
        )
    if gamma:
        return f"{model} computes the separatrix, gamma = 0, only; try carlson"
    answer, reached = _asymptotic(shape, digits), 0
    if answer is not None and answer[0].is_finite():
        worst = min(x.rel_accuracy_bits() for x in answer[:2])
        reached = max(0, int((worst - 4) / BITS_PER_DIGIT))
    return f"asymptotic reaches {reached} digits for this shape, not {digits}; try separatrix"
