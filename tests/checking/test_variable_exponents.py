"""Powers with a variable as exponent, where their bases are not positive."""

import pytest
from cases import cases

import tresym
from tresym.reals.verdict import Verdict

FAIL = cases(__file__, "FAIL")


@pytest.mark.parametrize("claim", FAIL)
def test_what_fails_at_other_bases_is_refuted_there(claim: str) -> None:
    answer = tresym.check(claim)
    assert answer.verdict is Verdict.REFUTED
    assert answer.witness is not None
