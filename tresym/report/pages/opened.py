"""A file of claims as a Python object: verify it, and write its documents, tables and charts."""

from __future__ import annotations

import os

from tresym.accuracy.table import Table
from tresym.papers.reading import OwnPaper, read_file
from tresym.papers.verification import LIMIT, PaperReport, verify_paper
from tresym.reals.numbers.exact import InputError
from tresym.report.pages import own_paper, own_slides, own_tables
from tresym.report.pages.python_api import Picture


class OpenedPaper:
    """A file of claims.

    Attributes:
        path: the file.
        paper: what was read of it, with its ``claims``, ``definitions`` and ``problems``.
    """

    path: str
    paper: OwnPaper

    def __init__(self, path: str | os.PathLike[str]) -> None:
        """Read the file.

        Raises:
            InputError: there is no such file, or it is not text.
        """
        self.path = os.fspath(path)
        self.paper = read_file(self.path)

    def verify(self, *labels: str, limit: float = LIMIT) -> PaperReport:
        """Decide the claims of these labels and what they use; all claims without labels.

        Args:
            labels: the claims.
            limit: the seconds for each claim.

        Raises:
            InputError: a label that no claim has.
        """
        return verify_paper(self.paper, labels, limit)

    def derive(self, *labels: str, style: str = "article") -> str:
        """Write the document of the file, or the claims of these labels to paste into a text.

        Args:
            labels: the claims; the whole document without labels.
            style: ``article`` (LaTeX), ``markdown``, ``html`` or ``jupyter``; without labels also
                ``beamer``, for slides.

        Raises:
            InputError: a label that no claim has, or a claim that is refuted unexpectedly.
        """
        if style not in own_paper.STYLES and (labels or style != "beamer"):
            raise InputError(f"the styles are {', '.join(own_paper.STYLES)}, and beamer for all")
        report = self.verify(*labels)
        if not labels:
            tables, _ = ({}, ()) if style == "jupyter" else own_tables.all_tables(self.paper, style)
            pictures = own_paper.Pictures(tables)
            if style == "beamer":
                return own_slides.slides(report, pictures)
            return own_paper.document(report, style, pictures)
        rows = [report[label] for label in dict.fromkeys(labels)]
        if refused := own_paper.refused(rows):
            raise InputError("; ".join(refused))
        return own_paper.fragments(report, rows, style)

    def table(self, label: str) -> Table:
        """Compute the table of errors that the file asks for of a claim.

        Raises:
            InputError: no claim has the label, the file asks for no table of it, or the points do
                not fit.
        """
        return own_tables.tables_of(self.paper, label)[0]

    def chart(self, label: str, path: str | os.PathLike[str] | None = None) -> Picture:
        """Draw the error of a claim against the variable of its path.

        Args:
            label: the claim.
            path: where to save it as well; the ending (.svg, .pdf, .png) says in which format.

        Raises:
            InputError: no claim has the label, it has no errors, or matplotlib is not installed.
        """
        if path is not None:
            from tresym.output import write_bytes
            from tresym.report.figures import kind_of

            target = os.fspath(path)
            write_bytes(target, own_tables.chart(self.paper, label, kind_of(target)))
        return Picture(own_tables.chart(self.paper, label))

    def __repr__(self) -> str:
        read, problems = len(self.paper.claims), len(self.paper.problems)
        wrong = f", {problems} lines not read" if problems else ""
        return f"OpenedPaper({self.path}: {read} claims{wrong})"


def open(path: str | os.PathLike[str]) -> OpenedPaper:
    """Open a file of claims.

    Args:
        path: the file, which usually ends in ``.tresym``.

    Raises:
        InputError: there is no such file, or it is not text. Lines that cannot be read raise
            nothing; they are listed in ``paper.problems``.

    Example:
        >>> import pathlib, tempfile, tresym
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     path = pathlib.Path(folder) / "paper.tresym"
        ...     _ = path.write_text("x real; given x > 0\\nlarger: exp(x) > 1 + x")
        ...     tresym.open(path).verify()["larger"].verdict.value
        'PROVED'
    """
    return OpenedPaper(path)
