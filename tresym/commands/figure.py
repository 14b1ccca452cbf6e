"""``tresym figure``: a figure of the paper, recomputed."""

from __future__ import annotations

import argparse

from tresym.commands.parser import (
    PICTURE_PATH,
    Commands,
    deliver,
    deliver_picture,
)


def add(commands: Commands) -> None:
    """Add `tresym figure` to the command line."""
    parser = commands.add_parser(
        "figure",
        help="a figure of the paper, recomputed",
        description="Draw one figure; without a name, list them.",
        epilog="Needs matplotlib: pip install -e '.[docs]'.",
        allow_abbrev=False,
    )
    parser.add_argument("name", nargs="?", metavar="NAME", help="a figure, such as flip-map")
    parser.add_argument("-o", dest="path", metavar="PATH", help=PICTURE_PATH)
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Run it; returns the exit status."""
    from tresym.report import figures

    if args.name is None:
        names = (f"{name:<16} {title}\n" for name, title in figures.FIGURES.items())
        deliver("".join(names), args.path)
    else:
        deliver_picture(lambda kind: figures.picture(args.name, kind), args.path)
    return 0
