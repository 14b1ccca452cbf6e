"""Derivatives of the flip defect by differences, at many digits."""

from flint import arb, fmpq

from tresym.racket.flip.defect import defect_on
from tresym.racket.motion.orbit import exact_level
from tresym.reals.numbers.arithmetic import ball_precision

STEP = fmpq(1, 10**100)


def defect_slope(a: fmpq, b: fmpq, gamma: int | fmpq = 0) -> arb:
    """dε/dγ of a shape at a level, to far more than 75 digits."""
    with ball_precision(1600):
        low, high = (defect_on(a, b, exact_level(a, b, gamma + k * STEP)) for k in (-1, 1))
        return (high - low) / (2 * STEP)
