"""Constants on regions: walls that a normal form hides, and claims with a near falsehood each."""

import pytest
from cases import cases
from flint import Ordering, arb, fmpq, fmpz_mpoly_ctx

from tresym.reals.decisions.identity import decide
from tresym.reals.domain.conditions import Given
from tresym.reals.language.expression import number
from tresym.reals.language.parsing import parse
from tresym.reals.normal import locally_constant
from tresym.reals.normal.field import ALL_THEORIES, Field
from tresym.reals.normal.locally_constant import (
    _are_real,
    _gap,
    _inside,
    _zeros,
    equal_by_derivative,
)
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.verdict import Verdict

PAIRS = cases(__file__, "PAIRS")
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


HIDDEN = cases(__file__, "HIDDEN")
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
    assert field.signs.definite(value.num) == 0
    assert field.signs.definite(value.num + 1) == 1


LEVEL_AT_THE_BASE = [
    ("x", "0*x"),
    ("sin(x)", "x"),
    ("atan(x) + y", "atan(x)"),
    ("x + atan(y)", "atan(y)"),
    ("atan(x) + x*y", "atan(x)"),
]
"""Equal at the base point, where all symbols are 0, and constant in no direction or in one."""


@pytest.mark.parametrize(("left", "right"), LEVEL_AT_THE_BASE)
def test_a_derivative_that_is_not_0_is_no_constant(left: str, right: str) -> None:
    assert equal_by_derivative(parse(left), parse(right), Given(), ALL_THEORIES, 64) is None


def test_a_theory_that_is_not_named_is_not_used() -> None:
    sides = parse("sin(x)**2 + cos(x)**2"), parse("sin(0*x)**2 + cos(0)**2")
    assert equal_by_derivative(*sides, Given(), frozenset(), 64) is None


TWO_REGIONS = parse("1/x"), parse("1/x + 0*x")


@pytest.mark.parametrize("second", [None, False])
def test_a_region_that_is_unclear_is_no_region_outside(
    second: bool | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    found = iter([True, second])
    monkeypatch.setattr(locally_constant, "_inside", lambda *_: next(found))
    proof = equal_by_derivative(*TWO_REGIONS, Given(), ALL_THEORIES, 64)
    assert (proof is None) == (second is None)


def test_where_no_region_is_inside_nothing_is_proved(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(locally_constant, "_inside", lambda *_: False)
    assert equal_by_derivative(*TWO_REGIONS, Given(), ALL_THEORIES, 64) is None


def test_a_slope_that_is_real_nowhere_near_is_no_proof(monkeypatch: pytest.MonkeyPatch) -> None:
    assert equal_by_derivative(*TWO_REGIONS, Given(), ALL_THEORIES, 64) is not None
    monkeypatch.setattr(locally_constant, "_are_real", lambda *_: False)
    assert equal_by_derivative(*TWO_REGIONS, Given(), ALL_THEORIES, 64) is None


def test_regions_too_hard_to_find_are_no_proof(monkeypatch: pytest.MonkeyPatch) -> None:
    point = {"x": number(1)}
    monkeypatch.setattr(locally_constant, "_candidates", lambda *_: iter([point, None]))
    assert equal_by_derivative(*TWO_REGIONS, Given(), ALL_THEORIES, 64) is None


INSIDE = cases(__file__, "INSIDE")


@pytest.mark.parametrize(("left", "right", "given", "at", "expected"), INSIDE)
def test_a_point_is_inside_where_conditions_and_both_sides_are_shown(
    left: str, right: str, given: str, at: str, expected: bool | None
) -> None:
    point = {"x": parse(at)}
    assert _inside(parse(left), parse(right), Given.parse(given), point) is expected


def test_every_slope_is_real_at_a_base_point() -> None:
    at = {"x": parse("-1")}
    assert _are_real([parse("x"), parse("1/x")], at)
    assert not _are_real([parse("x"), parse("sqrt(x)")], at)


def test_a_loose_end_is_cut_out_and_no_wall_lies_in_the_cut() -> None:
    end = parse("pi/2 - x")
    (x,) = fmpz_mpoly_ctx.get(["v0"], Ordering.lex).gens()
    gap = _gap(end, ["x"], [x + 5, x - 2])
    assert gap is not None
    low, high = gap
    with ball_precision(256):
        assert arb(low) < arb.pi() / 2 < arb(high)
    assert high - low < fmpq(1, 2**60)
    middle = (low + high) / 2
    inside = x * int(middle.q) - int(middle.p)
    assert _gap(end, ["x"], [inside]) is None
    assert _gap(end, ["x"], [x + 5, inside]) is None
    assert _gap(end, ["x", "y"], []) is None
    assert _gap(parse("log(x)"), ["x"], []) is None


WALLS = [
    ("x - y", {"v0 - v1"}),
    ("(x - y)*(x + 2*y)", {"v0 - v1", "v0 + 2*v1"}),
    ("x - sqrt(y)", {"v0^2 - v1", "v1"}),
    ("x**2 + y**2 + 1", set()),
    ("(x - sqrt(y))*(y - 2*sqrt(x))", {"v0^2 - v1", "4*v0 - v1^2", "v0", "v1"}),
    ("x - abs(y)", {"v0^2 - v1^2", "v1"}),
]


@pytest.mark.parametrize(("e", "expected"), WALLS)
def test_walls_hold_the_zeros_of_an_expression(e: str, expected: set[str]) -> None:
    whole = parse(e)
    walls = _zeros(whole, whole, [whole], Field(Given()), ["x", "y"])
    assert walls is not None
    assert expected <= {str(wall if wall.leading_coefficient() > 0 else -wall) for wall in walls}
    assert bool(walls) == bool(expected)


@pytest.mark.parametrize("e", ["x - exp(y)", "x - z", "sin(x) - 1/3", "x - cos(pi/7)"])
def test_a_wall_that_is_no_polynomial_of_the_names_is_no_wall_known(e: str) -> None:
    whole = parse(e)
    assert _zeros(whole, whole, [whole], Field(Given()), ["x", "y"]) is None
