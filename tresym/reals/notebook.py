"""Display values: one line in a terminal, a table in notebooks."""

from __future__ import annotations

from collections.abc import Iterable
from html import escape

LONGEST = 160
"""Characters of a line at most."""


def in_one_line(text: str) -> str:
    """``text`` on one line, its end left out where it is long."""
    line = " ".join(text.split())
    return line if len(line) <= LONGEST else line[: LONGEST - 1] + "…"


def html_table(head: str, rows: Iterable[tuple[str, ...]]) -> str:
    """A heading in bold, and a small table of text under it."""
    lines = (
        "".join(f"<td style='text-align:left'>{escape(cell)}</td>" for cell in row) for row in rows
    )
    return f"<b>{escape(head)}</b><table>{''.join(f'<tr>{line}</tr>' for line in lines)}</table>"
