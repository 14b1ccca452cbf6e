"""An expression run in balls, gradients and germs: three arithmetics, one function."""

from __future__ import annotations

import pytest
from flint import arb, fmpq

from tresym.reals.balls.germ import Germs, LogarithmError, RamifiedError, UnresolvedError
from tresym.reals.balls.gradient import coordinates, gradients
from tresym.reals.balls.run import formula
from tresym.reals.language.expression import differentiate
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.arithmetic import ball_precision, balls
from tresym.reals.places.values import evaluate

SMOOTH = [
    "x**3 - 2*x**(-2) + x**(5/2) - x**(1/3)/x**(3/7)",
    "sqrt(x + 2)*exp(-x)*log(3 + x)",
    "sin(x)*cos(2*x)/tan(x/2) + cot(x)*sec(x) - csc(x)",
    "asin(x/3) + acos(x/4) - atan(x)",
    "sinh(x)/cosh(x)*tanh(x) + coth(x)*sech(x)*csch(x)",
    "asinh(x) - acosh(2 + x) + atanh(x/5)",
    "abs(x - 3)*sign(x - 3) + cbrt(x - 2)",
    "(1 + x)**(x - 2) + pi**x + 2**(1/x)",
    "exp(exp(x)) - 1",
    "(x + 1)*(x + 1)*(x + 1) + (x + 1)**3",
]

AT_ZERO = [
    "(1 - cos(x))/x**2",
    "log((1 + x)/(1 - x))/x",
    "exp(1/x)*x**4 - exp(1/x + x)",
    "exp(exp(-1/x)) - 1",
    "2*exp(exp(-1/x)) - 2 + exp(-3/x)",
    "(1 + exp(-1/x))**x - 1",
    "sqrt(1 + exp(-2/x)) - 1",
    "log(1 + exp(-1/x))*exp(1/x)",
    "log(exp(1/x) + 2) - 1/x",
    "tanh(1/x) - 1",
    "asinh(exp(1/x)) - sinh(x)",
    # arcs whose argument tends to ±1
    "acos(1 - x**2) - 3*asin(x**2 - 1)",
    "acos(-1/(1 + x**2))",
    # waves whose argument tends to a multiple of π/2
    "sin(pi + x)/x + sin(x - 3*pi/2)",
    "cos(pi/2 + x)/x + cos(5*pi/2 - x)/x",
    "cos(3*pi/2 + x)/x - cos(x - pi)",
    "cos(-pi/2 - x)/x + sin(2*pi + x)/x",
    "tan(pi/2 - x)*x + tan(pi + x)/x + tan(x - 3*pi/2)",
    "sin(pi/3 + x) - cos(x - pi/5)",
    "cot(x)*x + csc(x)*x - sec(x)",
    "abs(x - x**2) + sign(x - 2*x**2) - sign(-x)",
    "cbrt(x**3 - x**4) + cbrt(-8 + x) + (x**2 + x**3)**(1/2)",
    "x**2*sin(1/x) + 3",
]


@pytest.mark.parametrize("text", SMOOTH)
@pytest.mark.parametrize("at", ["3/10", "7/5", "5/2"])
def test_gradients_have_the_value_and_the_derivative(text: str, at: str) -> None:
    """The derivative by rules on the expression, at a point and over a ball about it."""
    e, point = parse(text), arb(fmpq(*map(int, at.split("/"))))
    with ball_precision(120):
        value, slope = (evaluate(part, {"x": point}) for part in (e, differentiate(e, "x")))
        assert value.is_finite()
        for radius in ("0", "0.001"):
            (x,) = coordinates((point + arb(0, radius),))
            found = formula(e, "x")(x, gradients)
            assert found.value.overlaps(value)
            assert found.slopes[0].overlaps(slope)
            assert found.value.contains(value) or radius == "0"
        assert formula(e, "x")(point, balls).overlaps(value)


