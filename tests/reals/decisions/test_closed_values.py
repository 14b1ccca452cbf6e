"""Claims without variables, and equality with a printed number."""

import pytest

import tresym

TRUE = (
    "log(2) ~= 0.6931",
    "log(2) ~= 0.69315",
    "integral(exp(-x**2), x, 0, oo) ~= 0.8862",
    "sum(1/k**3, k, 1, oo) ~= 1.2021",
    "sum(1/k**3, k, 1, oo) < 1.2021",
    "root(y*exp(y) - 3, y, 0, oo) ~= 1.0499",
    "integral(1/(sqrt(t)*(1 + t**3)), t, 0, oo) ~= 2.094395",
    "x**2 ~= 0.25 given x == 1/2",
    "1/8 ~= 0.13",
    "1/8 ~= 0.12",
    "exp(-20) ~= 2.06e-9",
    "sin(x) ~= 0 given x > 0, x < 1/2",
)
FALSE = (
    "log(2) ~= 0.6932",
    "log(2) ~= 0.69310",
    "integral(exp(-x**2), x, 0, oo) ~= 0.8863",
    "root(y*exp(y) - 3, y, 0, oo) ~= 1.0500",
    "1/8 ~= 0.120",
    "exp(-20) ~= 2.07e-9",
    "x ~= 0.1 given x >= 0",
)


@pytest.mark.parametrize("claim", TRUE)
@pytest.mark.slow
def test_a_printed_number_that_is_right_holds(claim: str) -> None:
    assert tresym.check(claim).verdict.holds


@pytest.mark.parametrize("claim", FALSE)
def test_a_printed_number_that_is_wrong_is_refuted(claim: str) -> None:
    assert tresym.check(claim).verdict.value == "REFUTED"


@pytest.mark.parametrize("claim", ["pi ~= x", "0.1150 ~= pi", "pi ~= 3.14 + 0", "pi ~= 3.1.4"])
def test_what_is_no_printed_number_is_refused(claim: str) -> None:
    with pytest.raises(tresym.InputError):
        tresym.check(claim)
