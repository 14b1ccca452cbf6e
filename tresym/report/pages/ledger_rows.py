"""Rows of the ledger as JSON, for ``tresym verify --json`` and the site."""

from __future__ import annotations

from typing import Any

from tresym.ledger.evidence.allowed_evidence import is_formal
from tresym.ledger.paper import display_lines, racket
from tresym.ledger.verification import JSON_VERSION, Report, Row
from tresym.reals.numbers.exact import fraction_text
from tresym.report.pages import coq_page
from tresym.report.typesetting.conditions import gathered
from tresym.report.typesetting.latex import says_latex


def report_json(report: Report) -> dict[str, Any]:
    """Return the report as ``tresym verify --json`` prints it."""
    lines = display_lines()
    labels = tuple(row.claim.label for row in report.rows)
    known = coq_page.found(labels)
    coq = {row.claim.label: coq_page.mark(row, known) for row in report.rows}
    return {
        "version": JSON_VERSION,
        "counts": report.counts,
        "refuted": report.refuted,
        "prose": [row.claim.label for row in report.rows if not is_formal(row.claim)],
        "claims": [_row_json(row, lines) | {"coq": coq[row.claim.label]} for row in report.rows],
    }


def common(row: Row) -> dict[str, Any]:
    """Return the fields that every JSON row of a claim has."""
    claim, finding = row.claim, row.finding
    return {
        "kind": claim.kind,
        "verdict": finding.verdict.value,
        "value": finding.value and finding.value._asdict(),
        "constant": finding.constant and finding.constant._asdict(),
        "region": finding.region,
        "parameter": finding.parameter,
        "witness": finding.witness
        and {name: fraction_text(v) for name, v in sorted(finding.witness.items())},
        "amended_by": [claim.label for claim in claim.amended_by],
        "uses": [used.label for used in claim.uses],
        "conditions": {label: gathered(given) for label, given in finding.conditions.items()},
        "axioms": [axiom.name for axiom in claim.axioms],
        "why": finding.why,
        "follows_from": list(finding.follows_from),
    }


def line_of(row: Row, lines: dict[int | None, int]) -> int | None:
    """Return the line of the paper's source that the claim is about, or None for a lemma."""
    where = row.claim.where
    return None if where is None else where.line or lines.get(where.display)


def _row_json(row: Row, lines: dict[int | None, int]) -> dict[str, Any]:
    claim, finding, where = row.claim, row.finding, row.claim.where
    return {
        "label": claim.label,
        "alias": racket().aliases.get(claim.label),
        "requested": row.requested,
        "says": says_latex(claim.says),
        "means": None if claim.statement is None else says_latex(claim.statement),
        "formula": None if claim.statement is None else str(claim.statement),
        "formal": is_formal(claim),
        "given": [says_latex(condition) for condition in claim.given],
        "expect": claim.expect.value,
        "steps": [
            {"verdict": s.verdict.value, "why": s.why, "seconds": round(s.seconds, 6)}
            for s in finding.steps
        ],
        "where": where
        and {"display": where.display, "line": line_of(row, lines), "cell": where.cell},
        **common(row),
        "seconds": round(finding.seconds, 6),
    }
