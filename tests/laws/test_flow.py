"""Laws of the flow ψ(φ), θ(φ) from any start, in balls: symmetries, conservation, bounds, group."""

from fractions import Fraction

from flint import arb, fmpq
from hypothesis import assume, example
from hypothesis import strategies as st
from strategies import (
    DIGITS,
    Start,
    bodies_and_levels,
    fly,
    fraction,
    law,
    rational,
    rational_near,
    same,
    starts,
    tame_shapes,
    turns,
)  # fmt: skip

from tresym import flip_angle, flip_defect
from tresym.racket.angle import Angle
from tresym.racket.body import Shape
from tresym.racket.formulas import printed
from tresym.racket.motion.jacobi import functions
from tresym.racket.motion.orbit import exact_level, orbit
from tresym.racket.result import proves
from tresym.reals.numbers.arithmetic import balls


@law(starts(), turns, st.integers(-3, 3))
def test_half_turns_of_psi_change_nothing(start: Start, phi: Fraction, halves: int) -> None:
    (a, b), psi, rate = start
    # An angle is a multiple of π or a rational number: here the former, so that half turns add.
    part = rational(psi)
    rate = fraction(a) * rate / (1 + abs(rate))
    one, two = (
        flip_angle(a, b, Angle(part + n, fmpq(0)), rate, 20, precession=phi) for n in (0, halves)
    )
    assert same(one.turn, two.turn, 18)
    assert same(one.theta, two.theta, 18)
    assert same(arb(one.gamma), arb(two.gamma), 18)
    assert same(two.psi - one.psi, halves * arb.pi(), 18)


IMAGES = {
    "the central symmetry about the unstable points": (-1, -1, 1),
    "time reversal, θ to π − θ": (1, -1, -1),
    "ψ to −ψ with the direction of φ": (-1, 1, -1),
}
"""Signs of ψ₀, of the rate (and so of cos θ), and of Δφ."""


AT_THE_SADDLE = (Shape(fmpq(1), fmpq(1, 3)), Fraction(0), Fraction(0))
NEAR_THE_SADDLE = (Shape(fmpq(1), fmpq(1, 3)), Fraction(1, 10**20), Fraction(-1, 10**20))
TURNING_BACK = (Shape(fmpq(1), fmpq(1, 3)), Fraction(3, 2), Fraction(0))


@law(starts(), turns)
@example(AT_THE_SADDLE, Fraction(6))
@example(NEAR_THE_SADDLE, Fraction(6))
@example(TURNING_BACK, Fraction(6))
def test_the_flow_has_the_symmetries_of_the_system(start: Start, phi: Fraction) -> None:
    shape, psi, rate = start
    here = fly(start, phi, 20)
    for name, (side, way, direction) in IMAGES.items():
        there = fly((shape, side * psi, way * rate), direction * phi, 20)
        theta = there.theta if way > 0 else arb.pi() - there.theta
        assert same(here.turn, side * there.turn, 18), name
        assert same(here.theta, theta, 18), name


@law(tame_shapes(), st.fractions(Fraction(1, 100), Fraction(95, 100), max_denominator=1000))
def test_the_defect_from_either_end_of_the_trajectory(shape: Shape, part: Fraction) -> None:
    a, b = shape
    rate = fraction((a + b) / (1 - b)) * part
    forth, back = (flip_angle(a, b, "pi/2", rate, DIGITS, precession=phi) for phi in ("pi", "-pi"))
    assert isinstance(forth.gamma, fmpq)
    assert same(forth.turn, -back.turn)
    assert same(arb.pi() / 2 - forth.turn, flip_defect(a, b, forth.gamma, DIGITS).defect)


@law(starts(), turns, st.one_of(turns, turns.map(lambda x: -x), st.just(None)))
@example(
    # At the saddle: cosh > ½ to the ball, yet the part of it that a term must lie below held 0.
    (Shape(fmpq(5733, 82_000), fmpq(82, 5733)), Fraction(0), Fraction(0)),
    Fraction(1, 100),
    Fraction(-117, 818),
)
def test_the_flow_composes(start: Start, first: Fraction, second: Fraction | None) -> None:
    """flow(φ₁ + φ₂) = flow(φ₂) ∘ flow(φ₁); None goes back to the start."""
    then = -first if second is None else second
    whole = fly(start, first + then, 60)
    half = fly(start, first, 75)
    there = flip_angle(
        *start[0], rational_near(half.psi), digits=60, theta0=rational_near(half.theta),
        precession=then,
    )  # fmt: skip
    assert abs(half.turn + there.turn - whole.turn) < arb("1e-40")
    assert abs(there.theta - whole.theta) < arb("1e-40")


@law(bodies_and_levels(), st.fractions(-1, 1, max_denominator=1000))
def test_the_momentum_keeps_its_length_and_gamma(at: tuple[Shape, fmpq], part: Fraction) -> None:
    """|M| = 1 and γ from the squares of M₁, M₂, M₃ in sn, cn and dn, three quotients of series."""
    (a, b), gamma = at
    assume(gamma != -b)
    on = orbit(a, b, exact_level(a, b, gamma))
    far = on.quarter_time if on.quarter_time.is_finite() else arb(9)
    found = functions(on.elliptic, far * rational(part))
    sn, cn, dn = (x * x for x in found[:3])
    high, low = on.level.above / (on.a + on.b), on.level.below / (on.a + on.b)
    if gamma >= 0:
        squares = high * dn, on.level.below / a * sn, low * cn
    else:
        squares = high * cn, on.level.above / b * sn, low * dn
    depth = a * squares[0] - b * squares[2]
    assert sum(squares).contains(1)
    assert sum(squares).rad() < arb("1e-60")
    assert depth.contains(arb(gamma))
    assert depth.rad() < arb("1e-60") * (1 + a)


@law(starts(), turns)
@example(AT_THE_SADDLE, Fraction(6))
@example(NEAR_THE_SADDLE, Fraction(6))
@example(TURNING_BACK, Fraction(6))
def test_gamma_and_the_bounds_hold_along_a_trajectory(start: Start, phi: Fraction) -> None:
    shape, _, rate = start
    a, b = (arb(x) for x in shape)
    end = fly(start, phi)
    gamma, slack = arb(end.gamma), arb("1e-24")
    now = printed.depth(end.theta, end.psi, a, b, balls)
    assert now.overlaps(gamma)
    assert now.rad() < arb("1e-27") * (1 + a)
    assert not gamma < -b
    assert not gamma > a
    sine, cosine = end.psi.sin(), end.theta.cos()
    # ψ and θ bounds, squared (eq_borne_psi, eq_borne_theta)
    assert not cosine * cosine * (a + b) > gamma + b + slack * (1 + a)
    if gamma > 0:
        assert not cosine * cosine * a < gamma - slack * (1 + a)
        # no crossing of θ = π/2
        assert not cosine * (1 if rate > 0 else -1) < -slack
    elif gamma < 0:
        assert not b * sine * sine < -gamma - slack
        # the amplitude of an oscillation is below π
        assert abs(end.turn) < arb.pi()


def test_a_start_within_rounding_of_the_saddle_ends() -> None:
    """The theta series once ran on for ever where the precision did not show cosh > 0."""
    theta = fmpq(
        1455086307567065297120939771110919450613573509313569719835088604471755577864741,
        2**259,
    )
    end = flip_angle(1, "1/1000", 0, digits=60, theta0=theta, precession="1/100")
    assert proves(end.turn, 60)
