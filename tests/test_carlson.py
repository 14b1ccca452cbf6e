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

from tresym.arithmetic import ball_precision, balls, bits, mp_precision, to_mp
from tresym.body import named_body
from tresym.exact import parse_number
from tresym.flip import quadrature
from tresym.flip.carlson import amplitude, by_flint, turn
from tresym.flip.gauss import FLOAT_ENDING, Ending, ball_ending, turn_by_gauss
from tresym.flip.jacobi import functions, parameter, thetas

STR = named_body("str").shape


def ball_turn(defect: arb, a: fmpq, b: fmpq, gamma: fmpq, *, gauss: bool) -> arb:
    p, q, g = arb(a), arb(b), arb(gamma)
    if gauss:
        tangent = defect.tan()
        rest = g + (g + q) * tangent * tangent
        return turn_by_gauss(tangent, rest, p, q, g, balls, ball_ending())
    sine, cosine = defect.sin_cos()
    at = amplitude(sine, cosine, g + q * sine * sine, p, q, g, balls)
    return turn(by_flint(at, q / p), p, q, g, balls)


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


def ended_early(small: str, within) -> tuple[arb, arb]:
    """F of the body str at its turning point with the steps ended early, and the truth."""
    a, b, g = arb(STR.a), arb(STR.b), arb(fmpq(-1, 1000))
    tangent = (-g / (g + b)).sqrt()
    early = turn_by_gauss(tangent, arb(0), a, b, g, balls, Ending(arb(small), within))
    return early, turn_by_gauss(tangent, arb(0), a, b, g, balls, ball_ending())


@pytest.mark.parametrize("small", ["0.3", "1e-2", "1e-5"])
def test_the_gauss_transformation_carries_its_truncation_error(small):
    """Ended early, the ball is wide but right; the bare value, and a bound 100 times less, not."""
    with ball_precision(300):
        early, truth = ended_early(small, lambda bound: arb(0, bound))
        assert early.overlaps(truth)
        assert early.rel_accuracy_bits() < 120
        for part in (0, arb("0.01")):
            wrong, _ = ended_early(small, lambda bound, part=part: arb(0, part * bound))
            assert not wrong.overlaps(truth)


def test_ended_early_the_error_is_of_fourth_order():
    with ball_precision(300):
        errors = []
        for small in ("1e-2", "1e-5"):
            early, truth = ended_early(small, lambda bound: arb(0))
            errors.append(float(abs(early - truth).mid()))
        assert 0 < errors[1] < errors[0] ** 1.9


@pytest.mark.parametrize("precision", [16, 24, 40, 64])
def test_at_low_precision_too_the_ball_holds_the_truth(precision):
    for gamma in (fmpq(1, 100), fmpq(0), fmpq(5)):
        with ball_precision(precision):
            rough = ball_turn(arb(fmpq(3, 10)), *STR, gamma, gauss=True)
        with ball_precision(200):
            assert rough.overlaps(ball_turn(arb(fmpq(3, 10)), *STR, gamma, gauss=True))


def test_a_planted_error_in_a_step_is_seen():
    """One square root of the steps off by 1e-30: far outside the ball."""

    class Turned:
        count = 0

        def sqrt(self, x: arb) -> arb:
            self.count += 1
            return x.sqrt() * (1 + arb("1e-30")) if self.count == 9 else x.sqrt()

        def __getattr__(self, name: str):
            return getattr(balls, name)

    with ball_precision(200):
        a, b, g = arb(STR.a), arb(STR.b), arb(fmpq(1, 10_000))
        tangent = arb("0.1").tan()
        rest = g + (g + b) * tangent * tangent
        right = turn_by_gauss(tangent, rest, a, b, g, balls, ball_ending())
        assert not turn_by_gauss(tangent, rest, a, b, g, Turned(), ball_ending()).overlaps(right)


@pytest.mark.parametrize("gamma", ["1e-4", "1e-8", "0", "-1/1000"])
def test_fifty_digits_take_few_steps_and_no_excess_precision(gamma):
    level = parse_number(gamma)
    with ball_precision(bits(50, 12)):
        value = ball_turn(arb(fmpq(3, 10)), *STR, level, gauss=True)
        assert value.rel_accuracy_bits() >= bits(50, 0)


def test_at_gamma_equal_to_a_the_transformation_is_slow_but_right():
    """γ = a = b = 1: G and H do not come together, x and y do."""
    with ball_precision(200):
        one = arb(1)
        value = turn_by_gauss(one, arb(3), one, one, one, balls, ball_ending())
        truth = quadrature.rigorous(arb.pi() / 4, one, one, one)
        assert value.overlaps(truth)
        assert value.rel_accuracy_bits() > 120


def test_the_gauss_transformation_that_does_not_end_gives_up():
    never = Ending(arb(0), lambda bound: arb(0, bound))
    with ball_precision(200), pytest.raises(ArithmeticError, match="too near a"):
        turn_by_gauss(arb(1), arb(3), arb(1), arb(1), arb(1), balls, never)


def test_float64_in_few_steps_to_a_few_roundings():
    rng = np.random.default_rng(1)
    a, b = float(STR.a.p) / float(STR.a.q), float(STR.b.p) / float(STR.b.q)
    exact = fmpq(*a.as_integer_ratio()), fmpq(*b.as_integer_ratio())
    for _ in range(200):
        gamma, e = 10.0 ** rng.uniform(-8, -2), rng.uniform(0.05, 1.2)
        rest = gamma + (gamma + b) * math.tan(e) ** 2
        value = turn_by_gauss(math.tan(e), rest, a, b, gamma, math, FLOAT_ENDING)
        with ball_precision(120):
            level = fmpq(*gamma.as_integer_ratio())
            truth = ball_turn(arb(e), *exact, level, gauss=False)
            assert abs(truth / value - 1) < 1e-14


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


@pytest.mark.parametrize("argument", ["3 +/- 190", "1e6", "nan", "inf"])
def test_theta_series_end_however_wide_the_argument(argument):
    """Once they ran on: a ball of cosh that holds 0 leaves no term small beside it."""
    with ball_precision(264):
        y = arb(argument)
        sinh, cosh = y.sinh_cosh()
        if argument == "1e6":
            assert all(x.is_finite() for x in thetas(arb("1e-900000"), sinh, cosh, True))
            return
        with pytest.raises(ArithmeticError, match="too wide"):
            thetas(arb("1e-150"), sinh, cosh, True)
        with pytest.raises(ArithmeticError, match="too wide"):
            thetas(arb("0.9"), arb(0), arb(1), False)


def test_planted_error_in_the_modulus_is_seen():
    with ball_precision(200):
        at = functions(parameter(arb("0.5"), arb("0.5")), arb(1))
        wrong = functions(parameter(arb("0.5000000001"), arb("0.4999999999")), arb(1))
        assert not at.sn.overlaps(wrong.sn)
