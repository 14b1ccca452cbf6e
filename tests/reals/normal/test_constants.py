"""A constant is zero where its norm says so: however small, no other one is."""

import pytest
from cases import cases
from flint import arb, fmpq

from tresym.reals.domain.conditions import Given
from tresym.reals.language.parsing import parse
from tresym.reals.normal.constants import (
    algebraic_zero,
    coefficients,
    is_algebraic,
    settled,
    vanishes,
)
from tresym.reals.normal.field import Field
from tresym.reals.normal.ring import Fraction
from tresym.reals.numbers.arithmetic import ball_precision

ZERO = {
    "nested cube roots": "cbrt(2 + sqrt(5)) + cbrt(2 - sqrt(5)) - 1",
    "Ramanujan": "cbrt(cbrt(2) - 1) - cbrt(1/9) + cbrt(2/9) - cbrt(4/9)",
    "Shanks": "sqrt(11 + 2*sqrt(29)) + sqrt(16 - 2*sqrt(29) + 2*sqrt(55 - 10*sqrt(29)))"
    " - sqrt(5) - sqrt(22 + 2*sqrt(5))",
    "heptagon": "cos(pi/7) - cos(2*pi/7) + cos(3*pi/7) - 1/2",
    "pentagon": "sin(pi/10) - (sqrt(5) - 1)/4",
    "seventeen": "sin(pi/17)^2 + cos(pi/17)^2 - 1",
    "roots and angles": "sqrt(2 + sqrt(2)) - 2*cos(pi/8)",
    "inside a function": "x*(sqrt(2 + sqrt(2)) - 2*cos(pi/8)) + y*(cos(pi/5) - (1 + sqrt(5))/4)",
}
NEARLY = {
    "Pell": "cbrt(2 + sqrt(5)) + cbrt(2 - sqrt(5)) - 1 + (sqrt(2) - 1)**300",
    "a rational": "sqrt(2 + sqrt(2)) - 2*cos(pi/8) - 1/10^200",
    "a sum of roots": "sqrt(1000001) + sqrt(1000025) + sqrt(1000031) + sqrt(1000084)"
    " + sqrt(1000087) + sqrt(1000134) + sqrt(1000158) + sqrt(1000182) + sqrt(1000198)"
    " - sqrt(1000002) - sqrt(1000018) - sqrt(1000042) - sqrt(1000066) - sqrt(1000113)"
    " - sqrt(1000116) - sqrt(1000169) - sqrt(1000175) - sqrt(1000199)",
    "one coefficient of two": "x*(sqrt(2 + sqrt(2)) - 2*cos(pi/8)) + y*(cos(pi/5) - 4/5)",
    "rational part left": "x*(sqrt(2 + sqrt(2)) - 2*cos(pi/8)) + y/10^99",
    "transcendental": "x*(sqrt(2 + sqrt(2)) - 2*cos(pi/8)) + y*(pi - 355/113)",
}


def normal(text: str, size: int = 48) -> tuple[Field, Fraction]:
    field = Field(Given(), size=size)
    (value,) = field.normal(parse(text))
    return field, value


@pytest.mark.parametrize("name", ZERO)
def test_zero(name: str) -> None:
    field, x = normal(ZERO[name])
    assert vanishes(field.ring, x.num)


@pytest.mark.parametrize("name", NEARLY)
def test_not_zero(name: str) -> None:
    field, x = normal(NEARLY[name])
    assert not vanishes(field.ring, x.num)


def test_what_no_ball_in_reach_can_tell_from_zero_is_not_zero() -> None:
    """Below 2^(−1200) and of degree 384: the bound on its norm is beyond all precision allowed."""
    field, x = normal("(sqrt(2) - 1)**380*(2 - sqrt(3))**380*cos(pi/97)")
    assert not algebraic_zero(field.ring, x.num)


@pytest.mark.parametrize(
    ("text", "expected"),
    cases(__file__, "algebraic"),
)
def test_algebraic(text: str, expected: bool) -> None:
    field, x = normal(text)
    (last,) = field.ring.used(x.num)
    assert is_algebraic(field.ring, last) is expected


