"""Claims with sums and products to oo: what is asked of whom."""

from contextlib import suppress

import pytest

import tresym
from tresym.reals.verdict import Verdict


@pytest.mark.parametrize(
    ("claim", "said"),
    [
        ("exp(x) == sum(x**n/factorial(n), n, 0, oo)", "differential equation"),
        ("pi**2/6 == sum(1/n**2, n, 1, oo)", "DLMF"),
        ("sum(1/(k*(k + 1)), k, 1, oo) == 1", "limit of the partial sums"),
        ("E/(E - 1) == sum(1/factorial(k), k, 0, oo)*sum(exp(-k), k, 0, oo)/E", "power series of"),
        (r"e^x = \sum_{n=0}^\infty \frac{x^n}{n!}", "differential equation"),
        (r"\ln 2 = \sum_{n=1}^\infty \frac{(-1)^{n-1}}{n}", "power series of"),
    ],
)
def test_how_a_series_is_decided(claim: str, said: str) -> None:
    answer = tresym.check(claim)
    assert answer.verdict is Verdict.PROVED
    assert said in answer.why


@pytest.mark.parametrize(
    "claim",
    [
        "diff(sum(x**n, n, 0, oo), x) == 1",
        "sum(x**n, n, 0, oo) -> 1 as x -> 0",
        "sum(x**n, n, 0, oo) > 0 given 0 < x < 1",
        "sum(x**n, n, 0, oo)**2 == 1/(1 - x)**3 given 0 < x < 1",
        "sum(sin(n), n, 0, oo) == 1",
    ],
)
def test_what_is_left_open_or_refused(claim: str) -> None:
    with suppress(tresym.InputError):
        assert not tresym.check(claim)
