"""Recursive descent: each production gives text of the same value as a hand-written one."""

import pytest
from cases import cases
from flint import arb, fmpq

from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.binders import worked_out
from tresym.reals.language.latex import read_latex
from tresym.reals.language.latex_cursor import Cursor
from tresym.reals.language.latex_grammar import read_sum
from tresym.reals.language.latex_tokens import tokenize
from tresym.reals.language.parsing import as_written, parse
from tresym.reals.numbers.exact import InputError

AT = {"x": arb(fmpq(3, 5)), "y": arb(fmpq(-7, 4)), "a1": arb(2)}


@pytest.mark.parametrize(
    ("source", "text"),
    [
        (r"-x^2+y", "-(x**2) + y"),
        (r"x-(y-1)", "x - (y - 1)"),
        (r"\frac{1}{2}x", "x/2"),
        (r"\frac12x", "x/2"),
        (r"x^{1/2}", "sqrt(x)"),
        (r"x^2y", "x**2*y"),
        (r"2^{3^2}", "512"),
        (r"\sqrt{x}", "sqrt(x)"),
        (r"\sqrt[3]{8}", "2"),
        (r"\sin^2x", "sin(x)**2"),
        (r"\sin 2xy", "sin(2*x*y)"),
        (r"\frac{\cos^2(x)}{2}", "cos(x)**2/2"),
        (r"\sin(x)y", "sin(x)*y"),
        (r"\cos x\sin y", "cos(x)*sin(y)"),
        (r"|y|", "7/4"),
        (r"\left|x-|y|\right|", "abs(x - abs(y))"),
        (r"e^{2x}", "exp(2*x)"),
        (r"\ln x", "log(x)"),
        (r"a_1^2", "4"),
        (r"\frac{d}{dx}(x^3)", "3*x**2"),
        (r"\pi x", "pi*x"),
        (r"\frac{x}{\frac{y}{2}}", "2*x/y"),
        (r"2\cdot 10^{-3}", "1/500"),
        (r"3 t^2\Big|_1^{x}", "3*x**2 - 3"),
        (r"\cosh t\bigg|^{x}_{0}", "cosh(x) - 1"),
        (r"-\left. t + t^2\right|_{t=1}^{t=x}", "2 - x - x**2"),
        (r"y\left[ t^3 \right]_0^2", "8*y"),
    ],
)
def test_productions(source: str, text: str) -> None:
    cursor = Cursor(tokenize(source))
    found = worked_out(read_sum(cursor).tree)
    assert cursor.peek() == ""
    gap = evaluate(found - parse(text), AT)
    assert gap.is_finite()
    assert abs(gap) < 1e-10


@pytest.mark.parametrize(
    "source",
    cases(__file__, "what_can_be_read_in_two_ways_or_not_at_all_is_refused"),
)
def test_what_can_be_read_in_two_ways_or_not_at_all_is_refused(source: str) -> None:
    with pytest.raises(InputError) as caught:
        read_sum(Cursor(tokenize(source)))
    assert "\n" not in str(caught.value)


def test_a_sum_stops_where_a_relation_begins() -> None:
    cursor = Cursor(tokenize(r"x+1\le y"))
    assert read_sum(cursor).tree == parse("x + 1")
    assert cursor.peek() == r"\le"


READ = {
    r"\int_0^1 x\,dx = 1": "integral(x, x, 0, 1)",
    r"\sum_{k=1}^n k = 1": "sum(k, k, 1, n)",
    r"\prod_{k=1}^n k = 1": "product(k, k, 1, n)",
    r"\lim_{x \to 0^+} \ln x = 1": "limit(log(x), x, 0, 1)",
    r"\frac{d}{dx} \sin x = 1": "diff(sin(x), x)",
    r"\sin 2x = 1": "sin(2*x)",
    r"\sin x + 1 = 1": "1 + sin(x)",
    r"\sin^2 x = 1": "sin(x)**2",
    r"\sqrt[3]{x} = 1": "cbrt(x)",
    r"\binom{n}{2} = 1": "n*(n - 1)/2",
    r"\ln\left(1 + x\right) = 1": "log(1 + x)",
}
REFUSED = [r"\int_0^1 x = 1", r"\sum^n k = 1", r"\lim \ln x = 1"]


@pytest.mark.parametrize("source", READ)
def test_operators_and_functions_are_read(source: str) -> None:
    (chain,) = read_latex(source)
    left, _, _ = next(iter(chain.links))
    assert left == as_written(READ[source])


@pytest.mark.parametrize("source", REFUSED)
def test_what_binds_no_variable_is_refused(source: str) -> None:
    with pytest.raises(InputError):
        read_latex(source)
