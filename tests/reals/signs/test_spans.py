"""Ranges of constants and of absolute values, and the signs that follow from them."""

import pytest
from flint import fmpq

from tresym.reals.language.parsing import parse
from tresym.reals.numbers.exact import Interval
from tresym.reals.signs.spans import absolute_sign, beside, constant_sign, span_sign, times


@pytest.mark.parametrize(
    ("text", "sign"), [("pi - 3", "+"), ("3 - pi", "-"), ("exp(1) - exp(1)", None)]
)
def test_signs_of_constants(text: str, sign: str | None) -> None:
    assert constant_sign(parse(text)) in (sign, "0" if sign is None else sign)


@pytest.mark.parametrize(
    ("interval", "sign"),
    [
        (Interval(fmpq(0), None, True), "+"),
        (Interval(fmpq(0), None, False), ">=0"),
        (Interval(None, fmpq(0), False, True), "-"),
        (Interval(None, fmpq(0), False, False), "<=0"),
        (Interval(fmpq(-1), fmpq(1)), None),
    ],
)
def test_signs_of_intervals(interval: Interval, sign: str | None) -> None:
    assert span_sign(interval) == sign


def test_an_absolute_value_is_at_least_0_and_more_where_it_does_not_vanish() -> None:
    assert span_sign(absolute_sign(Interval(fmpq(-2), fmpq(1)), False)) == ">=0"
    assert span_sign(absolute_sign(Interval(fmpq(-2), fmpq(1)), True)) == "+"


def test_a_sign_bounds_from_one_side_and_signs_multiply() -> None:
    assert beside(fmpq(2), "+").low == 2
    assert beside(fmpq(2), "<=0").high == 2
    assert beside(fmpq(2), None) == Interval()
    assert (times("+", "-"), times("-", "<=0"), times("0", "+")) == ("-", ">=0", "0")
