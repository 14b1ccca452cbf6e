"""The ledger as plain data for the pages of the site.

`tresym docs` writes it to docs/generated/ledger.json; the site is built from that file alone.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable
from typing import Any

from tresym.ledger.axioms import RULES, Axiom
from tresym.ledger.claim import AllOf, Claim
from tresym.ledger.evidence.admissible import is_formal
from tresym.ledger.paper import corrections, display_lines, sections
from tresym.ledger.verification import Report, Row
from tresym.report.pages import coq_page
from tresym.report.pages.ledger_rows import common, line_of
from tresym.report.pages.symbols import as_used
from tresym.report.typesetting.chains import displays
from tresym.report.typesetting.paper_location import place_text
from tresym.report.typesetting.statements import said
from tresym.report.typesetting.titles import title

RECORD_VERSION = 1

_EVIDENCE = {
    "tuple": "a chain; each step is decided by an exact normal form, from the reasons it names",
    "Together": "a chain for each part, decided step by step by exact normal forms",
    "Definition": "a definition: its symbols are new, and each has a value",
    "Root": "a definition: a name for the one root that is shown to be",
    "Instance": "an instance of an earlier claim, whose conditions are shown",
    "Charted": "balls on boxes in charts that cover the region, and the passage there, exact",
    "AllOf": "the conjunction of claims that are judged for themselves",
    "Formally": "the relations that the sentence states, decided as they stand",
    "Counterexample": "an exact point at which the conditions hold and the statement fails",
    "UniqueRoot": "opposite signs at the ends and a derivative of one sign, each by a chain",
    "ImplicitFunction": "an earlier equation, smooth and with a derivative that is not zero: the "
    "implicit function theorem",
    "Printed": "balls from the printed inputs, each known to half a unit of its last place",
    "Boxes": "balls on boxes that cover the region",
    "Asymptotics": "an expansion that shows where the order fails",
    "Squeezed": "an inequality on the whole side of the point",
    "Denied": "a claim that holds and contradicts it",
}


def record(report: Report) -> dict[str, Any]:
    """Everything that the site shows of the ledger.

    Returns:
        ``version``; ``counts`` by verdict; ``parts``, each a title and labels in order;
        ``axioms``, by name, each with its source and the labels of the claims that rest on it;
        ``rules``, the theorems of the judge's rules; and ``claims``, by label, in the order of the
        proofs.
    """
    claims = [row.claim for row in report.rows]
    known = {claim.label for claim in claims}
    parts = [(title, [c.label for c in stated if c.label in known]) for title, stated in sections()]
    used_by = _inverse(claims, lambda claim: claim.uses)
    amends = _inverse(claims, lambda claim: claim.amended_by)
    lines = display_lines()
    twice = coq_page.found()
    quotes = {label: found.quote for found in corrections() for label in found.labels}
    return {
        "version": RECORD_VERSION,
        "counts": report.counts,
        "parts": [{"title": title, "claims": labels} for title, labels in parts if labels],
        "axioms": {
            axiom.name: _axiom(axiom) | {"claims": [claim.label for claim in resting]}
            for axiom, resting in report.axioms.items()
        },
        "rules": {axiom.name: _axiom(axiom) | {"rule": axiom.rule} for axiom in RULES},
        "claims": {
            row.claim.label: _claim(row, lines, quotes)
            | {"coq": coq_page.shown(row.claim.label, twice)}
            | {"used_by": used_by[row.claim.label], "amends": amends[row.claim.label]}
            for row in report.rows
        },
    }


def _axiom(axiom: Axiom) -> dict[str, Any]:
    return {"says": axiom.says, "formula": axiom.formula, "source": axiom.source}


def _inverse(
    claims: list[Claim], named: Callable[[Claim], tuple[Claim, ...]]
) -> dict[str, list[str]]:
    """For each label, the labels of the claims that name it."""
    found: dict[str, list[str]] = defaultdict(list)
    for claim in claims:
        for other in named(claim):
            found[other.label].append(claim.label)
    return found


def _claim(row: Row, lines: dict[int | None, int], quotes: dict[str, str]) -> dict[str, Any]:
    claim = row.claim
    return {
        **common(row),
        "title": title(claim.label),
        "place": place_text(claim) if claim.where else None,
        "line": line_of(row, lines),
        **said(claim).as_record(),
        "chains": _chains(claim),
        "evidence": _evidence(claim),
        "note": claim.note,
        "symbols": as_used(claim),
        "formal": is_formal(claim),
        "conjunction": [c.label for c in claim.uses] if isinstance(claim.proof, AllOf) else [],
        "quote": quotes.get(claim.label, ""),
        "paper_says": claim.paper_says,
    }


def _evidence(claim: Claim) -> str:
    """What kind of evidence it is, in words."""
    kind = type(claim.proof)
    return _EVIDENCE.get(kind.__name__) or str(kind.__doc__).splitlines()[0].rstrip(".").lower()


def _chains(claim: Claim) -> list[list[dict[str, Any]]]:
    """The chains alone, line by line: a statement without one is not shown twice."""
    return [
        [
            {"left": line.left, "right": line.right, "reasons": [s._asdict() for s in line.reasons]}
            for line in display
        ]
        for display in displays(claim)
        if any(line.reasons for line in display)
    ]
