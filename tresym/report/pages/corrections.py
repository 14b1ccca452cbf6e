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
from tresym.report.typesetting.titles import shown_name

LONGEST = 320
"""Characters of the evidence that are shown."""
OPENING = 4
"""How many findings open the page."""

PREFACE = """# Corrections

Printed statements that do not hold, most important first, each listed once. Each entry gives the
place, the paper's words, what is true instead, the reason, and the evidence. The paper's main
result, that the flip is nearly complete and that its defect decreases exponentially, is correct.

Sections and equations are numbered as in the journal; equations of the appendix are (A.1), (A.2), …
A printed decimal stands for an interval of half a unit in its last place on either side. A printed
value is listed only if no inputs that round to the printed inputs give it. Symbols such as ε\\* and
c₁ are explained in the [table of symbols](../pages/symbols.md).
"""


FAULTS: tuple[tuple[Fault, str, str], ...] = (
    (
        Fault.THEOREM,
        "The theorem",
        "Its two leading terms are correct. The remainders are wrong wherever they are printed.",
    ),
    (
        Fault.STATEMENT,
        "Statements",
        "These statements are false for some of the cases that they cover.",
    ),
    (Fault.REASON, "Reasons", "The conclusion is correct, but the reason given for it is not."),
    (
        Fault.ROUNDING,
        "Rounding, and approximations printed as equalities",
        "The number or formula is close to the true one, but less accurate than printed.",
    ),
    (
        Fault.MISPRINT,
        "Misprints",
        "The context makes clear what is meant, and the results that depend on it are correct.",
    ),
)
"""The kinds of corrections, most important first: the kind, its heading, what it means."""

STRICTER = """## Fails only if read more strictly

Here the paper qualifies its statement, or gives no number, so that the printed statement is not
refuted. What is refuted is a stricter reading of ours, which the paper does not claim.
"""


def corrections(report: Report) -> str:
    """Write the page of corrections in Markdown.

    Args:
        report: verdicts on the ledger; only corrections of claims in it are listed.
    """
    rows = {row.claim.label: row for row in report.rows}
    found = [c for c in all_corrections() if c.labels[0] in rows]
    stricter = [row for row in report.rows if row.claim.paper_says and _is_refuted(row)]
    parts = [PREFACE]
    if found:
        parts += ["The four most important:", "", *_opening(found, rows), ""]
    for fault, title, meaning in FAULTS:
        of_it = [c for c in found if rows[c.labels[0]].claim.fault is fault]
        if of_it:
            parts += [f"## {title}", "", meaning, "", *(_entry(c, rows) for c in of_it)]
    return "\n".join([*parts, *([STRICTER, *map(_stricter, stricter)] if stricter else [])])


def _is_refuted(row: Row) -> bool:
    return row.finding.verdict is Verdict.REFUTED


def _opening(found: list[Correction], rows: dict[str, Row]) -> Iterator[str]:
    """The first few corrections, one line each."""
    for n, correction in enumerate(found[:OPENING], 1):
        claim = rows[correction.labels[0]].claim
        yield (
            f"{n}. **{sentence(correction.title)}** ({place_text(claim)}). Printed: "
            f"“{sentence(correction.quote)}”. True: {quoted(claim.amended_by[0])}"
        )


def _entry(correction: Correction, rows: dict[str, Row]) -> str:
    """A correction: places, quotation, the statement decided, what is true, and the evidence."""
    refuted = [rows[label] for label in correction.labels if label in rows]
    leading = refuted[0]
    claim = leading.claim
    places = "; ".join(
        f"{place_text(row.claim)} (`{shown_name(row.claim.label)}`)" for row in refuted
    )
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
    # A conjunction repeats the amendments of its parts, which are entries of their own.
    own = [r.claim for r in refuted if r is leading or not isinstance(r.claim.proof, AllOf)]
    lines += _true(tuple(dict.fromkeys(true for claim_ in own for true in claim_.amended_by)))
    lines += _searched(claim)
    if correction.why or claim.note:
        lines += [f"**Why:** {sentence(correction.why or claim.note)}", ""]
    return "\n".join([*lines, *_evidence(leading)])


def _stricter(row: Row) -> str:
    """The entry of a statement that fails only under a stricter reading."""
    claim = row.claim
    place = place_text(claim).removesuffix(", read more strictly")
    lines = [
        f"### {place} (`{shown_name(claim.label)}`)",
        "",
        f"**Printed:** {sentence(claim.paper_says)}",
        "",
        f"**Stricter reading:** {quoted(claim)}",
        "",
        *_true(claim.amended_by),
    ]
    lines += [f"**Why:** {sentence(claim.note)}", ""] if claim.note else []
    return "\n".join([*lines, *_evidence(row)])


def _true(claims: tuple[Claim, ...]) -> Iterator[str]:
    """What is true instead, the claim nearest to the printed one first."""
    if len(claims) == 1:
        yield f"**True instead:** {quoted(claims[0])} (`{shown_name(claims[0].label)}`)"
        yield ""
    elif claims:
        yield "**True instead:**"
        yield ""
        yield from (f"- {quoted(claim)} (`{shown_name(claim.label)}`)" for claim in claims)
        yield ""


def _searched(claim: Claim) -> Iterator[str]:
    """The repair that an automatic search finds, if one was made."""
    tried, found = search(claim)
    if found is not None:
        kind = (
            "The automatic search for a repair finds the misprint"
            if claim.fault is Fault.MISPRINT
            else "The automatic search for a repair finds"
        )
        yield f"**{kind}:** `{found.claim}`, {found.verdict} ({found.edit})."
        yield ""
    elif tried:
        yield (
            "**The automatic search for a repair finds:** no true statement that differs by one "
            "edit."
        )
        yield ""


def _evidence(row: Row) -> Iterator[str]:
    """How the statement is refuted, and at which point."""
    finding = row.finding
    path = finding.parameter
    if path and finding.along:
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
    """The text, shortened if necessary after a comma so that no formula is cut."""
    if len(text) <= LONGEST:
        return text
    parts = text[:LONGEST].rpartition(", ")
    return (parts[0] or parts[2]) + ", …"
