"""Write sentences in Markdown: escape special characters and set formulas."""

from __future__ import annotations

import re
from collections.abc import Callable

from tresym.report.typesetting.finding_text import readable
from tresym.report.typesetting.formulas import pieces

_SPECIAL = re.compile(r"([\\`*_{}\[\]<>#|$~])")
_SCRIPTS = re.compile(r"(?<=\S)([\^_])(?:\{([^{}]*)\}|(\d+|min\b|max\b|D\b|f\b))")
"""Superscripts and subscripts in sentences: e^{−π}, ε*^2, ψ_min, ε|_{γ = 0}."""


def escaped(text: str) -> str:
    """Return plain text as Markdown that looks the same."""
    return _SPECIAL.sub(r"\\\1", text)


def scripted(text: str, letters: Callable[[str], str], script: Callable[[str, str], str]) -> str:
    """Return a sentence with its superscripts and subscripts converted.

    Args:
        text: the sentence.
        letters: converts ordinary text.
        script: converts a superscript (``^``) or subscript (``_``), given the mark and its text.
    """
    parts, end = [], 0
    for found in _SCRIPTS.finditer(text):
        mark, braced, bare = found.groups()
        parts += [letters(text[end : found.start()]), script(mark, braced or bare)]
        end = found.end()
    return "".join([*parts, letters(text[end:])])


def sentence(text: str) -> str:
    """Return a sentence in Markdown, with formulas between dollars and names as code."""

    def script(mark: str, inside: str) -> str:
        tag = "sup" if mark == "^" else "sub"
        return f"<{tag}>{escaped(inside)}</{tag}>"

    def words(part: str) -> str:
        return scripted(part, escaped, script)

    return "".join(
        f"`{p.text}`" if p.code else f"${p.latex.strip()}$" if p.latex else words(p.text)
        for p in pieces(text)
    )


def finding(text: str) -> str:
    """Return a finding as a sentence in Markdown."""
    return sentence(readable(text))
