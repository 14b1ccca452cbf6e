"""Series with dots: every coefficient, and how far it converges."""

import pytest
from cases import cases

import tresym
from tresym.reals.verdict import Verdict

HOLD = cases(__file__, "HOLD")
FALSE = cases(__file__, "FALSE")
NEVER = cases(__file__, "NEVER")


@pytest.mark.parametrize("claim", HOLD)
def test_series_with_dots(claim: str) -> None:
    answer = tresym.check(claim)
    assert answer.verdict is Verdict.PROVED
    assert tresym.check(answer.read_as).verdict is Verdict.PROVED


@pytest.mark.parametrize("claim", FALSE)
def test_series_with_dots_that_are_false(claim: str) -> None:
    answer = tresym.check(claim)
    assert answer.verdict is Verdict.REFUTED
    assert answer.witness


@pytest.mark.parametrize("claim", NEVER)
def test_series_with_dots_that_are_not_proved(claim: str) -> None:
    assert not tresym.check(claim)
