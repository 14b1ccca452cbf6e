"""Derivatives, integrals, sums and limits as they are typed."""

import pytest

from tresym.reals.language.parsing import as_written
from tresym.reals.language.spelling import Speller
from tresym.reals.language.spelling_tokens import tokens
from tresym.reals.numbers.exact import InputError


@pytest.mark.parametrize(
    ("typed", "meant"),
    [
        ("∫_a^b x dx", "integral(x, x, a, b)"),
        ("∫_(-1)^1 x^2 + 1 dx", "integral(x**2 + 1, x, -1, 1)"),
        ("∫_-oo^oo exp(-x^2) dx", "integral(exp(-x**2), x, -oo, oo)"),
        ("2 ∫_0^1 t dt", "2*integral(t, t, 0, 1)"),
        ("Integrate[x y, {x, 0, 1}, {y, 0, x}]", "integral(integral(x*y, y, 0, x), x, 0, 1)"),
        ("integrate(x*y, (y, 0, x), (x, 0, 1))", "integral(integral(x*y, y, 0, x), x, 0, 1)"),
        ("int(x, x = 0 .. infinity)", "integral(x, x, 0, oo)"),
        ("sum_(k=0)^n k^2", "sum(k**2, k, 0, n)"),
        ("Sum[k, {k, n}]", "sum(k, k, 1, n)"),
        ("prod(k, k=1..n)", "product(k, k, 1, n)"),
        ("lim x->-oo exp(x)", "limit(exp(x), x, -oo)"),
        ("lim x->0- 1/x", "limit(1/x, x, 0, -1)"),
        ("Limit(1/x, x, oo)", "limit(1/x, x, oo)"),
        ("Limit(1/x, x, 0, '-')", "limit(1/x, x, 0, -1)"),
        ("limit(1/x, x = 0, left)", "limit(1/x, x, 0, -1)"),
        ("d^3/dx^3 x^4", "diff(x**4, x, 3)"),
        ("D[x^3, {x, 2}]", "diff(x**3, x, 2)"),
        ("Derivative(x**3, (x, 2))", "diff(x**3, x, 2)"),
        ("D[x y, x, y]", "diff(diff(x*y, x), y)"),
    ],
)
def test_typed_operators(typed: str, meant: str) -> None:
    speller = Speller(tokens(typed)[1])
    found = speller.sum()
    assert speller.at == len(speller.tokens)
    assert as_written(found) == as_written(meant)


@pytest.mark.parametrize(
    "typed",
    ["sum_(k=1)^n k + 1", "lim x->0 x + 1", "d/dx x + 1", "d/dx (x^2) x", "dy/dx", "d^2y/dx^2"],
)
def test_how_far_an_operator_reaches_is_not_guessed(typed: str) -> None:
    with pytest.raises(InputError):
        Speller(tokens(typed)[1]).sum()
