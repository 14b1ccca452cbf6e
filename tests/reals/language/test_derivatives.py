"""Derivatives: the slope of each function, and the rules, against values."""

import mpmath
import pytest
from flint import arb, fmpq

from tresym.reals.domain.evaluation import evaluate
from tresym.reals.functions.table import TABLE
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import FUNCTIONS, apply, symbol
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.arithmetic import ball_precision, mp_precision

x = symbol("x")


def test_every_function_has_a_derivative() -> None:
    for name, row in TABLE.items():
        assert name == row.name
        assert len(row.derivatives) == row.arity


PLACES = {"acosh": "17/10", "coth": "7/5", "log": "3/2"}


@pytest.mark.parametrize("name", sorted(FUNCTIONS - {"cbrt", "sign"}))
def test_slopes_agree_with_mpmath(name: str) -> None:
    p, q = map(int, PLACES.get(name, "-3/5").split("/"))
    with mp_precision(60) as m, ball_precision(200):
        f = m.fabs if name == "abs" else getattr(m, name)
        expected = arb(mpmath.nstr(m.diff(f, m.mpf(p) / q), 30))
        slope = evaluate(differentiate(apply(name, x), "x"), {"x": arb(fmpq(p, q))})
        assert abs(slope - expected) < 1e-20


RULES = [
    ("x**3*sin(x)", "3*x**2*sin(x) + x**3*cos(x)"),
    ("x/y", "1/y"),
    ("y/x", "-y/x**2"),
    ("x**y", "y*x**(y - 1)"),
    ("y**x", "y**x*log(y)"),
    ("x**x", "x**x*(log(x) + 1)"),
    ("exp(x**2*y)", "2*x*y*exp(x**2*y)"),
    ("sqrt(1 + x**2)", "x/sqrt(1 + x**2)"),
    ("cbrt(x)", "x**(-2/3)/3"),
    ("log(sin(x))", "cos(x)/sin(x)"),
    ("y*pi + 3", "0*x"),
    ("sign(x) + 2*x", "2"),
]


@pytest.mark.parametrize(("text", "derivative"), RULES)
def test_rules_of_derivatives(text: str, derivative: str) -> None:
    found = differentiate(parse(text), "x")
    for a, b in ((fmpq(2, 3), fmpq(5, 4)), (fmpq(9, 4), fmpq(1, 3))):
        at = {"x": arb(a), "y": arb(b)}
        assert abs(evaluate(found, at) - evaluate(parse(derivative), at)) < 1e-10
