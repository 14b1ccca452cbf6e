"""The charts: each function is what it is called, at exact roots, over boxes, with its slopes."""

from collections.abc import Callable
from itertools import product
from typing import Any, NamedTuple

import pytest
from differences import defect_slope
from flint import arb, fmpq

from tresym.racket.bounds import charts as c
from tresym.racket.flip import uniform
from tresym.racket.flip.separatrix import solve
from tresym.racket.flip.series import coefficient_values
from tresym.racket.formulas import printed
from tresym.reals.balls.gradient import Gradient, coordinates, gradients
from tresym.reals.balls.tracing import Named
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.expression import symbol
from tresym.reals.numbers.arithmetic import ball_precision, balls
from tresym.reals.numbers.exact import as_rational

SHAPES = [
    (fmpq(1), fmpq(1)),
    (fmpq(3), fmpq(1, 5)),
    (fmpq(25, 2), fmpq(3, 50)),
    (fmpq(9), fmpq(4, 5)),
]
WORK = 300


class Exact(NamedTuple):
    """A shape with its root, and what the charts call by name."""

    a: arb
    b: arb
    k: arb
    r: arb
    phase: arb
    e: arb
    star: arb

    @property
    def log(self) -> arb:
        """Q(ε₀)."""
        return (self.e / self.star).log()

    def c(self, n: int) -> arb:
        return coefficient_values(n, self.b, self.b / self.a, balls)[n]


def exact(a: fmpq, b: fmpq) -> Exact:
    found = solve(a, b, 75)
    p, q = arb(a), arb(b)
    k, r = (p * q).sqrt(), (q / p).sqrt()
    star = 2 * (p / (p + q)).sqrt() * (-k * (arb.pi() + (q / (p + q)).sqrt().asin())).exp()
    return Exact(p, q, k, r, found.phase, found.defect, star)


def slope(x: Exact) -> arb:
    """dε/dγ at γ = 0 from ∂F/∂γ (an integral that is elementary there) and f."""
    s = x.e.sin()
    root = (x.a + x.b * s * s).sqrt()
    arc = ((x.a / (x.a + x.b)).sqrt() * x.e.cos() / s).asinh()
    rest = root * x.e.cos() / (x.a * s * s)
    by_gamma = -((x.a - x.b - 2 * x.a * x.b) / x.a**1 / x.a.sqrt() * arc + rest)
    by_gamma /= 4 * x.b * x.b.sqrt()
    return by_gamma * root * x.b.sqrt() * s / (1 - x.b * s * s)


def kroot(b: arb, kappa: arb) -> c.Root:
    return c.root_by_kappa(b, kappa, balls)


BY_KAPPA: dict[str, tuple[Callable[[arb, arb], arb], Callable[[Exact], arb]]] = {
    "leading": (lambda b, h: c.by_kappa(b, h, balls).leading, lambda x: x.star),
    "root": (lambda b, h: kroot(b, h).defect, lambda x: x.e),
    "phase": (lambda b, h: c.phase_by_kappa(b, h), lambda x: x.phase),
    "rate": (lambda b, h: c.exponent_rate(*kroot(b, h), balls), lambda x: x.log / x.e**2),
    "bend": (
        lambda b, h: c.exponent_bend(*kroot(b, h), balls),
        lambda x: (x.log / x.e**2 - x.c(1)) / x.e**2,
    ),
    "twist": (
        lambda b, h: c.exponent_twist(*kroot(b, h)),
        lambda x: (x.log / x.e**2 - x.c(1) - (x.c(2) - 5 * x.c(1) ** 2 / 2) * x.e**2) / x.e**4,
    ),
    "first excess": (
        lambda b, h: c.first_excess(kroot(b, h), balls),
        lambda x: (x.e / x.star - 1) / x.star**2,
    ),
    "second excess": (
        lambda b, h: c.second_excess(kroot(b, h), balls),
        lambda x: (x.e / x.star - 1 - x.c(1) * x.star**2) / x.star**4,
    ),
    "third excess": (
        lambda b, h: c.third_excess(kroot(b, h), balls),
        lambda x: (x.e / x.star - 1 - x.c(1) * x.star**2 - x.c(2) * x.star**4) / x.star**6,
    ),
    "leading square": (
        lambda b, h: c.leading_square_over(b, h, balls),
        lambda x: (x.star * x.k) ** 2,
    ),
    "defect": (lambda b, h: c.defect_over_kappa(b, h, balls), lambda x: x.e * x.k),
    "slope rest": (
        lambda b, h: c.slope_rest(b, h, balls),
        lambda x: (-4 * x.b * x.e * slope(x) - 1) / x.e**2 / x.k,
    ),
    "printed": (
        lambda b, h: c.printed_excess(b * h, balls),
        lambda x: (printed.asymptotic_defect(x.a, x.b, balls) / x.star).log() / (x.b * x.r**2),
    ),
    "far sweep": (
        lambda b, h: c.far_difference(b, h, c.phase_by_kappa(b, h), arb(4), balls),
        lambda x: x.k * (x.phase - uniform.swept_phase(arb(4), x.k, x.r, balls)),
    ),
    "far error": (
        lambda b, h: c.far_sweep_error(b, h, arb(4), balls),
        lambda x: uniform.balanced(x.a, x.b, balls) / x.e - 1,
    ),
    "far Newton": (
        lambda b, h: c.far_newton_excess(b, h, c.phase_by_kappa(b, h), arb(4), balls),
        lambda x: -x.k * (x.phase - uniform.newton_phase(arb(4), x.k, x.r, balls)),
    ),
}

