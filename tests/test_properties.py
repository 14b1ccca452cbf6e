"""Laws: what holds of every body and every start, whatever the numbers.

Each law takes as many examples as the profile says (``HYPOTHESIS_PROFILE``: dev 50, ci 200, deep
10 000). A deep run in pieces that can be resumed sets ``TRESYM_CHUNK`` to 0, 1, 2, …: each number
seeds examples of its own, so fifty chunks of the ci profile are 10 000 examples of each law.
"""

from __future__ import annotations

import functools
import math
import os
from collections.abc import Callable
from contextlib import suppress
from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
from flint import arb, ctx, fmpq
from hypothesis import assume, example, given, seed
from hypothesis import strategies as st

from tresym import InputError, flip_angle, flip_defect
from tresym.arithmetic import ball_precision, balls, mp_precision, to_mp
from tresym.body import Body, Shape
from tresym.exact import fraction_text, parse_number
from tresym.flip import defect as defects
from tresym.flip import separatrix
from tresym.flip.flipmap import arrivals, flip_map, flip_uncertainty
from tresym.flip.ladder import RUNGS
from tresym.flip.levels import turning_level
from tresym.flip.result import Journey, proves
from tresym.formulas import printed, stable

DIGITS = 30
WORK = 400
"""Bits in which the laws are checked."""

# Beyond this √(ab)·2π a start of sixty digits says little about its end.
TAME = 3


def law(*strategies: Any, **named: Any) -> Callable[[Any], Any]:
    """``given``, checked in balls of ``WORK`` bits, with the seed of the chunk if one is set."""
    chunk = os.environ.get("TRESYM_CHUNK")

    def wrap(test: Any) -> Any:
        @functools.wraps(test)
        def in_balls(*values: Any, **more: Any) -> None:
            with ball_precision(WORK):
                test(*values, **more)

        checked = given(*strategies, **named)(in_balls)
        return seed(int(chunk))(checked) if chunk else checked

    return wrap


def fraction(x: fmpq) -> Fraction:
    return Fraction(int(x.p), int(x.q))


def magnitudes(low: int, high: int) -> st.SearchStrategy[Fraction]:
    """Positive rationals, even in the logarithm, of few digits."""
    return st.builds(
        lambda digits, power: Fraction(digits) * Fraction(10) ** (power - 3),
        st.integers(1000, 9999),
        st.integers(low, high - 1),
    )


shares = st.one_of(
    st.sampled_from([Fraction(1), Fraction(1, 2), Fraction(999_999, 1_000_000)]),
    st.fractions(Fraction(1, 1000), 1, max_denominator=10**6),
    magnitudes(-12, 0),
)


@st.composite
def shapes(draw: st.DrawFn, low: int = -6, high: int = 4) -> Shape:
    """Shapes even in log(ab), with b from 1e-12 to 1."""
    b, product = draw(shares), draw(magnitudes(low, high))
    a = product / b
    return Shape(fmpq(a.numerator, a.denominator), fmpq(b.numerator, b.denominator))


def tame_shapes() -> st.SearchStrategy[Shape]:
    """Shapes whose flow keeps digits: b from 1e-3 on and √(ab) below 3."""
    b = st.fractions(Fraction(1, 1000), Fraction(99, 100), max_denominator=10**4)
    return st.builds(
        lambda b, ab: Shape(_q(ab / b), _q(b)),
        b,
        st.fractions(Fraction(1, 1000), TAME**2, max_denominator=10**4),
    )


def _q(x: Fraction | int) -> fmpq:
    return fmpq(x.numerator, x.denominator)


