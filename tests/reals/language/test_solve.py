"""Zeros found by inverting functions: candidates that are zeros where they are real."""

import pytest
from flint import arb, fmpq

from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.expression import symbols
from tresym.reals.language.parsing import parse
from tresym.reals.language.solve import solutions
from tresym.reals.numbers.arithmetic import ball_precision

FOUND = [
    ("x - 3", 1),
    ("7 - 2*x", 1),
    ("x**2 - 2", 2),
    ("x**3 - 5", 1),
    ("x**(-2) - 4", 2),
    ("sqrt(x) - 3", 1),
    ("x**(2/3) - 4", 1),
    ("exp(x) - 3", 1),
    ("log(x) + 2", 1),
    ("2**x - 8", 1),
    ("sin(2*x) - 1/2", 1),
    ("cos(x) - 1/3", 1),
    ("tan(x) + 1", 1),
    ("atan(x) - 1", 1),
    ("asin(x/2) - 1/5", 1),
    ("acos(x) - 1", 1),
    ("sinh(x) - 2", 1),
    ("tanh(x) - 1/2", 1),
    ("asinh(x) + 3", 1),
    ("acosh(x) - 2", 1),
    ("atanh(x) - 1", 1),
    ("log(x)*(x - 3)", 2),
    ("x**2*(x - 1)*exp(x)", 2),
    ("exp(1/(x + 1)) - 5", 1),
    ("(log(x) - 1)**2 - 2", 2),
    ("y*x - 1", 1),
    ("exp(y)*x**2 - y", 2),
]


@pytest.mark.parametrize(("text", "count"), FOUND)
def test_candidates_are_zeros(text: str, count: int) -> None:
    e = parse(text)
    found = solutions(e, "x")
    assert len(set(found)) == count
    with ball_precision(150):
        for candidate in found:
            assert "x" not in symbols(candidate)
            y = {"y": arb(fmpq(7, 5))}
            value = evaluate(e, {"x": evaluate(candidate, y), **y})
            assert abs(value) < arb(2) ** -100


@pytest.mark.parametrize(
    "text",
    ["exp(x)", "1/x", "3", "y", "x + exp(x)", "x**x - 2", "sin(x) + cos(x)", "abs(x) - 1"],
)
def test_where_nothing_is_found(text: str) -> None:
    assert solutions(parse(text), "x") == []


@pytest.mark.parametrize("text", ["x**2 + 1", "exp(x) + 1", "cosh(x) - 1/2", "sin(x) - 2"])
def test_a_candidate_without_a_real_value_is_seen_as_such(text: str) -> None:
    assert not any(evaluate(found, {}).is_finite() for found in solutions(parse(text), "x"))


def test_what_grows_beyond_the_bounds_gives_nothing() -> None:
    assert solutions(parse("x**(1/900) - 10**900"), "x") == []
