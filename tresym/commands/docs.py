"""``tresym docs``: build the generated documents, or check that they are up to date."""

from __future__ import annotations

import argparse

from tresym.commands.parser import UNEXPECTED, Commands, add_options


def add(commands: Commands) -> None:
    """Add `tresym docs` to the command line."""
    parser = commands.add_parser(
        "docs",
        help="build the generated documents, or check that they are up to date",
        description="Write docs/generated from the ledger and the tables.",
    )
    add_options(parser, ("--check", "write nothing; exit status 1 if a document is out of date"))


def run(args: argparse.Namespace) -> int:
    """Run the command and return its exit status."""
    from tresym.report.pages import documents

    if args.check:
        stale = documents.stale()
        print("\n".join(f"stale: {path}" for path in stale) or "every document is up to date")
        return UNEXPECTED if stale else 0
    print("\n".join(documents.build()))
    return 0
