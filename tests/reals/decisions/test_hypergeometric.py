"""Hypergeometric series: which sums are such, and where they converge."""

import pytest

from tresym.reals.decisions.claim_parsing import read
from tresym.reals.decisions.hypergeometric import (
    Series,
    folded,
    out_of_range,
    radius_of,
    series_of,
)
from tresym.reals.domain.conditions import Given

NONE = [
    "sin(n)*x**n",
    "x**(n**2)",
    "x**n/factorial(n/2)",
    "x**(n/2)",
    "log(n)*x**n",
    "(n - 3)*x**n",
    "factorial(5 - n)*x**n",  # the terms from n = 6 on are none
    "sqrt(n + 1)*x**n",
    "(n + 1)**(3/2)*x**n",
    "n**n*x**n",
    "(n**n + 1)*x**n",
    "(n + n**(-1))*x**n",
    "0**(n - 1)*x**n",
    "x**n/0**n",
    "f(n)*x**n",
]


def series(terms: str, low: int | str = 1) -> Series | None:
    return series_of(read(f"1 == sum({terms}, n, {low}, oo)").comparisons[0].right)


@pytest.mark.parametrize("terms", NONE)
def test_what_is_no_such_series(terms: str) -> None:
    assert series(terms) is None


def test_an_index_counts_from_an_integer() -> None:
    assert series("x**n", "1/2") is None


@pytest.mark.parametrize(
    ("terms", "radius", "above", "below"),
    [
        ("x**n", "1", False, False),
        ("x**n/n", "1", False, True),
        ("x**n/n**2", "1", True, True),
        ("(-x)**n/n", "1", False, True),
        ("n*x**n/3**n", "3", False, False),
        ("factorial(2*n)*x**n/factorial(n)**2", "1/4", False, True),
        ("factorial(2*n)*x**n/(factorial(n)**2*n)", "1/4", True, True),
    ],
)
def test_where_it_converges(terms: str, radius: str, above: bool, below: bool) -> None:
    s = series(terms)
    assert s is not None
    assert str(radius_of(s)) == radius
    r = f"({radius})"
    ends = ("-x", "x") if "(-x)" in terms else ("x", "-x")
    assert out_of_range(s, Given.parse(f"abs(x) < {r}")) == ""
    for x, holds in zip(ends, (above, below), strict=True):
        assert (out_of_range(s, Given.parse(f"0 <= {x}, {x} <= {r}")) == "") is holds
        assert out_of_range(s, Given.parse(f"0 <= {x}, {x} <= 2*{r}"))


def test_a_series_that_diverges_everywhere_has_no_range() -> None:
    s = series("factorial(n)*x**n")
    assert s is not None
    assert out_of_range(s, Given.parse("x >= 0, x <= 0"))


def test_numbers_diverge_beyond_the_radius() -> None:
    s = series("(3/2)**n")
    assert s is not None
    assert out_of_range(s, Given()) == "the series diverges"


def test_factorials_of_fractions_are_no_numbers() -> None:
    assert folded(read("1 == factorial(1/2)").comparisons[0].right) is None
