"""Numbers at the border: what is taken, what is refused, and that printed balls contain."""

from fractions import Fraction

import pytest
from cases import cases
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import (
    MAX_CHARACTERS,
    InputError,
    Interval,
    as_rational,
    decimal_ball,
    fraction_text,
    parse_number,
    printed,
    rational_ends,
)


def exact_ends(x: arb) -> tuple[fmpq, fmpq]:
    """The two ends of a ball as exact rationals."""
    mid, rad = (fmpq(2) ** int(e) * m for m, e in (x.mid().man_exp(), x.rad().man_exp()))
    return mid - rad, mid + rad


@pytest.mark.parametrize(
    "text",
    cases(__file__, "what_is_read_at_once_is_what_is_read_slowly"),
)
def test_what_is_read_at_once_is_what_is_read_slowly(text: str) -> None:
    assert as_rational(text) == parse_number(text)


@pytest.mark.parametrize(
    "text", ["", "-", "--5", "-+5", "1/0", "-1/0", "1/-2/3", "٣", "²", "1e-", "e-3", "5-", "1_0"]
)
def test_what_is_no_number_is_none_at_once_either(text: str) -> None:
    with pytest.raises(InputError):
        as_rational(text)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("0.0629", Fraction(629, 10_000)),
        ("16380/1210", Fraction(1638, 121)),
        ("-1.5/0.25", Fraction(-6)),
        ("1e-400", Fraction(1, 10**400)),
        ("+.5", Fraction(1, 2)),
        ("7.", Fraction(7)),
        ("2E3", Fraction(2000)),
        (" 3 / 4 ", Fraction(3, 4)),
        ("1e" + "0" * 5000 + "2", Fraction(100)),
    ],
)
def test_numbers_are_read_exactly(text: str, value: Fraction) -> None:
    assert parse_number(text) == fmpq(value.numerator, value.denominator)


@pytest.mark.parametrize(
    "text",
    [
        "",
        " ",
        ".",
        "-",
        "1e",
        "nan",
        "inf",
        "-inf",
        "1/0",
        "0/0",
        "1/2/3",
        "1_000",
        "0x10",
        "١",
        "1,5",
        "1e10001",
        "1e-10001",
        "1e" + "9" * 5000,
        "__import__('os')",
        "sqrt(2)",
        "1" * (MAX_CHARACTERS + 1),
        "1\n2",
        "1\n",
    ],
)
def test_anything_else_is_refused_in_one_line(text: str) -> None:
    with pytest.raises(InputError) as caught:
        parse_number(text, "shape parameter a")
    message = str(caught.value)
    assert message.startswith("shape parameter a: ")
    assert "\n" not in message
    assert len(message) < 250


def test_long_numbers_pass_where_python_would_refuse_them() -> None:
    text = "7" * 9_999
    assert fraction_text(parse_number(text)) == text


@pytest.mark.parametrize("value", [0.5, True, None, 1j, b"1"])
def test_inexact_types_are_refused(value: object) -> None:
    with pytest.raises(InputError):
        as_rational(value)


@given(st.fractions())
def test_fractions_survive_text(value: Fraction) -> None:
    assert parse_number(str(value)) == as_rational(value)
    assert fraction_text(as_rational(value)) == str(value)


@pytest.mark.parametrize(
    ("text", "low", "high"),
    cases(__file__, "a_printed_number_is_half_a_unit_wide_on_both_sides"),
)
def test_a_printed_number_is_half_a_unit_wide_on_both_sides(text: str, low: str, high: str) -> None:
    interval = printed(text)
    assert interval == Interval(parse_number(low), parse_number(high))
    assert interval.ball().contains(arb(interval.low))
    assert interval.ball().contains(arb(interval.high))


@given(
    value=st.fractions(max_denominator=10**30),
    scale=st.integers(-400, 400),
    spread=st.integers(1, 300),
    digits=st.integers(1, 60),
)
def test_decimal_balls_are_rounded_outward(
    value: Fraction, scale: int, spread: int, digits: int
) -> None:
    with ball_precision(320):
        x = arb(as_rational(value)) * arb((1, scale))
        x = arb(x.mid(), abs(x.mid()) * arb((1, -spread)))
        low, high = exact_ends(x)
        mid, rad = (parse_number(part) for part in decimal_ball(x, digits))
    assert mid - rad <= low
    assert high <= mid + rad


def test_a_decimal_ball_of_zero_is_zero() -> None:
    assert decimal_ball(arb(0), 50) == ("0", "0")
    mid, rad = decimal_ball(arb(0, 1e-30), 20)
    assert mid == "0"
    assert parse_number(rad) >= parse_number("1e-30")


def test_a_decimal_ball_is_as_narrow_as_its_digits_allow() -> None:
    with ball_precision(400):
        mid, rad = decimal_ball(arb(2).sqrt(), 50)
    assert parse_number(rad) <= parse_number("1e-52")
    assert mid.startswith("1.41421356237309504880168872420969807856967187537694")


ENDS = st.one_of(st.none(), st.fractions(-9, 9, max_denominator=30))


@given(ENDS, ENDS, st.booleans(), st.booleans())
def test_the_simplest_of_an_interval(low, high, low_open, high_open):
    ends = [None if x is None else fmpq(x.numerator, x.denominator) for x in (low, high)]
    if None not in (low, high) and (low > high or (low == high and (low_open or high_open))):
        return
    where = Interval(*ends, low_open, high_open)
    x = where.simplest()
    assert where.holds(x)
    around = [fmpq(k, q) for q in range(1, int(x.q)) for k in ((x * q).floor(), (x * q).ceil())]
    assert not any(map(where.holds, around))


def test_an_interval_holds_its_closed_ends_alone():
    where = Interval(fmpq(1), fmpq(2), low_open=True)
    assert [where.holds(fmpq(x)) for x in (0, 1, 2, 3)] == [False, False, True, False]
    assert Interval().holds(fmpq(-(10**9)))
    assert where.middle == fmpq(3, 2)
    assert where.width == 1


@pytest.mark.parametrize("size", [10**8, 10**12, 10**40])
@pytest.mark.parametrize("sign", [1, -1])
def test_ends_beyond_all_memory_are_rounded_outward(size: int, sign: int) -> None:
    huge, tiny = arb((sign, size)), arb((sign, -size))
    low, high = rational_ends(huge)[:2]
    assert (low is None, high is None) == (sign < 0, sign > 0)
    assert all(end is None or abs(end) > 2**1000 for end in (low, high))
    low, high = rational_ends(tiny)[:2]
    assert 0 in (low, high)
    assert 0 < high - low < fmpq(1, 2**1000)
    assert Interval(low, high).ball().contains(tiny)


def test_ends_of_what_is_no_number() -> None:
    assert rational_ends(arb.nan()) == Interval() == rational_ends(arb(0, "inf"))


@given(st.fractions(), st.fractions(min_value=0, max_value=1))
def test_ends_contain_the_ball(middle: Fraction, radius: Fraction) -> None:
    with ball_precision(53):
        ball = arb(fmpq(middle.numerator, middle.denominator))
        ball += arb(0, 1) * arb(fmpq(radius.numerator, radius.denominator))
        inner, outer = exact_ends(ball), rational_ends(ball)
        assert outer.low <= inner[0] <= inner[1] <= outer.high
