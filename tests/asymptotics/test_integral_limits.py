"""Limits and orders of what holds integrals."""

import pytest

import tresym
from tresym.reals.verdict import Verdict

HOLD = [
    "limit(integral(t**2, t, 0, x)/x**3, x, 0) == 1/3",
    "limit(integral(t**2, t, 0, x)/x**3, x, 0) == 1/3 given w > 0",
    "limit(1/b*integral(cos(w*t), t, 0, b), b, 0) == 1",
    "limit(1/x*integral(exp(-t**2), t, 0, x), x, 0) == 1",
    "integral(exp(t**2), t, 0, x) ~ x as x -> 0",
    "limit(integral(exp(t**2), t, 0, x**2)/x**2, x, 0) == 1",
    "limit(integral(1/t, t, 1, x)/log(x), x, oo) == 1",
    "limit(integral(1/t, t, x, 2*x), x, 0) == log(2)",
    "limit(integral(cos(t**2), t, a, x)/(x - a), x, a) == cos(a**2)",
    "limit(integral(a*t, t, 0, x)/x**2, x, 0) == a/2",
    "limit(integral(sin(x*t), t, 0, 1)/x, x, 0) == 1/2",
    "limit(integral(exp(-t), t, 0, x), x, oo) == 1",
]
FAIL = [
    "limit(1/x*integral(exp(-t**2), t, 0, x), x, 0) == 2",
    "limit(integral(a*t, t, 0, x)/x**2, x, 0) == a",
    "limit(integral(t**2, t, 0, x)/x**3, x, 0) == oo",
    "integral(t**2, t, 0, x) == o(x**3) as x -> 0",
    "limit(integral(exp(t**2), t, 0, abs(x))/x, x, 0) == 1",
    "limit(integral(exp(t**2), t, 0, x)/cos(x), x, 0) == 1",
    "limit(integral(exp(t**2), t, 1, x)/x, x, 0) == 1",
    "limit(integral(exp(x*t**2), t, 0, x)/x, x, 0) == 2",
    "limit(integral(exp(t**2), t, 0, x)/(x + x**2*sin(1/x)), x, 0) == 2",
]
OPEN = [
    "limit(integral(1/t, t, 0, x)*x, x, 0) == 0",  # it has no value
    "limit(integral(1/t, t, -x, x)/x, x, 0) == 0",
    "limit(integral(exp(t**2)/t, t, 0, x)/x, x, 0) == 1",  # not continuous there
]


@pytest.mark.parametrize("claim", HOLD)
def test_it_holds(claim: str) -> None:
    assert tresym.check(claim).verdict in (Verdict.PROVED, Verdict.ENCLOSED)


@pytest.mark.parametrize("claim", FAIL)
def test_it_fails(claim: str) -> None:
    answer = tresym.check(claim)
    assert answer.verdict is Verdict.REFUTED
    assert answer.witness


@pytest.mark.parametrize("claim", OPEN)
def test_it_is_open(claim: str) -> None:
    assert tresym.check(claim).verdict is Verdict.UNDECIDED
