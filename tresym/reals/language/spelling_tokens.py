"""Tokens of mathematics as people type it: ``2x``, ``sin²x``, ``Sin[x]``, ``∫₀¹ x dx``."""

from __future__ import annotations

import re
from typing import NamedTuple

from tresym.reals.language.unicode_input import signs

MAX_TEXT = 3000
MAX_NESTING = 60

SUB = "⌄"
"""Marks a lower bound of an integral, a sum or a limit."""
_BIG = "∫|∑|∏|\\b(?:integral|integrate|int|sum|product|prod|limit|lim)"
_SUBSCRIPTS = str.maketrans("₀₁₂₃₄₅₆₇₈₉₋", "0123456789-")
_LATEX_WORDS = {
    **{"le": "<=", "leq": "<=", "ge": ">=", "geq": ">=", "ne": "!=", "neq": "!=", "to": "->"},
    **{"cdot": "*", "times": "*", "infty": "oo", "in": " in ", "implies": "=>", "land": " and "},
    **{"rightarrow": "->", "Rightarrow": "=>", "forall": " forall "},
}
_WORDS = {
    **{"∀": " forall ", "∈": " in ", "∧": " and ", "∨": " or ", "⇒": "=>", "⟹": "=>", "⇔": "<=>"},
    **{"ℝ": " RR ", "ℤ": " ZZ ", "ℕ": " NN ", "ℚ": " QQ ", "ℂ": " CC ", "Σ": "∑", "…": "..."},
    **{"⋯": "...", "∛": " cbrt ", "⟺": "<=>"},
}
_TOKEN = re.compile(
    r"(?P<space>\s*)(?:"
    r"(?P<number>\d+(?:\.(?!\.)\d*)?(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?)"
    r"|(?P<name>[A-Za-z_]\w*)"
    r"|(?P<quoted>'[+-]{1,2}'|\"[+-]{1,2}\")"
    r"|(?P<sign>\*\*|\.\.\.|\.\.|<=>|==>|=>|<->|->|===|==|=/=|!=|<>|<=|=<|>=|:=|&&|\S))"
)


class Token(NamedTuple):
    """One token; ``at`` is where it begins, ``spaced`` whether a space stands before it."""

    kind: str
    text: str
    spaced: bool
    at: int


END = Token("end", "", True, 0)


def tokens(text: str) -> tuple[str, list[Token]]:
    """The text that is read, in ASCII but for the signs of integrals and sums, and its tokens.

    Returns nothing for text that is too long or too deeply nested.
    """
    if len(text) > MAX_TEXT:
        return "", []
    text = _ascii(text)
    found = []
    for match in _TOKEN.finditer(text):
        kind = str(match.lastgroup)
        found.append(Token(kind, match[kind], bool(match["space"]), match.start(kind)))
    depth = deepest = 0
    for token in found:
        depth += (token.text in ("(", "[", "{")) - (token.text in (")", "]", "}"))
        deepest = max(deepest, depth)
    signed = re.search(r"(?:[-+^√∫∑∏]\s*|\*\*\s*|\b[a-z]{2,}\s+){40}", text)
    bars = sum(token.text == "|" for token in found)
    if deepest > MAX_NESTING or signed or bars > MAX_NESTING:
        return "", []
    return text, found


def _ascii(text: str) -> str:
    """Signs of print as words and operators."""
    text = re.sub(r"\\([A-Za-z]+)", lambda m: _LATEX_WORDS.get(m[1], f" {m[1]} "), text)
    text = re.sub(r"\b(?:math|np|numpy|sympy|sp|mpmath|Math)\.(?=[a-zA-Z])", "", text)
    text = re.sub("∂\\s*([a-z])", r"d\1", text).replace("∂", "d")
    for sign, word in _WORDS.items():
        text = text.replace(sign, word)
    text = re.sub("(?<=[∫∑∏])[₀-₉₋]+", lambda m: "_" + m[0].translate(_SUBSCRIPTS), text)
    text = re.sub(rf"({_BIG})\s*_\s*", rf"\1 {SUB} ", text)
    return signs(text)
