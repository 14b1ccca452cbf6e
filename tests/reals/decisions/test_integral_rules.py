"""Rules for integrals: what they give of smooth integrands, and what only looks like it."""

import pytest
from cases import cases

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
PROVED = cases(__file__, "PROVED")
REFUTED = [
    "integral(2*x**x, x, 1, 2) == integral(x**x, x, 1, 2)",
]
OPEN = cases(__file__, "OPEN")


@pytest.mark.parametrize(("claim", "verdict"), CLAIMS)
def test_the_derivative_of_an_integral(claim: str, verdict: str) -> None:
    assert tresym.check(claim).verdict.value == verdict


@pytest.mark.parametrize("claim", PROVED)
def test_linearity_and_joined_intervals(claim: str) -> None:
    assert tresym.check(claim).verdict.value == "PROVED"


@pytest.mark.parametrize("claim", REFUTED)
def test_quadrature_refutes_what_holds_no_unknown_function(claim: str) -> None:
    assert tresym.check(claim).verdict.value == "REFUTED"


@pytest.mark.parametrize("claim", OPEN)
def test_what_is_no_identity_of_smooth_integrands_is_open(claim: str) -> None:
    assert tresym.check(claim).verdict.value == "UNDECIDED"
