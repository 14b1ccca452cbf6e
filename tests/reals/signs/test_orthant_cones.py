"""Polynomials on an orthant, cut into cones: what coefficients of one sign settle, and what not."""

from __future__ import annotations

import pytest
from falsehoods import is_false_at, proves, read

from tresym.reals.domain.conditions import Given
from tresym.reals.normal.field import Field
from tresym.reals.signs.orthant_cones import _excludes, open_factors, sign_on_cones

TRUE = [
    # contact where coordinates have rational ratios
    "a**2 + b**2 + c**2 >= a*b + b*c + c*a",
    "a**3 + b**3 + c**3 >= 3*a*b*c given a > 0, b > 0, c > 0",
    "(x + y)*(y + z)*(z + x) >= 8*x*y*z given x >= 0, y >= 0, z >= 0",
    "a/(b + c) + b/(c + a) + c/(a + b) >= 3/2 given a > 0, b > 0, c > 0",
    "a*(a - b)*(a - c) + b*(b - a)*(b - c) + c*(c - a)*(c - b) >= 0 given a >= 0, b >= 0, c >= 0",
    "x**4 + y**4 >= x**3*y",
    "(2*x - 3*y)**2*(x + y) >= 0 given x > 0, y > 0",
    # strict, in one variable and in several
    "x**2 + 3*y**2 > x*y given x > 0, y > 0",
    "a**2 + b**2 + c**2 + 1/10 > a*b + b*c + c*a given a >= 0, b >= 0, c >= 0",
    "x**2 - 3*x + 5/2 > 0 given x > 0",
    "x/y + y/x != 1 given x > 0, y > 0",
    "x**2 + y**2 > x*y given x > 0, y >= 0",
    # ranges of two ends, roots and exponentials
    "x*y + 1 >= x + y given x <= 1, y <= 1",
    "x*y*(1 - x)*(1 - y) >= 0 given 0 <= x <= 1, 0 <= y <= 1",
    "x + y >= 2*sqrt(x*y) given x > 0, y > 0",
    "exp(2*x) + 1 >= 2*exp(x)",
    "x**3 >= 3*x - 2 given x >= -2",
    # under conditions beyond the box
    "a**2 + b**2 + c**2 <= 2*(a*b + b*c + c*a) given a + b >= c, b + c >= a, c + a >= b, "
    "a > 0, b > 0",
    "x*y <= 1/4 given x + y <= 1, x >= 0, y >= 0",
    "a*b >= c**2 given a > c, b > c, c > 0",
    "a*b + a + b > c**2 given a > c, b > c, c > 0",
]

FALSE = {
    # zeros on a face, at a closed end, where a condition is an equality
    "x*z + y*z > 0 given x > 0, y > 0, z >= 0": "x = 1, y = 1, z = 0",
    "2 - x - y > 0 given x >= 0, x <= 1, y >= 0, y <= 1, x + y > 1": "x = 1, y = 1",
    "x - y > 0 given x >= y, x > 0, y > 0": "x = 1, y = 1",
    "100*(a**2 + b**2 + c**2) >= 101*(a*b + b*c + c*a)": "a = 1, b = 1, c = 1",
    "a**3 + b**3 + c**3 >= 3*a*b*c + 3*(a - b)**2*c given a > 0, b > 0, c > 0": (
        "a = 3/2, b = 1/2, c = 1"
    ),
    "a/(b + c) + b/(c + a) + c/(a + b) >= 1501/1000 given a > 0, b > 0, c > 0": (
        "a = 1, b = 1, c = 1"
    ),
    "x**4 + y**4 >= 2*x**3*y": "x = 11/10, y = 1",
    # between two edges with coefficients of one sign
    "100*(x - y)**2 >= x*y given x > 0, y > 0": "x = 1, y = 1",
    "x**2 + 2*y**2 >= 3*x*y given x > 0, y > 0": "x = 3/2, y = 1",
    # equality at one ray, at a face, at a corner, at an end of a range
    "a**2 + b**2 + c**2 > a*b + b*c + c*a given a > 0, b > 0, c > 0": "a = 1, b = 1, c = 1",
    "(x - y)**2*(x + y + 1) > 0 given x > 0, y > 0": "x = 1, y = 1",
    "(x - y)**2*(x + y + 1) != 0 given x > 0, y > 0": "x = 2, y = 2",
    "x**2 + y**2 > x*y given x >= 0, y >= 0": "x = 0, y = 0",
    "x + y**2 > 0 given x >= 0": "x = 0, y = 0",
    "x*y + y**2 > 0 given x > 0, y >= 0": "x = 1, y = 0",
    "x*(1 - x) > 0 given 0 < x <= 1": "x = 1",
    "x*y <= 1/5 given x + y <= 1, x >= 0, y >= 0": "x = 1/2, y = 1/2",
    "sqrt(x) > 0 given x >= 0": "x = 0",
    "exp(2*x) + 1 > 2*exp(x)": "x = 0",
    "x + y > 2*sqrt(x*y) given x > 0, y > 0": "x = 1, y = 1",
    # a half of a range that is not looked at
    "x**3 >= 3*x - 2 given x >= -3": "x = -3",
    "x*y + 1 >= x + y given x <= 1, y <= 2": "x = 0, y = 2",
    "x*y + x + y + 1 >= 0 given x > 0": "x = 1, y = -2",
    # a cone is left out only where a condition says that it may be
    "a**2 + b**2 + c**2 < 2*(a*b + b*c + c*a) given a + b >= c, b + c >= a, c + a >= b, "
    "a >= 0, b >= 0": "a = 1, b = 0, c = 1",
    "a*b > c**2 given a >= c, b >= c, c > 0": "a = 1, b = 1, c = 1",
    "x >= y given x != y, x > 0, y > 0": "x = 1, y = 2",
    "a >= b given (a - b)/(a - 2) > 0, a > 0, b > 0": "a = 1, b = 3/2",
    "a >= b given sqrt(a - b + 2) > 0, a > 0, b > 0": "a = 1, b = 2",
    "x >= y given (x - y)*(x - 2*y) > 0, x > 0, y > 0": "x = 1, y = 2",
    # the other sign everywhere
    "x + y + 1 < 0 given x > 0, y > 0": "x = 1, y = 1",
    "x*y + 1 <= 0 given x >= 0, y >= 0": "x = 1, y = 1",
    # a root that is defined, on a line alone, where the normal form has none
    "y + 1 + sqrt(x**2*y) > 0": "x = 0, y = -2",
    # more variables than are looked at
    "a + b + c + d + 2 > f given a > 0, b > 0, c > 0, d > 0, f > 0": "a=1, b=1, c=1, d=1, f=9",
}


