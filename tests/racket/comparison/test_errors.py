"""Error tables: the signs, sizes and certified digits that the claims promise."""

import pytest
from flint import arb, fmpq

from tresym.racket.body import NAMED_BODIES
from tresym.racket.comparison import errors


@pytest.mark.parametrize("b", errors.WIDTHS)
@pytest.mark.parametrize("product", errors.PRODUCTS)
def test_every_entry_is_certified_and_within_its_bound(b, product):
    found = errors.errors_at(product / b, b)
    for error in found.values():
        assert error.rel_accuracy_bits() >= 13
    assert 0 < found["one line"] < 0.028
    assert abs(found["balanced"]) < 0.0065
    assert -4e-6 < found["Newton"] < 0
    if product >= 1:
        assert abs(found["third order"]) < abs(found["second order"]) < abs(found["leading"])


def test_the_slope_and_the_thresholds_of_the_standard_racket():
    shape = NAMED_BODIES["str"].shape
    slope, leading = errors.slope_at(*shape)
    assert abs(leading + arb("34.5")) < 0.1  # the paper prints −34.5 from its rounded defect
    assert -36 < slope < -35
    low, high = errors.linear_thresholds(*shape)
    assert abs(low - arb("0.0109")) < 5e-5
    assert abs(high + arb("0.0042")) < 5e-5


def test_the_slope_is_the_limit_of_the_linear_formula():
    """dε/dγ → −1/(4bε₀) as ab grows at fixed b."""
    gaps = []
    for product in (1, 4, 9):
        slope, leading = errors.slope_at(fmpq(2 * product), fmpq(1, 2))
        gaps.append(abs(slope / leading - 1))
    assert gaps[0] > gaps[1] > gaps[2]


@pytest.mark.parametrize("product", [1, 100, 10_000])
def test_the_error_of_the_slope_is_certified_however_small(product):
    """It is near 4√(ab) ε₀² times a number of size 1: 10⁻²⁷² at ab = 10⁴."""
    slope, leading, error = errors.slope_with_error(fmpq(product), fmpq(1))
    assert error.rel_accuracy_bits() >= 13
    assert slope < 0
    assert leading < 0
    assert 0 < abs(error) < abs(1 / slope)
