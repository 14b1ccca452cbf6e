"""The commands table, figure, derive and paper as Python functions."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

from tresym.reals.numbers.exact import InputError

if TYPE_CHECKING:
    from tresym.accuracy.table import Table
    from tresym.manuscript.deciding import Row


class Picture(bytes):
    """The bytes of an SVG file; a notebook shows them as a picture."""

    def _repr_svg_(self) -> str:
        return self.decode()

    def _repr_html_(self) -> str:
        return self.decode()

    def __repr__(self) -> str:
        return f"Picture({len(self)} bytes of SVG)"


def table(name: str) -> Table:
    """Compute a table of certified numbers.

    Args:
        name: objects, errors, constants, slope, thresholds or routes.

    Returns:
        The caption, the column heads and the rows as text.

    Raises:
        InputError: there is no table of that name.

    Example:
        >>> import tresym
        >>> len(tresym.table("constants").rows) > 3
        True
    """
    from tresym.ledger.paper import racket

    found: Table = racket().tables().table(name)
    return found


def derive(*labels: str) -> str:
    r"""Write the derivation of claims, or the whole article, in LaTeX.

    Args:
        labels: the claims, such as ``"eq_gamma"``; none means the article.

    Returns:
        LaTeX to paste into a document, or, without labels, a complete document.

    Raises:
        InputError: a label that no claim has, or a claim that is refuted.

    Example:
        >>> import tresym
        >>> r"\label{tresym:eq_gamma}" in tresym.derive("eq_gamma")
        True
    """
    from tresym.ledger.verification import verify
    from tresym.report.pages import derivation, fragments
    from tresym.report.pages.article import article
    from tresym.report.pages.article import labels as named

    report = verify(labels or named())
    if not labels:
        return article(report)
    asked = [report[label] for label in dict.fromkeys(labels)]
    refused = derivation.refused(asked)
    if refused:
        raise InputError("; ".join(refused))
    return fragments.written(asked, "article")


def paper(path: str | os.PathLike[str], limit: float = 5.0) -> list[Row]:
    """Check the displays of a manuscript.

    Args:
        path: its LaTeX source.
        limit: seconds for each claim.

    Returns:
        A row for each link of each display, with ``status``, ``why`` and ``witness``.

    Raises:
        InputError: the file cannot be read.

    Example:
        >>> import pathlib, tempfile, tresym
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     source = pathlib.Path(folder) / "paper.tex"
        ...     _ = source.write_text("For all real $x$: $$ (x+1)^2 = x^2 + 2x + 1. $$")
        ...     [row.status for row in tresym.paper(source)]
        ['PROVED']
    """
    from tresym.manuscript.deciding import decided
    from tresym.manuscript.links import read_links
    from tresym.manuscript.source import read_manuscript

    return decided(read_links(read_manuscript(Path(path))), limit)
