"""Integrands: in complex balls the same functions as in real ones, and nothing where undefined."""

import pytest
from flint import acb, arb, fmpq

from tresym.reals.domain.evaluation import UndefinedError, evaluate
from tresym.reals.domain.integrands import MEROMORPHIC, Integrand
from tresym.reals.language.binders import integral
from tresym.reals.language.expression import FUNCTIONS, Expr, apply, number, symbol
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.arithmetic import ball_precision


def of_x(e: Expr) -> Integrand:
    return Integrand(e, "x", lambda part: evaluate(part, {"y": arb(2)}))


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


@pytest.mark.parametrize("name", sorted(FUNCTIONS - MEROMORPHIC - {"abs", "log"}))
def test_what_is_not_holomorphic_everywhere_is_not_taken_for_it(name: str) -> None:
    x = symbol("x")
    assert not of_x(apply(name, x)).holomorphic(acb(fmpq(3, 2))).is_finite()


@pytest.mark.parametrize("text", ["sqrt(x)", "x**(1/3)", "log(x)", "x**pi", "1/x", "abs(x)"])
def test_a_ball_on_a_cut_has_no_holomorphic_value(text: str) -> None:
    wide = acb(arb(0, 1), arb(0, 1))
    assert not of_x(parse(text)).holomorphic(wide).is_finite()
