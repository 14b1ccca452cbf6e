"""The documents of ``tresym derive`` without labels: article, slides, Markdown and notebook."""

from __future__ import annotations

import re
from importlib.resources import files

from tresym import release
from tresym.ledger.verification import Report
from tresym.report.pages import article, ledger_document, notebook, templates

ledger = ledger_document.ledger_document

SLIDES, NOTEBOOK = "teaching/slides", "teaching/notebook.md"
"""The templates of the slides and of the notebook."""
_CODE = re.compile(r"^```python\n(.*?)^```\n", re.DOTALL | re.MULTILINE)


def figures_of(style: str) -> tuple[str, ...]:
    """Return the names of the figures of a document."""
    if style == "beamer":
        return templates.figures_in(templates.text_of(SLIDES))
    return () if style == "jupyter" else article.figures_of()


def labels(style: str) -> tuple[str, ...]:
    """Return the labels of the claims that a document names."""
    if style in ("beamer", "jupyter"):
        name = SLIDES if style == "beamer" else NOTEBOOK
        return tuple(templates.expected(templates.text_of(name)))
    return article.labels()


def written(report: Report, style: str, where: str = "", folder: str = "") -> str:
    """Write a document.

    Args:
        report: verdicts on the claims of :func:`labels`, or on the whole ledger.
        style: ``article``, ``beamer``, ``markdown`` or ``jupyter``.
        where: where the ledger of the article is; see :data:`article.LEDGER`.
        folder: the folder of the figures, or an empty text for a document without figures.

    Raises:
        InputError: the text no longer fits the verdicts.
    """
    if style == "beamer":
        return _slides(report, bool(folder))
    if style == "jupyter":
        return _notebook(report)
    if style == "markdown":
        return article.in_markdown(report, folder)
    return article.article(report, where, bool(folder))


def _slides(report: Report, figures: bool) -> str:
    text = article.templates_of(report).filled(SLIDES)
    frame = files("tresym.report.pages").joinpath("slides.tex").read_text(encoding="utf-8")
    body = text if figures else article.without_figures(text)
    return frame.replace("{{ version }}", release.dated()).replace("{{ body }}", body)


def _notebook(report: Report) -> str:
    """The notebook: its text in cells of Markdown, and its programs in cells of code."""
    filled = article.templates_of(report).filled(NOTEBOOK)
    cells = []
    for n, part in enumerate(_CODE.split(filled)):
        if part.strip():
            cells.append(notebook.code(part.rstrip()) if n % 2 else notebook.text(part))
    return notebook.book(cells)
