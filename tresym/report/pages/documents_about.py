"""The documents of ``tresym derive`` without labels: article, slides, Markdown and notebook."""

from __future__ import annotations

from tresym.ledger.verification import Report
from tresym.report.pages import article, ledger_document

ledger = ledger_document.ledger_document


def figures_of(style: str) -> tuple[str, ...]:
    """Return the names of the figures of a document."""
    return article.figures_of()


def labels(style: str) -> tuple[str, ...]:
    """Return the labels of the claims that a document names."""
    return article.labels()


def written(report: Report, style: str, where: str = "", folder: str = "") -> str:
    """Write a document.

    Args:
        report: verdicts on the claims of :func:`labels`, or on the whole ledger.
        style: ``article``, ``beamer``, ``markdown`` or ``jupyter``.
        where: where the ledger of the article is; see :data:`article.LEDGER`.
        folder: the folder of the figures, or an empty text for a document without figures.
    """
    return article.article(report, where, bool(folder))
