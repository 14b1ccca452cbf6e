"""Integrals without a value, and functions that oscillate: told from those that converge."""

from __future__ import annotations

import pytest

import tresym
from tresym.reals.decisions.divergence import has_no_limit
from tresym.reals.domain.conditions import Given
from tresym.reals.language.parsing import parse

OSCILLATES = [
    "sin(x)",
    "x*sin(x)",
    "exp(x)*sin(x)**2",
    "sin(pi*x) + 1/x",
    "sin(3*x)/3 - cos(2*x)/2",
    "atan(x*sin(x))",
]
DOES_NOT = [
    "sin(x)/x",
    "exp(-x)*sin(x)",
    "x + sin(x)",  # it goes to infinity
    "sin(x)**2 + cos(x)**2",
    "cos(2*x) - 2*cos(x)**2",
    "sin(x) - sin(x + 2*pi)",
    "sin(1/x)",
    "a*sin(x)",  # a may be 0
]
VALUES = [
    ("integral(1/x, x, -1, 1) == 0", "REFUTED"),
    ("2*integral(1/x, x, -1, 2) == 2*log(2)", "REFUTED"),
    ("integral(a/x, x, -1, 1) == 0 given a > 0", "REFUTED"),
    ("integral(a/x, x, -1, 1) == 0", "REFUTED"),  # at a = 2, though not at a = 0
    ("integral(x/(1 + x**2), x, -oo, oo) == 0", "REFUTED"),
    ("integral(x/(1 + x**4), x, -oo, oo) == 0", "PROVED"),
    ("integral(x, x, -oo, oo) == oo", "REFUTED"),
    ("integral(x**3, x, -oo, oo) == 0", "REFUTED"),
    ("integral(cos(x), x, 0, oo) == 0", "REFUTED"),
    ("integral(exp(-x)*cos(x), x, 0, oo) == 1/2", "PROVED"),
    ("integral(1/x, x, -1, 1) == integral(1/x, x, -1, 1)", "UNDECIDED"),  # of no number
    ("integral(1/x, x, -1, 1) == log(-1)", "UNDECIDED"),
    ("integral(1/sqrt(abs(x)), x, -1, 1) == 4", "PROVED"),
]


@pytest.mark.parametrize("e", OSCILLATES)
def test_what_oscillates_has_no_limit(e: str) -> None:
    assert has_no_limit(parse(e), "x", 1, Given())


@pytest.mark.parametrize("e", DOES_NOT)
def test_what_has_a_limit_or_may_have_one(e: str) -> None:
    assert not has_no_limit(parse(e), "x", 1, Given())


@pytest.mark.parametrize(("claim", "verdict"), VALUES)
def test_an_integral_without_a_value_equals_no_number(claim: str, verdict: str) -> None:
    assert tresym.check(claim).verdict.value == verdict
