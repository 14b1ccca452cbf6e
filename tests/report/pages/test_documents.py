"""Generated documents: pure functions of the ledger, honest about what they show."""

import re
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from pathlib import Path

import pytest

from tresym.ledger.claim import (
    Fault,
)
from tresym.ledger.formulas import sides_of
from tresym.ledger.paper import all_claims, racket
from tresym.ledger.paper import corrections as all_corrections
from tresym.ledger.verification import Report, verify
from tresym.reals.language.expression import Expr
from tresym.reals.verdict import Verdict
from tresym.report.pages import documents
from tresym.report.pages.corrections import FAULTS, corrections
from tresym.report.pages.documents import kept, stale
from tresym.report.typesetting.markdown import sentence
from tresym.report.typesetting.titles import shown_name


@pytest.fixture(scope="module")
def report(judged: Callable[..., Report]) -> Report:
    return judged("table_racket_3_b", "table_racket_3_a", "eq_gamma", "table_str_a")


def test_the_corrections_are_the_refuted_statements_of_the_paper(report: Report) -> None:
    page = corrections(report)
    assert "(`table_racket_3_b`)" in page
    assert "(`racket_3_third_moment`)" in page
    assert "`table_str_a`" not in page
    assert page.count("\n### ") == 2


def test_each_refuted_statement_of_the_paper_is_in_a_correction() -> None:
    refuted = {
        claim.label
        for claim in all_claims()
        if claim.expect is Verdict.REFUTED and claim.where and not claim.paper_says
    }
    named = [label for correction in all_corrections() for label in correction.labels]
    assert set(named) == refuted
    assert {label for label in named if named.count(label) > 1} == {"prop1"}  # it has two formulas


def test_corrections_are_in_order_of_weight_and_each_is_told_once() -> None:
    faults = {claim.label: claim.fault for claim in all_claims()}
    weights = [[*Fault].index(faults[c.labels[0]]) for c in all_corrections()]
    assert weights == sorted(weights)
    assert [fault for fault, _, _ in FAULTS] == [*Fault]
    assert len({c.title for c in all_corrections()}) == len(all_corrections())
    assert len({c.quote for c in all_corrections()}) == len(all_corrections())


def test_a_correction_quotes_the_paper_and_says_what_is_true_and_why() -> None:
    claims = {claim.label: claim for claim in all_claims()}
    for correction in all_corrections():
        leading = claims[correction.labels[0]]
        assert 0 < len(correction.quote) <= 130
        assert leading.amended_by
        assert correction.why or leading.note


def test_the_page_opens_with_the_four_that_matter_most(judged: Callable[..., Report]) -> None:
    page = corrections(judged(*(c.labels[0] for c in all_corrections()[:5])))
    opening = page[: page.index("\n## ")]
    for number, correction in enumerate(all_corrections()[:4], 1):
        assert f"{number}. **{sentence(correction.title)}**" in opening
        assert f"“{sentence(correction.quote)}”" in opening
    assert "5. " not in opening
    for part in ("**Printed:**", "**Decided:**", "**True instead:**", "**Why:**", "**Evidence:**"):
        assert page.count(part) == 5
    assert r"\dots" not in page  # long evidence ends between formulas, not inside one


HEDGED = (
    *("angles_of_the_reference", "angles_rest_at_e1", "d31"),
    *("components_are_sufficient", "each_oscillating_trajectory", "globally_parameterize"),
    *("hyperbolic_levels", "near_flip_likely", "no_tre_far", "not_elementary"),
    *("one_circle_e1", "only_about_the_handle", "slow_on_separatrix", "three_equilibria"),
    "threshold_impossible",
)
"""The paper qualifies these or prints no number; what is refuted is a stricter reading of ours."""


