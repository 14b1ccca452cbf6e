"""Factorials by the least of them: what holds of integers, and what does not."""

import pytest
from cases import cases

import tresym
from tresym.reals.verdict import Verdict

HOLD = cases(__file__, "HOLD")
FAIL = cases(__file__, "FAIL")
OPEN = [
    "factorial(n) == 1 given n < 2",  # true, of numbers 1 and 1 alone
    "factorial(x) == x*factorial(x - 1) given x > 1/3, x < 2/3",  # of no integer
    "diff(factorial(n), n) == 0",
    "factorial(factorial(n)) >= 1",
    *cases(__file__, "BESIDE_OTHERS"),
]


@pytest.mark.parametrize(
    ("claim", "verdict"),
    [
        *((claim, Verdict.PROVED) for claim in HOLD),
        *((claim, Verdict.REFUTED) for claim in FAIL),
        *((claim, Verdict.UNDECIDED) for claim in OPEN),
    ],
)
def test_factorials_are_those_of_integers(claim: str, verdict: Verdict) -> None:
    assert tresym.check(claim).verdict is verdict
