"""Shapes and bodies: a and b exactly from moments, the realizable ones, and what is no body."""

from fractions import Fraction
from typing import Any

import pytest
from flint import fmpq
from hypothesis import given
from hypothesis import strategies as st

from tresym.racket.body import (
    NAMED_BODIES,
    Body,
    Shape,
    as_shape,
    named_body,
    shape,
    shape_of_moments,
    shape_of_rotational_constants,
)
from tresym.reals.numbers.exact import InputError

sizes = st.fractions("1/1000", 1000, max_denominator=10**6)


def fraction(x: fmpq) -> Fraction:
    return Fraction(int(x.p), int(x.q))


@given(sizes, sizes, sizes, sizes)
def test_the_shape_is_that_of_the_moments_in_any_unit(
    first: Fraction, step: Fraction, last: Fraction, unit: Fraction
) -> None:
    one, two, three = first, first + step, first + step + last
    body = Body(one, two, three)
    a, b = map(fraction, body.shape)
    assert a * one == two - one
    assert (1 - b) * three == two
    assert body.realizable is body.shape.realizable is (three <= one + two)
    assert shape_of_moments(*(x * unit for x in (one, two, three))) == body.shape
    assert shape_of_rotational_constants(1 / one, 1 / two, 1 / three) == body.shape


@pytest.mark.parametrize(
    ("moments", "can_be"),
    [
        (("1", "2", "3"), True),  # a plate
        (("1", "2", "3.000000000000000000000000000001"), False),
        (("1", "2", "2.999999999999999999999999999999"), True),
        (("1/3", "2/3", "1"), True),
        (("1e-400", "1", "1e400"), False),
    ],
)
def test_a_plate_is_the_border_of_the_bodies(moments: tuple[str, str, str], can_be: bool) -> None:
    body = Body(*moments)
    assert body.realizable is can_be
    assert body.shape.realizable is can_be
    assert shape(*body.shape) == body.shape


@pytest.mark.parametrize(
    ("a", "b", "says"),
    [
        ("0", "1/2", "symmetric top"),
        ("1", "0", "symmetric top"),
        ("-1e-300", "1/2", "positive"),
        ("1", "1.0000000000000000000000001", "in (0, 1]"),
        ("1", "-1e-9", "in (0, 1]"),
        (0.5, "1/2", "not exact"),
        ("1", True, "truth value"),
        ("nan", "1", "not a number"),
        ("1", "inf", "not a number"),
        ("1/0", "1", "zero"),
    ],
)
def test_what_is_no_shape(a: Any, b: Any, says: str) -> None:
    with pytest.raises(InputError) as caught:
        shape(a, b)
    assert says in str(caught.value)
    assert "\n" not in str(caught.value)


def test_the_largest_b_is_a_shape() -> None:
    assert shape(1, 1) == Shape(fmpq(1), fmpq(1))
    assert not shape(1, 1).realizable


@pytest.mark.parametrize(
    ("moments", "says"),
    [
        (("3", "2", "1"), "I3 < I2 < I1"),
        (("1", "3", "2"), "I1 < I3 < I2"),
        (("2", "1", "2"), "I2 < I1 = I3"),
        (("1", "1", "2"), "I1 = I2"),
        (("1", "2", "2"), "I2 = I3"),
        (("1", "1", "1"), "I1 = I2 = I3"),
        (("0", "1", "2"), "I1: must be positive"),
        (("1", "2", "-3"), "I3: must be positive"),
        ((1, 2.0, 3), "not exact"),
    ],
)
def test_what_is_no_body(moments: tuple[Any, Any, Any], says: str) -> None:
    with pytest.raises(InputError) as caught:
        Body(*moments)
    assert says in str(caught.value)


@pytest.mark.parametrize("constants", [("3", "2", "0"), ("3", "-2", "1"), ("1", "2", "3")])
def test_rotational_constants_are_positive_and_fall(constants: tuple[str, str, str]) -> None:
    with pytest.raises(InputError):
        shape_of_rotational_constants(*constants)


def test_a_body_is_a_value() -> None:
    body = Body("0.5", 1, Fraction(3, 2))
    assert body == Body("1/2", "1", "1.5") != Body(1, 2, 3)
    assert body != body.shape
    assert hash(body) == hash(Body("1/2", "1", "1.5"))
    assert eval(repr(body), {"Body": Body}) == body
    with pytest.raises(AttributeError):
        body.I1 = fmpq(1)


@pytest.mark.parametrize("name", NAMED_BODIES)
def test_named_bodies_have_a_shape(name: str) -> None:
    found = named_body(name)
    assert shape(*found.shape) == found.shape
    with pytest.raises(InputError, match=f"did you mean {name}"):
        named_body(name.upper() + "?")


@pytest.mark.parametrize(
    "body", [Body(1, 2, 3), Body(1, 2, 3).shape, named_body(min(NAMED_BODIES))]
)
def test_a_body_has_its_b_in_it(body: Any) -> None:
    assert as_shape(body).a > 0
    with pytest.raises(InputError, match=r"^shape: a body has its b in it, .* as digits=30$"):
        as_shape(body, 30)
