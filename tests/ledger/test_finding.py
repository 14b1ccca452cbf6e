"""Findings: values with nothing in them that was not found."""

from dataclasses import FrozenInstanceError

import pytest

from tresym.ledger.finding import RULINGS, Finding, Premise, StepFinding
from tresym.reals.verdict import Verdict


def test_what_is_not_found_is_not_there() -> None:
    found = Finding(Verdict.UNDECIDED, "why")
    nothing = (found.value, found.constant, found.region, found.parameter, found.witness)
    assert nothing == (None,) * 5
    assert found.steps == found.trees == ()


def test_premises_hold_and_are_counted_apart() -> None:
    assert all(premise.holds for premise in Premise)
    names = [ruling.value for ruling in RULINGS]
    assert names == ["PROVED", "ENCLOSED", "REFUTED", "UNDECIDED", "DEFINED", "ASSUMED"]


def test_findings_do_not_change() -> None:
    for found in (Finding(Verdict.UNDECIDED, "why"), StepFinding(Verdict.UNDECIDED, "why")):
        with pytest.raises(FrozenInstanceError):
            found.verdict = Verdict.PROVED
