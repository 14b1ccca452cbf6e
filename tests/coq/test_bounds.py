"""Bounds on regions that Coq proves, and sharper false ones, which the same proofs do not reach."""

from collections.abc import Iterator

import pytest

from tresym.coq.coqtop import Dialogue
from tresym.coq.export import stored
from tresym.coq.ledger_statements import Theorem, lemmas, theorem_of
from tresym.ledger.paper import all_claims

SECONDS = 12
SHARPER = (
    ("corner_margin", ">= (3 / 8) *", ">= (2 / 5) *"),  # at b = 1, x = 1/10
    ("decay_at_least", "(-3) * PI", "(-2) * PI"),  # everywhere
    ("majorant_exists", "^ 2 < 1", "^ 2 < 2 / 5"),  # at a = 1/4, b = 1
    ("bend_leaves", "> (7 / 2) *", "> (11 / 2) *"),  # everywhere
    ("newton_pi_goes_on", "v_P_pi > 3", "v_P_pi > 4"),  # where b is small
    ("newton_four_goes_on", "v_P_4 > 3", "v_P_4 > 4"),
    ("terms_decrease", "13 / 5", "5 / 4"),  # at a = 1/4, b = 1
    ("printed_error", "17 / 100", "166 / 1000"),  # at a = 400, b = 1
    ("repaired_from_10", "443 / 1000", "441 / 1000"),  # at a = 10, b = 1
    ("repaired_from_1", "669 / 1000", "667 / 1000"),  # at a = 1, b = 1
    ("repaired_from_1_100", "219 / 5", "218 / 5"),  # at a = 1/100, b = 1
)
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
