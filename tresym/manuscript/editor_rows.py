"""The rows of a manuscript that stands in an editor, as JSON on standard output.

A process of its own for each look at the text, so that the editor never waits and an outdated look
can be ended: ``python -m tresym.manuscript.editor_rows`` reads one JSON value from standard input.
What was decided before comes from the cache, so that only displays that changed are decided.
"""

from __future__ import annotations

import json
import os
import sys
from pathlib import Path
from typing import Any

from tresym.checking.answer_cache import cached_answers
from tresym.manuscript.deciding import Row, decided
from tresym.manuscript.links import read_links
from tresym.manuscript.settings import settings_for, with_settings
from tresym.manuscript.source import read_manuscript
from tresym.manuscript.suspects import proofread
from tresym.papers.editor_rows import claims_file_rows
from tresym.reals.language.expression import symbols
from tresym.reals.language.readings import in_latex
from tresym.reals.numbers.exact import InputError
from tresym.reals.processes import end_with_parent

MOST_KINDS = 12
"""Symbols of a link whose kinds are shown at most."""


def editor_rows(path: Path, text: str, limit: float) -> list[dict[str, Any]]:
    """The rows of a manuscript, with what an editor offers for them.

    Raises:
        InputError: the text cannot be read as a manuscript.
    """
    events = with_settings(read_manuscript(path, text=text), settings_for(path.parent))
    with cached_answers():
        rows = proofread(decided(read_links(events), limit))
    counts: dict[int, int] = {}
    for row in rows:
        number = row.link.display.number
        counts[number] = counts.get(number, 0) + 1
    return [_value(row, counts[row.link.display.number] == 1) for row in rows]


def _value(row: Row, alone: bool) -> dict[str, Any]:
    """A row with the LaTeX of what is true instead, where its display says nothing else."""
    latex = [in_latex(found.claim) for found in row.instead if alone and not found.given]
    names = (
        sorted(symbols(row.link.sides[0]) | symbols(row.link.sides[2])) if row.link.sides else []
    )
    return row.as_json() | {
        "replacements": [one for one in latex if one],
        "symbols": [name for name in names if name != "oo"][:6],
        "kind": row.link.display.kind,
        "kinds": [f"{name}: {kind}" for name, kind, _ in row.link.symbols][:MOST_KINDS],
    }


def _tell(row: dict[str, Any]) -> None:
    print(json.dumps({"row": row}), flush=True)


def main() -> int:
    """Answer the question on standard input: rows as they are known, and last all of them."""
    end_with_parent(os.getppid())
    asked = json.loads(sys.stdin.buffer.read())
    answer: dict[str, Any]
    try:
        path, limit = Path(asked["path"]), float(asked["limit"])
        if path.suffix == ".tresym":
            rows = claims_file_rows(path.name, asked["text"], limit, path.parent, _tell)
        else:
            rows = editor_rows(path, asked["text"], limit)
        answer = {"rows": rows}
    except InputError as error:
        answer = {"error": str(error)}
    print(json.dumps(answer))
    return 0


if __name__ == "__main__":
    sys.exit(main())
