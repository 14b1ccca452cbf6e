"""Where what is differentiated is real: open ends to refute at, closed ones to prove on."""

import pytest
from cases import cases
from flint import arb, fmpq

from tresym.reals.decisions.derivative_domains import real_nowhere, where_real
from tresym.reals.domain.conditions import Given
from tresym.reals.language.parsing import parse


def texts(given: Given) -> set[str]:
    return {f"{left} {relation} {right}" for left, relation, right in given.comparisons}


@pytest.mark.parametrize(
    ("function", "by", "opened", "whole"),
    cases(__file__, "ends_are_left_out_to_refute_and_counted_in_to_prove"),
)
def test_ends_are_left_out_to_refute_and_counted_in_to_prove(
    function: str, by: str, opened: str, whole: str
) -> None:
    found = where_real(Given(), [parse(function)], by)
    assert [texts(part) for part in found] == [texts(Given.parse(t)) for t in (opened, whole)]


def test_conditions_that_were_given_stay() -> None:
    given = Given.parse("x < 5, y > 1")
    for part in where_real(given, [parse("sqrt(x - 2)"), parse("log(y)")], "xy"):
        assert part.comparisons[:2] == given.comparisons
        assert len(part.comparisons) == 4


@pytest.mark.parametrize("function", ["sqrt(-1 - x**2)", "log(-x**2)", "asin(x**2 + 2)"])
def test_what_holds_nowhere_stays_a_condition(function: str) -> None:
    """Or a claim about the derivatives of nothing would be one about all points."""
    for part in where_real(Given(), [parse(function)], "x"):
        assert part.comparisons
        assert not list(part.points(["x"], 1))


@pytest.mark.parametrize("n", [-3, -2, 0, 1, 3])
def test_a_point_is_inside_where_the_function_is_real(n: int) -> None:
    opened, whole = where_real(Given(), [parse("(x + 1)**(3/2)")], "x")
    for part in (opened, whole):
        assert all(c.holds({"x": arb(fmpq(n))}) for c in part.conditions) is (n > -1)


@pytest.mark.parametrize(
    ("functions", "given", "expected"),
    [
        (["log(-1 - x**2)"], "", True),
        (["sqrt(-x**2)"], "", False),  # it is real at 0
        (["sqrt(-x**2)/x"], "", True),
        (["sqrt(-x**2)", "1/(3*x**2*y)"], "", True),
        (["sqrt(-x**2)", "1/(x + y)"], "", False),
        (["sqrt(-x**2)", "1/(x**2 + y)"], "", False),
        (["log(x)"], "x < -1", True),
        (["log(x + y)"], "x < -1, y < 0", True),
        (["log(x + y)"], "x < -1", False),
        (["log(x + y)", "sqrt(-y)"], "x < -1", True),
        (["atanh(cosh(x))"], "", True),
        (["asin(cosh(x))"], "", False),  # it is real at 0
        (["tan(x)/(cos(x)**2 + sin(x)**2 - 1)"], "", True),
    ],
)
def test_what_is_real_nowhere_is_shown_to_be(
    functions: list[str], given: str, expected: bool
) -> None:
    assert real_nowhere(Given.parse(given), list(map(parse, functions))) is expected
