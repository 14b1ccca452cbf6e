"""Derivatives and integrals as they are written in a claim."""

import sympy as sp

from tresym.reals.decisions.claim_parsing import read
from tresym.reals.language.parsing import parse

x, y = sp.symbols("x y", real=True)


def test_a_derivative_keeps_what_is_differentiated() -> None:
    (comparison,) = read("diff(log(x), x) == 1/x").comparisons
    assert comparison.differentiated == (parse("log(x)"),)
    (comparison,) = read(sp.Eq(sp.Derivative(sp.log(x), x), 1 / x)).comparisons
    assert comparison.differentiated == (parse("log(x)"),)


def test_an_integral_without_ends_is_a_claim_of_a_derivative() -> None:
    one, other = read("integral(f*exp(x), x) == y"), read("2*integral(x, x) + x == x**2")
    assert str(one.comparisons[0].right) == "f*exp(x)"
    assert one.comparisons[0].derivatives[0].by == "x"
    (comparison,) = other.comparisons
    assert comparison.right == parse("2*x")
    assert comparison.differentiated == (parse("-x + x**2"),)
