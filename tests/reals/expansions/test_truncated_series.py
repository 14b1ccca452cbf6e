"""Sums and products of coefficients, joined in their shortest form."""

import pytest
from flint import fmpq

from tresym.reals.expansions.truncated_series import plus, raised, times
from tresym.reals.language.expression import Expr
from tresym.reals.language.parsing import parse


@pytest.mark.quick
@pytest.mark.parametrize(
    ("form", "expected"),
    [
        (lambda: times(parse("sqrt(2)*x"), parse("sqrt(2)/x")), "2"),
        (lambda: times(parse("exp(x)"), parse("exp(-x)*y")), "y"),
        (lambda: plus(parse("x - y"), parse("2*y - x")), "y"),
        (lambda: raised(parse("sqrt(2)/2"), fmpq(-1)), "sqrt(2)"),
        (lambda: raised(parse("(x**2)"), fmpq(1, 2)), "sqrt(x**2)"),  # |x|, and not x
        (lambda: raised(parse("8"), fmpq(1, 2)), "sqrt(8)"),
        (lambda: raised(parse("exp(x)"), fmpq(1, 2)), "exp(x/2)"),
    ],
)
def test_coefficients_are_joined(form: object, expected: str) -> None:
    found: Expr = form()  # type: ignore[operator]
    assert found == parse(expected)
