"""Derivatives of order n: the base and the step of the induction are both needed."""

import pytest

import tresym
from tresym.reals.verdict import Verdict

HOLD = [
    "diff(log(x), x, n) == (-1)**(n - 1)*factorial(n - 1)*x**(-n) given n integer, n >= 1",
    "diff(sin(x), x, n) == sin(x + n*pi/2) given n integer, n >= 0",
    "diff(exp(a*x), x, n) == a**n*exp(a*x)",
    "diff(1/(1 - x), x, n) == factorial(n)/(1 - x)**(n + 1)",
    "diff(x*exp(x), x, n) == (x + n)*exp(x)",
    "diff(1/sqrt(x), x, n) == (-1)**n*factorial(2*n)/(4**n*factorial(n))*x**(-1/2 - n)",
    "diff(2**x, x, n) == log(2)**n*2**x",
    r"\frac{d^n}{dx^n}\cos x=\cos\left(x+\frac{n\pi}{2}\right)",
    r"\frac{d^{n}}{dx^{n}}\ln(1+x)=(-1)^{n-1}\frac{(n-1)!}{(1+x)^{n}} \text{ for } n \ge 1",
]
FALSE = [
    "diff(log(x), x, n) == (-1)**n*factorial(n - 1)*x**(-n) given n integer, n >= 1",
    "diff(log(x), x, n) == (-1)**(n - 1)*factorial(n)*x**(-n) given n integer, n >= 1",
    "diff(sin(x), x, n) == cos(x + n*pi/2)",
    "diff(sin(x), x, n) == sin(x + n*pi/2) + n*(n - 1)*(n - 2)",
    "diff(exp(a*x), x, n) == n*a*exp(a*x) given n >= 1",
    "diff(x*exp(x), x, n) == (x + 2*n)*exp(x)",
]
NEVER = [
    "diff(log(x), x, n) == (-1)**(n - 1)*factorial(n - 1)*x**(-n)",  # n = 0 has none
    "diff(sin(x), x, n) == sin(x + n*pi/2) + n*(n - 1)*(n - 2)*(n - 3)*(n - 4)",
    "diff(sin(x), x, n/2) == sin(x)",
    "diff(sin(x), x, n) <= 1",
    # nothing is said at n = 20 and 21, so nothing follows beyond
    "diff(exp(x), x, n) == exp(x)*((3 + sign(n - 41/2))/2 + sqrt((n - 199/10)*(n - 211/10))"
    " - sqrt((n - 199/10)*(n - 211/10)))",
    # at x = 0 the right side has a value and no derivative
    "diff(exp(x), x, n) == exp(x) + (abs(n - 10) + n - 10)*(1 - sign(x)) + sqrt(x) - sqrt(x)",
    "diff(exp(x), x, n) == exp(x) + (abs(n - 10) + n - 10)*(1 - sign(x)) + asin(x - 1)"
    " - asin(x - 1)",
    "diff(exp(x), x, n) == exp(x) + x**(n/2) - x**(n/2)",
    # what is said of n is another thing at n + 1
    "diff(exp(x), x, n) == exp(x) + n*(n - 1)*(n - 2)*(n - 3)*(n - 4)*(m - 2*n + 2) given m == 2*n",
    "diff(sin(x), x, n)**2 == sin(x)**2",
]


@pytest.mark.parametrize("claim", HOLD)
def test_derivatives_of_order_n(claim: str) -> None:
    answer = tresym.check(claim)
    assert answer.verdict is Verdict.PROVED
    assert tresym.check(answer.read_as).verdict is Verdict.PROVED


@pytest.mark.parametrize("claim", FALSE)
def test_derivatives_of_order_n_that_are_false(claim: str) -> None:
    answer = tresym.check(claim)
    assert answer.verdict is Verdict.REFUTED
    assert answer.witness
    assert "n" in answer.witness


def test_what_is_true_of_an_order_is_never_refuted() -> None:
    answer = tresym.check("diff(exp(x), x, n) == exp(x)*(m - 2*n + 1)", given="m == 2*n")
    assert answer.verdict is Verdict.UNDECIDED
    answer = tresym.check("diff(exp(x), x, n) == exp(x) + abs(x - n) - x + n", given="x > n")
    assert answer.verdict is Verdict.UNDECIDED


@pytest.mark.parametrize("claim", NEVER)
def test_derivatives_of_order_n_that_are_not_proved(claim: str) -> None:
    assert not tresym.check(claim)
