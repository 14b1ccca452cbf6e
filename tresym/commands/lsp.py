"""``tresym lsp``: check a manuscript while you write it, in any editor."""

from __future__ import annotations

import argparse

from tresym.commands.parser import Commands, parse_seconds
from tresym.reals.numbers.exact import InputError


def add(commands: Commands) -> None:
    """Add `tresym lsp` to the command line."""
    parser = commands.add_parser(
        "lsp",
        help="a language server for editors: diagnostics as you type",
        description="A server of the Language Server Protocol on standard input and output, to "
        "be started by an editor for LaTeX files; it needs the extra tresym[editor].",
    )
    parser.add_argument(
        "--limit", default="2", metavar="SECONDS", help="processor time for each claim (2)"
    )
    parser.add_argument(
        "--stdio",
        action="store_true",
        help=(
            "accepted because editors pass this option; the server "
            "always uses standard input and output"
        ),
    )


def run(args: argparse.Namespace) -> int:
    """Serve until the editor disconnects, and return the exit status."""
    limit = parse_seconds(args.limit)
    try:
        from tresym.manuscript.language_server import serve
    except ImportError:
        raise InputError("lsp: pygls is missing: pip install 'tresym[editor]'") from None
    return serve(limit)
