"""Rows of text that were computed before, in a file of the user's cache folder.

    rows = Rows(path)
    rows.put(b"key", "text")
    rows.get(b"key")          # "text", in this run and in the next one

The file is a SQLite database in write-ahead mode, so several runs may share it and a run that is
killed loses nothing that was written. Each row carries a checksum over its key, its text and the
version of the code: what was truncated or changed is not used. A damaged file is replaced by an
empty one, and one line says so. A file that cannot be written is still read; one that cannot be
read is not used, and one line says so.
"""

from __future__ import annotations

import hashlib
import os
import sqlite3
import sys
from contextlib import suppress
from pathlib import Path

from tresym.checking.cache_folder import cache_folder, version

MAX_BYTES = 100_000_000
"""Size of the file at most when a run ends; what was written longest ago is dropped first."""
MOST_HALVINGS = 20
_PRAGMAS = ("journal_mode=WAL", "synchronous=NORMAL")
_TABLE = (
    "CREATE TABLE IF NOT EXISTS answers "
    "(key BLOB PRIMARY KEY, value TEXT, sum BLOB, written INTEGER) WITHOUT ROWID"
)


def cache_file() -> Path | None:
    """The file in the cache folder."""
    folder = cache_folder()
    return folder and folder / "answers.sqlite"


class Rows:
    """The rows of a file; every failure of the file is answered by doing without."""

    def __init__(self, path: Path) -> None:
        """Open the file, which is made where it is missing."""
        self.path = path
        self._database: sqlite3.Connection | None = None
        self.reads_only = False
        """Whether the file cannot be written, so that nothing is added to it."""
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            self._open()
        except (sqlite3.Error, OSError) as error:
            self._recover(error)

    def _open(self) -> None:
        self._database = _connected(str(self.path))
        for pragma in _PRAGMAS:
            self._database.execute(f"PRAGMA {pragma}")
        self._database.execute(_TABLE)
        self._database.execute("SELECT key, value, sum, written FROM answers LIMIT 1").fetchone()

    def _recover(self, error: Exception) -> None:
        """Begin a damaged file anew, read one that cannot be written, or do without."""
        self._forget()
        try:
            if _is_damage(error):
                for end in ("", "-wal", "-shm"):
                    self.path.with_name(self.path.name + end).unlink(missing_ok=True)
                self._open()
                _tell(f"the cache {self.path} was damaged and is begun anew")
                return
            if self.path.is_file() and not os.access(self.path, os.W_OK):
                self._database = _connected(f"{self.path.resolve().as_uri()}?mode=ro&immutable=1")
                self._database.execute("SELECT key FROM answers LIMIT 1").fetchone()
                self.reads_only = True
                return
        except (sqlite3.Error, OSError) as another:
            error = another
        self._give_up(error)

    def get(self, key: bytes) -> str | None:
        """The text that was put under the key by the same version of the code, or None."""
        if self._database is None:
            return None
        try:
            row = self._database.execute(
                "SELECT value, sum FROM answers WHERE key = ?", (key,)
            ).fetchone()
        except sqlite3.Error as error:
            self._recover(error)
            return None
        if row is None or not isinstance(row[0], str) or row[1] != _sum(key, row[0]):
            return None
        return str(row[0])

    def put(self, key: bytes, value: str) -> None:
        """Keep a text under a key, unless the file cannot be written."""
        if self._database is None or self.reads_only:
            return
        try:
            self._database.execute(
                "INSERT OR REPLACE INTO answers VALUES (?, ?, ?, unixepoch())",
                (key, value, _sum(key, value)),
            )
        except sqlite3.Error as error:
            self._recover(error)

    def close(self) -> None:
        """Drop what is too much, and close the file."""
        if self._database is None:
            return
        with suppress(sqlite3.Error):
            before = 0 if self.reads_only else self._bytes()
            for _ in range(MOST_HALVINGS):
                if self._bytes() <= MAX_BYTES:
                    break
                self._database.execute(
                    "DELETE FROM answers WHERE key IN (SELECT key FROM answers ORDER BY written "
                    "LIMIT (SELECT (count(*) + 1) / 2 FROM answers))"
                )
            if self._bytes() < before:
                self._database.execute("VACUUM")
        with suppress(sqlite3.Error):
            self._database.close()
        self._database = None

    def _bytes(self) -> int:
        """The size of what is in use."""
        assert self._database is not None
        pages, size, free = (
            int(self._database.execute(f"PRAGMA {name}").fetchone()[0])
            for name in ("page_count", "page_size", "freelist_count")
        )
        return (pages - free) * size

    def _forget(self) -> None:
        if self._database is not None:
            with suppress(sqlite3.Error):
                self._database.close()
        self._database = None

    def _give_up(self, error: Exception) -> None:
        self._forget()
        why = " ".join(str(error).split())[:200]
        removed = "tresym paper --clear-cache removes it"
        _tell(f"continuing without the cache {self.path}: {why} ({removed})")


def _connected(name: str) -> sqlite3.Connection:
    """Open a database by its file or its URI; text that is no Unicode reads as other text."""
    uri = name.startswith("file:")
    made = sqlite3.connect(name, 2, isolation_level=None, check_same_thread=False, uri=uri)
    made.text_factory = lambda raw: raw.decode("utf-8", "replace")
    return made


def _is_damage(error: Exception) -> bool:
    """Whether an error says that the file is no database of ours, and not that it is in use."""
    words = str(error)
    other_table = isinstance(error, sqlite3.OperationalError) and "no such column" in words
    return other_table or (
        isinstance(error, sqlite3.DatabaseError)
        and not isinstance(error, (sqlite3.OperationalError, sqlite3.ProgrammingError))
    )


def _tell(line: str) -> None:
    if sys.stderr is not None:
        print(f"tresym: {line}", file=sys.stderr)


def _sum(key: bytes, value: str) -> bytes:
    return hashlib.sha256(version() + key + value.encode()).digest()
