"""Canonical factors multiply to what they are factors of, and the same one has always one form."""

import pytest
from cases import cases
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from tresym.reals.domain.conditions import Given
from tresym.reals.language.parsing import parse
from tresym.reals.normal.factors import MAX_FACTOR_TERMS, factor_fraction, factor_polynomial
from tresym.reals.normal.field import Field
from tresym.reals.normal.ring import Fraction, UndefinedError
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.factoring import TooLargeError

POSITIVE = "x > 0, y > 0"


def normal(text: str, under: str = POSITIVE) -> tuple[Field, Fraction]:
    field = Field(Given.parse(under))
    (value,) = field.normal(parse(text))
    return field, value


PARTS = cases(__file__, "PARTS")
PARTS += ["log(x) + 1", "2 - sqrt(2)", "x + y + 2*sqrt(x*y)", "sqrt(2) + sqrt(3)"]
parts = st.sampled_from(PARTS)


@given(st.lists(st.tuples(parts, st.integers(-2, 2)), min_size=1, max_size=4))
def test_the_product_of_the_factors(chosen: list[tuple[str, int]]) -> None:
    text = "*".join(f"({part})**({k})" for part, k in chosen)
    field, x = normal(text)
    sign, factors = factor_fraction(field.ring, x)
    with ball_precision(200):
        at = {"x": arb(fmpq(5, 7)), "y": arb(fmpq(13, 4))}
        total = arb(sign)
        for part, k in factors.values():
            assert k.q == 1
            total *= field.ring.ball(part, at) ** int(k.p)
        assert total.overlaps(field.ring.ball(x, at))
        assert total.rel_accuracy_bits() > 100


SAME = cases(__file__, "SAME")


@pytest.mark.parametrize(("left", "right"), SAME)
def test_one_form(left: str, right: str) -> None:
    field = Field(Given.parse(POSITIVE))
    x, y = field.normal(parse(left), parse(right))
    assert factor_fraction(field.ring, x / y) == (1, {})
    assert factor_fraction(field.ring, x / (y * field.ring.fraction(2)))[1] != {}
    one, other = factor_fraction(field.ring, x), factor_fraction(field.ring, y)
    assert one[0] == other[0]
    assert {k: v[1] for k, v in one[1].items()} == {k: v[1] for k, v in other[1].items()}


def test_zero_has_no_factors() -> None:
    field, x = normal("x - x")
    with pytest.raises(UndefinedError):
        factor_fraction(field.ring, x)


def test_bounds() -> None:
    field = Field(Given())
    x, y = (field.ring.variable(field.ring.symbol(name)) for name in "xy")
    p = sum((x**k * y ** (k * k % 97) for k in range(MAX_FACTOR_TERMS + 2)), field.ring.one_poly)
    with pytest.raises(TooLargeError):
        factor_polynomial(field.ring, p)


NESTED = cases(__file__, "NESTED")


@pytest.mark.parametrize(("left", "right", "wrong"), NESTED)
def test_nested_roots(left: str, right: str, wrong: str) -> None:
    field = Field(Given.parse(POSITIVE))
    x, y = field.normal(parse(left), parse(right))
    assert (x - y).num.is_zero()
    x, y = field.normal(parse(left), parse(wrong))
    assert not (x - y).num.is_zero()


SIGNS = [
    # sign of what, is what, and is not what
    ("(x - y)^3*(x + 2)^2", "sign(x - y)", "1", ""),
    ("(x^2 + 1)/(y - x)", "sign(y - x)", "1", ""),
    ("atan(x*y)", "sign(x)*sign(y)", "sign(x)", ""),
    ("log(x)", "sign(x - 1)", "sign(x)", ""),
    ("log(x/y)", "sign(x - y)", "1", POSITIVE),
    ("pi/2*sign(y) - atan(x)/2", "sign(y)", "sign(x)", ""),
    ("sqrt(x) - y", "sign(x - y^2)", "sign(x - y)", POSITIVE),
    ("1 - sqrt(x)", "sign(1 - x)", "sign(x - 1)", ""),
    ("exp(x) - 1", "sign(exp(x) - 1)", "1", ""),
    ("-5*x", "-sign(x)", "sign(x)", ""),
]


@pytest.mark.parametrize(("text", "right", "wrong", "under"), SIGNS)
def test_sign_of_a_product(text: str, right: str, wrong: str, under: str) -> None:
    field = Field(Given.parse(under))
    for other, expected in ((right, True), (wrong, False)):
        x, y = field.normal(parse(f"sign({text})"), parse(other))
        assert (x - y).num.is_zero() is expected


LEARNT = [
    # a condition, and what follows from it through inverse functions, roots and products
    ("atan(x*(y - 3)) > 0, x > 0", "y - 3", 1),
    ("log(x/y) > 0, y > 0, x > 0", "x - y", 1),
    ("atan(x - y)*(x - y)^2 > 0", "x - y", 1),
    ("log(x) - log(y) < 0", "x - y", -1),
    ("sqrt(x) > 1 + y^2", "x - 1", 1),
    ("log(1 - x) > 0", "x", -1),
    # and what does not
    ("(x + abs(x))^2*y >= 0", "y", 0),
    ("atan(x + abs(x))^2*y >= 0", "y", 0),
    ("log(1 + x + abs(x))^2*y >= 0", "y", 0),
    ("(pi/2 - atan(x) - atan(1/x))^2*y >= 0", "y", 0),
    ("atan(x*(y - 3)) > 0", "y - 3", 0),
    ("atan(x*(y - 3))^2 > 0, x > 0", "y - 3", 0),
    ("pi/2 - 3*atan(x - y) > 0", "x - y", 0),
    ("log(x/y)*z > 0, y > 0, x > 0", "x - y", 0),
    # a factor that vanishes on a region: nothing follows of the other
    ("(x + abs(x))*y >= 0", "y", 0),
    ("atan(x + abs(x))*y >= 0", "y", 0),
    ("(pi/2 - atan(x) - atan(1/x))*y >= 0", "y", 0),
    ("(pi/2 - atan(x) - atan(1/x))*y > 0", "z - y", 0),
]


@pytest.mark.parametrize(("under", "text", "expected"), LEARNT)
def test_what_a_condition_tells(under: str, text: str, expected: int) -> None:
    field, x = normal(text, under)
    assert field.signs.sign(x.num) == expected
