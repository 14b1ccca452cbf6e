"""Claims about solutions of differential equations: a list with known truth, and guards."""

from __future__ import annotations

from pathlib import Path

import pytest

from tresym.checking import solution_check
from tresym.checking.dispatch import decide_claim
from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.verdict import Verdict

DATA = Path(__file__).parent.parent / "data" / "asymptotics" / "solutions.txt"
SAMPLE = 4
LEAST_DECIDED = 0.9
NUMERICALLY_OPEN = ("O(e) given e*diff", "uniformly", "o(exp(-2*t))")
"""Boundary layers and uniformity are not looked at by a numerical solution at fixed points, and at
the late times of a limit exp(-2*t) is smaller than its error."""


def _rows(kinds: str) -> list[tuple[str, str]]:
    lines = (line.partition(" ") for line in DATA.read_text().splitlines())
    return [(kind, claim) for kind, _, claim in lines if kind in list(kinds)]


def _is_right(kind: str, verdict: Verdict) -> bool:
    return verdict.holds if kind == "T" else verdict is Verdict.REFUTED


@pytest.mark.parametrize(("kind", "claim"), _rows("TF")[1::SAMPLE])
def test_claims_of_known_truth(kind: str, claim: str) -> None:
    assert _is_right(kind, decide_claim(claim).verdict)


@pytest.mark.night
def test_most_claims_of_known_truth_are_decided_and_none_wrongly() -> None:
    verdicts = [(kind, decide_claim(claim).verdict) for kind, claim in _rows("TF")]
    decided = [(kind, v) for kind, v in verdicts if v is not Verdict.UNDECIDED]
    assert all(_is_right(kind, v) for kind, v in decided)
    assert len(decided) >= LEAST_DECIDED * len(verdicts)


@pytest.mark.parametrize("claim", [claim for _, claim in _rows("G")])
def test_what_must_not_pass(claim: str) -> None:
    assert not decide_claim(claim)


@pytest.mark.night
@pytest.mark.parametrize(("kind", "claim"), _rows("TF"))
def test_the_truth_is_that_of_a_numerical_solution(kind: str, claim: str) -> None:
    statement = read(claim)
    passed = Answer(Verdict.PROVED, "")
    found = solution_check.contradiction(statement.comparisons[0], statement, passed)
    if kind == "T" or not any(text in claim for text in NUMERICALLY_OPEN):
        assert (found is not None) == (kind == "F")
