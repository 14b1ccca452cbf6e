"""Numbers quoted in the prose of the site, computed here by name."""

from __future__ import annotations

from tresym.ledger.paper import corrections, index, racket
from tresym.ledger.verification import Report


def numbers(report: Report) -> dict[str, str]:
    """Return every number that pages quote by name.

    Returns:
        Text by name: the counts of the ledger, and the numbers of the paper.
    """
    found = {name.lower(): str(count) for name, count in report.counts.items()}
    placed = sum(row.claim.where is not None for row in report.rows)
    known = {row.claim.label for row in report.rows}
    findings = sum(correction.labels[0] in known for correction in corrections())
    found |= {
        "claims": str(len(report.rows)),
        "statements": str(placed),
        "lemmas": str(len(report.rows) - placed),
        "corrections": str(findings),
        "corrected": str(report.refuted["paper"]),
        "stricter": str(report.refuted["stricter"]),
        "sharpness": str(report.refuted["sharpness"]),
        "resting": str(sum(bool(row.claim.axioms) for row in report.rows)),
        "displays": str(len(index()["displays"])),
    }
    return found | racket().numbers()
