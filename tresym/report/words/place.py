"""Where in the paper a claim stands, in words."""

from __future__ import annotations

from tresym.ledger.claim import Claim


def place_text(claim: Claim) -> str:
    """Where in the paper a claim stands, in words; a dash for a lemma of ours."""
    where = claim.where
    if where is None:
        return "—"
    parts = [f"display {where.display}"] if where.display else []
    parts += [f"cell {where.cell}"] if where.cell else []
    parts += [f"line {where.line}"] if where.line and not where.display else []
    parts += ["read more sharply"] if claim.paper_says else []
    return ", ".join(parts) or "—"
