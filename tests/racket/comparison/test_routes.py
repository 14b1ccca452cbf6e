"""Six routes to ε(γ): each on its own, where they meet, and the counting of digits."""

import mpmath
import pytest
from flint import arb, fmpq

from tresym.racket.body import Shape, named_body, shape
from tresym.racket.comparison import routes
from tresym.racket.flip.levels import turning_level
from tresym.reals.numbers.arithmetic import ball_precision, mp_precision, to_mp

BOOK = named_body("book").shape
QUICK = [route for route in routes.ROUTES if route.run is not routes.mpmath_taylor]

PLACES = [
    (shape("2", "1/3"), fmpq(0)),
    (shape("2", "1/3"), fmpq(1, 7)),
    (shape("2", "1/3"), fmpq(-1, 50)),
    (shape("1/2", "1/5"), fmpq(1, 3)),
    (shape("3", "1/4"), fmpq(-1, 10)),
]


def elementary(given: Shape) -> mpmath.mpf:
    """ε₀ from F(ε, 0) = asinh(√(a/(a+b)) cot ε)/√(ab) − arcsin(√(b/(a+b)) cos ε) = π."""
    with mp_precision(70) as mp:
        a, b = (to_mp(x, mp) for x in given)

        def excess(e: mpmath.mpf) -> mpmath.mpf:
            fall = mp.asinh(mp.sqrt(a / (a + b)) * mp.cot(e)) / mp.sqrt(a * b)
            return fall - mp.asin(mp.sqrt(b / (a + b)) * mp.cos(e)) - mp.pi

        return mp.findroot(excess, (mp.mpf("1e-9"), mp.pi / 2), solver="anderson")


@pytest.mark.parametrize("route", QUICK, ids=lambda route: route.run.__name__)
@pytest.mark.slow
def test_on_the_separatrix_every_route_solves_the_elementary_equation(route: routes.Route) -> None:
    given = shape("2", "1/3")
    truth = elementary(given)
    with ball_precision(300):
        ball = arb(mpmath.nstr(truth, 65))
    assert routes.agreement(route.run(given, fmpq(0)), ball) >= min(route.digits - 1, 49)


@pytest.mark.parametrize("place", PLACES, ids=str)
def test_the_routes_agree_at_places_that_are_not_in_the_table(place: tuple[Shape, fmpq]) -> None:
    truth = routes.carlson(*place)
    for route in QUICK[1:]:
        assert routes.agreement(route.run(*place), truth) >= route.digits - 2, route.name


def test_the_taylor_route_agrees_where_the_others_do() -> None:
    truth = routes.carlson(BOOK, fmpq(1, 20))
    assert routes.agreement(routes.mpmath_taylor(BOOK, fmpq(1, 20)), truth) == routes.DIGITS


def test_a_taylor_step_solves_the_planar_system() -> None:
    """Over a small step: the state after it by the slopes, their errors falling like h²."""
    with mp_precision(40) as mp:
        a, b, h = mp.mpf(2), mp.mpf(1) / 3, mp.mpf(10) ** -12
        psi, z = mp.mpf(1) / 2, mp.mpf(1) / 5
        sine, cosine = mp.sin(psi), mp.cos(psi)
        state = [sine, cosine, z, 1 / (1 - b * sine**2)]
        turn, after = routes._taylor_step(state, a, b, h, 8, mp)
        slopes = routes._system(a, b, mp)([psi, z])
        assert abs(turn - h * slopes[0]) < 1e-23
        assert abs(after[2] - z - h * slopes[1]) < 1e-23
        assert abs(after[0] - mp.sin(psi + turn)) < 1e-35
        assert abs(after[1] - mp.cos(psi + turn)) < 1e-35
        assert abs(after[3] * (1 - b * mp.sin(psi + turn) ** 2) - 1) < 1e-35


def test_the_turned_side_is_told() -> None:
    level = turning_level(*BOOK, 30)
    assert level is not None
    with ball_precision(200):
        near = fmpq((level.mid() * 10**20).floor().unique_fmpz(), 10**20)
    for gamma, turned in ((near + fmpq(1, 10**15), False), (near - fmpq(1, 10**15), True)):
        assert routes._turned(BOOK, gamma) is turned
    assert not routes._turned(BOOK, fmpq(1, 10))
    assert not routes._turned(shape("1/100", "1/100"), fmpq(-1, 101))


@pytest.mark.parametrize("start", ["1.3", "1.4142135623", "1.5", "1.41421356237309504"])
def test_newton_s_method_encloses_the_root(start: str) -> None:
    with ball_precision(200):
        found = routes._newton(arb(start), lambda x: x * x - 2, lambda x: 2 * x)
        assert found.overlaps(arb(2).sqrt())
        assert found.rad() < 1e-3


@pytest.mark.parametrize("start", ["0.01", "0.3", "-0.01"])
def test_newton_s_method_shows_nothing_from_afar(start: str) -> None:
    with ball_precision(200), pytest.raises(ArithmeticError, match="did not contract"):
        routes._newton(arb(start), lambda x: x * x - 2, lambda x: 2 * x)


@pytest.mark.parametrize(
    ("factor", "digits"),
    [("1", 50), ("1.0000000001", (9, 10)), ("0.9", (0, 1)), ("-1", 0), ("1e9", 0), ("0", 0)],
)
def test_digits_are_counted_in_every_arithmetic(factor: str, digits: object) -> None:
    right = {digits} if isinstance(digits, int) else set(digits)
    with ball_precision(300), mp_precision(80) as mp:
        truth = arb(fmpq(-5, 8))
        assert routes.agreement(arb(factor) * truth, truth) in right
        assert routes.agreement(mp.mpf(factor) * mp.mpf(-0.625), truth) in right
        assert routes.agreement(float(factor) * -0.625, truth) in right
