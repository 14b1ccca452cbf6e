"""The orbit in balls: it solves the planar system, its phase is the integral of f, and inverts."""

from itertools import product
from typing import Any

import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from tresym.racket.motion import orbit as motion
from tresym.racket.motion import quadrature
from tresym.racket.motion.carlson import Amplitude, by_flint
from tresym.racket.motion.jacobi import functions
from tresym.racket.motion.orbit import (
    Orbit,
    Place,
    angle_at,
    exact_level,
    handle_at,
    orbit,
    phase,
    phase_at,
    slope,
    time_of,
)
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import parse_number

SHAPES = [(fmpq(2), fmpq(1, 3)), (fmpq(25, 2), fmpq(3, 50)), (fmpq(1), fmpq(1))]
PARTS = ["0.9", "0.1", "1e-20", "0", "-1e-20", "-0.1", "-0.9"]
WORK = 240


def made(shape: tuple[fmpq, fmpq], part: str) -> Orbit:
    a, b = shape
    share = parse_number(part)
    return orbit(a, b, exact_level(a, b, share * (a if share > 0 else b)))


def whole_phase(on: Orbit, place: Place) -> arb:
    found = phase_at(on, place.time)
    return found + 2 * place.halves * on.quarter_phase if place.halves else found


def test_it_solves_the_planar_system() -> None:
    """dψ/dφ = (a + bs²)z/(1 − bs²), dz/dφ = b(1 − z²)sc/(1 − bs²), z = cos θ; γ stays."""
    for shape, part, phi in product(SHAPES, PARTS, ["0.4", "-2", "7", "-31"]):
        with ball_precision(WORK):
            on = made(shape, part)
            a, b = on.a, on.b
            place = time_of(on, arb(phi))
            assert whole_phase(on, place).overlaps(arb(phi))
            assert not whole_phase(on, place).overlaps(arb(phi) + arb("1e-12"))
            psi, z = arb.pi() / 2 + angle_at(on, place), handle_at(on, place)
            sine, cosine = psi.sin_cos()
            clock, scale = 1 - b * sine**2, a + b * sine**2
            gamma = a * z**2 - b * (1 - z**2) * sine**2
            assert gamma.overlaps(on.level.gamma)
            step = arb((1, -60))
            around = [time_of(on, arb(phi) + sign * step) for sign in (-1, 1)]
            angles, handles = ([f(on, x) for x in around] for f in (angle_at, handle_at))
            rate = scale * z / clock
            assert abs((angles[1] - angles[0]) / (2 * step) - rate) < 1e-15
            fall = b * (1 - z**2) * sine * cosine / clock
            assert abs((handles[1] - handles[0]) / (2 * step) - fall) < 1e-15
            assert abs((angles[1] - angles[0]) / (2 * step) - rate - arb("1e-10")) > 1e-15


@pytest.mark.slow
@given(st.sampled_from(SHAPES[:2]), st.fractions("-99/100", "99/100"), st.fractions(-12, 12))
def test_the_phase_inverts_and_is_odd(shape: tuple[fmpq, fmpq], part: Any, phi: Any) -> None:
    target = fmpq(*phi.as_integer_ratio())
    a, b = shape
    share = fmpq(*part.as_integer_ratio())
    with ball_precision(160):
        on = orbit(a, b, exact_level(a, b, share * (a if share > 0 else b)))
        forth, back = time_of(on, arb(target)), time_of(on, arb(-target))
        assert whole_phase(on, forth).overlaps(arb(target))
        assert angle_at(on, forth).overlaps(-angle_at(on, back))
        assert handle_at(on, forth).overlaps(handle_at(on, back))


@pytest.mark.parametrize("shape", SHAPES[:2], ids=str)
@pytest.mark.parametrize("part", ["0.9", "0.1", "0", "-0.1", "-0.9"])
def test_the_phase_is_the_integral_of_f(shape: tuple[fmpq, fmpq], part: str) -> None:
    with ball_precision(150):
        on = made(shape, part)
        gamma = on.level.gamma
        for time in (arb("0.1"), arb("0.7"), arb("1.2")):
            if not time < on.quarter_time:
                continue
            psi = arb.pi() / 2 - angle_at(on, Place(time, 0))
            found = phase_at(on, time)
            assert found.overlaps(quadrature.rigorous(psi, on.a, on.b, gamma))
            assert found.rad() < 1e-35
            at = functions(on.elliptic, time)
            assert found.overlaps(phase(on, by_flint(at, on.characteristic)))
            step = arb((1, -40))
            rise = (phase_at(on, time + step) - phase_at(on, time - step)) / (2 * step)
            assert abs(rise - slope(on, at)) < 1e-18
            assert slope(on, at).overlaps((1 - on.b * psi.sin() ** 2) / on.speed)
        if on.level.regime < 0:
            truth = quadrature.rigorous_turned(arb.pi() / 2, on.a, on.b, gamma)
            assert on.quarter_phase.overlaps(truth)
        elif on.level.regime > 0:
            assert on.quarter_phase.overlaps(quadrature.rigorous(arb(0), on.a, on.b, gamma))
        else:
            assert not on.quarter_phase.is_finite()


