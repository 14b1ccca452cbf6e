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


def test_ends_may_be_balls() -> None:
    with ball_precision(128):
        wide = integral(Compiled(parse("x**2"), "x"), arb(0), arb(1, 0.125), 60)
        assert wide is not None
        assert wide.contains(arb(fmpq(7, 8)) ** 3 / 3)
        assert wide.contains(arb(fmpq(9, 8)) ** 3 / 3)


@pytest.mark.parametrize(
    "text",
    ["abs(x - 1/3)", "sign(x - 1/3)", "sqrt((x - 1/3)**2)", "1/(x - 1/3)", "1/(3*x - 1)**2",
     "log(x)", "sqrt(x - 1/3)", "tan(2*x)", "asin(2*x)", "(x - 1/3)**(2/3)", "1/sinh(x)",
     "exp(-1/(x - 1/3)**2)", "x**x"],
)  # fmt: skip
def test_nothing_is_said_where_the_integrand_is_not_analytic(text: str) -> None:
    with ball_precision(128):
        assert integral(Compiled(parse(text), "x"), arb(0), arb(1), 60) is None
