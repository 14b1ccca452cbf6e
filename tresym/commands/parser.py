"""Shared by the commands: a parser with one-line errors, common options, and output."""

from __future__ import annotations

import argparse
import sys
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, NoReturn, TypeAlias

from tresym.reals.numbers.exact import InputError

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator, Sequence


Commands: TypeAlias = "argparse._SubParsersAction[Parser]"

UNEXPECTED = 1
BAD_INPUT = 2
INTERRUPTED = 130
CLOSED_PIPE = 141
PICTURE_PATH = "write to a file (.svg, .pdf or .png) instead of standard output"


class Parser(argparse.ArgumentParser):
    """An argument parser that raises InputError with a one-line message; no abbreviations."""

    def __init__(self, **options: Any) -> None:
        super().__init__(allow_abbrev=False, **options)

    def parse_args(self, args: Any = None, namespace: Any = None) -> Any:
        """Parse the words; an unknown option is refused with the nearest one of its command."""
        found, rest = self.parse_known_args(args, namespace)
        if rest:
            named, word = self._named(args or ()), rest[0].strip()
            options = [option for option in named._option_string_actions if len(option) > 2]
            meant = nearest(word.partition("=")[0], options) if word.startswith("-") else ""
            named.error(f"there is no argument {word!r}{meant}")
        return found

    def _named(self, words: Sequence[str]) -> Parser:
        """Return the parser of the command that the words name, or this one."""
        for action in self._actions:
            if isinstance(action, argparse._SubParsersAction):
                parsers: dict[str, Parser] = action.choices
                return next((parsers[word] for word in words if word in parsers), self)
        return self

    def _check_value(self, action: argparse.Action, value: Any) -> None:
        if action.choices is not None and value not in action.choices:
            known = ", ".join(map(str, action.choices))
            meant = nearest(str(value), map(str, action.choices))
            what = "command" if isinstance(action, argparse._SubParsersAction) else "choice"
            raise argparse.ArgumentError(
                None if what == "command" else action,
                f"there is no {what} {value!r}{meant}" + ("" if meant else f"; known: {known}"),
            )

    def error(self, message: str) -> NoReturn:
        """Raise the message as InputError; quoted input may be long, or not printable."""
        raise InputError(f"{one_line(message, 200)} (see {self.prog} --help)")


def nearest(word: str, known: Iterable[str]) -> str:
    """Return ``; did you mean …?`` with the nearest known word, or an empty text."""
    from difflib import get_close_matches

    found = get_close_matches(word, list(known), 1, 0.7)
    return f"; did you mean {found[0]}?" if found else ""


def one_line(text: str, longest: int) -> str:
    """Return ``text`` as printable characters, cut to ``longest``."""
    shown = text if text.isprintable() else ascii(text)[1:-1]
    return shown if len(shown) <= longest else shown[: longest - 3] + "..."


@contextmanager
def in_a_checkout(what: str) -> Iterator[None]:
    """Run a block that imports :mod:`tresym.dev`, which the wheel does not contain.

    Raises:
        InputError: tresym does not run from a checkout.
    """
    try:
        yield
    except ModuleNotFoundError as error:
        if error.name != "tresym.dev":
            raise
        raise InputError(
            f"{what}: runs only in a source checkout of tresym; "
            "the installed package does not contain it"
        ) from None


def add_options(
    parser: argparse.ArgumentParser | argparse._ArgumentGroup, *options: tuple[str, str]
) -> None:
    """Add options with their help: ``--full``, ``--coq DIR`` or, with a default, ``--dpi N=9``."""
    for spec, says in options:
        name, _, value = spec.partition(" ")
        metavar, _, default = value.partition("=")
        more: dict[str, Any] = {"metavar": metavar, "default": default or None}
        parser.add_argument(name, help=says, **(more if value else {"action": "store_true"}))


def add_output(parser: argparse.ArgumentParser) -> None:
    """Add --json and -o."""
    add_options(parser, ("--json", "print JSON"))
    parser.add_argument(
        "-o", dest="path", metavar="PATH", help="write to a file instead of standard output"
    )


def worker_count(text: str | None) -> int:
    """Return the number of processes in ``text``; one per core if it is None."""
    from tresym.reals.processes import cores, parse_workers

    return cores() if text is None else parse_workers(text)


def deliver(text: str, path: str | None) -> None:
    """Write a text to the file ``path``, or print it if that is None."""
    if path is None:
        print(text, end="")
        return
    from tresym.output import write_text

    write_text(path, text)


def deliver_json(answer: dict[str, Any], path: str | None) -> None:
    """Write or print a value as one line of JSON."""
    deliver(json_line(answer), path)


def json_line(answer: dict[str, Any]) -> str:
    """Return a value as one line of JSON."""
    import json

    return json.dumps(answer, ensure_ascii=False) + "\n"


MAX_SECONDS = 86_400
LEAST_SECONDS = 0.001


def parse_seconds(text: str) -> float:
    """Return the seconds of --limit.

    Raises:
        InputError: it is not a number above 0 and at most a day.
    """
    from tresym.reals.numbers.exact import parse_number

    value = parse_number(text, "--limit")
    if not 0 < value <= MAX_SECONDS:
        raise InputError(f"--limit: give a time above 0 and at most {MAX_SECONDS} seconds")
    return max(int(value.p) / int(value.q), LEAST_SECONDS)


def deliver_picture(
    draw: Callable[[str], bytes], path: str | None, kind: str | None = None
) -> None:
    """Draw a picture and write it to a file, or to standard output.

    Args:
        draw: returns the picture in a format.
        path: the file; None for standard output.
        kind: the format; None to take it from the ending of ``path``.
    """
    from tresym.output import write_bytes
    from tresym.report.figures import kind_of

    picture = draw(kind_of(path) if kind is None else kind)
    if path is not None:
        write_bytes(path, picture)
    elif kind in (None, "svg"):
        print(picture.decode(), end="")
    else:
        sys.stdout.buffer.write(picture)