def test_coefficients_are_of_what_is_not_algebraic() -> None:
    field, x = normal("(sqrt(2) + 3)*x^2 + cos(pi/7)*sqrt(2)*x + pi*sqrt(3) - 5")
    found = list(coefficients(field.ring, x.num))
    assert len(found) == 4
    assert all(is_algebraic(field.ring, i) for p in found for i in field.ring.used(p))


SETTLED = cases(__file__, "SETTLED")


@pytest.mark.parametrize(("left", "right"), SETTLED)
def test_settled(left: str, right: str) -> None:
    field, difference = normal(f"{left} - ({right})")
    assert settled(field, difference).num.is_zero()
    for wrong in (f"{left} - ({right}) + 1/10^40", f"{left} - ({right}) + pi/12"):
        field, difference = normal(wrong)
        assert not settled(field, difference).num.is_zero()


@pytest.mark.parametrize(
    "text",
    [
        "log(7 + 5*sqrt(2)) - 2*log(1 + sqrt(2))",
        "log(1 + sqrt(2)) + log(3)",
        "atan(1/2) + atan(1/4)",
    ],
)
def test_a_sum_that_is_not_known_stays(text: str) -> None:
    field, x = normal(text)
    assert settled(field, x).key == x.key


def convergent(digits: int) -> fmpq:
    """A rational this close to tan(π/12) = 2 − √3."""
    with ball_precision(4 * digits):
        value = 2 - arb(3).sqrt()
    return fmpq((value * 10**digits).mid().floor().unique_fmpz(), 10**digits)


def test_arc_tangents_beside_a_twelfth_are_not_it() -> None:
    """The ball singles out k; only the imaginary part says that the sum is kπ/12."""
    u = convergent(60)
    field, x = normal(f"atan({u.p}/{u.q}) - pi/12")
    assert not settled(field, x).num.is_zero()
    v = (1 - 2 * u) / (2 + u)  # atan u + atan v = atan(1/2)
    field, x = normal(f"atan({u.p}/{u.q}) + atan({v.p}/{v.q}) - pi/12")
    assert not settled(field, x).num.is_zero()


def test_several_turns_are_counted() -> None:
    """The product (1 + 2i)⁴(1 + 3i)⁴ is real and does not know how often; the ball does."""
    field, x = normal("4*atan(2) + 4*atan(3)")
    found = settled(field, x)
    assert (found - field.angles.pi(fmpq(3))).num.is_zero()
    assert not (found - field.angles.pi(fmpq(1))).num.is_zero()


def test_only_logarithms_of_functions_are_replaced() -> None:
    field, x = normal("x*(log(1 + sqrt(2)) + log(sqrt(2) - 1)) + atan(1/2) + atan(1/3)")
    kinds = {field.ring.at(i).kind for i in field.ring.used(settled(field, x, functions=True).num)}
    assert "atan" in kinds
    assert "log" not in kinds


BELOW_A_NARROW_BOUND = {
    "a product of two roots": "sqrt(2)*sqrt(1000000000063) - sqrt(3)*sqrt(666666666708)",
    "a small root beside a large one": "sqrt(2) + sqrt(10^40 + 119*10^18) - 10^20 - 2",
    "a large root beside a small one": "sqrt(10^40 + 119*10^18) + sqrt(2) - 10^20 - 2",
    "a cube root": "cbrt(10^60 + 1) - 10^20",
    "a root of a root": "sqrt(10^40 + sqrt(2)) - 10^20",
    "an angle": "10^20*cos(pi/7) - 90096886790241912624",
}
"""Not zero, and zero to anybody who forgets a conjugate, a factor, a term or a degree."""


@pytest.mark.parametrize("name", BELOW_A_NARROW_BOUND)
def test_every_conjugate_counts_in_the_bound(name: str) -> None:
    field = Field(Given(), size=48)
    _, x = field.normal(parse("sqrt(2)"), parse(BELOW_A_NARROW_BOUND[name]))
    assert not vanishes(field.ring, x.num)


LOGARITHMS = cases(__file__, "LOGARITHMS")
"""Sums that are known, each with a near falsehood."""


@pytest.mark.parametrize(("left", "right", "other"), LOGARITHMS)
def test_sums_of_logarithms_and_arc_tangents_are_known(left: str, right: str, other: str) -> None:
    for text, expected in ((right, True), (other, False)):
        field, x = normal(f"({left}) - ({text})")
        assert vanishes(field.ring, settled(field, x).num) == expected
