"""What the commands share: a parser that complains in one line, and where answers go."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any, NoReturn, TypeAlias

from tresym.reals.numbers.exact import InputError

if TYPE_CHECKING:
    from collections.abc import Callable

Commands: TypeAlias = "argparse._SubParsersAction[Parser]"

UNEXPECTED = 1
BAD_INPUT = 2
INTERRUPTED = 130
PICTURE_PATH = "write to a file instead: .svg, .pdf or .png"


class Parser(argparse.ArgumentParser):
    """argparse, with its complaints as one line."""

    def error(self, message: str) -> NoReturn:
        """Raise the complaint as bad input; what it quotes may be long, or not printable."""
        raise InputError(f"{one_line(message, 200)} (see {self.prog} --help)")


def one_line(text: str, longest: int) -> str:
    """``text`` as it may be shown: what it quotes may be long, or not printable."""
    shown = text if text.isprintable() else ascii(text)[1:-1]
    return shown if len(shown) <= longest else shown[: longest - 3] + "..."


def add_output(parser: argparse.ArgumentParser) -> None:
    """Add --json and -o."""
    parser.add_argument("--json", action="store_true", help="print JSON")
    parser.add_argument("-o", dest="path", metavar="PATH", help="write to a file instead")


def worker_count(text: str | None) -> int:
    """The number of processes that ``text`` asks for; one a core if nothing is asked."""
    from tresym.reals.processes import cores, parse_workers

    return cores() if text is None else parse_workers(text)


def deliver(text: str, path: str | None) -> None:
    """To the file ``path``, or to standard output."""
    if path is None:
        print(text, end="")
        return
    from tresym.output import write_text

    write_text(path, text)


def deliver_json(answer: dict[str, Any], path: str | None) -> None:
    """A value as one line of JSON, delivered."""
    deliver(json_line(answer), path)


def json_line(answer: dict[str, Any]) -> str:
    """A value as one line of JSON."""
    import json

    return json.dumps(answer, ensure_ascii=False) + "\n"


MAX_SECONDS = 86_400
LEAST_SECONDS = 0.001


def parse_seconds(text: str) -> float:
    """The seconds that --limit names; InputError unless they are above 0 and at most a day."""
    from tresym.reals.numbers.exact import parse_number

    value = parse_number(text, "--limit")
    if not 0 < value <= MAX_SECONDS:
        raise InputError(f"--limit: more than 0 and at most {MAX_SECONDS} seconds")
    return max(int(value.p) / int(value.q), LEAST_SECONDS)


def deliver_picture(draw: Callable[[str], bytes], path: str | None) -> None:
    """To a file of the kind its name ends in, or as SVG to standard output."""
    from tresym.output import write_bytes
    from tresym.report.figures import kind_of

    picture = draw(kind_of(path))
    if path is None:
        print(picture.decode(), end="")
    else:
        write_bytes(path, picture)
