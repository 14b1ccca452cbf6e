"""The hunt for wrong verdicts: what it takes for true is true, and a wrong one is noticed."""

from fractions import Fraction

import known
import pytest
from flint import arb, fmpq

from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.arithmetic import ball_precision


def ball(q: Fraction) -> arb:
    return arb(fmpq(q.numerator, q.denominator))


def test_values_in_fractions_are_those_of_balls() -> None:
    dice, compared = known.Dice(1), 0
    for _ in range(100):
        e = known.piecewise(dice, 2, waves=False)
        x = dice.small() + Fraction(1, 7919)  # no corner is there
        with ball_precision(300):
            found = evaluate(parse(e.text), {"x": ball(x)})
            value = e.at(x)
            if value is None:
                assert not found.is_finite(), e.text
            elif found.is_finite():
                assert found.overlaps(ball(value)), e.text
                compared += 1
    assert compared > 50


def test_no_verdict_is_wrong() -> None:
    dice = known.Dice(2)
    for _ in range(100):
        _, claim = known.made(dice)
        said = known.verdict(claim.text)
        assert not known.is_wrong(said.verdict, said.why, claim.truth), claim


@pytest.mark.parametrize(
    ("said", "why", "truth"),
    [("PROVED", "", False), ("ENCLOSED", "", False), ("REFUTED", "", True), ("PROVED", "", None),
     ("REFUTED", "", None), ("UNDECIDED", "please report this claim", True), ("FAILS", "", True)],
)  # fmt: skip
def test_a_wrong_verdict_is_noticed(said: str, why: str, truth: bool | None) -> None:
    assert known.is_wrong(said, why, truth)
    assert not known.is_wrong("UNDECIDED", "", truth)
