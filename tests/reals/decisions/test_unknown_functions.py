"""Functions left unknown: what holds of every smooth function, and a function where it fails."""

import pytest
from cases import cases

import tresym
from tresym.reals.verdict import Verdict

HOLD = cases(__file__, "HOLD")
FAIL = cases(__file__, "FAIL")
OPEN = [
    "integral(f(x), x, 0, 1) == 1",
    "f(log(-1 - x**2)) == 1",
    "f(2) == 4 given f(x) == x**2",
    "diff(y(t), t, 2) == y(t) given diff(y(t), t) == y(t)",
    "y(x) == y(0)*exp(x) given diff(y(x), x) == y(x)",
]


@pytest.mark.parametrize("claim", HOLD)
def test_what_holds_of_every_function(claim: str) -> None:
    answer = tresym.check(claim)
    assert answer.verdict in (Verdict.PROVED, Verdict.ENCLOSED)
    assert "all smooth f" in answer.why


@pytest.mark.parametrize("claim", FAIL)
def test_what_fails_of_one_gives_its_values(claim: str) -> None:
    answer = tresym.check(claim)
    assert answer.verdict is Verdict.REFUTED
    assert answer.witness
    assert any("f(" in name for name in answer.witness)


@pytest.mark.parametrize("claim", OPEN)
def test_what_no_function_is_shown_to_be_is_not_decided(claim: str) -> None:
    assert tresym.check(claim).verdict is Verdict.UNDECIDED


TERMS = {
    "sum(f(k + 1) - f(k), k, 1, n) == f(n + 1) - f(1)": "PROVED",
    "sum(f(k) + c*g(k), k, 1, n) == sum(f(k), k, 1, n) + c*sum(g(k), k, 1, n)": "PROVED",
    "sum(fn_a(k + 1), k, 1, n) == sum(fn_a(k), k, 2, n + 1)": "PROVED",
    "sum(fn_a(k)**2, k, 1, n) >= 0": "PROVED",
    "sum(fn_a(k), k, 1, n) == n*fn_a(k)": "",
    "sum(fn_a(k)*fn_b(k), k, 1, n) == fn_b(k)*sum(fn_a(k), k, 1, n)": "",
    "sum(f(k + 1) - f(k), k, 1, n) == f(n) - f(1)": "",
    "sum(fn_a(k), k, 1, oo) == fn_a(1) + sum(fn_a(k), k, 2, oo)": "",
    "limit(fn_a(k)/k, k, oo) == 0": "",
}


@pytest.mark.parametrize("claim", TERMS)
def test_sums_of_terms_of_unknown_sequences(claim: str) -> None:
    found = tresym.check(claim).verdict
    assert (found is Verdict.PROVED) is (TERMS[claim] == "PROVED")


@pytest.mark.parametrize(
    ("claim", "verdict"),
    [
        ("f(n) + g(n) == g(n) + f(n) given n integer", "PROVED"),
        ("(-1)**(2*n)*f(n) == f(n) given n integer", "PROVED"),
        ("(-1)**n*f(n) == f(n) given n integer", "REFUTED"),
    ],
)
def test_unknown_functions_of_integers(claim: str, verdict: str) -> None:
    assert tresym.check(claim).verdict.value == verdict


@pytest.mark.parametrize(
    "claim",
    [
        "y(t) == t**3 given diff(y(t), t) == 3*cbrt(y(t))**2, y(0) == 0, t >= 0",
        "y(t) == 1/(1 - t) given diff(y(t), t) == y(t)**2, y(0) == 1, t >= 0",
        "y(t) == sin(t) given diff(y(t), t, 2) == -4*y(t), y(0) == 0",
    ],
)
def test_conditions_on_the_function_itself_are_not_asked_for_without_end(claim: str) -> None:
    assert tresym.check(claim).verdict is Verdict.UNDECIDED
