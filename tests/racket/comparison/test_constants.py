"""The constants K and K₂: no shape goes beyond them, the corners come within one per cent."""

from fractions import Fraction
from itertools import pairwise

import mpmath
import pytest
from flint import arb, fmpq

from tresym.racket.comparison.constants import CONSTANTS, Constants, excesses
from tresym.racket.result import proves
from tresym.reals.numbers.arithmetic import mp_precision, to_mp
from tresym.reals.numbers.exact import parse_number


def by_mpmath(a: fmpq, b: fmpq) -> tuple[mpmath.mpf, mpmath.mpf]:
    """Both ratios from the phase equation, by mpmath alone."""
    with mp_precision(80) as mp:
        p, q = to_mp(a, mp), to_mp(b, mp)
        k, r = mp.sqrt(p * q), mp.sqrt(q / p)
        phase = mp.findroot(lambda x: x - mp.pi - mp.atan(r * mp.tanh(k * x)), mp.mpf(4))
        exact = mp.atan(1 / (mp.sqrt(1 + r * r) * mp.sinh(k * phase)))
        leading = 2 / mp.sqrt(1 + r * r) * mp.exp(-k * (mp.pi + mp.asin(r / mp.sqrt(1 + r * r))))
        first = (exact / leading - 1) / leading**2
        return first, (first - (6 * q - 1 + 3 * q / p) / 12) / leading**2


@pytest.mark.parametrize(
    ("a", "b"),
    [("1/100", "1"), ("1/100", "1/1000"), ("1", "1/6"), ("12.5", "0.06"), ("10", "1"), ("50", "1")],
)
def test_the_ratios_are_those_of_the_exact_root(a: str, b: str) -> None:
    shape = parse_number(a), parse_number(b)
    found = excesses(*shape, 20)
    for ball, truth in zip(found, by_mpmath(*shape), strict=True):
        assert proves(ball, 20)
        assert abs(ball / arb(mpmath.nstr(truth, 30)) - 1) < 1e-14
        assert not ball.overlaps(arb(mpmath.nstr(truth, 30)) * (1 + arb("1e-9")))


def worst(row: Constants, ratio: int) -> arb:
    return excesses(parse_number(row.least), fmpq(1))[ratio]


@pytest.mark.parametrize("row", CONSTANTS, ids=lambda row: row.least)
def test_the_corner_is_within_one_per_cent_and_not_beyond(row: Constants) -> None:
    for ratio, constant in enumerate((row.first, row.second)):
        found, stated = worst(row, ratio), parse_number(constant)
        assert abs(found) < arb(stated)
        assert abs(found) > arb(stated) * arb("0.99")


@pytest.mark.parametrize("row", CONSTANTS, ids=lambda row: row.least)
def test_no_shape_of_a_grid_goes_beyond(row: Constants) -> None:
    for more in (1, fmpq(3, 2), 5, 40):
        for b in ("1", "0.97", "0.6", "1/6", "0.01"):
            a = parse_number(row.least) * more
            found = excesses(a, parse_number(b), 3)
            for ratio, constant in zip(found, (row.first, row.second), strict=True):
                assert abs(ratio) < arb(parse_number(constant))


def test_a_row_does_not_serve_the_row_above() -> None:
    """The constants of a larger a₀ are too small at the corner of the one before."""
    for before, row in pairwise(CONSTANTS):
        assert parse_number(before.least) < parse_number(row.least)
        assert worst(before, 0) > arb(parse_number(row.first))
        assert worst(before, 1) > arb(parse_number(row.second))


def test_far_out_they_are_the_coefficients_of_the_expansion() -> None:
    first, second = excesses(fmpq(10**4), fmpq(1))
    assert abs(first - arb(fmpq(5, 12))) < 1e-4
    assert abs(second - arb(fmpq(31, 80))) < 1e-3
    assert Fraction(5, 12) < Fraction(CONSTANTS[-1].first)
    assert Fraction(31, 80) < Fraction(CONSTANTS[-1].second)
