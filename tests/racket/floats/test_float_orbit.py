"""One start's orbit in float64: places and phases by quadrature, and the flow against balls."""

import math
from typing import Any

import numpy as np
import pytest
from flint import arb, fmpq
from hypothesis import assume, given
from hypothesis import strategies as st
from numpy.typing import NDArray

from tresym.racket.angle import Angle
from tresym.racket.body import Shape
from tresym.racket.floats import float_orbit as fo
from tresym.racket.floats.float_orbit import LEVELS
from tresym.racket.motion.quadrature import rigorous
from tresym.racket.motion.trajectory import Start, travel
from tresym.reals.numbers.arithmetic import ball_precision, mp_precision

Floats = NDArray[np.float64]
A, B = 2.0, 0.25


def room(n: int = 1) -> Floats:
    return np.empty((5, LEVELS + 1, n))


def on_level(gamma: float, a: float = A, b: float = B) -> fo.FloatOrbit:
    given_ = [
        np.array([x]) for x in (gamma >= 0, math.sqrt(abs(gamma) * (a + b)), a - gamma, gamma + b)
    ]
    rotating, root, below, above = given_
    return fo.orbit(a, b, rotating, root, below, above, room())


def turn(a: float, b: float, psi: Any, rate: Any, phi: Any) -> Floats:
    psi, rate, phi = np.broadcast_arrays(*(np.asarray(x, float).ravel() for x in (psi, rate, phi)))
    with np.errstate(all="ignore"):
        return fo.turn(a, b, psi, rate, phi, room(psi.size))


def integrals(gamma: float, sine: float) -> tuple[float, float]:
    """τ and φ from ψ = π/2 to the angle of a sine, the way before any turning point, by mpmath."""
    with mp_precision(20) as mp:

        def speed(psi: Any, power: int) -> Any:
            s = B * mp.sin(psi) ** 2
            return (1 - power * s) / mp.sqrt((A + s) * (gamma + s))

        ends = [mp.asin(sine), mp.pi / 2]
        return tuple(float(mp.quad(lambda psi, n=n: speed(psi, n), ends)) for n in (0, 1))


@pytest.mark.parametrize("gamma", [1.9, 0.5, 1e-3, -1e-3, -0.1, -0.24])
def test_places_keep_the_level_and_their_time_and_phase_are_the_integrals(gamma: float) -> None:
    """r² − p² = γ(a+b), z² − p² = a(γ+b), p′ = −rz; φ = τ − ∫ b sin²ψ dτ."""
    on = on_level(gamma)
    for time in map(np.array, ([0.1], [0.5], [0.9])):
        p, r, z = (float(x[0]) for x in fo.place(on, time))
        assert r * r - p * p == pytest.approx(gamma * (A + B), rel=1e-9, abs=1e-13 * z * z)
        assert z * z - p * p == pytest.approx(A * (gamma + B), rel=1e-9, abs=1e-13 * z * z)
        near, far = (fo.place(on, time + x) for x in (-1e-5, 1e-5))
        for one, other, slope in zip(near, far, (-r * z, -p * z, -p * r), strict=True):
            assert float((other - one)[0]) / 2e-5 == pytest.approx(slope, rel=1e-5)
        fo.place(on, time)
        rest = fo.spent(on, time, fo.TANGENTS)
        assert 0 <= rest[0] <= math.pi / 2
        whole, phase = integrals(gamma, float((p / np.hypot(p, on.reach))[0]))
        assert time[0] == pytest.approx(whole, rel=1e-12)
        assert time[0] - rest[0] == pytest.approx(phase, rel=1e-12)


starts = st.tuples(
    st.floats(0.05, 30), st.floats(0.02, 0.98), st.floats(-3, 3), st.floats(-0.98, 0.98),
    st.floats(-7, 7),
)  # fmt: skip


def truth(a: float, b: float, psi: float, rate: float, phi: float) -> float:
    p, q, x, y, z = (fmpq(*v.as_integer_ratio()) for v in (a, b, psi, rate, phi))
    radians = Start(Angle(fmpq(0), x), y)
    with ball_precision(120):
        return float(travel(Shape(p, q), radians, Angle(fmpq(0), z), 20).turn)


@given(starts)
def test_the_flow_is_that_of_the_balls(start: tuple[float, float, float, float, float]) -> None:
    a, b, psi, part, phi = start
    assume(math.sqrt(a * b) * abs(phi) < 7)
    square = math.sin(psi) ** 2
    rate = part * (a + b * square) / (1 - b * square)
    # Roundings of the start grow by e^(√(ab) φ) at most, times the speed.
    growth = math.exp(math.sqrt(a * b) * abs(phi)) * (1 + a) / (1 - b)
    assert abs(turn(a, b, psi, rate, phi)[0] - truth(a, b, psi, rate, phi)) < 1e-12 * growth


@pytest.mark.parametrize(
    ("psi", "rate", "turned"),
    [(0.0, 0.0, 0.0), (math.pi / 2, 0.0, 0.0), (0.1, 1e3, math.nan), (0.1, -1e3, math.nan)],
)
def test_at_rest_and_where_there_is_no_start(psi: float, rate: float, turned: float) -> None:
    assert turn(A, B, psi, rate, 6.0)[0] == pytest.approx(turned, abs=1e-12, nan_ok=True)


