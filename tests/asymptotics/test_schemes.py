"""Orders of differences and quadratures for every smooth f: lists, leading errors and refusals."""

from __future__ import annotations

from pathlib import Path

import pytest

import tresym

LIST = Path(__file__).parent.parent / "data" / "asymptotics" / "schemes.txt"
VERDICTS = {"true": "PROVED", "false": "REFUTED", "open": "UNDECIDED"}
LINES = [line for line in LIST.read_text().splitlines() if not line.startswith("#")]


@pytest.mark.parametrize("line", LINES)
def test_scheme(line: str) -> None:
    truth, claim = line.split(maxsplit=1)
    assert tresym.check(claim).verdict.value == VERDICTS[truth]


def test_leading_error_and_true_order() -> None:
    simpson = "integral(f(t), t, x, x+h) == h/6*(f(x) + 4*f(x+h/2) + f(x+h)) + O(h**{}) as h -> 0"
    assert "-h**5*diff(f(x), x, 4)/2880" in tresym.check(simpson.format(5)).why
    assert "the true order is h**5" in tresym.check(simpson.format(6)).why


@pytest.mark.parametrize("given", ["f(x) == 0", "diff(f(x), x) == 0"])
def test_conditions_are_not_dropped(given: str) -> None:
    found = tresym.check("f(x+h) == f(x) + O(h**2) as h -> 0", given=given)
    assert found.verdict.value == "UNDECIDED"


def test_leading_error_of_a_method() -> None:
    midpoint = "y(t+h) == y(t) + h*f(y(t) + h/2*f(y(t))) + O(h**{}) as h -> 0"
    equation = "diff(y(t), t) == f(y(t))"
    error = "h**3*(f**2*f_yy/24 + f*f_y**2/6)"
    assert error in tresym.check(midpoint.format(3), given=equation).why
    assert "the true order is h**3" in tresym.check(midpoint.format(4), given=equation).why
