"""A general statement denied by an instance: what claims that hold say of it contradicts it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

from flint import fmpq

from tresym.ledger.claim import Claim
from tresym.ledger.finding import Finding, Ruling
from tresym.reals.verdict import Verdict


@dataclass(frozen=True)
class Denied:
    """None, "never" and "every", denied by ``claims`` that exhibit the case ``witness``.

    That the claims contradict the statement is for the reader to see, as with a conjunction; that
    they hold is not: a denial whose claims do not all hold is UNDECIDED.
    """

    claims: tuple[Claim, ...]
    witness: Mapping[str, fmpq]
    expect: ClassVar[Ruling] = Verdict.REFUTED

    def judge(self) -> Finding:
        """REFUTED; only asked when every claim named is found to hold."""
        if not self.claims or not self.witness:
            return Finding(Verdict.UNDECIDED, "a denial needs a claim and a case")
        why = "contradicted by " + ", ".join(claim.label for claim in self.claims)
        return Finding(Verdict.REFUTED, why, witness=self.witness)
