"""Points of conditions in floating point."""

from collections.abc import Callable

import pytest

from tresym.reals.language.parsing import parse_claim, parse_given
from tresym.repair.floating import Points
from tresym.repair.samples import held, sampled

Holds = Callable[[dict[str, float]], bool]


@pytest.mark.parametrize(
    ("given", "holds"),
    [
        ("x > 0", lambda p: p["x"] > 0),
        ("0 < x < 1", lambda p: 0 < p["x"] < 1),
        ("x <= -2", lambda p: p["x"] <= -2),
        ("n integer, n >= 3", lambda p: p["n"] >= 3 and p["n"] == round(p["n"])),
        ("x < y, y < 1", lambda p: p["x"] < p["y"] < 1),
        ("y == x**2", lambda p: p["y"] == p["x"] ** 2),
        ("1000 < x**2 < 1001", lambda p: 1000 < p["x"] ** 2 < 1001),
    ],
)
def test_points_lie_in_the_conditions(
    given: str, holds: Callable[[dict[str, float]], bool]
) -> None:
    found = sampled(["x"], parse_given(given), 8)
    assert found is not None
    assert found.count >= 2
    for n in range(found.count):
        assert holds({name: row[n] for name, row in found.at.items()})


def test_points_are_on_both_sides_of_zero_small_and_large() -> None:
    found = sampled(["x"], [], 30)
    assert found is not None
    row = found.at["x"]
    assert min(row) < -1
    assert max(row) > 5
    assert any(0 < x < 1 for x in row)


def test_a_comparison_without_values_is_neither_held_nor_broken() -> None:
    points = Points({"x": [4.0, -1.0, 9.0]})
    assert held(points, parse_claim("sqrt(x) == 2")[0]) == [True, None, False]
