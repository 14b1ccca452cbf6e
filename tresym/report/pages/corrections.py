"""The page of corrections: printed statements that do not hold, and what is true instead."""

from __future__ import annotations

from collections.abc import Iterator

from tresym.ledger.claim import AllOf, Claim, Fault
from tresym.ledger.paper import Correction
from tresym.ledger.paper import corrections as all_corrections
from tresym.ledger.verification import Report, Row
from tresym.reals.numbers.exact import fraction_text
from tresym.reals.verdict import Verdict
from tresym.report.pages.found_repairs import search
from tresym.report.typesetting.markdown import finding as found_text
from tresym.report.typesetting.markdown import sentence
from tresym.report.typesetting.paper_location import place_text
from tresym.report.typesetting.statements import quoted

LONGEST = 320
OPENING = 4
"""How many findings open the page."""

PREFACE = """# Corrections

What the paper prints and does not hold, each finding once and the weightiest first: the place, the
paper's words, what is true instead, why, and the evidence. Sections and equations are counted as
the journal prints them, those of the appendix as (A.1), (A.2), … Printed decimals are read as
intervals of half a unit in their last place, and a printed value stands here only if no inputs that
round to the printed inputs give it. The letters, such as ε\\* and c₁, are in the table of
[symbols](../pages/symbols.md). The paper's main result, that the flip is nearly complete and that
its defect decreases exponentially, stands.
"""


FAULTS: tuple[tuple[Fault, str, str], ...] = (
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
)
"""The kinds of corrections by weight, with title and meaning."""

SHARPER = """## Read more sharply than printed

The paper hedges here, or gives no number, and as it is read here it is not refuted. What is refuted
is a sharper reading, which is ours: the words do not carry it.
"""


def corrections(report: Report) -> str:
    """The page in Markdown."""
    rows = {row.claim.label: row for row in report.rows}
    found = [c for c in all_corrections() if c.labels[0] in rows]
    sharper = [row for row in report.rows if row.claim.paper_says and _is_refuted(row)]
    parts = [PREFACE]
    if found:
        parts += ["The four that matter most:", "", *_opening(found, rows), ""]
    for fault, title, meaning in FAULTS:
        of_it = [c for c in found if rows[c.labels[0]].claim.fault is fault]
        if of_it:
            parts += [f"## {title}", "", meaning, "", *(_entry(c, rows) for c in of_it)]
    return "\n".join([*parts, *([SHARPER, *map(_sharper, sharper)] if sharper else [])])


def is_correction(row: Row) -> bool:
    """Whether the paper itself says what is refuted, and not only a sharper reading of it."""
    return _is_refuted(row) and row.claim.where is not None and not row.claim.paper_says


def _is_refuted(row: Row) -> bool:
    return row.finding.verdict is Verdict.REFUTED


def _opening(found: list[Correction], rows: dict[str, Row]) -> Iterator[str]:
    for n, correction in enumerate(found[:OPENING], 1):
        claim = rows[correction.labels[0]].claim
        yield (
            f"{n}. **{sentence(correction.title)}** ({place_text(claim)}). Printed: "
            f"“{sentence(correction.quote)}”. True: {quoted(claim.amended_by[0])}"
        )


def _entry(correction: Correction, rows: dict[str, Row]) -> str:
    said_in = [rows[label] for label in correction.labels if label in rows]
    leading = said_in[0]
    claim = leading.claim
    places = "; ".join(f"{place_text(row.claim)} (`{row.claim.label}`)" for row in said_in)
    lines = [
        f"### {sentence(correction.title)}",
        "",
        f"{places}.",
        "",
        f"**Printed:** “{sentence(correction.quote)}”.",
        "",
        f"**Decided:** {quoted(claim)}",
        "",
    ]
    own = [r.claim for r in said_in if r is leading or not isinstance(r.claim.proof, AllOf)]
    lines += _true(tuple(dict.fromkeys(true for said_by in own for true in said_by.amended_by)))
    lines += _searched(claim)
    if correction.why or claim.note:
        lines += [f"**Why:** {sentence(correction.why or claim.note)}", ""]
    return "\n".join([*lines, *_evidence(leading)])


def _sharper(row: Row) -> str:
    claim = row.claim
    lines = [
        f"### {place_text(claim).removesuffix(', read more sharply')} (`{claim.label}`)",
        "",
        f"**Printed:** {sentence(claim.paper_says)}",
        "",
        f"**More sharply, and ours:** {quoted(claim)}",
        "",
        *_true(claim.amended_by),
    ]
    lines += [f"**Why:** {sentence(claim.note)}", ""] if claim.note else []
    return "\n".join([*lines, *_evidence(row)])


def _true(claims: tuple[Claim, ...]) -> Iterator[str]:
    """What is true instead, nearest first."""
    if len(claims) == 1:
        yield f"**True instead:** {quoted(claims[0])} (`{claims[0].label}`)"
        yield ""
    elif claims:
        yield "**True instead:**"
        yield ""
        yield from (f"- {quoted(claim)} (`{claim.label}`)" for claim in claims)
        yield ""


def _searched(claim: Claim) -> Iterator[str]:
    """What the search for repairs finds by itself."""
    tried, found = search(claim)
    if found is not None:
        kind = (
            "The misprint is found automatically"
            if claim.fault is Fault.MISPRINT
            else "Found automatically"
        )
        yield f"**{kind}:** `{found.claim}`, {found.verdict} ({found.edit})."
        yield ""
    elif tried:
        yield "**Found automatically:** nothing that holds within one edit."
        yield ""


def _evidence(row: Row) -> Iterator[str]:
    """How it is refuted, and at which point."""
    finding = row.finding
    path = finding.parameter
    if path and finding.why.startswith("along "):
        path = f"for {path.partition(',')[0]}, "
    elif path:
        path = f"along {path}: "
    text = f"**Evidence:** {found_text(_clipped((path or '') + finding.why))}"
    if finding.witness and " = " not in finding.why:
        point = ", ".join(f"{n} = {fraction_text(v)}" for n, v in sorted(finding.witness.items()))
        text += f", at {found_text(_clipped(point))}"
    yield text if text.endswith("…") else f"{text}."
    yield ""


def _clipped(text: str) -> str:
    """A long text as far as a part of its sentence goes, which leaves its formulas whole."""
    if len(text) <= LONGEST:
        return text
    parts = text[:LONGEST].rpartition(", ")
    return (parts[0] or parts[2]) + ", …"
