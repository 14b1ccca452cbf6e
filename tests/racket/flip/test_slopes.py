"""dε/dγ and d²ε/dγ²: F(ε(γ), γ) = π differentiated under the integral sign, by mpmath alone."""

import mpmath
import pytest
from flint import arb, fmpq

from tresym.racket.flip.defect import defect_on
from tresym.racket.flip.levels import turning_level
from tresym.racket.flip.slopes import slopes
from tresym.racket.motion.orbit import exact_level
from tresym.racket.result import proves
from tresym.reals.numbers.arithmetic import ball_precision, mp_precision, to_mp
from tresym.reals.numbers.exact import InputError, parse_number

PLACES = [
    ("2", "1/3", "1/10"),
    ("2", "1/3", "1"),
    ("2", "1/3", "19/10"),
    ("12.5", "0.06", "1/5"),
    ("1", "1", "1/2"),
    ("1/2", "1/5", "0"),
    ("2", "1/3", "0"),
    ("2", "1/3", "-1/1000"),
    ("1/2", "1/4", "-1/20"),
]


def by_integrals(a: str, b: str, gamma: str) -> tuple[mpmath.mpf, mpmath.mpf, mpmath.mpf]:
    """ε, ε′ and ε″ of an orbit that has not turned, from integrals of f, f_γ and f_γγ over ψ."""
    with mp_precision(24) as mp:
        p, q, g = (to_mp(parse_number(x), mp) for x in (a, b, gamma))

        def f(psi: mpmath.mpf, power: int = 0) -> mpmath.mpf:
            """f, and its derivatives by γ."""
            s = q * mp.sin(psi) ** 2
            factor = (1, mp.mpf(-1) / 2, mp.mpf(3) / 4)[power]
            return factor * (1 - s) / mp.sqrt(p + s) / (g + s) ** (mp.mpf(1) / 2 + power)

        def total(e: mpmath.mpf, power: int) -> mpmath.mpf:
            ends = mp.linspace(e, mp.pi / 2, 9)
            if g <= 0:
                ends = [e * (mp.pi / 2 / e) ** (mp.mpf(i) / 6) for i in range(7)]
            return mp.quad(lambda psi: f(psi, power), ends)

        # The float of the ball is only where Newton's method starts.
        level = exact_level(*map(parse_number, (a, b, gamma)))
        e = mp.mpf(float(defect_on(parse_number(a), parse_number(b), level)))
        for _ in range(2):
            e += (total(e, 0) - mp.pi) / f(e)
        first = total(e, 1) / f(e)
        by_angle = mp.diff(f, e)
        return e, first, (total(e, 2) - 2 * f(e, 1) * first - by_angle * first**2) / f(e)


@pytest.mark.parametrize("place", PLACES, ids="/".join)
def test_they_are_the_integrals(place: tuple[str, str, str]) -> None:
    found, truth = slopes(*map(parse_number, place), 20), by_integrals(*place)
    for ball, value in zip(found, truth, strict=True):
        assert proves(ball, 20)
        assert abs(ball / arb(mpmath.nstr(value, 20)) - 1) < 1e-12
        assert not abs(ball / (arb(mpmath.nstr(value, 20)) * arb("1.000001")) - 1) < 1e-12


@pytest.mark.parametrize(
    ("a", "b", "gamma"),
    [("2", "1/3", "1"), ("2", "1/3", "1e-30"), ("12.5", "0.06", "12"), ("12.5", "0.06", "-1/20"),
     ("3", "1/4", "-1/5"), ("1/2", "1/4", "-1/5"), ("1e-3", "1", "-1/2"), ("1e3", "1", "700")],
)  # fmt: skip
def test_they_are_the_limits_of_differences_after_turns_too(a: str, b: str, gamma: str) -> None:
    p, q, g = map(parse_number, (a, b, gamma))
    step = fmpq(1, 10**60)
    found = slopes(p, q, g, 20)
    with ball_precision(900):
        low, mid, high = (defect_on(p, q, exact_level(p, q, g + k * step)) for k in (-1, 0, 1))
        assert found.defect.overlaps(mid)
        first, second = (high - low) / (2 * step), (high - 2 * mid + low) / step**2
        assert abs(first / found.first - 1) < 1e-18
        assert abs(second / found.second - 1) < 1e-18


def test_at_the_turning_level_the_slope_is_finite_and_negative() -> None:
    a, b = parse_number("12.5"), parse_number("0.06")
    level = turning_level(a, b, 60)
    with ball_precision(400):
        scaled = int((level.mid() * 10**50).floor().unique_fmpz())
    around = [slopes(a, b, fmpq(scaled + k, 10**50), 15) for k in (-1, 0, 1, 2)]
    for one in around:
        assert one.first < 0
        assert abs(one.first / around[0].first - 1) < 1e-12


@pytest.mark.parametrize("gamma", ["-1/3", "2", "-1/2", "5", "2.00000000000000000000000001"])
def test_at_the_ends_there_is_no_slope(gamma: str) -> None:
    with pytest.raises(InputError, match="strictly between"):
        slopes(fmpq(2), fmpq(1, 3), parse_number(gamma), 10)


def test_more_digits_lie_within_fewer() -> None:
    few, many = (slopes(fmpq(2), fmpq(1, 3), fmpq(-1, 10), n) for n in (10, 120))
    with ball_precision(600):
        for rough, fine in zip(few, many, strict=True):
            assert rough.overlaps(fine)
            assert proves(fine, 120)
