"""Where answers go: a file that is whole or not there, and a terminal that may be a pipe."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterable, Iterator
from contextlib import contextmanager, suppress

from tresym.reals.numbers.exact import InputError

_BEGINS = re.compile(
    r"""
      (\[\s*)? \{ \s* "(verdict|version|workload|display|paper|a|caption)":
      | (PROVED|ENCLOSED|REFUTED|UNDECIDED|DEFINED|ASSUMED|EQUATION|UNREAD)\s
      | [^\n]+ \n\n [ ]shape[ ] | flowchart[ ]BT\n | (claim|piece|mutant)[ ]{2}
      | (separatrix|many|turn|defect|flipmap|identities|check|waiting|precision|honesty|atlas):[ ]
      | (sweep|scaling):[ ] | [-\w]+ [ ]+ (Fig\.|True)[ ]
      | \|[ ] (body|shape|route|a₀)[ ] \| | ([^\n]+\n){1,6} \n ([^\n]+\n){1,9}? ─[─ ]+\n
      | \\begin\{(sideways)?table\}(\\centering)?\\small\\setlength
      | (?!\\documentclass) .{0,2000}? \\label\{tresym:
      | \\documentclass\[a4paper,11pt\]\{article\} .{0,600} \\definecolor\{proved\}
      | \(\* .{0,2000} tresym | (%PDF|.PNG|GIF8|.{4}ftyp) .* tresym
      | <\?xml .*? <title>[^<]*</title>\s*<(metadata|desc)>""",
    re.VERBOSE | re.DOTALL,
)
"""How begins what the commands write with ``-o``."""


def replaceable(path: str) -> bool:
    """Whether there is no file at ``path``, or an empty one, or one that begins as one of ours."""
    if not os.path.isfile(path):
        return True
    with open(path, "rb") as file:
        head = file.read(20_000)
        file.seek(max(0, os.path.getsize(path) - 4000))
        text = (head + file.read()).decode("utf-8", errors="replace")
    return not head or _BEGINS.match(text) is not None


def write_text(path: str, text: str) -> None:
    """Write ``text`` (UTF-8) to ``path``, whole or not at all (:func:`writing`)."""
    write_bytes(path, text.encode("utf-8", errors="backslashreplace"))


def write_bytes(path: str, data: bytes) -> None:
    """Write ``data`` to ``path``, whole or not at all (:func:`writing`)."""
    with writing(path) as aside, open(aside, "wb") as file:
        file.write(data)


@contextmanager
def writing(path: str) -> Iterator[str]:
    """What the block writes to: a file aside, renamed at its end, so no half file is ever seen.

    A device or a pipe is written to as it is; of a link, the file it leads to is replaced.

    Raises:
        InputError: the file cannot be written there.
    """
    aside = None
    try:
        if os.path.exists(path) and not os.path.isfile(path):
            yield path
        else:
            goal = os.path.realpath(path)
            aside = f"{goal}.{os.getpid()}.part"
            _remove_what_the_dead_left(goal)
            yield aside
            os.replace(aside, goal)
    except InputError:
        raise
    except (OSError, ValueError) as error:
        shown = path if path.isprintable() else ascii(path)
        reason = error.strerror or error if isinstance(error, OSError) else error
        raise InputError(f"{shown}: cannot be written ({reason})") from None
    finally:
        if aside is not None:
            with suppress(OSError):
                os.remove(aside)


def own_folder(folder: str, names: Iterable[str], mark: str) -> None:
    """Make the folder; what stands there by the names to be written must bear our mark.

    Raises:
        InputError: it cannot be made, or holds a file of somebody else by one of the names.
    """
    try:
        os.makedirs(folder, exist_ok=True)
        for name in names:
            path = os.path.join(folder, name)
            if os.path.isfile(path) and os.path.getsize(path) and not _bears(path, mark):
                shown = path if path.isprintable() else ascii(path)
                raise InputError(f"{shown}: is not ours, and is not replaced; name another folder")
    except (OSError, ValueError) as error:
        reason = error.strerror or error if isinstance(error, OSError) else error
        raise InputError(f"{folder!a}: no folder to write in ({reason})") from None


def _bears(path: str, mark: str) -> bool:
    with open(path, encoding="utf-8", errors="replace") as file:
        return mark in file.read(10_000)


def _remove_what_the_dead_left(goal: str) -> None:
    """Remove the files aside of processes that were killed while they wrote."""
    folder, name = os.path.split(goal)
    for found in os.listdir(folder or "."):
        process = found.removeprefix(f"{name}.").removesuffix(".part")
        is_ours = found == f"{name}.{process}.part" and process.isdecimal()
        if is_ours and not _is_alive(int(process)):
            with suppress(OSError):
                os.remove(os.path.join(folder, found))


def _is_alive(process: int) -> bool:
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except OSError:
        return True
    return True


def colour_wanted() -> bool:
    """Whether standard output is a terminal and the user has not set ``NO_COLOR``."""
    return sys.stdout is not None and sys.stdout.isatty() and not os.environ.get("NO_COLOR")


def bold(text: str, colour: bool) -> str:
    """``text`` in bold where colour is wanted."""
    return f"\x1b[1m{text}\x1b[0m" if colour else text


def dim(text: str, colour: bool) -> str:
    """``text`` dimmed where colour is wanted."""
    return f"\x1b[2m{text}\x1b[0m" if colour else text
