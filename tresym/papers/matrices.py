"""Read matrices in files of claims of the ledger.

Rows are separated by semicolons, and a column is a matrix whose rows have one entry::

    about_z(x) := (cos(x), -sin(x), 0; sin(x), cos(x), 0; 0, 0, 1)
    turn := about_z(phi)*about_z(alpha)
    orthogonal: transposed(turn)*turn == (1, 0, 0; 0, 1, 0; 0, 0, 1)

Matrices are added and multiplied, also by numbers; there are ``transposed(A)`` and the derivative
``diff(A, x)``. The entries of ``turn`` are called ``turn_11``, ``turn_12``, …, those of a column
``v_1``, ``v_2``, …. A product is worked out as far as SymPy does so by itself; in ``written_out(A,
B)`` its entries are sums of products as they stand, which matters if an equation is to be printed.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import reduce
from typing import Any

from sympy import Add, Basic, Function, ImmutableMatrix, Mul, Symbol, diff
from sympy import Expr as Expression

from tresym.reals.language.brackets import closing, encloses, places, split
from tresym.reals.numbers.exact import InputError

_CALL = re.compile(r"([^\W\d]\w*)\s*(?=\()")
_TIMES = r"(?<!\*)\*(?!\*)"


@dataclass(frozen=True)
class MatrixFunction:
    """A matrix whose entries depend on parameters."""

    parameters: tuple[Symbol, ...]
    body: ImmutableMatrix

    def at(self, values: tuple[Expression, ...]) -> ImmutableMatrix:
        """Return the matrix for values of the parameters; sin(x + 2π) stays as it is.

        Raises:
            InputError: the number of values is not that of the parameters.
        """
        if len(values) != len(self.parameters):
            raise InputError(f"{len(self.parameters)} arguments are asked for")
        put = dict(zip(self.parameters, values, strict=True))
        return self.body.applyfunc(lambda e: _with(e, put))


def _with(e: Basic, put: Mapping[Symbol, Expression]) -> Any:
    if not e.free_symbols & put.keys():
        return e
    if e in put:
        return put[e]
    args = [_with(arg, put) for arg in e.args]
    return e.func(*args, evaluate=False) if isinstance(e, Function) else e.func(*args)


@dataclass
class Matrices:
    """The matrices of a file, and how to read an expression with them.

    Attributes:
        scalar: reads an expression whose value is a number.
        known: the matrices with a name.
    """

    scalar: Callable[[str], Expression]
    known: dict[str, Any] = field(default_factory=dict)

    def stand_in(self, text: str) -> bool:
        """Return whether a text speaks of a matrix."""
        words = {*re.findall(r"[^\W\d]\w*", text)}
        return bool(words & {*self.known}) or ";" in text

    def read(self, text: str) -> ImmutableMatrix:
        """Return the matrix that an expression stands for.

        Raises:
            InputError: it is no matrix, or the matrices do not fit.
        """
        found = self._sum(text)
        if not isinstance(found, ImmutableMatrix):
            raise InputError(f"'{text}' is not a matrix")
        return found

    def _sum(self, text: str) -> Any:
        try:
            return reduce(lambda one, other: one + other, map(self._product, _summands(text)))
        except (TypeError, ValueError) as error:
            raise InputError(f"'{text}': the matrices do not fit: {error}") from None

    def _product(self, text: str) -> Any:
        first, *others = split(text, _TIMES)
        minus = first.startswith("-")
        value = self._factor(first[1:] if minus else first)
        return reduce(
            lambda one, other: one * other, map(self._factor, others), -value if minus else value
        )

    def _factor(self, text: str) -> Any:
        text = text.strip()
        if not self.stand_in(text):
            return self.scalar(text)
        if encloses(text):
            rows = split(text[1:-1], ";")
            return self._literal(rows) if rows[1:] else self._sum(text[1:-1])
        if text in self.known:
            found = self.known[text]
            if isinstance(found, ImmutableMatrix):
                return found
            raise InputError(f"{text} is a function: write its arguments")
        match = _CALL.match(text)
        if match is None or closing(text[match.end() :]) != len(text) - match.end() - 1:
            raise InputError(f"'{text}' is not read as a matrix")
        return self._call(match[1], split(text[match.end() + 1 : -1], ","))

    def _literal(self, rows: list[str]) -> ImmutableMatrix:
        return ImmutableMatrix([[self.scalar(e) for e in split(row, ",")] for row in rows])

    def _call(self, name: str, arguments: list[str]) -> ImmutableMatrix:
        function = self.known.get(name)
        if isinstance(function, MatrixFunction):
            return function.at(tuple(map(self.scalar, arguments)))
        if name == "transposed" and len(arguments) == 1:
            return self.read(arguments[0]).T
        if name == "diff" and len(arguments) == 2:
            return diff(self.read(arguments[0]), self.scalar(arguments[1]))
        if name == "written_out":
            return reduce(_written_out, map(self.read, arguments))
        raise InputError(f"'{name}' of a matrix is not read")


def entries(name: str, matrix: ImmutableMatrix) -> Iterator[tuple[str, Expression]]:
    """Yield the entries of a matrix, each with the name under which it may be used."""
    rows, columns = matrix.shape
    for i in range(rows):
        for j in range(columns):
            place = f"{i + 1}{j + 1}" if columns > 1 else f"{i + 1}"
            yield f"{name}_{place}", matrix[i, j]


def _written_out(first: ImmutableMatrix, second: ImmutableMatrix) -> ImmutableMatrix:
    if first.shape[1] != second.shape[0]:
        raise InputError(f"matrices of {first.shape} and {second.shape} have no product")
    columns = range(second.shape[1])
    return ImmutableMatrix(
        [[_dot(first.row(i), second.col(j)) for j in columns] for i in range(first.shape[0])]
    )


def _dot(row: ImmutableMatrix, column: ImmutableMatrix) -> Expression:
    pairs = zip(row, column, strict=True)
    return Add(*(Mul(p, q, evaluate=False) for p, q in pairs), evaluate=False)


def _summands(text: str) -> list[str]:
    """The terms of a sum, each with its sign if that is a minus."""
    text, found, start = text.strip(), [], 0
    for at, end in places(text, r"[+-]"):
        before = text[start:at].strip()
        if before and before[-1] not in "*/^":
            found.append(before)
            start = at if text[at] == "-" else end
    return [*found, text[start:].strip()]
