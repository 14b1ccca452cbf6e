"""Powers with a variable as exponent, where their bases are not positive."""

import pytest
from cases import cases

import tresym
from tresym.reals.verdict import Verdict

FAIL = cases(__file__, "FAIL")
HOLD = [
    "x**a*x**b == x**(a + b)",
    "x**a*y**a == (x*y)**a",
    "(x**2)**a == abs(x)**(2*a)",
    "abs(x)**a >= 0",
    "diff(x**a, x) == a*x**(a - 1)",
]
CLOSED = cases(__file__, "CLOSED")


@pytest.mark.parametrize("claim", FAIL)
def test_what_fails_at_other_bases_is_refuted_there(claim: str) -> None:
    answer = tresym.check(claim)
    assert answer.verdict is Verdict.REFUTED
    assert answer.witness is not None


@pytest.mark.parametrize("claim", HOLD)
def test_what_passes_says_where_its_powers_are_taken(claim: str) -> None:
    answer = tresym.check(claim)
    assert answer.verdict is Verdict.PROVED
    assert "where the bases of powers are positive (" in answer.why


@pytest.mark.parametrize("claim", CLOSED)
def test_conditions_that_make_the_base_positive_say_it_all(claim: str) -> None:
    answer = tresym.check(claim)
    assert answer
    assert "as exponent" not in answer.why


def test_a_point_of_the_conditions_names_all_of_their_variables() -> None:
    assert tresym.check("x > 0", "x**a > 2").verdict is not Verdict.PROVED
