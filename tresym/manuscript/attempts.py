"""Ask what each link claims: a short look at everything first, then a long one where it helps.

A link may be read in several ways, tried in order until one passes. One that takes long and comes
to nothing would keep the others waiting, so each is asked with a short limit first. What was
stopped is asked again with the full limit, unless another way has passed.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import TypeAlias

from tresym.checking.time_limited import Task, check_all
from tresym.manuscript.classification import Link
from tresym.reals.decisions.answer import Answer
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Cause, Verdict

SHORT = 1.0
"""Seconds for each attempt in the first round."""
AGAIN = 1
"""The attempts at a link that are repeated with the full limit."""
MOST_AGAIN = 8
"""The links that are asked again: where more were stopped, the full limit rarely decides one."""
MOST_SPENT = 1.0
"""Short limits that all attempts at a link may take together before the others are left out."""
INTERRUPTED = "not decided: interrupted; run again to continue"
Found: TypeAlias = dict[int, list[Answer | InputError]]
Check: TypeAlias = Callable[..., Iterator[tuple[Task, Answer | InputError]]]


def answers_to(
    links: Sequence[Link],
    limit: float,
    processes: int | None,
    progress: Callable[[int, int], None],
    keep: bool = False,
) -> Found:
    """Return the answers to the attempts at each link, up to the first that passes.

    Args:
        limit: seconds for each attempt.
        processes: how many to use; None for one per core.
        progress: called with the number of links done and their total.
        keep: after Ctrl-C, return what is done; the rest is UNDECIDED.
    """
    answers: Found = {}
    asked = [n for n, link in enumerate(links) if link.claims]
    finished: set[int] = set()
    try:
        _first(links, asked, min(limit, SHORT), processes, answers, finished, progress)
        if limit > SHORT:
            _again(links, asked, limit, processes, answers)
    except KeyboardInterrupt:
        if not keep:
            raise
        for n in {*asked} - finished:  # links with attempts that are not decided
            answers[n] = [Answer(Verdict.UNDECIDED, INTERRUPTED, cause=Cause.INTERRUPTED)]
    return answers


def _first(
    links: Sequence[Link],
    open_: list[int],
    limit: float,
    processes: int | None,
    answers: Found,
    finished: set[int],
    progress: Callable[[int, int], None],
) -> None:
    """Decide the candidate readings of each link in turn, each with a short time limit."""
    total, attempt = len(open_), 0
    while open_:
        tasks = [Task(links[n].claims[attempt].text, line=n) for n in open_]
        again = []
        for n, (_, found) in zip(open_, check_all(tasks, limit, processes), strict=True):
            answers.setdefault(n, []).append(found)
            more = attempt + 1 < len(links[n].claims)
            most = (
                3 * MOST_SPENT if links[n].solves is not None else MOST_SPENT
            )  # roots have branches
            more = more and _spent(answers[n]) < most * limit
            if more and not isinstance(found, InputError) and not found:
                again.append(n)
            else:
                finished.add(n)
            progress(len(finished), total)
        open_, attempt = again, attempt + 1


def _again(
    links: Sequence[Link],
    asked: Sequence[int],
    limit: float,
    processes: int | None,
    answers: Found,
) -> None:
    """Repeat stopped attempts with the full limit, at links where no attempt has passed."""
    places = {n: _stopped(answers[n])[:AGAIN] for n in asked if _may_be_told(links[n])}
    if sum(map(bool, places.values())) > MOST_AGAIN:
        return
    while open_ := {n: left.pop(0) for n, left in places.items() if left}:
        tasks = [Task(links[n].claims[attempt].text, line=n) for n, attempt in open_.items()]
        for (n, attempt), (_, found) in zip(
            open_.items(), check_all(tasks, limit, processes), strict=True
        ):
            answers[n][attempt] = found
            if found and not isinstance(found, InputError):
                del answers[n][attempt + 1 :]
                places[n] = []


def _spent(found: Sequence[Answer | InputError]) -> float:
    """Return the processor time that the attempts at a link took."""
    return sum(answer.seconds for answer in found if isinstance(answer, Answer))


def _may_be_told(link: Link) -> bool:
    """Whether a link is likely a claim, for which more time may help; not an equation."""
    return link.same or link.firm or link.solves is not None or link.otherwise[0] == "UNDECIDED"


def _stopped(found: Sequence[Answer | InputError]) -> list[int]:
    """Return the attempts at a link that ran out of time, if none has passed."""
    read = [(n, answer) for n, answer in enumerate(found) if isinstance(answer, Answer)]
    if any(answer for _, answer in read):
        return []
    return [n for n, answer in read if answer.cause is Cause.STOPPED]
