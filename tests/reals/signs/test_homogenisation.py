"""Polynomials made homogeneous by a condition: what that settles, and what it does not."""

from __future__ import annotations

import pytest
from falsehoods import is_false_at, proves
from flint import fmpq

from tresym.reals.domain.conditions import Given
from tresym.reals.language.expression import Expr, number
from tresym.reals.language.parsing import parse
from tresym.reals.signs.homogenisation import Way, below, sign_by_homogeneity

POSITIVE = "x >= 0, y >= 0, z >= 0"

TRUE = [
    f"1 >= 3*(x*y + y*z + z*x) given x + y + z <= 1, {POSITIVE}",
    f"1 > 3*(x*y + y*z + z*x) given x + y + z < 1, {POSITIVE}",
    f"1 >= 27*x*y*z given x + y + z <= 1, {POSITIVE}",
    f"x + y + z >= 9*x*y*z given x*y + y*z + z*x <= 1/3, {POSITIVE}",
    "x**2 + y**2 + z**2 >= 1/3 given x + y + z >= 1",
    "x**2 + y**2 + z**2 > 1/3 given x + y + z > 1",
    f"x*y + y*z + z*x >= 9*x*y*z given x + y + z <= 1, {POSITIVE}",
    "x*y <= 2 given x + 2*y <= 4, x >= 0, y >= 0",
    "x*y <= 1/2 given x**2 + y**2 <= 1",
    "x**2*y <= 4/27 given x + y <= 1, x >= 0, y >= 0",
    "x**3 + y**3 >= 2 given x*y >= 1, x > 0, y > 0",
]

FALSE = {
    f"1 >= 301/100*(x*y + y*z + z*x) given x + y + z <= 1, {POSITIVE}": "x = 1/3, y = 1/3, z = 1/3",
    f"1 > 3*(x*y + y*z + z*x) given x + y + z <= 1, {POSITIVE}": "x = 1/3, y = 1/3, z = 1/3",
    f"1 >= 28*x*y*z given x + y + z <= 1, {POSITIVE}": "x = 1/3, y = 1/3, z = 1/3",
    "x**2 + y**2 + z**2 >= 334/1000 given x + y + z >= 1": "x = 1/3, y = 1/3, z = 1/3",
    "x**2 + y**2 + z**2 > 1/3 given x + y + z >= 1": "x = 1/3, y = 1/3, z = 1/3",
    "x*y <= 199/100 given x + 2*y <= 4, x >= 0, y >= 0": "x = 2, y = 1",
    "x*y < 1/2 given x**2 + y**2 <= 1": "x = sqrt(1/2), y = sqrt(1/2)",
    # the form may be negative, below −k too
    "1 >= (x - y)**2 given x - y <= 1": "x = 0, y = 5",
    "1 >= (x + y)**2 given x + y <= 1": "x = -2, y = -2",
    "1 >= x**2*y**2 given x*y <= 1": "x = 2, y = -2",
    # a term of the other sign
    "x**2 + y**2 >= x + y given x + y <= 1, x >= 0, y >= 0": "x = 1/2, y = 1/4",
    "x**2 + y**2 + 49/100 >= x + y given x + y >= 1": "x = 1/2, y = 1/2",
    "1 >= 4*x*y given x + y >= 1, x > 0, y > 0": "x = 1, y = 1",
    "x**2 + y**2 >= 1/2 given x + y <= 1, x >= 0, y >= 0": "x = 0, y = 0",
    # strict conditions that are lost where a term vanishes
    "x > x*(x + y) given x + y < 1, x >= 0, y >= 0": "x = 0, y = 0",
    "x*y > x*y*(x + y) given x + y < 1, x >= 0, y > 0": "x = 0, y = 1/2",
    # conditions that are not homogeneous up to a constant, or that have none
    "1 >= 4*x*y given x + y**2 <= 1, x >= 0, y >= 0": "x = 2/3, y = 1/2",
    "x >= x*y given x - y <= 0, x >= 0, y >= 0": "x = 1, y = 2",
    "1 >= 4*x*y given x + y != 1, x >= 0, y >= 0": "x = 1, y = 1",
    "x**2 + y**2 >= 1/2 given x + y != 1, x >= 0, y >= 0": "x = 0, y = 0",
    # what is not larger may be negative, and the function vanish
    "1 != 2*(x + y)**2 given x + y <= 1, x > 0, y > 0": "x = sqrt(1/8), y = sqrt(1/8)",
    # coefficients that are no rational numbers
    f"1 >= sqrt(10)*(x*y + y*z + z*x) given x + y + z <= 1, {POSITIVE}": "x=1/3, y=1/3, z=1/3",
    "1 != 4*x*y given x + y <= 1, x >= 0, y >= 0": "x = 1/2, y = 1/2",
}