def test_stricter_readings_are_listed_apart_from_statements_of_the_paper(
    judged: Callable[..., Report],
) -> None:
    found = judged(*HEDGED, "d27", "zero_on_separatrix")
    assert {c.label for c in all_claims() if c.paper_says} == set(HEDGED)
    page, apart = corrections(found).split("## Fails only if read more strictly")
    for name in map(shown_name, HEDGED):
        assert f" (`{name}`)\n" in apart
        assert f"`{name}`" not in page
    assert apart.count("**Printed:** ") == apart.count("**Stricter reading:**")
    assert apart.count("Read as:") == len(HEDGED)
    for word in ("approximately", "very likely", r"\simeq", "hyperbolic shape", "very slow"):
        assert word in apart


@pytest.mark.slow
def test_every_page_is_up_to_date(whole: Report) -> None:
    """Pictures and tables are compared in test_processors.py."""
    assert stale(kept(whole)) == []


def test_pages_are_the_same_twice(report: Report) -> None:
    again = verify(["table_racket_3_b", "table_racket_3_a", "eq_gamma", "table_str_a"])
    assert corrections(report) == corrections(again)


README = (Path(__file__).resolve().parents[3] / "README.md").read_text(encoding="utf-8")
_ROW = re.compile(r"^\| (.+) \| (PROVED|ENCLOSED|REFUTED) \| (.+) \|$", re.MULTILINE)
_NUMBER = re.compile(r"(?<![\w^(.])\d+(?:\.\d+|/\d+)?(?![\w)])")
FINDINGS = [row for row in _ROW.findall(README) if "`" in row[0]]


def numbers_in(e: Expr) -> set[Fraction]:
    if e.op == "number":
        return {Fraction(str(e.args[0]))}
    return {q for part in e.args if isinstance(part, Expr) for q in numbers_in(part)}


@pytest.mark.parametrize(("said", "verdict", "truth"), FINDINGS)
def test_the_findings_of_the_readme_are_those_of_the_ledger(
    said: str, verdict: str, truth: str, whole: Report
) -> None:
    labels, reasons = (
        [racket().label_of(name) for name in re.findall(r"`(\w+)`", text)] for text in (said, truth)
    )
    assert {whole[label].finding.verdict.value for label in labels} == {verdict}
    assert all(whole[label].finding.verdict.holds for label in reasons)
    claims = [whole[label].claim for label in (*labels, *reasons)]
    told = " ".join(f"{claim.says} {claim.note}" for claim in claims)
    formulas = [e for c in claims for e in (c.statement, *c.given) if e is not None]
    stated = {q for side in sides_of(tuple(formulas)) for q in numbers_in(side)}
    text = re.sub(r"`\w+`|\]\([^)]*\)|ε₀|b²|I₃", "", f"{said} {truth}")
    for number in _NUMBER.findall(text):
        typed = Fraction(number)
        assert number in told or {typed, typed / 100} & stated, (number, told)


def test_the_readme_shows_findings() -> None:
    assert len(FINDINGS) >= 9


def test_links_of_the_readme_lead_somewhere() -> None:
    root = Path(__file__).resolve().parents[3]
    for page in ("README.md", "CONTRIBUTING.md"):
        text = (root / page).read_text(encoding="utf-8")
        for target in re.findall(r"\]\(([^)#]+)\)", text):
            assert target.startswith("http") or (root / target).exists(), target


def test_what_two_processes_begin_at_once_is_judged_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    judgements = []

    def judge(**_: object) -> Report:
        judgements.append(time.sleep(0.1))
        return Report(())

    monkeypatch.setattr(documents, "site_folder", lambda: tmp_path)
    monkeypatch.setattr(documents, "fingerprint", str)
    monkeypatch.setattr(documents, "verify", judge)
    monkeypatch.setattr(documents, "Report", lambda *_: Report(()))
    monkeypatch.setattr("tresym.ledger.paper.all_claims", tuple)
    with ThreadPoolExecutor(2) as both:
        list(both.map(lambda _: documents.judged(), range(2)))
    assert len(judgements) == 1
