"""``tresym best``: the best constant of a claim, or from where on it holds, from both sides."""

from __future__ import annotations

import argparse

from tresym.commands.parser import (
    Commands,
    add_options,
    add_output,
    deliver,
    json_line,
    parse_seconds,
)
from tresym.reals.numbers.exact import InputError

UNDECIDED = 3
NOTHING = "nothing found: the claim was not decided to hold with one number and fail with another\n"


def add(commands: Commands) -> None:
    """Add `tresym best` to the command line."""
    parser = commands.add_parser(
        "best",
        help="the best constant of a claim, or from where on it holds, from both sides",
        description="Enclose the best constant of a claim, or the end of the largest region on "
        "which it holds, between a number with which the claim is decided to hold and one with "
        "which it is refuted.",
        epilog="Examples: tresym best 'log(x) <= c*sqrt(x)' --of c --given 'x > 0'; tresym best "
        "'abs(sin(x) - x) <= x/1000' --as 'x -> 0+'. Exit status: 0, 3 if nothing is found, 2 for "
        "bad input.",
    )
    parser.add_argument("claim", metavar="CLAIM", help="an inequality")
    parser.add_argument(
        "--as", dest="tends", metavar="PATH", help="where the claim holds: near x -> 0+, x -> oo"
    )
    add_options(
        parser,
        ("--of NAME", "the free constant of the claim"),
        ("--given CONDITIONS", "conditions: x > 0, n >= 1"),
        ("--limit SECONDS=60", "when the search ends (60)"),
    )
    add_output(parser)


def run(args: argparse.Namespace) -> int:
    """Run the command and return its exit status."""
    from tresym.accuracy.bracketing import best, holds_from

    if (args.of is None) == (args.tends is None):
        raise InputError("best: give either the constant, --of c, or a limit, --as 'x -> oo'")
    seconds, given = parse_seconds(args.limit), args.given or ""
    if args.of is not None:
        found = best(args.claim, args.of, given, seconds)
    else:
        found = holds_from(args.claim, args.tends, given, seconds)
    if args.json:
        shown = json_line(found.as_json()) if found else "null\n"
    else:
        shown = f"{found}\n" if found else NOTHING
    deliver(shown, args.path)
    return 0 if found else UNDECIDED
