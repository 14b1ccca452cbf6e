"""Laws of the defect ε: where it lies, how it falls, and that every route comes to the ball."""

import math
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from flint import arb, fmpq
from hypothesis import assume, example
from hypothesis import strategies as st
from strategies import (
    DIGITS,
    bodies_and_levels,
    fraction,
    law,
    magnitudes,
    rational,
    rational_near,
    shapes,
)  # fmt: skip

from tresym import InputError, flip_defect
from tresym.racket.body import Body, Shape
from tresym.racket.flip import separatrix
from tresym.racket.flip.levels import turning_level
from tresym.racket.flip.model_selection import MODELS
from tresym.racket.flip.phase_folding import float_defect
from tresym.racket.formulas import stable
from tresym.racket.motion.quadrature import rigorous
from tresym.reals.numbers.arithmetic import ball_precision, balls, mp_precision, to_mp
from tresym.reals.numbers.exact import parse_number


def floor() -> arb:
    """2 arctan e^−π, which no rigid body reaches."""
    return 2 * (-arb.pi()).exp().atan()


@law(st.tuples(magnitudes(-9, 9), magnitudes(-9, 9), magnitudes(-9, 9)), magnitudes(-50, 50))
def test_the_unit_of_the_moments_does_not_matter(
    moments: tuple[Fraction, Fraction, Fraction], unit: Fraction
) -> None:
    assume(len(set(moments)) == 3)
    ordered = sorted(moments)
    one, two = Body(*ordered), Body(*(unit * x for x in ordered))
    assert one.shape == two.shape
    assert one.shape.a > 0
    assert 0 < one.shape.b < 1
    assert one.realizable == two.realizable == one.shape.realizable


@law(shapes(-12, 6))
@example(Shape(fmpq(1), fmpq(1)))
@example(Shape(fmpq(10) ** 12, fmpq(1, 10**12)))
def test_the_defect_on_the_separatrix_is_between_0_and_a_right_angle(shape: Shape) -> None:
    found = flip_defect(*shape, digits=DIGITS)
    assert 0 < found.defect < arb.pi() / 2
    assert found.turn > 0
    assert not found.turn > arb.pi()
    assert not found.realizable or found.defect > floor()


@law(magnitudes(-6, 12), st.fractions(Fraction(1, 1000), 1, max_denominator=1000))
@example(Fraction(10) ** 12, Fraction(1))
def test_no_rigid_body_is_nearer_to_a_perfect_flip_than_the_floor(
    a: Fraction, part: Fraction
) -> None:
    found = flip_defect(a, part / (a + 2), digits=DIGITS)
    assert found.realizable
    assert found.defect > floor()


@law(shapes(-6, 6), magnitudes(-9, 0))
@example(Shape(fmpq(1), fmpq(1)), Fraction(1, 10**9))
def test_the_defect_falls_in_a_and_in_b(shape: Shape, more: Fraction) -> None:
    a, b = shape
    factor = 1 + rational(more)
    least = flip_defect(a, b, digits=DIGITS).defect
    assert flip_defect(a * factor, b, digits=DIGITS).defect < least
    assert flip_defect(a, b / factor, digits=DIGITS).defect > least


@law(shapes(-4, 2), st.tuples(*[st.fractions(0, 1, max_denominator=10**6)] * 2))
@example(Shape(fmpq(1), fmpq(1, 3)), (Fraction(0), Fraction(1)))
@example(Shape(fmpq(2), fmpq(1)), (Fraction(0), Fraction(1, 10**6)))
@example(Shape(fmpq(2), fmpq(1)), (1 - Fraction(1, 10**6), Fraction(1)))
@pytest.mark.slow
def test_the_defect_falls_in_gamma_up_to_a_right_angle(
    shape: Shape, parts: tuple[Fraction, Fraction]
) -> None:
    a, b = shape
    low, high = sorted(parts)
    assume(low != high)
    # The level with ε = π/2; below it ε(γ) need not be monotone.
    lowest = turning_level(a, b, 20, 2)
    bottom = -b if lowest is None else rational_near(lowest.upper()) + fmpq(1, 2**200)
    assume(bottom < a)
    one, two = (bottom + (a - bottom) * rational(part) for part in (low, high))
    assert flip_defect(a, b, one, 40).defect > flip_defect(a, b, two, 40).defect


