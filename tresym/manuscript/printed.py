r"""Typeset a display as its author wrote it: MathML from its LaTeX, without a network.

``\frac{a}{b}`` is shown as a fraction although nothing of it was understood. The converter is
math-core, which comes with the extra ``html``; without it, or for LaTeX that it cannot read, the
caller shows the source itself.
"""

from __future__ import annotations

import re
from functools import cache
from typing import Any

from tresym.manuscript.source import Display

_IGNORED = re.compile(
    r"\\label\s*\{[^{}]*\}|\\tag\*?\s*\{[^{}]*\}|\\(?:nonumber|notag|displaybreak|allowdisplaybreaks)"
    r"(?![a-zA-Z])"
)
_BETWEEN = re.compile(r"\\(?:short)?intertext\s*\{((?:[^{}]|\{[^{}]*\})*)\}")
_IN_TEXT = re.compile(r"\\(?:text\w*|mbox|hbox)\s*\{[^{}]*\}")
_COLUMNS = re.compile(r"&\s*(=|<|>|\\[a-zA-Z]+)\s*&")
_ROWS = re.compile(r"\\\\|&")


@cache
def _converter() -> Any:
    try:
        from math_core import LatexToMathML
    except ImportError:
        return None
    return LatexToMathML(ignore_unknown_commands=True, fancy_error=False)


def as_mathml(display: Display) -> str:
    """Return a display as MathML; empty if it cannot be converted."""
    return _converted(display.kind, display.text)


def latex_as_mathml(latex: str, block: bool = True) -> str:
    """Return a formula in LaTeX as MathML; empty if it cannot be converted.

    Args:
        latex: the formula.
        block: whether it stands on a line of its own.
    """
    return _converted("", latex, block)


@cache
def _converted(kind: str, text: str, block: bool = True) -> str:
    text = " ".join(_IGNORED.sub(" ", text).split())
    text = re.sub(r"\\(begin|end)\s*\{split\}", r"\\\1{aligned}", text)
    text = _IN_TEXT.sub(lambda words: words[0].replace("$", " "), text)
    text = _BETWEEN.sub(lambda words: rf"\\ \text{{{words[1]}}} \\", text)
    converter = _converter()
    if converter is None or not text:
        return ""
    partly = ""
    for tex in _wrapped(kind.rstrip("*"), text):
        try:
            found = str(converter.convert_with_local_state(tex, displaystyle=block))
        except Exception:  # of a compiled library: the source is shown instead
            continue
        if "<merror" not in found:
            return found
        partly = partly or found  # an unknown command is shown by its name
    return partly


def _wrapped(kind: str, text: str) -> tuple[str, ...]:
    """Return the LaTeX in the environments in which it may be read, the likeliest first."""
    if not _ROWS.search(text):
        return (text,)
    if kind == "eqnarray":
        text = _COLUMNS.sub(r"&\1", text)
    aligned, gathered = (
        rf"\begin{{{name}}} {text} \end{{{name}}}" for name in ("aligned", "gathered")
    )
    return (aligned, text) if "&" in text else (gathered, aligned)