@pytest.mark.parametrize("claim", TRUE)
def test_what_has_one_sign_on_cones(claim: str) -> None:
    assert proves(sign_on_cones, claim)


@pytest.mark.parametrize("claim", FALSE)
def test_near_falsehoods_are_not_proved(claim: str) -> None:
    assert is_false_at(claim, FALSE[claim])
    assert not proves(sign_on_cones, claim)


@pytest.mark.parametrize("ratio", [(1, 1), (2, 1), (3, 2), (5, 3), (7, 4)])
def test_contact_at_a_rational_ratio_comes_to_lie_on_an_edge(ratio: tuple[int, int]) -> None:
    p, q = ratio
    claim = f"({q}*x - {p}*y)**2*x + y*x**2 >= {{}}*x**2*y given x > 0, y > 0"
    assert proves(sign_on_cones, claim.format("1"))
    false = claim.format("1000001/1000000")
    assert is_false_at(false, f"x = {p}, y = {q}")
    assert not proves(sign_on_cones, false)


def test_contact_at_an_irrational_ratio_ends() -> None:
    claim = "(x**2 - x*y - y**2)**2*x + z*(x**4 + y**4) >= 0 given x > 0, y > 0, z >= 0"
    assert not proves(sign_on_cones, claim)


@pytest.mark.parametrize(
    ("e", "strict", "sign", "rest"),
    [
        ("x*(x - y)**2", False, 1, "1"),
        ("x*(x - y)**3", False, 1, "x - y"),
        ("-x*(x - y)*z", False, -1, "(x - y)*z"),
        ("x*(x - y)**2", True, 1, "x*(x - y)**2"),
        ("-2*x*(x - y)**4", True, -1, "x*(x - y)**2"),
    ],
)
def test_open_factors(e: str, strict: bool, sign: int, rest: str) -> None:
    """What the product is but for factors of known sign; for strict claims, all that may vanish."""
    field = Field(Given.parse("x > 0"))
    value, expected = field.normal(read(f"{e} >= 0").left, read(f"{rest} >= 0").left)
    found, left = open_factors(field, (value.num, value.den), strict)
    scale = left.leading_coefficient() / expected.num.leading_coefficient()
    assert scale != 0
    assert left - expected.num * scale == 0
    assert found * (1 if scale > 0 else -1) == sign


def test_where_a_closed_condition_fails_is_left_out_of_half_spaces_alone() -> None:
    field = Field(Given())
    line, curve = (v.num for v in field.normal(read("x - y > 0")[0], read("x*y - 1 > 0")[0]))
    assert _excludes(line, ">", True)
    assert _excludes(curve, ">", True)
    assert _excludes(line, ">=", False)
    assert not _excludes(line, ">=", True)
    assert not _excludes(curve, ">=", False)
