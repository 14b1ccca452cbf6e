"""Refutations of asymptotic claims: none leaves that the complete statement does not support."""

import pytest
from cases import cases

import tresym
from tresym.asymptotics import path_claims, refutation_check
from tresym.asymptotics.refutation_check import checked
from tresym.checking import dispatch
from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.expansions import leading_terms
from tresym.reals.verdict import Verdict

DEPENDENT_WAVES = cases(__file__, "DEPENDENT_WAVES")
"""True: one phase determines the other."""
NESTED = ["sin(sin(2*x)) == O(sin(x)) as x -> oo", "exp(sin(2*x)) - 1 == O(sin(x)) as x -> oo"]
NOT_REAL = [
    "sqrt(sin(x)) == O(1 + sin(x)) as x -> oo",
    "sqrt(sin(x) - 1/2) == O(sin(x)) as x -> oo",
    "log(sin(x)) == O(1/sin(x)) as x -> oo",
    "sqrt(sin(1/x) - 1/3) == O(sin(1/x)) as x -> 0",
]
"""True: where the gauge vanishes the left side is not real."""
INTEGERS = [
    ("limit(sin(n*x), x, pi) == 0 given n integer, n > 0", {"n": "1/2", "x": "3"}),
    ("x**n == O(x) as x -> 0+ given n integer, n > 0", {"n": "1/2"}),
    ("exp(-n*x) == O(exp(-x)) as x -> oo given n integer, n > 0", {"n": "1/2"}),
    ("limit(sin(x), x, n*pi) == 0 given n integer, n > 0", {"n": "1/2"}),
    ("a*x == O(x**2) as x -> 0 given a == 0", {"a": "1"}),
    ("x**a == O(1) as x -> 0+ given a > 0", {"a": "-1"}),
    ("x**a == O(1) as x -> 0+ given a >= sqrt(2)", {"a": "7/5"}),
]
"""True, each with values at which it fails, that the conditions exclude."""


@pytest.mark.slow
@pytest.mark.parametrize("claim", DEPENDENT_WAVES + NESTED + NOT_REAL)
def test_what_is_true_is_refuted_by_neither_guard_alone(
    claim: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert tresym.check(claim).verdict is not Verdict.REFUTED
    with monkeypatch.context() as m:  # the symbolic part alone
        m.setattr(refutation_check, "checked", lambda answer, *_: answer)
        assert tresym.check(claim).verdict is not Verdict.REFUTED
    with monkeypatch.context() as m:  # numbers alone, where every order is taken to fail
        m.setattr(leading_terms, "_truth", lambda *_: False)
        m.setattr(path_claims, "_by_exact_limit", lambda *_: None)
        assert tresym.check(claim).verdict is not Verdict.REFUTED


@pytest.mark.parametrize(("claim", "witness"), INTEGERS)
def test_values_that_the_conditions_exclude_refute_nothing(
    claim: str, witness: dict[str, str], monkeypatch: pytest.MonkeyPatch
) -> None:
    assert tresym.check(claim)
    wrong = Answer(Verdict.REFUTED, "so it is said", witness=witness)
    monkeypatch.setattr(dispatch, "_decide", lambda *_: wrong)
    assert tresym.check(claim).verdict is Verdict.UNDECIDED


@pytest.mark.parametrize(
    ("claim", "witness"),
    [
        ("limit(sin(n*x), x, pi/2) == 0 given n integer", {"n": "1"}),
        ("x**n == O(x**2) as x -> 0+ given n integer, n > 0", {"n": "1"}),
        ("x**a == O(1) as x -> 0+ given a**2 == 2", {"a": "-sqrt(2)"}),
        ("sin(x) == O(sin(2*x)) as x -> oo", {}),
        ("sin(x) == O(sin(sqrt(2)*x)) as x -> oo", {}),
        ("sin(x)/x -> 1 + 1/10**50 as x -> 0", {}),
        ("cos(x) < 1 as x -> oo", {"x": "2*pi"}),
    ],
)
def test_what_fails_is_supported(claim: str, witness: dict[str, str]) -> None:
    statement = read(claim)
    said = Answer(Verdict.REFUTED, "so it is said", witness=witness)
    assert checked(said, statement.comparisons[0], statement).verdict is Verdict.REFUTED


def test_parameters_of_no_use_get_values() -> None:
    statement = read("a*x -> 2 as x -> 0 given a > 0, b > 3, b != 5, m integer, m > 2")
    said = Answer(Verdict.REFUTED, "so it is said", witness={"a": "1"})
    found = checked(said, statement.comparisons[0], statement)
    assert found.verdict is Verdict.REFUTED
    assert found.witness is not None
    assert found.witness.keys() >= {"a", "b"}
    statement = read("a*x -> 2*a as x -> 1 given a**2 == 4, b > 3")
    said = Answer(Verdict.REFUTED, "so it is said", witness={"b": "4"})
    found = checked(said, statement.comparisons[0], statement)
    assert found.verdict is Verdict.REFUTED
    assert found.witness is not None
    assert found.witness["a"] in ("2", "-2")


@pytest.mark.parametrize("claim", DEPENDENT_WAVES)
def test_dependent_waves_are_functions_of_one_phase(claim: str) -> None:
    assert tresym.check(claim).verdict in (Verdict.PROVED, Verdict.ENCLOSED)
