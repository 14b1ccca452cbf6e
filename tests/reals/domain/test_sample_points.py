"""Sample points lie inside their ranges, and corners at their closed ends."""

from fractions import Fraction

import pytest
from flint import fmpq
from hypothesis import given
from hypothesis import strategies as st

from tresym.reals.domain.sample_points import LONG, _sample, corners
from tresym.reals.numbers.exact import Interval

ends = st.fractions(max_denominator=10**6)
widths = st.one_of(
    st.fractions(Fraction(1, 10**9), 10**9),
    st.builds(lambda n: Fraction(1, 10**n), st.integers(1, 60)),
)
samples = st.integers(0, 200), st.integers(0, 5)


def _rational(x: Fraction) -> fmpq:
    return fmpq(x.numerator, x.denominator)


@given(ends, widths, *samples)
def test_a_bounded_range(low: Fraction, width: Fraction, k: int, j: int) -> None:
    where = Interval(_rational(low), _rational(low + width))
    x = _sample(where, k, j)
    assert where.low < x < where.high
    assert x == _sample(where, k, j)


@given(ends, st.booleans(), *samples)
def test_a_ray(end: Fraction, above: bool, k: int, j: int) -> None:
    x = _rational(end)
    if above:
        assert _sample(Interval(low=x), k, j) > x
    else:
        assert _sample(Interval(high=x), k, j) < x


def test_a_range_beside_zero_is_tried_on_its_short_side() -> None:
    where = Interval(fmpq(-1), fmpq(10**6))
    assert any(_sample(where, k, 0) < 0 for k in range(80))
    where = Interval(low=fmpq(-1, 1000))
    assert any(_sample(where, k, 0) < 0 for k in range(80))


def test_both_signs_and_all_sizes_come_on_the_line() -> None:
    found = [_sample(Interval(), k, 0) for k in range(60)]
    assert {x > 0 for x in found[:2]} == {True, False}
    assert min(map(abs, found)) < fmpq(1, 10**4)
    assert max(map(abs, found)) > 100
    assert len(set(found)) > 50


def test_symbols_do_not_move_together() -> None:
    pairs = {(_sample(Interval(), k, 0) > 0, _sample(Interval(), k, 1) > 0) for k in range(12)}
    assert len(pairs) == 4


def test_ends_that_stand_for_constants_give_short_points() -> None:
    low, high = fmpq(314159265358979323846, 10**20), fmpq(4)
    assert all(_sample(Interval(low, high), k, 0).q < LONG for k in range(30))


@pytest.mark.parametrize(
    ("where", "wanted", "unwanted"),
    [
        (Interval(fmpq(2), fmpq(5), False, False), {2, 5}, set()),
        (Interval(fmpq(2), fmpq(5), True, False), {5}, {2}),
        (Interval(fmpq(2), fmpq(5), False, True), {2}, {5}),
        (Interval(fmpq(-3), None, False), {-3, 0, 1}, set()),
        (Interval(), {0, 1}, set()),
    ],
)
def test_corners(where: Interval, wanted: set[int], unwanted: set[int]) -> None:
    found = {point["x"] for point in corners(["x"], {"x": where})}
    assert {fmpq(x) for x in wanted} <= found
    assert not {fmpq(x) for x in unwanted} & found


def test_corners_combine() -> None:
    box = {"x": Interval(fmpq(0), fmpq(3), False, False)}
    found = {(point["x"], point["y"]) for point in corners(["x", "y"], box)}
    assert {(fmpq(a), fmpq(b)) for a in (0, 3) for b in (0, 1)} <= found
