"""Sentences of ours as Markdown: what has a meaning there is escaped, exponents are raised."""

from __future__ import annotations

import re

from tresym.report.words.wording import readable

_SPECIAL = re.compile(r"([\\`*_{}\[\]<>#|$~])")
SCRIPTS = re.compile(r"(?<=\S)(?:\^\{([^{}]*)\}|\^(\d+)|_(min|max|D|f)(?!\w))")
"""What our sentences raise or lower: e^{−π}, ε*^2, ψ_min."""


def escaped(text: str) -> str:
    """Plain text as Markdown that reads the same."""
    return _SPECIAL.sub(r"\\\1", text)


def sentence(text: str) -> str:
    """A sentence with its exponents and indices raised and lowered, for any reader of Markdown."""
    parts, end = [], 0
    for found in SCRIPTS.finditer(text):
        raised, digits, lowered = found.groups()
        mark, inside = ("sub", lowered) if lowered else ("sup", raised or digits)
        parts += [escaped(text[end : found.start()]), f"<{mark}>{escaped(inside)}</{mark}>"]
        end = found.end()
    return "".join([*parts, escaped(text[end:])])


def finding(text: str) -> str:
    """What judging found, as a sentence."""
    return sentence(readable(text))