BY_ROOT: dict[str, tuple[Callable[[Any, Any, Any], Any], Callable[[Exact], arb]]] = {
    "leading": (lambda b, k, m: c.by_root(b, k, m).leading, lambda x: x.star),
    "phase": (lambda b, k, m: c.phase_over(b, k), lambda x: x.phase),
    "cotangent": (lambda b, k, m: c.cotangent(b, k, c.phase_over(b, k), m), lambda x: x.e.cot()),
    "gap": (lambda b, k, m: c.cubic_gap(b, k, m)[0], lambda x: x.e - x.star),
    "cube": (
        lambda b, k, m: c.cubic_gap(b, k, m)[1],
        lambda x: (x.star / 2) ** 3 * (1 + x.r**2).sqrt() ** 3,
    ),
    "sweep": (
        lambda b, k, m: c.sweep_error(b, k, arb(4), m),
        lambda x: uniform.balanced(x.a, x.b, balls) / x.e - 1,
    ),
}

ROUGH = {"far Newton", "twist", "third excess"}
"""Enclosures that are balls at a point too."""


def holds(ball: arb, truth: arb, name: str) -> bool:
    """The truth is in the ball, which says something; a planted error is not."""
    narrow = ball.rad() < abs(truth) * arb("1e-9") or name in ROUGH
    off = truth + 3 * ball.rad() + abs(truth) * arb("1e-6")
    return bool(ball.overlaps(truth) and narrow and ball.is_finite() and not ball.overlaps(off))


def test_in_b_and_kappa() -> None:
    for shape, name in product(SHAPES, BY_KAPPA):
        function, truth = BY_KAPPA[name]
        with ball_precision(WORK):
            x = exact(*shape)
            assert holds(function(x.b, 1 / x.k), truth(x), name)
        with ball_precision(80):
            wide = arb(x.b.mid(), "1e-4"), arb((1 / x.k).mid(), "1e-4")
            whole = function(*wide)
        for shift in (fmpq(0), fmpq(1, 10**4) * fmpq(9, 10)):
            with ball_precision(WORK):
                inner = exact(shape[0], shape[1] - shift)
                if abs(1 / inner.k - wide[1].mid()) < wide[1].rad():
                    assert whole.overlaps(truth(inner))


def test_in_b_and_k_with_slopes() -> None:
    for shape, name in product(
        [*SHAPES, (fmpq(1, 50), fmpq(1, 2)), (fmpq(10), fmpq(1, 500))], BY_ROOT
    ):
        function, truth = BY_ROOT[name]
        with ball_precision(WORK):
            x = exact(*shape)
            assert holds(function(x.b, x.k, balls), truth(x), name)
            b, k, step = x.b.mid(), x.k.mid(), arb((1, -60))
            found = function(*coordinates((b, k)), gradients)
            assert isinstance(found, Gradient)
            assert found.value.overlaps(function(b, k, balls))
            for i, (db, dk) in enumerate(((step, 0), (0, step))):
                rise = function(b + db, k + dk, balls) - function(b - db, k - dk, balls)
                assert abs(rise / (2 * step) - found.slopes[i]) < 1e-12 * (1 + abs(found.value))


@pytest.mark.parametrize("shape", SHAPES, ids=str)
def test_in_the_other_charts(shape: tuple[fmpq, fmpq]) -> None:
    with ball_precision(WORK):
        x = exact(*shape)
        assert holds(c.root_by_k(x.k, 1 / x.a, balls).defect, x.e, "")
        for order in (0, 1):
            gap, power = c.gap_over(x.a, x.b.sqrt(), order, balls)
            series = 1 + order * x.c(1) * x.star**2
            assert holds(gap, x.e - x.star * series, "")
            assert holds(power, x.star ** (2 * order + 3), "")
        assert abs(slope(x) / defect_slope(*shape) - 1) < 1e-30


@pytest.mark.parametrize("shape", SHAPES, ids=str)
def test_the_error_of_newton_s_step_is_held(shape: tuple[fmpq, fmpq]) -> None:
    with ball_precision(WORK):
        x = exact(*shape)
        truth = uniform.one_step(x.a, x.b, balls) / x.e - 1
        found = c.newton_error(x.b, x.k, arb(4), balls)
        assert found.overlaps(truth)
        assert not found.overlaps(2 * truth + found.rad() * 3)


