"""``tresym table``: print certified tables."""

from __future__ import annotations

import argparse

from tresym.commands.parser import Commands, add_output, deliver

TABLES = "objects, errors, constants, slope, thresholds, routes"


def add(commands: Commands) -> None:
    """Add `tresym table` to the command line."""
    parser = commands.add_parser(
        "table",
        help=f"certified tables: {TABLES}",
        description="A table of certified numbers, for the terminal, in Markdown or in LaTeX.",
    )
    parser.add_argument("name", metavar="NAME", help=TABLES)
    parser.add_argument(
        "--format", choices=("text", "markdown", "latex"), default="text", help="default: text"
    )
    add_output(parser)


def run(args: argparse.Namespace) -> int:
    """Run the command and return its exit status."""
    from tresym.report.pages import tables

    found = tables.table(args.name)
    if args.json:
        import json

        deliver(json.dumps(found._asdict(), ensure_ascii=False, indent=1) + "\n", args.path)
        return 0
    deliver(tables.written(found, args.format), args.path)
    return 0
