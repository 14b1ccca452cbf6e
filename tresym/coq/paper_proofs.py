"""Prove the claims of a file in Coq: of each claim that holds, what came of it.

Of ``square: (x + 1)^2 == x^2 + 2*x + 1`` the outcome is a file with a theorem and its proof, which
Coq accepted; of a claim that Coq's statements cannot express, the reason.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from tresym.coq.bound_statements import BoundTheorem
from tresym.coq.candidate_search import Outcome, export
from tresym.coq.claim_export import theorems, theorems_of_parts
from tresym.coq.constant_proofs import with_constant
from tresym.coq.statement import NotExportedError, Theorem
from tresym.papers.reading import PaperClaim
from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.language.formula import chained
from tresym.reals.numbers.exact import InputError

if TYPE_CHECKING:
    from tresym.papers.verification import PaperReport


def outcomes(report: PaperReport) -> Iterator[tuple[str, Outcome]]:
    """Yield the label of each claim that was asked for, and what came of it in Coq."""
    for row in report.rows:
        claim = row.item
        if not isinstance(claim, PaperClaim) or not row.requested:
            continue
        if not row.verdict.holds:
            yield row.label, Outcome(None, f"{row.verdict.value}: not exported", "")
            continue
        try:
            yield row.label, export(*_theorems(claim, row.decisive, file_name(row.label)))
        except (NotExportedError, InputError) as error:
            yield row.label, Outcome(None, str(error), "")


def file_name(label: str) -> str:
    """Return the name of a claim's theorem, and of its file."""
    return re.sub(r"\W", "_", label)


def _theorems(
    claim: PaperClaim, answer: Answer | None, name: str
) -> tuple[list[Theorem] | list[BoundTheorem], BoundTheorem | None]:
    """Return the theorems of a claim, and for an order the one with its constant.

    Raises:
        NotExportedError: Coq's statements cannot express it.
    """
    if not (claim.links or claim.whole) or claim.assumed:
        raise NotExportedError("labels and assumptions are not exported to Coq")
    if claim.whole is not None:
        return theorems_of_parts(claim.whole, name), None
    if len(claim.links) == 1 and answer is not None:
        (link,) = claim.links
        asked = read(chained((link,)), chained(claim.conditions), claim.path)
        return with_constant(asked, answer, f"{name}_1" if claim.is_derivation else name)
    plain: list[Theorem] = []
    bounds: list[BoundTheorem] = []
    for n, link in enumerate(claim.links, 1):
        asked = read(chained((link,)), chained(claim.conditions), claim.path)
        for one in theorems(asked, f"{name}_{n}" if claim.is_derivation else name):
            if isinstance(one, Theorem):
                plain.append(one)
            else:
                bounds.append(one)
    if plain and bounds:
        raise NotExportedError("limits and inequalities at points are exported to Coq one by one")
    return plain or bounds, None
