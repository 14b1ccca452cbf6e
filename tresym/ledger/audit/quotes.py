"""Check that quotations from the paper match the lines they were taken from.

A quotation writes formulas in Unicode, so two things are compared: the hash of the quoted lines,
and the words and decimals of the quotation, which must occur in these lines in the same order.
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from tresym.ledger.audit.source import hash_of
from tresym.reals.numbers.exact import InputError

WORD = re.compile(r"[A-Za-z]{3,}|\d+\.\d+|\d{3,}")


@dataclass(frozen=True)
class Quote:
    """A quotation in a claim, and the lines it was taken from, identified by their hash."""

    label: str
    text: str
    line: int
    end: int
    sha256: str

    def line_in(self, paper: str) -> int | None:
        """Return the first of the quoted lines in a source, or None if they were altered.

        The lines may have moved together. If they occur twice, the occurrence nearest to the old
        place is taken.
        """
        lines, long = paper.split("\n"), self.end - self.line
        starts = sorted(range(1, len(lines) - long + 1), key=lambda n: abs(n - self.line))
        return next((n for n in starts if hash_of(lines[n - 1 : n + long]) == self.sha256), None)

    def lost(self, paper: str) -> str | None:
        """Return the first word of the quotation missing from its lines (in order), or None."""
        start = self.line_in(paper) or 1
        body = "\n".join(paper.split("\n")[start - 1 : start + self.end - self.line])
        words = iter(WORD.findall(body))
        return next((word for word in WORD.findall(self.text) if word not in words), None)


def load_quotes(path: Path, texts: Mapping[str, str]) -> tuple[Quote, ...]:
    """Return the quotations listed in the index, with the words that each claim quotes, by label.

    Raises:
        InputError: the index does not list the source lines of a claim's quotation.
    """
    data = json.loads(path.read_text(encoding="utf-8"))["quotes"]
    places = {item["label"]: item for item in data}
    missing = sorted(texts.keys() - places.keys())
    if missing:
        raise InputError(
            f"{path.name} does not list the source lines of the quotation in {missing[0]}"
        )
    return tuple(Quote(text=text, **places[label]) for label, text in texts.items())
