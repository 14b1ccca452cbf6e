"""Estimate the width of a typeset formula."""

from __future__ import annotations

import re

_TOKEN = re.compile(r"\\[A-Za-z]+|\\.|.", re.DOTALL)
_NOTHING = frozenset([r"\left", r"\right", r"\mathsf", r"\dot", r"\vec", r"\text", r"\,", "&", " "])
_WORDS = {
    r"\sin": 3.5, r"\cos": 3.5, r"\tan": 3.5, r"\sinh": 4.5, r"\cosh": 4.5, r"\tanh": 4.5,
    r"\arcsin": 6.0, r"\arccos": 6.0, r"\arctan": 6.0, r"\ln": 2.5, r"\quad": 2.0, r"\iff": 4.0,
}  # fmt: skip
_SPACED = frozenset(["=", "+", "-", "<", ">", r"\ge", r"\le", r"\ne"])
SCRIPT = 0.7


def width(formula: str) -> float:
    """Return the approximate width of a formula in letters; a fraction counts its wider part."""
    return _width(_TOKEN.findall(formula))


def _width(tokens: list[str]) -> float:
    total = 0.0
    while tokens:
        token = tokens.pop(0)
        if token == r"\frac":
            total += max(_width(argument(tokens)), _width(argument(tokens)))
        elif token in ("^", "_"):
            total += SCRIPT * _width(argument(tokens))
        elif token == "{":
            total += _width(_rest(tokens))
        elif token == r"\begin":
            total += 2 + max(map(_width, _matrix(tokens)))
        elif token not in _NOTHING and token != "}":
            total += _WORDS.get(token, 2.0 if token in _SPACED else 1.0)
    return total


def _rest(tokens: list[str]) -> list[str]:
    """The tokens up to the closing brace, removed from the list."""
    depth, found = 1, []
    while tokens and depth:
        found.append(tokens.pop(0))
        depth += (found[-1] == "{") - (found[-1] == "}")
    return found


def argument(tokens: list[str]) -> list[str]:
    """Return the next argument without its braces, and remove it from ``tokens``."""
    if not tokens:
        return []
    first = tokens.pop(0)
    return _rest(tokens)[:-1] if first == "{" else [first]


def _matrix(tokens: list[str]) -> list[list[str]]:
    """The rows of the matrix at the start of the list, removed from it."""
    argument(tokens)
    rows: list[list[str]] = [[]]
    while tokens and (token := tokens.pop(0)) != r"\end":
        if token == r"\\":
            rows.append([])
        else:
            rows[-1].append(token)
    argument(tokens)
    return rows
