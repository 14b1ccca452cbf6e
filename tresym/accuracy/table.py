"""Tables of certified numbers as text, Markdown, LaTeX, CSV or HTML.

A table is a value: a caption, column heads and rows of text. Every digit in it is proved by a ball
(an interval given by midpoint and radius).
"""

from __future__ import annotations

import re
from collections.abc import Callable
from html import escape
from itertools import zip_longest
from textwrap import wrap
from typing import NamedTuple

TERMINAL = 80
"""Width of a terminal in characters."""
HEAD = 12
"""Characters of a column head that are kept on one line, even if its cells are narrower."""
WIDEST = 90
"""Characters of a row that fit a page; a wider table is set sideways in LaTeX."""
FORMATS = ("text", "markdown", "latex", "csv", "html")
_RAISED = str.maketrans("0123456789-+", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺")
_NUMBER = re.compile(r"([-+]?\d+(?:\.\d+)?)(?:e([-+]?\d+))?( %)?")
_SPECIAL = re.compile(r"([\\`*_{}\[\]<>#|$~])")
_POWER = re.compile(r"\*\*(?:(\d+)(?!\d)|\((-?\d+)\))")
_NAMES = "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau"
_GREEK = dict(
    zip([*_NAMES.split(), "phi", "chi", "psi", "omega"], "αβγδεζηθικλμνξπρστφχψω", strict=True)
)
_LATEX = {
    "\\": r"\textbackslash{}", "~": r"\textasciitilde{}", "^": r"\textasciicircum{}",
    "−": "$-$", "∞": r"$\infty$",
    "≤": r"$\le$", "≥": r"$\ge$", "→": r"$\to$", "·": r"$\cdot$", "±": r"$\pm$",
} | {c: rf"\{c}" for c in "&%$#_{}"}  # fmt: skip
_LATEX |= {sign: rf"$\{name}$" for name, sign in _GREEK.items()} | {"ε": r"$\varepsilon$"}
Words = Callable[[str], str]
"""Converts plain text to the text of a format."""


class Table(NamedTuple):
    """A table: a caption, the heads of the columns, and rows of text of the same length."""

    caption: str
    heads: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    name: str = ""
    keys: int = 1
    """The number of columns at the left that identify a row."""


def raised(text: str) -> str:
    """Return a formula in signs of print: raised exponents, Greek letters, and no stars.

    Example:
        >>> raised("2*eps**3 + pi/sqrt(lambda_)")
        '2 ε³ + π/sqrt(λ)'
    """
    found = re.sub(r"\b[A-Za-z_]\w*\b(?!\()", lambda word: letter(word[0]), text)
    found = _POWER.sub(lambda n: (n[1] or n[2]).translate(_RAISED), found)
    return found.replace("**", "^").replace("*", " ")


def letter(name: str) -> str:
    """Return a name as it is printed: a Greek letter by its sign; other names unchanged.

    Example:
        >>> letter("lambda_"), letter("e")
        ('λ', 'e')
    """
    return _GREEK.get({"eps": "epsilon", "varepsilon": "epsilon"}.get(name, name.rstrip("_")), name)


def latex_text(text: str) -> str:
    """Return plain text in LaTeX; a character that text fonts lack becomes a question mark."""
    return "".join(_LATEX.get(c, c if ord(c) < 256 or c in "–—’“”" else "?") for c in text)


def markdown_text(text: str) -> str:
    """Return plain text as Markdown that looks the same."""
    return _SPECIAL.sub(r"\\\1", text)


def written(
    found: Table,
    form: str,
    latex_words: Words = latex_text,
    longest: int | None = None,
    caption: str | None = None,
) -> str:
    """Return a table in one of the :data:`FORMATS`.

    Args:
        found: the table.
        form: the format.
        latex_words: converts text to LaTeX.
        longest: characters of a number in LaTeX; a longer one is cut off and ends in dots.
        caption: the caption in the language of the format, for Markdown, LaTeX and HTML.
    """
    if form == "markdown":
        return _markdown(found, caption)
    if form == "csv":
        return _csv(found)
    if form == "html":
        return _html(found, caption)
    return _latex(found, latex_words, longest, caption) if form == "latex" else _text(found)


def _text(found: Table) -> str:
    """Plain text; a table wider than a terminal becomes blocks that repeat the first columns."""
    body = [*zip(*found.rows, strict=True)]
    heads = [_lines(h, max(map(len, cells))) for h, cells in zip(found.heads, body, strict=True)]
    widths = [max(map(len, (*h, *cells))) for h, cells in zip(heads, body, strict=True)]
    keys = [*range(found.keys)]
    blocks = [[*keys]]
    for column in range(found.keys, len(widths)):
        wide = sum(widths[n] + 2 for n in (*blocks[-1], column)) - 2
        if wide > TERMINAL and len(blocks[-1]) > len(keys):
            blocks.append([*keys])
        blocks[-1].append(column)
    joined = re.sub(r" (?=[<>=≤≥+−] )|(?<= [<>=≤≥+−]) ", "\xa0", found.caption)
    text = [line.replace("\xa0", " ") for line in wrap(joined, TERMINAL)]
    for block in blocks:
        above = zip_longest(*(heads[n] for n in block), fillvalue="")
        rows = [
            *above,
            ["─" * widths[n] for n in block],
            *zip(*(body[n] for n in block), strict=True),
        ]
        text.append("")
        for row in rows:
            cells = (c.ljust(widths[n]) for n, c in zip(block, row, strict=True))
            text.append("  ".join(cells).rstrip())
    return "\n".join([*text, ""])


def _lines(head: str, width: int) -> list[str]:
    """A column head, wrapped if it is wider than its cells."""
    return wrap(head, max(width, HEAD), break_long_words=False, break_on_hyphens=False)


def _markdown(found: Table, caption: str | None) -> str:
    rows = (map(_set, row) for row in found.rows)
    lines = [found.heads, tuple("---" for _ in found.heads), *rows]
    body = ["| " + " | ".join(row) + " |" for row in lines]
    return "\n".join([*body, "", f"*{caption or markdown_text(found.caption)}*", ""])


def _set(text: str) -> str:
    """A number with true minus signs and powers of ten; other text unchanged."""
    number = _NUMBER.fullmatch(text)
    if number is None:
        return text
    power = f"·10{number[2].translate(_RAISED)}" if number[2] else ""
    return f"{number[1].replace('-', '−')}{power}{number[3] or ''}"


def _latex(found: Table, words: Words, longest: int | None, caption: str | None) -> str:
    """LaTeX for a document that loads booktabs, array, graphicx, and rotating for wide tables.

    A table wider than the text is shrunk to fit.
    """

    def cell(text: str) -> str:
        number = _NUMBER.fullmatch(text)
        if number is None:
            return words(text)
        digits = number[1]
        if longest is not None and len(digits) > longest:
            digits = digits[:longest] + r"\dots"
        power = rf"\times 10^{{{int(number[2])}}}" if number[2] else ""
        return f"${digits}{power}${words(number[3] or '')}"

    head, *body = [" & ".join(map(cell, row)) + r" \\" for row in (found.heads, *found.rows)]
    columns = [
        _column(cells, longest or WIDEST) for cells in zip(found.heads, *found.rows, strict=True)
    ]
    kind = "sidewaystable" if sum(width for _, width in columns) > WIDEST else "table"
    return "\n".join(
        [
            rf"\begin{{{kind}}}\centering\small\setlength{{\tabcolsep}}{{4pt}}",
            rf"\caption{{{caption or words(found.caption)}}}\label{{tab:{found.name}}}\smallskip",
            rf"\sbox0{{\begin{{tabular}}{{@{{}}{''.join(kind for kind, _ in columns)}@{{}}}}",
            r"\toprule",
            head,
            r"\midrule",
            *body,
            r"\bottomrule",
            r"\end{tabular}}%",
            r"\ifdim\wd0>\linewidth\resizebox{\linewidth}{!}{\usebox0}\else\usebox0\fi",
            rf"\end{{{kind}}}",
            "",
        ]
    )


def _column(cells: tuple[str, ...], longest: int) -> tuple[str, int]:
    """The LaTeX column type and the width of a column; a head wider than its cells is wrapped."""
    head, *body = (min(len(text), longest) + 3 * ("e-" in text) for text in cells)
    widest = max(max(body, default=0), 7)
    if len(cells[0]) <= widest:
        return "l", max(head, widest)
    return rf">{{\raggedright\arraybackslash}}p{{{0.5 * widest:.1f}em}}", widest


def _csv(found: Table) -> str:
    import csv
    import io

    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(found.heads)
    writer.writerows(found.rows)
    return out.getvalue()


def _html(found: Table, caption: str | None) -> str:
    def row(cells: tuple[str, ...], tag: str) -> str:
        return "<tr>" + "".join(f"<{tag}>{escape(_set(c))}</{tag}>" for c in cells) + "</tr>"

    body = "\n".join(row(cells, "td") for cells in found.rows)
    return (
        f"<table>\n<caption>{caption or escape(found.caption)}</caption>\n"
        f"<thead>{row(found.heads, 'th')}</thead>\n<tbody>\n{body}\n</tbody>\n</table>\n"
    )
