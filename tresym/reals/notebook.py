"""Display values: one line in a terminal, a table in notebooks."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from html import escape

LONGEST = 160
"""The maximal number of characters of a line."""
LONGEST_NUMBER = 60
"""The maximal number of digits of a number that text output shows in full."""
_LONG_NUMBER = re.compile(rf"\d{{{LONGEST_NUMBER + 1},}}")


def in_one_line(text: str) -> str:
    """Return ``text`` on one line, truncated if it is long."""
    line = " ".join(text.split())
    return line if len(line) <= LONGEST else line[: LONGEST - 1] + "…"


def abbreviated(text: str) -> str:
    """Return ``text`` with the middle digits of very long numbers left out.

    Example:
        >>> abbreviated(f"x > 1/{10**99}")
        'x > 1/1000000000…[80 digits]…0000000000'
    """
    return _LONG_NUMBER.sub(
        lambda found: f"{found[0][:10]}…[{len(found[0]) - 20} digits]…{found[0][-10:]}", text
    )


def html_table(
    head: str,
    rows: Iterable[tuple[str, ...]],
    shown: Callable[[str, str], str] = lambda name, text: escape(text),
) -> str:
    """Return HTML with a heading in bold and a small table of text below it.

    Args:
        head: the heading.
        rows: the cells of each row, the first of which is its name.
        shown: returns a cell in HTML, from the name of its row and its text.
    """
    lines = (
        "".join(f"<td style='text-align:left'>{shown(row[0], cell)}</td>" for cell in row)
        for row in rows
    )
    return f"<b>{escape(head)}</b><table>{''.join(f'<tr>{line}</tr>' for line in lines)}</table>"
