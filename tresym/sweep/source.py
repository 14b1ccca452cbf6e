"""The input of a sweep: a grid of a, b, γ, or a CSV file of bodies.

A source is divided into parts that are small to send and can produce their rows. A row that cannot
be read is kept, with the reason.
"""

from __future__ import annotations

import csv
import hashlib
import re
from collections.abc import Container, Iterator
from pathlib import Path
from typing import Any, NamedTuple, Protocol

from flint import arb, fmpq

from tresym.racket import body
from tresym.racket.body import Shape
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError, fraction_text, parse_number

MOST_ROWS = 10**12
MOST_VALUES = 10**6
"""Most values of one axis; they take about 100 megabytes."""
LONGEST_LINE = 40_000
"""Most bytes of a CSV line; three numbers of the greatest length fit."""

LOG_DIGITS = 15
"""Significant digits of logarithmically spaced points, which are exact decimals of this length."""

_RANGE = re.compile(r"([^:]*):([^:]*):(\d{1,8})(log)?", re.ASCII)
_SHAPES = (("a", "b"), ("I1", "I2", "I3"), ("body",))


class Entry(NamedTuple):
    """A row to compute: its line, a name, and shape and γ, or the problem with them.

    ``written`` is a, b and γ as the table shows them, if the source knows.
    """

    line: int
    name: str | None
    shape: Shape | None
    gamma: fmpq | None
    problem: str | None = None
    written: tuple[str, str, str] | None = None


class Part(Protocol):
    """A part of a source that can be sent to another process."""

    def entries(self) -> Iterator[Entry]:
        """Yield the rows of the part, in order."""
        ...


class Source(Protocol):
    """Rows, numbered from 0, that can be divided into parts."""

    @property
    def total(self) -> int:
        """The number of rows, including blank lines of a file."""
        ...

    def fingerprint(self) -> dict[str, Any]:
        """Return what identifies this source, as JSON data."""
        ...

    def parts(self, size: int, done: Container[int]) -> Iterator[tuple[int, Part]]:
        """Yield batches of ``size`` rows with their numbers, except those in ``done``."""
        ...


