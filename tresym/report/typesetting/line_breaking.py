"""Break long LaTeX formulas into lines.

A line ends before a relation, a sign of a sum or a factor, at the lowest nesting depth that makes
it fit. A bracket that is broken inside has a fixed size, since TeX's automatic sizes end with the
line. A fraction that is too wide becomes a product, or a quotient of two brackets.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from typing import NamedTuple

from tresym.report.typesetting.formula_width import width

INDENT = 3.0
"""The indentation of the lines after the first, in letters."""
LEAST = 24.0
"""The least width of a line, even inside nested brackets."""

_TOKEN = re.compile(r"\\[A-Za-z]+ ?|\\.|.", re.DOTALL)
_RELATIONS = frozenset(["=", "<", ">", r"\ge", r"\le", r"\ne", r"\iff"])
_SUMS = frozenset("+-")
_PAIRS = {"{": "}", "(": ")", "[": "]"}
_FUNCTIONS = re.compile(r"\\(arc)?(sin|cos|tan)h?|\\ln|\\log|\\exp|\\operatorname")
_BEFORE = re.compile(r"\\int|\\sum|\\frac\{(d|\\partial)\}|\\,|\\text|\\Big|/|-|\+|=|\\in\b|d$")
"""A token that begins with these belongs to the factor after it."""
_AFTER = re.compile(r"\\in\b|\\,|\\Big|/|\\quad|d|[^\w\\(]")
"""A token that begins with these belongs to the factor before it."""


class Piece(NamedTuple):
    """A sign or a factor; for a factor that can be broken also its start, content and end."""

    text: str
    inside: tuple[str, str, str] | None = None


def broken(formula: str, limit: float, used: float = 0) -> list[str]:
    """Break a formula into lines of about ``limit`` letters, where possible.

    Args:
        formula: LaTeX, without environments.
        limit: the width of a line in letters.
        used: letters that are already on the first line.
    """
    if width(formula) <= limit - used or r"\begin" in formula:
        return [formula]
    pieces = list(_pieces(formula))
    for ends in (_quad, _relation, _sum):
        terms = list(_grouped(pieces, ends))
        if len(terms) > 1:
            return _packed(["".join(p.text for p in term) for term in terms], limit, used)
    return _product(pieces, limit, used)


def _packed(terms: list[str], limit: float, used: float) -> list[str]:
    """The terms in order on as few lines as possible; a term that is too wide is broken inside."""
    lines = [""]
    for term in terms:
        room = limit - (INDENT if lines[1:] else used) - width(lines[-1])
        short = width(lines[-1]) < limit / 6 and width(term) > limit - INDENT
        if lines[-1] and width(term) > room and not short:
            lines.append("")
        taken = width(lines[-1]) + (0 if lines[1:] else used)
        found = broken(term, max(limit - INDENT, LEAST), taken)
        lines[-1] += found[0]
        lines += found[1:]
    return lines


def _product(pieces: list[Piece], limit: float, used: float) -> list[str]:
    """A product: lines of whole factors; a wide factor is broken inside."""
    lines, before = [""], ""
    for piece in pieces:
        taken = width(lines[-1]) + (INDENT if lines[1:] else used)
        if width(piece.text) <= limit - taken:
            lines[-1] += piece.text
        elif piece.inside and width(piece.text) > limit / 2:
            start, body, end = piece.inside
            found = broken(body, max(limit - INDENT, LEAST), taken + width(start))
            lines[-1] += start + found[0]
            lines += found[1:]
            lines[-1] += end
        elif lines[-1].strip() and not _BEFORE.match(before) and not _AFTER.match(piece.text):
            lines.append(r"\times " + piece.text)
        else:
            lines[-1] += piece.text
        before = piece.text
    return lines


def _grouped(pieces: list[Piece], ends: Callable[[str, str], bool]) -> Iterator[list[Piece]]:
    """Groups of pieces; a new group starts before each piece that ``ends`` the one before."""
    group: list[Piece] = []
    for piece in pieces:
        if group and ends(piece.text.strip(), group[-1].text.strip()):
            yield group
            group = []
        group.append(piece)
    yield group


def _quad(sign: str, before: str) -> bool:
    return before in (r"\quad", r"\qquad", "\\") and sign not in (r"\quad", r"\qquad")


def _relation(sign: str, before: str) -> bool:
    return sign in _RELATIONS


def _sum(sign: str, before: str) -> bool:
    return sign in _SUMS and before not in (_SUMS | _RELATIONS | {r"\times"})


def _pieces(formula: str) -> Iterator[Piece]:
    tokens = [token.rstrip(" ") if len(token) > 1 else token for token in _TOKEN.findall(formula)]
    spaced = _TOKEN.findall(formula)
    place = 0
    while place < len(tokens):
        end = _factor(tokens, place)
        text = "".join(spaced[place:end])
        if text.strip():
            yield Piece(text, _inside(tokens, spaced, place, end))
        place = end


def _factor(tokens: list[str], place: int) -> int:
    """The end of the factor that begins at ``place``, with its arguments and scripts."""
    token = tokens[place]
    end = _group(tokens, place)
    if token in (r"\frac", r"\tfrac"):
        end = _group(tokens, _group(tokens, end))
    elif token in (r"\sqrt", r"\text", r"\operatorname", r"\mathrm", r"\dot", r"\vec"):
        end = _group(tokens, end)
    end = _scripts(tokens, end)
    if _FUNCTIONS.fullmatch(token) and end < len(tokens):
        end = _factor(tokens, end + (tokens[end] == " "))
    return end


def _scripts(tokens: list[str], end: int) -> int:
    while end < len(tokens) and tokens[end] in ("^", "_", "'"):
        end = end + 1 if tokens[end] == "'" else _group(tokens, end + 1)
    return end


def _group(tokens: list[str], place: int) -> int:
    """The position after one token, or after the bracket that opens there."""
    if place >= len(tokens):
        return place
    if tokens[place] == r"\left":
        depth, n = 1, place + 1
        while depth and n < len(tokens):
            depth += (tokens[n] == r"\left") - (tokens[n] == r"\right")
            n += 1
        return n + 1
    close = _PAIRS.get(tokens[place])
    n = place + 1
    while close and n < len(tokens) and tokens[n] != close:
        n = _group(tokens, n)
    return min(n + (close is not None), len(tokens))


def _inside(
    tokens: list[str], spaced: list[str], place: int, end: int
) -> tuple[str, str, str] | None:
    """The start, content and end of a factor that can be broken inside, else None."""

    def text(start: int, stop: int) -> str:
        return "".join(spaced[start:stop])

    if tokens[place] == r"\frac":
        middle = _group(tokens, place + 1)
        above, below = text(place + 2, middle - 1), text(middle + 1, _group(tokens, middle) - 1)
        if width(below) > width(above) / 2:
            above = above if len(above) == 1 else rf"\left({above}\right)"
            return "", rf"{above}\Big/\left({below}\right)", ""
        return rf"\frac{{1}}{{{below}}}\Bigl(", above, r"\Bigr)"
    start = place
    if _FUNCTIONS.fullmatch(tokens[place]):
        start = _scripts(tokens, _group(tokens, place))
        if tokens[place] == r"\operatorname":
            start = _scripts(tokens, _group(tokens, place + 1))
    if start >= end or tokens[start] not in ("(", r"\left"):
        return None
    sized = tokens[start] == r"\left"
    close = _group(tokens, start)
    opens, shuts = (tokens[start + 1], tokens[close - 1]) if sized else ("(", ")")
    body = text(start + 1 + sized, close - 1 - sized)
    return rf"{text(place, start)}\Bigl{opens}", body, rf"\Bigr{shuts}{text(close, end)}"
