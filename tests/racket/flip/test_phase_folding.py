"""The fold into the first quarter: what unfolds again, and the quarter in float64."""

import math

import mpmath
import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from tresym.racket.flip.defect import defect_on
from tresym.racket.flip.levels import turning_level
from tresym.racket.flip.phase_folding import Fold, Quarter, float_defect, folded
from tresym.racket.motion.orbit import exact_level
from tresym.reals.numbers.arithmetic import ball_precision, mp_precision
from tresym.reals.numbers.exact import parse_number

PLACES = [
    (a, b, part * (a if part > 0 else b))
    for a, b in ((12.5, 0.0625), (1.0, 1.0), (0.25, 0.5), (40.0, 0.03125), (3.0, 0.25))
    for part in (0.875, 0.25, 1e-3, 1e-9, -1e-9, -1e-3, -0.25, -0.75, -0.96875)
]


def exact(x: float) -> fmpq:
    return fmpq(*x.as_integer_ratio())


def truth(a: float, b: float, gamma: float) -> float:
    """ε(γ) by inverting the phase in balls."""
    with ball_precision(160):
        return float(defect_on(exact(a), exact(b), exact_level(exact(a), exact(b), exact(gamma))))


def test_the_folded_angle_unfolds_to_the_defect() -> None:
    for place in PLACES:
        found = folded(*place)
        assert found is not None
        fold, angle = found
        sign, turns = fold.unfolding
        assert fold.rotating is (place[2] >= 0)
        assert 0 < angle < math.pi / 2
        right = truth(*place)
        assert sign * angle + turns * math.pi == pytest.approx(right, rel=1e-9, abs=1e-9)
        for other in (fold._replace(back=not fold.back), fold._replace(halves=fold.halves + 1)):
            sign, turns = other.unfolding
            same = (sign, turns) == fold.unfolding
            assert same or abs(sign * angle + turns * math.pi - right) > 1e-6


def test_the_phase_of_the_folded_angle_is_the_folded_half_turn() -> None:
    for place in PLACES:
        fold, angle = folded(*place)
        quarter = Quarter(*place)
        tangent, rest, _ = quarter.at(quarter.time(angle))
        phase, whole = quarter.turn(tangent, rest), quarter.whole()
        phase = 2 * whole - phase if fold.back else phase
        wanted = fold.phase(arb.pi(), lambda whole=whole: arb(whole))
        assert phase == pytest.approx(float(wanted), rel=1e-9, abs=1e-9 * max(1, math.pi / whole))


quarters = st.builds(
    lambda a, b, part: Quarter(a, b, part * (a if part > 0 else b)),
    st.floats(0.01, 50), st.floats(0.01, 1), st.floats(-0.99, 0.99).filter(lambda x: abs(x) > 1e-6),
)  # fmt: skip


@given(quarters, st.floats(0.02, 5))
def test_the_variable_of_the_quarter(on: Quarter, time: float) -> None:
    """tan e and (γ + b sin²e)/cos²e belong together, T comes back, dF/dT is the difference."""
    tangent, rest, rate = on.at(time)
    assert rest == pytest.approx(on.gamma + (on.gamma + on.b) * tangent**2, rel=1e-6, abs=1e-9)
    if on.gamma > 0 or rest > 1e-4 * on.b:
        assert on.time(math.atan(tangent)) == pytest.approx(time, rel=1e-5)
    step = 1e-4 * time
    near, far = (on.turn(*on.at(time + shift)[:2]) for shift in (-step, step))
    assert (far - near) / (2 * step) == pytest.approx(rate, rel=1e-4)
    assert rate * math.sqrt(on.a * (on.b + max(on.gamma, 0))) < 1 + 1e-9


@pytest.mark.parametrize("place", PLACES[::2], ids=str)
def test_the_whole_quarter_is_the_integral(place: tuple[float, float, float]) -> None:
    """In v with sin ψ = sin ψ_min + …: cos ψ = cos ψ_min sin v takes the turning point away."""
    with mp_precision(25) as mp:
        a, b, gamma = map(mp.mpf, place)

        def oscillating(v: mpmath.mpf) -> mpmath.mpf:
            s = 1 - (1 + gamma / b) * mp.sin(v) ** 2
            return (1 - b * s) / mp.sqrt(b * s * (a + b * s))

        def rotating(x: mpmath.mpf) -> mpmath.mpf:
            c = mp.sqrt(gamma / (gamma + b)) * mp.sinh(x)
            s = c * c / (1 + c * c)
            return (1 - b * s) / mp.sqrt((a + b * s) * (gamma + b) * (1 + c * c))

        if gamma < 0:
            value = mp.quad(oscillating, mp.linspace(0, mp.pi / 2, 5))
        else:
            value = mp.quad(rotating, [0, 1, 4, 12, 30, mp.inf])
        assert Quarter(*place).whole() == pytest.approx(float(value), rel=1e-10)


def test_a_trajectory_that_has_turned_is_not_taken_for_one_that_has_not() -> None:
    a, b = parse_number("12.5"), parse_number("1/16")
    level = float(turning_level(a, b, 20))
    assert float_defect(12.5, 0.0625, level * 0.5) == pytest.approx(
        truth(12.5, 0.0625, level * 0.5), rel=1e-8
    )
    for gamma in (level * 1.01, level * 2, -0.06):
        assert float_defect(12.5, 0.0625, gamma) is None


@pytest.mark.parametrize(
    "place",
    [(1.0, 1.0, -1.0), (1.0, 1.0, -1.5), (1.0, 0.5, math.nan), (math.inf, 1.0, 0.5)],
    ids=str,
)  # fmt: skip
def test_outside_nothing_is_found_and_nothing_raised(place: tuple[float, float, float]) -> None:
    assert folded(*place) is None


def test_the_unfolding_by_the_half_periods() -> None:
    """ψ(π) = ψ(π − 2jQ) − jπ where it rotates, by π − ψ for odd j where it oscillates."""
    for j in range(6):
        assert Fold(True, j, False).unfolding == (1, -j)
        assert Fold(True, j, True).unfolding == (-1, 1 - j)
        assert Fold(False, j, False).unfolding == ((-1, 1) if j % 2 else (1, 0))
        assert Fold(False, j, True).unfolding == ((1, 0) if j % 2 else (-1, 1))
