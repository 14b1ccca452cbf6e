"""Decide claims in processes of their own, each with a limit on processor time.

The limit counts the time of the claim's own process, so that the verdict does not depend on what
else the machine does. An answer that was stopped says nothing of the claim and is not stored.
"""

from __future__ import annotations

import pickle
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import BrokenExecutor, Future
from contextlib import ExitStack
from dataclasses import replace
from itertools import islice
from typing import Any, NamedTuple, Protocol

from tresym.checking.dispatch import decide_claim
from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.statement import Statement
from tresym.reals.language.readings import read_as
from tresym.reals.numbers.exact import InputError
from tresym.reals.processes import AHEAD, Processes, StoppedError, cores
from tresym.reals.verdict import Cause, Verdict

DEFAULT_LIMIT = 5.0
_DIED = "the process ended unexpectedly, perhaps because it ran out of memory"
_BOXES = ("inequality", "branch and bound")
"""Stages at which smaller ranges of the variables help."""


class Task(NamedTuple):
    """A claim to decide; ``line`` is where it stands in a file."""

    claim: Any
    given: Any = ""
    path: str | None = None
    line: int | None = None


class Cache(Protocol):
    """Where answers are looked up and kept, such as the file of the user's cache."""

    def get(self, claim: Any, given: Any, path: str | None, limit: float) -> Answer | None:
        """Return the answer to a claim, or None."""

    def put(self, claim: Any, given: Any, path: str | None, limit: float, answer: Answer) -> None:
        """Keep an answer."""


CACHES: list[Cache] = []
"""The caches in use, innermost last; a run that uses none loads no database."""


def current_cache() -> Cache | None:
    """Return the cache of answers that is in use, if any."""
    return CACHES[-1] if CACHES else None


def check_within(task: Task, limit: float = DEFAULT_LIMIT) -> Answer:
    """Decide one claim in at most ``limit`` seconds of processor time.

    Raises:
        InputError: the claim cannot be read.
    """
    for _, found in check_all([task], limit, 1):
        if isinstance(found, InputError):
            raise found
        return found
    raise RuntimeError("a task has no answer")


def check_all(
    tasks: Iterable[Task],
    limit: float = DEFAULT_LIMIT,
    processes: int | None = None,
    *,
    forked: bool = True,
) -> Iterator[tuple[Task, Answer | InputError]]:
    """Yield every task with its answer or its error, in the order of the tasks.

    Args:
        tasks: the claims; a few are read ahead.
        limit: seconds of processor time for each claim.
        processes: the number of processes; all cores unless given.
        forked: whether the processes are forks of this one, which then must have a single thread.
    """
    cache = current_cache()
    under_way: deque[tuple[Task, Answer | Future[Any]]] = deque()
    with ExitStack() as stack:
        pool: Processes | None = None
        for task in tasks:
            asked: Answer | Future[Any] | None = (
                cache.get(*task[:3], limit) if cache is not None else None
            )
            if asked is None:
                pool = pool or stack.enter_context(
                    Processes(processes or cores(), limit, deaths=1, forked=forked)
                )
                asked = next(pool.in_order(_judged, [task[:3]]))
            under_way.append((task, asked))
            if len(under_way) == AHEAD:
                yield _told(*under_way.popleft(), limit)
        while under_way:
            yield _told(*under_way.popleft(), limit)


def _told(
    task: Task, asked: Answer | Future[Any], limit: float
) -> tuple[Task, Answer | InputError]:
    """A task with its answer, which is kept in the cache unless it comes from there."""
    if isinstance(asked, Answer):
        return task, replace(asked, line=task.line)
    found, cache = _found(task, asked, limit), current_cache()
    if cache is not None and isinstance(found, Answer):
        cache.put(*task[:3], limit, found)
    return task, found


BATCH = 200
"""Claims that go to a worker elsewhere at once."""


def check_by(
    in_order: Callable[[Callable[[bytes], bytes], Iterator[bytes]], Iterator[bytes]],
    tasks: Iterable[Task],
    limit: float = DEFAULT_LIMIT,
) -> Iterator[tuple[Task, Answer | InputError]]:
    """As :func:`check_all`, by workers elsewhere.

    Args:
        in_order: calls a function on each of many arguments, and gives what it returns in order.
    """
    asked = (pickle.dumps((batch, limit)) for batch in _batches(tasks))
    for found in in_order(check_batch, asked):
        yield from pickle.loads(found)


def check_batch(asked: bytes) -> bytes:
    """What one call to a worker does, from bytes to bytes: no scheduler looks into either.

    The claims are decided in a process of their own, one after the other: a worker may have
    several threads, and precision is one for all of a process.
    """
    tasks, limit = pickle.loads(asked)
    return pickle.dumps(list(check_all(tasks, limit, 1, forked=False)))


def _batches(tasks: Iterable[Task]) -> Iterator[tuple[Task, ...]]:
    tasks = iter(tasks)
    while batch := tuple(islice(tasks, BATCH)):
        yield batch


def _found(task: Task, future: Future[Any], limit: float) -> Answer | InputError:
    """Return the answer; UNDECIDED after a timeout or if the process died."""
    try:
        found: Answer | InputError = future.result()
    except StoppedError as error:
        return _given_up(task, Cause.STOPPED, _stopped_text(error), limit)
    except BrokenExecutor:
        return _given_up(task, Cause.DIED, _DIED, limit)
    return found if isinstance(found, InputError) else replace(found, line=task.line)


def _stopped_text(error: StoppedError) -> str:
    """Return where a claim was stopped, and what may help at that stage."""
    reached = f" at the stage {error.stage}" if error.stage else ""
    boxes = error.stage.endswith(_BOXES)
    helps = "fewer variables or bounds on them" if boxes else "a simpler claim"
    return f"{error}{reached}; {helps} may help, a longer --limit rarely does"


def _given_up(task: Task, cause: Cause, why: str, limit: float) -> Answer:
    given = task.claim.given if isinstance(task.claim, Statement) else task.given
    return Answer(
        Verdict.UNDECIDED,
        why,
        statement=" ".join(str(task.claim)[:400].split()),
        given=str(given)[:400],
        read_as=read_as(*task[:3]),
        seconds=limit,
        line=task.line,
        cause=cause,
    )


def _judged(claim: Any, given: Any, path: str | None) -> Answer | InputError:
    """Return the answer, or the error if the claim cannot be read."""
    try:
        return decide_claim(claim, given, path)
    except InputError as error:
        return error
    except Exception as error:  # one claim that we fail at must not end the others
        why = f"internal error ({type(error).__name__}); please report this claim"
        text = " ".join(str(claim)[:400].split())
        reading = read_as(claim, given, path)
        return Answer(Verdict.UNDECIDED, why, text, read_as=reading, cause=Cause.FAILED)
