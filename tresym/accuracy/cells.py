"""Compute the cells of an error table elsewhere, and keep the finished ones.

A worker gets bytes and returns bytes. Balls travel as midpoint and radius in binary, without
rounding. The finished cells of a long table are kept in the cache folder of answers, under the
version of the code, so that a run that was interrupted goes on where it stopped. Rows are JSON with
a checksum; what does not fit is computed again.
"""

from __future__ import annotations

import hashlib
import json
import pickle
import sqlite3
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from typing import Any

from flint import arb, fmpz

from tresym.accuracy.error_table import Cell, Question, cell
from tresym.checking.cache_folder import cache_folder, version
from tresym.reals.language.expression import Expr
from tresym.reals.numbers.exact import InputError

MOST_ROWS = 100_000
"""More finished cells than these are not kept."""


def encoded(question: Question, x: Expr, digits: int) -> bytes:
    """Return what a worker is asked: one cell."""
    return pickle.dumps((question, x, digits))


def computed(asked: bytes) -> bytes:
    """Compute a cell; the function that workers call."""
    question, x, digits = pickle.loads(asked)
    found = cell(question, x, digits)
    if isinstance(found, InputError):
        return pickle.dumps(str(found))
    return pickle.dumps(tuple(map(_parts, found)))


def decoded(found: bytes) -> Cell | InputError:
    """Return the cell that a worker computed."""
    parts = pickle.loads(found)
    return InputError(parts) if isinstance(parts, str) else Cell(*map(_ball, parts))


def _parts(x: arb | None) -> tuple[int, ...] | None:
    """Return a ball as two pairs of mantissa and exponent."""
    if x is None:
        return None
    numbers = (*x.mid().man_exp(), *x.rad().man_exp())
    return tuple(map(int, numbers))


def _ball(parts: tuple[int, ...] | None) -> Any:
    if parts is None:
        return None
    middle, power, radius, other = parts
    return arb((fmpz(middle), fmpz(power)), (fmpz(radius), fmpz(other)))


class CellStore:
    """The finished cells of tables, by question and point."""

    def __init__(self, file: sqlite3.Connection) -> None:
        """Use an open database."""
        self.file = file
        self.file.execute("CREATE TABLE IF NOT EXISTS cells (key BLOB PRIMARY KEY, value TEXT)")

    def get(self, asked: bytes) -> Cell | None:
        """Return the cell that answers a question of :func:`encoded`, if it is kept."""
        with suppress(sqlite3.Error, ValueError, TypeError, KeyError):
            key = _key(asked)
            row = self.file.execute("SELECT value FROM cells WHERE key = ?", (key,)).fetchone()
            if row is not None:
                found = json.loads(row[0])
                if found["sum"] == _sum(key, found["parts"]):
                    return Cell(*map(_ball, found["parts"]))
        return None

    def put(self, asked: bytes, found: Cell) -> None:
        """Keep a finished cell; on a full disk nothing is kept."""
        with suppress(sqlite3.Error):
            key, parts = _key(asked), [_parts(x) for x in found]
            value = json.dumps({"parts": parts, "sum": _sum(key, parts)})
            self.file.execute("INSERT OR REPLACE INTO cells VALUES (?, ?)", (key, value))
            self.file.commit()

    def trim(self) -> None:
        """Forget all cells if there are too many."""
        with suppress(sqlite3.Error):
            (count,) = self.file.execute("SELECT COUNT(*) FROM cells").fetchone()
            if count > MOST_ROWS:
                self.file.execute("DELETE FROM cells")
                self.file.commit()


def _key(asked: bytes) -> bytes:
    question, x, digits = pickle.loads(asked)
    text = f"{question.exact}|{question.approx}|{question.path}|{x}|{digits}"
    return hashlib.sha256(version() + text.encode()).digest()


def _sum(key: bytes, parts: Any) -> str:
    return hashlib.sha256(key + json.dumps(parts).encode()).hexdigest()


@contextmanager
def kept_cells() -> Iterator[CellStore | None]:
    """Open the store in the cache folder; None if there is no such folder or it cannot be used."""
    folder = cache_folder()
    store = None
    if folder is not None:
        with suppress(OSError, sqlite3.Error):
            folder.mkdir(parents=True, exist_ok=True)
            store = CellStore(sqlite3.connect(folder / "cells.sqlite", timeout=5))
    try:
        yield store
    finally:
        if store is not None:
            store.trim()
            store.file.close()
