"""The table of a sweep: one SQLite file, one transaction per batch, and exports.

A batch is stored completely or not at all, whatever happens to the process. While a sweep runs, its
file is locked: a second sweep, or a reader, gets an error. A worker returns a batch as a small
database, so that the process which stores all batches does not have to unpack any value.
"""

from __future__ import annotations

import csv
import json
import marshal
import os
import sqlite3
import zlib
from collections.abc import Iterator, Sequence
from contextlib import closing, contextmanager
from pathlib import Path
from typing import Any

from tresym.output import check_replaceable, writing
from tresym.reals.numbers.exact import InputError
from tresym.sweep.rows import SweepRow

APPLICATION = 0x74726573
"""SQLite's ``application_id``, which marks the table of a sweep."""

FORMAT = 3

EXPORT_ROWS = 20_000
"""Rows in memory at once while exporting."""

_RADIUS = SweepRow._fields.index("radius")


def columns(in_floats: bool) -> tuple[str, ...]:
    """Return the names of the columns.

    In float64 the defect is called ``defect_float64`` and has no radius, as nothing certifies it.
    """
    if not in_floats:
        return SweepRow._fields
    names = {"defect": "defect_float64"}
    return tuple(names.get(name, name) for name in SweepRow._fields if name != "radius")


def _schema(in_floats: bool) -> tuple[str, ...]:
    return (
        f"PRAGMA application_id = {APPLICATION}",
        "CREATE TABLE sweep (request TEXT NOT NULL)",
        "CREATE TABLE batches (number INTEGER PRIMARY KEY, rows INTEGER NOT NULL, "
        "checksum INTEGER NOT NULL)",
        _rows_schema(in_floats),
    )


def _rows_schema(in_floats: bool) -> str:
    return f"CREATE TABLE rows (line INTEGER PRIMARY KEY, {', '.join(columns(in_floats)[1:])})"


def packed(rows: Sequence[SweepRow], in_floats: bool) -> bytes:
    """Return a batch as the bytes of a database with the rows and their checksum.

    Args:
        rows: the rows of the batch.
        in_floats: whether they are in float64.
    """
    marks = ", ".join("?" * len(columns(in_floats)))
    values: Sequence[tuple[Any, ...]] = rows
    if in_floats:
        values = [row[:_RADIUS] + row[_RADIUS + 1 :] for row in rows]
    with closing(sqlite3.connect(":memory:", isolation_level=None)) as connection:
        connection.execute("BEGIN")
        connection.execute(_rows_schema(in_floats))
        connection.executemany(f"INSERT INTO rows VALUES ({marks})", values)
        connection.execute("CREATE TABLE checksum (value INTEGER)")
        stored = connection.execute("SELECT * FROM rows ORDER BY line").fetchall()
        connection.execute("INSERT INTO checksum VALUES (?)", (_checksum(stored),))
        connection.execute("COMMIT")
        return connection.serialize()


def _checksum(rows: list[tuple[Any, ...]]) -> int:
    """The checksum of rows as SQLite returns them; ``marshal`` 2 writes equal rows equally."""
    return zlib.crc32(marshal.dumps(rows, 2))


