"""Recursive descent: each production gives text of the same value as a hand-written one."""

import pytest
from cases import cases
from flint import arb, fmpq

from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.binders import worked_out
from tresym.reals.language.latex_grammar import Reader
from tresym.reals.language.latex_tokens import tokenize
from tresym.reals.language.parsing import parse
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
    reader = Reader(tokenize(source))
    found = worked_out(reader.sum().tree)
    assert reader.peek() == ""
    gap = evaluate(found - parse(text), AT)
    assert gap.is_finite()
    assert abs(gap) < 1e-10


@pytest.mark.parametrize(
    "source",
    cases(__file__, "what_can_be_read_in_two_ways_or_not_at_all_is_refused"),
)
def test_what_can_be_read_in_two_ways_or_not_at_all_is_refused(source: str) -> None:
    with pytest.raises(InputError) as caught:
        Reader(tokenize(source)).sum()
    assert "\n" not in str(caught.value)


def test_a_sum_stops_where_a_relation_begins() -> None:
    reader = Reader(tokenize(r"x+1\le y"))
    assert reader.sum().tree == parse("x + 1")
    assert reader.peek() == r"\le"
