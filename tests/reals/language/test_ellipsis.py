"""Dots in sums: what they stand for is seen, or the sum is refused."""

import pytest
from cases import cases

from tresym.reals.language.latex import read_expression
from tresym.reals.language.parsing import as_written
from tresym.reals.language.readings import read_as
from tresym.reals.numbers.exact import InputError

SEEN = {
    "1 + 2 + ... + n": "sum(k, k, 1, n)",
    "1 + 3 + 5 + ... + (2*n - 1)": "sum(2*k - 1, k, 1, n)",
    "1 + x + x**2 + ... + x**n": "sum(x**k, k, 0, n)",
    "1/2 + cos(t) + cos(2*t) + ... + cos(n*t)": "sum(cos(k*t), k, 1, n) + 1/2",
    "1 + x + x**2/factorial(2) + ... + x**n/factorial(n) + ...": "sum(x**k/factorial(k), k, 0, oo)",
    "1 + 2 + ... + 2*n": "sum(k, k, 1, 2*n)",
    "1 + 2 + 4 + ... + 2**n": "sum(2**k, k, 0, n)",
    "1 + 1/2 + 1/3 + ... + 1/2**n": "sum(1/k, k, 1, 2**n)",
    "1 - 1/3 + 1/5 - ...": "sum((-1)**k/(2*k + 1), k, 0, oo)",
    "1 + 1/4 + 1/9 + ...": "sum((k + 1)**(-2), k, 0, oo)",
    "1 + 1 + 1/2 + 1/6 + ...": "sum(1/factorial(k), k, 0, oo)",
    "1 + 1/2 + 1/4 + ...": "sum((1/2)**k, k, 0, oo)",
    "1 + x + x**2/2 + ...": "1 + x + x**2/2 + ...",
    "x - x**3/6 + ... ": "x - x**3/6 + ...",
}
UNSEEN = cases(__file__, "UNSEEN")


@pytest.mark.parametrize("text", SEEN)
def test_what_dots_stand_for(text: str) -> None:
    assert str(as_written(text)).replace(" ", "") == SEEN[text].replace(" ", "")


@pytest.mark.parametrize("text", UNSEEN)
def test_dots_that_are_refused(text: str) -> None:
    with pytest.raises(InputError):
        as_written(text)


def test_dots_in_latex() -> None:
    for dots in ("\\cdots", "\\dots", "\\ldots", "\\dotsb"):
        assert str(read_expression(f"1 + x + x^2 + {dots}")) == "1 + x + x**2 + ..."
        assert str(read_expression(f"1 + 2 + {dots} + n")) == "sum(k, k, 1, n)"


def test_a_condition_has_no_dots() -> None:
    assert read_as("x == 1 given x > 1 + y + y**2 + ...") == ""
