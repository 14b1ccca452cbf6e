"""Whether two trees say the same: a display and a claim, and different where one errs."""

import pytest
from cases import cases
from sympy import Basic, Derivative, Function, Integral, Subs, Symbol, cos, sin, sqrt

from tresym.ledger.audit.tree_comparison import agree, of_claim, of_display, same
from tresym.reals.domain.conditions import Given
from tresym.reals.language.expression import symbol
from tresym.reals.language.latex import read_expression
from tresym.reals.language.latex_author import Author
from tresym.reals.language.latex_author import Function as Defined
from tresym.reals.language.parsing import as_written, parse

x, y, t, s = (Symbol(name, real=True) for name in "xyts")
O = Function("O")  # noqa: E741

PAIRS = [
    ("x^2 + 2x + 1", (x + 1) ** 2, (x - 1) ** 2),
    (r"\int_0^1 tx\,dt", Integral(t * x, (t, 0, 1)), Integral(t * x, (t, 0, 2))),
    (r"\int_0^1 tx\,dt", Integral(s * x, (s, 0, 1)), Integral(s * s, (s, 0, 1))),
    (r"\int_0^x (t + t)dt", Integral(2 * t, (t, 0, x)), Integral(3 * t, (t, 0, x))),
    (r"2\int_0^1 t\,dt + x", 2 * Integral(t, (t, 0, 1)) + x, Integral(t, (t, 0, 1)) + x),
    ("(x^2 + y)|_{x=3}", Subs(x**2 + y, x, 3), Subs(x**2 + y, x, 4)),
    (r"\frac{d}{dx}x^3", Derivative(x**3, x), Derivative(x**2, x)),
    (r"\frac{d}{dx}\int_0^x ty\,dt", Derivative(Integral(t * y, (t, 0, x)), x), x * y),
    ("O(x^2)", O(x**2), O(x**3)),
    ("q|_{x=3}", Subs(Symbol("q", real=True), x, 3), Symbol("q", real=True)),
    (r"\lambda x", Symbol("lambda", real=True) * x, x),
]


@pytest.mark.parametrize(("latex", "alike", "other"), PAIRS, ids=[p[0] for p in PAIRS])
def test_latex_and_sympy_are_compared(latex: str, alike: Basic, other: Basic) -> None:
    tree = of_display(read_expression(latex, Author()), {})
    assert same(tree, of_claim(alike), Given())
    assert not same(tree, of_claim(other), Given())


def test_slopes_of_functions_that_the_paper_defines_are_worked_out() -> None:
    functions = {
        "g": Defined(("a", "b"), parse("a**2 + b")),
        "F": Defined(("a", "b"), as_written("integral(t*a, t, 0, b)")),
    }

    def read(latex: str) -> object:
        return of_display(read_expression(latex, Author(functions)), {}, functions)

    assert same(read(r"\frac{dg}{da}"), parse("2*a"), Given())  # type: ignore[arg-type]
    slope = as_written("diff(integral(t*a, t, 0, b), b)")
    assert read(r"\frac{\partial F}{\partial b}") == slope
    assert read(r"\frac{dF}{db}") == symbol("dF_db")
    at_zero = as_written("at(diff(integral(t*a, t, 0, b), b), b, 0)")
    assert read(r"\left.\frac{\partial F}{\partial b}\right|_{b=0}") == at_zero


def test_names_that_the_claim_writes_otherwise() -> None:
    reads = {"q": "x**2", "at(p, x, 0)": "y", "lambda_": "z"}
    otherwise = {as_written(name): as_written(meant) for name, meant in reads.items()}
    tree = read_expression(r"q + p|_{x=0} + \lambda", Author())
    assert of_display(tree, otherwise) == parse("x**2 + y + z")
    assert of_display(tree, {}) != parse("x**2 + y + z")


def test_a_bracket_with_limits_is_a_difference() -> None:
    tree = read_expression("[t^2u]_1^x", Author(variable="t"))
    assert same(tree, parse("(x**2 - 1)*u"), Given())


def test_two_integrals_count_as_one_only_where_they_agree_on_their_interval() -> None:
    one = of_claim(Integral(sqrt(t**2), (t, 0, 1)))
    assert same(one, of_claim(Integral(t, (t, 0, 1))), Given())
    assert not same(one, of_claim(Integral(t, (t, -1, 1))), Given())


@pytest.mark.parametrize(
    ("left", "right", "under", "found"),
    cases(__file__, "agreement"),
)
def test_agreement(left: str, right: str, under: str, found: bool) -> None:
    assert agree(parse(left), parse(right), Given.parse(under)) is found


def test_the_order_of_sine_and_cosine_is_seen_under_an_integral() -> None:
    one = of_claim(Integral(sin(s) * cos(x), (s, 0, 1)))
    assert not same(one, of_claim(Integral(cos(s) * sin(x), (s, 0, 1))), Given())
