"""Claims without variables, and equality with a printed number."""

import pytest
from cases import cases

import tresym

TRUE = tuple(cases(__file__, "TRUE"))


@pytest.mark.parametrize("claim", TRUE)
@pytest.mark.slow
def test_a_printed_number_that_is_right_holds(claim: str) -> None:
    assert tresym.check(claim).verdict.holds


@pytest.mark.parametrize("claim", ["pi ~= x", "0.1150 ~= pi", "pi ~= 3.14 + 0", "pi ~= 3.1.4"])
def test_what_is_no_printed_number_is_refused(claim: str) -> None:
    with pytest.raises(tresym.InputError):
        tresym.check(claim)
