"""The hunt for wrong limits and orders: what it takes for true is true, and a sample of it."""

import random
from fractions import Fraction

import asymptotic_claims
import pytest
from asymptotic_claims import Wave

from tresym.checking.dispatch import decide_claim
from tresym.reals.verdict import Verdict


def test_zeros_of_waves() -> None:
    wave = Wave(random.Random(1), 0)
    wave.parts = [("sin", 2, 1), ("cos", 3, 2), ("one", 1, 1)]
    assert wave.text("x") == "sin(2*(x))*cos(3*(x))**2*(1 - cos(x))"
    orders = {0: 3, 1: 1, Fraction(1, 2): 3, Fraction(1, 6): 2, Fraction(1, 4): 0, 2: 3}
    for at, order in orders.items():
        assert wave.order(Fraction(at)) == order, at


@pytest.mark.parametrize("kind", asymptotic_claims.KINDS[1:], ids=lambda kind: kind.__name__)
@pytest.mark.slow
def test_no_verdict_on_a_sample_is_wrong(kind: object) -> None:
    assert callable(kind)
    dice = random.Random(2026)
    decided = 0
    for _ in range(10):
        text, truth = kind(dice)
        answer = decide_claim(text)
        assert "at fault" not in answer.why, text
        if answer.verdict is not Verdict.UNDECIDED:
            decided += 1
            assert truth is not None, text
            assert bool(answer) is truth, (text, answer.why)
    assert decided >= 5
