"""Roots of equations near a number: proved by the residual, and no false bound is."""

import time

import pytest
from cases import cases

from tresym.coq.candidate_search import bound, found_by
from tresym.coq.claim_export import theorems
from tresym.coq.coqtop import HEAD, Dialogue
from tresym.coq.statement import Theorem
from tresym.reals.decisions.claim_parsing import read

TRUE, FALSE = cases(__file__, "TRUE"), cases(__file__, "FALSE")
QUICK = 1
"""How many of each are asked by ``pytest -m coq``; the others every night."""


def proved(claim: str, coq: Dialogue) -> bool:
    (found,) = theorems(read(claim))
    assert isinstance(found, Theorem)
    return found_by(found, coq, time.monotonic() + 60) is not None


def dialogue() -> Dialogue:
    return Dialogue(lemmas=HEAD + bound(theorems(read(TRUE[0]))))


@pytest.mark.coq
def test_a_root_is_near_and_not_nearer() -> None:
    with dialogue() as coq:
        assert all(proved(claim, coq) for claim in TRUE[:QUICK])
        assert not any(proved(claim, coq) for claim in FALSE[:QUICK])


@pytest.mark.coq
@pytest.mark.night
def test_of_all_bounds_the_true_ones_are_proved() -> None:
    with dialogue() as coq:
        assert not [claim for claim in FALSE[QUICK:] if proved(claim, coq)]
        assert not [claim for claim in TRUE[QUICK:] if not proved(claim, coq)]
