"""Rows of the ledger as JSON: for `tresym verify --json`, and for the pages of the site."""

from __future__ import annotations

from typing import Any

from tresym.ledger.evidence.meant import is_formal
from tresym.ledger.paper import display_lines
from tresym.ledger.verification import JSON_VERSION, Report, Row
from tresym.reals.numbers.exact import fraction_text
from tresym.report.words.latex import given_latex, says_latex


def report_json(report: Report) -> dict[str, Any]:
    """The report as `tresym verify --json` prints it."""
    lines = display_lines()
    return {
        "version": JSON_VERSION,
        "counts": report.counts,
        "prose": [row.claim.label for row in report.rows if not is_formal(row.claim)],
        "claims": [_row_json(row, lines) for row in report.rows],
    }


def _row_json(row: Row, lines: dict[int | None, int]) -> dict[str, Any]:
    claim, finding = row.claim, row.finding
    where = claim.where
    return {
        "label": claim.label,
        "requested": row.requested,
        "kind": claim.kind,
        "says": says_latex(claim.says),
        "formal": is_formal(claim),
        "given": [given_latex(condition) for condition in claim.given],
        "verdict": finding.verdict.value,
        "expect": claim.expect.value,
        "value": finding.value and finding.value._asdict(),
        "constant": finding.constant and finding.constant._asdict(),
        "region": finding.region,
        "parameter": finding.parameter,
        "steps": [
            {"verdict": s.verdict.value, "why": s.why, "seconds": round(s.seconds, 6)}
            for s in finding.steps
        ],
        "where": where
        and {
            "display": where.display,
            "line": where.line or lines.get(where.display),
            "cell": where.cell,
        },
        "witness": finding.witness
        and {name: fraction_text(v) for name, v in sorted(finding.witness.items())},
        "amended_by": [claim.label for claim in claim.amended_by],
        "uses": [used.label for used in claim.uses],
        "why": finding.why,
        "seconds": round(finding.seconds, 6),
    }
