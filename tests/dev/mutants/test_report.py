"""The score against mutants: counts add up, and what is believed is named."""

import json
from dataclasses import replace

import pytest
from sympy import Symbol
from sympy_statements import equal

from tresym.dev.mutants.mutants import Mutant
from tresym.dev.mutants.report import (
    MutantReport,
    MutantRow,
    Slip,
    _dependents,
    _survives,
    verify_mutants,
)
from tresym.ledger.claim import (
    Claim,
    Definition,
)
from tresym.ledger.evidence.decided import Decided
from tresym.ledger.evidence.refutation import Denied
from tresym.ledger.finding import RULINGS
from tresym.ledger.paper import all_claims
from tresym.reals.verdict import Verdict

ORDER = [claim.label for claim in all_claims()]
x, y = (Symbol(name, real=True) for name in "xy")
A = Claim("A", equal(x, y), Definition())
B = Claim("B", equal(x, y), Decided((A,)))
FALSE = Mutant("B", "the right side", "x = 2 y", replace(B, says=equal(x, 2 * y)))
BELIEVED, STOPPED = Slip("B", "the right side", "x = 2 y"), Slip("A", "the left side", "2 x = y")


def row(
    claim: Claim,
    *survivors: Slip,
    stopped: tuple[Slip, ...] = (),
    few: str = "",
    **counts: int,
) -> MutantRow:
    full = {v.value: counts.get(v.value, 0) for v in RULINGS}
    return MutantRow(claim.label, full, survivors, stopped, sum(counts.values()), few)


REPORT = MutantReport(
    (
        row(A, stopped=(STOPPED,), REFUTED=3, UNDECIDED=1),
        row(B, BELIEVED, few="short", PROVED=1),
    )
)


def test_counts_add_up() -> None:
    assert REPORT.counts == dict.fromkeys(
        ("PROVED", "ENCLOSED", "REFUTED", "UNDECIDED", "DEFINED", "ASSUMED"), 0
    ) | {"PROVED": 1, "REFUTED": 3, "UNDECIDED": 1}
    assert [r.total for r in REPORT.rows] == [4, 1]
    assert REPORT.survivors == (BELIEVED,)
    assert REPORT.stopped == (STOPPED,)
    assert [r.label for r in REPORT.few] == ["B"]


def test_json_names_survivors_and_claims_with_few_changes() -> None:
    value = json.loads(json.dumps(REPORT.as_json()))
    assert value["counts"] == REPORT.counts
    assert value["survivors"] == [{"label": "B", "place": "the right side", "change": "x = 2 y"}]
    assert value["stopped"] == [{"label": "A", "place": "the left side", "change": "2 x = y"}]
    assert [c["label"] for c in value["claims"]] == ["A", "B"]
    assert value["few"] == [{"label": "B", "changes": 1, "why": "short"}]


@pytest.mark.parametrize("verdict", RULINGS)
def test_a_mutant_survives_where_it_is_believed(verdict: Verdict) -> None:
    assert _survives(FALSE, verdict) is verdict.holds


def test_what_is_false_may_deny_nothing() -> None:
    denied = replace(FALSE, claim=replace(B, proof=Denied((A,), {})))
    assert _survives(denied, Verdict.REFUTED)
    assert not _survives(denied, Verdict.UNDECIDED)


@pytest.mark.slow
def test_processes_find_what_one_finds() -> None:
    labels = ("eq_gamma", "d08", "ratios_of_moments")
    alone, together = (verify_mutants(labels, 1, workers=n) for n in (1, 2))
    assert alone.counts == together.counts
    assert [row.label for row in alone.rows] == sorted(labels, key=ORDER.index)
    assert alone.survivors == ()


def test_dependents_are_those_that_name_a_claim() -> None:
    assert _dependents((A, B)) == {A: (B,), B: ()}
