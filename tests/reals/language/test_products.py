"""Products and sums with like parts joined: the same value at every positive point."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from flint import arb, fmpq

from tresym.reals.language.expression import Expr, multiply, power
from tresym.reals.language.parsing import parse
from tresym.reals.language.products import (
    MAX_POWER,
    collected,
    factors,
    in_exponentials,
    joined,
)
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.places.values import evaluate

TEXTS = [
    "x*x**2*exp(x)*exp(-x)",
    "exp(x + 1)/exp(x)",
    "exp(2*log(x) + x)",
    "exp(x*log(2))*exp(1/3*log(x*exp(x)))",
    "abs(-3*x*sin(x))",
    "abs(abs(cos(x)))*abs(x**2)",
    "log(x**3)*log(1/x)",
    "log(x**2*exp(x))",
    "log(6*x*exp(x)/35)",
    "log(exp(x) + 1) - x",
    "log(sinh(x)) + log(2*cosh(x))",
    "x**2 + x*sin(x)",
    "(x**2*sin(x) + 3*x**3)/x**2",
    "exp(x)*x + exp(2*x)",
    "exp(-x)*x + 5*exp(-x)*cos(x)",
    "sqrt(x**2)*(x**(1/2))**3",
    "sqrt(sin(x)**2)*cbrt(x)",
    "sqrt(exp(2*x) + 1) - exp(x)",
    "1/(exp(x) + x)**2 - exp(-2*x)",
    "sinh(x) - cosh(x)",
    "coth(x) - 1 + tanh(x)",
    "(exp(x) + 1)**3 - exp(3*x)",
    "(x + 1)*(x - 1) - x**2 + 2*(x + 3) - x",
    "x - x + sin(x)",
    "3*(x + 2*(x - 5*(x + 1))) - 7*x",
    "x**pi*x**(1 - pi)*2**x",
    "(2*x)**x",
    "(sin(x)*x)**2*x**(-2)",
]
FORMS: dict[str, Callable[[Expr], Expr]] = {
    "factors": lambda e: multiply(*(power(b, x) for b, x in factors(e, "x"))),
    "joined": lambda e: joined(e, "x"),
    "collected": collected,
    "in_exponentials": lambda e: in_exponentials(e, "x"),
}


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("text", TEXTS)
def test_the_value_is_kept_at_positive_points(text: str, form: str) -> None:
    e = parse(text)
    found = FORMS[form](e)
    with ball_precision(200):
        for x in (fmpq(1, 7), fmpq(5, 3), fmpq(11, 2)):  # the sine is of both signs
            at = {"x": arb(x)}
            expected, value = evaluate(e, at), evaluate(found, at)
            if expected.is_finite():
                assert abs(expected - value) < arb(2) ** -100 * (1 + abs(expected))


@pytest.mark.parametrize(
    ("text", "form", "expected"),
    [
        ("x*x**2*exp(x)*exp(-x)", "joined", "x**3"),
        ("exp(x + 1)/exp(x)", "joined", "E"),
        ("exp(2*log(x))", "joined", "x**2"),
        ("log(x**3)", "joined", "3*log(x)"),
        ("sqrt(x**2)", "joined", "x"),
        ("x - x + sin(x)", "collected", "sin(x)"),
        ("2*(x + 1) - 2*x", "collected", "2"),
        ("sinh(x) - cosh(x)", "in_exponentials", "-exp(-x)"),
        ("log(exp(x) + 1) - x", "in_exponentials", "log(exp(-x) + 1)"),
        ("log(6*x*exp(x)) - log(2) - log(3)", "in_exponentials", "x + log(x)"),
    ],
)
def test_what_cancels_is_gone(text: str, form: str, expected: str) -> None:
    assert FORMS[form](parse(text)) == parse(expected)


@pytest.mark.parametrize(
    ("text", "false"),
    [
        ("sqrt(sin(x)**2)", "sin(x)"),
        ("abs(x*sin(x))", "x*sin(x)"),
        ("(sin(x)**6)**(1/2)", "sin(x)**3"),
        ("log(sin(x)**2)", "2*log(sin(x))"),
        ("exp(1/2*log(sin(x)**2))", "sin(x)"),
    ],
)
def test_the_sign_of_a_base_is_not_forgotten(text: str, false: str) -> None:
    """At x = 5 the sine is negative."""
    with ball_precision(100):
        at = {"x": arb(5)}
        value, wrong = evaluate(joined(parse(text), "x"), at), evaluate(parse(false), at)
        assert value.is_finite()
        assert not value.overlaps(wrong) or not wrong.is_finite()


def test_factors_are_bases_with_exponents() -> None:
    found = dict(factors(parse("3*x**2*exp(x)/sin(x)*x**y"), "x"))
    assert found == {
        parse("3"): parse("1"),
        parse("x"): parse("2 + y"),
        parse("E"): parse("x"),
        parse("sin(x)"): parse("-1"),
    }


@pytest.mark.parametrize("n", [2, 3, MAX_POWER + 1, 900])
def test_what_grows_is_left_as_it_is(n: int) -> None:
    found = in_exponentials(parse(f"(exp(x) + 1)**{n}"), "x")
    assert (found.op == "+") is (n < MAX_POWER)
    assert found.size < 100
