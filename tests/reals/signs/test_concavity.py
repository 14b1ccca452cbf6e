"""A difference concave between two ends: what its values there settle, and what they do not."""

import pytest
from cases import cases
from falsehoods import is_false_at, proves

from tresym.reals.signs.concavity import sign_by_concavity

TRUE = cases(__file__, "TRUE")

FALSE = {
    # the value at an end
    "x*(1 - x) >= 1/100 given 0 <= x <= 1": "x = 0",
    "sin(x) >= 2*x/3 given 0 <= x <= pi/2": "x = 3/2",
    "log(x) > (x - 1)/3 given 1 < x <= 20": "x = 20",
    # equality at an end that belongs to the range
    "x*(1 - x) > 0 given 0 <= x < 1": "x = 0",
    "x*(1 - x) > 0 given 0 < x <= 1": "x = 1",
    "x*(1 - x) != 0 given 0 <= x <= 1": "x = 1",
    # no end, or one alone
    "1 - x**2 >= 0 given x >= -1": "x = 2",
    "1 - x**2 >= 0 given x <= 1": "x = -2",
    "1 - x**2 >= 0": "x = 2",
    "1 - x**2 >= 0 given -1 <= x, x != 1": "x = 2",
    # convex, or linear where more is claimed
    "x**2 >= x given 0 <= x <= 1": "x = 1/2",
    "exp(x) >= 1 + (E - 1)*x given 0 <= x <= 1": "x = 1/2",
    "sin(x)**2 + cos(x)**2 > 1 given 0 < x < 1": "x = 1/2",
    "sin(x) >= 0 given 0 <= x <= 3*pi": "x = 4",
    # concave on both sides of a place between, and not across it
    "1 - 1/x**2 >= 0 given -1 <= x <= 1": "x = 1/2",
    "log(x**2) >= 0 given -1 <= x <= 1": "x = 1/2",
    "abs(x) >= 1/2 given -1 <= x <= 1": "x = 0",
    "sqrt(abs(x)) >= 1 given -1 <= x <= 1": "x = 1/4",
    "x*sign(x) >= 1 given -1 <= x <= 1": "x = 1/2",
    # more than one variable
    "exp(x*y) <= 1 + 1.72*x*y given 0 <= x <= 1, 0 <= y <= 2": "x = 1, y = 2",
    "y*sin(x) >= 2*x*y/pi given 0 <= x <= pi/2, y >= -1": "x = 1, y = -1",
    "(x - x**2)*exp(y) + y**2 > 0 given 0 <= x < 1": "x = 0, y = 0",
    "y*log(x) - x + 2 >= 0 given 0 <= x <= 1, y > 0": "x = 1/1000, y = 1",
    "3 - y/x - x >= 0 given 0 <= x <= 1, y > 0": "x = 1/1000, y = 1",
    "x*(1 - x) + y >= 0 given 0 <= x <= 1, x + y >= 0": "x = 1, y = -1/2",
    "x*(1 - x) + y >= 0 given 0 <= x <= 1": "x = 1/2, y = -1",
    "x*(y - x) >= 0 given 0 <= x, x <= 1": "x = 1, y = 0",
}


@pytest.mark.parametrize("claim", TRUE)
def test_what_is_concave_between_its_ends(claim: str) -> None:
    assert proves(sign_by_concavity, claim)


@pytest.mark.parametrize("claim", FALSE)
def test_near_falsehoods_are_not_proved(claim: str) -> None:
    assert is_false_at(claim, FALSE[claim])
    assert not proves(sign_by_concavity, claim)


def test_an_end_at_which_the_difference_is_not_defined_is_no_end() -> None:
    assert not proves(sign_by_concavity, "log(x) - x + 2 >= 0 given 0 <= x <= 1")
    assert not proves(sign_by_concavity, "3 - 1/x - x >= 0 given 0 < x <= 1")
