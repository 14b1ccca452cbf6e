"""Generated documents: pure functions of the ledger, honest about what they show."""

import re
from pathlib import Path

import pytest

from tresym.ledger.paper import all_claims
from tresym.ledger.verification import Report, verify
from tresym.reals.verdict import Verdict
from tresym.report.pages.corrections import corrections, is_correction
from tresym.report.pages.documents import ledger


@pytest.fixture(scope="module")
def report() -> Report:
    return verify(["table_racket_3_b", "table_racket_3_a", "eq_gamma", "table_str_a"])


def test_the_corrections_are_the_refuted_statements_of_the_paper(report: Report) -> None:
    page = corrections(report)
    assert "`table_racket_3_b`" in page
    assert "`racket_3_third_moment`" in page
    assert "`table_str_a`" not in page
    assert page.count("\n### ") == sum(
        row.finding.verdict is Verdict.REFUTED and row.claim.where is not None
        for row in report.rows
    )


HEDGED = (
    *("abstract_general_formula", "angles_of_the_reference", "angles_rest_at_e1", "d31"),
    *("components_are_sufficient", "each_oscillating_trajectory", "globally_parameterize"),
    *("hyperbolic_levels", "intro_any_body", "near_flip_likely", "no_tre_far", "not_elementary"),
    *("one_circle_e1", "only_about_the_handle", "slow_on_separatrix", "three_equilibria"),
    "threshold_impossible",
)
"""Where the paper hedges or prints no number, and what is refuted is a sharper reading of ours."""


def test_a_sharper_reading_is_kept_apart_from_what_the_paper_says() -> None:
    found = verify([*HEDGED, "d27", "zero_on_separatrix"])
    rows = [row for row in found.rows if row.finding.verdict is Verdict.REFUTED]
    said = {row.claim.label for row in rows if is_correction(row)}
    assert said == {"d27", "zero_on_separatrix"}
    assert {c.label for c in all_claims() if c.paper_says} == set(HEDGED)
    page, apart = corrections(found).split("## Read more sharply than printed")
    assert all(f"### `{label}` (" in apart and label not in page for label in HEDGED)
    assert apart.count("**The paper:**") == apart.count("**More sharply, and ours:**")
    assert apart.count("Read as:") == len(HEDGED)
    for word in ("approximately", "very likely", "≃", "hyperbolic shape", "very slowly"):
        assert word in apart


def test_the_ledger_lists_every_claim() -> None:
    whole = verify()
    page = ledger(whole)
    assert page.startswith("# The ledger")
    assert all(f"| `{row.claim.label}` |" in page for row in whole.rows)


def test_pages_are_the_same_twice(report: Report) -> None:
    again = verify(["table_racket_3_b", "table_racket_3_a", "eq_gamma", "table_str_a"])
    assert corrections(report) == corrections(again)


README = (Path(__file__).resolve().parents[3] / "README.md").read_text(encoding="utf-8")
_ROW = re.compile(r"^\| (.+) \| (PROVED|ENCLOSED|REFUTED) \| (.+) \|$", re.MULTILINE)
_NUMBER = re.compile(r"(?<![\w^(.])\d+(?:\.\d+)?(?![\w)])")
FINDINGS = [row for row in _ROW.findall(README) if "`" in row[0]]


@pytest.mark.parametrize(("said", "verdict", "truth"), FINDINGS)
def test_the_findings_of_the_readme_are_those_of_the_ledger(
    said: str, verdict: str, truth: str
) -> None:
    labels, reasons = re.findall(r"`(\w+)`", said), re.findall(r"`(\w+)`", truth)
    whole = verify([*labels, *reasons])
    assert {whole[label].finding.verdict.value for label in labels} == {verdict}
    assert all(whole[label].finding.verdict.holds for label in reasons)
    claims = [whole[label].claim for label in (*labels, *reasons)]
    told = " ".join(f"{claim.says} {claim.note}" for claim in claims)
    text = re.sub(r"`\w+`|\]\([^)]*\)|ε₀|b²|I₃", "", f"{said} {truth}")
    for number in _NUMBER.findall(text):
        assert number in told, (number, told)


def test_the_readme_shows_findings() -> None:
    assert len(FINDINGS) >= 9


def test_links_of_the_readme_lead_somewhere() -> None:
    root = Path(__file__).resolve().parents[3]
    for page in ("README.md", "CONTRIBUTING.md"):
        text = (root / page).read_text(encoding="utf-8")
        for target in re.findall(r"\]\(([^)#]+)\)", text):
            assert target.startswith("http") or (root / target).exists(), target
