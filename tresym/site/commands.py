"""Write the command reference from the argument parsers, and run examples."""

from __future__ import annotations

import argparse
import contextlib
import io
import re
import shlex
from collections.abc import Iterator

from tresym.report.typesetting.markdown import escaped
from tresym.report.typesetting.plain_text import in_lines

COLUMNS = 84
"""The width of the boxes of the site that show an answer, in characters."""
_TIME = re.compile(r"\b\d[\d.e-]*( ?)(ms|s|µs)\b")


def reference() -> str:
    """Write every command with its usage, arguments and exit status in Markdown."""
    from tresym.commands import build_parser

    parser = build_parser()
    parts = ["# Commands", escaped(parser.description or "")]
    for name, command in _commands(parser).items():
        parts += _command(name, command)
    return "\n\n".join(parts) + "\n"


def _commands(parser: argparse.ArgumentParser) -> dict[str, argparse.ArgumentParser]:
    (found,) = (a for a in parser._actions if isinstance(a, argparse._SubParsersAction))
    return dict(found.choices)


def _command(name: str, parser: argparse.ArgumentParser) -> Iterator[str]:
    yield f"## tresym {name}"
    yield escaped(parser.description or "")
    usage = argparse.HelpFormatter(parser.prog, width=78)
    usage.add_usage(None, parser._actions, parser._mutually_exclusive_groups, prefix="")
    yield f"```text\n{usage.format_help().strip()}\n```"
    rows = [_argument(action) for action in parser._actions if action.dest != "help"]
    yield "\n".join(rows)
    if parser.epilog:
        yield escaped(parser.epilog)


def _argument(action: argparse.Action) -> str:
    """An argument as an entry of a definition list."""
    value = action.metavar if action.nargs != 0 else None
    if action.choices:
        value = "{" + ",".join(map(str, action.choices)) + "}"
    shown = " ".join(value) if isinstance(value, tuple) else value or ""
    if action.option_strings:
        names = [f"`{f'{option} {shown}'.strip()}`" for option in action.option_strings]
    else:
        names = [f"`{shown}`"]
    return f"{', '.join(names)}\n: {escaped(action.help or '')}\n"


def transcript(command: str) -> str:
    """Return a command line and its output, with times replaced by dots, since they vary.

    Raises:
        ValueError: the command is not a tresym command, or its input was refused.
    """
    from tresym.commands import main

    name, *words = shlex.split(command)
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        status = main(words) if name == "tresym" else 2
    if status == 2:
        raise ValueError(f"{command}: is not a tresym command, or its input was refused")
    lines = _TIME.sub("…", printed.getvalue()).rstrip().splitlines()
    if words[:1] in (["check"], ["explain"]):
        lines = [part for line in lines for part in _wrapped(line)]
    return "\n".join([f"$ {on_lines(command)}", *lines, ""])


def on_lines(command: str) -> str:
    """Return a command on lines that fit a box of the site, its options on lines of their own."""
    if len(command) <= COLUMNS:
        return command
    return "\n".join(
        part for line in command.replace(" --", " \\\n    --").split("\n") for part in _broken(line)
    )


def _broken(line: str) -> Iterator[str]:
    """Break a line that is still too long between its quoted arguments."""
    while len(line) > COLUMNS and (at := line.rfind("' ", 0, COLUMNS - 2)) > 0:
        yield f"{line[: at + 1]} \\"
        line = f"    {line[at + 2 :]}"
    yield line


def _wrapped(line: str) -> Iterator[str]:
    text = line.lstrip()
    later = " " * 13 if text != line or re.match("[A-Z]+:", line) else ""
    return in_lines(text, line[: len(line) - len(text)], later, COLUMNS)