@pytest.mark.parametrize("text", AT_ZERO)
def test_germs_contain_the_values(text: str) -> None:
    e = parse(text)
    with ball_precision(200):
        field = Germs(fmpq(1, 16), 6)
        germ = formula(e, "x")(field.x, field)
        for k in range(1, 17):
            x = arb(fmpq(k, 256))
            with ball_precision(1200):
                value = evaluate(e, {"x": x})
            at = field.germ(germ)
            exponent = sum((_ball(p) / x**j for j, p in enumerate(at.exponent)), start=arb(0))
            assert value.is_finite()
            assert (at.range() * x**at.power * exponent.exp()).contains(value)


def _ball(p: object) -> arb:
    return Germs(fmpq(1)).constant(p).leading


@pytest.mark.parametrize(
    ("text", "power", "leading"),
    [
        # exact zeros: what cancels to all powers, or at a multiple of π/2, leaves its next term
        ("sin(pi + x)", 1, "-1"),
        ("cos(3*pi/2 + x)", 1, "1"),
        ("cos(pi/2 - x)", 1, "1"),
        ("tan(2*pi + x)", 1, "1"),
        ("tan(pi/2 + x)", -1, "-1"),
        ("acos(1 - x**2/2)", 1, "1"),
        ("pi - acos(x**2/2 - 1)", 1, "1"),
        ("exp(exp(-1/x)) - 1", 0, "1"),
        ("(1 + exp(-1/x))**5 - 1", 0, "5"),
        ("1 - tanh(1/x)", 0, "2"),
    ],
)
def test_the_leading_term_is_not_lost(text: str, power: int, leading: str) -> None:
    with ball_precision(128):
        field = Germs(fmpq(1, 64), 6)
        germ = formula(parse(text), "x")(field.x, field)
        assert germ.power == power
        assert germ.leading.overlaps(arb(leading))
        assert germ.leading.rad() < 1e-3


REFUSED = {
    "1/(x - x)": UnresolvedError,
    "(x - x)**(-2)": UnresolvedError,
    "sqrt(-x**2)": UnresolvedError,
    "sqrt(-4 + x)": UnresolvedError,
    "(x - 1)**(1/3)": UnresolvedError,
    "sign(sin(1/x))": UnresolvedError,
    "cbrt(x*sin(1/x))": UnresolvedError,
    "abs(1/3 - 8*x)": UnresolvedError,
    "acos(1 + x**2)": UnresolvedError,
    "asin(1 + x)": UnresolvedError,
    "log(cos(1/x))": UnresolvedError,
    "(-2 + x)**x": UnresolvedError,
    "sqrt(x)": RamifiedError,
    "cbrt(x)": RamifiedError,
    "acos(1 - x)": RamifiedError,
    "x**x": LogarithmError,
    "log(x)": LogarithmError,
    "asinh(1/x)": LogarithmError,
}


@pytest.mark.parametrize("text", REFUSED)
def test_no_germ_where_a_sign_or_a_zero_is_not_certain(text: str) -> None:
    with ball_precision(100):
        field = Germs(fmpq(1, 4), 6)
        with pytest.raises(REFUSED[text]):
            formula(parse(text), "x")(field.x, field)


@pytest.mark.parametrize("text", ["sqrt(x - 2)", "log(x - 2)", "asin(x + 2)", "(x - 2)**(1/3)"])
def test_what_is_not_defined_has_no_finite_value(text: str) -> None:
    run = formula(parse(text), "x")
    with ball_precision(64):
        assert not run(arb(1), balls).is_finite()
        found = run(coordinates((arb(1),))[0], gradients)
        assert not found.value.is_finite()


@pytest.mark.parametrize("text", ["sign(x)", "cbrt(x)"])
def test_no_gradient_across_a_change_of_sign(text: str) -> None:
    with ball_precision(64):
        found = formula(parse(text), "x")(coordinates((arb(0, 1),))[0], gradients)
        assert not found.slopes[0].is_finite()