@st.composite
def levels(draw: st.DrawFn, a: fmpq, b: fmpq) -> fmpq:
    """γ from −b to a: the ends, the separatrix, log-near each of the three, and between."""
    kind = draw(st.sampled_from(["0", "near 0", "near -b", "near a", "between", "-b", "a"]))
    if kind in ("0", "-b", "a"):
        return {"0": fmpq(0), "-b": -b, "a": a}[kind]
    small = _q(draw(magnitudes(-30, -1)))
    side = draw(st.sampled_from([-1, 1]))
    if kind == "near 0":
        return small * (a if side > 0 else -b)
    if kind == "between":
        part = _q(draw(st.fractions(0, 1, max_denominator=1000)))
        return part * (a if side > 0 else -b)
    return a * (1 - small) if kind == "near a" else -b * (1 - small)


@st.composite
def bodies_and_levels(draw: st.DrawFn, low: int = -6, high: int = 2) -> tuple[Shape, fmpq]:
    shape = draw(shapes(low, high))
    return shape, draw(levels(shape.a, shape.b))


Start = tuple[Shape, Fraction, Fraction]


@st.composite
def starts(draw: st.DrawFn) -> Start:
    """A tame shape, ψ₀ and a rate that such a body can have there, also near the saddle."""
    shape = draw(tame_shapes())
    psi = draw(st.one_of(
        st.fractions(-4, 4, max_denominator=10**4),
        magnitudes(-20, -1),
        magnitudes(-20, -1).map(lambda x: -x),
    ))  # fmt: skip
    a, b = float(fraction(shape.a)), float(fraction(shape.b))
    sine2 = math.sin(psi) ** 2
    largest = Fraction(int((a + b * sine2) / (1 - b * sine2) * 10**6), 10**6)
    part = draw(st.one_of(
        st.fractions(Fraction(-99, 100), Fraction(99, 100), max_denominator=1000),
        magnitudes(-20, -1),
    ))  # fmt: skip
    return shape, psi, largest * part


turns = st.fractions(Fraction(1, 100), Fraction(63, 10), max_denominator=1000)


def fly(start: Start, precession: Fraction | str = "2*pi", digits: int = DIGITS) -> Journey:
    shape, psi, rate = start
    return flip_angle(*shape, psi, rate, digits, precession=precession)


def same(x: arb, y: arb, digits: int = DIGITS - 2) -> bool:
    """Two balls overlap, and are narrow enough that this says something."""
    with ball_precision(WORK):
        small = arb(fmpq(1, 10) ** digits) * (1 + abs(x))
        return bool(x.overlaps(y) and x.rad() < small and y.rad() < small)


# Symmetries of the flow


@law(starts(), turns)
def test_half_a_turn_of_psi_changes_nothing(start: Start, phi: Fraction) -> None:
    shape, psi, rate = start
    one = fly(start, phi)
    # π is not rational: a start 22/7 − π away would be another one, so the multiple is exact.
    two = flip_angle(*shape, "pi/3", rate / 4, DIGITS, precession=phi)
    three = flip_angle(*shape, "4*pi/3", rate / 4, DIGITS, precession=phi)
    assert same(two.turn, three.turn)
    assert same(two.theta, three.theta)
    assert one.gamma == fly((shape, psi, rate), phi).gamma or psi != 0


@law(starts(), turns)
def test_the_map_is_symmetric_about_the_unstable_points(start: Start, phi: Fraction) -> None:
    shape, psi, rate = start
    one, two = fly(start, phi), fly((shape, -psi, -rate), phi)
    assert same(one.turn, -two.turn)
    assert same(one.theta, arb.pi() - two.theta)


@law(starts(), turns)
def test_time_reversal(start: Start, phi: Fraction) -> None:
    shape, psi, rate = start
    one, two = fly(start, phi), fly((shape, psi, -rate), -phi)
    assert same(one.turn, two.turn)
    assert same(one.theta, arb.pi() - two.theta)


@law(starts(), turns)
def test_psi_reversed_with_the_direction_of_phi(start: Start, phi: Fraction) -> None:
    shape, psi, rate = start
    one, two = fly(start, phi), fly((shape, -psi, rate), -phi)
    assert same(one.turn, -two.turn)
    assert same(one.theta, two.theta)


