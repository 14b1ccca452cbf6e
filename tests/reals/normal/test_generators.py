"""Generators have the value, the symbols and the name of the function that they stand for."""

import pytest
from cases import cases
from flint import arb, fmpq

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.parsing import parse
from tresym.reals.normal.field import Field
from tresym.reals.normal.ring import Fraction

KINDS = {
    "symbol": ("x", "x*y - x/y"),
    "pi": ("pi", "pi*x"),
    "root": ("sqrt(x)", "sqrt(x) + y*x**(2/3)"),
    "nested root": ("root", "sqrt(3 + sqrt(x + y))"),
    "sign": ("sign", "abs(x - y)"),
    "cosine": ("cosine", "cos(pi/7)*x"),
    "exp": ("exp", "exp(x/3) - exp(-y)"),
    "tan": ("tan", "sin(x + y)/(2 + cos(3*x))"),
    "log": ("log", "log(x + 1)/y"),
    "atan": ("atan", "atan(x + y)"),
    "plain turn": ("cos", "cos(pi*abs(x - y)/(x - y)*log(x)*log(y))"),
}
POINTS = [{"x": fmpq(2, 7), "y": fmpq(5, 3)}, {"x": fmpq(19, 4), "y": fmpq(1, 9)}]


def normal(text: str, given: str = "x > 0, y > 0") -> tuple[Field, Fraction]:
    field = Field(Given.parse(given))
    (value,) = field.normal(parse(text))
    return field, value


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("point", POINTS, ids=["first", "second"])
def test_value_in_balls(kind: str, point: dict[str, fmpq]) -> None:
    field, x = normal(KINDS[kind][1])
    at = {name: arb(value) for name, value in point.items()}
    value = field.ring.ball(x, at)
    assert value.is_finite()
    assert value.overlaps(evaluate(parse(KINDS[kind][1]), at))
    assert value.rel_accuracy_bits() > 30


@pytest.mark.parametrize(
    ("text", "point"),
    [
        ("x + z", {"x": fmpq(1)}),
        ("sign(x - y)", {"x": fmpq(1), "y": fmpq(1)}),
        ("log(x - y)", {"x": fmpq(1), "y": fmpq(1)}),
        ("1/(x - y)", {"x": fmpq(1), "y": fmpq(1)}),
        ("exp(x)/(x - y)", {"x": fmpq(1), "y": fmpq(1)}),
    ],
)
def test_no_value_where_there_is_none(text: str, point: dict[str, fmpq]) -> None:
    field, x = normal(text)
    assert not field.ring.ball(x, {name: arb(value) for name, value in point.items()}).is_finite()


def test_no_value_of_an_unknown_function() -> None:
    field = Field(Given(), frozenset())
    (value,) = field.normal(parse("sin(x)"))
    assert not field.ring.ball(value, {"x": arb(1)}).is_finite()
    assert not field.ring.is_constant(value)
    (one,) = field.normal(parse("sin(1)"))
    assert not field.ring.is_constant(one)  # nothing is known of it


@pytest.mark.parametrize(
    ("text", "names"),
    cases(__file__, "dependence"),
)
def test_dependence(text: str, names: str) -> None:
    field, x = normal(text, "")
    assert field.ring.dependence(x) == frozenset(names)
    assert field.ring.is_constant(x) is (not names)


def test_involved_reaches_the_innermost() -> None:
    field, x = normal("log(1 + sqrt(exp(x) + 2))")
    kinds = {field.ring.at(i).kind for i in field.ring.involved(x.num)}
    assert kinds == {"log", "root", "exp", "symbol"}


def test_involved_reaches_what_is_unknown() -> None:
    field = Field(Given(), frozenset({"roots"}))
    (x,) = field.normal(parse("sqrt(x + sin(1))"))
    assert "opaque" in {field.ring.at(i).kind for i in field.ring.involved(x.num)}
