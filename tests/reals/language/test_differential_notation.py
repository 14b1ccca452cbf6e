"""Typed notation of differential equations: letters that are functions, primes, initial slopes."""

from __future__ import annotations

import pytest

from tresym.checking.dispatch import decide_claim
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.numbers.exact import InputError


@pytest.mark.parametrize(
    "slope",
    ["y'(0) == 1", "diff(y(0), t) == 1", "diff(y(t), t)(0) == 1", "at(diff(y(t), t), t, 0) == 1"],
)
@pytest.mark.parametrize("equation", ["diff(y(t), t, 2) == -y(t)", "y''(t) == -y(t)"])
def test_an_initial_slope_is_read_in_every_spelling(slope: str, equation: str) -> None:
    found = read(f"y(t) == sin(t) given {equation}, y(0) == 0, {slope}")
    assert found.read_as.endswith("y(0) == 0, at(diff(y(x_1), x_1), x_1, 0) == 1")


def test_any_letter_that_is_differentiated_is_a_function() -> None:
    answer = decide_claim("x(t) == cos(t) given x'(t) == -p(t), p'(t) == x(t), x(0) = 1, p(0) = 0")
    assert answer.verdict.value == "PROVED"
    assert "fn_" not in answer.read_as


@pytest.mark.parametrize(
    ("claim", "message"),
    [
        ("x(t) == t + x given x'(t) == 1, x(0) == 0", "both as a function and as a variable"),
        ("y(t) == 1 given y'(0) == 1, y(0) == 0", "with its variable"),
        ("y(t) == exp(-t) given y' = -y, y(0) = 1", "a derivative is written"),
        ("y(t) == 1 given diff(y(t), t == 1", "not closed"),
    ],
)
def test_what_remains_unclear_is_refused(claim: str, message: str) -> None:
    with pytest.raises(InputError, match=message):
        read(claim)


def test_a_derivative_by_the_chain_rule_stays_one() -> None:
    assert "diff(y(2*t), t)" in read("diff(y(2*t), t) == 2 given diff(y(t), t) == 1").read_as
