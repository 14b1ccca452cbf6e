"""Check a table that somebody printed against the formula that its column shows.

Each cell is compared with a ball of the formula at the printed parameters. Tables follow one of
four conventions, and the one that most cells of the column follow is taken:

- *nearest*: the cell is the value rounded, to half a unit in the last place;
- *truncated*: digits are cut off;
- *upper* and *lower*: the cell is a bound, rounded up or down.

A cell that does not follow it is flagged with the true value. The printed parameters are exact: a
table of erf with 0.5234999 beside 0.5 is wrong, though erf takes that value at a number that rounds
to 0.5. In a table of measured numbers the parameters are rounded themselves; if the caller says so,
a cell is accepted that is right for some parameters that round to the printed ones.
"""

from __future__ import annotations

import csv
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

from flint import arb, fmpq

from tresym.accuracy.table import Table
from tresym.accuracy.values import certified, constant, read, rounded
from tresym.reals.decisions.closed_values import certified_evaluation
from tresym.reals.domain.evaluation import UndefinedError
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.expression import Expr, substitute, symbols
from tresym.reals.notebook import in_one_line
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import Decimal, InputError, Interval, decimal_ball, printed, quoted

MOST_ROWS = 100_000
MOST_BYTES = 50_000_000
GUARD = 12
"""Digits of the true value beyond those printed."""
SHOWN = 4
"""Digits of the true value that are shown beyond those printed."""
CONVENTIONS: dict[str, Callable[[arb, fmpq, fmpq], bool | None]] = {
    "nearest": lambda x, p, unit: _within(x, p - unit / 2, p + unit / 2),
    "truncated": lambda x, p, unit: (
        _within(x, p, p + unit) if p > 0 else _within(x, p - unit, p if p < 0 else unit)
    ),
    "upper": lambda x, p, unit: _within(x, p - unit, p),
    "lower": lambda x, p, unit: _within(x, p, p + unit),
}
"""For each convention, whether a value and a printed number with its last unit agree."""


def _within(x: arb, low: fmpq, high: fmpq) -> bool | None:
    """Return whether a ball lies between two numbers; None if it cannot be told."""
    if x >= low and x <= high:
        return True
    return False if x < low or x > high else None


class Cell(NamedTuple):
    """One cell.

    Attributes:
        at: the parameters as printed.
        printed: the cell as printed.
        true: a ball around the value at exactly these parameters; None if there is none.
        shown: the true value, with a few digits more than the cell.
        fits: whether the cell follows the convention of the column.
        why: what is wrong, or what makes it right; empty if it simply fits.
    """

    at: dict[str, str]
    printed: str
    true: Decimal | None
    shown: str
    fits: bool
    why: str


@dataclass(frozen=True)
class PrintedTable:
    """A printed column with the verdict on each cell.

    Attributes:
        formula: what the column should show.
        column: the name of the column.
        convention: nearest, truncated, upper or lower.
        cells: one for each row.
    """

    formula: str
    column: str
    convention: str
    cells: tuple[Cell, ...]

    @property
    def wrong(self) -> tuple[Cell, ...]:
        """The cells that do not fit."""
        return tuple(cell for cell in self.cells if not cell.fits)

    def __bool__(self) -> bool:
        return not self.wrong

    def __repr__(self) -> str:
        return in_one_line(
            f"PrintedTable({self.formula}: {len(self.cells) - len(self.wrong)} of "
            f"{len(self.cells)} cells fit, {self.convention})"
        )

    def table(self) -> Table:
        """Return the cells as a table of text."""
        names = list(self.cells[0].at)
        rows = tuple(
            (*cell.at.values(), cell.printed, cell.shown, "" if cell.fits else "WRONG", cell.why)
            for cell in self.cells
        )
        caption = (
            f"{self.column} against {self.formula}: {len(self.cells) - len(self.wrong)} of "
            f"{len(self.cells)} cells follow the convention of the column, {self.convention}."
        )
        return Table(
            caption, (*names, "printed", "true", "verdict", "note"), rows, "printed", len(names)
        )

    def as_json(self) -> dict[str, Any]:
        """Return the table for JSON."""
        return {
            "formula": self.formula,
            "column": self.column,
            "convention": self.convention,
            "rows": [
                cell._asdict() | {"true": None if cell.true is None else cell.true._asdict()}
                for cell in self.cells
            ],
        }


