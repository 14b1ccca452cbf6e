"""Points with small numbers in conditions."""

from __future__ import annotations

from flint import fmpq

from tresym.reals.decisions.simple import simple_points
from tresym.reals.places.conditions import Given


def test_small_numbers_come_first_and_satisfy_the_conditions() -> None:
    assert simple_points(["a"], Given.parse("a > 0"), 2) == [{"a": fmpq(2)}, {"a": fmpq(3)}]
    far = simple_points(["a"], Given.parse("a > 1000"), 2)
    assert far
    assert all(point["a"] > 1000 for point in far)
    assert simple_points(["a"], Given.parse("a > 1, a < 0"), 2) == []
