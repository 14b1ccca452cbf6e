"""Laurent expansions: against functions that are known, and what has none."""

import pytest
from flint import arb, fmpq

from tresym.reals.decisions.hypergeometric import OpenError
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.expansions.laurent import SIZE, germ_of
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.arithmetic import ball_precision

HAVE = [
    *("exp(y)", "log(1 + y)", "sin(y)", "cos(2*y)", "tan(y)", "cot(y)", "sec(y)", "csc(y)"),
    *("sinh(y)", "cosh(y)", "tanh(y)", "coth(y)", "sech(y)", "csch(y)", "atan(y)", "asin(y)"),
    *("asinh(y)", "atanh(y/2)", "sqrt(4 + y)", "1/(1 - y)", "y/(exp(y) - 1)", "exp(sin(y))"),
    *("log(cos(y))", "log(sin(y)/y)", "1/(y - sin(y))", "(1 + y)**(-2/3)", "cot(y) - 1/y"),
]


@pytest.mark.parametrize("text", HAVE)
def test_the_coefficients_give_the_value(text: str) -> None:
    e, y = parse(text), fmpq(1, 100)
    germ = germ_of(e, "y")
    assert germ.series[0]
    with ball_precision(200):
        terms = (arb(c) * arb(y) ** (germ.order + k) for k, c in enumerate(germ.series))
        gap = abs(sum(terms, arb(0)) - evaluate(e, {"y": y}))
        assert gap < arb(10) ** -(SIZE - 8)


@pytest.mark.parametrize(
    "text", ["exp(1 + y)", "log(y)", "sqrt(y)", "sqrt(2 + y)", "abs(y)", "exp(1/y)", "a*y", "pi*y"]
)
def test_what_has_no_expansion_with_rational_coefficients(text: str) -> None:
    with pytest.raises(OpenError):
        germ_of(parse(text), "y")


def test_the_root_of_a_square_is_no_power() -> None:
    with pytest.raises(OpenError):
        germ_of(parse("sqrt(y**2 + y**4)"), "y")


def test_no_coefficient_is_given_that_is_not_known() -> None:
    germ = germ_of(parse("(exp(y) - 1 - y - y**2/2)/y**3"), "y")
    assert germ[0] == fmpq(1, 6)
    with pytest.raises(OpenError):
        germ[SIZE]
