"""Where answers go: a file that is whole or not there, and a terminal that may be a pipe."""

from __future__ import annotations

import os
import sys

from tresym.exact import InputError


def write_text(path: str, text: str) -> None:
    """Write ``text`` (UTF-8) to ``path``: aside first, then renamed, so no half file is ever seen.

    Raises:
        InputError: the file cannot be written there.
    """
    aside = f"{path}.{os.getpid()}.part"
    try:
        with open(aside, "w", encoding="utf-8") as file:
            file.write(text)
        os.replace(aside, path)
    except OSError as error:
        if os.path.exists(aside):
            os.remove(aside)
        raise InputError(f"{path}: cannot be written ({error.strerror})") from None


def colour_wanted() -> bool:
    """Whether standard output is a terminal and the user has not set ``NO_COLOR``."""
    return sys.stdout is not None and sys.stdout.isatty() and not os.environ.get("NO_COLOR")


def bold(text: str, colour: bool) -> str:
    """``text`` in bold where colour is wanted."""
    return f"\x1b[1m{text}\x1b[0m" if colour else text


def dim(text: str, colour: bool) -> str:
    """``text`` dimmed where colour is wanted."""
    return f"\x1b[2m{text}\x1b[0m" if colour else text
