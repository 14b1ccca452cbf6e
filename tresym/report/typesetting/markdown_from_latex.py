"""Convert the LaTeX of the article's text to Markdown, for pages that tell the same things.

Only what the templates of the article use is converted: paragraphs, emphasis, formulas, verdict
marks, and references, which become links or are left out.
"""

from __future__ import annotations

import re
from collections.abc import Callable

_MATHS = re.compile(
    r"(?:\\inmargin\{\w+\}\{\w\}\{[^{}]*\})?\\begin\{(equation|gather)(\*?)\}(?:\\label\{[^}]*\})?"
    r"(?P<shown>.*?)\\end\{\1\2\}|\$(?P<inline>[^$]+)\$",
    re.DOTALL,
)
_MARK = re.compile(r"\\raised\{(\w+)\}\{(\w)\}")
_WORDS = (
    (r"\\noindent\s*", ""),
    (r"\\(?:emph|textit)\{([^{}]*)\}", r"*\1*"),
    (r"\\(?:paragraph|textbf)\{([^{}]*)\}", r"**\1**"),
    (r"\\(?:sub)*section\*?\{([^{}]*)\}(?:\\label\{[^}]*\})?", r"## \1"),
    (r"\\texttt\{([^{}]*)\}", r"`\1`"),
    (r"\s*\\cite\{[^}]*\}", ""),
    (r"\s*\((?:Section|Figure|Theorem)~\\ref\{[^}]*\}\.?\)", ""),
    (r"\s*\\eqref\{[^}]*\}", ""),
    (r"\\label\{[^}]*\}", ""),
    (r"\\,\\%|\s*\\%", " %"),
    (r"\\,", " "),
    (r"~", " "),
    (r"\\(?=[_&#])", ""),
)
"""What a text is converted by, in this order: a pattern and what replaces it."""


def markdown_from_latex(text: str, mark: Callable[[str, str], str]) -> str:
    """Return a text of the article in Markdown.

    Args:
        text: LaTeX, with every placeholder filled in.
        mark: writes the mark of a verdict, from the label of a claim and a letter.
    """
    done, at = [], 0
    for found in _MATHS.finditer(text):
        done += [_worded(text[at : found.start()], mark), _formula(found)]
        at = found.end()
    joined = "".join([*done, _worded(text[at:], mark)])
    return re.sub(r"\n{3,}", "\n\n", re.sub(r" +\n", "\n", joined)).strip() + "\n"


def _formula(found: re.Match[str]) -> str:
    inline = found["inline"]
    if inline is not None:
        return f"${' '.join(inline.split())}$"
    shown = found["shown"].strip().removesuffix(",").removesuffix(".")
    return f"\n$$\n{shown}\n$$\n"


def _worded(text: str, mark: Callable[[str, str], str]) -> str:
    for pattern, instead in _WORDS:
        text = re.sub(pattern, instead, text)
    return _MARK.sub(lambda found: mark(found[1], found[2]), text)
