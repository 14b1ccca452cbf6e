"""Where the claims of a paper are written: the file of each claim and its lines.

Example: the claim ``eq_gamma`` of the racket paper is written in ``euler_angles.py``; its lines are
those of the statement ``eq_gamma = Claim(…)``. A claim that a function makes from a row of data,
such as a cell of a table, has the lines of the statement that makes it.
"""

from __future__ import annotations

import ast
import re
from functools import cache
from typing import NamedTuple

from tresym.ledger.paper import Paper, racket


class Lines(NamedTuple):
    """A range of lines in a file of the proofs, counted from 1, both ends included."""

    file: str
    first: int
    last: int


@cache
def lines_of_claims() -> dict[str, Lines]:
    """Return the lines of each claim of the racket paper, by label."""
    return _lines_of(racket())


def _lines_of(paper: Paper) -> dict[str, Lines]:
    found: dict[str, Lines] = {}
    for module, (_, claims) in zip(paper.modules, paper.parts(), strict=True):
        path = paper.source_of(module)
        text = path.read_text(encoding="utf-8")
        statements = _statements(text) if path.suffix == ".py" else _lines_of_text(text)
        for claim in claims:
            first, last = _of_claim(claim.label, statements)
            found[claim.label] = Lines(path.name, first, last)
    return found


def _lines_of_text(text: str) -> list[tuple[str, int, int]]:
    """The statements of a file of claims, each with the lines that follow without an empty one."""
    lines = text.splitlines()
    begin = [n for n, line in enumerate(lines) if line and not line[0].isspace() and line[0] != ">"]
    found = []
    for n in begin:
        end = next((m for m in range(n + 1, len(lines)) if m in begin or not lines[m]), len(lines))
        said = "\n".join(lines[n:end]).removeprefix("let ").removeprefix("assume ")
        found.append((said, n + 1, end))
    return found


def _statements(text: str) -> list[tuple[str, int, int]]:
    """The statements at the top level of a file, each with its first and last line."""
    lines = text.splitlines()
    return [
        ("\n".join(lines[node.lineno - 1 : node.end_lineno]), node.lineno, node.end_lineno or 0)
        for node in ast.parse(text).body
    ]


def _of_claim(label: str, statements: list[tuple[str, int, int]]) -> tuple[int, int]:
    """The lines of the statement that names a claim; failing that, those of the whole file."""
    name = re.escape(label)
    for pattern in (rf"^{name}\b.*[=:]", rf"label=\"{name}\"", rf"\b{name}\b"):
        for text, first, last in statements:
            if re.search(pattern, text, re.MULTILINE):
                return first, last
    for text, first, last in statements:
        several = re.match(r"(\w+) = ", text)
        if (several and label.startswith(f"{several[1]}_")) or "label=" in text:
            return first, last
    return 1, statements[-1][2]