@pytest.mark.parametrize("claim", TRUE)
def test_what_holds_of_the_homogeneous_function(claim: str) -> None:
    assert proves(sign_by_homogeneity, claim)


@pytest.mark.parametrize("claim", FALSE)
def test_near_falsehoods_are_not_proved(claim: str) -> None:
    assert is_false_at(claim, FALSE[claim])
    assert not proves(sign_by_homogeneity, claim)


def test_a_coefficient_may_be_any_constant() -> None:
    claim = "{} >= sqrt(3)*x*y given x + y <= 1, x >= 0, y >= 0"
    assert proves(sign_by_homogeneity, claim.format("sqrt(2)"))
    assert proves(sign_by_homogeneity, claim.format("sqrt(3)/4"))
    false = claim.format("sqrt(3)/4 - 1/10**9")
    assert is_false_at(false, "x = 1/2, y = 1/2")
    assert not proves(sign_by_homogeneity, false)


X, Y = parse("x"), parse("y")
QUARTER = ((number(1), fmpq(2)), (-4 * X * Y, fmpq(0)))


@pytest.mark.parametrize(
    ("parts", "form", "side", "given", "found"),
    [
        (QUARTER, X + Y, 1, "x >= 0, y >= 0, x + y <= 1", False),
        (QUARTER, X + Y, 1, "x >= 0, y >= 0, x + y < 1", True),
        # the form may be larger, or negative, or of the other side
        (QUARTER, X + Y, 1, "x >= 0, y >= 0, x + y <= 2", None),
        (QUARTER, X + Y, 1, "x + y <= 1", None),
        (QUARTER, X + Y, -1, "x >= 0, y >= 0, x + y <= 1", None),
        (QUARTER, X + Y, 1, "x >= 0, y >= 0, x + y >= 1", None),
        # they are no parts of it
        (QUARTER[:1], X + Y, 1, "x >= 0, y >= 0, x + y <= 1", None),
        # a part that is multiplied has the other sign, or is divided
        (((number(1), fmpq(0)), (-4 * X * Y, fmpq(1))), X + Y, 1, "x > 0, y > 0, x + y <= 1", None),
        (((number(1), fmpq(-1)), (-4 * X * Y, fmpq(0))), X + Y, 1, "x > 0, y > 0, x + y < 1", None),
        (
            ((number(1), fmpq(1)), (-4 * X * Y, fmpq(1))),
            *(X + Y, 1, "x > 0, y > 0, x + y <= 1", None),
        ),
        # nothing is lost where what is multiplied may be 0
        (
            ((X, fmpq(1)), (1 - X - 4 * X * Y, fmpq(0))),
            *(X + Y, 1, "x >= 0, y >= 0, x + y < 1", False),
        ),
    ],
)
def test_what_is_below_is_so(
    parts: tuple, form: Expr, side: int, given: str, found: bool | None
) -> None:
    made = below(1 - 4 * X * Y, Way(parts, form, side, ""), Given.parse(given))
    assert (None if made is None else made[1]) is found