def test_a_rate_a_little_too_large_is_no_start() -> None:
    square = B * math.sin(0.7) ** 2
    largest = (A + square) / (1 - square)
    found = turn(A, B, 0.7, [largest * (1 - 1e-12), largest * (1 + 1e-12), -largest * 1.01], 1.0)
    assert np.isnan(found).tolist() == [False, True, True]


@pytest.mark.parametrize("gamma", [1e-200, -1e-200])
@pytest.mark.parametrize("time", [0.3, 5.0, 40.0, 200.0])
def test_next_to_the_separatrix_the_phase_is_elementary_however_long(
    gamma: float, time: float
) -> None:
    """∫ b sin²ψ dτ = arctan(√(b/a) tanh(√(ab) τ)), whatever number of turns the angles make."""
    on, at = on_level(gamma), np.array([time])
    fo.place(on, at)
    exact = math.atan(math.sqrt(B / A) * math.tanh(math.sqrt(A * B) * time))
    assert fo.spent(on, at, fo.TANGENTS)[0] == pytest.approx(exact, rel=1e-12)


def test_near_the_saddle_the_motion_is_linear() -> None:
    """ψ″ = ab ψ: accurate relative to itself, in arrays where others are far off."""
    k, phi = math.sqrt(A * B), 3.0
    psi, rate = np.array([1e-14, -1e-200, 0.0, 0.7]), np.array([0.0, 1e-200, 1e-30, 0.1])
    found = turn(A, B, psi, rate, phi)
    linear = psi * (math.cosh(k * phi) - 1) + rate * math.sinh(k * phi) / k
    assert found[:3] == pytest.approx(linear[:3], rel=1e-13, abs=0)
    assert found[3] == pytest.approx(truth(A, B, 0.7, 0.1, phi), rel=1e-12)


def test_the_end_of_a_start_and_its_time() -> None:
    """cos θ and sin θ of one angle, γ kept, and the time as φ + ∫ b sin²ψ dτ ≥ φ."""
    psi, rate, phi = np.array([0.3, 1.2, -2.0]), np.array([0.4, -0.5, 0.1]), np.full(3, 5.0)
    turned, handle, level, time, size, _ = fo.arrive(A, B, psi, rate, phi, room(3))
    assert np.hypot(handle, level) == pytest.approx(1.0, abs=1e-13)
    square = B * np.sin(psi) ** 2
    start = rate * (1 - square) / (A + square)
    before = A * start**2 - (1 - start**2) * square
    after = A * handle**2 - B * level**2 * np.sin(psi + turned) ** 2
    assert after == pytest.approx(before, abs=1e-13)
    assert (time > phi).all()
    assert (time < phi / (1 - B)).all()
    assert (size >= np.abs(turned)).all()


@pytest.mark.parametrize("gamma", [1.9, 0.2, -0.2])
def test_the_far_end_is_the_quarter_and_a_start_comes_back(gamma: float) -> None:
    on = on_level(gamma)
    p, r, z = fo.place(on, np.array([0.4]))
    time, phase, far, far_phase = fo.entries(on, p, r, z, np.array([1.0]))
    assert time[0] == pytest.approx(0.4, rel=1e-13)
    at_far = fo.place(on, far)
    assert abs(float(at_far[0 if gamma > 0 else 1][0])) < 1e-12
    there = fo.arrival(on, phase, far, far_phase)
    assert there[0][0] == pytest.approx(0.4, rel=1e-12)
    assert there[1][0] == pytest.approx(p[0], rel=1e-12)
    assert there[2][0] == pytest.approx(r[0], rel=1e-12)
    if gamma <= 8 * B:
        assert fo.of_fast_rotation(on, far, far_phase) == (far, far_phase)


def test_the_six_points_of_fast_rotation() -> None:
    for gamma in (8.1, 20.0):
        on = on_level(gamma, 30.0, 1.0)
        with ball_precision(80):
            whole = rigorous(arb(0), arb(30), arb(1), arb(gamma))
        zero = np.array([0.0])
        _, phase = fo.of_fast_rotation(on, zero, zero)
        assert phase[0] == pytest.approx(float(whole), rel=1e-14)


def test_numbers_that_are_not_are_left_aside() -> None:
    x = np.array([math.nan, 2.0, -1.0])
    assert (fo.largest(x), fo.least(x)) == (2.0, -1.0)
    assert fo.largest(np.array([])) == -math.inf
    assert fo.least(np.array([])) == math.inf
    assert fo.choose(x > 0, 1.0, 0.0).tolist() == [0.0, 1.0, 0.0]


def test_start_by_start_is_the_same() -> None:
    psi, rate, phi = np.array([0.3, 1.2, -2.0]), np.array([0.4, -0.5, 0.1]), np.full(3, 5.0)
    each = np.array([turn(A, B, *start)[0] for start in zip(psi, rate, phi, strict=True)])
    assert turn(A, B, psi, rate, phi) == pytest.approx(each, abs=1e-14)
