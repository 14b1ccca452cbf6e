"""Claims that hold but at exceptional values of parameters, and the guard that excludes each."""

import pytest

import tresym
from tresym.checking import dispatch
from tresym.reals.decisions import (
    ellipsis_series,
    exceptional_values,
    induction,
    integrals,
    power_series,
)
from tresym.reals.decisions.exceptional_values import with_signs
from tresym.reals.language.parsing import as_written
from tresym.reals.verdict import Verdict

JUMPS = (
    *("1/x + 1 - sign(a - 9)**2 -> 0 as x -> oo", "x*(1 - sign(a - 9)**2) == O(1) as x -> oo"),
    *(
        "x - x**2*(1 - sign(a - 9)**2) > 0 as x -> oo",
        "sign(n - 50)**2*sum(k, k, 1, n) == n*(n + 1)/2",
    ),
    "a/x + atan2(a - 9, -1) + atan2(9 - a, -1) -> 0 as x -> oo",
    "n*(1 - sign(a - 9)**2) -> 0 as n -> oo given n integer",
    "1/x + 1 - sign(a - b)**2 -> 0 as x -> oo given a > b - 1",
    "1/x + 1 - sign(a**2 - 2)**2 -> 0 as x -> oo",
    "f(sign(a)**2) == f(1)",
    "(-1)**n/n + 1 - sign(a - 9)**2 -> 0 as n -> oo given n integer",
)
ZEROS = (
    "a*diff(exp(x), x, n) == a*exp(x) + b given a*b == 0",
    "sign(a - 7)**2*diff(exp(x), x, n) == exp(x)",
    "sign(a - 7)**2*(1 + x + x**2 + ...) == 1/(1 - x) given -1 < x < 1",
    "sign(a - 7)**2*sum(x**k, k, 0, oo) == 1/(1 - x) given -1 < x < 1",
)
HOLES = (
    "sign(a)**2*sum(1/(n**2 + a**2), n, 1, oo) == sum(1/(n**2 + a**2), n, 1, oo)",
    "sum(x**k/(k + 1), k, 0, oo)*sign(x)**2 == sum(x**k/(k + 1), k, 0, oo) given -1 < x < 1",
    "sign(a)**2*integral(exp(a*x), x, 0, 1) == integral(exp(a*x), x, 0, 1)",
)


@pytest.fixture
def _no_cases(monkeypatch: pytest.MonkeyPatch) -> None:
    for module in (exceptional_values, induction, power_series, ellipsis_series):
        monkeypatch.setattr(module, "also_at_zeros", lambda found, *_: found)
    for module in (induction, integrals):
        monkeypatch.setattr(module, "also_at_holes", lambda found, *_: found)


@pytest.mark.usefixtures("_no_cases")
@pytest.mark.parametrize("claim", [*JUMPS, *ZEROS, *HOLES])
def test_without_the_cases_it_would_be(claim: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """The jumps, the zeros of coefficients and the holes of values are excluded here alone."""
    monkeypatch.setattr(dispatch, "attack", lambda *_: None)
    assert tresym.check(claim)


@pytest.mark.usefixtures("_no_cases")
@pytest.mark.parametrize("claim", [*JUMPS, *ZEROS, *HOLES])
def test_the_cross_check_alone_stops_it(claim: str) -> None:
    """It tries the exceptional values that occur in the statement by itself."""
    found = tresym.check(claim)
    assert found.verdict is Verdict.UNDECIDED
    assert "a proof was found, but" in found.why


@pytest.mark.parametrize(
    ("written", "worked"),
    [
        *(("sign(-3)*x", "-x"), ("0*x", "0"), ("0*log(x)", "0*log(x)"), ("atan2(0, -2)", "pi")),
        ("sum(0**k/(k + 1), k, 0, oo)", "1"),
        ("sum(0**k/k, k, 0, oo)", "1/0"),
        ("sum(0**(k - 1), k, 0, oo)", "sum(0**(k - 1), k, 0, oo)"),
        ("0*sum(k, k, 0, oo)", "0*sum(k, k, 0, oo)"),
    ],
)
def test_only_what_is_defined_is_dropped_beside_zero(written: str, worked: str) -> None:
    assert with_signs(as_written(written)) == as_written(worked)


def test_the_witness_has_the_exceptional_value() -> None:
    found = tresym.check("1/x + 1 - sign(a - b)**2 -> 0 as x -> oo")
    assert found.verdict is Verdict.REFUTED
    assert found.witness
    assert found.witness["a"] == found.witness["b"]
