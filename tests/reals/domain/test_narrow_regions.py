"""Points on conditions that hold far away or on narrow sets, where samples miss them."""

from itertools import islice

import pytest
from flint import arb, fmpq

from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.narrow_regions import MAX_DEGREE, windows
from tresym.reals.domain.sample_points import ExactPoint
from tresym.reals.language.expression import symbols
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.arithmetic import ball_precision


def found(positive: list[str]) -> list[ExactPoint]:
    conditions = [parse(text) for text in positive]
    names = sorted(frozenset().union(*map(symbols, conditions)))
    return list(windows(conditions, [dict.fromkeys(names, fmpq(1, 3))]))


def inside(positive: list[str], point: ExactPoint) -> bool:
    with ball_precision(256):
        at = {name: arb(value) for name, value in point.items()}
        return all(bool(evaluate(parse(text), at) > 0) for text in positive)


MET = [
    ["x - 10**30"],
    ["(10**9*x - 1)*(2 - 10**9*x)"],
    ["x - 10**6", "10**6 + 1/10**6 - x"],
    ["1/10**12 - (x - 7)**2 - (y - 5)**2"],
    ["x*y - 1", "-x", "1/10**3 - y - x - 10**4"],
    ["x**2 - 2", "2 + 1/10**20 - x**2", "-x"],
    ["1 - x**2 - y**2", "x + y - 7/5"],
    ["log(x - 10**6)", "10**6 + 2 - x"],
    ["sqrt((x - 3)*(4 - x))"],
    ["sin(x) - 999/1000", "x - 100"],
    ["1/10**6 - abs(exp(x) - 1000)"],
]


@pytest.mark.parametrize("positive", MET, ids=", ".join)
def test_a_point_inside_is_met(positive: list[str]) -> None:
    assert any(inside(positive, point) for point in found(positive))


@pytest.mark.parametrize(
    "positive",
    [["-1 - x**2"], ["x - 1", "-x"], ["x*y - 1", "-x - y", "x"], ["sin(x) - 2"]],
    ids=", ".join,
)
def test_no_point_is_inside_of_nothing(positive: list[str]) -> None:
    points = found(positive)
    assert points
    assert not any(inside(positive, point) for point in points)


@pytest.mark.parametrize("positive", [*MET, [f"x**{MAX_DEGREE + 1} - 2"], ["x*y*z - 9"]])
def test_every_point_has_every_coordinate_and_the_search_ends(positive: list[str]) -> None:
    names = sorted(frozenset().union(*(symbols(parse(text)) for text in positive)))
    assert all(sorted(point) == names for point in found(positive))


def test_variables_without_a_condition_stay_where_they_were() -> None:
    start = {"x": fmpq(0), "y": fmpq(5, 7)}
    regions = islice(windows([parse("x**2 - 10**9")], [start]), 3)
    assert all(point["y"] == fmpq(5, 7) for point in regions)


def test_every_region_of_polynomials_has_its_point() -> None:
    """Also inside of other functions, at whose zeros they change their ways."""
    regions = found(["abs(x**2 - 10**8) - abs(x) + 10**20"])
    assert any(p["x"] < -(10**4) for p in regions)
    assert any(p["x"] > 10**4 for p in regions)
    assert any(-(10**4) < p["x"] < 0 for p in regions)
