"""Points downhill: they find what samples miss, and none outside the conditions is the end."""

import pytest
from flint import arb, fmpq

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.local_search import low_points
from tresym.reals.language.parsing import parse

VALLEYS = [
    ("(x - 37/3)**2 - 1/1000000", "", {"x": 1}),
    ("(x + 21)**4 - 1/1000000", "", {"x": 5}),
    ("(x - y - 7/2)**2 + (x + y - 50)**2 - 1/100000", "", {"x": 1, "y": -1}),
    ("x*log(x) + 36787/100000", "x > 0", {"x": 3}),
    ("abs(x - 5) + abs(y - 9) - 1/1000", "", {"x": 0, "y": 0}),
    ("x + 1/x - 2000001/1000000", "x > 0", {"x": 9}),
    ("exp(x - 11) - x + 10 - 1/10**9", "", {"x": 2}),
]


@pytest.mark.parametrize(("text", "under", "start"), VALLEYS)
def test_a_narrow_valley_is_found(text: str, under: str, start: dict[str, int]) -> None:
    e = parse(text)
    from_here = {name: fmpq(x) for name, x in start.items()}
    points = list(low_points(e, Given.parse(under), [from_here]))
    values = [evaluate(e, {n: arb(x) for n, x in p.items()}) for p in points]
    assert any(value < 0 for value in values)


@pytest.mark.parametrize(
    ("text", "under", "start"),
    [
        ("x", "x > 1", {"x": 3}),
        ("x + y", "x**2 + y**2 < 4", {"x": 1, "y": 1}),
        ("-x", "log(x) < 1", {"x": 2}),
        ("x", "sqrt(x - 1/7) > 0", {"x": 3}),
    ],
)
def test_the_end_of_the_descent_is_inside_and_lower(
    text: str, under: str, start: dict[str, int]
) -> None:
    e, given = parse(text), Given.parse(under)
    from_here = {name: fmpq(x) for name, x in start.items()}
    *_, last = low_points(e, given, [from_here])
    at = {name: arb(x) for name, x in last.items()}
    assert all(condition.holds(at) for condition in given.conditions)
    assert evaluate(e, at) < evaluate(e, {n: arb(x) for n, x in from_here.items()})


def test_starts_without_a_value_are_left_out() -> None:
    outside, inside = {"x": fmpq(-1)}, {"x": fmpq(2)}
    assert list(low_points(parse("log(x) + 1"), Given(), [outside])) == []
    assert len(list(low_points(parse("log(x) + 1"), Given(), [outside, inside]))) == 4


def test_the_lowest_starts_are_taken() -> None:
    starts = [{"x": fmpq(k)} for k in range(20, 0, -1)]
    first = next(low_points(parse("abs(x - 1/3) + 1"), Given(), starts))
    assert abs(first["x"] - fmpq(1, 3)) < fmpq(1, 10)
