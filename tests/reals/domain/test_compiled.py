"""Integrands: in complex balls the same functions as in real ones, and nothing where undefined."""

import pytest
from flint import acb, arb, fmpq

from tresym.reals.domain.compiled import MEROMORPHIC, Compiled
from tresym.reals.domain.evaluation import UndefinedError, evaluate
from tresym.reals.language.binders import integral
from tresym.reals.language.expression import FUNCTIONS, Expr, apply, number, symbol
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.arithmetic import ball_precision


def of_x(e: Expr) -> Compiled:
    return Compiled(e, "x", lambda part: evaluate(part, {"y": arb(2)}))


@pytest.mark.parametrize(
    "text", ["x**2 + y*x + y", "x/y - y/x", "sqrt(x*y)", "x**y", "sin(x*y)/(x + y)**3", "abs(-x)"]
)
def test_the_steps_come_to_what_the_tree_does(text: str) -> None:
    e, here = parse(text), fmpq(5, 7)
    with ball_precision(128):
        found = of_x(e)(acb(here), False)
        assert found.real.overlaps(evaluate(e, {"x": here, "y": fmpq(2)}))
        assert found.real.rel_accuracy_bits() > 100
        assert found.imag.is_zero()


@pytest.mark.parametrize("text", ["sqrt(-x)", "1/(x - x)", "tanh(log(x - 1))", "tanh(1/(x - 1))"])
def test_nothing_comes_of_a_step_that_is_undefined(text: str) -> None:
    assert not of_x(parse(text)).real(arb(1)).is_finite()
    assert not of_x(parse(text))(acb(1, 1), False).is_finite()


def test_a_part_that_binds_the_variable_is_no_integrand() -> None:
    inner = integral(parse("x*z"), "z", number(0), number(1))
    with pytest.raises(UndefinedError):
        of_x(inner)


HOLOMORPHIC = ("x**2", "x**(-3)", "sqrt(x)", "x**(5/3)", "x**pi", "log(x)", "pi*x + 1/2", "abs(x)")


@pytest.mark.parametrize("text", [*HOLOMORPHIC, *(f"{name}(x)" for name in sorted(MEROMORPHIC))])
def test_in_the_complex_numbers_it_is_the_same_function(text: str) -> None:
    e, here = parse(text), fmpq(3, 7)
    with ball_precision(128):
        found = of_x(e).holomorphic(acb(here))
        assert found.real.overlaps(evaluate(e, {"x": here}))
        assert found.real.rel_accuracy_bits() > 90
        assert found.imag.contains(0)
        turned = of_x(e).holomorphic(acb(0, 1))
        if text in ("sqrt(x)", "exp(x)", "cos(x)"):
            assert not turned.imag.is_zero() or text == "cos(x)"


CUTS = {
    "atan": ((0, 2), (0, -3)),
    "asinh": ((0, 2), (0, -3)),
    "asin": ((2, 0), (-3, 0)),
    "acos": ((2, 0), (-3, 0)),
    "atanh": ((2, 0), (-3, 0)),
    "acosh": ((fmpq(1, 2), 0), (-3, 0)),
    "sign": ((0, 1), (0, -2)),
    "cbrt": ((0, 1), (0, -2)),
}
"""Points on the branch cuts of each function."""


@pytest.mark.parametrize("name", sorted(FUNCTIONS - MEROMORPHIC - {"abs", "log"}))
def test_what_is_not_holomorphic_everywhere_is_not_taken_for_it(name: str) -> None:
    for real, imaginary in CUTS[name]:
        small = arb(0, "1e-9")
        there = acb(arb(real) + small, arb(imaginary) + small)
        assert not of_x(apply(name, symbol("x"))).holomorphic(there).is_finite()


@pytest.mark.parametrize("name", sorted(CUTS))
def test_off_its_cuts_a_function_is_differentiable(name: str) -> None:
    """Its values at the corners of a small square satisfy the equations of Cauchy and Riemann."""
    f = of_x(apply(name, symbol("x")))
    with ball_precision(200):
        for z in (acb(2, 3), acb(-2, fmpq(1, 3)), acb(fmpq(1, 2), -1)):
            if not f.holomorphic(z).is_finite():
                continue
            h = acb(fmpq(1, 10**20))
            across = (f.holomorphic(z + h) - f.holomorphic(z - h)) / (2 * h)
            i = acb(0, 1)
            along = (f.holomorphic(z + i * h) - f.holomorphic(z - i * h)) / (2 * i * h)
            assert abs(across - along) < fmpq(1, 10**18)


@pytest.mark.parametrize("text", ["sqrt(x)", "x**(1/3)", "log(x)", "x**pi", "1/x", "abs(x)"])
def test_a_ball_on_a_cut_has_no_holomorphic_value(text: str) -> None:
    wide = acb(arb(0, 1), arb(0, 1))
    assert not of_x(parse(text)).holomorphic(wide).is_finite()