def against(
    path: str, formula: str, column: str | None = None, rounded_parameters: bool = False
) -> PrintedTable:
    """Compare a column of a CSV file with a formula.

    Args:
        path: the file; its first line names the columns, and the variables of the formula are
            columns.
        formula: the expression.
        column: the column that is compared; if not given, the only one that is no variable.
        rounded_parameters: whether printed parameters with a decimal point are rounded numbers.

    Raises:
        InputError: the file cannot be read, a column is missing, or a cell is no number.
    """
    e = read(formula)
    names = sorted(symbols(e) - {INFINITY.args[0]})
    rows = list(_rows(path))
    if len(rows) < 2:
        raise InputError(f"{path}: it has no rows below the names of its columns")
    heads, *body = rows
    missing = [name for name in names if name not in heads]
    if missing:
        raise InputError(
            f"{path}: no column is called {missing[0]}; its columns are {', '.join(heads)}"
        )
    others = [head for head in heads if head not in names]
    if column is None and len(others) != 1:
        raise InputError(f"{path}: say which column is meant, --column {' or '.join(others)}")
    chosen = others[0] if column is None else column
    if chosen not in heads:
        raise InputError(f"{path}: no column is called {quoted(chosen)}")
    found = []
    for line, row in enumerate(body, 2):
        if len(row) != len(heads):
            raise InputError(f"{path}, line {line}: {len(row)} cells, {len(heads)} columns")
        here = dict(zip(heads, row, strict=True))
        try:
            found.append(_value(e, {name: here[name] for name in names}, here[chosen]))
        except InputError as error:
            raise InputError(f"{path}, line {line}: {error}") from None
    fits = {
        kind: sum(one.agrees(rule) is True for one in found) for kind, rule in CONVENTIONS.items()
    }
    best = max(CONVENTIONS, key=lambda kind: fits[kind])
    return PrintedTable(
        str(e), chosen, best, tuple(one.cell(best, rounded_parameters) for one in found)
    )


def _rows(path: str) -> Iterator[list[str]]:
    try:
        with open(path, encoding="utf-8-sig", newline="") as file:
            text = file.read(MOST_BYTES + 1)
    except (OSError, UnicodeDecodeError) as error:
        why = getattr(error, "strerror", None) or "it is not UTF-8 text"
        raise InputError(f"{path}: cannot be read ({why})") from None
    if len(text) > MOST_BYTES:
        raise InputError(f"{path}: is too long")
    count = 0
    for row in csv.reader(text.splitlines()):
        if any(cell.strip() for cell in row):
            count += 1
            if count > MOST_ROWS:
                raise InputError(f"{path}: more than {MOST_ROWS} rows")
            yield [cell.strip() for cell in row]


class _Found(NamedTuple):
    """The value of a cell before the convention of the column is known."""

    e: Expr
    at: dict[str, str]
    text: str
    where: Interval
    true: arb | None
    why: str

    def agrees(self, rule: Callable[[arb, fmpq, fmpq], bool | None]) -> bool | None:
        """Return whether the cell follows a convention."""
        if self.true is None:
            return None
        with ball_precision(400):
            return rule(self.true, self.where.middle, self.where.width)

    def cell(self, kind: str, rounded_parameters: bool) -> Cell:
        """Return the cell with its verdict."""
        if self.true is None:
            return Cell(self.at, self.text, None, "", False, self.why)
        digits = _digits(self.text) + SHOWN
        with ball_precision(400):
            ball = decimal_ball(self.true, digits)
        shown = rounded(self.true, digits)
        rule = CONVENTIONS[kind]
        fits = self.agrees(rule)
        why, only_rounded = "", False
        if fits is not True:
            wide = self._over_rounded_parameters()
            if wide is not None and wide.is_finite():
                with ball_precision(400):
                    near = rule(wide, self.where.middle, self.where.width) is not False
                if near and rounded_parameters:
                    fits, why = True, "right within the rounding of the parameters"
                only_rounded = near and any("." in x for x in self.at.values())
        if fits is not True:
            why = f"the value is {shown}"
            if only_rounded:
                why += "; the cell is right if the parameters are rounded numbers"
        return Cell(self.at, self.text, ball, shown, fits is True, why)

    def _over_rounded_parameters(self) -> arb | None:
        """Return a ball over all parameters that round to the printed ones."""
        with ball_precision(128):
            point = {}
            for name, text in self.at.items():
                try:
                    point[name] = (
                        printed(text).ball() if "." in text else arb(constant(text, name).args[0])
                    )
                except (InputError, TypeError):
                    return None
            try:
                return certified_evaluation(point).value(self.e)
            except UndefinedError:
                return None


def _value(e: Expr, at: Mapping[str, str], text: str) -> _Found:
    where = printed(text.replace("−", "-"))
    point = {name: constant(x.replace("−", "-"), name) for name, x in at.items()}
    try:
        true = certified(substitute(e, point), _digits(text) + GUARD)
        return _Found(e, dict(at), text, where, true, "")
    except InputError as error:
        return _Found(e, dict(at), text, where, None, str(error))


def _digits(text: str) -> int:
    """Return the number of significant digits of a printed number, at least 1."""
    digits = text.lower().partition("e")[0].replace(".", "").lstrip("+-−0")
    return max(1, len(digits))
