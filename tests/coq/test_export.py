"""The files of Coq: nothing is assumed in them, and every claim is in the index."""

import json
import os
import re
import subprocess
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from random import Random
from typing import Any

import pytest
from cases import cases
from flint import arb

from tresym.commands import main
from tresym.commands.export import _need_compiled
from tresym.coq import export
from tresym.coq.checked_proofs import checked, library
from tresym.coq.coqtop import accepted
from tresym.coq.ledger_statements import conditions_of, theorem_of
from tresym.coq.lemma_proofs import candidates, plans
from tresym.coq.statement import NotExportedError, Theorem, comparison, variable
from tresym.dev.corpus.rewriting import changed
from tresym.ledger.paper import all_claims
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.expression import Expr, symbols
from tresym.reals.language.formula import Relation
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.report.pages import coq_page

BEYOND = re.compile(r"\b(Admitted|Axiom|Axioms|Parameter|Parameters|Conjecture|admit|Abort)\b")
STORE = export.stored()


def proved() -> list[str]:
    return [label for label, entry in coq_page.found().items() if entry.status == "proved"]


def test_a_statement_that_changed_has_no_proof() -> None:
    label = proved()[0]
    changed = {**STORE["claims"][label], "statement": "0" * 16}
    store = {**STORE, "claims": {**STORE["claims"], label: changed}}
    assert export.entries(store, [label])[label].status == "none"


def test_coq_has_checked_every_stored_proof_as_it_stands() -> None:
    """By hashes alone; if this fails, ``make`` and ``tresym export --coq DIR --check`` are due."""
    exported = export.entries(STORE, unchecked=True)
    assert not [
        n for n, entry in exported.items() if entry.script and not coq_page.found()[n].checked
    ]
    found = export.library_text()
    assert all(checked(row, (), found) for row in STORE["possible"].values())


def test_every_claim_whose_statement_is_new_or_changed_has_a_proof_or_is_listed() -> None:
    """By hashes alone; ``tresym export --coq DIR --search`` looks for proofs that are missing.

    ``tests/data/lists/coq/export.txt`` lists the claims that have a theorem in Coq but no complete
    proof. A claim that is proved has to leave the list, which only gets shorter.
    """
    assert STORE["claims"].keys() <= coq_page.found().keys()
    missing = {
        label
        for label, entry in coq_page.found().items()
        if entry.theorem is not None and entry.status in ("none", "partial")
    }
    assert missing == {*cases(__file__, "OPEN")}


def text_of(label: str) -> str:
    """The lemmas and the script stored for a claim."""
    return f"{STORE['claims'][label]['lemmas']}\n{STORE['claims'][label]['script']}"


def changed_row(label: str, **changes: str) -> dict[str, Any]:
    """The store with another row for a claim."""
    return {**STORE, "claims": {**STORE["claims"], label: STORE["claims"][label] | changes}}


@pytest.mark.parametrize("change", [{"script": "nonsense."}, {"lemmas": "Axiom wrong : 0 = 1."}])
def test_a_replaced_script_or_lemma_is_not_proved(change: dict[str, str]) -> None:
    label = next(label for label in proved() if "intros" in STORE["claims"][label]["script"])
    store = changed_row(label, **change)
    entry = export.entries(store, [label])[label]
    assert (entry.status, entry.checked) == ("none", "")
    assert "has not checked" in entry.why
    assert export.entries(store, [label], unchecked=True)[label].status == "proved"


def test_another_version_of_coq_or_another_day_is_not_what_checked_it() -> None:
    label = proved()[0]
    row = STORE["claims"][label]
    for change in ({"coq": "9.0"}, {"day": "2020-01-01"}, {"stamp": "0" * 16}):
        store = changed_row(label)
        store["claims"][label] = row | {"checked": row["checked"] | change}
        assert export.entries(store, [label])[label].status == "none"