@pytest.mark.parametrize("shape", SHAPES[:2], ids=str)
def test_the_limits_of_the_quarter(shape: tuple[fmpq, fmpq]) -> None:
    """At the bottom φ_K = π(1 − b)/(2√(b(a+b))); at γ = a the orbit is elementary, k = 0."""
    a, b = shape
    with ball_precision(200):
        low = orbit(a, b, exact_level(a, b, -b + fmpq(1, 10**30))).quarter_phase
        limit = arb.pi() * arb(1 - b) / (2 * arb(b * (a + b)).sqrt())
        assert abs(low - limit) < 1e-28
        assert low > limit
        top = orbit(a, b, exact_level(a, b, a))
        assert top.elliptic.modulus.is_zero()
        root = arb(a * (a + b)).sqrt()
        assert top.quarter_phase.overlaps(arb.pi() / 2 * ((1 + arb(a)) / root - 1))


def test_half_periods_on_top() -> None:
    """A half period on: ψ goes on by π where it rotates; where it oscillates it is reflected."""
    with ball_precision(160):
        for part in ("0.3", "-0.3"):
            on = made(SHAPES[0], part)
            here, there = Place(arb("0.3"), 0), Place(arb("0.3"), 3)
            sign = 1 if on.level.regime > 0 else -1
            turns = 3 * arb.pi() if on.level.regime > 0 else 0
            assert (angle_at(on, there) - turns).overlaps(sign * angle_at(on, here))
            assert handle_at(on, there).overlaps(sign * handle_at(on, here))


@pytest.mark.parametrize("phi", ["nan", "inf", "1e15", "0.5 +/- 40"])
@pytest.mark.parametrize("part", ["0.3", "0", "-0.3"])
def test_a_phase_that_is_not_known_gives_no_place_or_one_that_holds_it(part: str, phi: str) -> None:
    with ball_precision(80):
        on = made(SHAPES[0], part)
        try:
            place = time_of(on, arb(phi))
        except ArithmeticError:
            return
        assert whole_phase(on, place).overlaps(arb(phi))


@pytest.mark.parametrize("part", ["0.3", "0", "-0.3"])
@pytest.mark.parametrize("factor", ["1e6", "0.7", "3"])
def test_a_wrong_slope_costs_time_and_never_the_truth(
    part: str, factor: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The root is enclosed by two signs of the phase, wherever Newton's method was led."""
    with ball_precision(120):
        on = made(SHAPES[0], part)
        truth = time_of(on, arb("0.7")).time
        whole = motion.slope
        monkeypatch.setattr(motion, "slope", lambda *x: whole(*x) * arb(factor))
        try:
            found = time_of(on, arb("0.7")).time
        except ArithmeticError:
            return
        assert found.overlaps(truth)


@pytest.mark.parametrize("shape", SHAPES, ids=str)
@pytest.mark.parametrize("phi", ["1e3", "-1e20", "1e300"])
def test_on_the_separatrix_a_far_phase_is_found(shape: tuple[fmpq, fmpq], phi: str) -> None:
    """It takes ever longer, and comes no further than the unstable point."""
    with ball_precision(1200):
        on = made(shape, "0")
        place = time_of(on, arb(phi))
        assert (place.time - on.speed * arb(phi)).overlaps(arb(0, 1))
        assert abs(abs(angle_at(on, place)) - arb.pi() / 2) < 1e-12


def test_a_wide_phase_is_held_as_a_whole() -> None:
    with ball_precision(120):
        on = made(SHAPES[0], "-0.3")
        wide = time_of(on, arb("0.7", "1e-6"))
        for phi in ("0.699999", "0.7", "0.700001"):
            assert angle_at(on, wide).contains(angle_at(on, time_of(on, arb(phi))))
        far = Amplitude(arb(1), arb(0), on.elliptic.complement.sqrt(), on.elliptic.modulus)
        assert by_flint(far, on.characteristic).time.overlaps(on.quarter_time)
