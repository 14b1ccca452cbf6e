"""Values: closed forms of numbers, and of sums up to n."""

import math

import pytest

from tresym.reals.language.parsing import parse_claim, parse_given
from tresym.repair.values import recognised, values


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (9.0, "9"),
        (-2 / 7, "-2/7"),
        (math.pi / 4, "pi/4"),
        (math.sqrt(math.pi) / 2, "sqrt(pi)/2"),
        (math.sqrt(3) / 2, "sqrt(3)/2"),
        (math.log(2), "log(2)"),
        (2 * math.e, "2*E"),
        (math.pi**2 / 6, "pi**2/6"),
        (1 + math.log(2), "log(2) + 1"),
        (math.sqrt(7), "sqrt(7)"),
        (math.log(7), "log(7)"),
    ],
)
def test_numbers_are_recognised(value: float, text: str) -> None:
    assert text in [str(tree) for tree in recognised(value)]


def test_an_unknown_number_is_not_recognised() -> None:
    assert recognised(0.5772156649015329) == []
    assert recognised(math.nan) == []


@pytest.mark.parametrize(
    ("claim", "given", "value"),
    [
        ("integral(x**2, x, 0, 3) == 5", "", "9"),
        ("sum(k, k, 1, n) == n**2", "n integer, n >= 1", "n*(n + 1)/2"),
        ("sum(1/(k*(k + 1)), k, 1, n) == 1/n", "n integer, n >= 1", "n/(n + 1)"),
        ("sin(pi/6) == 1/3", "", "1/2"),
    ],
)
def test_the_right_value_is_found(claim: str, given: str, value: str) -> None:
    found = values(parse_claim(claim)[0], parse_given(given) if given else [])
    assert value in [str(tree) for tree in found]
