"""Sums rewritten so that nothing cancels have the same value, and none is left to cancel."""

from __future__ import annotations

import pytest
from flint import arb, fmpq

from tresym.reals.language.cancellation import scaled, without_cancellation
from tresym.reals.language.expression import add, multiply, number, symbols
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.places.values import evaluate

REWRITTEN = [
    "log(x) - log(x + 1) + 3",
    "2*log(x) - log(log(x)) - 7",
    "1/3*log(x) + log(x**2 + 1) + x",
    "asinh(x) - log(x) - log(2)",
    "acosh(x) - asinh(x)",
    "log(x + 1) + exp(x) - log(x) - 1/2*acosh(x)",
    "tanh(x) - 1",
    "tanh(x) + 1",
    "3*tanh(x**2) - 3",
    "-2*tanh(1/x) - 2",
    "x - 5*tanh(x) + 5",
    "log(x) + tanh(x) - log(x + 1) - 1",
]
KEPT = [
    "tanh(x) - 2",
    "2*tanh(x) - 1",
    "tanh(x) + x",
    "log(x) + x",
    "log(2) - log(3) + x",
    "1/101*log(x) - log(x + 1)",
    "x + 1",
]
POINTS = [fmpq(3, 2), fmpq(7), fmpq(1001, 1000), fmpq(29)]


@pytest.mark.parametrize("text", [*REWRITTEN, *KEPT])
@pytest.mark.parametrize("x", POINTS, ids=str)
def test_the_terms_have_the_sum(text: str, x: fmpq) -> None:
    e = parse(text)
    with ball_precision(200):
        at = {"x": arb(x)}
        gap = evaluate(e, at) - evaluate(add(*without_cancellation(e)), at)
        assert abs(gap) < arb(2) ** -120


@pytest.mark.parametrize("text", REWRITTEN)
def test_what_cancels_is_gone(text: str) -> None:
    e = parse(text)
    terms = without_cancellation(e)
    assert list(e.args) != terms
    logarithms = [t for t in terms if scaled(t)[1].op in ("log", "asinh", "acosh") and symbols(t)]
    assert len(logarithms) <= 1
    assert not any(scaled(t)[1].op == "tanh" for t in terms)


@pytest.mark.parametrize("text", KEPT)
def test_what_does_not_cancel_stays(text: str) -> None:
    e = parse(text)
    assert without_cancellation(e) == list(e.args)


def test_far_out_the_digits_remain() -> None:
    """1 − tanh 30 is 1.7e-26: the sum as written has no digit of it at 64 bits."""
    e = parse("tanh(x) - 1")
    with ball_precision(64):
        at = {"x": arb(30)}
        assert evaluate(e, at).contains(0)
        assert evaluate(add(*without_cancellation(e)), at) < 0


@pytest.mark.parametrize(
    ("text", "scale", "rest"),
    [
        ("3*x", 3, "x"),
        ("-x*y", -1, "x*y"),
        ("x/2", fmpq(1, 2), "x"),
        ("x*y", 1, "x*y"),
        ("x", 1, "x"),
        ("2", 1, "2"),
        ("0*log(x)", 0, "log(x)"),
    ],
)
def test_a_number_times_the_rest(text: str, scale: int, rest: str) -> None:
    r, inner = scaled(parse(text))
    assert (r, inner) == (scale, parse(rest))
    assert multiply(number(r), inner) == parse(text)
