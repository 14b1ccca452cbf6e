"""Taylor's theorem about one point with proved signs: what it settles, and what it does not."""

import pytest
from cases import cases
from falsehoods import is_false_at, proves

from tresym.reals.signs.taylor import sign_by_taylor

TRUE = cases(__file__, "TRUE")

FALSE = {
    # a term below the order
    "exp(x) >= 1 + 101*x/100": "x = 1/100",
    "cos(x) >= 1 - x**2/2 + x**4/23 given x >= 0": "x = 1/4",
    "sin(x) >= x - x**3/7 given x >= 0": "x = 1/2",
    "sin(x) >= x - x**3/6 + x**5/121 given x >= 0": "x = 1",
    "x*log(x/y) >= 1001*(x - y)/1000 given x > 0, y > 0": "x = 10001/10000, y = 1",
    "a + x > 0 given x > 0": "a = -2, x = 1",
    "exp(x) >= a + x": "a = 2, x = 0",
    # a term by its own expansion, of the other sign, or not on the range
    "exp(x + y) >= 1 + x + y + 201*x*y/100 given x >= 0, y >= 0": "x = 1/200, y = 1/200",
    "exp(x + y) >= 1 + x + 101*y/100 + x*y given x >= 0, y >= 0": "x = 0, y = 1/200",
    "exp(x + y) > 1 + x + y + x*y given x >= 0, y >= 0": "x = 0, y = 0",
    "(exp(x) - 1)*(exp(y) - 1) >= x*y": "x = 1, y = -1",
    "exp(x)*(exp(y) - 1 - y - y**2/2) >= 0": "x = 1, y = -1",
    "exp(x)*(sin(y) - y) >= 0 given x >= 0, y >= 0": "x = 1, y = 1",
    # the other side of the point
    "sin(x) <= x": "x = -1",
    "exp(x) < 1 + x + x**2/2 + x**3/6": "x = -1",
    "atan(x) < x given x > -1": "x = -1/2",
    # the point itself
    "exp(x) > 1 + x": "x = 0",
    "exp(x) != 1 + x given x < 1": "x = 0",
    "sin(x) < x given x >= 0": "x = 0",
    "x**2 + a**2 > 2*a*x": "x = 3, a = 3",
    "x*log(x) > x - 1 given x >= 1": "x = 1",
    "sin(x)**2 + cos(x)**2 > 1 given x > 0": "x = 1",
    # a singularity between the point and the range
    "tan(x) >= x given x >= 0": "x = 2",
    "-1 - 1/(x - 1) >= 0 given x >= 0": "x = 2",
    "1/x >= -1 given x < 1": "x = -1/2",
    "log((x - 1)**2) <= 0 given x >= 0": "x = 3",
    "cbrt(x)**2 <= 0 given x >= 0": "x = 1",
    "abs(x - 1) >= 1 - x + x**2/9 given x >= 0": "x = 1",
    # a derivative whose sign is known on the range alone, from a point that is not in it
    "x**2 - 3*x + 1 >= 0 given x >= 2": "x = 2",
    # or from one that a condition cuts off
    "2*x**3 - 3*x**2 + 1/2 > 0 given x >= 0, x**2 - x > 0": "x = 11/10",
    "x**3/3 - x + 1/2 > 0 given x >= 0, x**2 - 1 > 0": "x = 11/10",
    # a point that is not defined under the conditions
    "x**4/4 - a*x**2/2 + a**2/4 > 0": "x = 1, a = 1",
    "x**3/3 - a*x + a**2 + a + 1/10 > 0 given x > 0": "x = 1/100, a = -1/2",
    # a pole on the way from one end, whichever is named first
    "1/(3 + x) + 1/x > 0 given x > -1, x < 1": "x = -1/2",
    "1/x + 1/(3 + x) > 0 given x > -1, x < 1": "x = -1/2",
    "sqrt(a)*x >= x**2 given x > 0, a > 0": "x = 2, a = 1",
}


@pytest.mark.parametrize("claim", TRUE)
def test_what_its_terms_settle(claim: str) -> None:
    assert proves(sign_by_taylor, claim)


@pytest.mark.parametrize("claim", FALSE)
def test_near_falsehoods_are_not_proved(claim: str) -> None:
    assert is_false_at(claim, FALSE[claim])
    assert not proves(sign_by_taylor, claim)


@pytest.mark.parametrize("relation", [">", "!="])
@pytest.mark.parametrize("centre", ["0", "1", "1/2", "a"])
def test_a_point_of_contact_in_the_range_is_no_strict_example(centre: str, relation: str) -> None:
    squares = f"(x - {centre})**2*exp(x) {{}} 0 given x {{}} {centre}, a > 2"
    assert not proves(sign_by_taylor, squares.format(relation, ">="))
    assert proves(sign_by_taylor, f"exp(x) {relation} exp({centre}) given x > {centre}, a > 2")
    assert not proves(sign_by_taylor, f"exp(x) {relation} exp({centre}) given x >= {centre}, a > 2")
