"""Planted falsehoods: each is false, rests on what holds, and is refused by its guard alone."""

import pytest

from tresym.dev.mutants.seeded_faults import planted
from tresym.ledger.claim import (
    Claim,
    Counterexample,
)
from tresym.ledger.counterexamples import violation
from tresym.ledger.finding import Finding, Premise
from tresym.ledger.judge import judge
from tresym.reals.verdict import Verdict

PLANTED = list(planted())


def label(claim: Claim) -> str:
    return claim.label.removeprefix("planted-")


def judged(claim: Claim) -> dict[str, Finding]:
    found: dict[str, Finding] = {}
    for used in (*claim.rests_on, claim):
        found[used.label] = judge(used, found)
    return found


@pytest.mark.parametrize("claim", PLANTED, ids=label)
def test_none_is_believed_and_all_that_it_rests_on_holds(claim: Claim) -> None:
    found = judged(claim)
    verdict = found.pop(claim.label).verdict
    refused = (Verdict.REFUTED, Verdict.UNDECIDED)
    assert verdict in refused[isinstance(claim.proof, Counterexample) :]
    assert all(f.verdict in (Verdict.PROVED, *Premise) for f in found.values())


@pytest.mark.parametrize("claim", PLANTED, ids=label)
def test_what_refuses_is_a_guard_and_not_the_advocate(claim: Claim) -> None:
    assert not judged(claim)[claim.label].stopped


# What has a pole inside has no value, and a sentence is refuted at a point.
POLES = ("planted-across-a-pole", "planted-without-value", "planted-smoothness")
SEEN = [c for c in PLANTED if c.statement is c.says and c.label not in POLES]


@pytest.mark.parametrize("claim", SEEN, ids=label)
def test_each_formula_is_violated_somewhere(claim: Claim) -> None:
    found = violation(claim.says, claim.given)
    assert found is not None
    if label(claim) == "condition-unsaid":
        assert found.point["t"] < 0
        assert found.point["u"] != 0


def test_each_is_one_claim_and_made_anew() -> None:
    assert len({claim.label for claim in PLANTED}) == len(PLANTED) > 10
    assert [c.says for c in planted()] == [c.says for c in PLANTED]
