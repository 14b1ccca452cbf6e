"""Derivatives: the slope of each function, and the rules, against values."""

import mpmath
import pytest
from cases import cases
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


RULES = cases(__file__, "RULES")


@pytest.mark.parametrize(("text", "derivative"), RULES)
def test_rules_of_derivatives(text: str, derivative: str) -> None:
    found = differentiate(parse(text), "x")
    for a, b in ((fmpq(2, 3), fmpq(5, 4)), (fmpq(9, 4), fmpq(1, 3))):
        at = {"x": arb(a), "y": arb(b)}
        assert abs(evaluate(found, at) - evaluate(parse(derivative), at)) < 1e-10
