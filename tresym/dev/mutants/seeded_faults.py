"""Seeded faults: false claims that pass if a guard of the judge is missing.

They stand in ``faults.tresym``, and are judged together with the mutants. If one is accepted, the
guard that should refuse it is missing.
"""

from __future__ import annotations

from pathlib import Path

from tresym.ledger.claim import Claim
from tresym.papers.ledger_claims import read_part

FILE = Path(__file__).with_name("faults.tresym")
MARK = "planted"
"""Begins the labels of what is false."""


def planted() -> tuple[Claim, ...]:
    """Return the false claims, each with evidence that only one guard of the judge refuses."""
    claims = read_part(FILE, lambda name: {}).claims.values()
    return tuple(claim for claim in claims if claim.label.startswith(MARK))
