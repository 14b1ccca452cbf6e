"""The table of definitions as a page: what each symbol stands for, and what is assumed."""

from __future__ import annotations

from collections.abc import Iterator

from tresym.ledger.claim import Claim, Definition, ImplicitFunction
from tresym.ledger.definitions import Entry, table
from tresym.ledger.finding import Premise
from tresym.ledger.verification import Report
from tresym.report.words.conditions import gathered
from tresym.report.words.latex import expression_latex, says_latex
from tresym.report.words.place import place_text


def symbols(report: Report) -> str:
    """Two tables in Markdown: what is defined, and what is assumed, in the order of the proofs.

    A symbol that an earlier equation defines as a function has its slope for a definition.
    """
    rows = [row for row in report.rows if table((row.claim,))]
    assumed = [row.claim for row in rows if row.finding.verdict is Premise.ASSUMED]
    defined = [row.claim for row in rows if row.claim not in assumed]
    return "\n".join(
        (
            "## What is defined",
            "",
            "| symbol | stands for | where | by |",
            "|---|---|---|---|",
            *(line for claim in defined for line in _defined(claim)),
            "",
            "## What is assumed",
            "",
            "| equation | where | what it is | by |",
            "|---|---|---|---|",
            *map(_assumed, assumed),
            "",
        )
    )


def _defined(claim: Claim) -> Iterator[str]:
    entries = table((claim,))
    if claim.shown is not None:
        yield _row(", ".join(_symbol(entry) for entry in entries), f"${claim.shown}$", claim)
        return
    slope = (
        "the slope of an implicit function, " if isinstance(claim.proof, ImplicitFunction) else ""
    )
    for entry in entries:
        yield _row(_symbol(entry), f"{slope}${expression_latex(entry.meaning)}$", claim)


def _symbol(entry: Entry) -> str:
    return f"${expression_latex(entry.symbol)}$"


def _assumed(claim: Claim) -> str:
    says = claim.shown or says_latex(claim.says)
    given = ", ".join(f"${condition}$" for condition in gathered(claim.given))
    name = claim.proof.assumes if isinstance(claim.proof, Definition) else ""
    return _cells(f"${says}$", given, name, _by(claim))


def _row(name: str, meaning: str, claim: Claim) -> str:
    given = ", ".join(f"${condition}$" for condition in gathered(claim.given))
    return _cells(name, meaning, given, _by(claim))


def _by(claim: Claim) -> str:
    return f"`{claim.label}`" + (f" ({place_text(claim)})" if claim.where else "")


def _cells(*cells: str) -> str:
    written = (cell.replace("|", r"\vert ") for cell in cells)
    return f"| {' | '.join(written)} |"
