"""Normal forms written as expressions keep their values, and numerators the zeros."""

import pytest
from cases import cases
from flint import arb, fmpq

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.expression import Expr
from tresym.reals.language.parsing import parse
from tresym.reals.normal.field import Field
from tresym.reals.normal.to_expression import numerator, written

SAME = cases(__file__, "SAME")
POINTS = [(fmpq(2, 7), fmpq(5, 3)), (fmpq(19, 11), fmpq(1, 9)), (fmpq(-3, 4), fmpq(-5, 2))]


def at(point: tuple[fmpq, fmpq]) -> dict[str, arb]:
    return {name: arb(value) for name, value in zip("xy", point, strict=True)}


def points(given: str) -> list[dict[str, arb]]:
    conditions = Given.parse(given).conditions
    return [p for p in map(at, POINTS) if all(c.holds(p) for c in conditions)]


@pytest.mark.parametrize(("text", "given"), SAME)
def test_written_has_the_value(text: str, given: str) -> None:
    field = Field(Given.parse(given))
    (value,) = field.normal(parse(text))
    for p in (value.num, value.den):
        e = written(field, p)
        assert e is not None
        for point in points(given):
            found = evaluate(e, point)
            assert found.is_finite()
            assert found.overlaps(field.ring.ball(p, point))
    whole = written(field, value.num) / written(field, value.den)  # type: ignore[operator]
    met = 0
    for point in points(given):
        expected, found = evaluate(parse(text), point), evaluate(whole, point)
        if expected.is_finite() and found.is_finite():
            assert found.overlaps(expected)
            assert found.rel_accuracy_bits() > 20
            met += 1
    assert met


@pytest.mark.parametrize(
    "text",
    ["abs(x)", "cos(pi/7)*x", "sqrt(2 + sign(x))", "log(1 + abs(x))", "atan(x + abs(x))"],
)
def test_a_sign_or_a_cosine_is_not_written(text: str) -> None:
    field = Field(Given())
    (value,) = field.normal(parse(text))
    assert written(field, value.num) is None


def test_an_unknown_function_is_not_written() -> None:
    field = Field(Given(), frozenset())
    (value,) = field.normal(parse("x + sin(x)"))
    assert written(field, value.num) is None


NUMERATORS = [
    # and one of its zeros
    ("x/(1 + y^2) - 1", "", (2, 1)),
    ("1/x - 1/y", "", (3, 3)),
    ("x - 1/(y + 1)", "", (fmpq(1, 4), 3)),
    ("sin(x)/cos(x)", "-1 < x, x < 1", (0, 1)),
    ("exp(x) - exp(-x)", "", (0, 2)),
    ("sqrt(x) - 1/sqrt(x)", "x > 0", (1, 2)),
    ("log(x) - y/(x + 1)", "x > 0", (1, 0)),
]


@pytest.mark.parametrize(("text", "given", "zero"), NUMERATORS)
def test_the_numerator_has_the_zeros_and_no_denominator(
    text: str, given: str, zero: tuple[fmpq, fmpq]
) -> None:
    found: Expr = numerator(parse(text), Given.parse(given))
    assert evaluate(found, at(zero)).contains(0)
    signs = set()
    for point in points(given):
        value = evaluate(found, point)
        assert not value.contains(0)
        signs.add(bool(value / evaluate(parse(text), point) > 0))
    assert signs
    outside = {"x": arb(1) / 7, "y": arb(-1)}  # where x = 1/(y + 1) has a pole
    assert evaluate(found, outside).is_finite()


@pytest.mark.parametrize("text", ["abs(x) + 1", "1/(x - x)", "(x + y + 1)^500", "cos(pi/7)*x"])
def test_what_cannot_be_written_stays(text: str) -> None:
    e = parse(text)
    assert numerator(e, Given()) is e
