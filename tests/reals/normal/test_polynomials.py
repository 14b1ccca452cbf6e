"""Polynomials in symbols are read off the normal form, exactly or not at all."""

import pytest
from flint import fmpq
from hypothesis import given
from hypothesis import strategies as st

from tresym.reals.domain.conditions import Given
from tresym.reals.language.expression import Expr, number, substitute, symbol
from tresym.reals.language.parsing import parse
from tresym.reals.normal.field import Field
from tresym.reals.normal.polynomials import (
    Monomial,
    as_expression,
    degree,
    polynomial,
    terms_in_symbols,
)

READ = [
    ("(x - y)^2", {(("x", 2),): 1, (("x", 1), ("y", 1)): -2, (("y", 2),): 1}),
    ("x/3 - 5/7", {(("x", 1),): fmpq(1, 3), (): fmpq(-5, 7)}),
    ("(x^2 - 1)/(x - 1)", {(("x", 1),): 1, (): 1}),
    ("sin(x)^2 + cos(x)^2 + y", {(("y", 1),): 1, (): 1}),
    ("x - x", {}),
    ("4", {(): 4}),
]


@pytest.mark.parametrize(("text", "expected"), READ, ids=[text for text, _ in READ])
def test_read(text: str, expected: dict[Monomial, fmpq]) -> None:
    found = polynomial(parse(text))
    assert found is not None
    assert {tuple(sorted(m)): c for m, c in found.items()} == expected


@pytest.mark.parametrize(
    "text",
    ["sqrt(x)", "pi*x", "sqrt(2)*x", "1/x", "x + 1/y", "abs(x)", "x^y", "1/(x - x)", "(x + y)^700"],
)
def test_no_polynomial_with_rational_coefficients(text: str) -> None:
    assert polynomial(parse(text)) is None


def test_a_generator_that_is_no_symbol() -> None:
    field = Field(Given.parse("x > 0"))
    (value,) = field.normal(parse("x*y + sqrt(x)"))
    assert terms_in_symbols(field.ring, value.num) is None
    (value,) = field.normal(parse("x*y - 3"))
    assert terms_in_symbols(field.ring, value.num) == {(("y", 1), ("x", 1)): 1, (): -3}


X, Y = symbol("x"), symbol("y")
trees: st.SearchStrategy[Expr] = st.recursive(
    st.sampled_from([X, Y]) | st.fractions(-3, 3, max_denominator=5).map(number),
    lambda inner: (
        st.builds(Expr.__add__, inner, inner)
        | st.builds(Expr.__sub__, inner, inner)
        | st.builds(Expr.__mul__, inner, inner)
    ),
    max_leaves=8,
)


@given(trees, st.integers(-7, 7), st.integers(-7, 7))
def test_its_terms_add_up_to_it(e: Expr, x: int, y: int) -> None:
    terms = polynomial(e)
    assert terms is not None
    at = {"x": number(fmpq(x, 3)), "y": number(fmpq(y, 4))}
    total: Expr = number(0)
    for monomial, c in terms.items():
        assert c != 0
        total = total + number(c) * as_expression(monomial)
    assert substitute(total, at) == substitute(e, at)


def test_degree_and_product_of_a_monomial() -> None:
    assert degree(()) == 0
    assert degree((("x", 2), ("y", 3))) == 5
    assert as_expression(()) == number(1)
    assert as_expression((("x", 2), ("y", 1))) == X**2 * Y
