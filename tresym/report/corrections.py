"""The page of corrections: what the paper says, what is true instead, and the evidence."""

from __future__ import annotations

from tresym.claims.claim import Claim
from tresym.exact import fraction_text
from tresym.report.latex import says_latex
from tresym.report.place import place_text
from tresym.verdict import Verdict
from tresym.verification import Report, Row

PREFACE = """# Corrections

Statements of the paper that do not hold as they stand, in its order, each with the evidence and
with the nearest statement that does hold. Printed decimals are read as intervals of half a unit in
their last place, and a printed value stands here only if no inputs that round to the printed inputs
give it. The paper's main result, that the flip is nearly complete and that its defect decreases
exponentially, stands.
"""

LONGEST = 200


def corrections(report: Report) -> str:
    """The page in Markdown."""
    refuted = [row for row in report.rows if _stands_in_the_paper(row)]
    return "\n".join([PREFACE, *(_entry(row) for row in refuted)])


def _stands_in_the_paper(row: Row) -> bool:
    return row.finding.verdict is Verdict.REFUTED and row.claim.where is not None


def _entry(row: Row) -> str:
    claim, finding = row.claim, row.finding
    lines = [f"## `{claim.label}` ({place_text(claim)})", "", f"**As printed:** {_said(claim)}", ""]
    lines += [f"**Evidence:** {_clipped(finding.why)}.", ""]
    if finding.witness:
        point = ", ".join(f"{n} = {fraction_text(v)}" for n, v in sorted(finding.witness.items()))
        lines += [f"**Witness:** {_clipped(point)}", ""]
    for amendment in claim.amended_by:
        lines += [f"**True instead** (`{amendment.label}`): {_said(amendment)}", ""]
    if claim.note:
        lines += [claim.note, ""]
    return "\n".join(lines)


def _said(claim: Claim) -> str:
    return claim.says if isinstance(claim.says, str) else f"${says_latex(claim.says)}$"


def _clipped(text: str) -> str:
    return text if len(text) <= LONGEST else text[: LONGEST - 1] + "…"
