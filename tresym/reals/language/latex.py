"""Parse LaTeX mathematics into trees.

`read_latex` turns a displayed formula into chains of relations, `read_expression` one expression
into a tree. Nothing is guessed: what can be read in two ways is refused, with a line that says how
to write it.

Read are sums, products by juxtaposition, ``\\frac``, ``\\sqrt``, powers, absolute values,
the elementary functions, ``\\max``, ``e^{…}``, ``\\frac{d}{dx}``, ``\\int_a^b … dx``,
``\\lim_{x \\to a}``, values at a point, ``O(…)``, arrays, and the usual relations, ``\\in`` an
interval among them.
Symbols become names: ``\\psi_0`` is ``psi0``, ``\\theta_{\\min}`` is ``theta_min``,
``\\Delta\\psi`` is ``Delta_psi``; names that the grammar of text reserves get an underscore
(``lambda_``). How far a function's argument goes is told in
:mod:`tresym.reals.language.latex_operands`.

For an author ``\\frac{d\\psi}{d\\phi}`` and ``\\dot\\theta`` are the symbols ``dpsi_dphi`` and
``dtheta_dt``; anybody else's symbols are real variables.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import pairwise

from tresym.reals.language.expression import Expr
from tresym.reals.language.latex_author import Author
from tresym.reals.language.latex_cursor import Cursor, is_letter
from tresym.reals.language.latex_grammar import read_arguments, read_point, read_sum
from tresym.reals.language.latex_operands import Piece
from tresym.reals.language.latex_tokens import (
    ARRAYS,
    CONDITION,
    MAX_DEPTH,
    RELATIONS,
    STOPS,
    Called,
    tokenize,
    with_sign,
)
from tresym.reals.numbers.exact import InputError

NO_RELATION = "LaTeX: a relation such as a = b is expected, there is none"
TOO_DEEP = f"LaTeX: nested deeper than {MAX_DEPTH} levels"
_AUTHORS_WORDS = frozenset({"hot"})


@dataclass(frozen=True)
class Relations:
    """A chain of relations: ``terms[0] ops[0] terms[1] ops[1] terms[2] …``.

    Attributes:
        printed: of each term that is a decimal its digits, of the others nothing.
        condition: the chain under which it is said to hold ("For γ > 0:" above a column).
        defines: the name and the parameters of the author's function that begins it.
    """

    terms: tuple[Expr, ...]
    ops: tuple[str, ...]
    printed: tuple[str, ...] = ()
    condition: Relations | None = None
    defines: tuple[str, tuple[str, ...]] | None = None

    @property
    def links(self) -> Iterator[tuple[Expr, str, Expr]]:
        """Each term with its neighbour and the relation between them."""
        return zip(self.terms, self.ops, self.terms[1:], strict=False)

    def __str__(self) -> str:
        rest = (f" {op} {term}" for op, term in zip(self.ops, self.terms[1:], strict=True))
        return str(self.terms[0]) + "".join(rest)


def read_expression(source: str, author: Author | None = None) -> Expr:
    """One LaTeX expression; ``author`` as in read_latex.

    Raises:
        InputError: LaTeX that is not read; one line says what and, where it helps, how to write it.
    """
    cursor = Cursor(tokenize(source), author)
    try:
        tree = read_sum(cursor).tree
    except RecursionError:
        raise InputError(TOO_DEEP) from None
    cursor.skip_stops()
    if cursor.peek():
        cursor.refuse("an operation or the end is expected")
    return tree


_FUNCTIONS = ("\\Gamma", "\\zeta", "\\psi")
"""Letters of special functions, whose functional equations are no recurrences of unknowns."""


def sequences_in(source: str) -> frozenset[str]:
    """The letters for which a formula states a recurrence, as T in ``T(n) = 2T(n/2) + n``."""
    tokens = tokenize(source)
    arguments: dict[str, list[list[str]]] = {}
    begun: dict[str, str] = {}
    for i, (name, after) in enumerate(pairwise(tokens)):
        if not is_letter(name) or name in _FUNCTIONS or after != "(":
            continue
        end = Cursor(tokens).partner(i + 1)
        inside = tokens[i + 2 : end]
        arguments.setdefault(name, []).append(inside)
        plain = len(inside) == 1 or (len(inside) == 3 and inside[1] == "+")
        if plain and is_letter(inside[0]) and tokens[end + 1 : end + 2] == ["="]:
            begun.setdefault(name, inside[0])
    return frozenset(
        name
        for name, n in begun.items()
        if len({tuple(inside) for inside in arguments[name] if n in inside}) > 1
    )


def read_latex(
    source: str, author: Author | None = None, sequences: frozenset[str] = frozenset()
) -> tuple[Relations, ...]:
    """The relations that a displayed formula states, in order.

    Args:
        source: what stands between the delimiters of the display.
        author: whose formula it is, if claims are compared with it.
        sequences: letters that denote sequences where a bracket follows.

    Raises:
        InputError: LaTeX that is not read; one line says what and, where it helps, how to write it.
    """
    tokens = tokenize(source, frozenset() if author is None else _AUTHORS_WORDS)
    while tokens[-1:] == ["\\\\"]:
        tokens.pop()
    tokens = [
        Called(t) if t in sequences and after == "(" else t for t, after in pairwise([*tokens, ""])
    ]
    try:
        if {"\\pm", "\\mp"} & {*tokens}:
            both = ("; ".join(map(str, _statements(with_sign(tokens, s), author))) for s in "+-")
            raise InputError(f"LaTeX: of two signs two claims: write {' and '.join(both)}")
        found = tuple(_statements(tokens, author))
    except RecursionError:
        raise InputError(TOO_DEEP) from None
    if not found:
        raise InputError(NO_RELATION)
    return found


def _statements(tokens: list[str], author: Author | None) -> list[Relations]:
    """The chains of a display: rows and cells of an array, or one formula."""
    if tokens and tokens[0].startswith("\\begin{"):
        name = tokens[0][tokens[0].index("{") + 1 : -1]
        if name not in ARRAYS:
            raise InputError(f"LaTeX: environment {name} is not read")
        if not tokens[-1].startswith("\\end") or tokens[-1][5:-1] != name:
            raise InputError(f"LaTeX: something follows the {name}, or it is not closed")
        return _rows(_body_of(tokens, name), author)
    return _chains(tokens, author)


def _body_of(tokens: list[str], name: str) -> list[str]:
    body = tokens[1:-1]
    if name == "array" and body[:1] == ["{"]:
        if "}" not in body:
            raise InputError("LaTeX: the columns of the array are not closed")
        body = body[body.index("}") + 1 :]
    return body


def _rows(body: list[str], author: Author | None) -> list[Relations]:
    """Each cell is a statement; one that opens with a relation continues the cell before it."""
    cells: list[list[str]] = []
    columns: list[int] = []
    for row in _split(body, "\\\\"):
        for column, cell in enumerate(_split(row, "&")):
            if cell and cell[0] in RELATIONS and cells:
                cells[-1].extend(cell)
            elif cell:
                cells.append(cell)
                columns.append(column)
    found: list[Relations] = []
    conditions: dict[int, Relations] = {}
    for cell, column in zip(cells, columns, strict=True):
        if cell[0] == CONDITION:
            conditions[column] = _chains([t for t in cell[1:] if t != ":"], author)[0]
            continue
        under = conditions.get(column)
        found.extend(replace(c, condition=under or c.condition) for c in _chains(cell, author))
    return found


def _split(tokens: list[str], separator: str) -> list[list[str]]:
    parts: list[list[str]] = [[]]
    for token in tokens:
        if token == separator:
            parts.append([])
        else:
            parts[-1].append(token)
    return parts


def _chains(tokens: list[str], author: Author | None) -> list[Relations]:
    """The chains of a formula; what follows an upright "for" is a condition on all of them."""
    tokens, *conditions = _split(tokens, CONDITION)
    condition = None
    if not tokens and len(conditions) == 1:  # the condition comes first
        condition, *chains = _chains(conditions[0], author)
    else:
        chains = [*read_chains(Cursor(tokens, author))]
        if len(conditions) == 1:
            (condition,) = _chains(conditions[0], author)
    if not chains or len(conditions) > 1:
        raise InputError(NO_RELATION)
    return [replace(chain, condition=condition or chain.condition) for chain in chains]


def read_chains(cursor: Cursor) -> Iterator[Relations]:
    """All chains, apart by commas, full stops or arrows."""
    cursor.skip_stops()
    while cursor.peek():
        yield read_chain(cursor)
        cursor.skip_stops()


def read_chain(cursor: Cursor) -> Relations:
    """One chain; an interval at its end becomes two inequalities."""
    defines = definition_ahead(cursor)
    terms, ops = [read_sum(cursor)], []
    while cursor.peek() in RELATIONS:
        op = RELATIONS[cursor.take()]
        if op == "in" and len(terms) > 1:
            cursor.refuse("in a chain an interval is not read, here")
        if op == "in":
            low, first, high, second = read_interval(cursor)
            return Relations((low, terms[-1].tree, high), (first, second))
        if op == "->":
            point, side = read_point(cursor)
            terms.append(Piece(point))
            ops.append(op + ("", "+", "-")[side])
        else:
            terms.append(read_sum(cursor))
            ops.append(op)
    if not ops:
        cursor.refuse("a relation such as = is expected")
    if cursor.peek() and cursor.peek() not in STOPS:
        cursor.refuse("a relation, a comma or the end is expected")
    trees, printed = tuple(t.tree for t in terms), tuple(t.printed for t in terms)
    return Relations(trees, tuple(ops), printed, defines=defines)


def definition_ahead(cursor: Cursor) -> tuple[str, tuple[str, ...]] | None:
    """The head ``f(a, b)`` of a definition of an author's, looked at and not taken."""
    start, found = cursor.at, None
    if cursor.author and cursor.kind(start) == "letter" and cursor.peek() != "\\pi":
        name = cursor.symbol()
        if cursor.peek() == "(" and cursor.is_list():
            values = read_arguments(cursor)
            if cursor.peek() in RELATIONS and all(value.op == "symbol" for value in values):
                found = name, tuple(str(value) for value in values)
    cursor.at = start
    return found


def read_interval(cursor: Cursor) -> tuple[Expr, str, Expr, str]:
    """An interval: its ends, and how the variable compares with them."""
    opening = cursor.take()
    if opening not in ("[", "(", "]"):
        cursor.refuse("an interval is expected")
    low = read_sum(cursor).tree
    cursor.take(",")
    high = read_sum(cursor).tree
    closing = cursor.take()
    return low, "<=" if opening == "[" else "<", high, "<=" if closing == "]" else "<"
