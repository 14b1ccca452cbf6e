"""Identities of integrals whatever their values, and what only looks like one."""

import pytest

import tresym

PROVED = [
    "integral(f(x), x, a, b) == -integral(f(x), x, b, a)",
    "integral(f(x) + g(x), x, a, b) == integral(f(x), x, a, b) + integral(g(x), x, a, b)",
    "integral(2*f(x), x, a, b) == 2*integral(f(x), x, a, b)",
    "integral(f(x), x, a, c) == integral(f(x), x, a, b) + integral(f(x), x, b, c)",
    "integral(diff(f(x), x), x, a, b) == f(b) - f(a)",
    "integral(1 + f(x), x, a, b) == b - a + integral(f(x), x, a, b)",
    "integral(x**x, x, 1, 2) + integral(x**x, x, 2, b) == integral(x**x, x, 1, b) given b > 2",
    "integral(x**x, x, 1, 3) == -integral(x**x, x, 3, 1)",
]
REFUTED = [
    "integral(2*x**x, x, 1, 2) == integral(x**x, x, 1, 2)",
]
OPEN = [
    "integral(f(x), x, a, b) == integral(f(x), x, b, a)",  # false, without a point that shows it
    "integral(f(x), x, 0, 1) == integral(f(x), x, 1, 2)",
    "integral(f(x), x, 0, 1) == f(1) - f(0)",
    "integral(diff(f(x), x), x, a, b) == f(a) - f(b)",
    "integral(f(x), x, 0, 1) > 0 given f(0) > 0",
    "integral(f(x)**2, x, 0, 1) >= 0",  # true, and for no other reason
    "integral(f(x)*g(x), x, a, b) == integral(f(x), x, a, b)*integral(g(x), x, a, b)",
    "integral(f(x)/x, x, -1, 1) == integral(f(x)/x, x, -1, 1)",  # has no value
    "integral(f(1/x), x, -1, 1) == integral(f(1/x), x, -1, 2) + integral(f(1/x), x, 2, 1)",
    "integral(1/x, x, -1, 1) == integral(1/x, x, -1, 0) + integral(1/x, x, 0, 1)",
    "integral(exp(1/x), x, -1, 1) == integral(exp(1/x), x, -1, 2) + integral(exp(1/x), x, 2, 1)",
]


@pytest.mark.parametrize("claim", PROVED)
def test_linearity_and_joined_intervals(claim: str) -> None:
    assert tresym.check(claim).verdict.value == "PROVED"


@pytest.mark.parametrize("claim", REFUTED)
def test_quadrature_refutes_what_holds_no_unknown_function(claim: str) -> None:
    assert tresym.check(claim).verdict.value == "REFUTED"


@pytest.mark.parametrize("claim", OPEN)
def test_what_is_no_identity_of_smooth_integrands_is_open(claim: str) -> None:
    assert tresym.check(claim).verdict.value == "UNDECIDED"
