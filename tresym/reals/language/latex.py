"""Reading LaTeX mathematics as text of the expression grammar.

`read_latex` turns a displayed formula into chains of relations; `read_expression` one expression
into text that :func:`tresym.reals.parse` accepts. Nothing is guessed: what can be read in two
ways is refused, with a line that says how to write it.

Read are sums, products by juxtaposition, ``\\frac``, ``\\sqrt``, powers, absolute values, the
elementary functions, ``e^{…}``, arrays, and the usual relations, ``\\in`` an interval among them.
Symbols become names: ``\\psi_0`` is ``psi0``, ``\\theta_{\\min}`` is ``theta_min``,
``\\Delta\\psi`` is ``Delta_psi``; names that the grammar reserves get an underscore (``lambda_``).
How far a function's argument goes is told in :mod:`tresym.reals.language.latex_reach`.

For an ``author`` whose symbols are more than real variables ``\\frac{d\\psi}{d\\phi}`` and
``\\dot\\theta`` are the symbols ``dpsi_dphi`` and ``dtheta_dt``.

Beyond the grammar of expressions the text has calls that stand for what is not an expression:
``integral(f, x, low, high)``, ``at(e, x, value)`` for an evaluation bar, ``between(e, low, high)``
for a bracket with limits, ``value(e, p, …)`` for a value at a point, ``O(e)``, ``o(e)``, ``inf``,
and functions of the author's such as ``f(a, b)``.
"""

from __future__ import annotations

from dataclasses import dataclass

from tresym.reals.language.latex_grammar import Reader
from tresym.reals.language.latex_tokens import ARRAYS, CONDITION, RELATIONS, STOPS, tokenize
from tresym.reals.numbers.exact import InputError

_AUTHORS_WORDS = frozenset({"hot"})


@dataclass(frozen=True)
class Relations:
    """A chain of relations: ``terms[0] ops[0] terms[1] ops[1] terms[2] …``.

    ``condition`` is the chain under which it is said to hold ("For γ > 0:" above a column).
    """

    terms: tuple[str, ...]
    ops: tuple[str, ...]
    condition: Relations | None = None

    def __str__(self) -> str:
        text = self.terms[0]
        for op, term in zip(self.ops, self.terms[1:], strict=True):
            text += f" {op} {term}"
        return text


def read_expression(source: str, author: bool = False) -> str:
    """One LaTeX expression as text of the expression grammar; ``author`` as in read_latex.

    Raises:
        InputError: LaTeX that is not read; one line says what and, where it helps, how to write it.
    """
    reader = Reader(tokenize(source), author)
    text = reader.sum().text
    reader.skip_stops()
    if reader.peek():
        reader.refuse("an operation or the end is expected")
    return text


def read_latex(source: str, author: bool = False) -> tuple[Relations, ...]:
    """The relations that a displayed formula states, in order.

    Args:
        source: what stands between the delimiters of the display.
        author: whether ``f(x)``, derivatives such as ``dy/dx`` or ``\\dot x``, and the word "hot"
            are symbols of an author's whose claims are compared with what is read. Else a variable
            is a real number, and these are refused.

    Raises:
        InputError: LaTeX that is not read; one line says what and, where it helps, how to write it.
    """
    tokens = tokenize(source, _AUTHORS_WORDS if author else frozenset())
    while tokens[-1:] == ["\\\\"]:
        tokens.pop()
    return tuple(_statements(tokens, author))


def _statements(tokens: list[str], author: bool) -> list[Relations]:
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


def _rows(body: list[str], author: bool) -> list[Relations]:
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
        condition = conditions.get(column)
        found.extend(Relations(c.terms, c.ops, condition) for c in _chains(cell, author))
    return found


def _split(tokens: list[str], separator: str) -> list[list[str]]:
    parts: list[list[str]] = [[]]
    for token in tokens:
        if token == separator:
            parts.append([])
        else:
            parts[-1].append(token)
    return parts


def _chains(tokens: list[str], author: bool) -> list[Relations]:
    reader = _Chains(tokens, author)
    chains: list[Relations] = []
    reader.skip_stops()
    while reader.peek():
        chains.extend(reader.chain())
        reader.skip_stops()
    if not chains:
        raise InputError("LaTeX: a relation such as a = b is expected, there is none")
    return chains


class _Chains(Reader):
    """Expressions and the relations between them."""

    def chain(self) -> list[Relations]:
        """One chain; an interval on its right end becomes two inequalities."""
        terms, ops = [self.sum().text], []
        while self.peek() in RELATIONS:
            op = RELATIONS[self.take()]
            if op == "in":
                low, first, high, second = self.interval()
                return [Relations((low, terms[-1], high), (first, second))]
            ops.append(op)
            terms.append(self.sum().text)
        if not ops:
            self.refuse("a relation such as = is expected")
        if self.peek() and self.peek() not in STOPS:
            self.refuse("a relation, a comma or the end is expected")
        return [Relations(tuple(terms), tuple(ops))]

    def interval(self) -> tuple[str, str, str, str]:
        opening = self.take()
        if opening not in ("[", "(", "]"):
            self.refuse("an interval is expected")
        low = self.sum().text
        self.take(",")
        high = self.sum().text
        closing = self.take()
        return low, "<=" if opening == "[" else "<", high, "<=" if closing == "]" else "<"
