"""The page of corrections: what the paper says, what is true instead, and the evidence."""

from __future__ import annotations

from tresym.ledger.claim import Claim, Fault
from tresym.ledger.verification import Report, Row
from tresym.reals.numbers.exact import fraction_text
from tresym.reals.verdict import Verdict
from tresym.report.words.latex import says_latex
from tresym.report.words.markdown import finding as found_text
from tresym.report.words.markdown import sentence
from tresym.report.words.place import place_text

LONGEST = 200

PREFACE = """# Corrections

Statements of the paper that do not hold as they stand, sentences in our words and formulas as
printed, each with its place, the evidence, and the nearest statement that does hold. Printed
decimals are read as intervals of half a unit in their last place, and a printed value stands here
only if no inputs that round to the printed inputs give it. The paper's main result, that the flip
is nearly complete and that its defect decreases exponentially, stands.
"""


FAULTS: tuple[tuple[Fault | None, str, str], ...] = (
    (
        Fault.THEOREM,
        "The theorem",
        "Its two leading terms are right; the remainders are not, wherever they are printed.",
    ),
    (
        Fault.STATEMENT,
        "Statements",
        "What is said does not hold for everything it is said of.",
    ),
    (
        Fault.REASON,
        "Reasons",
        "The conclusion holds; the reason given for it does not.",
    ),
    (
        Fault.ROUNDING,
        "Rounding, and approximations printed as equalities",
        "The number or the formula is near the truth, and not as near as it is printed.",
    ),
    (
        Fault.MISPRINT,
        "Misprints",
        "What is meant is plain from the context, and what is built on it stands.",
    ),
    (
        None,
        "Read more sharply than printed",
        "The paper hedges here, or gives no number, and as it is read here it is not refuted. What "
        "is refuted is a sharper reading, which is ours: the words do not carry it.",
    ),
)
"""The kinds of corrections, with title and meaning; the last are none (see `paper_says`)."""


def corrections(report: Report) -> str:
    """The page in Markdown: the theorem first, each kind in the order of the proofs."""
    refuted = [
        row
        for row in report.rows
        if is_correction(row) or (row.claim.paper_says and row.finding.verdict is Verdict.REFUTED)
    ]
    parts = [PREFACE]
    for fault, title, meaning in FAULTS:
        rows = [row for row in refuted if fault_of(row.claim) is fault]
        if rows:
            parts += [f"## {title}", "", meaning, "", *map(_entry, rows)]
    return "\n".join(parts)


def fault_of(claim: Claim) -> Fault | None:
    """The kind of correction that a refuted claim is; None where only a sharper reading is."""
    return None if claim.paper_says else claim.fault


def is_correction(row: Row) -> bool:
    """Whether the paper itself says what is refuted, and not only a sharper reading of it."""
    claim = row.claim
    refuted = row.finding.verdict is Verdict.REFUTED
    return refuted and claim.where is not None and not claim.paper_says


def _entry(row: Row) -> str:
    claim, finding = row.claim, row.finding
    lines = [
        f"### `{claim.label}` ({place_text(claim)})",
        "",
        f"**The paper:** {sentence(claim.paper_says) or _said(claim)}",
        "",
    ]
    if claim.paper_says:
        lines += [f"**More sharply, and ours:** {_said(claim)}", ""]
    lines += [f"**Evidence:** {found_text(_clipped(finding.why))}.", ""]
    if finding.witness and " = " not in finding.why:
        point = ", ".join(f"{n} = {fraction_text(v)}" for n, v in sorted(finding.witness.items()))
        lines += [f"**Witness:** {found_text(_clipped(point))}.", ""]
    for amendment in claim.amended_by:
        lines += [f"**True instead** (`{amendment.label}`): {_said(amendment)}", ""]
    if claim.note:
        lines += [sentence(claim.note), ""]
    return "\n".join(lines)


def _said(claim: Claim) -> str:
    if isinstance(claim.says, str):
        return sentence(claim.says)
    parts = (claim.shown or says_latex(claim.says)).replace("|", r"\vert ").split(r",\quad ")
    return ", ".join(f"${part}$" for part in parts)


def _clipped(text: str) -> str:
    return text if len(text) <= LONGEST else text[: LONGEST - 1] + "…"
