"""Functions left unknown: what holds of every smooth function, and a function where it fails."""

import pytest
from cases import cases

import tresym
from tresym.reals.verdict import Verdict

FAIL = cases(__file__, "FAIL")


@pytest.mark.parametrize("claim", FAIL)
def test_what_fails_of_one_gives_its_values(claim: str) -> None:
    answer = tresym.check(claim)
    assert answer.verdict is Verdict.REFUTED
    assert answer.witness
    assert any("f(" in name for name in answer.witness)


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
