"""Run a sweep: submit batches to an executor, and store their rows.

Any ``concurrent.futures`` executor can be used. The number of batches in progress is bounded, and
so is the memory, however long the sweep.
"""

from __future__ import annotations

import pickle
import sys
import time
from collections import deque
from collections.abc import Callable, Iterator
from concurrent.futures import BrokenExecutor
from contextlib import AbstractContextManager
from typing import Any, NamedTuple

from tresym.racket.flip.model_selection import checked_digits
from tresym.reals.numbers.exact import InputError
from tresym.reals.processes import cores
from tresym.sweep.rows import compute
from tresym.sweep.source import Part, Source
from tresym.sweep.table import Table, check_export, open_table, packed, to_frame
from tresym.sweep.workers import Workers, processes

FLOAT_BATCH = 20_000
LARGEST_BATCH = 4000
MOST_DIGITS = 200_000
"""Rows times digits of a batch. With each of these three limits a batch takes about a second."""

FEWEST_BATCHES = 16
"""The least number of batches, so that a small sweep is shared among workers too."""

SHOWN_PROBLEMS = 10
"""Problems that a summary lists."""


class Summary(NamedTuple):
    """The result of a sweep: rows in the table, rows with problems, and rows computed in this run.

    ``problems`` holds the first few, each as line and reason.
    """

    path: str
    rows: int
    bad: int
    computed: int
    problems: list[tuple[int, str]]
    seconds: float

    def as_json(self) -> dict[str, Any]:
        """Return the summary as a JSON object."""
        problems = [{"line": line, "reason": reason} for line, reason in self.problems]
        return {**self._asdict(), "problems": problems}

    def to_frame(self) -> Any:
        """Return all rows of the table as a DataFrame; see :func:`tresym.sweep.table.to_frame`."""
        return to_frame(self.path)


def sweep(
    source: Source,
    path: str,
    digits: int | None = 50,
    workers: Callable[[], AbstractContextManager[Workers]] | None = None,
    *,
    export: str | None = None,
    notice: Callable[[str], None] = lambda _: None,
) -> Summary:
    """Compute every row of ``source`` that is not yet in the table at ``path``.

    Args:
        source: a :class:`~tresym.sweep.source.Grid` or a :class:`~tresym.sweep.source.CsvFile`.
        path: the SQLite file; if the same sweep was begun in it, the sweep is continued.
        digits: certified digits, 1 to 10 000; None for float64.
        workers: opens the executor; by default :func:`~tresym.sweep.workers.processes` on every
            core.
        export: a .csv or .parquet file to which the rows are also written at the end.
        notice: called from time to time with the progress, in one line.

    Raises:
        InputError: wrong digits, a table or an export that cannot be written, or workers that keep
            dying.
    """
    if digits is not None:
        checked_digits(digits)
    if export is not None:
        read = getattr(source, "path", None)
        check_export(export, (path, read) if read else (path,))
    began = time.perf_counter()
    size = batch_size(source.total, digits)
    asked = {"digits": digits, "batch": size, **source.fingerprint()}
    with open_table(path, asked) as table:
        left = -(-source.total // size) - len(table.done())
        opened = workers or (lambda: processes(min(cores(), max(left, 1))))
        progress = Progress(source.total, min(len(table.done()) * size, source.total), notice)
        progress.announce(size, left)
        if left:
            _run(opened, source.parts(size, table.done()), digits, table, progress)
        if export is not None:
            table.export(export)
        rows, bad = table.counts()
        seconds = time.perf_counter() - began
        problems = table.problems(SHOWN_PROBLEMS)
        return Summary(path, rows, bad, progress.computed, problems, seconds)


def batch_size(total: int, digits: int | None) -> int:
    """Return the number of rows in a batch, so that a batch takes about a second."""
    most = FLOAT_BATCH if digits is None else max(1, min(LARGEST_BATCH, MOST_DIGITS // digits))
    return max(1, min(most, total // FEWEST_BATCHES))


def _run(
    opened: Callable[[], AbstractContextManager[Workers]],
    parts: Iterator[tuple[int, Part]],
    digits: int | None,
    table: Table,
    progress: Progress,
) -> None:
    """Compute the parts and add their rows to the table."""
    asked = ((number, pickle.dumps((part, digits))) for number, part in parts)
    with opened() as workers:
        try:
            for number, found in workers.as_landed(computed, asked):
                progress.landed(table.add(number, found))
        except BrokenExecutor as error:
            raise InputError(f"sweep: {error or 'the workers have died'}") from None


def computed(asked: bytes) -> bytes:
    """Compute one batch in a worker, from bytes to bytes.

    Args:
        asked: the pickle of a part and the digits.

    Returns:
        A batch as :func:`~tresym.sweep.table.packed` makes it. No scheduler has to unpack either.
    """
    part, digits = pickle.loads(asked)
    return packed(compute(part, digits), digits is None)


class Progress:
    """The progress of a sweep, with the remaining time by the mean and by the latest rate."""

    EVERY = 2.0
    """Seconds between two reports."""

    def __init__(self, total: int, already: int, notice: Callable[[str], None]) -> None:
        """Start the clock.

        Args:
            total: rows of the sweep.
            already: rows that were computed in earlier runs.
            notice: called with each report.
        """
        self.total, self.already, self.notice = total, already, notice
        self.computed = 0
        self.start = self.reported = time.monotonic()
        self.latest = deque([(self.start, 0)], maxlen=10)

    def announce(self, size: int, batches: int) -> None:
        """Report how many rows are to be computed."""
        found = f"{self.already} of them computed before; " if self.already else ""
        self.notice(f"{self.total} rows; {found}{batches} batches of {size} to go")

    def landed(self, rows: int) -> None:
        """Count rows that have been stored, and report if it is time."""
        self.computed += rows
        now = time.monotonic()
        if now - self.reported >= self.EVERY:
            self.reported = now
            self.notice(self.line(now))
            self.latest.append((now, self.computed))

    def line(self, now: float) -> str:
        """Return rows so far, rate, and the remaining time as a range."""
        done = min(self.already + self.computed, self.total)
        then, before = self.latest[0]
        rates = sorted(
            (self.computed / (now - self.start), (self.computed - before) / (now - then))
        )
        slow, fast = ((self.total - done) / max(rate, 1e-9) for rate in rates)
        left = (
            duration(fast)
            if duration(fast) == duration(slow)
            else (f"{duration(fast)} to {duration(slow)}")
        )
        return f"{done} of {self.total} rows, {rates[1]:.3g} a second, about {left} left"


def duration(seconds: float) -> str:
    """Return a duration as text, such as ``12 min``."""
    for unit, size in (("d", 86_400), ("h", 3600), ("min", 60)):
        if seconds >= 2 * size:
            return f"{seconds / size:.0f} {unit}"
    return f"{seconds:.0f} s"


def summary_text(found: Summary) -> str:
    """Return the summary as lines for people."""
    lines = [f"{found.path}: {found.rows} rows, {found.computed} of them computed now"]
    lines += [f"  line {line}: {reason}" for line, reason in found.problems]
    if found.bad > len(found.problems):
        lines.append(f"  and {found.bad - len(found.problems)} more rows with a problem")
    return "\n".join(lines) + "\n"


def to_stderr(text: str) -> None:
    """Print a line on standard error, if there is one."""
    if sys.stderr is not None:
        print(f"tresym: {text}", file=sys.stderr, flush=True)
