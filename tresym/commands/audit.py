"""``tresym audit``: compare the paper's LaTeX with the claims."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

from rich.console import Console
from rich.table import Table
from rich.text import Text

from tresym.commands.parser import (
    UNEXPECTED,
    Commands,
    add_output,
    deliver,
)

if TYPE_CHECKING:
    from tresym.ledger.audit.coverage import Audit, PieceRow


def add(commands: Commands) -> None:
    """Add `tresym audit` to the command line."""
    parser = commands.add_parser(
        "audit",
        help="compare the paper's LaTeX with the claims",
        description="List the claims that cover each display, theorem, table and figure of the "
        "paper, and each line of its text with a formula or on the motion; compare them "
        "with its LaTeX.",
        epilog="Exit status: 1 unless all of the paper is covered, unaltered and copied correctly.",
        allow_abbrev=False,
    )
    parser.add_argument("paper", metavar="PAPER.tex", help="the LaTeX source of the paper")
    add_output(parser)
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Run the command and return its exit status."""
    from pathlib import Path

    import tresym.proofs as proofs
    from tresym.ledger.audit import coverage
    from tresym.ledger.audit.quotes import load_quotes
    from tresym.ledger.paper import file_of, quotes

    path, claims = file_of("index.json"), proofs.claims()
    quoted = load_quotes(path, quotes(claims))
    index, words = coverage.load_index(path), coverage.load_words(path)
    found = coverage.audit(Path(args.paper), claims, index, quoted, words)
    if args.json or args.path is not None:
        import json

        deliver(json.dumps(found.as_json(), ensure_ascii=False, indent=1) + "\n", args.path)
    else:
        from tresym.output import terminal

        show_audit(found, terminal())
    return 0 if found.complete else UNEXPECTED


SHOWN_CLAIMS = 3


def show_audit(audit: Audit, console: Console) -> None:
    """Print every row, and how many of each kind are covered."""
    from tresym.ledger.audit.coverage import Transcription

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


def _cells(row: PieceRow) -> tuple[Text | str, ...]:
    from tresym.ledger.audit.coverage import Text as Found

    names = ", ".join(row.claims[:SHOWN_CLAIMS])
    more = len(row.claims) - SHOWN_CLAIMS
    names += f" and {more} more" if more > 0 else ""
    state = row.transcription.value if row.text is Found.SAME else row.text.value
    style = "green" if row.good else "bold red"
    found = Text(state or "same", style=style)
    return _piece(row), row.label, str(row.line or "—"), names or "—", found


def _piece(row: PieceRow) -> str:
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
