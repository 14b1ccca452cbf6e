"""A place in mathematics as people type it: what comes next, and what the text says of itself.

Of ``2 Sin[x]`` the token behind the 2 begins another factor, and the square bracket behind ``Sin``
says that arguments stand in such brackets, as in Mathematica.
"""

from __future__ import annotations

import re
from itertools import pairwise

from tresym.reals.functions.table import TABLE
from tresym.reals.language.calls import KNOWN
from tresym.reals.language.operators import SIGNS, WORDS
from tresym.reals.language.spelling_tokens import END, SUB, Token
from tresym.reals.numbers.exact import InputError

_CAPITALS = {row.mathematica: row.name for row in TABLE.values() if row.theory and row.arity == 1}
_CAPITALS |= {
    f"Arc{alias[1:].capitalize()}": alias
    for row in TABLE.values()
    for alias in row.of_reciprocal
    if not alias.startswith("arc")
}
FUNCTIONS = {
    **{name: name for name in KNOWN - {"diff", "Derivative"}},
    **_CAPITALS,
    **{"Sqrt": "sqrt", "Ln": "log", "fabs": "abs"},
    **{"tg": "tan", "ctg": "cot", "arctg": "atan", "arcctg": "acot"},
    **{"factorial": "factorial", "Factorial": "factorial"},
}
INFINITE = frozenset(("oo", "infinity", "Infinity", "inf", "Inf"))
RESERVED = frozenset(
    (
        *("given", "for", "forall", "if", "then", "when", "whenever", "where", "with", "and", "or"),
        *("in", "from", "to", "as", "provided", "assuming", "suppose", "such", "implies", "is"),
        *("equals", "of", "tends", "goes", "approaches", "integer", "integers", "real", "positive"),
        *("negative", "nonnegative", "iff", "not", "degrees", "deg", "let"),
    )
)
CLOSING = {"(": ")", "[": "]", "{": "}"}


class NotSpelledError(Exception):
    """The text is not understood here either: what the strict reader says of it stands."""


def two(one: str, other: str) -> InputError:
    """The refusal of what can be read in two ways."""
    return InputError(f"two readings remain: write {bare(one)} or {bare(other)}")


def bare(text: str) -> str:
    """Without parentheses around all of it."""
    if text.startswith("(") and text.endswith(")"):
        depth = 0
        for n, character in enumerate(text):
            depth += (character == "(") - (character == ")")
            if depth == 0:
                return text[1:-1] if n == len(text) - 1 else text
    return text


class Typed:
    """The tokens of a text, the place in them, and what the whole text tells of its notation.

    Attributes:
        at: the next token.
        bars: how many absolute values are open.
        under: the operators that are open: what ends their bodies is no factor.
        alone: names that stand without a bracket somewhere.
        brackets: arguments stand in square brackets, as in Mathematica.
        sequences: names for which the text or its conditions state a recurrence.
        maple: ranges are written ``1..n``, as in Maple.
    """

    def __init__(self, found: list[Token], sequences: frozenset[str] = frozenset()) -> None:
        self.tokens, self.sequences = found, sequences
        self.at = 0
        self.bars = 0
        self.under: list[str] = []
        self.brackets = any(
            token.text in FUNCTIONS or token.text in WORDS or token.text == "D"
            for token, after in pairwise(found)
            if after.text == "[" and not after.spaced
        )
        self.alone = {
            token.text
            for token, after in zip(found, [*found[1:], END], strict=True)
            if token.kind == "name" and after.text not in ("(", "[")
        } - RESERVED
        self.maple = any(token.text == ".." for token in found)

    def peek(self, ahead: int = 0) -> Token:
        """A token to come."""
        place = self.at + ahead
        return self.tokens[place] if place < len(self.tokens) else END

    def next(self) -> Token:
        """The next token, which is passed."""
        token = self.peek()
        self.at += 1
        return token

    def take(self, *texts: str) -> str:
        """The next token if it is one of these, which is passed; else nothing."""
        if self.peek().text in texts and self.peek().kind != "end":
            return self.next().text
        return ""

    def need(self, *texts: str) -> str:
        """As :meth:`take`, where one must stand."""
        found = self.take(*texts)
        if not found:
            raise NotSpelledError
        return found

    def name(self) -> str:
        """The name of a variable."""
        if self.peek().kind != "name":
            raise NotSpelledError
        return self.next().text

    def starts_factor(self) -> bool:
        """Whether a factor follows without a sign."""
        token = self.peek()
        if token.kind == "name":
            if not token.spaced and self.at and self.tokens[self.at - 1].text == "0":
                raise NotSpelledError  # 0x10 is no product
            ends = "integral" in self.under and re.fullmatch("d[a-zA-Z]", token.text)
            return token.text not in RESERVED and not ends
        if token.kind == "number":
            if self.at and self.tokens[self.at - 1].kind == "number":
                raise NotSpelledError
            return True
        if token.text == "(" and self.peek(1).text in RESERVED:
            return False
        return token.text in ("(", *SIGNS) or (token.text == "|" and not self.bars)

    def has_comma(self) -> bool:
        """Whether the parentheses that follow hold several arguments."""
        depth = 0
        for token in self.tokens[self.at :]:
            depth += (token.text in CLOSING) - (token.text in (")", "]", "}"))
            if token.text == "," and depth == 1:
                return True
            if depth == 0:
                return False
        return False

    def is_operator(self, name: str) -> bool:
        """Whether such a name begins an integral, a sum or a limit here."""
        after = self.peek()
        return after.kind == "name" or after.text in ("(", "[", SUB, "|") or after.kind == "number"
