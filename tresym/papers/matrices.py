"""Read matrices in files of claims of the ledger.

Rows are separated by semicolons, and a column is a matrix whose rows have one entry::

    about_z(x) := (cos(x), -sin(x), 0; sin(x), cos(x), 0; 0, 0, 1)
    turn := about_z(phi)*about_z(alpha)
    orthogonal: transposed(turn)*turn == (1, 0, 0; 0, 1, 0; 0, 0, 1)

Matrices are added and multiplied, also by numbers; there are ``transposed(A)`` and the derivative
``diff(A, x)``. The entries of ``turn`` are called ``turn_11``, ``turn_12``, …, those of a column
``v_1``, ``v_2``, …. In a product, terms with a factor 0 are left out where the other factors are
defined everywhere; in ``written_out(A, B)`` they stay, which matters if an equation is to be
printed.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import reduce
from typing import Any

from tresym.reals.domain.operation_domains import needs
from tresym.reals.language.binders import elementary
from tresym.reals.language.brackets import closing, encloses, places, split
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import ONE, ZERO, Expr, add, multiply, substitute
from tresym.reals.numbers.exact import InputError

_CALL = re.compile(r"([^\W\d]\w*)\s*(?=\()")
_TIMES = r"(?<!\*)\*(?!\*)"


@dataclass(frozen=True)
class Matrix:
    """A matrix by its rows."""

    rows: tuple[tuple[Expr, ...], ...]

    def __post_init__(self) -> None:
        if len({*map(len, self.rows)}) != 1:
            raise InputError("the rows of a matrix have the same length")

    @property
    def shape(self) -> tuple[int, int]:
        """The number of rows, and that of columns."""
        return len(self.rows), len(self.rows[0])

    @property
    def transposed(self) -> Matrix:
        """The matrix with rows and columns exchanged."""
        return Matrix(tuple(zip(*self.rows, strict=True)))

    def mapped(self, change: Callable[[Expr], Expr]) -> Matrix:
        """Return the matrix with each entry changed."""
        return Matrix(tuple(tuple(map(change, row)) for row in self.rows))

    def __neg__(self) -> Matrix:
        return self.mapped(lambda e: _product(-ONE, e))

    def __add__(self, other: Any) -> Matrix:
        if not isinstance(other, Matrix) or other.shape != self.shape:
            raise InputError(f"a matrix of {self.shape} is added to another one of that size")
        pairs = zip(self.rows, other.rows, strict=True)
        return Matrix(
            tuple(tuple(p + q for p, q in zip(one, two, strict=True)) for one, two in pairs)
        )

    def times(self, other: Matrix, product: Callable[[Expr, Expr], Expr]) -> Matrix:
        """Return the product; ``product`` multiplies two entries.

        Raises:
            InputError: the sizes do not fit.
        """
        if self.shape[1] != other.shape[0]:
            raise InputError(f"matrices of {self.shape} and {other.shape} have no product")
        columns = other.transposed.rows
        return Matrix(
            tuple(tuple(add(*map(product, row, column)) for column in columns) for row in self.rows)
        )


@dataclass(frozen=True)
class MatrixFunction:
    """A matrix whose entries depend on parameters."""

    parameters: tuple[str, ...]
    body: Matrix

    def at(self, values: tuple[Expr, ...]) -> Matrix:
        """Return the matrix for values of the parameters.

        Raises:
            InputError: the number of values is not that of the parameters.
        """
        if len(values) != len(self.parameters):
            raise InputError(f"{len(self.parameters)} arguments are asked for")
        put: Mapping[str, Expr] = dict(zip(self.parameters, values, strict=True))
        return self.body.mapped(lambda e: substitute(e, put))


@dataclass
class Matrices:
    """The matrices of a file, and how to read an expression with them.

    Attributes:
        scalar: reads an expression whose value is a number.
        known: the matrices with a name.
    """

    scalar: Callable[[str], Expr]
    known: dict[str, Any] = field(default_factory=dict)

    def stand_in(self, text: str) -> bool:
        """Return whether a text speaks of a matrix."""
        words = {*re.findall(r"[^\W\d]\w*", text)}
        return bool(words & {*self.known}) or ";" in text

    def read(self, text: str) -> Matrix:
        """Return the matrix that an expression stands for.

        Raises:
            InputError: it is no matrix, or the matrices do not fit.
        """
        found = self._sum(text)
        if not isinstance(found, Matrix):
            raise InputError(f"'{text}' is not a matrix")
        return found

    def _sum(self, text: str) -> Any:
        try:
            return reduce(lambda one, other: one + other, map(self._product, _summands(text)))
        except TypeError:
            raise InputError(f"'{text}': a matrix and a number are not added") from None

    def _product(self, text: str) -> Any:
        first, *others = split(text, _TIMES)
        minus = first.startswith("-")
        value = self._factor(first[1:] if minus else first)
        return reduce(_times, map(self._factor, others), -value if minus else value)

    def _factor(self, text: str) -> Any:
        text = text.strip()
        if not self.stand_in(text):
            return self.scalar(text)
        if encloses(text):
            rows = split(text[1:-1], ";")
            return self._literal(rows) if rows[1:] else self._sum(text[1:-1])
        if text in self.known:
            found = self.known[text]
            if isinstance(found, Matrix):
                return found
            raise InputError(f"{text} is a function: write its arguments")
        match = _CALL.match(text)
        if match is None or closing(text[match.end() :]) != len(text) - match.end() - 1:
            raise InputError(f"'{text}' is not read as a matrix")
        return self._call(match[1], split(text[match.end() + 1 : -1], ","))

    def _literal(self, rows: list[str]) -> Matrix:
        return Matrix(tuple(tuple(map(self.scalar, split(row, ","))) for row in rows))

    def _call(self, name: str, arguments: list[str]) -> Matrix:
        function = self.known.get(name)
        if isinstance(function, MatrixFunction):
            return function.at(tuple(map(self.scalar, arguments)))
        if name == "transposed" and len(arguments) == 1:
            return self.read(arguments[0]).transposed
        if name == "diff" and len(arguments) == 2:
            variable = str(self.scalar(arguments[1]))
            return self.read(arguments[0]).mapped(lambda e: differentiate(e, variable))
        if name == "written_out":
            return reduce(lambda one, other: one.times(other, multiply), map(self.read, arguments))
        raise InputError(f"'{name}' of a matrix is not read")


def entries(name: str, matrix: Matrix) -> Iterator[tuple[str, Expr]]:
    """Yield the entries of a matrix, each with the name under which it may be used."""
    columns = matrix.shape[1]
    for i, row in enumerate(matrix.rows, 1):
        for j, e in enumerate(row, 1):
            yield f"{name}_{f'{i}{j}' if columns > 1 else i}", e


def _times(one: Any, other: Any) -> Any:
    """The product of matrices and numbers."""
    if isinstance(one, Matrix) and isinstance(other, Matrix):
        return one.times(other, _product)
    if isinstance(one, Matrix):
        return one.mapped(lambda e: _product(e, other))
    if isinstance(other, Matrix):
        return other.mapped(lambda e: _product(one, e))
    return one * other


def _product(one: Expr, other: Expr) -> Expr:
    """The product of two entries; 0 where one is, and the other has a value everywhere."""
    if ZERO in (one, other) and elementary(one, other) and not [*needs((one, other))]:
        return ZERO
    return one * other


def _summands(text: str) -> list[str]:
    """The terms of a sum, each with its sign if that is a minus."""
    text, found, start = text.strip(), [], 0
    for at, end in places(text, r"[+-]"):
        before = text[start:at].strip()
        if before and before[-1] not in "*/^":
            found.append(before)
            start = at if text[at] == "-" else end
    return [*found, text[start:].strip()]