class Table:
    """The file of one sweep, open."""

    def __init__(self, path: str, connection: sqlite3.Connection, in_floats: bool) -> None:
        """Wrap a connection that :func:`open_table` has opened."""
        self.path = path
        self.in_floats = in_floats
        self._connection = connection

    def done(self) -> set[int]:
        """Return the numbers of the batches that are stored."""
        return {number for (number,) in self._connection.execute("SELECT number FROM batches")}

    def add(self, number: int, batch: bytes) -> int:
        """Store one :func:`packed` batch in one transaction.

        Returns:
            The number of its rows.
        """
        run = self._connection.execute
        with _plainly(self.path):
            run("ATTACH ':memory:' AS batch")
            self._connection.deserialize(batch, name="batch")
            run("BEGIN")
            # Both tables have the same schema, so SQLite copies the records unchanged.
            rows = run("INSERT INTO main.rows SELECT * FROM batch.rows").rowcount
            landed = "INSERT INTO batches SELECT ?, ?, value FROM batch.checksum"
            run(landed, (number, rows))
            run("COMMIT")
            run("DETACH batch")
        return rows

    def counts(self) -> tuple[int, int]:
        """Return the number of rows, and how many of them have a problem."""
        query = "SELECT count(*), count(problem) FROM rows"
        rows, bad = self._connection.execute(query).fetchone()
        return rows, bad

    def problems(self, limit: int) -> list[tuple[int, str]]:
        """Return line and reason of the first ``limit`` rows with a problem."""
        query = "SELECT line, problem FROM rows WHERE problem IS NOT NULL ORDER BY line LIMIT ?"
        return list(self._connection.execute(query, (limit,)))

    def _pieces(self) -> Iterator[list[tuple[Any, ...]]]:
        """All rows in order, in lists of bounded length."""
        cursor = self._connection.execute("SELECT * FROM rows ORDER BY line")
        while piece := cursor.fetchmany(EXPORT_ROWS):
            yield piece

    def export(self, path: str) -> None:
        """Write all rows to ``path``, as Parquet if it ends in .parquet, else as CSV.

        Raises:
            InputError: the file cannot be written, or Parquet is wanted without pyarrow.
        """
        write = _write_parquet if path.endswith(".parquet") else _write_csv
        with writing(path) as aside:
            write(aside, self._pieces(), self.in_floats)


def to_frame(path: str) -> Any:
    """Return the table at ``path`` as a pandas DataFrame.

    A certified ``defect`` and its ``radius`` are text with all digits, as in Parquet.

    Raises:
        InputError: pandas is not installed, the file is not the table of a sweep, or a sweep is
            running on it.
    """
    try:
        import pandas
    except ImportError:
        raise InputError("to_frame: pandas is not installed: pip install pandas") from None
    address = f"{Path(os.path.abspath(path)).as_uri()}?mode=ro"
    with _plainly(path), closing(sqlite3.connect(address, timeout=1, uri=True)) as connection:
        if connection.execute("PRAGMA application_id").fetchone() != (APPLICATION,):
            raise InputError(f"{path}: is not the table of a sweep")
        cursor = connection.execute("SELECT * FROM rows ORDER BY line")
        names = [name for name, *_ in cursor.description]
        return pandas.DataFrame(_typed(names, row) for row in cursor)


def _typed(names: Sequence[str], values: Sequence[Any]) -> dict[str, Any]:
    """A row as a dictionary by column, with a boolean where SQLite has 0 or 1."""
    row = dict(zip(names, values, strict=True))
    return row | {"realizable": None if row["realizable"] is None else bool(row["realizable"])}


@contextmanager
def open_table(path: str, request: dict[str, Any]) -> Iterator[Table]:
    """Open the table at ``path`` for this process alone, or create it.

    Args:
        path: the SQLite file.
        request: what identifies the sweep; a table begun by another request is refused.

    Raises:
        InputError: it cannot be opened or written, is in use, or belongs to something else.
    """
    # SQLite would treat a file of one byte as empty and overwrite it.
    if os.path.isfile(path) and os.path.getsize(path) == 1:
        raise InputError(
            f"{path}: is not the table of a sweep and is not replaced; name another file"
        )
    with _plainly(path):
        connection = sqlite3.connect(os.path.abspath(path), timeout=1, isolation_level=None)
    try:
        with _plainly(path):
            connection.execute("PRAGMA locking_mode = EXCLUSIVE")
            _begin(connection, path, request)
            _forget_damage(connection, request)
            # In this mode a killed process loses no stored batch, and none waits for the disk.
            connection.execute("PRAGMA journal_mode = WAL")
            connection.execute("PRAGMA synchronous = NORMAL")
        table = Table(path, connection, request["digits"] is None)
        with _plainly(path, sqlite3.Error):
            yield table
    finally:
        connection.close()


