"""F(ε, γ): Carlson's form, the Gauss transformation, and the routes by integration."""

from __future__ import annotations

import math
from fractions import Fraction

import mpmath
import numpy as np
import pytest
from flint import arb, fmpq
from hypothesis import example, given
from hypothesis import strategies as st

from tresym.arithmetic import ball_precision, balls, mp_precision, to_mp
from tresym.body import named_body
from tresym.exact import parse_number
from tresym.flip import quadrature
from tresym.flip.carlson import Amplitude, amplitude, ball_stop, by_flint, by_gauss, turn
from tresym.flip.jacobi import functions, parameter

STR = named_body("str").shape


def ball_turn(defect: arb, a: fmpq, b: fmpq, gamma: fmpq, *, gauss: bool) -> arb:
    p, q, g = arb(a), arb(b), arb(gamma)
    sine, cosine = defect.sin_cos()
    at = amplitude(sine, cosine, g + q * sine * sine, p, q, g, balls)
    found = by_gauss(at, q / p, balls, ball_stop) if gauss else by_flint(at, q / p)
    return turn(found, p, q, g, balls)


shapes = st.tuples(st.fractions("1/50", 50), st.fractions("1/100", 1))
levels = st.fractions("1/1000", "999/1000")
defects = st.fractions("1/100", "3/2")


@given(shapes, levels, defects)
@example((Fraction(1), Fraction(1)), Fraction(1, 2), Fraction(1))
def test_both_routes_to_the_integrals_overlap_flint_s_rigorous_integration(shape, part, defect):
    a, b, factor, e = (fmpq(*x.as_integer_ratio()) for x in (*shape, part, defect))
    gamma = a * factor
    with ball_precision(160):
        by_balls = ball_turn(arb(e), a, b, gamma, gauss=False)
        fast = ball_turn(arb(e), a, b, gamma, gauss=True)
        truth = quadrature.rigorous(arb(e), arb(a), arb(b), arb(gamma))
        assert by_balls.overlaps(truth)
        assert fast.overlaps(truth)
        assert by_balls.rel_accuracy_bits() > 100
        assert fast.rel_accuracy_bits() > 80


@pytest.mark.parametrize("gamma", ["1/100", "1/10000", "1/100000000", "0", "-1/10000", "-1/1000"])
def test_mpmath_quadrature_agrees_to_fifty_digits(gamma):
    level = parse_number(gamma)
    with ball_precision(220), mp_precision(62) as mp:
        ball = ball_turn(arb(fmpq(3, 10)), *STR, level, gauss=True)
        a, b, g = (to_mp(x, mp) for x in (*STR, level))
        t = quadrature.parameter(mp.mpf(3) / 10, b, g, mp)
        value = quadrature.substituted(t, a, b, g, mp)
        assert abs(ball - arb(mpmath.nstr(value, 60))) < 1e-50


def test_the_printed_integrand_loses_every_digit_across_the_near_singularity():
    """Why the substitution is there; and quad's own estimate of its error is no bound."""
    with mp_precision(50) as mp:
        a, b, g = (to_mp(x, mp) for x in (*STR, fmpq(1, 10**14)))
        start = -mp.mpf(1) / 20
        value, claimed = quadrature.printed(start, a, b, g, mp)
        t = quadrature.parameter(start, b, g, mp)
        error = abs(value - quadrature.substituted(t, a, b, g, mp))
        assert error > 5
        assert error > 5 * claimed


def test_the_radicand_given_exactly_keeps_the_digits_at_the_turning_point():
    """z = γ + b sin²ε passed as 0 gives φ_K; formed by subtraction it is a wide ball about 0."""
    gamma = fmpq(-1, 1000)
    with ball_precision(200):
        a, b, g = arb(STR.a), arb(STR.b), arb(gamma)
        sine = (-g / b).sqrt()
        cosine = (1 + g / b).sqrt()
        exact = amplitude(sine, cosine, arb(0), a, b, g, balls)
        value = turn(by_flint(exact, b / a), a, b, g, balls)
        truth = quadrature.rigorous_turned(arb.pi() / 2, a, b, g)
        assert value.overlaps(truth)
        assert value.rel_accuracy_bits() > 180
        z = g + b * sine * sine
        assert z.contains(0)


