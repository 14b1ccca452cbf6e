"""Where an interval of integration is cut: zeros, turns of angles, and roots of squares."""

import pytest
from flint import fmpq

from tresym.reals.decisions.integration_pieces import (
    decided_number,
    pieces_of,
    roots_of_squares,
    without_corners,
)
from tresym.reals.domain.conditions import Given
from tresym.reals.language.parsing import parse


@pytest.mark.parametrize(
    ("part", "high", "cuts"),
    [
        ("abs(x - 1)", "2", ["0", "1", "2"]),
        ("abs(x**2 - 2)", "2", ["0", "sqrt(2)", "2"]),
        ("abs(x - 3)", "2", ["0", "2"]),
        ("abs(sin(x))", "2*pi", ["0", "pi", "2*pi"]),
        ("x", "2", ["0", "2"]),
    ],
)
def test_pieces_end_at_corners(part: str, high: str, cuts: list[str]) -> None:
    found = list(pieces_of("x", [parse(part)], parse("0"), parse(high)))
    assert [str(low) for low, _ in found] + [str(found[-1][1])] == cuts


def test_what_has_one_sign_has_no_corner() -> None:
    assert without_corners(parse("abs(x)"), Given.parse("x < 0")) == parse("-x")
    assert without_corners(parse("abs(x)"), Given()) == parse("abs(x)")


def test_a_root_of_a_square_is_an_absolute_value() -> None:
    (found,) = roots_of_squares(parse("sqrt(1 - sin(x)**2)"), Given())
    assert str(found[1]) == "abs(cos(x))"


def test_rational_numbers_are_recognised() -> None:
    assert decided_number(parse("sqrt(4)/3")) == fmpq(2, 3)
    assert decided_number(parse("x")) is None
