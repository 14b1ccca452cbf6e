"""Write files completely or not at all, never over the user's own files, and print to terminals."""

from __future__ import annotations

import os
import stat
import sys
from collections.abc import Iterable, Iterator
from contextlib import contextmanager, suppress

from tresym.reals.numbers.exact import InputError

RECORDED = 20_000
"""The number of checksums of written files that are kept; each takes 65 bytes."""


def replaceable(path: str) -> bool:
    """Return whether writing to ``path`` destroys nothing that is not tresym's own.

    This is so if there is no file, if the file is empty, or if tresym wrote it. A file counts as
    written by tresym only if the SHA-256 of its present content is in the record of files written
    on this machine, so a file that was edited since is not replaced.
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
    """The file with the checksums of files written, in the user's state directory."""
    home = os.environ.get("XDG_STATE_HOME") or os.path.expanduser("~/.local/state")
    return os.path.join(home, "tresym", "written")


def _checksum(path: str) -> str:
    from hashlib import file_digest

    with open(path, "rb") as file:
        return file_digest(file, "sha256").hexdigest()


def _remember(path: str) -> None:
    """Record the checksum of a file just written; if that fails, replacing it will need --force."""
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
    """Write ``text`` to ``path`` in UTF-8, completely or not at all.

    Raises:
        InputError: the file cannot be written.
    """
    write_bytes(path, text.encode("utf-8", errors="backslashreplace"))


def write_bytes(path: str, data: bytes) -> None:
    """Write ``data`` to ``path``, completely or not at all.

    Raises:
        InputError: the file cannot be written.
    """
    with writing(path) as aside, open(aside, "wb") as file:
        file.write(data)


@contextmanager
def writing(path: str) -> Iterator[str]:
    """Yield the path of a temporary file, which replaces ``path`` when the block succeeds.

    No reader ever sees a partly written file. Exceptions: a device or pipe is written to directly,
    and for a symbolic link the file that it points to is replaced.

    Raises:
        InputError: the file cannot be written.
    """
    aside = None
    try:
        if os.path.exists(path) and not os.path.isfile(path):
            say_if_waiting(path, "reader")
            yield path
        else:
            goal = os.path.realpath(path)
            aside = f"{goal}.{os.getpid()}.part"
            _remove_leftovers(goal)
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


def say_if_waiting(path: str, peer: str) -> None:
    """Say that a named pipe waits for its other end, as the command does nothing until then.

    Args:
        peer: what it waits for, "reader" or "writer".
    """
    with suppress(OSError, ValueError):
        if stat.S_ISFIFO(os.stat(path).st_mode) and sys.stderr is not None:
            print(f"tresym: {path}: a named pipe; waiting for a {peer}", file=sys.stderr)


def check_replaceable(paths: Iterable[str], force: bool = False) -> None:
    """Check, before any work is done, that no file of the user's would be replaced.

    Args:
        paths: the files that are going to be written.
        force: whether to replace whatever is there; then nothing is checked.

    Raises:
        InputError: there is a file that tresym did not write, or that was changed since.
    """
    for path in paths:
        if not force and not replaceable(path):
            shown = path if path.isprintable() else ascii(path)
            raise InputError(
                f"{shown}: exists, and tresym did not write it or it was changed since; "
                "choose another file, or replace this one with --force if the command has it"
            )


def make_folder(folder: str) -> None:
    """Create a folder, with its parents, if it does not exist.

    Raises:
        InputError: it cannot be created.
    """
    try:
        os.makedirs(folder, exist_ok=True)
    except (OSError, ValueError) as error:
        reason = error.strerror or error if isinstance(error, OSError) else error
        raise InputError(f"{folder!a}: cannot be used as a folder ({reason})") from None


def _remove_leftovers(goal: str) -> None:
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
    """Return whether standard output is a terminal and the user has not set ``NO_COLOR``."""
    return sys.stdout is not None and sys.stdout.isatty() and not os.environ.get("NO_COLOR")


def styled(text: str, style: str, colour: bool = True) -> str:
    """Return ``text`` in a style of terminals if ``colour``: ``"1;31"`` is bold red."""
    return f"\x1b[{style}m{text}\x1b[0m" if colour else text


def bold(text: str, colour: bool) -> str:
    """Return ``text`` in bold if ``colour``, else unchanged."""
    return styled(text, "1", colour)


def dim(text: str, colour: bool) -> str:
    """Return ``text`` dimmed if ``colour``, else unchanged."""
    return styled(text, "2", colour)


def show_progress(text: str) -> None:
    """Show a counter on standard error over the one before, if that is a terminal; "" clears it."""
    if sys.stderr is not None and sys.stderr.isatty() and not os.environ.get("NO_COLOR"):
        print(f"\r{text}\x1b[K\r", end="", file=sys.stderr, flush=True)