class Grid(NamedTuple):
    """Every combination of the values of a, b and γ; γ varies fastest, and lines count from 1."""

    a: tuple[fmpq, ...]
    b: tuple[fmpq, ...]
    gamma: tuple[fmpq, ...]

    @classmethod
    def read(cls, a: str, b: str, gamma: str = "0") -> Grid:
        """Read a grid from text: values ``0.1,1/3``, ``LOW:HIGH:COUNT`` or ``LOW:HIGH:COUNTlog``.

        Raises:
            InputError: other text, or more than 10^12 rows.

        Example:
            >>> Grid.read("0:1:3", "1/2").total
            3
        """
        grid = cls(read_values(a, "a"), read_values(b, "b"), read_values(gamma, "gamma"))
        if grid.total > MOST_ROWS:
            raise InputError(f"grid: {grid.total} rows are beyond the limit of {MOST_ROWS}")
        return grid

    @property
    def total(self) -> int:
        """The number of rows."""
        return len(self.a) * len(self.b) * len(self.gamma)

    def fingerprint(self) -> dict[str, Any]:
        """Return a digest of the exact values."""
        text = ";".join(",".join(map(fraction_text, axis)) for axis in self)
        return {"grid": hashlib.sha256(text.encode()).hexdigest(), "rows": self.total}

    def parts(self, size: int, done: Container[int]) -> Iterator[tuple[int, Part]]:
        """Yield batches of ``size`` rows, except those in ``done``."""
        for number in range(-(-self.total // size)):
            if number not in done:
                yield number, self._part(number * size, min(size, self.total - number * size))

    def _part(self, start: int, count: int) -> Part:
        """A part that holds only the values that its rows use."""
        first, last = start // len(self.gamma), (start + count - 1) // len(self.gamma)
        places = [divmod(i, len(self.b)) for i in range(first, last + 1)]
        a = {i: fraction_text(self.a[i]) for i in {i for i, _ in places}}
        b = {j: fraction_text(self.b[j]) for j in {j for _, j in places}}
        pairs = tuple((a[i], b[j]) for i, j in places)
        offset = start % len(self.gamma)
        if last == first:
            gammas = self.gamma[offset : offset + count]
            return GridPart(start + 1, count, pairs, tuple(map(fraction_text, gammas)), 0)
        return GridPart(start + 1, count, pairs, tuple(map(fraction_text, self.gamma)), offset)


class GridPart(NamedTuple):
    """``size`` rows of a grid; the first is on ``line`` and has γ number ``offset``."""

    line: int
    size: int
    shapes: tuple[tuple[str, str], ...]
    gammas: tuple[str, ...]
    offset: int

    def entries(self) -> Iterator[Entry]:
        """Yield the rows, in order."""
        texts = {text for pair in self.shapes for text in pair}
        numbers = {text: parse_number(text) for text in texts}
        levels = [parse_number(gamma) for gamma in self.gammas]
        shapes = [_shape(numbers[a], numbers[b]) for a, b in self.shapes]
        for i in range(self.size):
            j, k = divmod(self.offset + i, len(levels))
            shape, problem = shapes[j]
            written = (*self.shapes[j], self.gammas[k])
            yield Entry(self.line + i, None, shape, levels[k], problem, written)


def _shape(a: fmpq, b: fmpq) -> tuple[Shape, str | None]:
    """The shape and the problem with it, if there is one."""
    try:
        return body.shape(a, b), None
    except InputError as error:
        return Shape(a, b), str(error)


def read_values(text: str, what: str) -> tuple[fmpq, ...]:
    """Read exact values: ``0.1,1/3,2``, or ``0:1:11`` (ends included), or ``1e-3:10:50log``.

    Logarithmically spaced values are rounded to 15 digits, except the ends.

    Args:
        text: the values.
        what: their name, for the error message.

    Raises:
        InputError: other text, or more than 10^6 values.

    Example:
        >>> [str(x) for x in read_values("0:1:3", "a")]
        ['0', '1/2', '1']
    """
    match = _RANGE.fullmatch(text.strip())
    if match is None:
        words = text.split(",")
        if len(words) > MOST_VALUES:
            raise InputError(f"{what}: more than {MOST_VALUES} values")
        return tuple(parse_number(word, what) for word in words)
    low, high = parse_number(match[1], what), parse_number(match[2], what)
    count = int(match[3])
    if not 2 <= count <= MOST_VALUES:
        raise InputError(f"{what}: the number of values must be between 2 and {MOST_VALUES}")
    if match[4] is None:
        return tuple(low + (high - low) * fmpq(i, count - 1) for i in range(count))
    if low <= 0 or high <= 0:
        raise InputError(f"{what}: logarithmic spacing needs both ends above 0")
    return _equal_ratios(low, high, count)


def _equal_ratios(low: fmpq, high: fmpq, count: int) -> tuple[fmpq, ...]:
    with ball_precision(192):
        start, length = arb(low).log(), (arb(high) / low).log()
        points = [(start + length * i / (count - 1)).exp() for i in range(1, count - 1)]
        inner = [parse_number(x.str(LOG_DIGITS, radius=False)) for x in points]
    return (low, *inner, high)


class CsvFile:
    """Bodies in a CSV file, one on each line below a header; lines count as in an editor.

    Columns: ``a, b``, or ``I1, I2, I3`` (moments), or ``body`` (a name); optionally ``gamma`` (0 if
    there is none) and ``name``; others are ignored. The file is UTF-8, without line breaks in
    values.
    """

    def __init__(self, path: str) -> None:
        """Read the header, the length and the digest of the file.

        Raises:
            InputError: there is no such file, or the header does not name the columns.
        """
        self.path = path
        if not Path(path).is_file():
            raise InputError(f"{path}: there is no such file, or it is not a regular file")
        digest, count, header = hashlib.sha256(), 0, ""
        try:
            for line in _lines(path):
                digest.update(line)
                if count == 0:
                    header = _decoded(line)
                count += 1
        except OSError as error:
            raise InputError(f"{path}: cannot be read ({error.strerror})") from None
        self.columns = _columns(header, path)
        self.total = max(0, count - 1)
        self._digest = digest.hexdigest()

    def fingerprint(self) -> dict[str, Any]:
        """A digest of the file's lines."""
        return {"csv": self._digest, "rows": self.total}

    def parts(self, size: int, done: Container[int]) -> Iterator[tuple[int, Part]]:
        """Batches of ``size`` lines, but for those in ``done``."""
        number, first, batch = 0, 2, []
        for line, raw in enumerate(_lines(self.path), start=1):
            if line == 1:
                continue
            if number not in done:
                batch.append(_decoded(raw))
            if line == first + size - 1 or line == self.total + 1:
                if number not in done:
                    yield number, CsvPart(first, self.columns, tuple(batch))
                number, first, batch = number + 1, line + 1, []


class CsvPart(NamedTuple):
    """Some lines of a CSV file; ``line`` is the number of the first."""

    line: int
    columns: tuple[str, ...]
    lines: tuple[str, ...]

    def entries(self) -> Iterator[Entry]:
        """Yield the rows, in order; blank lines are skipped."""
        for line, text in enumerate(self.lines, start=self.line):
            if text.strip():
                yield self._entry(line, text)

    def _entry(self, line: int, text: str) -> Entry:
        name = None
        try:
            values = self._values(text)
            name = values.get("name", values.get("body")) or None
            shape = _shape_of(values)
            return Entry(line, name, shape, parse_number(values.get("gamma") or "0", "gamma"))
        except InputError as error:
            return Entry(line, name, None, None, str(error))

    def _values(self, text: str) -> dict[str, str]:
        if len(text) > LONGEST_LINE:
            raise InputError(f"line: longer than the limit of {LONGEST_LINE} bytes")
        try:
            (values,) = csv.reader([text], strict=True)
        except csv.Error as error:
            raise InputError(f"line: {error}") from None
        if len(values) != len(self.columns):
            raise InputError(f"line: {len(values)} values for {len(self.columns)} columns")
        return {key: value.strip(" \t") for key, value in zip(self.columns, values, strict=True)}


def _shape_of(values: dict[str, str]) -> Shape:
    if "a" in values:
        return body.shape(values["a"], values["b"])
    if "I1" in values:
        return body.shape_of_moments(values["I1"], values["I2"], values["I3"])
    return body.named_body(values["body"]).shape


def _columns(header: str, path: str) -> tuple[str, ...]:
    try:
        (names,) = csv.reader([header], strict=True)
    except (csv.Error, ValueError):
        names = []
    columns = tuple(name.strip() for name in names)
    given = [shape for shape in _SHAPES if set(shape) <= set(columns)]
    if len(given) != 1 or len(set(columns)) < len(columns):
        raise InputError(
            f"{path}: the first line must name the columns: a, b or I1, I2, I3 or body, each once; "
            "the columns gamma and name are optional"
        )
    return columns


def _lines(path: str) -> Iterator[bytes]:
    """The lines of a file; a line that is too long is cut off just above the limit."""
    with open(path, "rb") as file:
        while line := file.readline(LONGEST_LINE + 2):
            rest = line
            while rest and not rest.endswith(b"\n"):
                rest = file.readline(LONGEST_LINE + 2)
            yield line


def _decoded(line: bytes) -> str:
    return line.removeprefix(b"\xef\xbb\xbf").decode(errors="backslashreplace").rstrip("\r\n")
