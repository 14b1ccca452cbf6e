"""Where answers go: a file that is whole or not there, and a terminal that may be a pipe."""

from __future__ import annotations

import os
import sys
from contextlib import suppress

from tresym.exact import InputError


def write_text(path: str, text: str) -> None:
    """Write ``text`` (UTF-8) to ``path`` as :func:`write_bytes` does."""
    write_bytes(path, text.encode("utf-8", errors="backslashreplace"))


def write_bytes(path: str, data: bytes) -> None:
    """Write ``data`` to ``path``: aside first, then renamed, so no half file is ever seen.

    A device or a pipe is written to as it is; of a link, the file it leads to is replaced.

    Raises:
        InputError: the file cannot be written there.
    """
    try:
        if os.path.exists(path) and not os.path.isfile(path):
            _write(path, data)
        else:
            _replace(os.path.realpath(path), data)
    except (OSError, ValueError) as error:
        shown = path if path.isprintable() else ascii(path)
        reason = error.strerror if isinstance(error, OSError) else error
        raise InputError(f"{shown}: cannot be written ({reason})") from None


def _replace(path: str, data: bytes) -> None:
    aside = f"{path}.{os.getpid()}.part"
    try:
        _write(aside, data)
        os.replace(aside, path)
    finally:
        with suppress(OSError):
            os.remove(aside)


def _write(path: str, data: bytes) -> None:
    with open(path, "wb") as file:
        file.write(data)


def colour_wanted() -> bool:
    """Whether standard output is a terminal and the user has not set ``NO_COLOR``."""
    return sys.stdout is not None and sys.stdout.isatty() and not os.environ.get("NO_COLOR")


def bold(text: str, colour: bool) -> str:
    """``text`` in bold where colour is wanted."""
    return f"\x1b[1m{text}\x1b[0m" if colour else text


def dim(text: str, colour: bool) -> str:
    """``text`` dimmed where colour is wanted."""
    return f"\x1b[2m{text}\x1b[0m" if colour else text
