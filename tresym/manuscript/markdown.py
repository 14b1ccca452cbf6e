r"""A Markdown page as LaTeX, line by line, so that the places of formulas stay the same.

``## Second example`` becomes a section, which ends what was said of letters before it, as it would
in LaTeX; ``**Example 2.**`` becomes a bold heading. Code is left out, but a block that is marked as
``math`` is a display, and one such as ``{admonition}`` or ``{exercise}`` of MyST is text. A percent
sign is no comment, except of ``% tresym: ...`` and ``<!-- tresym: ... -->``, which are directives.
In a table ``\|`` is a bar. Of a Jupyter notebook the Markdown cells are read, at the lines of its
file where it has a line for each line of a cell.
"""

from __future__ import annotations

import json
import re

from tresym.reals.numbers.exact import InputError

MAX_BETWEEN = 5000
"""Lines of a notebook's file between two of its Markdown cells, to keep the places."""
SUFFIXES = frozenset((".md", ".markdown", ".mdx", ".rmd", ".qmd"))
_FENCE = re.compile(r"\s*(?:>\s*)*(```+|~~~+)")
_MATH = re.compile(r"\s*(?:>\s*)*(```+|~~~+|:::+)\s*(?:math|\{math\})\s*(\S*)\s*$")
"""The first line of a block of mathematics: of GitHub, and of MyST, which may name it."""
_DIRECTIVE_BLOCK = re.compile(r"\s*(?:>\s*)*(```+|~~~+)\s*\{([a-zA-Z:-]+)\}\s*(.*?)\s*$")
_SCOPED = {
    "example": "example",
    "exercise": "exercise",
    "solution": "solution",
    "proof": "proof",
    **dict.fromkeys(("theorem", "lemma", "proposition", "corollary"), "theorem"),
}
"""Blocks of MyST that are environments in LaTeX."""
_OF_TEXT = frozenset(
    (
        *("admonition", "note", "tip", "hint", "important", "warning", "caution", "attention"),
        *("danger", "error", "seealso", "dropdown", "margin", "sidebar", "topic", "card", "toggle"),
        *("details", "tab-item", "tab-set", "grid", "grid-item", "grid-item-card", "definition"),
        *("remark", "callout", "axiom", "conjecture", "observation", "property", "algorithm"),
        *_SCOPED,
    )
)
"""Blocks of MyST that hold text, not code."""
_OPTION = re.compile(r"\s*:[\w-]+:")
_LABELLED = re.compile(r"\s*:(label|name|nowrap|class|number|width):\s*(.*?)\s*$")
_HEADING = re.compile(r"(#{1,6})\s+(.*?)\s*#*\s*$")
_DIRECTIVE = re.compile(r"\s*<!--\s*(tresym:.*?)\s*-->\s*$")
_BOLD = re.compile(r"(\s*(?:[-*+]\s+|\d+\.\s+)?)\*\*([^*$]{1,80})\*\*")
_QUOTED = re.compile(r"(?:\s{0,3}>\s?)+")
_PERCENT = re.compile(r"(?<!\\)%(?!\s*tresym:)")


def is_markdown(suffix: str) -> bool:
    """Whether files with this suffix are Markdown."""
    return suffix.lower() in SUFFIXES


def as_latex(text: str) -> str:
    """Return a page as LaTeX with the same lines."""
    lines = text.split("\n")
    result: list[str] = []
    fence = math = ""
    blocks: list[tuple[str, str]] = []  # open blocks of text: their fences and environments
    options = False
    header = lines[:1] == ["---"]
    for n, line in enumerate(lines):
        if header:  # of the page, with its title and the like
            header = n == 0 or line.strip() not in ("---", "...")
            result.append("")
            continue
        if math:
            if line.strip().lstrip("> ") == math:
                math, line = "", "\\]"
            elif option := _LABELLED.match(line):
                line = f"\\label{{{option[2]}}}" if option[1] in ("label", "name") else ""
            result.append(_QUOTED.sub("", line, count=1))
            continue
        if not fence and (block := _MATH.match(line)):
            math = block[1]
            result.append("\\[")
            continue
        mark = _FENCE.match(line)
        found = None if fence else _DIRECTIVE_BLOCK.match(line)
        name = found[2].rpartition(":")[2] if found else ""
        if found and name in _OF_TEXT:
            scope = _SCOPED.get(name, "")
            blocks.append((found[1], scope))
            result.append(rf"\begin{{{scope}}}" if scope else _line(found[3]))
            options = True
            continue
        options = options and bool(_OPTION.match(line))
        if options:
            result.append("")
            continue
        if blocks and not fence and line.strip().lstrip("> ") == blocks[-1][0]:
            _, scope = blocks.pop()
            result.append(rf"\end{{{scope}}}" if scope else "")
            continue
        if fence or (mark and mark[1]):
            if not fence and mark:
                fence = mark[1]
            elif mark and mark[1].startswith(fence):
                fence = ""
            result.append("")
            continue
        result.append(_line(line))
    return "\n".join(result)


def _line(line: str) -> str:
    if found := _DIRECTIVE.match(line):
        return f"% {found[1]}"
    line = _QUOTED.sub("", line, count=1) if _QUOTED.match(line) else line
    if found := _HEADING.match(line):
        title = found[2].replace("{", "").replace("}", "")
        title = _PERCENT.sub(r"\\%", title)
        return rf"\{'section' if len(found[1]) < 3 else 'subsection'}{{{title}}}"
    if line.lstrip().startswith("|"):
        line = line.replace("\\|", "|")
    line = _BOLD.sub(r"\1\\textbf{\2}", line, count=1)
    return _PERCENT.sub(r"\\%", line)


def markdown_cells(text: str, name: str) -> str:
    """Return the text of the Markdown cells of a notebook, each with an empty line behind it.

    Raises:
        InputError: it is no notebook, or cut off.
    """
    try:
        cells = json.loads(text)["cells"]
        pages = ["".join(one["source"]) for one in cells if one["cell_type"] == "markdown"]
    except (ValueError, KeyError, TypeError, RecursionError):
        raise InputError(f"{name}: is no notebook of Jupyter, or a damaged one") from None
    rows = text.split("\n")
    result: list[str] = []
    at = 0
    for page in pages:
        for line in page.split("\n"):
            starts = (
                f'"{json.dumps(line)[1:-1]}',
                f'"{json.dumps(line, ensure_ascii=False)[1:-1]}',
            )
            near = range(at, min(at + MAX_BETWEEN, len(rows))) if line else ()
            place = next((n for n in near if rows[n].lstrip().startswith(starts)), -1)
            if place >= len(result):
                result += [""] * (place - len(result))
                at = place + 1
            result.append(line)
        result.append("")
    return "\n".join(result)
