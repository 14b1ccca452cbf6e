"""Comparable trees: the same from LaTeX's text and from SymPy, and different where one errs."""

from __future__ import annotations

import pytest
from sympy import Basic, Derivative, Function, Integral, Order, Subs, Symbol, cos, sin, sqrt

from tresym.ledger.audit.terms import Function as Defined
from tresym.ledger.audit.terms import Terms, agree
from tresym.reals.language.expression import symbol
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.exact import InputError
from tresym.reals.places.conditions import Given

x, y, t, s = (Symbol(name, real=True) for name in "xyts")
F = Function("F")

PAIRS = [
    ("x**2 + 2*x + 1", (x + 1) ** 2, (x - 1) ** 2),
    ("integral(t*x, t, 0, 1)", Integral(t * x, (t, 0, 1)), Integral(t * x, (t, 0, 2))),
    ("integral(t + t, t, 0, x)", Integral(2 * t, (t, 0, x)), Integral(3 * t, (t, 0, x))),
    ("2*integral(t, t, 0, 1) + x", 2 * Integral(t, (t, 0, 1)) + x, Integral(t, (t, 0, 1)) + x),
    ("at(x**2 + y, x, 3)", Subs(x**2 + y, x, 3), Subs(x**2 + y, x, 4)),
    ("diff(x**3, x)", Derivative(x**3, x), Derivative(x**2, x)),
    ("O(x**2)", Order(x**2), Order(x**3)),
    ("F(x, 2*y)", F(x, 2 * y), F(x, 3 * y)),
    ("F(x, y)", F(x, y), x),
]


@pytest.mark.parametrize(("text", "same", "other"), PAIRS, ids=[p[0] for p in PAIRS])
def test_text_and_sympy_become_one_tree(text: str, same: Basic, other: Basic) -> None:
    terms = Terms()
    tree = terms.from_text(text)
    assert terms.same(tree, terms.from_sympy(same))
    assert not terms.same(tree, terms.from_sympy(other))


def test_functions_that_the_paper_defines_are_put_in() -> None:
    terms = Terms({"g": Defined(("a", "b"), "a**2 + b")})
    assert terms.same(terms.from_text("g(x, 3)"), parse("x**2 + 3"))
    assert not terms.same(terms.from_text("g(3, x)"), parse("x**2 + 3"))
    assert terms.from_text("dg_da") == parse("2*a")


def test_names_that_the_claim_writes_otherwise() -> None:
    terms = Terms(reads={"q": "x**2", "G(1, 2)": "y"})
    assert terms.same(terms.from_text("q + G(1, 2)"), parse("x**2 + y"))
    assert Terms().from_text("lambda_") == symbol("lambda")


def test_a_bracket_with_limits_is_a_difference() -> None:
    terms = Terms(variable="t")
    assert terms.same(terms.from_text("between(t**2, 1, x)"), parse("x**2 - 1"))


def test_a_value_is_put_in_only_where_the_variable_is_seen() -> None:
    terms = Terms()
    assert terms.from_text("at(x**2, x, 3)") == parse("9")
    assert terms.from_text("at(y, x, 3)") != parse("y")


def test_two_integrals_count_as_one_only_where_they_agree_on_their_interval() -> None:
    terms = Terms()
    one = terms.from_sympy(Integral(sqrt(t**2), (t, 0, 1)))
    assert one == terms.from_sympy(Integral(t, (t, 0, 1)))
    assert one != terms.from_sympy(Integral(t, (t, -1, 1)))


@pytest.mark.parametrize(
    ("left", "right", "under", "found"),
    [
        ("sin(x)**2 + cos(x)**2", "1", "", True),
        ("sin(x)", "cos(x)", "", False),
        ("sqrt(x**2)", "x", "", False),
        ("sqrt(x**2)", "x", "x > 0", True),
        ("x", "x + 10**(-9)", "", False),
        ("log(x)", "log(x) + 0*y", "x > 0", True),
        ("log(x)", "log(x) + 1", "x < 0", False),  # nowhere defined is no agreement
        ("x", "2*x", "x > 1, x < 0", False),
    ],
)
def test_agreement(left: str, right: str, under: str, found: bool) -> None:
    assert agree(parse(left), parse(right), Given.parse(under)) is found


@pytest.mark.parametrize("text", ["x +", "x; y", "2x", ""])
def test_what_is_no_text_of_the_grammar(text: str) -> None:
    with pytest.raises(InputError):
        Terms().from_text(text)


def test_the_order_of_sine_and_cosine_is_seen_under_an_integral() -> None:
    terms = Terms()
    one = terms.from_sympy(Integral(sin(s) * cos(x), (s, 0, 1)))
    assert one != terms.from_sympy(Integral(cos(s) * sin(x), (s, 0, 1)))
