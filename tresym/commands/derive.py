"""``tresym derive``: the article, or statements to paste, in LaTeX."""

from __future__ import annotations

import argparse
import sys

from tresym.commands.parser import (
    UNEXPECTED,
    Commands,
    deliver,
)


def add(commands: Commands) -> None:
    """Add `tresym derive` to the command line."""
    parser = commands.add_parser(
        "derive",
        help="the derivation in LaTeX: the whole article, or one statement to paste",
        description="Without labels, one article; with labels, each statement and its chain.",
        epilog="Exit status 1, and nothing printed, when a claim named is refuted.",
        allow_abbrev=False,
    )
    parser.add_argument("labels", nargs="*", metavar="LABEL", help="claims, such as eq_gamma")
    parser.add_argument(
        "--refuted",
        action="store_true",
        help="print refuted claims too, marked, with what is true instead",
    )
    parser.add_argument("-o", dest="path", metavar="PATH", help="write to a file instead")
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Run it; returns the exit status."""
    from tresym.ledger.verification import verify
    from tresym.reals.processes import cores
    from tresym.report.pages import derivation

    report = verify(args.labels, workers=cores())
    asked = [report[label] for label in dict.fromkeys(args.labels)]
    refused = derivation.refused(asked) if args.labels and not args.refuted else ()
    if refused:
        print("\n".join(refused), file=sys.stderr)
        return UNEXPECTED
    statements = map(derivation.fragment, asked)
    text = "\n".join(statements) if args.labels else derivation.article(report)
    deliver(text, args.path)
    return 0 if report.as_expected else UNEXPECTED
