"""Series with dots: every coefficient, and how far it converges."""

import pytest
from cases import cases

import tresym
from tresym.reals.verdict import Verdict

HOLD = cases(__file__, "HOLD")


@pytest.mark.parametrize("claim", HOLD)
def test_series_with_dots(claim: str) -> None:
    answer = tresym.check(claim)
    assert answer.verdict is Verdict.PROVED
    assert tresym.check(answer.read_as).verdict is Verdict.PROVED
