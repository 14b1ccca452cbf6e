"""The ledger's claims as theorems: their definitions, their conditions, and what is exported."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from pathlib import Path

import pytest

from tresym.commands import main
from tresym.coq import export
from tresym.coq.ledger import candidates, name_of, stamp, theorems_of
from tresym.coq.statement import NotExportedError, Theorem
from tresym.ledger.claim import Claim, Counterexample, Definition, Printed
from tresym.ledger.paper import all_claims
from tresym.reals.language.expression import symbol
from tresym.reals.places.conditions import Given
from tresym.reals.verdict import Verdict

BEYOND = re.compile(r"\b(Admitted|Axiom|Axioms|Parameter|Parameters|Conjecture|admit|Abort)\b")
STORE = export.stored()


def exported() -> list[tuple[Claim, list[Theorem]]]:
    found = []
    for claim in all_claims():
        try:
            found.append((claim, theorems_of(claim)))
        except NotExportedError:
            continue
    return found


EXPORTED = exported()


def test_theorems_of_claims_have_names_of_their_own() -> None:
    names = [t.name for _, found in EXPORTED for t in found]
    assert len(set(names)) == len(names)
    assert all(re.fullmatch(r"claim_\w+", name) for name in names)
    assert len(EXPORTED) > 250


def test_conditions_of_a_claim_are_premises_and_nothing_is_assumed_that_it_says() -> None:
    for claim, found in EXPORTED:
        for t in found:
            if isinstance(claim.proof, Printed):
                continue
            says = (t.left, t.relation, t.right)
            assert says not in t.given, t.name
            assert set(Given.from_sympy(*claim.given).comparisons) <= set(t.given), t.name


def test_a_definition_is_a_premise_once_and_does_not_come_back_to_itself() -> None:
    for claim, found in EXPORTED:
        if isinstance(claim.proof, Printed | Counterexample):
            continue
        for t in found:
            defined = [x for x, relation, _ in t.given if relation == "=="]
            assert len(set(defined)) == len(defined), t.name
            assert all(x.op == "symbol" for x in defined)


def test_what_is_refuted_is_exported_as_its_counterexample_alone() -> None:
    for claim, found in EXPORTED:
        if claim.expect is Verdict.REFUTED:
            assert isinstance(claim.proof, Counterexample)
            assert all(t.exists for t in found)


def test_a_definition_has_no_theorem() -> None:
    claim = next(c for c in all_claims() if isinstance(c.proof, Definition))
    with pytest.raises(NotExportedError, match="definition"):
        theorems_of(claim)


def test_stored_proofs_are_of_statements_that_stand() -> None:
    by_label = {claim.label: found for claim, found in EXPORTED}
    kept = {k: v for k, v in STORE["claims"].items() if k in by_label}
    stands = [label for label, row in kept.items() if row["statement"] == stamp(by_label[label])]
    assert len(stands) > len(STORE["claims"]) / 3
    for label in stands:
        assert kept[label]["proofs"].keys() <= {t.name for t in by_label[label]}


def test_a_statement_that_changed_has_no_proof() -> None:
    claim, found = next((c, f) for c, f in EXPORTED if export.entry(c, STORE).status == "proved")
    changed = {**STORE["claims"][claim.label], "statement": "0" * 16}
    store = {**STORE, "claims": {**STORE["claims"], claim.label: changed}}
    assert export.entry(claim, store).status == "none"
    assert found


def test_the_files_assume_nothing_and_the_index_names_every_claim(tmp_path: Path) -> None:
    index = export.write(tmp_path, (), STORE)
    assert index.keys() == {claim.label for claim in all_claims()}
    assert json.loads((tmp_path / "index.json").read_text(encoding="utf-8")) == index
    project = (tmp_path / "_CoqProject").read_text().split()
    assert {path.name for path in tmp_path.glob("*.v")} == set(project[3:])
    for path in tmp_path.glob("*.v"):
        text = path.read_text(encoding="utf-8")
        assert not BEYOND.search(text), path.name
        assert text.count("\nQed.") >= text.count("Print Assumptions")
    states = [row["status"] for row in index.values()]
    assert states.count("proved") > 50


def test_an_unknown_label_is_bad_input(tmp_path: Path) -> None:
    assert main(["export", "--coq", str(tmp_path), "xyz"]) == 2


def test_names_and_stamps() -> None:
    assert name_of("eq:gamma") == "claim_eq_gamma"
    _, found = EXPORTED[0]
    other = Theorem("claim_other", (), (), (), symbol("x"), "==", symbol("x"))
    assert stamp(found) != stamp([*found, other])
    assert list(candidates(EXPORTED[0][0], found[0]))


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("coqc") is None, reason="coqc is not installed")
def test_coq_accepts_what_is_exported(tmp_path: Path) -> None:
    label = next(c.label for c, _ in EXPORTED if export.entry(c, STORE).status == "proved")
    assert main(["export", "--coq", str(tmp_path), label]) == 0
    done = subprocess.run(["make"], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
