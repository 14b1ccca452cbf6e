"""``tresym explain``: a verdict as a proof that can be read."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tresym.commands.parser import Commands, add_options, deliver, parse_seconds
from tresym.reals.verdict import Verdict

if TYPE_CHECKING:
    import argparse

_STATUS = {Verdict.REFUTED: 1, Verdict.UNDECIDED: 3}


def add(commands: Commands) -> None:
    """Add `tresym explain` to the command line."""
    parser = commands.add_parser(
        "explain",
        help="explain the verdict on a claim, step by step",
        description="Decide a claim and explain the verdict: the lemma and its source, each "
        "statement to which the claim is reduced with its own reason, the constant, the "
        "counterexample, and for limits and orders a table of both sides on the way to the end.",
        epilog="Example: tresym explain 'sin(x) ~ x - x**3/4 as x -> 0'. Exit status: 0 if the "
        "claim holds, 1 if it is REFUTED, 3 if it is UNDECIDED, 2 for bad input.",
    )
    parser.add_argument("claim", metavar="CLAIM", help="a claim, as for tresym check")
    parser.add_argument("--as", dest="tends", metavar="PATH", help="the limit process: x -> 0+")
    add_options(
        parser,
        ("--given CONDITIONS", "conditions of the claim"),
        ("--limit SECONDS=20", "processor time for the decision (20)"),
    )
    parser.add_argument(
        "--style",
        choices=("text", "markdown", "html"),
        default="text",
        help="default: text; html is a page with a picture of the ratio",
    )
    parser.add_argument(
        "-o", dest="path", metavar="PATH", help="write to a file instead of standard output"
    )


def run(args: argparse.Namespace) -> int:
    """Run the command and return its exit status."""
    from tresym.reals.language.readings import need_variables
    from tresym.report.pages.explanation import explain

    claim, given = args.claim.strip(), args.given or ""
    need_variables(claim, given, args.tends)
    found = explain(claim, given, args.tends, parse_seconds(args.limit))
    if args.style == "html":
        from tresym.report.typesetting.html import page

        deliver(page(claim, found.html()), args.path)
    else:
        deliver(found.markdown() if args.style == "markdown" else found.text(), args.path)
    return _STATUS.get(found.answer.verdict, 0)