# The fixed-point map


angles = st.fractions(0, Fraction(157, 100), max_denominator=10**6)


@law(shapes(-6, 4), angles, angles)
@example(Shape(fmpq(1), fmpq(1)), Fraction(0), Fraction(157, 100))
def test_the_fixed_point_map_contracts_in_balls(shape: Shape, x: Fraction, y: Fraction) -> None:
    assume(x != y)
    a, b = arb(shape.a), arb(shape.b)
    ends = [arb(rational(end)) for end in (x, y)]
    one, two = (stable.separatrix_map(end, a, b, balls) for end in ends)
    assert abs(one - two) < b * abs(ends[0] - ends[1])
    root = separatrix.defect_over(a, b)
    assert root.overlaps(flip_defect(*shape, digits=DIGITS).defect)


@law(shapes(-6, 4), angles, angles)
@example(Shape(fmpq(1), fmpq(1)), Fraction(0), Fraction(157, 100))
def test_the_fixed_point_map_contracts_in_mpmath_and_floats(
    shape: Shape, x: Fraction, y: Fraction
) -> None:
    with mp_precision(40) as mp:
        _contracts(*(to_mp(rational(z), mp) for z in (*map(fraction, shape), x, y)), mp, "1e-38")
    _contracts(*(np.float64(float(z)) for z in (*map(fraction, shape), x, y)), np, "1e-14")


def _contracts(a: Any, b: Any, x: Any, y: Any, m: Any, rounding: str) -> None:
    one, two = (stable.separatrix_map(end, a, b, m) for end in (x, y))
    assert abs(one - two) <= b * abs(x - y) + type(a)(rounding)


@law(shapes(-6, 2))
def test_four_arithmetics_have_one_defect(shape: Shape) -> None:
    truth = flip_defect(*shape, digits=50).defect
    a, b = (float(fraction(x)) for x in shape)
    with mp_precision(60) as mp:
        exact = mp.mpf(truth.str(55, radius=False))
        p, q = to_mp(shape.a, mp), to_mp(shape.b, mp)
        assert abs(stable.separatrix_map(exact, p, q, mp) / exact - 1) < mp.mpf("1e-45")
    assert stable.separatrix_map(truth, arb(shape.a), arb(shape.b), balls).overlaps(truth)
    near = float(truth)
    assert abs(stable.separatrix_map(np.float64(near), a, b, np) / near - 1) < 1e-11


# Digits and routes


@law(bodies_and_levels(), st.integers(1, 60))
@example((Shape(fmpq(1), fmpq(1)), fmpq(-1)), 30)
@example((Shape(fmpq(1), fmpq(1)), fmpq(0)), 30)
@example((Shape(fmpq(1), fmpq(1)), fmpq(1)), 30)
def test_more_digits_lie_inside_fewer(at: tuple[Shape, fmpq], digits: int) -> None:
    shape, gamma = at
    few, many = (flip_defect(*shape, gamma, n) for n in (digits, digits + 40))
    assert few.defect.contains(many.defect)
    assert few.turn.overlaps(many.turn)
    text = few.as_json()["defect"]
    mid, rad = parse_number(text["mid"]), parse_number(text["rad"])
    # claimed digits never exceed true ones
    assert abs(arb(mid) - many.defect) <= arb(rad)
    if text.get("relative", True):
        assert rad * fmpq(10) ** digits <= abs(mid)


