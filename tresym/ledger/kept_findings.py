"""What the evidence of a claim showed before, kept in the user's cache folder.

    with kept_findings() as kept:
        kept.get("eq_gamma")             # None, or the finding of an earlier run
        kept.put("eq_gamma", finding)

`tresym verify` judges each claim's own evidence, which takes a minute for the racket paper; the
second time it reads what it found. A finding is found again only by the same code, the same
libraries and the same files of the paper, byte by byte. What a claim rests on is judged anew each
time, by :func:`tresym.ledger.judge.judge`, and nothing is read under `verify --full`. What is
printed as JSON follows from the claims and the findings, and is kept as well.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any

from flint import fmpq

from tresym.checking.cache_folder import version
from tresym.checking.kept_rows import Rows, cache_file
from tresym.ledger.finding import RULINGS, Finding, StepFinding
from tresym.reals.numbers.exact import Decimal
from tresym.reals.verdict import Verdict

_WORDS = {ruling.value: ruling for ruling in RULINGS}
_TEXTS = ("why", "region", "parameter", "seconds", "stopped", "boxes", "along")
_NUMBERS = ("value", "constant")


class KeptFindings:
    """The findings on the claims of the paper in a folder; without a file, none."""

    def __init__(self, rows: Rows | None, folder: Path) -> None:
        self._rows = rows
        self._paper = _hash_of(folder) if rows is not None else b""

    def get(self, label: str) -> Finding | None:
        """The finding on the claim's own evidence, or None."""
        text = self._rows and self._rows.get(self._key(label))
        return _finding(text) if text else None

    def put(self, label: str, finding: Finding) -> None:
        """Keep a finding; not one with conditions, which are no text, and not what is open."""
        if self._rows is None or finding.conditions or finding.verdict is Verdict.UNDECIDED:
            return
        self._rows.put(self._key(label), _text(finding))

    def text(self, report: Iterable[tuple[str, Finding]], made: Callable[[], str]) -> str:
        """The text that follows from these findings, by label: the one that is kept, or made now.

        How long judging took is no part of what is looked up.
        """
        if self._rows is None:
            return made()
        told = [f"{label} {_text(replace(found, seconds=0))}" for label, found in report]
        key = self._key("\n".join(told))
        text = self._rows.get(key)
        if text is None:
            self._rows.put(key, text := made())
        return text

    def _key(self, label: str) -> bytes:
        return hashlib.sha256(version() + self._paper + label.encode()).digest()


@contextmanager
def kept_findings(folder: Path | None, wanted: bool = True) -> Iterator[KeptFindings]:
    """Inside, the findings on the paper of a folder are read from the user's cache and kept there.

    Args:
        folder: where the files of the paper stand; None keeps nothing.
        wanted: False to find everything anew.
    """
    path = cache_file() if wanted and folder is not None else None
    rows = Rows(path) if path is not None else None
    try:
        yield KeptFindings(rows, folder or Path())
    finally:
        if rows is not None:
            rows.close()


def _hash_of(folder: Path) -> bytes:
    """A hash of what a paper's claims can depend on: its modules and the data beside them."""
    found = hashlib.sha256()
    kinds = {".py", ".tresym", ".json", ".txt", ".notes"}
    files = (p for p in folder.rglob("*") if p.suffix in kinds)
    for path in sorted(files):
        text = path.read_bytes()
        found.update(f"{path.relative_to(folder)}\0{len(text)}\0".encode() + text)
    return found.digest()


def _text(finding: Finding) -> str:
    whole: dict[str, Any] = {name: getattr(finding, name) for name in _TEXTS}
    whole |= {name: _fields(getattr(finding, name)) for name in _NUMBERS}
    whole |= {"verdict": finding.verdict.value, "trees": finding.trees}
    whole["follows_from"] = finding.follows_from
    whole["steps"] = [(step.verdict.value, step.why, step.seconds) for step in finding.steps]
    if finding.witness is not None:
        whole["witness"] = {k: [int(v.p), int(v.q)] for k, v in finding.witness.items()}
    return json.dumps(whole)


def _fields(number: Decimal | None) -> dict[str, Any] | None:
    return None if number is None else number._asdict()


def _finding(text: str) -> Finding | None:
    """The finding of a row, or None if it cannot be read."""
    try:
        read = json.loads(text)
        plain: dict[str, Any] = {name: read[name] for name in _TEXTS}
        plain |= {k: read[k] and Decimal(**read[k]) for k in _NUMBERS}
        witness = read.get("witness")
        return Finding(
            verdict=_WORDS[read["verdict"]],
            steps=tuple(StepFinding(Verdict(v), why, took) for v, why, took in read["steps"]),
            trees=tuple(read["trees"]),
            follows_from=tuple(read["follows_from"]),
            witness=None if witness is None else {k: fmpq(*v) for k, v in witness.items()},
            **plain,
        )
    except (ValueError, TypeError, KeyError):
        return None
