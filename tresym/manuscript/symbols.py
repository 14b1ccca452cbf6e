"""The symbols that stand in a formula's tokens, and how they stand there."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

from tresym.manuscript.notation import plain_notation
from tresym.reals.language.latex_cursor import INDICES, WORDS_BELOW, allowed, is_letter, is_number
from tresym.reals.language.latex_tokens import RELATIONS

_ACCENTS = (
    *("bar", "hat", "tilde", "check", "breve", "widehat", "widetilde", "overline"),
    *("mathcal", "mathscr", "mathfrak", "star"),
)
STYLES = frozenset(
    ("\\mathbf", "\\boldsymbol", "\\bm", "\\vec", "\\mathbb", "\\pmb", "\\mathsf", "\\underline")
)
"""Commands that make another symbol of a letter, and that the reader refuses."""
_UPRIGHT = re.compile(
    r"\\(?:text\w*|mathrm|operatorname\*?|mbox|hbox|label|tag|ref|eqref|cite|color|intertext)"
    r"\s*\{[^{}]*\}|\\begin\s*\{(?:array|tabular)\}\s*\{[^{}]*\}|\\(?:begin|end)\s*\{[^{}]*\}"
)
OPENING = ("(", "[", "\\{")
_CLOSING = {"(": ")", "[": "]", "\\{": "\\}"}


class Mention(NamedTuple):
    """One place in a list of tokens where a symbol stands.

    Attributes:
        letter: its letter, ``A`` or ``theta``.
        accent: ``hat``, ``mathcal``, or a style such as ``\\mathbf``; else nothing.
        subscript: the tokens of its subscript, without braces.
        start, end: the tokens from ``start`` to before ``end`` are the symbol.
    """

    letter: str
    accent: str
    subscript: tuple[str, ...]
    start: int
    end: int

    @property
    def shown(self) -> str:
        """The symbol for a reader."""
        accent = self.accent.removeprefix("\\")
        letter = f"{accent} {self.letter}" if accent else self.letter
        below = "".join(t.removeprefix("\\") for t in self.subscript)
        return f"{letter}_{below}" if below else letter

    @property
    def name(self) -> str:
        """The name by which the reader of LaTeX calls it."""
        below = "".join(t.removeprefix("\\") for t in self.subscript) + self.accent
        if not below:
            return allowed(self.letter)
        return self.letter + (below if below[0].isdigit() else f"_{below}")

    @property
    def is_index(self) -> bool:
        """Whether its subscript numbers a term of a sequence: ``a_k``, ``a_{n+1}``, ``a_{ij}``."""
        letters = "".join(t for t in self.subscript if t.isalpha())
        signs = {"+", "-"} & {*self.subscript}
        if self.subscript and self.subscript[-1].isdigit() and not signs:
            return False  # J0 is a name, 2k and k+1 number terms
        named = letters in WORDS_BELOW or any(t.startswith("\\") for t in self.subscript)
        return bool(letters) and not named and {*letters} <= INDICES


def group_end(tokens: Sequence[str], at: int) -> int:
    """The token that closes the bracket or brace at ``at``, or the last one."""
    opening = {*OPENING, "{", "\\langle"}
    closing = {*_CLOSING.values(), "}", "\\rangle"}
    depth = 0
    for n in range(at, len(tokens)):
        depth += (tokens[n] in opening) - (tokens[n] in closing)
        if depth == 0:
            return n
    return len(tokens) - 1


def mentions(tokens: Sequence[str]) -> Iterator[Mention]:
    """The symbols in a list of tokens, without those in subscripts, differentials and ``e``."""
    at = 0
    while at < len(tokens):
        token = tokens[at]
        after = tokens[at + 1] if at + 1 < len(tokens) else ""
        if token == "_":
            at = group_end(tokens, at + 1) + 1 if after == "{" else at + 2
            continue
        differential = token == "d" and (is_letter(after) or after in ("\\Delta", "\\phi"))
        letter = is_letter(token) or (len(token) == 1 and token.isalpha())
        if not letter or differential or token == "e":
            at += 1
            continue
        style, start = _style(tokens, at)
        end = at + 1
        subscript: tuple[str, ...] = ()
        if after == "_":
            braced = tokens[at + 2 : at + 3] == ["{"] or tokens[at + 2 : at + 3] == ("{",)
            last = group_end(tokens, at + 2) if braced else at + 2
            subscript = tuple(tokens[at + 2 + braced : last + (not braced)])
            end = last + 1
        accent, subscript = _without_accent(subscript)
        yield Mention(token.removeprefix("\\"), style or accent, subscript, start, end)
        at = end


def _style(tokens: Sequence[str], at: int) -> tuple[str, int]:
    """The command that styles the letter at ``at``, and where it begins."""
    if at and tokens[at - 1] in STYLES:
        return tokens[at - 1], at - 1
    if at > 1 and tokens[at - 1] == "{" and tokens[at - 2] in STYLES:
        return tokens[at - 2], at - 2
    return "", at


def _without_accent(subscript: tuple[str, ...]) -> tuple[str, tuple[str, ...]]:
    """The accent that the tokenizer has put at the end of a subscript, and the rest of it."""
    for length in range(min(9, len(subscript)), 2, -1):
        word = "".join(subscript[-length:])
        if word in _ACCENTS:
            return word, subscript[:-length]
    return "", subscript


def without_upright(tex: str) -> str:
    """A formula without words, labels and environments in it."""
    return _UPRIGHT.sub(" ", plain_notation(tex))


def is_lone_argument(tokens: Sequence[str], at: int) -> bool:
    """Whether the bracket at ``at`` holds what a factor would not need it for: ``(x)``, ``(2x)``,
    ``(-x)``, ``(x, y)``, or a bracket of another kind."""
    inner = tokens[at + 1 : group_end(tokens, at)]
    depth = 0
    for n, token in enumerate(inner):
        depth += (token in (*OPENING, "{")) - (token in (*_CLOSING.values(), "}"))
        if depth == 0 and token == ",":
            return True
        if depth == 0 and n and token in ("+", "-", "\\pm", "\\mp"):
            return False
    return bool(inner) and not any(token in RELATIONS for token in inner)


def factors(tokens: Sequence[str], found: Sequence[Mention]) -> Iterator[tuple[Mention, Mention]]:
    """Neighbours that are multiplied without a sign, powers of the first in between passed over."""
    for one, other in pairwise(found):
        at = one.end
        if tokens[at : at + 1] and tokens[at] == "^":
            at = group_end(tokens, at + 1) + 1 if tokens[at + 1 : at + 2] else at + 1
            if at <= one.end + 1:
                at = one.end + 2
        if at == other.start:
            yield one, other


def is_plain_number(token: str) -> bool:
    """Whether a token is a decimal."""
    return is_number(token)
