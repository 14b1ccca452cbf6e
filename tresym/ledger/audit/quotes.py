"""Check that quotations from the paper match the lines they were taken from.

A quote writes formulas in letters of its own, so that two things are compared: the hash of the
lines, and the words and decimals of the quote, which stand in them in their order.
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
    """Words of the paper that a claim quotes, and the lines they were taken from, by their hash."""

    label: str
    text: str
    line: int
    end: int
    sha256: str

    def line_in(self, paper: str) -> int | None:
        """The first of the lines in a source, where they may have moved together; None if altered.

        Lines that are there twice are those nearest to where they were.
        """
        lines, long = paper.split("\n"), self.end - self.line
        starts = sorted(range(1, len(lines) - long + 1), key=lambda n: abs(n - self.line))
        return next((n for n in starts if hash_of(lines[n - 1 : n + long]) == self.sha256), None)

    def lost(self, paper: str) -> str | None:
        """The first word of the quote that does not stand in its lines, in this order; or None."""
        start = self.line_in(paper) or 1
        body = "\n".join(paper.split("\n")[start - 1 : start + self.end - self.line])
        words = iter(WORD.findall(body))
        return next((word for word in WORD.findall(self.text) if word not in words), None)


def load_quotes(path: Path, texts: Mapping[str, str]) -> tuple[Quote, ...]:
    """The quotes of the index beside the proofs, with what each claim quotes, by its label.

    Raises:
        InputError: a claim quotes words, and the index does not say from where.
    """
    data = json.loads(path.read_text(encoding="utf-8"))["quotes"]
    places = {item["label"]: item for item in data}
    missing = sorted(texts.keys() - places.keys())
    if missing:
        raise InputError(f"{path.name} does not say where the quote of {missing[0]} was taken from")
    return tuple(Quote(text=text, **places[label]) for label, text in texts.items())
