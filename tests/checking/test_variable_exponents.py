"""Powers with a variable as exponent, where their bases are not positive."""

import pytest

import tresym
from tresym.reals.verdict import Verdict

FAIL = [  # each was PROVED where its bases are positive
    "x**a >= 0",
    "x**a > 0",
    "abs(x)**a > 0",
    "x**x > 0",
    "(x**2)**a == x**(2*a)",
    "(x**a)**b == x**(a*b)",
    "sqrt(x**a) == x**(a/2)",
    "abs(x**a) == x**a",
    "asin(x)**a*sqrt(x**2) == asin(x)**a*x",
    "x**a >= 1 + a*(x - 1) given a >= 1",
    "(1 + x)**a >= 1 + a*x given a > 1",
    "x**n >= 0 given n**2 == 9, n > 0",
    "x**n*x**a == abs(x**n*x**a) given n integer",
]
HOLD = [
    "x**a*x**b == x**(a + b)",
    "x**a*y**a == (x*y)**a",
    "(x**2)**a == abs(x)**(2*a)",
    "abs(x)**a >= 0",
    "diff(x**a, x) == a*x**(a - 1)",
]
CLOSED = [
    "x**a >= 0 given x > 0",
    "(x**2)**a == x**(2*a) given x > 0",
    "(1 + x)**a >= 1 + a*x given a > 1, x > -1",
    "2**x > x",
    "log(x**a) == a*log(x)",
    "diff(a**x/log(a), x) == a**x",
]


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
