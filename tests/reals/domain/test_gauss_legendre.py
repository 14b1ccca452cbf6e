"""The Gauss–Legendre rule: mpmath's values lie in the balls; none where nothing is analytic."""

import mpmath
import pytest
from flint import arb, fmpq

from tresym.reals.domain.compiled import Compiled
from tresym.reals.domain.gauss_legendre import integral
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.arithmetic import ball_precision, mp_precision

ANALYTIC = {
    "1/(1 + x**2)": lambda x: 1 / (1 + x**2),
    "exp(-x)*cos(9*x)": lambda x: mpmath.exp(-x) * mpmath.cos(9 * x),
    "sqrt(x + 1/50)": lambda x: mpmath.sqrt(x + mpmath.mpf(1) / 50),
    "1/sqrt(2 - x**2)": lambda x: 1 / mpmath.sqrt(2 - x**2),
    "(1 + x)**pi/(x + 2)**3": lambda x: (1 + x) ** mpmath.pi / (x + 2) ** 3,
    "tanh(8*x - 3)": lambda x: mpmath.tanh(8 * x - 3),
    "pi*sqrt(2)*x": lambda x: mpmath.pi * mpmath.sqrt(2) * x,
    "log(3)/pi": lambda _: mpmath.log(3) / mpmath.pi,
    "abs(x - 2)": lambda x: 2 - x,
    "log(1 + 1/(x + 1/9))": lambda x: mpmath.log(1 + 1 / (x + mpmath.mpf(1) / 9)),
}


@pytest.mark.parametrize("text", ANALYTIC)
@pytest.mark.parametrize("accuracy", [3, 8, 20, 100])
def test_the_ball_contains_what_mpmath_finds(text: str, accuracy: int) -> None:
    with mp_precision(45):
        value = str(mpmath.quad(ANALYTIC[text], [0, 0.25, 0.5, 0.75, 1]))
    with ball_precision(128):
        found = integral(Compiled(parse(text), "x"), arb(0), arb(1), accuracy)
        assert found is not None
        assert found.overlaps(arb(value) + arb(0, 1e-38))
        assert found.rad() < arb((1, 6 - accuracy))


def test_a_piece_is_only_left_out_where_the_integrand_is_negligible() -> None:
    with ball_precision(128):
        falling = integral(Compiled(parse("exp(-cosh(x))"), "x"), arb(0), arb(32), 60)
        assert falling is not None
        assert falling.overlaps(arb("0.4210244382407083333356274", 1e-24))  # besselk(0, 1)
        assert falling.rad() < arb((1, -52))
        assert integral(Compiled(parse("1/(x - 8)"), "x"), arb(0), arb(32), 60) is None


@pytest.mark.parametrize(
    ("text", "value"), [("abs(x - 1/3)", fmpq(5, 18)), ("sign(x - 1/3)", fmpq(1, 3))]
)
def test_a_kink_or_jump_lies_in_a_piece_that_is_small_enough(text: str, value: fmpq) -> None:
    with ball_precision(128):
        found = integral(Compiled(parse(text), "x"), arb(0), arb(1), 60)
        assert found is not None
        assert found.contains(value)
        assert found.rad() < arb((1, -50))


def test_ends_may_be_balls() -> None:
    with ball_precision(128):
        wide = integral(Compiled(parse("x**2"), "x"), arb(0), arb(1, 0.125), 60)
        assert wide is not None
        assert wide.contains(arb(fmpq(7, 8)) ** 3 / 3)
        assert wide.contains(arb(fmpq(9, 8)) ** 3 / 3)


@pytest.mark.parametrize(
    "text",
    ["1/(x - 1/3)", "1/(3*x - 1)**2",
     "log(x)", "sqrt(x - 1/3)", "tan(2*x)", "asin(2*x)", "(x - 1/3)**(2/3)", "1/sinh(x)",
     "exp(-1/(x - 1/3)**2)", "x**x"],
)  # fmt: skip
def test_nothing_is_said_where_the_integrand_is_not_bounded_or_not_defined(text: str) -> None:
    with ball_precision(128):
        assert integral(Compiled(parse(text), "x"), arb(0), arb(1), 60) is None
