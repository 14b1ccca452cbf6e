"""Lemmas on integrals, sums and factorials: lists of claims whose truth is known.

A line of ``lemmas.txt`` is ``true``, ``false``, ``open`` or ``beyond`` and a claim; ``open`` are
claims without a meaning near the end of their path, which must be neither proved nor refuted, and
``beyond`` true ones that no lemma reaches yet. A line of
``lemma_falsehoods.txt`` is a guard and a false claim that would pass without it; the claims
of ``slow.txt`` are decided at night, all others in every run.
"""

from pathlib import Path
from typing import Any

import pytest

import tresym
from tresym.reals.verdict import Verdict

DATA = Path(__file__).parents[1] / "data" / "asymptotics"
CASES = [line.split(" | ", 1) for line in (DATA / "lemmas.txt").read_text().splitlines()]
FALSEHOODS = [
    line.split(" | ", 1) for line in (DATA / "lemma_falsehoods.txt").read_text().splitlines()
]
EXPECTED = {
    "true": (Verdict.PROVED, Verdict.ENCLOSED),
    "false": (Verdict.REFUTED,),
    "open": (Verdict.UNDECIDED,),
    "beyond": (Verdict.UNDECIDED,),
}
SLOW = frozenset((DATA / "slow.txt").read_text().splitlines())
"""Claims that take more than 0.6 seconds each; the others are decided in every run."""


def _marked(rows: list[list[str]]) -> list[Any]:
    marks = {True: [pytest.mark.night], False: [pytest.mark.slow]}
    return [pytest.param(*row, marks=marks[row[1] in SLOW]) for row in rows]


@pytest.mark.parametrize(("truth", "claim"), _marked(CASES))
def test_claims_of_known_truth_are_decided(truth: str, claim: str) -> None:
    assert tresym.check(claim).verdict in EXPECTED[truth]


@pytest.mark.parametrize(("guard", "claim"), _marked(FALSEHOODS))
def test_no_false_claim_passes(guard: str, claim: str) -> None:
    assert not tresym.check(claim), guard


def test_an_answer_names_the_lemma_the_obligation_and_the_constant() -> None:
    claim = "integral(exp(-x*t)/(1+t), t, 0, oo) == 1/x - 1/x**2 + O(1/x**3) as x -> oo"
    answer = tresym.check(claim)
    assert answer.lemma.startswith("Watson's lemma")
    assert any(part.claim.startswith("abs(") for part in answer.obligations)
    assert answer.region == "x > 0"
    assert answer.constant is not None
    assert 2 <= float(answer.constant.mid) < 2.2


@pytest.mark.parametrize(
    ("claim", "lemma", "supremum"),
    [
        # the supremum of |left|/|right| over the region, by quadrature to 30 digits
        ("integral(exp(-x*t)/(1+t), t, 0, oo) == 1/x - 1/x**2 + O(1/x**3)", "Watson", 2.0),
        ("integral(exp(-t)/t, t, x, oo) == exp(-x)/x + O(exp(-x)/x**2)", "Laplace", 1.0),
        ("sum(1/k**2, k, n, oo) == 1/n + 1/(2*n**2) + O(1/n**3)", "Euler", 0.1667),
    ],
)
def test_constants_are_close_to_the_supremum(claim: str, lemma: str, supremum: float) -> None:
    name = "n" if "sum" in claim else "x"
    answer = tresym.check(f"{claim} as {name} -> oo")
    assert lemma in answer.lemma
    assert answer.constant is not None
    assert supremum * 0.999 <= float(answer.constant.mid) <= 1.6 * supremum
