"""Like terms as one, and numbers apart."""

import pytest
from flint import fmpq

from tresym.reals.language.expression import multiply, number
from tresym.reals.language.like_terms import collected, scaled
from tresym.reals.language.parsing import parse


@pytest.mark.parametrize(
    ("text", "scale", "rest"),
    [
        ("3*x", 3, "x"),
        ("-x*y", -1, "x*y"),
        ("x/2", fmpq(1, 2), "x"),
        ("x*y", 1, "x*y"),
        ("x", 1, "x"),
        ("2", 1, "2"),
        ("0*log(x)", 0, "log(x)"),
    ],
)
def test_a_number_times_the_rest(text: str, scale: int, rest: str) -> None:
    r, inner = scaled(parse(text))
    assert (r, inner) == (scale, parse(rest))
    assert multiply(number(r), inner) == parse(text)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("x + y + 2*x", "3*x + y"),
        ("3*(x + 2) - 6", "3*x"),
        ("2*(x - 3*(x + y)) + 5*x", "x - 6*y"),
        ("x - x", "0"),
        ("x*(y + 1) - x*(y + 1)/2", "x*(y + 1)/2"),
    ],
)
def test_like_terms_are_one(text: str, expected: str) -> None:
    assert collected(parse(text)) == parse(expected)
