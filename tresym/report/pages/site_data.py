"""The ledger as plain data for the pages of the site.

``tresym docs`` writes it to docs/_pages/ledger.json; the site is built from that file alone.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable
from typing import Any

from tresym.ledger.axioms import RULES, Axiom
from tresym.ledger.claim import AllOf, Claim
from tresym.ledger.evidence.allowed_evidence import is_formal
from tresym.ledger.paper import corrections, display_lines, racket, sections
from tresym.ledger.verification import Report, Row
from tresym.report.pages import coq_page
from tresym.report.pages.ledger_rows import common, line_of
from tresym.report.pages.places_of_proofs import lines_of_claims
from tresym.report.pages.symbols import as_used
from tresym.report.typesetting.chains import displays
from tresym.report.typesetting.paper_location import place_text
from tresym.report.typesetting.statements import said
from tresym.report.typesetting.titles import title

RECORD_VERSION = 1

_EVIDENCE = {
    "Definition": "a definition: its symbols are new, and each has a value",
    "Root": "a definition: a name for a root that is proved to exist and to be unique",
    "Instance": "substitution into an earlier claim, whose conditions are verified",
    "Charted": "ball arithmetic on boxes in coordinates that cover the region, with an exact "
    "proof of the change of coordinates",
    "AllOf": "a conjunction of claims, each proved separately",
    "Counterexample": "an exact point at which the conditions hold and the statement fails",
    "ImplicitFunction": "the implicit function theorem, applied to an earlier equation that is "
    "smooth and has a non-zero derivative",
    "Printed": "ball arithmetic from the printed inputs, each known to half a unit in its last "
    "place",
    "Boxes": "ball arithmetic on boxes that cover the region",
    "Asymptotics": "an asymptotic expansion that contradicts the stated order",
    "Decided": "the general decision procedure for claims, with definitions unfolded",
    "Denied": "a proved claim that contradicts it",
    "Follows": "evidence for each of its parts",
    "RootBound": "the sign, at the bound, of the monotone function whose zero the root is",
    "RootMonotone": "the implicit function theorem, since the derivative of the root has one sign",
    "MonotoneOf": "an earlier claim that its variable is monotone, and the sign of a derivative",
    "FromSlope": "a positive derivative, from a point where the function is not negative",
    "FromTheEdge": "the same bound at one value, and an earlier claim on monotone dependence",
    "InfimumBy": "a bound, and points at which it is approached",
    "Dominated": "a bound that depends on the variable of the limit alone",
}
"""The kind of evidence, by the type of a claim's proof; pages put "By" in front of it."""


def record(report: Report) -> dict[str, Any]:
    """Return everything that the site shows of the ledger, as JSON data.

    Returns:
        ``version``; ``counts`` by verdict; ``parts``, each a title and labels in order;
        ``axioms``, by name, each with its source and the labels of the claims that depend on it;
        ``rules``, the theorems on which the rules of proof depend; and ``claims``, by label, in the
        order of the proofs.
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
            | {"coq": coq_page.shown(row, twice)}
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
        "alias": racket().aliases.get(claim.label),
        "title": title(claim.label),
        "place": place_text(claim) if claim.where else None,
        "source": lines_of_claims()[claim.label]._asdict(),
        "statement": None if claim.statement is None else str(claim.statement),
        "given_text": [str(condition) for condition in claim.given],
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
    """The kind of evidence, in words."""
    kind = type(claim.proof)
    return _EVIDENCE.get(kind.__name__) or str(kind.__doc__).splitlines()[0].rstrip(".").lower()


def _chains(claim: Claim) -> list[list[dict[str, Any]]]:
    """The derivations, line by line; statements without one are left out."""
    return [
        [
            {"left": line.left, "right": line.right, "reasons": [s._asdict() for s in line.reasons]}
            for line in display
        ]
        for display in displays(claim)
        if any(line.reasons for line in display)
    ]
