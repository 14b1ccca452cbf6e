"""Balls under the array API's names, and precision that is restored."""

import math
import threading
from fractions import Fraction

import mpmath
import pytest
from flint import arb, ctx, fmpq
from hangs import HANGS
from hypothesis import given
from hypothesis import strategies as st

from tresym.reals.numbers.arithmetic import (
    ball,
    ball_precision,
    balls,
    bits,
    mp_precision,
    to_mp,
)
from tresym.reals.processes import Processes

ANYWHERE = ("exp", "expm1", "sin", "cos", "tan", "atan", "sinh", "cosh", "tanh", "asinh")
POSITIVE = ("sqrt", "log", "log1p")
UNIT = ("asin", "acos", "atanh")


def _agree(value: arb, expected: mpmath.mpf, digits: int = 40) -> bool:
    near = arb(mpmath.nstr(expected, digits + 10))
    return bool(abs(value - near) < (1 + abs(near)) * arb(10) ** -digits)


def _points() -> list[tuple[str, Fraction]]:
    third, near_one = Fraction(1, 3), Fraction(10**9 - 1, 10**9)
    found = [(name, x) for name in ANYWHERE for x in (third, -7 * third, Fraction(1, 10**15))]
    found += [(name, x) for name in POSITIVE for x in (third, Fraction(10**9), Fraction(1, 10**15))]
    found += [(name, x) for name in UNIT for x in (third, -third, near_one)]
    return [*found, ("acosh", Fraction(4, 3)), ("acosh", 1 / near_one)]


def test_functions_agree_with_mpmath() -> None:
    for name, x in _points():
        with mp_precision(60) as m, ball_precision(bits(60)) as b:
            value = getattr(b, name)(ball(fmpq(x.numerator, x.denominator)))
            expected = getattr(m, name)(m.mpf(x.numerator) / x.denominator)
            assert _agree(value, expected)


@pytest.mark.parametrize(("name", "x"), [("expm1", 10**-30), ("log1p", 10**-30)])
def test_small_differences_keep_their_digits(name: str, x: float) -> None:
    with ball_precision(64) as b:
        value = getattr(b, name)(arb(x))
    assert float(value) == pytest.approx(x, rel=1e-15)
    assert value.rad() < arb(x) * arb(2) ** -50


@pytest.mark.parametrize(
    ("name", "x"), [("sqrt", -1), ("log", -1), ("asin", 2), ("acos", -2), ("acosh", 0)]
)
def test_outside_the_reals_there_is_no_number(name: str, x: int) -> None:
    assert not getattr(balls, name)(arb(x)).is_finite()


def test_pi_follows_the_precision() -> None:
    with ball_precision(300) as b:
        assert b.pi.rad() < arb(2) ** -290
        assert _agree(b.pi, mpmath.mp.make_mpf(mpmath.libmp.mpf_pi(300)), 80)


def test_the_angle_of_a_point_lies_in_its_quadrant() -> None:
    for y, x in ((1, 1), (1, -1), (-1, -1), (-1, 1)):
        assert float(balls.atan2(arb(y), arb(x))) == pytest.approx(math.atan2(y, x))


@pytest.mark.parametrize("y", [1, 0.5, fmpq(1, 2), "1"])
def test_the_angle_takes_balls_alone(y: object) -> None:
    with pytest.raises(TypeError):
        balls.atan2(y, arb(1))


@pytest.mark.parametrize("name", [*ANYWHERE, *POSITIVE, *UNIT, "acosh"])
def test_what_is_no_ball_raises(name: str) -> None:
    with pytest.raises(AttributeError):
        getattr(balls, name)(Fraction(1, 2))


def _fails_within() -> None:
    with ball_precision(1000), mp_precision(300):
        with ball_precision(70):
            assert ctx.prec == 70
        assert (ctx.prec, mpmath.mp.dps) == (1000, 300)
        raise ZeroDivisionError


def test_precision_is_restored_also_by_an_error() -> None:
    before, digits = ctx.prec, mpmath.mp.dps
    with pytest.raises(ZeroDivisionError):
        _fails_within()
    assert (ctx.prec, mpmath.mp.dps) == (before, digits)


@given(st.integers(1, 5000), st.integers(0, 64))
def test_bits_carry_the_digits_and_the_guard(digits: int, guard: int) -> None:
    assert 2 ** (bits(digits, guard) - guard) >= 10**digits


@given(st.fractions(max_denominator=10**6))
def test_rationals_enter_without_loss(x: Fraction) -> None:
    with ball_precision(20), mp_precision(30) as m:
        value = ball(fmpq(x.numerator, x.denominator))
        assert (value * x.denominator).contains(x.numerator)
        assert abs(to_mp(fmpq(x.numerator, x.denominator), m) * x.denominator - x.numerator) < 1e-20


@pytest.mark.parametrize("precise", [ball_precision, mp_precision])
def test_threads_take_turns_and_leave_the_precision_as_it_was(precise: type) -> None:
    entered, left = threading.Event(), threading.Event()

    def other() -> None:
        with precise(200):
            entered.set()
            left.wait(HANGS)

    before = ctx.prec, mpmath.mp.prec
    thread = threading.Thread(target=other)
    with precise(100):
        found = ctx.prec, mpmath.mp.prec
        thread.start()
        assert not entered.wait(0.05)
        assert (ctx.prec, mpmath.mp.prec) == found
    left.set()
    thread.join(HANGS)
    assert (ctx.prec, mpmath.mp.prec) == before


def test_a_copy_of_the_process_waits_for_no_thread_that_it_lacks() -> None:
    with Processes(1, limit=HANGS, forked=True) as pool, ball_precision(100):
        # The copy is made by the thread that leads it, while this one holds the precision.
        assert pool.submit(_thirds, 20).result() == "0.33333333333333333333"


def _thirds(digits: int) -> str:
    with ball_precision(200):
        return str((arb(1) / 3).str(digits, radius=False))