@law(bodies_and_levels())
@example((Shape(fmpq(1517, 121), fmpq(55, 874)), fmpq(-347861, 10**8)))
@example((Shape(fmpq(1517, 121), fmpq(55, 874)), fmpq(-55, 874)))
@example((Shape(fmpq(1, 2), fmpq(1)), fmpq(1, 2)))
def test_the_models_agree(at: tuple[Shape, fmpq]) -> None:
    shape, gamma = at
    found = []
    for model in MODELS:
        try:
            found.append(flip_defect(*shape, gamma, 8, model=model))
        except InputError:
            continue
    assert found[-1].model == "planar"
    assert all(one.defect.overlaps(found[-1].defect) for one in found)
    assert all(one.turn.overlaps(found[-1].turn) for one in found)


@law(shapes(-3, 1), st.fractions(Fraction(1, 1000), 1, max_denominator=1000))
@pytest.mark.slow
def test_the_integral_of_f_is_half_a_turn(shape: Shape, part: Fraction) -> None:
    """FLINT's rigorous integral of the printed f, which knows no elliptic function."""
    a, b = shape
    gamma = rational(part) * a / 2
    found = flip_defect(a, b, gamma, 9).defect
    with ball_precision(40):
        assert rigorous(found, arb(a), arb(b), arb(gamma)).overlaps(arb.pi())


@law(shapes(-4, 2), magnitudes(-30, 0))
def test_carlson_in_mpmath_makes_half_a_turn(shape: Shape, part: Fraction) -> None:
    """F(ε, γ) = π by mpmath's R_F and R_J, at 40 digits, for γ > 0 down to 1e-30 a."""
    gamma = rational(part) * shape.a
    truth = flip_defect(*shape, gamma, 60).defect
    assume(truth > 0)  # further on the trajectory goes through ψ = 0, where cot ψ changes sign
    with mp_precision(50) as mp:
        a, b, g = (to_mp(x, mp) for x in (*shape, gamma))
        e = mp.mpf(truth.str(55, radius=False))
        square = mp.sin(e) ** 2
        x, y, w = square, (a + b * square) / (a + b), (g + b * square) / (g + b)
        first = (1 - b) * mp.elliprf(x, y, w)
        second = b / 3 * mp.cos(e) ** 2 * mp.elliprj(x, y, w, 1)
        turned = mp.cos(e) / mp.sqrt((a + b) * (g + b)) * (first + second)
        assert abs(turned / mp.pi - 1) < mp.mpf("1e-40")


@law(bodies_and_levels(-4, 1))
# Near the turning point of a long body: cancellation once cost three digits here.
@example((Shape(fmpq(85_670), fmpq(1, 10_000)), fmpq(-111, 6_250_000_000_000_000)))
def test_the_float_route_is_right_where_it_answers(at: tuple[Shape, fmpq]) -> None:
    shape, gamma = at
    value = float_defect(*(float(fraction(x)) for x in (*shape, gamma)))
    if value is not None:
        truth = flip_defect(*shape, gamma, 20).defect
        # at the turning point ε moves by the square root of a rounding of γ
        scale = abs(arb(gamma)) + arb(shape.b) * truth.sin() ** 2
        assert abs(truth - value) < arb("1e-13") + (scale * arb("1e-15")).sqrt()


@law(shapes(-6, 4), magnitudes(-6, 0))
def test_the_float_defect_is_bounded_and_falls(shape: Shape, more: Fraction) -> None:
    """The float64 formulas that a sweep uses: 0 < ε₀ < π/2, falling in a and in b."""
    a, b = (float(fraction(x)) for x in shape)
    factor = 1 + float(more)
    shapes_ = np.array([[a, b], [a * factor, b], [a, b / factor]]).T
    k, r = np.sqrt(shapes_[0] * shapes_[1]), np.sqrt(shapes_[1] / shapes_[0])
    phase = np.full(3, math.pi)
    for _ in range(60):
        phase = stable.phase_map(phase, k, r, np)
    here, more_a, less_b = stable.defect_at(phase, k, r, np)
    assert 0 < here < math.pi / 2
    assert more_a <= here * (1 + 1e-10)
    assert less_b >= here * (1 - 1e-10)
