"""The audit at the terminal: one row for each display, theorem, table and figure."""

from __future__ import annotations

from rich.console import Console
from rich.table import Table
from rich.text import Text

from tresym.ledger.audit import Audit, Row, Transcription
from tresym.ledger.audit import Text as Found

SHOWN_CLAIMS = 3


def show_audit(audit: Audit, console: Console) -> None:
    """Print every row, and how many of each kind are covered."""
    table = Table(box=None, pad_edge=False, header_style="bold")
    for heading in ("piece", "label", "line"):
        table.add_column(heading, no_wrap=True)
    table.add_column("answered by", overflow="fold")
    table.add_column("its LaTeX", no_wrap=True)
    for row in audit.rows:
        table.add_row(*_cells(row))
    console.print(table)
    for row in audit.rows:
        if row.note and (not row.good or row.transcription is Transcription.AS_READ):
            style = "yellow" if row.good else "red"
            console.print(Text(f"{_piece(row)} ({row.label}): {row.note}", style=style))
    console.print(_summary(audit))


def _cells(row: Row) -> tuple[Text | str, ...]:
    names = ", ".join(row.claims[:SHOWN_CLAIMS])
    more = len(row.claims) - SHOWN_CLAIMS
    names += f" and {more} more" if more > 0 else ""
    state = row.transcription.value if row.text is Found.SAME else row.text.value
    style = "green" if row.good else "bold red"
    found = Text(state or "same", style=style)
    return _piece(row), row.label, str(row.line or "—"), names or "—", found


def _piece(row: Row) -> str:
    return f"display {row.number}" if row.number is not None else row.kind


def _summary(audit: Audit) -> Text:
    good, total = audit.count()
    parts = [f"{good} of {total} displays", f"{audit.read} of them read from the LaTeX"]
    if audit.read_otherwise:
        parts[-1] += f", {audit.read_otherwise} of these with something read otherwise than printed"
    for kind in audit.kinds:
        good, total = audit.count(kind)
        parts.append(f"{kind} {good}/{total}")
    style = "green" if audit.complete else "bold red"
    return Text("; ".join(parts), style=style)
