"""Levels of γ: what the ledger evaluates by integrals alone, against elliptic functions."""

import pytest
from flint import fmpq
from tresym.proofs import turning

from tresym.ledger.evidence.at_point import place_of
from tresym.ledger.formulas import in_trees
from tresym.racket.flip.defect import defect_on
from tresym.racket.motion.orbit import exact_level
from tresym.reals.numbers.arithmetic import ball_precision

LONG = fmpq(10), fmpq(1, 2)
"""A shape of no rigid body, whose motions turn several times."""


@pytest.mark.parametrize("level", ["-7/15", "-19/60", "-3/20", "-1/60"])
@pytest.mark.slow
def test_a_motion_that_turns_several_times(level: str) -> None:
    gamma = fmpq(*map(int, level.split("/")))
    at = {"a": LONG[0], "b": LONG[1], "gamma": gamma}
    with ball_precision(128):
        found = defect_on(*LONG, exact_level(*LONG, gamma))
        shown = place_of(at, (turning.one_time,)).value(in_trees(turning.flip_defect_on_level))
        assert shown.is_finite()
        assert abs(shown - found) < 1e-18