@law(st.tuples(magnitudes(-9, 9), magnitudes(-9, 9), magnitudes(-9, 9)), magnitudes(-50, 50))
def test_the_unit_of_the_moments_does_not_matter(
    moments: tuple[Fraction, Fraction, Fraction], unit: Fraction
) -> None:
    assume(len(set(moments)) == 3)
    ordered = sorted(moments)
    one, two = Body(*ordered), Body(*(unit * x for x in ordered))
    assert one.shape == two.shape
    assert one.realizable == two.realizable == one.shape.realizable


@law(tame_shapes(), st.fractions(Fraction(1, 100), Fraction(95, 100), max_denominator=1000))
def test_the_defect_from_either_end_of_the_trajectory(shape: Shape, part: Fraction) -> None:
    a, b = shape
    rate = fraction((a + b) / (1 - b)) * part
    forth, back = (flip_angle(a, b, "pi/2", rate, DIGITS, precession=phi) for phi in ("pi", "-pi"))
    assert isinstance(forth.gamma, fmpq)
    assert same(forth.turn, -back.turn)
    assert same(arb.pi() / 2 - forth.turn, flip_defect(a, b, forth.gamma, DIGITS).defect)


# Laws of the flow


def rational_near(x: arb) -> fmpq:
    """A rational number within 10^−75 of the middle of a ball."""
    return fmpq((x * arb(2) ** 260).mid().floor().unique_fmpz(), 2**260)


@law(starts(), turns, turns)
def test_the_flow_composes(start: Start, first: Fraction, second: Fraction) -> None:
    shape = start[0]
    whole = fly(start, first + second, 60)
    half = fly(start, first, 75)
    there = flip_angle(
        *shape, rational_near(half.psi), digits=60, theta0=rational_near(half.theta),
        precession=second,
    )  # fmt: skip
    assert abs(half.turn + there.turn - whole.turn) < arb("1e-40")
    assert abs(there.theta - whole.theta) < arb("1e-40")


@law(starts(), turns)
def test_there_and_back_again(start: Start, phi: Fraction) -> None:
    there = fly(start, phi, 75)
    back = flip_angle(
        *start[0], rational_near(there.psi), digits=60, theta0=rational_near(there.theta),
        precession=-phi,
    )  # fmt: skip
    assert abs(back.turn + there.turn) < arb("1e-40")


@law(starts(), turns)
def test_gamma_is_conserved_and_the_bounds_hold(start: Start, phi: Fraction) -> None:
    shape, _, rate = start
    end = fly(start, phi)
    a, b = arb(shape.a), arb(shape.b)
    gamma = arb(end.gamma)
    now = printed.depth(end.theta, end.psi, a, b, balls)
    assert now.overlaps(gamma)
    assert now.rad() < arb("1e-25") * (1 + a)
    assert not gamma < -b
    assert not gamma > a
    sine, cosine = end.psi.sin(), end.theta.cos()
    slack = arb("1e-24")
    # ψ and θ bounds, squared (eq_borne_psi, eq_borne_theta)
    assert not cosine**2 * (a + b) > gamma + b + slack * (1 + a)
    if gamma > 0:
        assert not cosine**2 * a < gamma - slack * (1 + a)
        # no crossing of θ = π/2
        assert not cosine * (1 if rate > 0 else -1) < -slack
    elif gamma < 0:
        assert not b * sine**2 < -gamma - slack
        assert abs(end.turn) < arb.pi()


@law(starts(), turns)
def test_the_float_map_is_as_good_as_it_says(start: Start, phi: Fraction) -> None:
    shape, psi, rate = start
    numbers = [float(fraction(x)) for x in shape] + [float(x) for x in (psi, rate, phi)]
    exact = [Fraction(x) for x in numbers]
    try:
        truth = flip_angle(*exact[:4], 20, precession=exact[4])
    except InputError:
        return
    a, b, *rest = numbers
    found = flip_map(a, b, *rest)
    error = float(abs(truth.turn - float(found)))
    rounding = 1e-14 * min(1, abs(rest[0]))
    assert error <= 4 * float(flip_uncertainty(a, b, *rest)) + rounding