def test_a_hull_of_ends_takes_the_least_of_an_even_function() -> None:
    for x in (arb(0, 1), arb("0.2", "0.5"), arb(1, "0.5")):
        hull = c._between_ends(x, lambda t: t * t)
        for part in (-1, 0, 1):
            assert hull.overlaps((x.mid() + part * x.rad()) ** 2)
        assert hull.contains(0) is bool(x.contains(0))


@pytest.mark.parametrize("x", ["0", "1e-9", "0.3", "-2", "0 +/- 0.5", "1 +/- 0.2", "-0.1 +/- 0.3"])
def test_hyperbolic_quotients_over_balls(x: str) -> None:
    with ball_precision(100):
        ball = arb(x)
        sine, jet = c.hyperbolic_sine_over(ball), c.hyperbolic_sine_over(coordinates((ball,))[0])
        for part in (-1, arb("-0.4"), arb("0.7"), 1):
            point = (ball.mid() + part * ball.rad()).mid()
            if point != 0:
                assert sine.overlaps(point.sinh() / point)
                assert jet.value.overlaps(point.sinh() / point)
                rate = (point.cosh() - point.sinh() / point) / point
                assert jet.slopes[0].overlaps(rate)
            if ball >= 0 and point > 0:
                assert c.hyperbolic_tangent_over(ball).overlaps(point.tanh() / point)
        assert not sine.overlaps(sine.upper() + arb("1e-9"))


def test_the_flat_function_and_its_slope_at_the_edge() -> None:
    rate = arb(3)
    assert c.flat(arb(0), rate) == 0
    for high in ("0.1", "1", "1.5", "4"):
        box = arb(0).union(arb(high))
        value, jet = c.flat(box, rate), c.flat(coordinates((box,))[0], rate)
        for part in (1, 2, 5, 10):
            x = arb(high) * part / 10
            assert value.overlaps((-3 / x).exp())
            assert jet.slopes[0].overlaps(3 / x**2 * (-3 / x).exp())
        assert value.contains(0)
        assert value.upper() < 1.01 * (-3 / arb(high)).exp() + arb("1e-9")


def test_errors_of_angles_and_tangents() -> None:
    with ball_precision(WORK):
        x = exact(*SHAPES[1])
        difference = arb("0.01")
        error = c.tangent_error(difference, x.phase, x.k, balls)
        sinhs = [(x.k * p).sinh() for p in (x.phase, x.phase - difference)]
        assert error.overlaps(sinhs[0] / sinhs[1] - 1)
        angle = (x.e.tan() * (1 + error)).atan()
        assert c.angle_error(error, x.e.cot(), balls).overlaps(angle / x.e - 1)
        tau, half = c.growth(x.b, 1 / x.k, balls)
        for n in range(1, 6):
            assert abs(x.c(n)) * x.star ** (2 * n) < half * tau**n / (2 * n + 1)


# -- what is trusted ------------------------------------------------------------------------------

NAMED = {name: f for name, f in vars(c).items() if isinstance(f, Named)}
COUNT = {"flat": 2, "phase_over": 2, "phase_by_kappa": 2, "exponent_twist": 3}
COUNT |= {"phase_bend": 4, "far_bend": 4}


def test_a_named_function_contains_what_it_means() -> None:
    """At exact points and over balls, where what it asks for is not negative."""
    for name, radius in product(NAMED, ["0", "1/100", "1/7"]):
        function, count = NAMED[name], COUNT.get(name, 1)
        names = [symbol(x) for x in "wxyz"[:count]]
        for at in product((fmpq(1, 5), fmpq(1, 2), fmpq(9, 10), fmpq(7, 3)), repeat=count):
            with ball_precision(128):
                wide = [arb(x) + arb(0, 1) * arb(as_rational(radius)) for x in at]
                point = dict(zip("wxyz", map(arb, at), strict=False))
                rooms = (evaluate(e, point) for e in function.asks(*names))
                if any(room < 0 for room in rooms):
                    continue
                found = function(*wide)
                if function.meaning is not None:
                    value = evaluate(function.meaning(*names), point)
                    assert not found.is_finite() or found.overlaps(value)
                    continue
                low, high = (evaluate(end, {}) for end in function.between)
                image = function.image(symbol("p"), *names)
                if at[0] > 1:  # b is 1 at most
                    continue
                start = low
                for _ in range(200):
                    start = evaluate(image, {**point, "p": start.mid()})
                assert low < start < high
                assert found.overlaps(arb(start.mid()) + arb(0, 1) * arb(2) ** -100)


def test_every_trusted_root_contains_no_other_number() -> None:
    with ball_precision(128):
        assert c.phase_by_kappa(arb(1), arb(1)).rad() < 1e-20
        assert c.phase_over(arb(1), arb(1)).rad() < 1e-20
        assert not c.flat_over(arb(4)).is_finite()
