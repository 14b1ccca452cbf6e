"""Polynomials on boxes: strict only where no closed corner is a zero."""

import pytest
from flint import Ordering, fmpq, fmpz_mpoly_ctx

from tresym.reals.normal.box import REALS, coefficient_sign, sign_on_box
from tresym.reals.numbers.exact import Interval

X, Y = fmpz_mpoly_ctx.get(["x", "y"], Ordering.lex).gens()
UNIT = Interval(fmpq(0), fmpq(1))
INSIDE = Interval(fmpq(0), fmpq(1), True, True)
ABOVE = Interval(fmpq(0))


@pytest.mark.parametrize(
    ("p", "spans", "found"),
    [
        (1 - X * Y, [UNIT, UNIT], ">=0"),
        (1 - X * Y, [UNIT, INSIDE], "+"),
        (1 - X * Y, [UNIT, ABOVE], None),
        (X - 1, [INSIDE, REALS], "-"),
        (X + Y**2, [ABOVE, REALS], ">=0"),
        (X + Y**2 + 1, [ABOVE, REALS], "+"),
        (X + Y**3, [ABOVE, REALS], None),
        (X**2 - 2 * X + 1, [REALS, REALS], ">=0"),
        (X**2 - 2 * X * Y + Y**2 + 1, [REALS, REALS], "+"),
        (X**2 - 2 * X * Y + Y**2 - 1, [REALS, REALS], None),
        (-(X**2) + X * Y - Y**2, [REALS, REALS], "<=0"),
        (X - 1, [Interval(fmpq(1), fmpq(1)), REALS], "0"),
        (X - X, [REALS, REALS], "0"),
        (Y * X**2 + Y, [REALS, REALS], None),
        (Y * X**2, [REALS, REALS], None),
        (X**2 + Y * X + Y**2 - 1, [REALS, REALS], None),
    ],
)
def test_signs(p: object, spans: list[Interval], found: str | None) -> None:
    assert sign_on_box(p, spans) == found


def test_coefficients_alone_see_no_square() -> None:
    assert coefficient_sign(X**2 - 2 * X + 1, [REALS, REALS]) is None
    assert coefficient_sign(2 - X, [UNIT, REALS]) == "+"


def test_both_signs_beside_a_zero_and_beyond_floating_point() -> None:
    narrow = Interval(fmpq(2), fmpq(2) + fmpq(1, 10**30), True, True)
    assert sign_on_box(X - 2, [narrow, REALS]) == "+"
    assert sign_on_box(X**2 - 2 * X * Y + Y**2, [INSIDE, INSIDE]) == ">=0"
    assert sign_on_box(10**400 * X - Y, [INSIDE, INSIDE]) is None
    assert sign_on_box(10**400 * X + Y, [INSIDE, INSIDE]) == "+"
    assert sign_on_box(X**150 - Y, [Interval(fmpq(9)), INSIDE]) == "+"
