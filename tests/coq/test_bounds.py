"""Bounds on regions that Coq proves, and sharper false ones, which the same proofs do not reach."""

from collections.abc import Iterator

import pytest
from cases import cases

from tresym.coq.coqtop import Dialogue
from tresym.coq.export import stored
from tresym.coq.ledger_statements import Theorem, lemmas, theorem_of
from tresym.ledger.paper import all_claims

SECONDS = 12
SHARPER = tuple(cases(__file__, "SHARPER"))
"""A bound and a sharper one; the constants stand in the statement and, mostly, in its proof."""


@pytest.fixture(scope="module")
def coq() -> Iterator[Dialogue]:
    with Dialogue(SECONDS, lemmas()) as dialogue:
        yield dialogue


def _text(label: str, old: str = "", new: str = "") -> str:
    """Return the theorem of a claim and its stored proof, with ``new`` for ``old`` in both."""
    (claim,) = (c for c in all_claims([label]) if c.label == label)
    row, whole = stored()["claims"][label], theorem_of(claim)
    assert isinstance(whole, Theorem)
    assert not row["uses"]
    assert old in whole.text
    text = f"{whole.text}\nProof.\n{row['script']}\nQed."
    return text.replace(old, new) if old else text


@pytest.mark.coq
@pytest.mark.parametrize("label", ["corner_margin", "bend_leaves", "repaired_from_10"])
def test_a_bound_is_proved(coq: Dialogue, label: str) -> None:
    assert coq.accepts(_text(label), SECONDS)


@pytest.mark.coq
@pytest.mark.parametrize(("label", "bound", "sharper"), SHARPER)
def test_a_sharper_bound_is_not_proved(coq: Dialogue, label: str, bound: str, sharper: str) -> None:
    assert not coq.accepts(_text(label, bound, sharper), SECONDS)
