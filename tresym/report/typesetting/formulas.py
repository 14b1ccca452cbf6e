"""Find formulas within sentences, and write them in LaTeX.

The sentences of the ledger are plain text, such as ``ε₀ = O(e^{−π/λ}) as λ → 0``, and a terminal
shows them unchanged. Where mathematics can be typeset, each run of letters, signs and brackets that
is a formula is typeset as one. What may be no formula, such as the article in "a body", stays text.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable, Iterator, Mapping
from typing import NamedTuple

_GREEK = {
    "α": r"\alpha", "β": r"\beta", "γ": r"\gamma", "δ": r"\delta", "ε": r"\epsilon",
    "θ": r"\theta", "κ": r"\kappa", "λ": r"\lambda", "μ": r"\mu", "ν": r"\nu", "ξ": r"\xi",
    "π": r"\pi", "ρ": r"\rho", "σ": r"\sigma", "τ": r"\tau", "φ": r"\phi", "χ": r"\chi",
    "ψ": r"\psi", "ω": r"\omega", "Δ": r"\Delta", "Σ": r"\sum", "Φ": r"\Phi", "Ψ": r"\Psi",
    "Ω": r"\Omega", "Θ": r"\Theta", "Λ": r"\Lambda", "∞": r"\infty", "∂": r"\partial",
    "∫": r"\int", "…": r"\dots",
}  # fmt: skip
_RELATIONS = {
    "=": "=", "<": "<", ">": ">", "≤": r"\le", "≥": r"\ge", "≠": r"\ne", "≈": r"\approx",
    "≃": r"\simeq", "∼": r"\sim", "~": r"\sim", "≪": r"\ll", "≫": r"\gg", "→": r"\to",
    ":=": ":=", "∈": r"\in", "∉": r"\notin", "∝": r"\propto", "⟺": r"\iff", "⇒": r"\Rightarrow",
}  # fmt: skip
_SIGNS = {"+": "+", "−": "-", "±": r"\pm", "∓": r"\mp"}
_TIMES = {"·": r"\cdot", "×": r"\times", "/": "/"}
_RAISED = dict(zip("⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻ⁿᵀ", [*"0123456789+-n", r"\top"], strict=True))
_LOWERED = dict(zip("₀₁₂₃₄₅₆₇₈₉₊₋ᵢₙ", "0123456789+-in", strict=True))
_OVER = {"\u0307": r"\dot", "\u0302": r"\hat", "\u20d7": r"\vec"}
_FUNCTIONS = {
    name: rf"\{name}" for name in ("sin", "cos", "tan", "cot", "sinh", "cosh", "tanh", "coth",
                                   "arcsin", "arccos", "arctan", "exp", "min", "max")
} | {"log": r"\ln"} | {
    name: rf"\operatorname{{{name}}}" for name in ("arsinh", "artanh", "arcosh", "sgn", "sn",
                                                   "cn", "dn", "ln")
}  # fmt: skip
_NAMES = {"const": r"\mathrm{const}", "hot": r"\mathrm{hot}"}
"""Words that occur in formulas."""
_PRODUCTS = frozenset(["ab", "kr", "kP", "aD", "gt"])
"""Pairs of Latin letters that are products."""
_AFTER_A = re.compile(
    "and|or|is|are|at|in|with|alone|for|to|by|as|has|tends|goes|falls|rises|grows|increases|"
    "decreases|exactly|when|where|which|but|than|through"
)
"""Words before which a single ``a`` is the symbol, not the article."""

_TOKEN = re.compile(
    r"(?P<code>`[^`]*`)"
    r"|(?P<unit>\b(?:kg|mm|cm)\b(?: ?(?:mm|m|s)[⁻⁰¹²³]*(?!\w))*|Physica D|App\. [A-Z]\b"
    r"|\([A-Z]\.\d+\))"
    r"|(?P<named>[A-Za-z]{2,}\d*_\w+|[A-Za-z]+\d\w*|[A-Za-z]_[a-z0-9]\w+(?<!_max)(?<!_min)"
    r"|[A-Za-z]\.[A-Za-z]\."
    r"|\d+\.\d+\.[\d.]+|\d+(?:st|nd|rd|th)\b|[A-Z]\. (?=[A-Z]))"
    r"|(?P<number>\d+(?:\.\d+)?(?:e-?\d+)?)"
    r"|(?P<word>[A-Za-zÀ-ɏ]+(?:['’-][A-Za-zÀ-ɏ]+)*)"
    r"|(?P<space>\s+)|(?P<sign>:=|.)",
    re.DOTALL,
)


class Piece(NamedTuple):
    """A part of a sentence: plain words, a formula in LaTeX, or a name in backticks."""

    text: str
    latex: str = ""
    code: bool = False


class _Token(NamedTuple):
    kind: str
    text: str


def pieces(sentence: str) -> Iterator[Piece]:
    r"""Split a sentence into words and formulas, in order.

    Example:
        >>> [p.latex for p in pieces("the root ε₀ of it") if p.latex]
        ['\\epsilon_{0}']
    """
    tokens = list(_tokens(sentence))
    words, place = "", 0
    while place < len(tokens):
        reader = _Reader(tokens, place)
        latex = reader.formula() if reader.may_begin() else None
        if latex is not None and reader.is_formula(place):
            if words:
                yield Piece(words)
            words = ""
            yield Piece("".join(t.text for t in tokens[place : reader.place]), latex)
            place = reader.place
        elif tokens[place].kind == "code":
            if words:
                yield Piece(words)
            words = ""
            yield Piece(tokens[place].text[1:-1], code=True)
            place += 1
        else:
            words += tokens[place].text
            place += 1
    if words:
        yield Piece(words)


def _tokens(sentence: str) -> Iterator[_Token]:
    found = [(m.lastgroup or "sign", m[0]) for m in _TOKEN.finditer(_decomposed(sentence))]
    for n, (kind, text) in enumerate(found):
        if kind != "word" or text in _FUNCTIONS:
            yield _Token("function" if kind == "word" else kind, text)
            continue
        before = found[n - 1] if n else ("", " ")
        after = found[n + 1][1][0] if n + 1 < len(found) else " "
        if text in _NAMES:
            yield _Token("letter", text)
        elif len(text) == 1 or text in _PRODUCTS or _is_product(text, before, after):
            yield from (_Token("letter", letter) for letter in text)
        else:
            yield _Token(kind, text)


def _decomposed(text: str) -> str:
    """The text with dotted letters split into the letter and its dot."""
    return "".join(unicodedata.normalize("NFD", c) if c in "ṘṀ" else c for c in text)


def _is_product(text: str, before: tuple[str, str], after: str) -> bool:
    """Whether adjacent letters touch something that occurs in formulas only."""
    if len(text) > 3 or not text.isascii():
        return False
    joined = before[0] == "number" or before[1][-1] in _GREEK or before[1][-1] in _LOWERED
    rate = text[0] == "d" and len(text) == 2 and (after == "/" or before[1] == "/")
    return joined or rate or after in _GREEK or after in _LOWERED or after in _RAISED


class _Reader:
    """Recursive-descent parser for one formula among the tokens; methods return None on failure."""

    def __init__(self, tokens: list[_Token], place: int) -> None:
        self.tokens = tokens
        self.place = place

    def _at(self, n: int = 0) -> _Token:
        place = self.place + n
        return self.tokens[place] if 0 <= place < len(self.tokens) else _Token("end", " ")

    def may_begin(self) -> bool:
        """Whether a formula may begin here, and not in the middle of words."""
        before = self._at(-1)
        return before.kind not in ("word", "number", "named", "letter") and before.text not in "{."

    def is_formula(self, start: int) -> bool:
        """Whether what was parsed from ``start`` is more than a number or a number in brackets."""
        read = self.tokens[start : self.place]
        if self._at().kind in ("word", "named") and read[-1].kind != "space":
            return False
        return any(
            t.kind == "letter" or (t.kind == "sign" and t.text not in "()[],…") for t in read
        )

    def formula(self) -> str | None:
        """Parse sums joined by relations."""
        return self._chain(self._sum, _RELATIONS)

    def _sum(self) -> str | None:
        return self._chain(self._term, _SIGNS)

    def _chain(self, part: Callable[[], str | None], signs: Mapping[str, str]) -> str | None:
        """Parse parts joined by signs; one sign may come first."""
        latex = self._sign(signs)
        first = part()
        if first is None:
            return None
        latex += first
        while True:
            start = self.place
            self._skip_space()
            if self._at().text not in signs:
                break
            sign = self._sign(signs)
            following = part()
            if following is None:
                break
            latex += f" {sign}{following}"
        self.place = start
        return latex

    def _sign(self, signs: Mapping[str, str]) -> str:
        if self._at().text not in signs:
            return ""
        sign = signs[self._at().text]
        self.place += 1
        self._skip_space()
        return f"{sign} "

    def _skip_space(self) -> None:
        self.place += self._at().kind == "space"

    def _term(self) -> str | None:
        latex = self._factor()
        if latex is None:
            return None
        while True:
            start = self.place
            spaced = self._at().kind == "space"
            self._skip_space()
            times = _TIMES.get(self._at().text, "")
            if times:
                self.place += 1
                self._skip_space()
                sign = self._sign(_SIGNS) if times != "/" else ""
                factor = self._factor()
            elif spaced and not self._joins():
                break
            else:
                sign, factor = "", self._factor()
            if factor is None:
                break
            latex += f"{times} {sign}{factor}" if times != "/" else f"/{factor}"
        self.place = start
        return latex

    def _joins(self) -> bool:
        """Whether another factor follows the space."""
        token, before = self._at(), self._at(-2)
        if token.kind == "number" or token.text in "[…":
            return before.kind == "function"
        after = self._at(1)
        if token.kind == "letter" and after.kind != "letter":
            return after.text in "^_(" or any(after.text in k for k in (_GREEK, _LOWERED, _RAISED))
        return not (token.text == "(" and before.kind == "letter")

    def _factor(self) -> str | None:
        token = self._at()
        if token.kind == "function":
            self.place += 1
            latex = _FUNCTIONS[token.text] + self._scripts()
            self._skip_space()
            argument = self._factor()
            return None if argument is None else f"{latex} {argument}"
        if token.text == "√":
            self.place += 1
            inner = self._factor()
            return None if inner is None else rf"\sqrt{{{_bare(inner)}}}"
        atom = self._atom()
        return None if atom is None else atom + self._scripts()

    def _atom(self) -> str | None:
        token = self._at()
        if token.kind == "number":
            self.place += 1
            return token.text
        if token.kind == "letter":
            return None if token.text in "aA" and self._is_article() else self._letter()
        if token.text in _GREEK:
            return self._letter()
        if token.text in ("(", "["):
            return self._bracket()
        return self._absolute() if token.text == "|" else None

    def _letter(self) -> str:
        text = self._at().text
        latex = _GREEK.get(text) or _NAMES.get(text, text)
        self.place += 1
        if self._at().text in _OVER:
            latex = f"{_OVER[self._at().text]} {latex}"
            self.place += 1
        return latex

    def _is_article(self) -> bool:
        """Whether a single ``a`` is the article: no sign next to it and no verb after it."""
        signs = (_RELATIONS, _SIGNS, _TIMES)
        if self._at(-1).kind in ("letter", "number", "sign") and self._at(-1).text not in '“("':
            return False
        before, after = self._at(-2).text, self._at(1)
        if before in ("fixed", "given") or any(before in known for known in signs):
            return False
        if after.kind != "space":
            return False
        then = self._at(2)
        return not (_AFTER_A.fullmatch(then.text) or any(then.text in known for known in signs))

    def _bracket(self) -> str | None:
        start, opening = self.place, self._at().text
        self.place += 1
        latex = self._listed()
        if latex is None or self._at().text not in (")", "]"):
            self.place = start
            return None
        closing = self._at().text
        self.place += 1
        return f"{opening}{latex}{closing}"

    def _listed(self) -> str | None:
        latex: str | None = self.formula()
        while latex is not None and self._at().text in (",", ";"):
            mark = self._at().text
            self.place += 1
            self._skip_space()
            following = self.formula()
            latex = None if following is None else f"{latex}{mark} {following}"
        return latex

    def _absolute(self) -> str | None:
        start = self.place
        self.place += 1
        inner = self._sum()
        if inner is None or self._at().text != "|":
            self.place = start
            return None
        self.place += 1
        return rf"\vert {inner}\vert "

    def _scripts(self) -> str:
        """Parse indices, exponents, primes, and the star of ε*."""
        lowered, raised = "", ""
        while True:
            text = self._at().text
            if text in _LOWERED:
                lowered += _LOWERED[text]
            elif text in _RAISED:
                raised += _RAISED[text]
            elif text == "*" and self._at(-1).text in ("ε", "γ"):
                lowered += "*"
            elif text in ("′", "″"):
                raised += r"\prime" * (1 + (text == "″"))
            elif text == "|" and self._at(1).text == "_":
                lowered += r"\vert " if lowered else ""
                return rf"{_script(lowered, raised)}\vert " + self._scripts_after_bar()
            elif text in ("^", "_"):
                found = self._braced()
                if found is None:
                    break
                raised, lowered = (raised + found, lowered) if text == "^" else (raised, found)
                continue
            else:
                break
            self.place += 1
        return _script(lowered, raised)

    def _scripts_after_bar(self) -> str:
        self.place += 1
        return self._scripts()

    def _braced(self) -> str | None:
        """Parse what follows ^ or _: braces, or a number, a letter, min or max."""
        start = self.place
        self.place += 1
        token = self._at()
        self.place += 1
        if token.kind in ("number", "letter"):
            return token.text
        if token.text in ("min", "max"):
            return _FUNCTIONS[token.text]
        if token.text == "{":
            inner = self._listed()
            if inner is not None and self._at().text == "}":
                self.place += 1
                return inner
        self.place = start
        return None


def _script(lowered: str, raised: str) -> str:
    below = f"_{{{lowered}}}" if lowered else ""
    return below + (f"^{{{raised}}}" if raised else "")


def _bare(latex: str) -> str:
    """The argument of a root, without the brackets that plain text needs."""
    depth = 0
    for n, c in enumerate(latex):
        depth += (c == "(") - (c == ")")
        if depth == 0:
            whole = n == len(latex) - 1 and latex[0] == "("
            return latex[1:-1] if whole else latex
    return latex
