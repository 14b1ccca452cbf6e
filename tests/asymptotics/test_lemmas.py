"""Lemmas on integrals, sums and factorials: lists of claims whose truth is known.

A line of the list is ``true``, ``false`` or ``open`` and a claim; ``open`` are claims without a
meaning near the end of their path, which must be neither proved nor refuted.
"""

from pathlib import Path

import pytest

import tresym
from tresym.reals.verdict import Verdict

LIST = Path(__file__).parents[1] / "data" / "claims" / "lemmas.txt"
CASES = [line.split(" | ", 1) for line in LIST.read_text().splitlines() if line]
EXPECTED = {
    "true": (Verdict.PROVED, Verdict.ENCLOSED),
    "false": (Verdict.REFUTED,),
    "open": (Verdict.UNDECIDED,),
}
SAMPLE = 12
"""Every so many claims of the list are decided by default, all of them at night."""


@pytest.mark.parametrize(("truth", "claim"), CASES[::SAMPLE])
def test_a_sample_is_decided(truth: str, claim: str) -> None:
    assert tresym.check(claim).verdict in EXPECTED[truth]


@pytest.mark.night
@pytest.mark.parametrize(("truth", "claim"), CASES)
def test_all_are_decided(truth: str, claim: str) -> None:
    assert tresym.check(claim).verdict in EXPECTED[truth]


def test_an_answer_names_the_lemma_the_obligation_and_the_constant() -> None:
    claim = "integral(exp(-x*t)/(1+t), t, 0, oo) == 1/x - 1/x**2 + O(1/x**3) as x -> oo"
    answer = tresym.check(claim)
    assert answer.lemma.startswith("Watson's lemma")
    assert any(part.claim.startswith("abs(") for part in answer.obligations)
    assert answer.region == "x > 0"
    assert answer.constant is not None
    assert 2 <= float(answer.constant.mid) < 2.2
