"""Levels of γ: found by elliptic functions, and shown by integrals alone."""

from __future__ import annotations

import pytest
from flint import arb, fmpq
from tresym.proofs import levels
from tresym.proofs.levels import NEAR, changing_sign

from tresym.racket.flip.defect import defect_on
from tresym.racket.motion.orbit import exact_level
from tresym.reals.numbers.arithmetic import ball_precision


def test_a_change_of_sign_is_enclosed_and_nothing_else_is() -> None:
    with ball_precision(128):
        assert changing_sign(arb(2).sqrt(), lambda x: x * x - 2).contains(arb(2).sqrt().mid())
        assert changing_sign(arb(2).sqrt() + 2 * NEAR, lambda x: x * x - 2).is_nan()
        assert changing_sign(arb(0), lambda x: x * x).is_nan()
        assert changing_sign(arb(0), lambda x: arb(0, 1)).is_nan()


@pytest.mark.parametrize("level", ["-7/15", "-19/60", "-3/20", "-1/60"])
def test_a_motion_that_turns_several_times(level: str) -> None:
    gamma = fmpq(*map(int, level.split("/")))
    with ball_precision(128):
        found = defect_on(*levels.LONG, exact_level(*levels.LONG, gamma))
    assert abs(levels._long_defect(gamma) - found) < 1e-18
