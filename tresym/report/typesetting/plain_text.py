r"""Write formulas as plain Unicode text, for a terminal.

``\frac{a}{b}`` becomes a/b. An exponent becomes superscript characters if Unicode has them, else it
is marked with ``^``.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator

from tresym.report.typesetting.formula_width import argument

_TOKEN = re.compile(r"\\[A-Za-z]+\*?|\\.|.", re.DOTALL)
_SIGNS = {
    r"\le": "≤", r"\ge": "≥", r"\ne": "≠", r"\to": "→", r"\iff": "⟺", r"\in": "∈", r"\cdot": "·",
    r"\times": "×", r"\pm": "±", r"\mp": "∓", r"\infty": "∞", r"\partial": "∂", r"\int": "∫",
    r"\exists": "∃", r"\vert": "|", r"\quad": " ", r"\qquad": " ", r"\,": "", r"\ ": " ",
    "-": "−", r"\{": "{", r"\}": "}", r"\!": "", r"\;": " ", r"\\": "; ",
    r"\sum": "Σ", r"\land": "and", r"\wedge": "and", r"\simeq": "≃", r"\sim": "∼",
    r"\alpha": "α", r"\beta": "β", r"\gamma": "γ", r"\delta": "δ", r"\epsilon": "ε",
    r"\theta": "θ", r"\kappa": "κ", r"\lambda": "λ", r"\mu": "μ", r"\nu": "ν", r"\xi": "ξ",
    r"\pi": "π", r"\rho": "ρ", r"\sigma": "σ", r"\tau": "τ", r"\phi": "φ", r"\chi": "χ",
    r"\psi": "ψ", r"\omega": "ω", r"\Delta": "Δ", r"\Phi": "Φ", r"\Psi": "Ψ", r"\Omega": "Ω",
    r"\Theta": "Θ", r"\min": "min", r"\max": "max", r"\top": "ᵀ", r"\varphi": "φ",
}  # fmt: skip
_RAISED = str.maketrans("0123456789+-−n*", "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁻ⁿ*")
_LOWERED = str.maketrans("0123456789+-−", "₀₁₂₃₄₅₆₇₈₉₊₋₋")
_OVER = {r"\dot": "\u0307", r"\vec": "\u20d7", r"\hat": "\u0302", r"\ddot": "\u0308"}
_KEPT = frozenset([r"\mathrm", r"\mathsf", r"\mathtt", r"\text", r"\operatorname", r"\mathbf"])
_SPACED = re.compile(r"(?<=[^\s(\[])\s*([=<>≤≥≠⟺→∼≃])\s*")
_PRODUCT = re.compile(r"[\s+\-−·/=<>]|(?<=\w)\(")


_ONE = re.compile(r"[d∂]?[^\W\d][₀-₉⁰¹²³⁴-⁹]*")
"""A letter or differential, with an index or an exponent."""


def plain(formula: str) -> str:
    r"""Return LaTeX of our printer as plain text.

    Example:
        >>> plain(r"\frac{a}{b}")
        'a/b'
    """
    text = _plain(_TOKEN.findall(re.sub(r"\\(?:left|right|[Bb]igg?[lr]?)\b\.?|~", "", formula)))
    text = re.sub(r"\s+", " ", _SPACED.sub(r" \1 ", text)).strip()
    text = re.sub(r"(?<=[(\[]) | (?=[)\]])", "", text)
    return unicodedata.normalize("NFC", text)


_BREAKS = re.compile(r"(?<=[^\s±])(?= [^±])|(?<=[\w)\]])(?=[+−])|(?<=\))(?=[(/·])")
"""Where a line may end: before a space, a sign of a sum or a factor, never within a number."""


def in_lines(text: str, first: str, later: str, columns: int) -> Iterator[str]:
    """Wrap a sentence or formula in plain text to lines of at most ``columns`` characters.

    Args:
        text: the text.
        first: the beginning of the first line.
        later: the beginning of the other lines.
        columns: the width. A part without a place to break stays whole.
    """
    line, empty = first, True
    for piece in _BREAKS.split(text):
        if not empty and len(line) + len(piece) > columns:
            yield line
            line, empty = later, True
        line += piece.lstrip() if empty else piece
        empty = False
    yield line


def _plain(tokens: list[str]) -> str:
    text = ""
    while tokens:
        token = tokens.pop(0)
        if token == r"\frac":
            above, below = _plain(argument(tokens)), _plain(argument(tokens)).strip()
            simple = below.isdigit() or _ONE.fullmatch(below)
            text += f"{_enclosed(above)}/{below if simple else _bracketed(below)}"
        elif token == r"\sqrt":
            text += "√" + _enclosed(_plain(argument(tokens)))
        elif token in ("^", "_"):
            text += script(token, _plain(argument(tokens)))
        elif token == "{":
            tokens.insert(0, token)
            text += _plain(argument(tokens))
        elif token in _OVER:
            while tokens[:1] == [" "]:
                tokens.pop(0)
            text += _plain(argument(tokens)) + _OVER[token]
        elif token in _KEPT:
            text += _plain(argument(tokens)).replace("−", "-")
        elif token == r"\begin":
            text += "(" if argument(tokens) else ""
        elif token == r"\end":
            text += ")" if argument(tokens) else ""
        elif token in _SIGNS:
            text += _SIGNS[token]
        elif token.startswith("\\") and token[1:].isalpha():
            text += (" " if text[-1:].isalnum() else "") + token[1:] + " "
        elif token == "&":
            text += " "
        elif token != "}":
            text += token
    return re.sub(r"(?<=[a-z]) (?=[\^(⁰¹²³⁴⁵⁶⁷⁸⁹])", "", text)


def _enclosed(text: str) -> str:
    text = text.strip()
    return _bracketed(text) if _PRODUCT.search(text) else text


def _bracketed(text: str) -> str:
    return f"({text})"


def script(mark: str, text: str) -> str:
    """Return ``text`` as superscript (^) or subscript (_) characters, if there are such."""
    text = text.strip()
    letters = _RAISED if mark == "^" else _LOWERED
    if all(ord(c) in letters for c in text):
        return text.translate(letters)
    if text in ("ᵀ", "T") and mark == "^":
        return "ᵀ"
    return mark + (text if len(text) == 1 or (mark == "_" and text.isalnum()) else f"({text})")
