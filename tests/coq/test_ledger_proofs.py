"""A search: what is stored is not asked again, and what takes too long is given up."""

from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

import pytest

from tresym.coq import ledger_proofs
from tresym.coq.export import stamped
from tresym.coq.ledger_proofs import Memory, lemma_proof
from tresym.coq.ledger_statements import theorem_of
from tresym.coq.lemma_proofs import plans
from tresym.coq.statement import Theorem
from tresym.ledger.paper import all_claims
from tresym.reals.language.expression import symbol
from tresym.reals.language.formula import Relation

X = symbol("x")
LEMMA = Theorem("lemma", ("x",), (), (), (), Relation(X, "==", X))


def test_a_stored_proof_of_a_lemma_is_not_asked_again() -> None:
    row = {"lemmas": f"{LEMMA.text}\nProof.\nreflexivity.\nQed.", "script": "", "uses": []}
    store = {"claims": {"some": stamped(row, {"claims": {}}, "8.16")}}
    memory = Memory(None, store)
    assert lemma_proof(LEMMA, memory) == "reflexivity."
    assert memory.coq is None


def test_a_stored_proof_of_a_lemma_that_was_replaced_is_not_taken() -> None:
    row = {"lemmas": f"{LEMMA.text}\nProof.\nreflexivity.\nQed.", "script": "", "uses": []}
    held = stamped(row, {"claims": {}}, "8.16")
    replaced = held | {"lemmas": row["lemmas"].replace("reflexivity", "lra")}
    assert not Memory(None, {"claims": {"some": replaced}}).known


def test_what_is_known_of_a_text_is_kept(tmp_path: Path) -> None:
    memory = Memory(tmp_path / "search.json")
    memory.known["lemma of old"] = "lra."
    memory.keep()
    assert Memory(tmp_path / "search.json").known == {"lemma of old": "lra."}


def test_what_takes_too_long_is_given_up(monkeypatch: pytest.MonkeyPatch) -> None:
    def endless() -> Iterator[str]:
        yield "lra."
        while True:
            with suppress(Exception):  # as provers do that find terms too large
                sum(range(1000))

    monkeypatch.setattr(ledger_proofs, "WRITING_SECONDS", 0.05)
    assert list(ledger_proofs._found_soon(endless())) == ["lra."]


def test_a_claim_with_values_put_into_another_applies_its_theorem() -> None:
    """The facts that it cites come first; no lemma is needed."""
    claim = next(claim for claim in all_claims() if claim.label == "sine_of_the_time")
    plan = next(p for p in plans(claim, theorem_of(claim)) if "W_0" in p.script)
    assert plan.lemmas == ()
    assert plan.uses == ("phase_range", "hyperbolic_sine_rises")
    assert "pose proof (claim_hyperbolic_sine_rises (v_P * sqrt (a * b)) " in plan.script
    assert plan.script.index("claim_phase_range") < plan.script.index("W_0")
