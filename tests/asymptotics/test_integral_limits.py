"""Limits and orders of what holds integrals."""

import pytest
from cases import cases

import tresym
from tresym.reals.verdict import Verdict

HOLD = cases(__file__, "HOLD")
FAIL = cases(__file__, "FAIL")
OPEN = [
    "limit(integral(1/t, t, 0, x)*x, x, 0) == 0",  # it has no value
    "limit(integral(1/t, t, -x, x)/x, x, 0) == 0",
    "limit(integral(exp(t**2)/t, t, 0, x)/x, x, 0) == 1",  # not continuous there
]


@pytest.mark.parametrize("claim", HOLD)
def test_it_holds(claim: str) -> None:
    assert tresym.check(claim).verdict in (Verdict.PROVED, Verdict.ENCLOSED)


@pytest.mark.parametrize("claim", FAIL)
def test_it_fails(claim: str) -> None:
    answer = tresym.check(claim)
    assert answer.verdict is Verdict.REFUTED
    assert answer.witness


@pytest.mark.parametrize("claim", OPEN)
def test_it_is_open(claim: str) -> None:
    assert tresym.check(claim).verdict is Verdict.UNDECIDED
