"""At an exact point, equal constants are found equal, and nothing else is."""

import pytest
from cases import cases
from flint import arb, fmpq

from tresym.reals.domain.conditions import Condition, Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.expression import Expr
from tresym.reals.language.parsing import parse
from tresym.reals.normal.at_point import equal_at, satisfies

EQUAL = [
    ("x^2", "2", {"x": "sqrt(2)"}),
    ("x^3 - 3*x", "1", {"x": "2*cos(pi/9)"}),
    ("sin(x)", "sqrt(3)/2", {"x": "2*pi/3"}),
    ("sin(x)", "1/2", {"x": "5*pi/6"}),
    ("exp(x*y)", "9", {"x": "log(3)", "y": "2"}),
    ("atan(x) + atan(y)", "pi/4", {"x": "1/2", "y": "1/3"}),
    ("sqrt(x)", "1 + sqrt(2)", {"x": "3 + 2*sqrt(2)"}),
    ("abs(x - y)", "y - x", {"x": "1", "y": "sqrt(2)"}),
    ("x**y", "x**y", {"x": "2", "y": "sqrt(2)"}),
    ("cbrt(x)", "-2", {"x": "-8"}),
    ("sqrt(x)", "0", {"x": "0"}),
]
NOT_EQUAL = [
    ("x^2", "2", {"x": "sqrt(2) + 1/10^50"}),
    ("x^3 - 3*x", "1", {"x": "2*cos(2*pi/9)"}),
    ("sin(x)", "sqrt(3)/2", {"x": "2*pi/3 + 1/10^80"}),
    ("exp(x)", "640320^3 + 744", {"x": "pi*sqrt(163)"}),
    ("atan(x) + atan(y)", "-3*pi/4", {"x": "1/2", "y": "1/3"}),
    ("atan(x) + atan(y)", "atan((x + y)/(1 - x*y))", {"x": "2", "y": "3"}),
    ("sqrt(x^2)", "x", {"x": "-sqrt(2)"}),
    ("sqrt(x)", "-1 - sqrt(2)", {"x": "3 + 2*sqrt(2)"}),
    ("abs(x - y)", "x - y", {"x": "1", "y": "sqrt(2)"}),
    ("1/x", "1/x", {"x": "0"}),
    ("2**(x*y)", "2**(x*y)", {"x": "10^4", "y": "10^4"}),  # too long to write
]


def exact(point: dict[str, str]) -> dict[str, fmpq | Expr]:
    return {name: parse(text) for name, text in point.items()}


@pytest.mark.parametrize(("left", "right", "point"), EQUAL)
def test_equal(left: str, right: str, point: dict[str, str]) -> None:
    assert equal_at(parse(left), parse(right), exact(point))


@pytest.mark.parametrize(("left", "right", "point"), NOT_EQUAL)
def test_not_equal(left: str, right: str, point: dict[str, str]) -> None:
    assert not equal_at(parse(left), parse(right), exact(point))


CONDITIONS = cases(__file__, "CONDITIONS")


@pytest.mark.parametrize(("text", "at", "expected"), CONDITIONS)
def test_satisfies(text: str, at: str, expected: bool) -> None:
    condition: Condition
    (condition,) = Given.parse(text).conditions
    value = parse(at)
    found = satisfies(condition, {"x": value}, {"x": evaluate(value, {})})
    assert found is expected


def test_a_rational_point_needs_no_expression() -> None:
    assert equal_at(parse("x^2 - y"), parse("0"), {"x": fmpq(-3, 2), "y": fmpq(9, 4)})
    (condition,) = Given.parse("x^2 >= y").conditions
    point = {"x": fmpq(-3, 2), "y": fmpq(9, 4)}
    assert satisfies(condition, point, {name: arb(value) for name, value in point.items()})
