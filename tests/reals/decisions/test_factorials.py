"""Factorials by the least of them: what holds of integers, and what does not."""

import pytest

import tresym
from tresym.reals.verdict import Verdict

HOLD = [
    "factorial(n + 1) == (n + 1)*factorial(n)",
    "factorial(n + 1)/factorial(n - 1) == n*(n + 1)",
    "x**(n + 1)/factorial(n + 1)/(x**n/factorial(n)) == x/(n + 1)",
    "factorial(2*n) == 2*n*factorial(2*n - 1)",
    "factorial(n) >= 1",
    "exp(x) > 1 + x**3/factorial(3) given x > 0",
    r"\binom{n+1}{k} = \binom{n}{k} + \binom{n}{k-1}",
    r"\binom{n}{k} = \binom{n}{n-k}",
    r"k\binom{n}{k} = n\binom{n-1}{k-1}",
    r"\binom{n}{k} = \frac{n!}{k!\,(n-k)!}",
    r"\frac{(n+2)!}{n!} = (n+1)(n+2)",
]
FAIL = [
    "factorial(n + 1) == (n + 2)*factorial(n)",
    "factorial(n + 1)/factorial(n - 1) == n*(n - 1)",
    "factorial(n) == factorial(m)",
    "factorial(n) > n",
    "factorial(n) == 1 given n <= 2",
    r"\binom{n+1}{k} = \binom{n}{k} + \binom{n}{k+1}",
    r"\binom{n}{k} = \binom{n}{n-k+1}",
    r"\frac{(n+2)!}{n!} = (n+1)(n+3)",
    "factorial(n)**2 == 1 given n > 30, n < 40",
]
OPEN = [
    "factorial(n) == 1 given n < 2",  # true, of numbers 1 and 1 alone
    "factorial(x) == x*factorial(x - 1) given x > 1/3, x < 2/3",  # of no integer
    "diff(factorial(n), n) == 0",
    "factorial(factorial(n)) >= 1",
]


@pytest.mark.parametrize(
    ("claim", "verdict"),
    [
        *((claim, Verdict.PROVED) for claim in HOLD),
        *((claim, Verdict.REFUTED) for claim in FAIL),
        *((claim, Verdict.UNDECIDED) for claim in OPEN),
    ],
)
def test_factorials_are_those_of_integers(claim: str, verdict: Verdict) -> None:
    assert tresym.check(claim).verdict is verdict
