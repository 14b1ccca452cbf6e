"""Integer variables: angles and signs by residues, refuted at integers alone."""

import pytest
from cases import cases

import tresym
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.decisions.integer_variables import residues
from tresym.reals.domain.conditions import Given
from tresym.reals.verdict import Verdict

FAIL = cases(__file__, "FAIL")


@pytest.mark.parametrize("claim", FAIL)
def test_what_fails_of_them_fails_at_an_integer(claim: str) -> None:
    answer = tresym.check(claim)
    assert answer.verdict is Verdict.REFUTED
    assert answer.witness is not None
    assert int(answer.witness["n"]) is not None


@pytest.mark.parametrize(("angle", "count"), [("6", 42), ("8", None)])
def test_a_claim_is_split_into_all_residue_classes_or_into_none(
    angle: str, count: int | None
) -> None:
    statement = read(f"cos(2*pi*n/7)*cos(2*pi*m/{angle}) == 1 given n integer, m integer")
    cases = residues(statement.comparisons[0], statement, ("n", "m"), Given())
    assert (cases and len(cases)) == count
