"""The status of every link: what is left open by reading is decided, many at once."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

from tresym.manuscript.classification import EQUATION, UNREAD, Link
from tresym.manuscript.instances import instances
from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.time_limited import Task, check_all
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict

PASSES = (Verdict.PROVED.value, Verdict.ENCLOSED.value)
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
    asked = [*links, *(link.second for link in links if link.second is not None)]
    answers = _answers(asked, limit, processes, progress)
    rows = [_row(link, answers.get(n, [])) for n, link in enumerate(asked)]
    rows = _varied(rows, answers, limit, processes)
    found = [(row, answers.get(n, [])) for n, row in enumerate(rows)]
    seconds = iter(found[len(links) :])
    return [
        row if link.second is None else _of_both((row, own), next(seconds))
        for link, (row, own) in zip(links, found[: len(links)], strict=True)
    ]


def _answers(
    links: Sequence[Link],
    limit: float,
    processes: int | None,
    progress: Callable[[int, int], None],
) -> dict[int, list[Answer | InputError]]:
    """The answers to the attempts at each link, up to the first that passes."""
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
    return answers


def _varied(
    rows: list[Row],
    answers: dict[int, list[Answer | InputError]],
    limit: float,
    processes: int | None,
) -> list[Row]:
    """The rows, but for passes of which an instance is refuted."""
    tasks: list[Task] = []
    told: list[tuple[int, str]] = []
    for n, row in enumerate(rows):
        passed = len(answers.get(n, [])) - 1
        if row.status not in PASSES or passed < 0:
            continue
        attempt = row.link.claims[passed]
        if attempt.sides is None or "(" in attempt.under:
            continue
        for text, values in instances(attempt.sides, row.link.constants):
            told.append((n, values))
            tasks.append(Task(text + attempt.under, line=n))
    if tasks:
        for (n, values), (_, found) in zip(told, check_all(tasks, limit, processes), strict=True):
            if isinstance(found, Answer) and found.verdict is Verdict.REFUTED:
                why = f"it was taken to be proved, but fails with {values}: please report it"
                rows[n] = replace(rows[n], status=Verdict.UNDECIDED.value, why=why)
    return rows


def _of_both(
    first: tuple[Row, list[Answer | InputError]], second: tuple[Row, list[Answer | InputError]]
) -> Row:
    """The row of a link that can be read in two ways: a status where both have it, else UNREAD."""
    (one, _), (other, _) = first, second
    if one.status in PASSES and other.status in PASSES:
        weaker = max((one, other), key=lambda row: PASSES.index(row.status))
        both = f"in both readings of print, {one.link.read_as} and {other.link.read_as}"
        return replace(weaker, why=f"{weaker.why}; {both}")
    told = " and ".join(
        f"{row.link.read_as} is {_verdict(found)}" for row, found in (first, second)
    )
    return replace(one, status=UNREAD, why=f"two readings remain: {told}", witness=None)


def _verdict(answers: list[Answer | InputError]) -> str:
    """The best verdict of several attempts at one reading."""
    read = [answer for answer in answers if isinstance(answer, Answer)]
    best = next((answer for answer in read if answer), read[0] if read else None)
    return best.verdict.value if best is not None else "not read"


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
    why = re.sub(r"\bfn_", "", f"{last.why}; {how}" if how else last.why)
    witness = None
    if last.witness is not None:
        witness = {name.removeprefix("fn_"): value for name, value in last.witness.items()}
    row = Row(link, last.verdict.value, why, witness, last.given, seconds)
    if last:
        return row
    uncounted = [n for n in sorted(link.counted) if not (witness or {}).get(n, "1").isdecimal()]
    if last.verdict is Verdict.REFUTED and link.firm and not uncounted:
        return row
    status, fallback = link.otherwise
    if last.verdict is Verdict.REFUTED and link.firm:
        at = ", ".join(f"{name} = {(witness or {})[name]}" for name in uncounted)
        why = f"it fails at {at}, but {', '.join(uncounted)} numbers things elsewhere"
        return replace(row, status="UNDECIDED", why=why, witness=None)
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
