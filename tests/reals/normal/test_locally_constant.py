"""Constants on regions: walls that a normal form hides, and claims with a near falsehood each."""

from __future__ import annotations

import pytest

from tresym.reals.decisions.identity import decide
from tresym.reals.language.parsing import parse
from tresym.reals.normal.field import ALL_THEORIES, Field
from tresym.reals.normal.locally_constant import equal_by_derivative
from tresym.reals.places.conditions import Given
from tresym.reals.verdict import Verdict

PAIRS = [
    ("2*atan(sin(t)/(1 + cos(t)))", "t", "-pi < t < pi", "0 < t < 33/10"),
    ("2*atan(sin(t)/(1 + cos(t)))", "t - 2*pi", "pi < t < 3*pi", "2*pi < t < 19/2"),
    ("2*atan((1 - cos(t))/sin(t))", "t", "0 < t < pi", "0 < t < 33/10"),
    ("atan(sin(2*t)/(1 + cos(2*t)))", "t", "-pi/2 < t < pi/2", "0 < t < 2"),
    ("2*atan(cos(t)/(1 - sin(t)))", "t + pi/2", "-pi < t < pi/2", "0 < t < 5/3"),
    ("2*atan(sin(x**2)/(1 + cos(x**2)))", "x**2", "-1 < x < 17/10", "0 < x < 9/5"),
    (
        "2*atan(sin(x + y)/(1 + cos(x + y)))",
        "x + y",
        "0 < x < pi/2, 0 < y < pi/2",
        "0 < x < 2, 0 < y < 2",
    ),
    ("acos(cos(x))", "x", "0 <= x <= pi", "0 <= x <= 4"),
    ("asin(sin(x))", "x", "-pi/2 <= x <= pi/2", "-3/2 < x < 2"),
    ("atan(tan(x))", "x", "-pi/2 < x < pi/2", "-3/2 < x < 2"),
    (
        "atan(sin(x)/2) + atan(sin(x)/3)",
        "atan(5*sin(x)/(6 - sin(x)**2))",
        "",
        None,
    ),
    ("2*atan(x)", "atan(2*x/(1 - x**2))", "-1 < x < 1", "-1/2 < x < 101/100"),
    ("atan(x) + atan(1/x)", "pi/2", "x > 0", "x > -1/1000"),
    ("acosh(2*x**2 - 1)", "2*acosh(x)", "", "x < -1/2"),
    ("log(abs(tan(x/2)))", "log(1 - cos(x)) - log(abs(sin(x)))", "", None),
    ("2*atan(tanh(x/2))", "atan(sinh(x))", "", None),
]
"""Left, right, where they are equal, and where they are so at some points and not at all."""


@pytest.mark.parametrize(("left", "right", "true", "false"), PAIRS)
def test_a_region_of_truth_and_one_that_exceeds_it(
    left: str, right: str, true: str, false: str | None
) -> None:
    sides = parse(left), parse(right)
    if false is None:
        sides_apart = sides[0], sides[1] + parse("1/10^30")
        assert decide(*sides_apart, Given.parse(true)).verdict is not Verdict.PROVED
    else:
        assert decide(*sides, Given.parse(false)).verdict is not Verdict.PROVED
        assert equal_by_derivative(*sides, Given.parse(false), ALL_THEORIES, 64) is None
    assert decide(*sides, Given.parse(true)).verdict is Verdict.PROVED


HIDDEN = [
    ("1 + cos(x)", "0 < x < 4"),  # 2/(1 + t²), which t = ∞ makes 0
    ("sin(x)", "1 < x < 4"),  # 2t/(1 + t²)
    ("1 + cos(x)", ""),
    ("1 + cos(x + y)", "0 < x < 2, 0 < y < 2"),
    ("exp(x)*(1 + cos(x))/(2 + cos(x))", "0 < x < 4"),
    ("2 + cos(x) + cos(x**2/pi)", "0 < x < 4"),  # 0 only where two half tangents are infinite
    ("log(2 + cos(x))", "0 < x < 4"),  # inside logarithms, positive at all other points
    ("abs(1 + cos(x))", "0 < x < 4"),
    ("cbrt(1 + cos(x))", "0 < x < 4"),
    ("(1 + cos(x))**x", "0 < x < 4"),
    ("1 + tanh(log(1 + cos(x)))", "0 < x < 4"),
    ("pi/2 - atan(1/(1 + cos(x)))", "0 < x < 4"),
]
"""Singularities at one point inside, of which no factor of the normal form tells."""


@pytest.mark.parametrize(("e", "given"), HIDDEN)
def test_no_base_point_serves_both_sides_of_a_hidden_wall(e: str, given: str) -> None:
    """True of the claim, but no more than of any function that is constant on either side."""
    sides = parse(f"1/({e})"), parse(f"1/({e}) + 0*x")
    assert equal_by_derivative(*sides, Given.parse(given), ALL_THEORIES, 64) is None


def test_the_zeros_of_what_a_sign_is_of_are_walls() -> None:
    """atan(u) of u = (x − 50)/(x − 51) is ±π/2 − atan(1/u), and 0 at 50, where neither case is."""
    e = "(x - 50)**2 + atan((x - 50)/(x - 51))**2"
    sides = parse(f"1/({e})"), parse(f"1/({e}) + 0*x")
    proof = equal_by_derivative(*sides, Given(), ALL_THEORIES, 64)
    assert proof is not None
    assert proof.endswith("x = 0; x = 101/2; x = 52")


@pytest.mark.parametrize("function", ["exp(u)", "atan(u)", "cos(u)", "asinh(u)**2"])
def test_what_is_cancelled_in_the_argument_of_a_generator_is_a_wall(function: str) -> None:
    """u = 1/(1 + x + |x|) is (1 + x − σx)/(1 + 2x), and 2x + 1 is nowhere a denominator of u."""
    e = function.replace("u", "(1/(x + 1 + abs(x)))")
    sides = parse(f"1/(2 + {e})"), parse(f"1/(2 + {e}) + 0*x")
    proof = equal_by_derivative(*sides, Given(), ALL_THEORIES, 64)
    assert proof is not None
    assert proof.endswith("x = -1; x = -1/3; x = 1")


def test_where_conditions_are_undefined_is_a_wall() -> None:
    sides = parse("atan(x)"), parse("atan(x) + 0*x")
    given = Given.parse("(x - 9)/(x - 9) + x**2 > 0")
    proof = equal_by_derivative(*sides, given, ALL_THEORIES, 64)
    assert proof is not None
    assert proof.endswith("x = 0; x = 10")


@pytest.mark.parametrize("text", ["x**2 + y**2", "x**2*y**2 + z**4"])
def test_squares_that_vanish_together_are_not_definite(text: str) -> None:
    field = Field(Given())
    (value,) = field.normal(parse(text))
    assert field.definite(value.num) == 0
    assert field.definite(value.num + 1) == 1
