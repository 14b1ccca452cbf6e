"""``tresym derive``: print the article, or derivations to paste, in LaTeX."""

from __future__ import annotations

import argparse
import os
import sys

from tresym.commands.parser import UNEXPECTED, Commands, deliver
from tresym.reals.numbers.exact import InputError


def add(commands: Commands) -> None:
    """Add `tresym derive` to the command line."""
    parser = commands.add_parser(
        "derive",
        help="derivations in LaTeX: the whole article, or single claims to paste",
        description=(
            "Without labels, print the whole article; with labels, each claim with its derivation."
        ),
        epilog="Exit status: 1, without output, if a requested claim is refuted.",
        allow_abbrev=False,
    )
    parser.add_argument("labels", nargs="*", metavar="LABEL", help="claims, such as eq_gamma")
    parser.add_argument(
        "--refuted",
        action="store_true",
        help="also print refuted claims, marked as such, with the correct statement",
    )
    parser.add_argument("-o", dest="path", metavar="PATH", help="write to a file instead")
    parser.add_argument(
        "--figures",
        action="store_true",
        help="also write the figures of the article, as PDF, to the folder figures beside PATH",
    )
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Run the command and return its exit status."""
    if args.figures and (args.labels or args.path is None):
        raise InputError("derive: --figures needs -o PATH and no labels")
    from tresym.ledger.verification import verify
    from tresym.reals.processes import cores
    from tresym.report.pages import derivation
    from tresym.report.pages.article import article, labels

    report = verify(args.labels or labels(), workers=cores())
    asked = [report[label] for label in dict.fromkeys(args.labels)]
    refused = derivation.refused(asked) if args.labels and not args.refuted else ()
    if refused:
        print("\n".join(refused), file=sys.stderr)
        return UNEXPECTED
    statements = map(derivation.fragment, asked)
    text = "\n".join(statements) if args.labels else article(report)
    deliver(text, args.path)
    if args.figures:
        _draw(os.path.join(os.path.dirname(args.path), "figures"))
    return 0 if report.as_expected else UNEXPECTED


def _draw(folder: str) -> None:
    """Draw the figures of the article into a folder, which is created if needed."""
    from tresym.output import write_bytes
    from tresym.report import figures
    from tresym.report.pages.article import figures_of

    os.makedirs(folder, exist_ok=True)
    for name in figures_of():
        write_bytes(os.path.join(folder, f"{name}.pdf"), figures.picture(name, "pdf"))
