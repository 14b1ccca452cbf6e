"""F(ε, γ): Carlson's form, the Gauss transformation, and the routes by integration."""

import math
from fractions import Fraction
from itertools import product

import mpmath
import numpy as np
import pytest
from cases import cases
from flint import arb, fmpq
from hypothesis import example, given
from hypothesis import strategies as st

from tresym.racket.body import named_body
from tresym.racket.motion import quadrature
from tresym.racket.motion.carlson import amplitude, by_flint, turn
from tresym.racket.motion.gauss import FLOAT_ENDING, ball_ending, ending, turn_by_gauss
from tresym.racket.motion.jacobi import functions, parameter, thetas
from tresym.reals.numbers.arithmetic import ball_precision, balls, bits, mp_precision, to_mp
from tresym.reals.numbers.exact import parse_number

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


@pytest.mark.slow
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


def ended_early(gamma: fmpq, small: arb, part: object, tiny: arb | None = None) -> tuple[arb, arb]:
    """F of the body str at ε = 0.3 with the steps ended early, and the truth by R_F and R_J.

    ``part`` of what may be left out is in the ball.
    """
    a, b, g = arb(STR.a), arb(STR.b), arb(gamma)
    tangent = arb(fmpq(3, 10)).tan()
    rest = g + (g + b) * tangent * tangent
    early = ending(small, arb(0, small**4 / 4 * part))
    if tiny is not None:
        early = early._replace(tiny=tiny)
    value = turn_by_gauss(tangent, rest, a, b, g, balls, early)
    return value, ball_turn(arb(fmpq(3, 10)), *STR, gamma, gauss=False)


def ratio_of(gamma: fmpq) -> arb:
    """2κ by x² at the start of :func:`ended_early`, and a little more."""
    b, g = arb(STR.b), arb(gamma)
    return abs(g) / ((g + b) * arb(fmpq(3, 10)).tan() ** 2) * arb("1.001")


@pytest.mark.parametrize("gamma", ["1e-3", "-1e-3", "1e-5", "-1e-5", "1e-10"])
def test_the_gauss_transformation_carries_what_it_leaves_out(gamma):
    """Ended early, the ball is wide but right; the bare value, and 1/1000 of the bound, are not."""
    level = parse_number(gamma)
    with ball_precision(400):
        small = ratio_of(level)
        value, truth = ended_early(level, small, 1)
        assert value.overlaps(truth)
        assert value.rel_accuracy_bits() < 150
        for part in (0, arb("0.001")):
            wrong, _ = ended_early(level, small, part)
            assert not wrong.overlaps(truth)


@pytest.mark.parametrize("gamma", ["1e-5", "-1e-5", "1e-10"])
def test_without_any_correction_it_carries_more(gamma):
    """What is smaller than ``tiny`` = small²/2 is taken without the terms of second order."""
    level = parse_number(gamma)
    with ball_precision(400):
        small = (2 * ratio_of(level)).sqrt()
        value, truth = ended_early(level, small, 1)
        assert value.overlaps(truth)
        assert not ended_early(level, small, arb("0.001"))[0].overlaps(truth)
        # With ``tiny`` too large the terms that are left out are not in the ball.
        wrong, _ = ended_early(level, ratio_of(level), 1, tiny=ratio_of(level))
        assert not wrong.overlaps(truth)


def test_after_steps_too_what_is_left_out_is_in_the_ball():
    for gamma in (fmpq(1), fmpq(1, 100), fmpq(-1, 1000)):
        for small in ("0.4", "1e-2", "1e-5", "1e-9"):
            with ball_precision(300):
                value, truth = ended_early(gamma, arb(small), 1)
                bare, _ = ended_early(gamma, arb(small), 0)
                assert value.overlaps(truth)
                assert abs(bare - truth) < 4 * arb(small) ** 4


EDGES = cases(__file__, "EDGES")


def test_at_the_edges_of_the_range_both_forms_overlap() -> None:
    """From the angle 1, from ψ = 0 or the turning point, and from next to it."""
    for shape, part in product(
        EDGES,
        ["1e-300", "1e-20", "1e-3", "0.5", "0.999999", "-1e-300", "-1e-3", "-0.5", "-0.999999"],
    ):
        a, b = map(parse_number, shape)
        gamma = parse_number(part) * (a if not part.startswith("-") else b)
        for precision in (70, 190, 1100):
            with ball_precision(precision):
                p, q, g = arb(a), arb(b), arb(gamma)
                # tan² ε, and γ + b sin²ε over cos²ε, exactly.
                least, whole = -gamma / (gamma + b) if gamma < 0 else fmpq(0), arb(0)
                for more in (fmpq(0), fmpq(1, 10**30), fmpq(2)):
                    square = least + more
                    rest = gamma + (gamma + b) * square
                    cosine, tangent = (1 / arb(1 + square)).sqrt(), arb(square).sqrt()
                    z = arb(rest / (1 + square))
                    fast = turn_by_gauss(tangent, arb(rest), p, q, g, balls, ball_ending())
                    at = amplitude(tangent * cosine, cosine, z, p, q, g, balls)
                    sure = turn(by_flint(at, q / p), p, q, g, balls)
                    assert fast.overlaps(sure)
                    assert fast.rel_accuracy_bits() > precision - 64
                    # On the way back the phase is what is missing to a half period.
                    back = turn_by_gauss(
                        tangent, arb(rest), p, q, g, balls, ball_ending(), back=True
                    )
                    whole = 2 * fast if more == 0 else whole
                    assert (back + fast).overlaps(whole)
                    assert back.rel_accuracy_bits() > precision - 64


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
    never = ending(arb(0), arb(0))
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
