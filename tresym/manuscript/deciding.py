"""The status of every link: what is left open by reading is decided, many at once."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

from tresym.manuscript.classification import EQUATION, UNREAD, Link
from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.time_limited import Task, check_all
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict

STATUSES = (*(v.value for v in Verdict), "DEFINED", "ASSUMED", EQUATION, UNREAD)


@dataclass(frozen=True)
class Row:
    """A link and its status.

    Attributes:
        witness: for REFUTED, names to exact numbers.
    """

    link: Link
    status: str
    why: str
    witness: dict[str, str] | None = None
    given: str = ""
    seconds: float = 0.0

    def as_json(self) -> dict[str, Any]:
        """A JSON value; every key is always there."""
        display = self.link.display
        return {
            "display": display.number,
            "line": display.line,
            "file": display.file or None,
            "label": display.labels[0] if display.labels else None,
            "link": self.link.number,
            "read_as": self.link.read_as,
            "status": self.status,
            "why": self.why,
            "witness": self.witness,
            "latex": self.link.shown,
            "seconds": round(self.seconds, 6),
        }


def decided(
    links: Sequence[Link],
    limit: float,
    processes: int | None = None,
    progress: Callable[[int, int], None] = lambda done, total: None,
) -> list[Row]:
    """A row for each link; each claim is asked for at most ``limit`` seconds."""
    answers: dict[int, list[Answer | InputError]] = {}
    open_ = [n for n, link in enumerate(links) if link.claims]
    total, done, attempt = len(open_), 0, 0
    while open_:
        tasks = [Task(links[n].claims[attempt].text, line=n) for n in open_]
        again = []
        for n, (_, found) in zip(open_, check_all(tasks, limit, processes), strict=True):
            answers.setdefault(n, []).append(found)
            if (
                attempt + 1 < len(links[n].claims)
                and not isinstance(found, InputError)
                and not found
            ):
                again.append(n)
            else:
                done += 1
            progress(done, total)
        open_, attempt = again, attempt + 1
    return [_row(link, answers.get(n, [])) for n, link in enumerate(links)]


def _row(link: Link, answers: list[Answer | InputError]) -> Row:
    if not answers:
        return Row(link, link.status, link.why)
    read = [answer for answer in answers if isinstance(answer, Answer)]
    if not read:
        return Row(link, UNREAD, str(answers[0]))
    counted = [n for n, answer in enumerate(read) if answer or link.claims[n].may_fail] or [0]
    last, asked = read[counted[-1]], link.claims[counted[-1]]
    seconds = sum(answer.seconds for answer in read)
    how = asked.how
    if last:
        link = replace(link, read_as=asked.read_as)
    why = f"{last.why}; {how}" if how else last.why
    witness = dict(last.witness) if last.witness is not None else None
    row = Row(link, last.verdict.value, why, witness, last.given, seconds)
    if last:
        return row
    if last.verdict is Verdict.REFUTED and link.firm:
        return row
    status, fallback = link.otherwise
    if last.verdict is Verdict.REFUTED:
        if (not link.same and status != "UNDECIDED") or status == "DEFINED":
            return replace(row, status=status, why=fallback, witness=None)
        at = ", ".join(f"{k} = {v}" for k, v in (witness or {}).items())
        where = f"it does not hold at {at or 'the constants'}"
        advice = "if it is meant for all values, write % tresym: claim before the display"
        if status == "UNDECIDED":
            return replace(row, status=status, why=f"{where}; {advice}", witness=None)
        return replace(row, status=status, why=f"{fallback}; {where}: {advice}", witness=None)
    if status == "DEFINED" or link.unknown:
        return replace(row, status=status, why=fallback)
    return row
