"""The text of a theorem is one, however the terms and factors of its claim are written."""

from itertools import permutations

import pytest

from tresym.coq.theorem_form import arranged, entry_of_a_matrix, first_one_first, in_one_order
from tresym.reals.language.expression import Expr
from tresym.reals.language.formula import Relation
from tresym.reals.language.parsing import parse
from tresym.reals.language.sympy import unworked
from tresym.reals.language.to_sympy import to_sympy

WRITTEN = [
    "sin(a) + b + a**2",
    "b*pi*sqrt(a)/(1 + a)**2 - 3*b/7",
    "cos(x)*exp(-x)*log(2)*x**2*E*abs(x)",
    "1 + y + x*y + x**2*y - x + pi + sqrt(2)*x + asin(x) + atan(x/2)",
    "(a + b + 1)*(a - b)*(b - 2*a)/a/b",
    "integral(exp(-t*x)*t**2, t, 0, x) + integral(t, t, 0, x) + x*sin(x)",
    "x + sqrt(1 + x) + sqrt(x) + x**(-1) + x**(3/2) + (x + y)**x",
]


@pytest.mark.parametrize("text", WRITTEN)
def test_the_order_is_that_of_sympy(text: str) -> None:
    e = parse(text)
    assert in_one_order(e) == unworked(to_sympy(e))


@pytest.mark.parametrize("text", WRITTEN)
def test_the_order_does_not_depend_on_how_an_expression_is_written(text: str) -> None:
    e = parse(text)
    turned = (Expr(e.op, args) for args in [*permutations(e.args)][:24])
    assert {in_one_order(other) for other in turned} == {in_one_order(e)}


def test_a_bound_variable_keeps_its_name_and_the_terms_of_a_root_their_sides() -> None:
    e = parse("root(x**2 - cos(x), x, 0, 1)")
    assert str(in_one_order(e)) == "root(x**2 - cos(x), x, 0, 1)"
    assert in_one_order(parse("root(-cos(z) + z**2, z, 0, 1)")) == in_one_order(e)


def test_a_product_of_matrices_is_shown_with_what_has_the_factor_zero() -> None:
    assert str(arranged(parse("x*x + sin(a)/(b*a) + 0*a"))) == "x**2 + 1/a/b*sin(a)"
    assert str(entry_of_a_matrix(parse("x*x + 0*log(a)"))) == "0*log(a) + x*x"
    assert str(entry_of_a_matrix(parse("x*x + log(a)"))) == "x**2 + log(a)"


def test_an_equivalence_has_one_text() -> None:
    first, second = (Relation(parse(p), "==", parse(q)) for p, q in (("x", "1"), ("x - 1", "0")))
    assert first_one_first((second, first)) == first_one_first((first, second))
