"""F by Gauss's transformation: the integral itself, its elementary limits, and where it ends."""

import math
from typing import Any

import mpmath
import pytest
from flint import arb, ctx, fmpq
from hypothesis import assume, given
from hypothesis import strategies as st

from tresym.racket.motion import quadrature
from tresym.racket.motion.gauss import FLOAT_ENDING, Ending, ball_ending, ending, turn_by_gauss
from tresym.reals.numbers.arithmetic import ball_precision, balls, mp_precision, to_mp
from tresym.reals.numbers.exact import parse_number


def gauss(tangent: arb, a: fmpq, b: fmpq, gamma: fmpq, *, back: bool = False) -> arb:
    g, q = arb(gamma), arb(b)
    rest = g + (g + q) * tangent * tangent
    return turn_by_gauss(tangent, rest, arb(a), q, g, balls, ball_ending(), back)


shapes = st.tuples(st.fractions("1/50", 50), st.fractions("1/50", 1))


@given(shapes, st.fractions("-99/100", "99/100"), st.fractions("1/20", 3), st.booleans())
def test_it_is_the_integral_of_f(shape: Any, part: Any, more: Any, back: bool) -> None:
    """At a tan² beyond the turning point's; back, what is missing to a half period."""
    a, b, x, extra = (fmpq(*v.as_integer_ratio()) for v in (*shape, part, more))
    # Next to the separatrix the integral is smooth on this side of the far end only.
    assume(not back or abs(x) > fmpq(1, 1000))
    gamma = x * (a if x > 0 else b)
    least = -gamma / (gamma + b) if gamma < 0 else fmpq(0)
    with ball_precision(150):
        tangent = arb(least + extra).sqrt()
        found = gauss(tangent, a, b, gamma, back=back)
        p, q, g = arb(a), arb(b), arb(gamma)
        if gamma >= 0:
            truth = quadrature.rigorous(-tangent.atan() if back else tangent.atan(), p, q, g)
        else:
            chi = (tangent.atan().cos() / (1 + g / q).sqrt()).asin()
            truth = quadrature.rigorous_turned(arb.pi() - chi if back else chi, p, q, g)
        assert found.overlaps(truth)
        assert found.rel_accuracy_bits() > 60
        assert not found.overlaps(truth * (1 + arb("1e-12")) + 4 * (found.rad() + truth.rad()))


@pytest.mark.parametrize(("a", "b"), [("2", "1/3"), ("1/100", "1"), ("400", "1/1000")])
@pytest.mark.parametrize("tangent", ["1e-3", "0.3", "4"])
def test_on_the_separatrix_it_is_elementary(a: str, b: str, tangent: str) -> None:
    p, q = parse_number(a), parse_number(b)
    with ball_precision(200):
        x, y = arb(p), arb(q)
        t = arb(tangent)
        truth = ((x / (x + y)).sqrt() / t).asinh() / (x * y).sqrt()
        truth -= ((y / (x + y)).sqrt() / (1 + t * t).sqrt()).asin()
        found = gauss(t, p, q, fmpq(0))
        assert found.overlaps(truth)
        assert found.rad() < 1e-40
        assert not found.overlaps(truth + arb("1e-30"))


@pytest.mark.parametrize("gamma", ["1/10", "1/100000", "0", "-1/1000", "19/10"])
@pytest.mark.parametrize("dps", [20, 50])
def test_in_mpmath_and_in_floats_it_is_the_same_formula(gamma: str, dps: int) -> None:
    a, b, g = fmpq(2), fmpq(1, 3), parse_number(gamma)
    with mp_precision(dps) as mp:
        p, q, level = (to_mp(x, mp) for x in (a, b, g))
        t = mp.mpf(1) / 2
        rest = level + (level + q) * t * t
        value = turn_by_gauss(t, rest, p, q, level, mp, ending(mp.mpf(10) ** (-dps / 4 - 1), 0))
        truth = quadrature.substituted(
            quadrature.parameter(mp.atan(t), q, level, mp), p, q, level, mp
        )
        assert abs(value / truth - 1) < mp.mpf(10) ** (6 - dps)
        floats = [float(x) for x in (t, rest, p, q, level)]
        assert turn_by_gauss(*floats, math, FLOAT_ENDING) == pytest.approx(float(truth), rel=1e-14)


@pytest.mark.parametrize("precision", [30, 53, 100, 333, 2000])
def test_more_precision_lies_within_less(precision: int) -> None:
    for gamma in (fmpq(1, 7), fmpq(-1, 100), fmpq(1, 10**40), fmpq(3, 2)):
        with ball_precision(precision):
            rough = gauss(arb(fmpq(1, 2)), fmpq(2), fmpq(1, 3), gamma)
        with ball_precision(precision + 300):
            fine = gauss(arb(fmpq(1, 2)), fmpq(2), fmpq(1, 3), gamma)
            assert rough.contains(fine)
        assert rough.rel_accuracy_bits() > precision - 24


@pytest.mark.parametrize("gamma", ["1/10", "-1/50", "1/1000"])
@pytest.mark.parametrize("tangent", [1, 8])
def test_an_ending_that_carries_nothing_is_wrong(gamma: str, tangent: int) -> None:
    """What a coarse ending leaves out is in its ball; without it the truth is outside."""
    level = parse_number(gamma)
    with ball_precision(300):
        t, g, b = arb(tangent), arb(level), arb(fmpq(1, 3))
        numbers = t, g + (g + b) * t * t, arb(2), b, g
        truth = turn_by_gauss(*numbers, balls, ball_ending())
        for small in map(arb, ("0.4", "0.1", "1e-3")):
            carried = ending(small, arb(0, small**4 / 4))
            assert turn_by_gauss(*numbers, balls, carried).overlaps(truth)
            bare = turn_by_gauss(*numbers, balls, Ending(small, carried.tiny, arb(0)))
            assert not bare.overlaps(truth)


def test_the_ending_follows_the_working_precision() -> None:
    for precision in (16, 64, 1000):
        with ball_precision(precision):
            made = ball_ending()
            assert made.small <= 0.4
            assert made.left_out.rad() * 2 > made.small**4 / 4 > made.left_out.rad() / 2
            assert made.small**4 / 4 < arb((1, 8 - ctx.prec)) or precision == 16
            assert made == ball_ending()


def test_from_the_pole_and_at_the_end_of_the_range() -> None:
    """ε = 0 is the whole quarter; γ near a gives up rather than run on."""
    with ball_precision(120):
        whole = gauss(arb(0), fmpq(2), fmpq(1, 3), fmpq(1))
        assert whole.overlaps(quadrature.rigorous(arb(0), arb(2), arb(fmpq(1, 3)), arb(1)))
        wide = arb("0.5", "1e-4")
        found = gauss(wide, fmpq(2), fmpq(1, 3), fmpq(1))
        for tangent in ("0.49991", "0.5", "0.50009"):
            assert found.contains(gauss(arb(tangent), fmpq(2), fmpq(1, 3), fmpq(1)))
        with pytest.raises(ArithmeticError, match="too near a"):
            gauss(arb("nan"), fmpq(2), fmpq(1, 3), fmpq(1))
    assert mpmath.mp.dps == 15
