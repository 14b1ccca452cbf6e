"""The ``tresym`` command line: each command has a module with its parser, action and output.

Exit status: 0 as expected; 1 a verdict unexpected or undecided; 2 bad input, with one line on
standard error; 130 interrupted; 141 the reader of a pipe left before the answer was known.
"""

from __future__ import annotations

import os
import re
import sys
from importlib import import_module
from typing import TYPE_CHECKING

import tresym
from tresym.commands.parser import BAD_INPUT, CLOSED_PIPE, INTERRUPTED, Parser, one_line
from tresym.output import check_replaceable
from tresym.reals.numbers.exact import InputError

if TYPE_CHECKING:
    import argparse

COMMANDS = (
    "verify",
    "derive",
    "table",
    "docs",
    "flip",
    "check",
    "export",
    "paper",
    "lsp",
    "audit",
    "bench",
    "sweep",
    "figure",
    "chart",
    "completion",
)
"""In the order of the help; only the file of the one that is asked for is loaded."""

BEGIN = """\
tresym: the tennis racket effect, verified. To begin with:

  tresym flip --body str                  how perfect the flip of a racket is
  tresym flip --inertia 1210 16380 17480  the same of a body of yours
  tresym verify eq_gamma                  a statement, and all that it rests on
  tresym check 'exp(x) >= 1 + x'          a claim of your own
  tresym paper MANUSCRIPT.tex             the displays of a manuscript of yours
  tresym verify                           every statement (half a minute)

tresym --help lists the commands, tresym COMMAND --help the arguments of one.
"""
"""What `tresym` alone says."""

INPUTS = ("file", "source", "papers", "notes", "baseline", "csv")
OUTPUTS = ("path", "coq", "export", "marks")
"""Arguments, of any command, that name a file to read, and one to write."""
REPLACING = ("path", "coq", "marks")
"""Of these, those whose files are checked here; a sweep checks its table itself."""

_OPTION = re.compile(r"-[hof]|--")


def build_parser(chosen: str | None = None) -> Parser:
    """The parser of the whole command line, or of the command ``chosen`` alone."""
    parser = Parser(
        prog="tresym",
        description="The tennis racket effect, verified: proofs, certified numbers, figures.",
        allow_abbrev=False,
    )
    parser.add_argument("--version", action="version", version=f"tresym {tresym.__version__}")
    commands = parser.add_subparsers(title="commands", metavar="COMMAND", required=True)
    for name in (chosen,) if chosen in COMMANDS else COMMANDS:
        import_module(f"tresym.commands.{name}").add(commands)
    for command in commands.choices.values():
        written = {action.dest for action in command._actions} & {*OUTPUTS, "html"}
        if written and command.prog.split()[-1] != "sweep":
            command.add_argument(
                "--force", action="store_true", help="replace files that tresym did not write"
            )
    return parser


def _keep_negative_values(words: list[str]) -> list[str]:
    """Mark words such as -1e5, -pi/2 or -inf as values: a leading space hides them from argparse.

    Every number is parsed after the spaces around it are dropped.
    """
    return [
        " " + word if word.startswith("-") and word != "-" and not _OPTION.match(word) else word
        for word in words
    ]


def _keep_inputs(args: argparse.Namespace) -> None:
    """See, before any work, that no output would replace an input or a file of the user's.

    Raises:
        InputError: one would.
    """
    given = vars(args)
    for goal in filter(None, map(given.get, OUTPUTS)):
        named = filter(None, map(given.get, INPUTS))
        sources = (one for name in named for one in (name if isinstance(name, list) else [name]))
        for source in sources:
            if os.path.isfile(goal) and os.path.realpath(goal) == os.path.realpath(source):
                raise InputError(f"{goal}: is read here, and is not replaced; name another file")
    if "csv" not in given:
        check_replaceable(filter(None, map(given.get, REPLACING)), given.get("force", False))


def main(arguments: list[str] | None = None) -> int:
    """Run one command line; returns the exit status."""
    words = sys.argv[1:] if arguments is None else arguments
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="replace")
    if not words:
        print(BEGIN, end="")
        return 0
    try:
        args = build_parser(next(iter(words), None)).parse_args(_keep_negative_values(words))
        _keep_inputs(args)
        status: int = args.run(args)
        try:
            if sys.stdout is not None:
                sys.stdout.flush()
        except BrokenPipeError:  # the answer is known, whether or not anybody reads it
            _forget_output()
        return status
    except InputError as error:
        print(f"tresym: {one_line(str(error), 2000)}", file=sys.stderr)
        return BAD_INPUT
    except KeyboardInterrupt:
        print("tresym: interrupted", file=sys.stderr)
        return INTERRUPTED
    except BrokenPipeError:
        # The reader left before the answer was known; say nothing, not even while Python exits.
        _forget_output()
        return CLOSED_PIPE
    except OSError as error:
        name = one_line(str(error.filename or "output"), 400)
        print(f"tresym: {name}: {error.strerror}", file=sys.stderr)
        if error.filename is None:
            _forget_output()
        return BAD_INPUT


def _forget_output() -> None:
    """Send what is left in the buffer nowhere: Python would complain of it at its end."""
    if sys.stdout is not None:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
