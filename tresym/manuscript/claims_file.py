"""Write what was read of a manuscript as a file of claims, for its author to complete.

``tresym paper M.tex --claims M.tresym`` writes one line for each link of each display: a definition
for a link that is DEFINED, and a claim with its conditions and its path for the others. What a file
of claims cannot say, such as an equation to be solved or a link that was not read, becomes a
comment with its LaTeX. The result is read once more: a line that is no statement of such a file
becomes a comment too.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from tresym.manuscript.deciding import Row
from tresym.papers.reading import RESERVED, read_paper
from tresym.reals.language.expression import symbols

ROUNDED = " to the digits printed"
_QUIET = ("DEFINED", "ASSUMED", "EQUATION", "UNREAD")
_WORDS = re.compile(r"[^A-Za-z0-9]+")


def claims_text(rows: Iterable[Row], name: str) -> str:
    """Return the file of claims of a manuscript.

    Args:
        rows: the links of its displays with their statuses.
        name: the name of the manuscript.
    """
    lines = list(_lines(rows, name))
    for problem in reversed(read_paper("\n".join(lines)).problems):
        line = lines[problem.line - 1]
        lines[problem.line - 1] = f"% {line}"
        lines.insert(problem.line - 1, f"% not a statement of such a file: {problem.message}")
    return "\n".join(lines) + "\n"


def _lines(rows: Iterable[Row], name: str) -> Iterator[str]:
    yield f"# {name}"
    yield "% Read from the displays of the manuscript; complete it, and run tresym verify on it."
    used: set[str] = set()
    labels: set[str] = set()
    display = 0
    for row in rows:
        link = row.link
        if link.display.number != display:
            display = link.display.number
            yield ""
            yield f"% line {link.display.line}"
        said = link.read_as
        left = link.sides[0] if link.sides else None
        names = symbols(link.sides[0]) | symbols(link.sides[2]) if link.sides else frozenset()
        if row.status in _QUIET or not said:
            own = str(left.args[0]) if left is not None and left.op == "symbol" else ""
            right = said.partition(" == ")[2].partition(" given ")[0].partition(" as ")[0]
            new = own and own not in used and own not in RESERVED and own not in _right(row)
            if row.status == "DEFINED" and new and right and " == " not in right:
                yield f"{own} := {right}"
            else:
                latex = " ".join((link.shown or str(said) or link.display.text).split())
                yield f"% {row.status}: {said or latex}"[:2000]
            used |= names
            continue
        used |= names
        label = _label(row, labels)
        labels.add(label)
        if row.status in ("REFUTED", "SUSPECT"):
            yield f"% {row.status}: {' '.join(row.why.split())}"[:2000]
        if ROUNDED in said:
            said = said.replace(ROUNDED, "").replace(" == ", " ~= ", 1)
        yield f"{label}: {said}"


def _right(row: Row) -> frozenset[str]:
    return symbols(row.link.sides[2]) if row.link.sides else frozenset()


def _label(row: Row, taken: set[str]) -> str:
    """A label from that of the display, or from its number; one for each link."""
    display = row.link.display
    stem = _WORDS.sub("_", display.labels[0]).strip("_") if display.labels else ""
    stem = stem if stem[:1].isalpha() else f"display_{display.number}"
    label, number = stem, 2
    while label in taken:
        label, number = f"{stem}_{number}", number + 1
    return label
