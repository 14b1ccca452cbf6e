"""Definite integrals: values that are proved, bounds, and what each guard keeps out."""

import pytest
from cases import cases

import tresym
from tresym.reals.decisions import antiderivatives, integrals
from tresym.reals.domain.conditions import Given
from tresym.reals.language.parsing import parse
from tresym.reals.verdict import Verdict

PROVED = cases(__file__, "PROVED")
REFUTED = cases(__file__, "REFUTED")


@pytest.mark.parametrize("claim", REFUTED)
def test_a_false_value_is_refuted(claim: str) -> None:
    answer = tresym.check(claim)
    assert answer.verdict is Verdict.REFUTED
    assert answer.witness is not None


@pytest.mark.parametrize(
    ("f", "function", "low", "high"),
    cases(__file__, "what_is_no_antiderivative_between_the_ends"),
)
def test_what_is_no_antiderivative_between_the_ends(
    f: str, function: str, low: str, high: str
) -> None:
    ends = [integrals.INFINITY if e == "oo" else parse(e) for e in (low, high)]
    found = integrals._difference("x", parse(f), parse(function), ends[0], ends[1], Given())
    assert found is None


def test_a_wrong_suggestion_proves_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(antiderivatives, "suggested", lambda *_: [parse("x"), parse("-1/x")])
    for claim in ("integral(x + 1, x, 0, 1) == 3/2", "integral(1/x**2, x, -1, 1) == -2"):
        assert tresym.check(claim).verdict is not Verdict.PROVED


def test_an_antiderivative_may_be_written_in_the_claim(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(antiderivatives, "suggested", lambda *_: [])
    for function, verdict in (("x**2/2", Verdict.PROVED), ("x**3/2", Verdict.UNDECIDED)):
        value = f"at({function}, x, 1) - at({function}, x, 0)"
        assert tresym.check(f"integral(x, x, 0, 1) == {value}").verdict is verdict
    assert tresym.check("integral(x, x, 0, 1) == at(x, x, 1)").verdict is Verdict.REFUTED


def test_either_order_of_the_ends_is_looked_at(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(integrals, "_by_quadrature", lambda *_: None)
    claim = "integral(abs(x - a), x, a, b) == (b - a)**2/2"  # for b < a it is less than 0
    assert tresym.check(claim).verdict is not Verdict.PROVED
    assert tresym.check(f"{claim} given a < b").verdict is Verdict.PROVED


@pytest.mark.parametrize("claim", PROVED)
def test_an_integral_with_an_antiderivative(claim: str) -> None:
    assert tresym.check(claim).verdict is Verdict.PROVED