@law(tame_shapes(), st.integers(0, 2**32 - 1))
def test_many_floats_compose_and_keep_gamma(shape: Shape, chunk: int) -> None:
    a, b = (float(fraction(x)) for x in shape)
    random = np.random.default_rng(chunk)
    psi = random.uniform(-4, 4, 60)
    largest = (a + b * np.sin(psi) ** 2) / (1 - b * np.sin(psi) ** 2)
    rate, phi = largest * random.uniform(-0.99, 0.99, 60), random.uniform(0, 6, 60)
    whole, half = arrivals(a, b, psi, rate, phi), arrivals(a, b, psi, rate, phi / 3)
    end = psi + whole.turn
    gamma = a - (1 - whole.handle**2) * (a + b * np.sin(end) ** 2)
    start = rate * (1 - b * np.sin(psi) ** 2) / (a + b * np.sin(psi) ** 2)
    before = a - (1 - start**2) * (a + b * np.sin(psi) ** 2)
    doubt = flip_uncertainty(a, b, psi, rate, phi)
    slope = 1 + a + 2 * b
    assert np.all(np.abs(gamma - before) <= 1e-11 * slope + slope * doubt)
    middle = psi + half.turn
    speed = half.handle * (a + b * np.sin(middle) ** 2) / (1 - b * np.sin(middle) ** 2)
    again = half.turn + flip_map(a, b, middle, speed, phi - phi / 3)
    allowed = doubt + flip_uncertainty(a, b, middle, speed, phi - phi / 3)
    exists = np.isfinite(again)
    growth = 1e-12 * (1 + a) * math.exp(2 * math.pi * math.sqrt(a * b)) / b
    assert np.all(np.abs(again - whole.turn)[exists] <= (100 * allowed + growth)[exists])
    assert exists.mean() > 0.9


def test_a_start_within_rounding_of_the_saddle_ends() -> None:
    """The theta series once ran on for ever where the precision did not show cosh > 0."""
    theta = fmpq(
        1455086307567065297120939771110919450613573509313569719835088604471755577864741,
        2**259,
    )
    end = flip_angle(1, "1/1000", 0, digits=60, theta0=theta, precession="1/100")
    assert proves(end.turn, 60)


# The defect


@law(shapes(-12, 6))
@example(Shape(fmpq(1), fmpq(1)))
@example(Shape(fmpq(10) ** 12, fmpq(1, 10**12)))
def test_the_defect_on_the_separatrix_is_between_0_and_a_right_angle(shape: Shape) -> None:
    found = flip_defect(*shape, digits=DIGITS)
    assert 0 < found.defect < arb.pi() / 2
    assert found.turn > 0
    assert not found.turn > arb.pi()
    floor = 2 * (-arb.pi()).exp().atan()
    assert not found.realizable or found.defect > floor


@law(magnitudes(-6, 12), st.fractions(Fraction(1, 1000), 1, max_denominator=1000))
@example(Fraction(10) ** 12, Fraction(1))
def test_no_rigid_body_is_nearer_to_a_perfect_flip_than_the_floor(
    a: Fraction, part: Fraction
) -> None:
    found = flip_defect(a, part / (a + 2), digits=DIGITS)
    assert found.realizable
    assert found.defect > 2 * (-arb.pi()).exp().atan()


@law(shapes(-6, 6), magnitudes(-9, 0))
def test_the_defect_falls_in_a_and_in_b(shape: Shape, more: Fraction) -> None:
    a, b = shape
    factor = 1 + _q(more)
    least = flip_defect(a, b, digits=DIGITS).defect
    assert flip_defect(a * factor, b, digits=DIGITS).defect < least
    assert flip_defect(a, b / factor, digits=DIGITS).defect > least


