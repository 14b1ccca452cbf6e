"""Polynomials at a point of every open cell: what is proved, and what each projection is for."""

import pytest
from cases import cases
from falsehoods import is_false_at, proves
from flint import fmpq

from tresym.reals.decisions.claim_parsing import read
from tresym.reals.domain.conditions import Given
from tresym.reals.language.expression import Expr
from tresym.reals.signs import polynomials
from tresym.reals.signs.interior import by_signs_of_parts
from tresym.reals.signs.polynomials import cells, sign_of_polynomial


def parts(text: str) -> tuple[Expr, str, Given]:
    """The difference, its relation to zero, and the conditions."""
    statement = read(text)
    (claim,) = statement.comparisons
    return claim.left - claim.right, claim.relation, statement.given


@pytest.mark.parametrize(
    "text",
    cases(__file__, "what_is_proved"),
)
def test_what_is_proved(text: str) -> None:
    assert sign_of_polynomial(*parts(text)) is not None


@pytest.mark.parametrize(
    "text",
    cases(__file__, "what_is_false_has_a_point_against_it"),
)
def test_what_is_false_has_a_point_against_it(text: str) -> None:
    difference, relation, given = parts(text)
    found = cells(difference, given)
    assert found is not None
    assert found.against is not None
    assert sign_of_polynomial(difference, relation, given) is None


@pytest.mark.parametrize(
    "text",
    cases(__file__, "what_is_not_proved"),
)
def test_what_is_not_proved(text: str) -> None:
    assert sign_of_polynomial(*parts(text)) is None


def test_it_gives_up_beyond_its_bound(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(polynomials, "MAX_CELLS", 0)
    assert sign_of_polynomial(*parts("x**4 + y**4 + x*y*(x - 3*y) >= -100 given x + y > 7")) is None


@pytest.mark.parametrize("least", [fmpq(0), fmpq(-1, 10**6)])
def test_a_least_value_that_is_not_positive_shows_nothing(
    least: fmpq, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(polynomials, "_least", lambda *_: least)
    (claim,) = read("(x*y - 1)**2 + (x - y)**2 > 0", "").comparisons
    assert sign_of_polynomial(claim.left, ">", Given()) is None


POSITIVE = "x >= 0, y >= 0, z >= 0"

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
    # under a condition that compares a form with a number
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
    "sqrt(2) >= sqrt(3)*x*y given x + y <= 1, x >= 0, y >= 0",
    "x + y + z <= sqrt(3) given x**2 + y**2 + z**2 <= 1",
    "x*y*z <= 1/(3*sqrt(3)) given x >= 0, y >= 0, z >= 0, x**2 + y**2 + z**2 <= 1",
    "(a + b + c + d)/4 >= (a*b*c*d)**(1/4) given a > 0, b > 0, c > 0, d > 0",
    "x + y > 2 given x > 0, y > 0, x*y > 1",
    "a/(b + c) + b/(c + a) + c/(a + b) < 2 given a > 0, b > 0, c > 0, a < b + c, b < c + a, "
    "c < a + b",
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
    "sqrt(3)/4 - 1/10**9 >= sqrt(3)*x*y given x + y <= 1, x >= 0, y >= 0": "x = 1/2, y = 1/2",
    # functions that take values on both sides
    "2*sin(x) + 1 >= 0": "x = -pi/2",
    "exp(x) >= 1": "x = -1",
    "1 >= sqrt(x)": "x = 2",
    "sqrt(x) >= x given x >= 0": "x = 2",
    # of u + v*sqrt(w), the part that is to be positive is not
    "x - 2*sqrt(y) >= 0 given x >= 0, x**2 >= y, y >= 0": "x = 1, y = 1",
    "sqrt(y) - x >= 0 given x**2 >= y, y >= 0": "x = 2, y = 1",
    "x + sqrt(y) >= 0 given y >= 0, x**2 >= y": "x = -2, y = 1",
    "x*sqrt(y) - 1 >= 0 given x**2*y >= 1, y >= 0": "x = -1, y = 1",
}


@pytest.mark.parametrize("claim", TRUE)
def test_what_one_point_of_each_cell_shows(claim: str) -> None:
    assert proves(sign_of_polynomial, claim) or proves(by_signs_of_parts, claim)


@pytest.mark.parametrize("claim", FALSE)
@pytest.mark.slow
def test_near_falsehoods_are_not_proved(claim: str) -> None:
    assert is_false_at(claim, FALSE[claim])
    assert not proves(sign_of_polynomial, claim)


@pytest.mark.parametrize("ratio", [(1, 1), (2, 1), (3, 2), (5, 3), (7, 4)])
def test_contact_at_a_rational_ratio(ratio: tuple[int, int]) -> None:
    p, q = ratio
    claim = f"({q}*x - {p}*y)**2*x + y*x**2 >= {{}}*x**2*y given x > 0, y > 0"
    assert proves(sign_of_polynomial, claim.format("1"))
    false = claim.format("1000001/1000000")
    assert is_false_at(false, f"x = {p}, y = {q}")
    assert not proves(sign_of_polynomial, false)