def test_the_gauss_transformation_carries_its_truncation_error():
    """Stopped a step early, the ball is wide but still right; the bare value is not."""
    with ball_precision(200):
        at = Amplitude(arb("0.8"), arb("0.6"), (1 - arb("0.32")).sqrt(), arb("0.5"))
        truth = by_flint(at, arb("0.3"))

        def early(twice: arb) -> arb | None:
            square = twice * twice / 4
            return 1 + arb(0).union(square) if square < 1e-6 else None

        rough = by_gauss(at, arb("0.3"), balls, early)
        bare = by_gauss(at, arb("0.3"), balls, lambda x: arb(1) if x * x < 4e-6 else None)
        assert rough.time.overlaps(truth.time)
        assert rough.third.overlaps(truth.third)
        assert rough.time.rel_accuracy_bits() < 60
        assert not bare.time.overlaps(truth.time)


def test_the_gauss_transformation_does_not_end_at_k_zero():
    at = Amplitude(arb(1), arb(0), arb(1), arb(0))
    with ball_precision(200), pytest.raises(ArithmeticError, match="too near a"):
        by_gauss(at, arb(1), balls, ball_stop)


def test_float64_in_few_steps_to_a_few_roundings():
    rng = np.random.default_rng(1)
    a, b = float(STR.a.p) / float(STR.a.q), float(STR.b.p) / float(STR.b.q)
    gamma = 10.0 ** rng.uniform(-8, -2, 200)
    e = rng.uniform(0.05, 1.2, 200)
    steps = []

    def four(twice):
        steps.append(0)
        return 1.0 if np.max(np.abs(twice)) < 1e-8 else None

    z = gamma + b * np.sin(e) ** 2
    at = amplitude(np.sin(e), np.cos(e), z, a, b, gamma, np)
    value = turn(by_gauss(at, b / a, np, four), a, b, gamma, np)
    assert len(steps) <= 5
    exact = fmpq(*a.as_integer_ratio()), fmpq(*b.as_integer_ratio())
    with ball_precision(120):
        for x, g, f in zip(e, gamma, value, strict=True):
            level = fmpq(*float(g).as_integer_ratio())
            truth = ball_turn(arb(float(x)), *exact, level, gauss=False)
            assert abs(truth / float(f) - 1) < 4e-15


@pytest.mark.parametrize("complement", ["0.9", "0.5", "0.3", "1e-5", "1e-150"])
@pytest.mark.parametrize("part", ["0", "0.3", "0.9999", "1"])
def test_theta_series_give_jacobi_s_functions(complement, part):
    with ball_precision(700):
        k1 = arb(complement)
        of = parameter(1 - k1, k1)
        quarter = arb.pi() / (2 * arb(1).agm(k1.sqrt()))
        at = functions(of, quarter * arb(part))
        assert (at.sn**2 + at.cn**2 - 1).contains(0)
        assert (at.dn**2 + (1 - k1) * at.sn**2 - 1).contains(0)
        assert at.sn.rad() < 1e-150
        if part != "0":
            back = by_flint(at, arb(1)).time
            assert back.overlaps(quarter * arb(part))


def test_planted_error_in_the_modulus_is_seen():
    with ball_precision(200):
        at = functions(parameter(arb("0.5"), arb("0.5")), arb(1))
        wrong = functions(parameter(arb("0.5000000001"), arb("0.4999999999")), arb(1))
        assert not at.sn.overlaps(wrong.sn)


def test_a_scalar_float_runs_the_same_code():
    a, b = 12.5, 0.06
    at = amplitude(math.sin(0.3), math.cos(0.3), 1e-3 + b * math.sin(0.3) ** 2, a, b, 1e-3, math)
    found = by_gauss(at, b / a, math, lambda x: 1.0 if abs(x) < 1e-8 else None)
    truth = mpmath.quad(
        lambda psi: quadrature.integrand(psi, a, b, 1e-3, mpmath), [0.3, mpmath.pi / 2]
    )
    assert turn(found, a, b, 1e-3, math) == pytest.approx(float(truth), rel=1e-13)
