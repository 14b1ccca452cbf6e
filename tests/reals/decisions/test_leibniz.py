"""Derivatives of integrals: worked out where the integrand is smooth, and nowhere else."""

import pytest

import tresym

CLAIMS = [
    ("diff(integral(x*t, t, 0, x), x) == 3*x**2/2", "PROVED"),
    ("diff(integral(x*t, t, 0, x), x) == x**2", "REFUTED"),  # without the parameter
    ("diff(integral(f(t), t, 0, x), x) == f(x)", "PROVED"),
    ("diff(integral(f(t), t, 0, x), x) == f(0)", "UNDECIDED"),  # false, but no f is shown
    ("diff(integral(f(t), t, x, 0), x) == f(x)", "UNDECIDED"),  # the other sign
    ("diff(integral(sin(t**2), t, 0, x), x) == sin(x**2)", "PROVED"),
    ("diff(integral(exp(-t**2), t, 0, x**2), x) == 2*x*exp(-x**4)", "PROVED"),
    ("diff(integral(exp(-t**2), t, 0, x**2), x) == exp(-x**4)", "REFUTED"),  # no chain rule
    ("diff(integral(exp(-t**2), t, 0, x), x) > 0", "PROVED"),
    ("diff(integral(sin(x*t)/t, t, 1, 2), x) == (sin(2*x) - sin(x))/x", "PROVED"),
    ("diff(integral(1/t, t, 1, x), x) == 1/x given x > 0", "PROVED"),
    ("diff(integral(1/t, t, -1, x), x) == 1/x", "UNDECIDED"),  # across the pole
    ("diff(integral(abs(t - x), t, 0, 1), x) == 0", "UNDECIDED"),
    ("diff(integral(1/(t - x), t, 0, 1), x) == 0", "UNDECIDED"),
    ("diff(integral(sign(t), t, -1, x), x) == 1", "UNDECIDED"),
    ("diff(integral(sqrt(t), t, 0, x), x) == sqrt(x) given x > 0", "UNDECIDED"),  # not at 0
    ("diff(integral(t, t, 0, x), x) == 5 given x > 1, x < 0", "UNDECIDED"),
]


@pytest.mark.parametrize(("claim", "verdict"), CLAIMS)
def test_the_derivative_of_an_integral(claim: str, verdict: str) -> None:
    assert tresym.check(claim).verdict.value == verdict
