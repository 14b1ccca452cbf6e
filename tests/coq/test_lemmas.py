"""Lemmas that proofs apply, to roots and to sums; none of them proves a falsehood."""

import time

import pytest
from cases import cases

from tresym.coq.bound_statements import BoundTheorem
from tresym.coq.candidate_search import bound, found_by, proofs
from tresym.coq.claim_export import theorems
from tresym.coq.coqtop import HEAD, Dialogue
from tresym.coq.statement import NotExportedError
from tresym.reals.decisions.claim_parsing import read

KINDS = ("ROOTS", "SUMS")
QUICK = 1
"""How many of each are asked by ``pytest -m coq``; the others every night."""


def proved(claims: list[str], seconds: float = 200) -> list[str]:
    """Those of the claims, all of one kind, of which Coq accepts a proof."""
    found = [theorems(read(claim))[0] for claim in claims]
    with Dialogue(lemmas=HEAD + bound(found)) as coq:
        return [
            claim
            for claim, theorem in zip(claims, found, strict=True)
            if found_by(theorem, coq, time.monotonic() + seconds) is not None
        ]


def test_a_sum_is_stated_with_its_terms() -> None:
    """Needs no Coq."""
    (found,) = theorems(read("sum(1/k, k, 1, n) == log(n) + O(1) as n -> oo"))
    assert isinstance(found, BoundTheorem)
    assert found.says == (
        "forall k : nat, (1 <= k)%nat -> INR k <> 0",
        "eventually (fun n : nat => 0 < INR n)",
        "exists C : R, eventually (fun n : nat => Rabs ((terms (fun k : nat => / (INR k)) 1 n) + "
        "(-1) * ln (INR n)) <= C * Rabs (1))",
    )


def test_half_of_the_last_term_is_found_by_trapezoids_and_no_other_share_of_it() -> None:
    """Needs no Coq: the orders of what is left are found, or the proof is not written at all."""

    def written(share: str) -> list[str]:
        claim = f"sum(log(k), k, 1, n) == n*log(n) - n + log(n)*{share} + O(1) as n -> oo"
        (found,) = theorems(read(claim))
        return [*proofs(found, lambda _: "exact I.")]

    assert ["trapezoids_near" in script for script in written("1/2")] == [True]
    assert written("1/3") == written("0") == []


@pytest.mark.parametrize("kind", KINDS)
def test_the_files_of_lemmas_are_there_with_those_that_they_use(kind: str) -> None:
    text = bound(theorems(read(cases(__file__, kind)[0])))
    for lemma in ("whole_beside", "root_by_residual", "by_antiderivative"):
        assert f"Lemma {lemma} " in text


@pytest.mark.parametrize(
    "claim",
    [
        "sum(1/(k + n), k, 1, n) ~ log(2) as n -> oo",  # n in the terms
        "sum(1/k, k, 1, 2*n) ~ log(n) as n -> oo",  # another end
        "sum(1/k^2, k, 2, n) == O(1) as n -> oo",  # another beginning
    ],
)
def test_other_sums_are_not_exported(claim: str) -> None:
    with pytest.raises(NotExportedError):
        theorems(read(claim))


@pytest.mark.coq
@pytest.mark.parametrize("kind", KINDS)
def test_what_is_true_is_proved_and_nothing_else(kind: str) -> None:
    true, false = cases(__file__, kind)[:QUICK], cases(__file__, f"FALSE_{kind}")[:QUICK]
    assert proved([*true, *false]) == true


@pytest.mark.coq
@pytest.mark.night
@pytest.mark.parametrize("kind", KINDS)
def test_the_same_of_all(kind: str) -> None:
    true, false = cases(__file__, kind)[QUICK:], cases(__file__, f"FALSE_{kind}")[QUICK:]
    assert proved([*true, *false]) == true
