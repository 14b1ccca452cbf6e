"""``tresym table``: print certified tables."""

from __future__ import annotations

import argparse

from tresym.commands import claims_file
from tresym.commands.parser import Commands, add_output, deliver
from tresym.reals.numbers.exact import InputError

TABLES = "objects, errors, constants, slope, thresholds, routes"


def add(commands: Commands) -> None:
    """Add `tresym table` to the command line."""
    parser = commands.add_parser(
        "table",
        help=f"certified tables: {TABLES}",
        description="A table of certified numbers, for the terminal, in Markdown or in LaTeX.",
    )
    parser.add_argument("name", metavar="NAME | FILE.tresym", help=f"{TABLES}; a file of claims")
    parser.add_argument("label", nargs="?", metavar="LABEL", help="a claim of the file")
    parser.add_argument(
        "--format", choices=("text", "markdown", "latex"), default="text", help="default: text"
    )
    add_output(parser)


def run(args: argparse.Namespace) -> int:
    """Run the command and return its exit status."""
    if args.name.endswith(claims_file.ENDING):
        if args.label is None:
            raise InputError("table: name a claim of the file: tresym table FILE.tresym LABEL")
        return claims_file.table(args.name, args.label, args.format, args.json, args.path)
    if args.label is not None:
        raise InputError("table: a label is for a file of claims: tresym table FILE.tresym LABEL")
    from tresym.report.pages import tables

    found = tables.table(args.name)
    if args.json:
        import json

        deliver(json.dumps(found._asdict(), ensure_ascii=False, indent=1) + "\n", args.path)
        return 0
    deliver(tables.written(found, args.format), args.path)
    return 0
