"""The ``tresym`` command line: each command has a module with its parser, action and output.

Exit status: 0 if all is as expected; 1 if a verdict is not as expected; 2 for bad input, with one
line on standard error; 130 if interrupted; 141 if the reader of a pipe left before the answer.
"""

from __future__ import annotations

import os
import re
import sys
from importlib import import_module
from typing import TYPE_CHECKING

from tresym.commands.parser import BAD_INPUT, CLOSED_PIPE, INTERRUPTED, Parser, one_line
from tresym.output import check_replaceable
from tresym.reals.numbers.exact import InputError, quoted

if TYPE_CHECKING:
    import argparse

COMMANDS = (
    "verify",
    "derive",
    "table",
    "docs",
    "flip",
    "check",
    "explain",
    "expand",
    "error",
    "atlas",
    "best",
    "export",
    "paper",
    "new",
    "lsp",
    "mcp",
    "audit",
    "bench",
    "sweep",
    "figure",
    "chart",
    "completion",
)
"""The commands in the order of the help; only the module of the requested one is loaded."""

BEGIN = """\
tresym: check formulas, approximations and manuscripts. Examples:

  tresym check 'exp(x) >= 1 + x'          a claim of your own
  tresym table 'sin(x)' x --as 'x -> 0'   how good an approximation is
  tresym error 'sin(x)' x --on '0<=x<=1'  its largest error on a region
  tresym paper MANUSCRIPT.tex             the formulas of your manuscript
  tresym new mine                         a file of claims, for a paper of your own
  tresym flip --body wilson               how complete the flip of a racket is
  tresym flip --inertia 1210 16380 17480  the same for your own body
  tresym verify main_theorem_remainder    a statement of the racket paper
  tresym verify                           all its statements (half a minute)

tresym --help lists the commands; tresym COMMAND --help explains one of them.
"""
"""The output of `tresym` without arguments."""

INPUTS = ("file", "source", "papers", "notes", "baseline", "csv")
OUTPUTS = ("path", "coq", "export", "marks")
"""Arguments of any command that name a file to write; INPUTS name a file to read."""
REPLACING = ("path", "coq", "marks")
"""Outputs that are checked here; a sweep checks its table itself."""

_OPTION = re.compile(r"-[hof]|--")


def build_parser(chosen: str | None = None) -> Parser:
    """Return the parser of the whole command line, or only of the command ``chosen``."""
    parser = Parser(
        prog="tresym",
        description="Check formulas, approximations and manuscripts: verdicts with proofs or "
        "counterexamples, and certified numbers. Begin with: tresym check 'sin(x) < x'",
    )
    parser.add_argument("--version", action="store_true", help="print version and commit")
    commands = parser.add_subparsers(title="commands", metavar="COMMAND", required=True)
    for name in (chosen,) if chosen in COMMANDS else COMMANDS:
        module = import_module(f"tresym.commands.{name}")
        module.add(commands)
        commands.choices[name].set_defaults(run=module.run)
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
    """Check before any work that no output would replace an input or a file of the user's.

    Raises:
        InputError: an output would.
    """
    given = vars(args)
    for goal in filter(None, map(given.get, OUTPUTS)):
        named = filter(None, map(given.get, INPUTS))
        sources = (one for name in named for one in (name if isinstance(name, list) else [name]))
        for source in sources:
            if os.path.isfile(goal) and os.path.realpath(goal) == os.path.realpath(source):
                raise InputError(
                    f"{goal}: this is an input file, so it is not replaced; name "
                    "another output file"
                )
    if "csv" not in given:
        check_replaceable(filter(None, map(given.get, REPLACING)), given.get("force", False))


def main(arguments: list[str] | None = None) -> int:
    """Run one command line and return the exit status.

    Args:
        arguments: the words after ``tresym``; None for those of this process.
    """
    words = sys.argv[1:] if arguments is None else arguments
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="replace")
    if not words:
        print(BEGIN, end="")
        return 0
    if words == ["--version"]:
        from tresym.release import described

        print(f"tresym {described()}")
        return 0
    try:
        if words[0].startswith("-") and words[0] not in ("-h", "--help", "--version"):
            raise InputError(
                f"there is no option {quoted(words[0])} before the command; write tresym COMMAND "
                "OPTIONS (see tresym --help)"
            )
        args = build_parser(next(iter(words), None)).parse_args(_keep_negative_values(words))
        _keep_inputs(args)
        status: int = args.run(args)
        try:
            if sys.stdout is not None:
                sys.stdout.flush()
        except BrokenPipeError:  # the answer is known even if nobody reads it
            _forget_output()
        return status
    except InputError as error:
        print(f"tresym: {one_line(str(error), 2000)}", file=sys.stderr)
        return BAD_INPUT
    except KeyboardInterrupt:
        print("tresym: interrupted", file=sys.stderr)
        return INTERRUPTED
    except BrokenPipeError:
        # The reader left before the answer was known: print nothing, not even while Python exits.
        _forget_output()
        return CLOSED_PIPE
    except OSError as error:
        name = one_line(str(error.filename or "output"), 400)
        print(f"tresym: {name}: {error.strerror}", file=sys.stderr)
        if error.filename is None:
            _forget_output()
        return BAD_INPUT


def _forget_output() -> None:
    """Discard buffered output, about which Python would otherwise complain at exit."""
    if sys.stdout is not None:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
