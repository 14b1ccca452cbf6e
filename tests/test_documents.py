"""Generated documents: pure functions of the ledger, honest about what they show."""

import pytest

from tresym.report.corrections import corrections
from tresym.report.documents import ledger
from tresym.verdict import Verdict
from tresym.verification import Report, verify


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


def test_the_ledger_lists_every_claim() -> None:
    whole = verify()
    page = ledger(whole)
    assert page.startswith("# The ledger")
    assert all(f"| `{row.claim.label}` |" in page for row in whole.rows)


def test_pages_are_the_same_twice(report: Report) -> None:
    again = verify(["table_racket_3_b", "table_racket_3_a", "eq_gamma", "table_str_a"])
    assert corrections(report) == corrections(again)
