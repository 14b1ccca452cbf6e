"""Reports for machines: GitHub annotations, SARIF, JUnit; and the baseline of known problems.

A baseline lists the known problems, each by the file, the status and the LaTeX of its link. Line
numbers are not recorded, so the text before a problem may change. Sources: SARIF 2.1.0 (OASIS,
2020); the JUnit XML that CI systems read; GitHub's workflow commands.
"""

from __future__ import annotations

import hashlib
import json
from collections import Counter
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any
from xml.sax.saxutils import escape, quoteattr

from tresym.ledger.latex_source import read_text
from tresym.manuscript.deciding import Row
from tresym.reals.numbers.exact import InputError

FORMATS = ("text", "json", "github", "sarif", "junit")
PROBLEMS = ("REFUTED", "SUSPECT", "UNDECIDED", "UNREAD")
"""The statuses of problems, worst first."""
_LEVELS = {"REFUTED": "error", "SUSPECT": "warning"}
_RULES = {
    "REFUTED": "A formula is false at the point shown",
    "SUSPECT": "A formula fails as it was read; it may mean something else",
    "UNDECIDED": "A formula could not be decided",
    "UNREAD": "A formula could not be read",
}
_MOST = 1000
"""The maximal length of a message, in characters."""
_HEAD = "tresym baseline 1"


def place(row: Row, paper: Path) -> str:
    """Return the path of the file that contains a link, relative to the working directory."""
    file = row.link.display.file
    return (paper.parent / file if file else paper).as_posix()


def message(row: Row) -> str:
    """Return the message on a link, in one line."""
    parts = [row.link.read_as or " ".join(row.link.shown.split()), row.why]
    if row.witness:
        parts.append("at " + ", ".join(f"{name} = {value}" for name, value in row.witness.items()))
    parts += [f"true instead: {found}" for found in row.instead[:1]]
    return ": ".join(filter(None, parts))[:_MOST]


def fingerprint(row: Row, paper: Path) -> str:
    """Return the identifier of a problem: a hash of its file, status and LaTeX."""
    said = json.dumps([place(row, paper), row.status, " ".join(row.link.shown.split())])
    return hashlib.sha256(said.encode()).hexdigest()[:20]


def problems(rows: Iterable[Row], paper: Path) -> list[tuple[Row, str]]:
    """Return the problems with their fingerprints."""
    return [(row, fingerprint(row, paper)) for row in rows if row.status in PROBLEMS]


def baseline_text(found: Sequence[tuple[Row, str]]) -> str:
    """Return a baseline: one line per problem; only the fingerprint at its start is read."""
    lines = [
        f"{known} {row.status} {' '.join(row.link.shown.split())[:80]!a}" for row, known in found
    ]
    return "\n".join([_HEAD, *sorted(lines)]) + "\n"


def read_baseline(path: Path) -> Counter[str]:
    """Return how often each problem occurs in a baseline, by its fingerprint.

    Raises:
        InputError: the file is not a baseline.
    """
    head, *lines = read_text(path).splitlines() or [""]
    if head.strip() != _HEAD:
        raise InputError(f"{path}: not a baseline file of tresym; write one with --update-baseline")
    return Counter(line.split()[0] for line in lines if line.strip())


def new_since(found: Sequence[tuple[Row, str]], known: Counter[str]) -> list[Row]:
    """Return the problems that are not in a baseline, or occur more often than in it."""
    left = known.copy()
    result = []
    for row, mark in found:
        left[mark] -= 1
        if left[mark] < 0:
            result.append(row)
    return result


def report(kind: str, rows: Sequence[tuple[Row, Path]]) -> str:
    """Return the rows of manuscripts in a machine-readable format.

    Args:
        kind: ``github``, ``sarif`` or ``junit``.
        rows: the rows, each with its manuscript.
    """
    return {"github": _github, "sarif": _sarif, "junit": _junit}[kind](rows)


def _github(rows: Sequence[tuple[Row, Path]]) -> str:
    """Return workflow commands of GitHub, one per line."""
    lines = []
    for row, paper in rows:
        if row.status in PROBLEMS:
            level = _LEVELS.get(row.status, "notice")
            where = f"file={_property(place(row, paper))},line={max(row.link.display.line, 1)}"
            said = _data(message(row))
            lines.append(f"::{level} {where},title=tresym {row.status}::{said}\n")
    return "".join(lines)


def _data(text: str) -> str:
    return text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def _property(text: str) -> str:
    return _data(text).replace(":", "%3A").replace(",", "%2C")


def _sarif(rows: Sequence[tuple[Row, Path]]) -> str:
    """Return a SARIF log."""
    results: list[dict[str, Any]] = []
    for row, paper in rows:
        if row.status not in PROBLEMS:
            continue
        where = {
            "artifactLocation": {"uri": place(row, paper)},
            "region": {"startLine": max(row.link.display.line, 1)},
        }
        results.append(
            {
                "ruleId": row.status,
                "level": _LEVELS.get(row.status, "note"),
                "message": {"text": message(row)},
                "locations": [{"physicalLocation": where}],
                "partialFingerprints": {"tresym/v1": fingerprint(row, paper)},
            }
        )
    rules = [{"id": name, "shortDescription": {"text": said}} for name, said in _RULES.items()]
    driver = {"name": "tresym", "rules": rules}
    log = {
        "$schema": "https://json.schemastore.org/sarif-2.1.0.json",
        "version": "2.1.0",
        "runs": [{"tool": {"driver": driver}, "results": results}],
    }
    return json.dumps(log, indent=1, ensure_ascii=False) + "\n"


def _junit(rows: Sequence[tuple[Row, Path]]) -> str:
    """Return a JUnit report with one test case per link."""
    failed = skipped = 0
    cases = []
    for row, paper in rows:
        display = row.link.display
        name = f"line {display.line}, display {display.number}, link {row.link.number}"
        inside = ""
        if row.status in _LEVELS:
            failed += 1
            inside = (
                f"<failure type={quoteattr(row.status)}>{escape(_clean(message(row)))}</failure>"
            )
        elif row.status in PROBLEMS:
            skipped += 1
            inside = f"<skipped message={quoteattr(_clean(f'{row.status}: {message(row)}'))}/>"
        where = quoteattr(_clean(place(row, paper)))
        cases.append(
            f"<testcase classname={where} name={quoteattr(name)} time='{row.seconds:.3f}'>"
            f"{inside}</testcase>\n"
        )
    counts = f"tests='{len(cases)}' failures='{failed}' skipped='{skipped}'"
    return (
        f"<?xml version='1.0' encoding='UTF-8'?>\n<testsuite name='tresym' {counts}>\n"
        f"{''.join(cases)}</testsuite>\n"
    )


def _clean(text: str) -> str:
    """Replace the characters that XML cannot represent."""
    return "".join(c if c in "\t\n" or c.isprintable() else "?" for c in text)
