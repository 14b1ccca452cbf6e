"""Slopes in balls: true derivatives over whole boxes, and nothing finite where there are none."""

from collections.abc import Callable
from fractions import Fraction
from itertools import product
from typing import Any

import mpmath
import pytest
from flint import arb, ctx, fmpq
from hypothesis import given
from hypothesis import strategies as st

from tresym.reals.balls.gradient import (
    Divided,
    Gradient,
    coordinates,
    gradients,
    taylor_coefficients,
)
from tresym.reals.numbers.arithmetic import ball_precision, balls

POINTS = {"acosh": "17/10"}
FUNCTIONS = ("sqrt", "exp", "expm1", "log", "log1p", "sin", "cos", "tan", "asin", "acos", "atan")
FUNCTIONS += ("sinh", "cosh", "tanh", "asinh", "acosh", "atanh")


@pytest.mark.parametrize("name", FUNCTIONS)
def test_each_function_has_its_derivative(name: str) -> None:
    """By differentiation in mpmath, to its last digits."""
    at = fmpq(*map(int, POINTS.get(name, "3/10").split("/")))
    with ball_precision(120), mpmath.workdps(40):
        (x,) = coordinates((arb(at),))
        found = getattr(gradients, name)(x)
        point = mpmath.mpf(int(at.p)) / int(at.q)
        for ball, n in ((found.value, 0), (found.slopes[0], 1)):
            exact = arb(str(mpmath.diff(getattr(mpmath.mp, name), point, n)))
            assert abs(ball - exact) < arb(10) ** -20
        assert getattr(gradients, name)(arb(at)).overlaps(found.value)


@pytest.mark.parametrize("name", FUNCTIONS)
def test_slopes_over_a_ball_contain_those_at_its_points(name: str) -> None:
    middle = arb(fmpq(*map(int, POINTS.get(name, "3/10").split("/"))))
    with ball_precision(100):
        (wide,) = coordinates((middle + arb(0, "0.2"),))
        slopes = getattr(gradients, name)(wide).slopes[0]
        assert slopes.is_finite()
        for k in range(-9, 10):
            (x,) = coordinates((middle + arb(fmpq(k, 50)),))
            assert slopes.contains(getattr(gradients, name)(x).slopes[0])


@pytest.mark.parametrize(
    ("formula", "at"),
    [
        (lambda x, m: m.sqrt(x), "0"),
        (lambda x, m: m.sqrt(x * x), "0"),
        (lambda x, m: m.log(x), "0"),
        (lambda x, m: 1 / x, "0"),
        (lambda x, m: x / (x - x), "1/3"),
        (lambda x, m: x**-1 if isinstance(x, arb) else 1 / x**1, "0"),
        (lambda x, m: m.asin(x), "1"),
        (lambda x, m: m.acos(x), "-1"),
        (lambda x, m: m.acosh(x), "1"),
        (lambda x, m: m.atanh(x), "1"),
        (lambda x, m: m.tan(m.pi * x), "1/2"),
    ],
)
def test_no_finite_slope_where_there_is_none(formula: Callable[..., Any], at: str) -> None:
    with ball_precision(64):
        for radius in ("0", "0.01"):
            (x,) = coordinates((arb(fmpq(*map(int, at.split("/")))) + arb(0, radius),))
            assert not formula(x, gradients).slopes[0].is_finite()


def test_the_slope_of_an_absolute_value_across_zero_is_both() -> None:
    with ball_precision(64):
        for x, slopes in ((arb(2, 1), (1,)), (arb(-2, 1), (-1,)), (arb(0, 1), (-1, 0, 1))):
            found = abs(coordinates((x,))[0]).slopes[0]
            assert all(found.contains(slope) for slope in slopes)
            assert found.is_exact() is (len(slopes) == 1)


NUMBERS = st.fractions(-3, 3, max_denominator=6)


@given(st.lists(NUMBERS, min_size=6, max_size=6), NUMBERS, NUMBERS)
def test_polynomials_and_quotients_have_the_slopes_of_algebra(
    c: list[Fraction], x: Fraction, y: Fraction
) -> None:
    """p = c₀ + c₁x + c₂y + c₃x² + c₄xy + c₅y², and p/(1 + x²), against fractions by hand."""
    p = c[0] + c[1] * x + c[2] * y + c[3] * x * x + c[4] * x * y + c[5] * y * y
    slopes = c[1] + 2 * c[3] * x + c[4] * y, c[2] + c[4] * x + 2 * c[5] * y
    w = 1 + x * x
    with ball_precision(80):
        k = [arb(_exact(a)) for a in c]
        u, v = coordinates((arb(_exact(x)), arb(_exact(y))))
        q = k[0] + k[1] * u - (-v) * k[2] + k[3] * u**2 + k[4] * u * v + v * v * k[5]
        quotient = q / (1 + u * u)
        for found, wanted in (
            (q, (p, *slopes)),
            (quotient, (p / w, slopes[0] / w - 2 * x * p / w**2, slopes[1] / w)),
            (2 - q / 3, (2 - p / 3, -slopes[0] / 3, -slopes[1] / 3)),
            (5 / (1 + u**2), (5 / w, -10 * x / w**2, Fraction(0))),
        ):
            for ball, exact in zip((found.value, *found.slopes), wanted, strict=True):
                assert ball.overlaps(arb(_exact(exact)))
                assert ball.rad() < 1e-15


