"""Hypergeometric series: which sums are such, and where they converge."""

import pytest
from cases import cases

from tresym.reals.decisions.claim_parsing import read
from tresym.reals.decisions.hypergeometric import (
    Series,
    folded,
    out_of_range,
    radius_of,
    series_of,
)
from tresym.reals.domain.conditions import Given

NONE = cases(__file__, "NONE")


def series(terms: str, low: int | str = 1) -> Series | None:
    return series_of(read(f"1 == sum({terms}, n, {low}, oo)").comparisons[0].right)


@pytest.mark.parametrize("terms", NONE)
def test_what_is_no_such_series(terms: str) -> None:
    assert series(terms) is None


def test_an_index_counts_from_an_integer() -> None:
    assert series("x**n", "1/2") is None


@pytest.mark.parametrize(
    ("terms", "radius", "above", "below"),
    cases(__file__, "where_it_converges"),
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
