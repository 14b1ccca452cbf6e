"""The rows of a file of claims that stands in an editor, in the form of those of a manuscript."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from tresym.papers.reading import OwnPaper, PaperClaim, read_paper
from tresym.papers.verification import Row, verify_paper

UNREADABLE = "UNREADABLE"
EXPECTED = "EXPECTED"
"""The statuses of a line that is not read, and of a claim that is refuted as the file expects."""


def claims_file_rows(
    name: str,
    text: str,
    limit: float,
    folder: Path | None = None,
    on_row: Callable[[dict[str, Any]], None] = lambda row: None,
) -> list[dict[str, Any]]:
    """Return a row for each line that cannot be read, each definition and each claim.

    Args:
        name: the name of the file.
        text: its text.
        limit: the seconds for each claim.
        folder: where the files are that it uses.
        on_row: is called with the row of each claim as soon as it is decided.
    """
    paper = read_paper(text, name, folder)
    rows = _unread(paper, text)
    report = verify_paper(paper, limit=limit, on_row=lambda row: on_row(_of_verdict(row)))
    return [*rows, *(_of_verdict(row) for row in report.rows)]


def unread_rows(name: str, text: str, folder: Path | None = None) -> list[dict[str, Any]]:
    """Return the rows of the lines that cannot be read, which are known before any verdict."""
    return _unread(read_paper(text, name, folder), text)


def _unread(paper: OwnPaper, text: str) -> list[dict[str, Any]]:
    lines = text.split("\n")
    return [
        _row(problem.line, UNREADABLE, problem.message, lines[problem.line - 1].strip())
        for problem in paper.problems
    ]


def _of_verdict(row: Row) -> dict[str, Any]:
    answer, item = row.decisive, row.item
    refuted = row.verdict.value == "REFUTED"
    status = EXPECTED if refuted and row.as_expected else row.verdict.value
    read_as = "; ".join(item.meanings) if isinstance(item, PaperClaim) else ""
    return _row(item.line, status, row.why, item.text) | {
        "read_as": read_as,
        "witness": dict(answer.witness) if answer is not None and answer.witness else None,
        "instead": [one._asdict() for one in row.instead],
    }


def _row(line: int, status: str, why: str, text: str) -> dict[str, Any]:
    return {
        "line": line,
        "status": status,
        "why": why,
        "latex": text,
        "read_as": "",
        "witness": None,
        "instead": [],
        "file": None,
        "kind": "claim",
        "kinds": [],
        "replacements": [],
        "symbols": [],
    }
