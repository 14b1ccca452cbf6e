"""The table of published statements that fail, with what is true instead, for the site.

A line of docs/examples/published_errors.txt tells where a statement stands, the statement as it is
printed there, and what is true, for example

    Think DSP, trunk/book.tex:454 ;; cos(x + pi/2) == sin(x) ;; sin(x + pi/2) == cos(x)

Both are decided when the page is built: a statement that is not REFUTED, or a correction that does
not hold, is an error, because nobody shall be accused by hand.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from tresym.checking import check
from tresym.reals.decisions.answer import Answer
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict
from tresym.report.typesetting.markdown import escaped

LIST = Path("examples") / "published_errors.txt"


class Failure(NamedTuple):
    """A statement that fails: where it stands, as it is printed, and what is true."""

    section: str
    source: str
    printed: str
    true: str


def read(text: str) -> Iterator[Failure]:
    """Yield the statements of a list.

    Raises:
        InputError: a line has not three parts.
    """
    section = ""
    for line in text.splitlines():
        if line.startswith("## "):
            section = line[3:].strip()
        elif line.strip() and not line.startswith("#"):
            parts = [part.strip() for part in line.split(";;")]
            if len(parts) != 3:
                raise InputError(f"published errors: {line[:60]} has {len(parts)} parts, not 3")
            yield Failure(section, *parts)


def judged(one: Failure) -> tuple[Answer, Answer]:
    """Return the answers to what is printed and to what is true.

    Raises:
        InputError: what is printed is not REFUTED, or the correction does not hold.
    """
    printed, true = (check(claim) for claim in (one.printed, one.true))
    if printed.verdict is not Verdict.REFUTED or not true.verdict.holds:
        found = f"{printed.verdict.value} and {true.verdict.value}"
        raise InputError(f"published errors: {one.source}: {found}, not REFUTED and true")
    return printed, true


def page(docs: Path) -> str:
    """Return the lists in Markdown, each statement with its reason.

    Args:
        docs: the folder of the documents.
    """
    section, lines = "", []
    for one in read((docs / LIST).read_text(encoding="utf-8")):
        if one.section != section:
            section = one.section
            lines.append(f"### {section}\n")
        printed, true = judged(one)
        lines.append(
            f"- **{escaped(one.source)}**\\\n  `{one.printed}`\\\n"
            f"  REFUTED: {escaped(printed.why)}.\\\n  {true.verdict.value}: `{one.true}`\n"
        )
    return "\n".join(lines)