def _exact(x: Fraction) -> fmpq:
    return fmpq(x.numerator, x.denominator)


def test_the_slopes_of_a_box_bound_all_differences() -> None:
    """f(p) − f(q) ∈ Σ slopeᵢ·(pᵢ − qᵢ) for points of the box: what the mean-value form rests on."""

    def f(x: Any, y: Any, m: Any) -> Any:
        return m.exp(x * y) / (2 + m.sin(x)) - abs(y - fmpq(1, 4)) * m.sqrt(1 + x)

    with ball_precision(80):
        sides = arb(fmpq(1, 4), fmpq(1, 4)), arb(fmpq(1, 3), fmpq(1, 6))
        slopes = f(*coordinates(sides), gradients).slopes
        grid = list(product((fmpq(0), fmpq(1, 5), fmpq(1, 2)), (fmpq(1, 6), fmpq(1, 2))))
        for p, q in product(grid, grid):
            gap = f(*map(arb, p), balls) - f(*map(arb, q), balls)
            bound = sum((s * (a - b) for s, a, b in zip(slopes, p, q, strict=True)), start=arb(0))
            assert bound.overlaps(gap)


SERIES = {
    "sin": (lambda s: s.sin(), mpmath.sin),
    "exp": (lambda s: s.exp(), mpmath.exp),
    "log(2 + x)": (lambda s: (2 + s).log(), lambda x: mpmath.log(2 + x)),
}


@pytest.mark.parametrize("name", SERIES)
@pytest.mark.parametrize("at", ["0", "1/3", "-1/2"])
def test_taylor_coefficients_by_mpmath(name: str, at: str) -> None:
    series, function = SERIES[name]
    point = fmpq(*map(int, at.split("/")))
    before = ctx.cap
    with ball_precision(100), mpmath.workdps(40):
        found = taylor_coefficients(series, arb(point), 7)
        wide = taylor_coefficients(series, arb(point, "0.1"), 7)
        expected = mpmath.taylor(function, mpmath.mpf(int(point.p)) / int(point.q), 6)
        for c, over, wanted in zip(found, wide, expected, strict=True):
            assert abs(c - arb(str(wanted))) < 1e-18
            assert over.contains(c)
    assert ctx.cap == before


def test_no_coefficient_where_the_function_is_not_defined_on_all_of_the_ball() -> None:
    with ball_precision(64):
        for series in (lambda s: s.log(), lambda s: 1 / s, lambda s: s.sqrt()):
            assert not any(c.is_finite() for c in taylor_coefficients(series, arb(0, 1), 3)[1:])


DIVIDED = [
    # (h, p, the quotient in mpmath)
    ("sin", 1, lambda x: mpmath.sin(x) / x),
    ("sin", 2, lambda x: (mpmath.sin(x) - x) / x**2),
    ("exp", 3, lambda x: (mpmath.exp(x) - 1 - x - x**2 / 2) / x**3),
    ("log(2 + x)", 1, lambda x: mpmath.log(1 + x / 2) / x),
]


def test_a_divided_function_and_its_slope_by_mpmath() -> None:
    for (name, power, quotient), at in product(
        DIVIDED, ["1/1000000", "1/64", "-1/60", "1/4", "7/20", "-1", "3/2"]
    ):
        divided = Divided(SERIES[name][0], power)
        point = fmpq(*map(int, at.split("/")))
        with ball_precision(100), mpmath.workdps(90):
            x = mpmath.mpf(int(point.p)) / int(point.q)
            value, slope = (arb(str(mpmath.diff(quotient, x, n))) for n in (0, 1))
            assert abs(divided(arb(point)) - value) < 1e-20
            for radius in ("0", "1e-4", "0.03"):
                found = divided(Gradient(arb(point) + arb(0, radius), (arb(1),)))
                assert (found.value - value).contains(0) or abs(found.value - value) < 1e-20
                assert (found.slopes[0] - slope).contains(0) or abs(found.slopes[0] - slope) < 1e-12
                wide = divided(arb(point) + arb(0, radius))
                assert wide.is_finite()
                for k in (-1, 1):
                    assert wide.overlaps(divided(arb(point) + k * arb(radius)))