def test_a_changed_statement_of_a_theorem_it_applies_is_noticed() -> None:
    label = next(label for label in proved() if STORE["claims"][label]["uses"])
    used = STORE["claims"][label]["uses"][0]
    store = changed_row(used, statement="0" * 16)
    assert export.entries(store, [label])[label].status != "proved"
    row = STORE["claims"][label]
    assert not checked(row, export.applied(row, store), export.library_text())


def test_a_changed_lemma_of_the_library_is_noticed_by_what_uses_it_alone() -> None:
    found = export.library_text()
    lemma = "Lemma share_below "
    assert lemma in found
    unchanged = found + "Lemma of_nothing : 0 = 0.\nProof. reflexivity. Qed.\n"
    other = found.replace(lemma, "Lemma share_below (unused : R) ")

    def held(text: str) -> set[str]:
        rows = STORE["claims"].items()
        return {n for n, row in rows if checked(row, export.applied(row, STORE), text)}

    assert held(unchanged) == held(found)
    lost = held(found) - held(other)
    assert lost
    assert len(lost) < 100
    assert all("share_below" in library(found).behind(text_of(n)) for n in lost)
    assert not held(found + "Set Universe Polymorphism.\n")


def test_a_theorem_whose_premise_has_no_proof_is_proved_in_part() -> None:
    label = next(label for label in proved() if STORE["claims"][label]["uses"])
    used = STORE["claims"][label]["uses"][0]
    rest = {k: row for k, row in STORE["claims"].items() if k != used}
    found = export.entries({**STORE, "claims": rest}, [label])[label]
    assert found.status in ("partial", "none")
    assert found.status == "none" or used in found.premises


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    found = tmp_path_factory.mktemp("exported")
    export.write(found, (), STORE)
    return found


def test_the_files_assume_nothing_and_the_index_names_every_claim(folder: Path) -> None:
    index = json.loads((folder / "index.json").read_text(encoding="utf-8"))
    assert index.keys() == {claim.label for claim in all_claims()}
    project = (folder / "_CoqProject").read_text().split()
    assert {path.name for path in folder.glob("*.v")} == {n for n in project if n.endswith(".v")}
    for path in folder.glob("*.v"):
        assert not BEYOND.search(path.read_text(encoding="utf-8")), path.name
    said = (folder / "Statements.v").read_text(encoding="utf-8")
    assert said.count("Definition says_") == sum(
        row["theorem"] is not None for row in index.values()
    )
    assert len(proved()) > 500


def test_what_the_theorems_rest_on_is_asked_once_for_each_kind(folder: Path) -> None:
    asked = (folder / "Ledger.v").read_text(encoding="utf-8").count("Print Assumptions")
    assert asked == 2
    reals, floats = "Axioms:\nClassical_Prop.classic : P\n", "Axioms:\nPrimFloat.add : float\n"
    found = export.assumed(folder, reals + floats)
    assert set(found.values()) == {
        "it rests on the classical reals alone",
        "it rests on the classical reals and at most on Coq's machine integers and floats",
    }
    beyond = export.assumed(folder, "Axioms:\nmine : 0 = 1\n" + floats)
    assert any("mine" in text for text in beyond.values())


def test_a_lemma_that_computes_with_floats_is_asked_about_with_the_others_that_do(
    folder: Path,
) -> None:
    text = (folder / "Ledger.v").read_text(encoding="utf-8")
    reals, floats = re.findall(r"Definition by_\w+ :=\s+\((.*)\)\.", text)
    assert "interval" not in STORE["claims"]["d57"]["script"]  # its lemmas use it
    assert "claim_d57" in floats.split(", ")
    assert "claim_d57" not in reals.split(", ")
    assert len(reals.split(", ")) > 400


def test_conditions_are_shown_to_hold_somewhere() -> None:
    rows = STORE.get("possible", {}).values()
    assert all(row["body"].lstrip().startswith("exists") for row in rows)


