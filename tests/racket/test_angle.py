"""Exact angles: what a text names, their sines in balls, and Niven's theorem."""

from fractions import Fraction
from math import gcd
from typing import Any

import mpmath
import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from tresym.racket.angle import Angle, as_angle, parse_angle
from tresym.reals.numbers.arithmetic import ball_precision, mp_precision, to_mp
from tresym.reals.numbers.exact import InputError

HALF = fmpq(1, 2)


@pytest.mark.parametrize(
    ("text", "halves", "radians"),
    [
        ("pi", "1", "0"),
        ("+pi", "1", "0"),
        ("-pi", "-1", "0"),
        ("0*pi", "0", "0"),
        ("1e-3*pi/4", "1/4000", "0"),
        ("\t2/3 * pi/0.5", "4/3", "0"),
        ("-pi/-2", "1/2", "0"),
        ("-16380/1210", "0", "-1638/121"),
        ("-0", "0", "0"),
    ],
)
def test_what_a_text_names(text: str, halves: str, radians: str) -> None:
    found = parse_angle(text)
    assert (str(found.halves), str(found.radians)) == (halves, radians)
    assert found.is_zero is (halves == radians == "0")


@pytest.mark.parametrize(
    "text",
    ["", " ", "-", "2pi", "pi2", "pi*2", "pi+1", "PI", "𝜋", "pi/0", "pi/", "*pi", "pi//2", "1/0",
     "1/2/3*pi", "pi/nan", "inf*pi", "1e99999*pi", "0x1*pi", "pi**2", "sin(1)",
     "1 2*pi", "--1*pi"],
)  # fmt: skip
def test_what_names_no_angle(text: str) -> None:
    with pytest.raises(InputError) as caught:
        parse_angle(text, "start")
    assert str(caught.value).startswith("start: ")
    assert "\n" not in str(caught.value)


@given(st.fractions(-50, 50), st.booleans())
def test_sine_and_cosine_and_the_text(value: Fraction, turns: bool) -> None:
    exact = fmpq(*value.as_integer_ratio())
    angle = Angle(exact, fmpq(0)) if turns else Angle(fmpq(0), exact)
    assert parse_angle(str(angle)) == angle
    assert (-angle).__neg__() == angle
    with ball_precision(200), mp_precision(60) as mp:
        number = to_mp(exact, mp) * (mp.pi if turns else 1)
        for ball, truth in zip(
            (angle.ball(), *angle.sin_cos()), (number, mp.sin(number), mp.cos(number)), strict=True
        ):
            assert abs(ball - arb(mpmath.nstr(truth, 58))) < 1e-50
            assert ball.rad() < 1e-50


@pytest.mark.parametrize("halves", ["0", "7", "1000000", "-3", "1/2", "-5/2", "99999999/2"])
def test_sine_and_cosine_are_exact_at_quarter_turns(halves: str) -> None:
    sine, cosine = Angle(fmpq(*Fraction(halves).as_integer_ratio()), fmpq(0)).sin_cos()
    assert sine.is_exact()
    assert cosine.is_exact()
    assert sine * sine + cosine * cosine == 1


@pytest.mark.parametrize("q", range(1, 31))
def test_the_square_of_a_sine_is_rational_just_where_niven_says(q: int) -> None:
    """2cos 2x is an algebraic integer, so that it is rational only where it is an integer."""
    for p in range(-2 * q, 2 * q + 1):
        if gcd(p, q) > 1:
            continue
        angle = Angle(fmpq(p, q), fmpq(0))
        square = angle.rational_square()
        with ball_precision(200):
            sine, _ = angle.sin_cos()
            if square is None:
                assert (2 - 4 * sine * sine).unique_fmpz() is None
                assert not (2 - 4 * sine * sine).contains_integer()
            else:
                assert abs(sine * sine - square) < 1e-50


def test_a_rational_number_of_radians_has_no_rational_sine() -> None:
    assert Angle(fmpq(0), fmpq(1, 2)).rational_square() is None
    assert Angle(fmpq(0), fmpq(0)).rational_square() == 0


@pytest.mark.parametrize(
    ("given_", "angle"),
    [
        ("pi/2", Angle(HALF, fmpq(0))),
        ("1/2", Angle(fmpq(0), HALF)),
        (2, Angle(fmpq(0), fmpq(2))),
        (Fraction(1, 2), Angle(fmpq(0), HALF)),
        (HALF, Angle(fmpq(0), HALF)),
    ],
)
def test_numbers_are_radians(given_: Any, angle: Angle) -> None:
    assert as_angle(given_) == angle


@pytest.mark.parametrize("bad", [0.5, True, None, 1j, "1" * 10_001])
def test_what_is_not_exact_is_refused(bad: Any) -> None:
    with pytest.raises(InputError):
        as_angle(bad)
