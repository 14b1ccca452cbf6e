"""Exact places of equality, and that none is found where there is none."""

import pytest
from flint import fmpq

import tresym
from tresym.reals.decisions.algebraic_witnesses import (
    equal_at_algebraic,
    equal_at_simple,
    equal_at_turns,
)
from tresym.reals.domain.conditions import Given
from tresym.reals.language.parsing import parse
from tresym.reals.verdict import Verdict

pytestmark = pytest.mark.quick


@pytest.mark.parametrize(
    ("left", "given", "found"),
    [
        ("(x**3 - 3*x + 1)**2", "", True),
        ("(x**5 - x - 1)**2", "x > 0", True),
        ("(x**5 - x - 1)**2", "x < 0", False),
        ("(x**5 - x - 1)**2", "x < 1.1673", False),
        ("(x**4 + x + 1)**2", "", False),  # no real zero
        ("(x**3 - 2)/(x**3 - 2)", "", False),
        ("(x**3 - 2)**2/(x**3 - 2)", "", False),  # not defined there
        ("sqrt(x**2)", "", False),
        ("(x**2 - 2)**2 + 1/10**60", "", False),
        ("(2*x - 1)**2", "", True),
        ("x**2 + y", "", False),
        ("(x**2 - 2)**2", "x*y > 0", True),
        ("(x**2 - 2)**2", "x*y > 3, 0 < y < 2", False),
        ("(x**2 - 2)**2*(1 + y**2)", "y > 2", True),
        ("(x**2 - 2)**2*(1 + y**2)/(x**2 - 2)", "y > 2", False),
        ("(x**2 - 2*y**2)**2", "y > 2", False),  # of no factor in one variable
    ],
)
def test_zeros_of_polynomials(left: str, given: str, found: bool) -> None:
    answer = equal_at_algebraic(parse(left), parse("0"), Given.parse(given))
    assert (answer is not None) is found


def test_a_rational_zero_is_exact() -> None:
    answer = tresym.check("x < 10**40")
    assert answer.verdict is Verdict.REFUTED
    assert answer.witness == {"x": str(10**40)}


@pytest.mark.parametrize(
    ("right", "found"), [("3*sqrt(3)/2", True), ("3*sqrt(3)/2 + 1/10**40", False)]
)
def test_points_of_simple_constants(right: str, found: bool) -> None:
    near = {"x": fmpq(1047197551, 10**9), "y": fmpq(1047197551, 10**9)}
    left = parse("sin(x) + sin(y) + sin(x + y)")
    answer = equal_at_simple(parse(right), left, Given(), near)
    assert (answer is not None) is found
    assert equal_at_simple(parse(right), left, Given.parse("x < 1.04"), near) is None


@pytest.mark.parametrize(
    ("claim", "verdict"),
    [
        ("exp(x) != 1 given x != 0", Verdict.PROVED),
        ("exp(x) != 2 given x != 0", Verdict.REFUTED),
        ("exp(x) != 1 given x != 1", Verdict.REFUTED),
        ("tan(x) != x given x > 0", Verdict.REFUTED),
        ("tan(x) != x given 0 < x < pi/2", Verdict.PROVED),
        ("1/x != 0 given x != 0", Verdict.PROVED),
        ("abs(x + 10**9) == x + 10**9", Verdict.REFUTED),
        ("abs(x + 10**9) == x + 10**9 given x > -10**9", Verdict.PROVED),
    ],
)
def test_where_signs_can_change(claim: str, verdict: Verdict) -> None:
    assert tresym.check(claim).verdict is verdict


@pytest.mark.parametrize("claim", ["(x**2 - 2)**2*(1 + y**2) > 0", "(x**2 - 2)**2*(x + y) != 0"])
def test_a_zero_in_one_variable_is_confirmed(claim: str) -> None:
    assert tresym.check(claim).verdict is Verdict.REFUTED


def test_an_open_cell_shows_what_no_sample_does() -> None:
    answer = tresym.check("(x - 1000)**2*(x - 1001) >= 0", "x >= 1000.5, x <= 1001")
    assert answer.verdict is Verdict.REFUTED


@pytest.mark.parametrize(
    ("left", "given", "found"),
    [
        ("a**2 + b**2 + 2*a*b*cos(x)", "a > 0, b > 0", True),
        ("a**2 + b**2 + 2*a*b*cos(x) + 1/10**40", "a > 0, b > 0", False),
        ("a**2 + b**2 + 2*a*b*cos(x)", "a > 0, b > 0, x < 3", False),
        ("a**2 + b**2 + 2*a*b*cos(x)", "a > 0, b > 0, z > 0", False),
        ("a*(1 - sin(x))", "a > 0", True),
        ("a*(1 - sin(x))/cos(x)", "a > 0", False),  # not defined there
        ("a**2 + b**2 + 2*a*b", "a > 0, b < 0", False),  # no angle
        ("1 - sin(x)", "", False),  # of one variable
    ],
)
def test_quarter_turns(left: str, given: str, found: bool) -> None:
    answer = equal_at_turns(parse(left), parse("0"), Given.parse(given))
    assert (answer is not None) is found
