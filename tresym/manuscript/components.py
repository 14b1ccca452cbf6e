r"""Vectors and matrices that are written out, read by components, and determinants as numbers.

``(1, 2) + (3, -5) = (4, 3)`` says ``1 + 3 = 4`` and ``2 - 5 = 3``, of which the second is false. A
determinant with rows 2, 1 and 5, 4 is ``2 \cdot 4 - 1 \cdot 5``. Each component becomes a chain of
its own. What stands beside a vector or a matrix must be a number or a usual letter of one, since a
capital may be a matrix itself; and all terms must be written out, of the same size.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import permutations
from typing import TypeAlias

from tresym.manuscript.display import Said

Tokens: TypeAlias = tuple[str, ...]
Matrix: TypeAlias = tuple[tuple[Tokens, ...], ...]
"""The entries of the rows; a column has rows of one entry, a number is a single row of one."""

MOST = 4
"""The largest number of rows or columns."""
_BEGIN, _END = "\\begin{", "\\end{"
_MATRICES = frozenset(("matrix", "pmatrix", "bmatrix", "Bmatrix", "smallmatrix", "array"))
_OPEN = frozenset(("(", "[", "{", "\\{", "\\langle", "\\left("))
_CLOSE = frozenset((")", "]", "}", "\\}", "\\rangle", "\\right)"))
_PARTNERS = {"(": ")", "[": "]", "\\langle": "\\rangle"}
_NUMBERS = frozenset("abcstkrmn") | {"\\lambda", "\\mu", "\\alpha", "\\beta", "\\theta", "\\pi"}
"""Letters of numbers beside a vector."""
_TRANSPOSED = (("^", "T"), ("^", "\\top"), ("^", "{", "T", "}"), ("^", "{", "\\top", "}"))
_UNREAD = frozenset(("\\ldots", "\\vdots", "\\ddots", "\\words", "\\hline"))


class _NoComponentsError(Exception):
    """A term is not written out, or in a way that is not read."""


def by_components(said: Said) -> list[Said]:
    """Return a chain as the chains of its components; the chain itself if it has none."""
    if not any(token.startswith(_BEGIN) or token in (",", "\\det") for token in said.tokens):
        return [said]
    if not said.ops or {*said.tokens} & _UNREAD or said.values:
        return [said]
    try:
        terms = [_without_determinants(term) for term in said.terms]
        if terms != [*said.terms]:
            said = replace(said, terms=tuple(terms), worked=True)
        if {*said.ops} != {"="} or not any(map(_is_written_out, terms)):
            return [said]
        values = [_sum(term) if _is_written_out(term) else ((term,),) for term in terms]
    except _NoComponentsError:
        return [said]
    sizes = {(len(value), len(value[0])) for value in values}
    if len(sizes) != 1:
        return [said]
    ((rows, columns),) = sizes
    calculated = said.worked or any(map(_is_product_or_sum, terms))
    chains = [
        replace(said, terms=tuple(value[i][j] for value in values), worked=calculated)
        for i in range(rows)
        for j in range(columns)
    ]
    telling = [chain for chain in chains if len({*chain.terms}) > 1]
    return telling or chains[:1]


def _is_written_out(term: Sequence[str]) -> bool:
    return any(token.startswith(_BEGIN) or token == "," for token in term)


def _is_product_or_sum(term: Sequence[str]) -> bool:
    """Whether a term is more than one vector or matrix in brackets."""
    if not _is_written_out(term):
        return False
    try:
        parts = [*_parts(term)]
    except _NoComponentsError:
        return True
    return len(parts) != 1 or term[-1].startswith(("^", "T", "}", "\\top"))


def _without_determinants(term: Tokens) -> Tokens:
    """Return a term with the determinants in it multiplied out."""
    tokens = list(term)
    while True:
        at = next((n for n, token in enumerate(tokens) if _opens_determinant(tokens, n)), -1)
        if at < 0:
            return tuple(tokens)
        start = next(n for n in range(at, len(tokens)) if tokens[n].startswith(_BEGIN))
        matrix, end = _environment(tokens, start)
        if tokens[at] == "\\left|":
            if tokens[end : end + 1] != ["\\right|"]:
                raise _NoComponentsError
            end += 1
        elif start > at + 1:  # \det ( ... )
            if tokens[end : end + 1] not in ([")"], ["]"]):
                raise _NoComponentsError
            end += 1
        tokens = [*tokens[:at], "(", *_determinant(matrix), ")", *tokens[end:]]


def _opens_determinant(tokens: Sequence[str], n: int) -> bool:
    token, behind = tokens[n], "".join(tokens[n + 1 : n + 2])
    if token == _BEGIN + "vmatrix}":
        return True
    if token == "\\left|":
        return behind in (_BEGIN + "matrix}", _BEGIN + "array}")
    if token == "\\det":
        further = "".join(tokens[n + 2 : n + 3])
        return behind.startswith(_BEGIN) or (behind in "([" and further.startswith(_BEGIN))
    return False


def _environment(tokens: Sequence[str], start: int) -> tuple[Matrix, int]:
    """Return the entries of the environment that begins at a token, and where it ends."""
    name = tokens[start][len(_BEGIN) : -1].rstrip("*")
    if name not in _MATRICES | {"vmatrix"}:
        raise _NoComponentsError
    end = next((n for n in range(start + 1, len(tokens)) if tokens[n].startswith(_END)), -1)
    body = list(tokens[start + 1 : end])
    if end < 0 or any(token.startswith(_BEGIN) for token in body):
        raise _NoComponentsError
    if name == "array":
        body = body[body.index("}") + 1 :] if body[:1] == ["{"] and "}" in body else body
    rows = [row for row in _split(body, ("\\\\",)) if row]
    matrix = tuple(tuple(map(tuple, _split(row, ("&",)))) for row in rows)
    if not matrix or len({len(row) for row in matrix}) != 1 or not all(map(all, matrix)):
        raise _NoComponentsError
    if max(len(matrix), len(matrix[0])) > MOST:
        raise _NoComponentsError
    return matrix, end + 1


def _split(tokens: Sequence[str], separators: Sequence[str]) -> list[list[str]]:
    """Split tokens at separators outside of brackets."""
    parts: list[list[str]] = [[]]
    depth = 0
    for token in tokens:
        depth += (token in _OPEN) - (token in _CLOSE)
        if depth == 0 and token in separators:
            parts.append([])
        else:
            parts[-1].append(token)
    return parts


def _determinant(matrix: Matrix) -> Tokens:
    if len(matrix) != len(matrix[0]) or len(matrix) > 3:
        raise _NoComponentsError
    result: list[str] = []
    for order in permutations(range(len(matrix))):
        odd = sum(a > b for n, a in enumerate(order) for b in order[n + 1 :]) % 2
        result += ["-" if odd else "+"] if result or odd else []
        result += _product([matrix[row][column] for row, column in enumerate(order)])
    return tuple(result)


def _product(parts: Sequence[Tokens]) -> Tokens:
    """Return the product of entries."""
    if any(part == ("0",) for part in parts):
        return ("0",)
    kept = [part for part in parts if part != ("1",)] or [("1",)]
    result: list[str] = []
    for part in kept:
        result += ["\\cdot"] if result else []
        result += part if len(part) == 1 else ["(", *part, ")"]
    return tuple(result)


def _total(parts: Sequence[tuple[str, Tokens]]) -> Tokens:
    """Return the sum of terms with signs."""
    kept = [(sign, part) for sign, part in parts if part != ("0",)] or [("+", ("0",))]
    result: list[str] = []
    for sign, part in kept:
        result += [sign] if result or sign == "-" else []
        several = any(token in ("+", "-") for token in part)
        result += ["(", *part, ")"] if several and (sign == "-" or result) else part
    return tuple(result)


def _sum(term: Sequence[str]) -> Matrix:
    """Return the components of a sum of products."""
    summands: list[tuple[str, list[str]]] = [("+", [])]
    depth = 0
    for token in term:
        depth += (token in _OPEN or token.startswith(_BEGIN)) - (
            token in _CLOSE or token.startswith(_END)
        )
        if depth == 0 and token in ("+", "-") and (summands[-1][1] or len(summands) == 1):
            if summands == [("+", [])]:
                summands = []
            summands.append((token, []))
        else:
            summands[-1][1].append(token)
    found = [(sign, _factors(tokens)) for sign, tokens in summands]
    sizes = {(len(value), len(value[0])) for _, value in found}
    if len(sizes) != 1:
        raise _NoComponentsError
    ((rows, columns),) = sizes
    return tuple(
        tuple(_total([(sign, value[i][j]) for sign, value in found]) for j in range(columns))
        for i in range(rows)
    )


def _factors(tokens: Sequence[str]) -> Matrix:
    """Return the components of a product of numbers, vectors and matrices."""
    result: Matrix | None = None
    number: list[str] = []
    for part, operator in _parts(tokens):
        if not isinstance(part, list):
            result = part if result is None else _times(result, part, operator)
            continue
        if any(token not in _NUMBERS and not _is_number(token) for token in part):
            raise _NoComponentsError
        number += part
    if result is None:
        raise _NoComponentsError
    if number:
        return tuple(tuple(_product([tuple(number), entry]) for entry in row) for row in result)
    return result


def _is_number(token: str) -> bool:
    return token[0].isdigit() or token in ("\\frac", "\\tfrac", "\\dfrac", "{", "}", "\\sqrt", "/")


def _parts(tokens: Sequence[str]) -> Iterator[tuple[Matrix | list[str], str]]:
    """Yield the vectors, matrices and numbers of a product, each with the sign before it."""
    at, operator = 0, ""
    number: list[str] = []
    while at < len(tokens):
        token = tokens[at]
        matrix: Matrix | None = None
        inner = "".join(tokens[at + 1 : at + 2])
        if token.startswith(_BEGIN):
            matrix, at = _environment(tokens, at)
        elif token in ("(", "[") and inner.startswith(_BEGIN):
            matrix, at = _environment(tokens, at + 1)
            if tokens[at : at + 1] != [_PARTNERS[token]]:
                raise _NoComponentsError
            at += 1
        elif token in _PARTNERS:
            matrix, at = _listed(tokens, at)
        if matrix is None:
            if token in ("\\cdot", "\\times"):
                operator = token
            else:
                number.append(token)
            at += 1
            continue
        for mark in _TRANSPOSED:
            if tuple(tokens[at : at + len(mark)]) == mark:
                matrix, at = tuple(zip(*matrix, strict=True)), at + len(mark)
        if tokens[at : at + 1] in (["^"], ["_"]):
            raise _NoComponentsError
        if number:
            yield number, ""
            number = []
        yield matrix, operator
        operator = ""
    if number:
        raise _NoComponentsError  # what stands behind a vector may be its argument


def _listed(tokens: Sequence[str], start: int) -> tuple[Matrix, int]:
    """Return the column of a list in brackets, and where it ends."""
    depth = 0
    for n in range(start, len(tokens)):
        depth += (tokens[n] in _OPEN) - (tokens[n] in _CLOSE)
        if depth == 0:
            entries = _split(tokens[start + 1 : n], (",",))
            fits = tokens[n] == _PARTNERS[tokens[start]] and 1 < len(entries) <= MOST
            if not fits or not all(entries):
                raise _NoComponentsError
            return tuple((tuple(entry),) for entry in entries), n + 1
    raise _NoComponentsError


def _times(one: Matrix, other: Matrix, operator: str) -> Matrix:
    """Return the product of matrices, or of two vectors by the sign between them."""
    columns = len(one[0]) == len(other[0]) == 1 and len(one) == len(other) > 1
    if columns and operator == "\\cdot":
        parts = [("+", _product([a[0], b[0]])) for a, b in zip(one, other, strict=True)]
        return ((_total(parts),),)
    if columns and operator == "\\times" and len(one) == 3:
        (a,), (b,), (c,) = one
        (x,), (y,), (z,) = other
        pairs = ((b, z, c, y), (c, x, a, z), (a, y, b, x))
        return tuple(
            (_total([("+", _product([p, q])), ("-", _product([r, s]))]),) for p, q, r, s in pairs
        )
    if len(one[0]) != len(other) or operator == "\\times":
        raise _NoComponentsError
    return tuple(
        tuple(
            _total([("+", _product([row[k], other[k][j]])) for k in range(len(other))])
            for j in range(len(other[0]))
        )
        for row in one
    )
