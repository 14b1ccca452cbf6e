"""F(ε, γ) by integration: five integrals of one f, and where F is elementary."""

from typing import Any

import mpmath
import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from tresym.racket.motion import quadrature as q
from tresym.reals.numbers.arithmetic import ball_precision, mp_precision, to_mp
from tresym.reals.numbers.exact import parse_number

A, B = fmpq(2), fmpq(1, 3)
ABOVE = ["1/10", "1", "19/10", "1/1000"]
BELOW = ["-1/100", "-1/10", "-1/4"]


def numbers(mp: Any, gamma: str) -> tuple[Any, Any, Any]:
    return to_mp(A, mp), to_mp(B, mp), to_mp(parse_number(gamma), mp)


def near(ball: arb, value: Any, digits: int) -> bool:
    return bool(abs(ball - arb(mpmath.nstr(value, 40))) < arb(10) ** -digits)


@pytest.mark.parametrize("gamma", [*ABOVE, "0", *BELOW])
def test_the_parameter_and_its_tangent_and_the_rate(gamma: str) -> None:
    """tan ψ(t) = tan ψ; the rate is f dψ/dt; all derivatives by mpmath."""
    with mp_precision(40) as mp:
        a, b, g = numbers(mp, gamma)
        for psi in map(mp.mpf, ("1.1", "1.3", "1.5")):
            t = q.parameter(psi, b, g, mp)
            assert abs(q.tangent(t, b, g, mp) / mp.tan(psi) - 1) < mp.mpf(10) ** -35
            speed = mp.diff(lambda x: mp.atan(q.tangent(x, b, g, mp)), t)
            f = q.integrand(psi, a, b, g, mp)
            assert abs(q.rate(t, a, b, g, mp) / (f * speed) - 1) < mp.mpf(10) ** -15


@pytest.mark.parametrize("psi", ["0.01", "0.3", "1", "1.57"])
def test_on_the_separatrix_it_is_elementary(psi: str) -> None:
    """F(ε, 0) = asinh(√(a/(a+b)) cot ε)/√(ab) − arcsin(√(b/(a+b)) cos ε)."""
    with ball_precision(200), mp_precision(45) as mp:
        a, b, g = numbers(mp, "0")
        e = mp.mpf(psi)
        truth = mp.asinh(mp.sqrt(a / (a + b)) * mp.cot(e)) / mp.sqrt(a * b)
        truth -= mp.asin(mp.sqrt(b / (a + b)) * mp.cos(e))
        assert near(q.rigorous(arb(psi), arb(A), arb(B), arb(0)), truth, 35)
        t = q.parameter(e, b, g, mp)
        assert abs(q.substituted(t, a, b, g, mp) - truth) < mp.mpf(10) ** -30
        value, error = q.printed(e, a, b, g, mp)
        assert abs(value - truth) < mp.mpf(10) ** -20
        assert error < mp.mpf(10) ** -10


def test_where_the_body_rotates_about_its_handle_it_is_elementary() -> None:
    """γ = a: f = (1 − bs)/(a + bs), s = sin²ψ: 2/a-shaped, by the tangent of half a turn."""
    with ball_precision(200):
        a, b = arb(A), arb(B)
        root = (a * (a + b)).sqrt()

        def inverse(tangent: arb) -> arb:
            return (tangent * ((a + b) / a).sqrt()).atan() / root

        # (1 − bs)/(a + bs) = (1 + a)/(a + bs) − 1.
        e = arb("0.4")
        truth = (1 + a) * (arb.pi() / 2 / root - inverse(e.tan())) - (arb.pi() / 2 - e)
        value = q.rigorous(e, a, b, a)
        assert value.overlaps(truth)
        assert value.rad() < 1e-50
        assert not value.overlaps(truth + arb("1e-40"))


defects = st.fractions("1/10", "3/2")


@pytest.mark.slow
@given(st.sampled_from(ABOVE), defects)
def test_balls_and_mpmath_agree_above(gamma: str, e: Any) -> None:
    with ball_precision(140), mp_precision(30) as mp:
        a, b, g = numbers(mp, gamma)
        angle = mp.mpf(e.numerator) / e.denominator
        exact = fmpq(e.numerator, e.denominator)
        ball = q.rigorous(arb(exact), arb(A), arb(B), arb(parse_number(gamma)))
        value = q.substituted(q.parameter(angle, b, g, mp), a, b, g, mp)
        assert near(ball, value, 24)
        assert near(ball, q.printed(angle, a, b, g, mp)[0], 15)


@pytest.mark.parametrize("gamma", BELOW)
@pytest.mark.parametrize("chi", ["0.2", "1", "1.5707", "2", "3"])
def test_through_the_turning_point(gamma: str, chi: str) -> None:
    """cos ψ = cos ψ_min sin χ: the integral in χ, and in t, which is negative after the turn."""
    with ball_precision(160), mp_precision(34) as mp:
        a, b, g = numbers(mp, gamma)
        x = mp.mpf(chi)
        psi = mp.acos(mp.sqrt(1 + g / b) * mp.sin(x))
        t = q.parameter(psi, b, g, mp)
        t = -t if x > mp.pi / 2 else t
        value = q.substituted(t, a, b, g, mp)
        level = arb(parse_number(gamma))
        ball = q.rigorous_turned(arb(chi), arb(A), arb(B), level)
        assert near(ball, value, 25)
        if x < mp.pi / 2:
            plain = q.rigorous(arb(mpmath.nstr(psi, 34)), arb(A), arb(B), level)
            assert abs(plain - ball) < 1e-15
        beyond = q.rigorous_turned(arb.pi() - arb(chi), arb(A), arb(B), level)
        whole = 2 * q.rigorous_turned(arb.pi() / 2, arb(A), arb(B), level)
        assert (ball + beyond).overlaps(whole)
        step = arb(10) ** -15
        around = [q.rigorous_turned(arb(chi) + s * step, arb(A), arb(B), level) for s in (-1, 1)]
        slope = (around[1] - around[0]) / (2 * step)
        assert abs(slope / q.rate_turned(arb(chi), arb(A), arb(B), level) - 1) < 1e-25


def test_across_a_zero_of_the_radicand_the_ball_claims_nothing() -> None:
    """γ + b sin²ψ < 0 on a part of the way: no finite ball."""
    with ball_precision(100):
        found = q.rigorous(arb("0.1"), arb(A), arb(B), arb("-0.1"))
        assert not found.is_finite()
