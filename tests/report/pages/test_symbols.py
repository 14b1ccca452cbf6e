"""The page of symbols: a line for each, and nothing assumed that is not named."""

from tresym.ledger.definitions import table
from tresym.ledger.finding import Premise
from tresym.ledger.verification import verify
from tresym.report.pages.symbols import symbols


def test_every_definition_and_every_assumption_has_its_line() -> None:
    report = verify(["d24", "eq_gamma", "unturned_decrease"])
    defined, assumed = symbols(report).split("## What is assumed")
    for row in report.rows:
        entries = table((row.claim,))
        if row.finding.verdict is Premise.ASSUMED:
            assert f"{row.claim.proof.assumes} | `{row.claim.label}`" in assumed
            assert f"`{row.claim.label}`" not in defined
        elif entries:
            lines = 1 if row.claim.shown else len(entries)
            assert defined.count(f"| `{row.claim.label}`") == lines
        else:
            assert f"`{row.claim.label}`" not in defined + assumed
    rows = [line for line in (defined + assumed).splitlines() if line.startswith("| $")]
    assert rows
    assert all(line.count("|") == 5 for line in rows)
