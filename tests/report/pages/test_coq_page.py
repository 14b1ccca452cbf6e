"""The page on Coq: what is proved, which premises stay, and every word of the statements."""

import re

import pytest

from tresym.commands import main
from tresym.coq import export
from tresym.coq.coqtop import prelude
from tresym.coq.ledger_statements import Joint
from tresym.coq.statement import Theorem
from tresym.ledger.claim import (
    AllOf,
    Dominated,
    Follows,
    InfimumBy,
    RootMonotone,
)
from tresym.ledger.finding import Finding
from tresym.ledger.paper import all_claims
from tresym.ledger.verification import Row, verify
from tresym.reals.verdict import Verdict
from tresym.report.pages import coq_page
from tresym.report.pages.trusted_code import trusted

BOUND = re.compile(r"\b(?:forall|exists !|exists|fun) ([^:]*) : R\b")


def test_every_function_in_a_statement_is_explained() -> None:
    defined = set(re.findall(r"\(\* .*? \*\)\nDefinition (\w+)", prelude()))
    words, variables = set(), set()
    for entry in coq_page.found().values():
        if isinstance(entry.theorem, Theorem):
            text = re.sub(r"\(\*.*?\*\)", "", entry.theorem.body)
            words |= set(re.findall(r"[A-Za-z_][\w']*", text))
            for names in BOUND.findall(text):
                variables |= {*names.split()}
    assert words - variables - defined - {*coq_page.LIBRARY} <= {"forall", "exists", "fun", "R"}


def test_the_page_says_what_is_proved_and_which_premises_stay() -> None:
    page = coq_page.page()
    proved = sum(entry.status == "proved" for entry in coq_page.found().values())
    assert f"Coq proves {proved} of the {len(coq_page.found())} claims (checked with " in page
    assert f"{trusted(coq_page.STATEMENTS):,} lines of Python turn a claim" in page
    label, entry = next(
        (n, e) for n, e in coq_page.found().items() if e.undefined and e.status == "proved"
    )
    assert f"| `{label}` | `{entry.undefined[0]}`" in page
    assert "Definition is_root" in page
    assert "Definition cot " not in page  # since no statement uses it


def test_the_theorem_of_a_claim_is_shown_without_the_premises_that_are_proved() -> None:
    label = next(n for n, e in coq_page.found().items() if e.left == () and e.status == "proved")
    found = coq_page.shown(verify(label)[label], coq_page.found())
    assert found
    assert "(* defined *)" not in found["text"]
    assert found["undefined"] == []
    joint = next(
        n
        for n, e in coq_page.found().items()
        if isinstance(e.theorem, Joint) and export.strengthened(n, coq_page.found())
    )
    found = coq_page.shown(verify(joint)[joint], coq_page.found())
    assert found
    assert "stronger_" in found["text"]


def test_verify_says_what_coq_proved(capsys: pytest.CaptureFixture[str]) -> None:
    refuted = next(
        claim.label
        for claim in all_claims()
        if claim.expect is Verdict.REFUTED and coq_page.found()[claim.label].status == "proved"
    )
    assert main(["verify", "eq_gamma", refuted]) == 0
    said = capsys.readouterr().out
    assert "    proved in Coq (checked with 8." in said
    assert "    its refutation is proved in Coq (checked with 8." in said


def test_verify_says_nothing_where_the_stamp_does_not_hold(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    store = export.stored()
    store["claims"]["eq_gamma"]["script"] = "nonsense."
    monkeypatch.setattr(coq_page, "stored", lambda: store)
    coq_page.found.cache_clear()
    try:
        assert main(["verify", "eq_gamma"]) == 0
        assert "in Coq" not in capsys.readouterr().out
    finally:
        coq_page.found.cache_clear()


def test_a_claim_without_its_verdict_is_not_called_proved_in_coq() -> None:
    row = verify("eq_gamma")["eq_gamma"]
    known = coq_page.found()
    assert "proved in Coq" in coq_page.sentence(row)
    assert coq_page.mark(row, known)
    for verdict in (Verdict.UNDECIDED, Verdict.REFUTED):
        other = Row(row.claim, Finding(verdict, "as a test"))
        assert coq_page.sentence(other) == ""
        assert coq_page.mark(other, known) is None
        assert coq_page.shown(other, known) is None


def test_no_sentence_in_words_is_proved_in_coq() -> None:
    """Nor one whose last step has no statement in Coq; and quoted theorems are named."""
    known = coq_page.found()
    for claim in all_claims():
        proof = claim.proof
        if isinstance(proof, AllOf | Follows | RootMonotone | InfimumBy | Dominated):
            whole = isinstance(proof, AllOf) and not proof.words
            assert whole or known[claim.label].status != "proved", claim.label
    quoting = next(c for c in all_claims() if c.axioms and known[c.label].status == "proved")
    row = verify(quoting.label)[quoting.label]
    assert f"quoted and not proved: {quoting.axioms[0].name}" in coq_page.sentence(row)
    assert f"`{quoting.label}`" in coq_page.page().partition("also quote theorems")[2]