@law(shapes(-4, 2), st.tuples(*[st.fractions(0, 1, max_denominator=10**6)] * 2))
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
    one, two = (bottom + (a - bottom) * _q(part) for part in (low, high))
    assert flip_defect(a, b, one, 40).defect > flip_defect(a, b, two, 40).defect


@law(shapes(-6, 4), st.tuples(*[st.fractions(0, Fraction(157, 100), max_denominator=10**6)] * 2))
def test_the_fixed_point_map_contracts(shape: Shape, ends: tuple[Fraction, Fraction]) -> None:
    assume(ends[0] != ends[1])
    a, b = arb(shape.a), arb(shape.b)
    x, y = (arb(_q(end)) for end in ends)
    images = (stable.separatrix_map(end, a, b, balls) for end in (x, y))
    one, two = images
    assert abs(one - two) < b * abs(x - y)
    root = separatrix.defect_over(a, b)
    assert root.overlaps(flip_defect(*shape, digits=DIGITS).defect)


@law(bodies_and_levels(), st.integers(1, 60))
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
def test_the_rungs_agree(at: tuple[Shape, fmpq]) -> None:
    shape, gamma = at
    found = []
    for rung in RUNGS:
        try:
            found.append(flip_defect(*shape, gamma, 8, rung=rung))
        except InputError:
            continue
    assert found[-1].rung == "planar"
    assert all(one.defect.overlaps(found[-1].defect) for one in found)
    assert all(one.turn.overlaps(found[-1].turn) for one in found)


@law(shapes(-3, 1), st.fractions(Fraction(1, 1000), 1, max_denominator=1000))
def test_the_integral_of_f_is_half_a_turn(shape: Shape, part: Fraction) -> None:
    from tresym.flip.quadrature import rigorous

    a, b = shape
    gamma = _q(part) * a / 2
    found = flip_defect(a, b, gamma, 20).defect
    with ball_precision(100):
        assert rigorous(found, arb(a), arb(b), arb(gamma)).overlaps(arb.pi())


@law(bodies_and_levels(-4, 1))
def test_the_float_route_is_right_where_it_answers(at: tuple[Shape, fmpq]) -> None:
    shape, gamma = at
    value = defects.float_defect(*(float(fraction(x)) for x in (*shape, gamma)))
    if value is not None:
        truth = flip_defect(*shape, gamma, 20).defect
        # at the turning point ε moves by the square root of a rounding of γ
        scale = abs(arb(gamma)) + arb(shape.b) * truth.sin() ** 2
        assert abs(truth - value) < arb("1e-13") + (scale * arb("1e-15")).sqrt()


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


# Precision


@law(st.lists(st.tuples(shapes(-3, 2), st.integers(1, 90), st.booleans()), min_size=1, max_size=6))
def test_precision_never_leaks(calls: list[tuple[Shape, int, bool]]) -> None:
    before, places = ctx.prec, mpmath.mp.prec
    alone = [flip_defect(*shape, digits=n).as_json()["defect"] for shape, n, _ in calls]
    for (shape, digits, good), expected in zip(calls, alone, strict=True):
        with ball_precision(37 + digits), mp_precision(digits):
            inside, mp_inside = ctx.prec, mpmath.mp.prec
            if good:
                assert flip_defect(*shape, digits=digits).as_json()["defect"] == expected
                flip_angle(*shape, "1/10", 0, min(digits, 30))
            else:
                for bad in (("1", "2"), ("nan", "1"), ("1", "1", "7")):
                    with suppress(InputError):
                        flip_defect(*bad, digits=digits)
            assert (ctx.prec, mpmath.mp.prec) == (inside, mp_inside)
    assert (ctx.prec, mpmath.mp.prec) == (before, places)


# Text


@law(st.fractions(), st.integers(-300, 300))
def test_numbers_survive_text(value: Fraction, power: int) -> None:
    x = _q(value) * fmpq(10) ** power
    assert parse_number(fraction_text(x)) == x
    assert proves(arb(x), 1) or x == 0
