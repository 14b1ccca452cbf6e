"""``tresym expand``: expand an expression in a limit process, with the constant of the error."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tresym.commands.parser import Commands, add_options, add_output, deliver, json_line
from tresym.reals.numbers.exact import InputError, quoted

if TYPE_CHECKING:
    import argparse

UNDECIDED = 3


def add(commands: Commands) -> None:
    """Add `tresym expand` to the command line."""
    parser = commands.add_parser(
        "expand",
        help="expand an expression in a limit process, with the constant of the error",
        description="Find the first terms of the expansion of an explicit expression or of a root "
        "of an equation, decide the statement with them, and give the constant of the error.",
        epilog="Example: tresym expand y --given 'y**5 + e*y == 1, y > 0' --as 'e -> 0' --terms 3. "
        "Exit status: 0 if the expansion is PROVED or ENCLOSED, 3 if it is undecided, 2 for bad "
        "input or if none is found.",
    )
    parser.add_argument("exact", metavar="EXACT", help="an expression, or an unknown")
    parser.add_argument(
        "--as",
        dest="tends",
        metavar="PATH",
        help="the limit process (path): x -> 0+, 0-, 0, 1/2, oo, -oo",
    )
    add_options(
        parser,
        ("--given CONDITIONS", "conditions, or an equation that determines the unknown EXACT"),
        ("--terms N=3", "the number of terms (3)"),
        ("--on REGION", "the region for which the constant is computed: 0 < e <= 1/2"),
    )
    parser.add_argument("--format", choices=("text", "latex"), default="text", help="default: text")
    add_output(parser)


def run(args: argparse.Namespace) -> int:
    """Run the command and return its exit status."""
    from tresym.accuracy.expansion import expand

    if args.tends is None:
        raise InputError("expand: give a limit process, such as --as 'x -> 0+'")
    text = str(args.terms)
    if not (text.isascii() and text.isdecimal() and len(text) < 4):
        asked = quoted(text.strip())
        raise InputError(f"--terms: {asked} is not a number of terms; give 1, 2, 3, …")
    found = expand(args.exact, args.tends, int(text), args.given or "", args.on or "")
    if args.json:
        shown = json_line(found.as_json())
    else:
        shown = (found.as_latex() if args.format == "latex" else str(found)) + "\n"
    deliver(shown, args.path)
    return 0 if found.answer else UNDECIDED
