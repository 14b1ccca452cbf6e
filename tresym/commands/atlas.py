"""``tresym atlas``: look up classical expansions and bounds, with their proved constants."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

from tresym.commands.parser import (
    Commands,
    add_options,
    add_output,
    deliver,
    deliver_picture,
    json_line,
)
from tresym.reals.numbers.exact import InputError

if TYPE_CHECKING:
    from tresym.entries.reading import Entry


def add(commands: Commands) -> None:
    """Add `tresym atlas` to the command line."""
    parser = commands.add_parser(
        "atlas",
        help="look up classical expansions and bounds, with proved constants",
        description="Show an entry of the atlas: a classical expansion or bound with its verdict, "
        "its constant as an interval, a false statement beside it, and its source. Without NAME, "
        "list the entries by subject. --explain, --markdown and --chart need one entry.",
        epilog="Examples: tresym atlas mills-ratio; tresym atlas --search 'erfc large'; tresym "
        "atlas sin-small --chart sin.svg. Exit status: 0, or 2 if there is no such entry.",
    )
    parser.add_argument(
        "name", metavar="NAME", nargs="?", help="the name of an entry, or a word it is found by"
    )
    add_options(
        parser,
        ("--search WORDS", "find entries by function, limit or name: 'erfc large', 'Mills'"),
        ("--bibtex", "print BibTeX with which the entry can be cited"),
        ("--explain", "decide the claim of the entry anew and explain the verdict step by step"),
        ("--markdown", "with --explain: write Markdown with formulas in LaTeX"),
        ("--chart FILE", "draw error and bound of a claim with O as svg, pdf or png"),
    )
    add_output(parser)


def run(args: argparse.Namespace) -> int:
    """Run the command and return its exit status."""
    from tresym import __version__
    from tresym.entries.lookup import atlas, bibtex, found, related
    from tresym.entries.reading import SUBJECTS, entries

    if args.name and args.search:
        raise InputError("atlas: give a NAME or --search, not both")
    words = args.search or args.name
    named = [entry for entry in entries() if entry.name == args.name]
    chosen = named or (list(found(words)) if words else list(entries()))
    if not chosen:
        atlas(words)  # says which names are near
    if args.markdown and not args.explain:
        raise InputError("atlas: --markdown needs --explain")
    if args.explain or args.chart:
        if args.json or args.bibtex:
            raise InputError("atlas: --explain and --chart go with neither --json nor --bibtex")
        one = _only(chosen)
        if args.chart:
            from tresym.report.charts.own import entry_chart

            deliver_picture(entry_chart(one), args.chart)
        if args.explain:
            from tresym.report.pages.explanation import explain

            explanation = explain(one.claim)
            deliver(explanation.markdown() if args.markdown else explanation.text(), args.path)
        return 0
    if args.json:
        shown = "".join(json_line(entry.as_json()) for entry in chosen)
    elif args.bibtex:
        shown = "\n\n".join(bibtex(entry, __version__) for entry in chosen) + "\n"
    elif words and len(chosen) <= 3:
        shown = "\n\n".join(map(str, chosen)) + "\n"
        if len(chosen) == 1 and (near := related(chosen[0])):
            shown += f"  related    {', '.join(entry.name for entry in near)}\n"
    elif words:
        shown = "".join(f"{entry.name}: {entry.title}\n  {entry.claim}\n" for entry in chosen)
    else:
        shown = ""
        for subject, title in SUBJECTS.items():
            names = [entry.name for entry in chosen if entry.subject == subject]
            shown += f"{title}\n  {', '.join(names)}\n" if names else ""
    deliver(shown, args.path)
    return 0


def _only(chosen: list[Entry]) -> Entry:
    """Return the one entry that is meant."""
    if len(chosen) == 1:
        return chosen[0]
    names = ", ".join(entry.name for entry in chosen[:5])
    more = ", …" if len(chosen) > 5 else ""
    raise InputError(f"atlas: --explain and --chart need the name of one entry: {names}{more}")
