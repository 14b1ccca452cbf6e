"""``tresym chart``: draw a chart of saved measurements."""

from __future__ import annotations

import argparse

from tresym.commands import claims_file
from tresym.commands.parser import PICTURE_PATH, Commands, deliver, deliver_picture
from tresym.reals.numbers.exact import InputError


def add(commands: Commands) -> None:
    """Add `tresym chart` to the command line."""
    parser = commands.add_parser(
        "chart",
        help="a chart of saved measurements",
        description="Draw one chart of what tresym bench --save kept; without a name, list them.",
        epilog="Needs matplotlib: pip install -e '.[docs]'.",
    )
    parser.add_argument(
        "name",
        nargs="?",
        metavar="NAME | FILE.tresym",
        help="a chart, such as work-precision; a file of claims",
    )
    parser.add_argument("label", nargs="?", metavar="LABEL", help="a claim of the file")
    parser.add_argument(
        "--from", dest="source", metavar="FILE", help="a saved measurement (default: the one here)"
    )
    parser.add_argument("-o", dest="path", metavar="PATH", help=PICTURE_PATH)


def run(args: argparse.Namespace) -> int:
    """Run the command and return its exit status."""
    if args.name is not None and args.name.endswith(claims_file.ENDING):
        if args.label is None:
            raise InputError("chart: name a claim of the file: tresym chart FILE.tresym LABEL")
        return claims_file.chart(args.name, args.label, args.path)
    if args.label is not None:
        raise InputError("chart: a label is for a file of claims: tresym chart FILE.tresym LABEL")
    from tresym.report import charts

    if args.name is None:
        names = (f"{name:<16} {chart.title}\n" for name, chart in charts.CHARTS.items())
        deliver("".join(names), args.path)
    else:
        deliver_picture(lambda kind: charts.picture(args.name, args.source, kind), args.path)
    return 0
