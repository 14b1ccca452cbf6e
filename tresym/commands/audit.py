"""``tresym audit``: compare the paper's LaTeX with the claims."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

from tresym.commands.parser import UNEXPECTED, Commands, add_output, deliver
from tresym.output import bold, colour_wanted, styled

if TYPE_CHECKING:
    from tresym.ledger.audit.coverage import Audit, PieceRow


def add(commands: Commands) -> None:
    """Add `tresym audit` to the command line."""
    parser = commands.add_parser(
        "audit",
        help="compare the paper's LaTeX with the claims",
        description="List the claims that cover each display, theorem, table and figure of the "
        "paper, and each line of the text with a formula or a statement about the motion. "
        "Compare the claims with the LaTeX of the paper.",
        epilog="Exit status: 1 unless all of the paper is covered, unaltered and copied correctly.",
    )
    parser.add_argument("paper", metavar="PAPER.tex", help="the LaTeX source of the paper")
    add_output(parser)


def run(args: argparse.Namespace) -> int:
    """Run the command and return its exit status."""
    from pathlib import Path

    import tresym.proofs as proofs

    from tresym.ledger.audit import coverage
    from tresym.ledger.audit.quotes import load_quotes
    from tresym.ledger.paper import file_of, quotes

    path, claims = file_of("index.json"), proofs.PAPER.all_claims()
    quoted = load_quotes(path, quotes(claims))
    index, words = coverage.load_index(path), coverage.load_words(path)
    found = coverage.audit(Path(args.paper), claims, index, quoted, words)
    if args.json or args.path is not None:
        import json

        deliver(json.dumps(found.as_json(), ensure_ascii=False, indent=1) + "\n", args.path)
    else:
        show_audit(found)
    return 0 if found.complete else UNEXPECTED


SHOWN_CLAIMS = 3
GOOD, NOTED, BAD = "32", "33", "1;31"
"""Green, yellow and bold red."""


def show_audit(audit: Audit) -> None:
    """Print every row, and how many of each kind are covered."""
    from tresym.ledger.audit.coverage import Transcription

    colour = colour_wanted()
    rows = [("piece", "label", "line", "its LaTeX", "answered by"), *map(_cells, audit.rows)]
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    for n, cells in enumerate(rows):
        *plain, state, names = (f"{c:<{w}}" for c, w in zip(cells, widths, strict=True))
        style = "1" if n == 0 else GOOD if audit.rows[n - 1].good else BAD
        heading = bold("  ".join(plain), colour and n == 0)
        print(heading, styled(state, style, colour), names.rstrip(), sep="  ")
    for row in audit.rows:
        if row.note and (not row.good or row.transcription is Transcription.AS_READ):
            note = f"{_piece(row)} ({row.label}): {row.note}"
            print(styled(note, NOTED if row.good else BAD, colour))
    print(styled(_summary(audit), GOOD if audit.complete else BAD, colour))


def _cells(row: PieceRow) -> tuple[str, ...]:
    from tresym.ledger.audit.coverage import Text

    names = ", ".join(row.claims[:SHOWN_CLAIMS])
    more = len(row.claims) - SHOWN_CLAIMS
    names += f" and {more} more" if more > 0 else ""
    state = row.transcription.value if row.text is Text.SAME else row.text.value
    return _piece(row), row.label, str(row.line or "—"), state or "same", names or "—"


def _piece(row: PieceRow) -> str:
    return f"display {row.number}" if row.number is not None else row.kind


def _summary(audit: Audit) -> str:
    good, total = audit.count()
    parts = [f"{good} of {total} displays", f"{audit.read} of them read from the LaTeX"]
    if audit.read_otherwise:
        parts[-1] += f", {audit.read_otherwise} of these with something read otherwise than printed"
    for kind in audit.kinds:
        good, total = audit.count(kind)
        parts.append(f"{kind} {good}/{total}")
    return "; ".join(parts)
