"""Absolute values by cases: both must hold, and each is asked on its own side."""

import pytest
from falsehoods import is_false_at, read

from tresym.reals.domain.conditions import Given
from tresym.reals.language.parsing import parse
from tresym.reals.signs.absolute_value_cases import by_cases
from tresym.reals.signs.sign import proof

TRUE = [
    "abs(x) - x >= 0",
    "abs(x) + abs(y) - abs(x + y) >= 0",
    "x**2 + 1 - abs(x) > 0",
    "abs(x**3) - x**3 >= 0",
]
FALSE = {
    "abs(x) - 2*x >= 0": "x = 1",
    "abs(x) + 2*x >= 0": "x = -1",
    "abs(x) + abs(y) - abs(x - 2*y) >= 0": "x = 0, y = 1",
    "abs(x) > 0": "x = 0",
}


def test_without_an_absolute_value_there_are_no_cases() -> None:
    assert by_cases(parse("x**2"), ">=", Given(), proof) is None


@pytest.mark.parametrize("claim", TRUE)
def test_both_cases_are_proved(claim: str) -> None:
    left, relation, _, given = read(claim)
    assert by_cases(left, relation, given, proof) is not None


@pytest.mark.parametrize("claim", FALSE)
def test_one_case_fails(claim: str) -> None:
    left, relation, _, given = read(claim)
    assert is_false_at(claim, FALSE[claim])
    assert by_cases(left, relation, given, proof) is None
