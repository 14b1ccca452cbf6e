"""Orders as SymPy writes them are read, with the path that they name."""

from __future__ import annotations

import pytest
import sympy

import tresym
from tresym.reals.numbers.exact import InputError

x, r = sympy.symbols("x r")
p = sympy.Symbol("p", positive=True)


@pytest.mark.parametrize(
    ("f", "variable", "point", "terms"),
    [
        (sympy.sin(x), x, 0, 6),
        (sympy.exp(x), x, 1, 3),
        (sympy.sqrt(r**2 + 1), r, sympy.oo, 4),
        (sympy.log(1 + 1 / r), r, sympy.oo, 5),
        (sympy.tan(p), p, 0, 6),
        (sympy.sqrt(1 + p) - sympy.cos(p), p, 0, 4),
    ],
)
def test_the_series_of_sympy_are_checked(
    f: sympy.Expr, variable: sympy.Symbol, point: object, terms: int
) -> None:
    claim = sympy.Eq(f, f.series(variable, point, terms), evaluate=False)
    answer = tresym.check(claim)
    assert answer.verdict.value == "ENCLOSED"
    assert f" as {variable} -> " in answer.read_as
    wrong = sympy.Eq(f, f.series(variable, point, terms) + variable / 7, evaluate=False)
    if wrong.rhs != claim.rhs:
        assert tresym.check(wrong, suggest=False).verdict.value == "REFUTED"


def test_printed_orders_are_read() -> None:
    answer = tresym.check("sqrt(r**2 + 1) == r + 1/(2*r) - 1/(8*r**3) + O(r**(-4), (r, oo))")
    assert answer.verdict.value == "ENCLOSED"
    assert answer.read_as.endswith(" as r -> oo")
    assert tresym.check("exp(x) == 1 + x + O(x**2, (x, 0))").verdict.value == "ENCLOSED"


def test_an_order_in_several_variables_is_refused() -> None:
    y = sympy.Symbol("y")
    with pytest.raises(InputError):
        tresym.check(sympy.Eq(sympy.sin(x + y), sympy.Order(x + y), evaluate=False))
