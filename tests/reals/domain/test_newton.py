"""Points on equations: every ball holds one, and none is found where there is none."""

import pytest

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.newton import points_on
from tresym.reals.language.parsing import parse

SYSTEMS = [
    (["x**2 + y**2 - 1"], "x > 0, y > 0"),
    (["x + 1/x - 3"], "x < 1"),
    (["v - u - a*t", "s - u*t - a*t**2/2"], "t > 0"),
    (["sin(x) - 1/2"], ""),
]
EMPTY = [
    (["x**2 + y**2 + 1"], ""),
    (["x**2 + y**2 - 1"], "x > 2"),
    (["x - 1", "x - 2"], ""),
    (["sqrt(x) + 1"], ""),
    (["x**2"], ""),  # a double zero is not shown
]


@pytest.mark.parametrize(("equations", "given"), SYSTEMS)
def test_a_ball_holds_a_point(equations: list[str], given: str) -> None:
    trees = [parse(text) for text in equations]
    at = next(points_on(trees, Given.parse(given), []))
    assert all(evaluate(e, at).contains(0) for e in trees)
    assert all(condition.holds(at) for condition in Given.parse(given).conditions)


@pytest.mark.parametrize(("equations", "given"), EMPTY)
def test_no_point_where_there_is_none(equations: list[str], given: str) -> None:
    assert next(points_on([parse(e) for e in equations], Given.parse(given), []), None) is None