def test_of_each_set_of_conditions_a_point_is_proved() -> None:
    """But of one, which bounds an integral, and where the point itself is given."""
    store, left = {row["body"] for row in STORE["possible"].values()}, []
    for claim in all_claims():
        try:
            given = conditions_of(claim.given)
        except InputError:
            continue
        names = sorted(frozenset().union(*(symbols(c.left) | symbols(c.right) for c in given)))
        body = " /\\\n".join(f"  {comparison(*c)}" for c in given)
        body = f"  exists {' '.join(map(variable, names))} : R,\n{body}"
        if names and all(c.sign != "==" for c in given) and body not in store:
            left.append(claim.label)
    assert left == ["symmetric_maximum"]


def test_an_unknown_label_is_bad_input(tmp_path: Path) -> None:
    assert main(["export", "--coq", str(tmp_path), "xyz"]) == 2


@pytest.mark.coq
def test_coq_accepts_what_is_exported(tmp_path: Path) -> None:
    """The central chain, from the condition of one turn to the one root of the exact equation."""
    labels = [label for label in ("d36", "unique_root", "stable_equation") if label in proved()]
    assert main(["export", "--coq", str(tmp_path), *labels]) == 0
    done = subprocess.run(["make"], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


def falsehoods(count: int) -> list[Theorem]:
    """Lemmas of the ledger's claims with a changed right side, false at a point by balls."""
    random, found = Random(8), []
    for claim in all_claims():
        try:
            plan = next(plans(claim, theorem_of(claim)), None)
        except NotExportedError:
            continue
        for lemma in plan.lemmas[:6] if plan else ():
            if lemma.by is not None or lemma.definitions:
                continue
            found += mutants(lemma, random)
        if len(found) >= count:
            break
    return found


def mutants(lemma: Theorem, random: Random) -> Iterator[Theorem]:
    """The lemma with a changed right side, where that is false."""
    seen = {lemma.right}
    for _ in range(4):
        try:
            right = changed(lemma.right, random)
        except InputError:
            continue
        if right not in seen and symbols(right) <= {*lemma.variables}:
            seen.add(right)
            if false_somewhere(lemma, right):
                yield replace(lemma, says=Relation(lemma.left, lemma.relation, right))


def false_somewhere(lemma: Theorem, right: Expr) -> bool:
    """Whether balls exclude the relation at a point where all is defined."""
    for point in Given(lemma.given).points(lemma.variables, 10):
        with ball_precision(100):
            at = {name: arb(x) for name, x in point.items()}
            d = evaluate(lemma.left - right, at)
            needed = [evaluate(e, at) for e, _ in lemma.defined]
            signs = {"==": d != 0, ">": d < 0, ">=": d < 0, "<": d > 0, "<=": d > 0, "!=": False}
            if d.is_finite() and all(v > 0 for v in needed) and signs[lemma.relation]:
                return True
    return False


@pytest.mark.coq
def test_no_falsehood_is_proved() -> None:
    count = int(os.environ.get("FALSEHOODS", "12"))
    false = falsehoods(count)
    assert len(false) >= count
    texts = []
    for n, lemma in enumerate(false):
        proof = next(candidates(lemma), "lra.")
        texts.append(f"Theorem false_{n} :\n{lemma.body}.\nProof.\n{proof}\nQed.")
    held = accepted(texts)
    assert not any(held), [t for t, ok in zip(texts, held, strict=True) if ok]


def test_a_file_that_coq_has_not_compiled_since_is_noticed(tmp_path: Path) -> None:
    source, compiled, said = (tmp_path / name for name in ("Model.v", "Model.vo", "said.txt"))
    for path in (source, compiled, said):
        path.write_text("")
        os.utime(path, (1000, 1000))
    _need_compiled(source, said)
    os.utime(source, (2000, 2000))
    with pytest.raises(InputError, match="has not compiled"):
        _need_compiled(source, said)
    os.utime(compiled, (3000, 3000))
    with pytest.raises(InputError, match="older than"):
        _need_compiled(source, said)
    os.utime(said, (3000, 3000))
    _need_compiled(source, said)
    compiled.unlink()
    with pytest.raises(InputError, match="has not compiled"):
        _need_compiled(source, said)
