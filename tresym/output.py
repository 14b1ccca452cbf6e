"""Write files completely or not at all, never over the user's own, and print to terminals."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Iterator
from contextlib import contextmanager, suppress
from typing import TYPE_CHECKING

from tresym.reals.numbers.exact import InputError

if TYPE_CHECKING:
    from rich.console import Console

RECORDED = 20_000
"""How many checksums of written files are remembered: 65 bytes each."""


def replaceable(path: str) -> bool:
    """Whether writing to ``path`` destroys nothing: no file, an empty one, or one we wrote.

    A file counts as ours only if the SHA-256 of its present content is in the record of files
    written on this machine, so a file that was edited since is not replaced.
    """
    if not os.path.isfile(path) or not os.path.getsize(path):
        return True
    try:
        with open(_record(), encoding="ascii") as file:
            known = set(file.read().split())
        return _checksum(path) in known
    except (OSError, ValueError):
        return False


def _record() -> str:
    """The file with the checksums of what was written, in the user's state directory."""
    home = os.environ.get("XDG_STATE_HOME") or os.path.expanduser("~/.local/state")
    return os.path.join(home, "tresym", "written")


def _checksum(path: str) -> str:
    from hashlib import file_digest

    with open(path, "rb") as file:
        return file_digest(file, "sha256").hexdigest()


def _remember(path: str) -> None:
    """Record the checksum of a file just written; without a record it needs --force later."""
    record = _record()
    with suppress(OSError, ValueError):
        os.makedirs(os.path.dirname(record), exist_ok=True)
        line = f"{_checksum(path)}\n".encode()
        # One short append is atomic, so commands that run at the same time do not mix lines.
        descriptor = os.open(record, os.O_WRONLY | os.O_APPEND | os.O_CREAT, 0o600)
        try:
            os.write(descriptor, line)
        finally:
            os.close(descriptor)
        if os.path.getsize(record) > 2 * RECORDED * len(line):
            with open(record, encoding="ascii") as file:
                recent = file.readlines()[-RECORDED:]
            aside = f"{record}.{os.getpid()}.part"
            with open(aside, "w", encoding="ascii") as file:
                file.writelines(recent)
            os.replace(aside, record)


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
            _remember(goal)
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


def check_replaceable(paths: Iterable[str], force: bool = False) -> None:
    """Check, before any work, that no file of the user's would be replaced.

    Args:
        paths: the files that are going to be written.
        force: replace whatever is there.

    Raises:
        InputError: a file is there that tresym did not write, or that was changed since.
    """
    for path in paths:
        if not force and not replaceable(path):
            shown = path if path.isprintable() else ascii(path)
            raise InputError(
                f"{shown}: exists, and tresym did not write it or it was changed since; "
                "name another file, or replace it with --force where the command has it"
            )


def make_folder(folder: str) -> None:
    """Make a folder to write in, where there is none.

    Raises:
        InputError: it cannot be made.
    """
    try:
        os.makedirs(folder, exist_ok=True)
    except (OSError, ValueError) as error:
        reason = error.strerror or error if isinstance(error, OSError) else error
        raise InputError(f"{folder!a}: no folder to write in ({reason})") from None


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


def terminal() -> Console:
    """A console of rich that raises BrokenPipeError, as print does, when a reader leaves.

    rich itself would end the command with exit status 1, which stands for a refuted statement.
    """
    from rich.console import Console

    class Terminal(Console):
        def on_broken_pipe(self) -> None:
            raise BrokenPipeError

    return Terminal(highlight=False)


def colour_wanted() -> bool:
    """Whether standard output is a terminal and the user has not set ``NO_COLOR``."""
    return sys.stdout is not None and sys.stdout.isatty() and not os.environ.get("NO_COLOR")


def bold(text: str, colour: bool) -> str:
    """``text`` in bold where colour is wanted."""
    return f"\x1b[1m{text}\x1b[0m" if colour else text


def dim(text: str, colour: bool) -> str:
    """``text`` dimmed where colour is wanted."""
    return f"\x1b[2m{text}\x1b[0m" if colour else text
