"""The status of every link: what is left open by reading is decided, many at once."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

from tresym.manuscript import accusations
from tresym.manuscript.classification import EQUATION, UNREAD, Attempt, Link
from tresym.manuscript.context import names_in
from tresym.reals.decisions.answer import Alternative, Answer
from tresym.reals.decisions.time_limited import Task, check_all, check_within
from tresym.reals.language.binders import elementary
from tresym.reals.language.expression import ONE, ZERO, Expr, symbols
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict

STATUSES = (*(v.value for v in Verdict), "SUSPECT", "DEFINED", "ASSUMED", EQUATION, UNREAD)


@dataclass(frozen=True)
class Row:
    """A link and its status.

    Attributes:
        witness: for REFUTED and SUSPECT, names to exact numbers.
        instead: for these, claims close to it that hold.
        refuted: what fails, in the grammar of text; empty where nothing does.
        put: the values of its symbols that were put in.
        fails_at: where, whatever the status.
    """

    link: Link
    status: str
    why: str
    witness: dict[str, str] | None = None
    given: str = ""
    seconds: float = 0.0
    instead: tuple[Alternative, ...] = ()
    refuted: str = ""
    put: tuple[tuple[str, Expr], ...] = ()
    fails_at: dict[str, str] | None = None

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
            "instead": [found._asdict() for found in self.instead],
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
    found = ((link, answers.get(n, [])) for n, link in enumerate(links))
    return [_failing(_row(link, own, limit), own) for link, own in found]


def _failing(row: Row, answers: list[Answer | InputError]) -> Row:
    """The row with what of its link is refuted, whatever its status, and where.

    It is the last way to ask that needs no definition of another paragraph.
    """
    pairs = [*zip(row.link.claims, answers, strict=False)]
    for asked, answer in reversed(pairs):
        failed = isinstance(answer, Answer) and answer.verdict is Verdict.REFUTED
        if isinstance(answer, Answer) and failed and asked.may_fail and not asked.far:
            at = None if answer.witness is None else dict(answer.witness)
            text = asked.plain or asked.text
            return replace(row, refuted=text, put=asked.put, fails_at=at)
    return row


def _restates(link: Link, asked: Attempt) -> str:
    """Why nothing was shown by an equality whose sides are the same, where it is no more."""
    one, _, other = asked.sides or (ZERO, "", ONE)
    if one != other:
        return ""
    if not asked.how:
        left, equal, right = link.shown.partition(" = ")
        bare = bool(equal) and left.split() == right.split()
        why = "both sides are read as the same expression, so there is nothing to check"
        return why if bare or (symbols(one) and link.ground.alike) else ""
    lone = next((s for s in (link.sides or ())[::2] if str(s) in link.ground.places), None)
    place = link.ground.places[str(lone)] if lone is not None else 0
    return f"restates {f'line {place}' if place else f'what {lone} stands for'}" if lone else ""


def _refuted(link: Link, answers: list[Answer | InputError]) -> tuple[Attempt, Answer] | None:
    """The last way to ask that rests on nothing said elsewhere, if all are refuted."""
    found = None
    for asked, answer in zip(link.claims, answers, strict=False):
        if isinstance(answer, Answer) and asked.may_fail:
            if answer.verdict is not Verdict.REFUTED:
                return None
            if not asked.far and (asked.same or link.ground.explicit or asked.sides is None):
                found = asked, answer
    return found


def _needed(link: Link) -> str:
    """Why a refutation that rests on what is said elsewhere is not reported."""
    far = dict.fromkeys(name for asked in link.claims for name in asked.far)
    if not far:
        return "other readings of it are not refuted"
    return f"{', '.join(far)} is defined in another paragraph (% tresym: from LABEL uses it)"


def _doubt(link: Link, asked: Attempt, limit: float) -> str:
    """Why a refutation is not reported as a falsehood of the text; empty where it is."""
    if link.ground.doubts:
        return link.ground.doubts[0]
    if asked.sides is None or link.ground.explicit or " as " in asked.text:
        return ""
    point = accusations.holds_elsewhere(asked.sides, asked.given)
    if point is not None:
        at = ", ".join(f"{name} = {value}" for name, value in point.items())
        return f"it holds at {at}: a condition may be missing"
    bound = names_in(asked.given) | names_in([asked.sides]) & {*"ABC"}
    free = sorted(names_in([asked.sides]) - bound - accusations.NO_VARIABLES)
    if free and not elementary(asked.sides[0], asked.sides[2]):
        signs = ", ".join(f"{name} > 0" for name in free)
        joint = ", " if " given " in asked.text else " given "
        text = f"{asked.text}{joint}{signs}"
        if check_within(Task(text), limit).verdict is not Verdict.REFUTED:
            return f"it is not refuted where {signs}: a condition may be missing"
    return ""


def _row(link: Link, answers: list[Answer | InputError], limit: float) -> Row:
    if not answers:
        status, why = (link.status, link.why) if link.status else link.otherwise
        return Row(link, status, why)
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
        same = _restates(link, asked)
        return replace(row, status="DEFINED", why=same) if same else row
    status, fallback = link.otherwise
    if last.verdict is Verdict.REFUTED and link.firm:
        failed = _refuted(link, answers)
        doubt = "" if failed else _needed(link)
        if failed is not None:
            asked, last = failed
            doubt = _doubt(link, asked, limit)
            witness = dict(last.witness) if last.witness is not None else None
            why = f"{last.why}; {asked.how}" if asked.how else last.why
            row = Row(link, last.verdict.value, why, witness, last.given, seconds)
        if not doubt:
            return replace(row, link=replace(link, read_as=asked.read_as))
        if status != "DEFINED":
            status, fallback = "UNDECIDED", ""
        at = ", ".join(f"{k} = {v}" for k, v in (witness or {}).items())
        why = fallback or f"not reported as false, for {doubt}; it fails at {at or 'the constants'}"
        return replace(row, status=status, why=why, witness=None)
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