def _begin(connection: sqlite3.Connection, path: str, request: dict[str, Any]) -> None:
    """Create the table, or check that it was begun by the same request."""
    asked = json.dumps({"format": FORMAT, **request}, sort_keys=True)
    connection.execute("BEGIN EXCLUSIVE")
    (tables,) = connection.execute("SELECT count(*) FROM sqlite_master").fetchone()
    if tables == 0:
        for statement in _schema(request["digits"] is None):
            connection.execute(statement)
        connection.execute("INSERT INTO sweep VALUES (?)", (asked,))
    elif connection.execute("PRAGMA application_id").fetchone() != (APPLICATION,):
        raise InputError(f"{path}: is a database of something else than a sweep; name another file")
    elif connection.execute("SELECT request FROM sweep").fetchone() != (asked,):
        raise InputError(
            f"{path}: holds a sweep with other rows or other digits; name "
            "another file, or delete this file"
        )
    connection.execute("COMMIT")


def _forget_damage(connection: sqlite3.Connection, request: dict[str, Any]) -> None:
    """Delete the batches whose rows do not match their checksum, so that they are computed again.

    Lines count from 1 in a grid, and from 2, below the header, in a file.
    """
    run, size, first = connection.execute, request["batch"], 2 if "csv" in request else 1
    run("BEGIN")
    for number, checksum in run("SELECT number, checksum FROM batches").fetchall():
        lines = (first + number * size, first + (number + 1) * size)
        found = run("SELECT * FROM rows WHERE line >= ? AND line < ? ORDER BY line", lines)
        if _checksum(found.fetchall()) != checksum:
            run("DELETE FROM batches WHERE number = ?", (number,))
    run(
        "DELETE FROM rows WHERE line < ? OR (line - ?) / ? NOT IN (SELECT number FROM batches)",
        (first, first, size),
    )
    run("COMMIT")


@contextmanager
def _plainly(path: str, others: type[Exception] = ValueError) -> Iterator[None]:
    """Turn errors of SQLite into an InputError of one line."""
    try:
        yield
    except InputError:
        raise
    except (sqlite3.Error, others) as error:
        if "locked" in str(error):
            raise InputError(
                f"{path}: is in use by another process; wait until it ends, or name another file"
            ) from None
        raise InputError(f"{path}: {error}") from None


def check_export(path: str, kept: Sequence[str] = ()) -> None:
    """Check, before any work, that the export can be written.

    Args:
        path: the file to write.
        kept: files that it must not replace: the table, and the file that the rows are read from.

    Raises:
        InputError: another ending than .csv or .parquet, no such folder, a file that tresym did not
            write, or no pyarrow.
    """
    if any(os.path.realpath(path) == os.path.realpath(other) for other in kept):
        raise InputError(
            f"{path}: is the table or the input of the sweep; name another file to export to"
        )
    if not path.endswith((".csv", ".parquet")):
        raise InputError(f"{path}: the name of an export must end in .csv or .parquet")
    if not os.path.isdir(os.path.dirname(path) or "."):
        raise InputError(f"{path}: there is no such folder")
    if path.endswith(".parquet"):
        _pyarrow()
    check_replaceable([path])


def _pyarrow() -> Any:
    try:
        import pyarrow
        import pyarrow.parquet
    except ImportError:
        raise InputError(
            "Parquet needs pyarrow (pip install 'tresym[parquet]'); CSV does not"
        ) from None
    return pyarrow


def _write_csv(path: str, pieces: Iterator[list[tuple[Any, ...]]], in_floats: bool) -> None:
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(columns(in_floats))
        for piece in pieces:
            writer.writerows(piece)


def _write_parquet(path: str, pieces: Iterator[list[tuple[Any, ...]]], in_floats: bool) -> None:
    """Write Parquet with typed columns: text, float64, boolean; a certified ``defect`` is text."""
    pyarrow = _pyarrow()
    names = columns(in_floats)
    types = dict.fromkeys(names, pyarrow.string())
    types |= {
        n: pyarrow.float64() for n in names if n.startswith("error_") or n.endswith("float64")
    }
    types |= {"line": pyarrow.int64(), "realizable": pyarrow.bool_()}
    schema = pyarrow.schema(list(types.items()))
    with pyarrow.parquet.ParquetWriter(path, schema) as writer:
        for piece in pieces:
            rows = [_typed(names, row) for row in piece]
            writer.write_table(pyarrow.Table.from_pylist(rows, schema=schema))
