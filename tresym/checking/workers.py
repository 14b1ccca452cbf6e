"""Claims decided in processes of their own, each of which is stopped when its time is over.

FLINT cannot be interrupted from inside, so a limit is kept from outside. A process serves many
claims; one that is stopped or dies is replaced.
"""

from __future__ import annotations

import time
import warnings
from collections.abc import Iterable, Iterator
from dataclasses import replace
from multiprocessing import get_all_start_methods, get_context
from multiprocessing.connection import Connection, wait
from typing import Any, NamedTuple

from tresym.checking.answer import Answer
from tresym.checking.judge import judge
from tresym.checking.statement import Statement, read_as
from tresym.exact import InputError
from tresym.processes import cores
from tresym.verdict import Verdict

DEFAULT_LIMIT = 5.0
GRACE = 5.0
"""Seconds beyond its limit after which a process ends of itself."""


class Task(NamedTuple):
    """A claim to decide; ``line`` is where it stands in a file."""

    claim: Any
    given: Any = ""
    path: str | None = None
    line: int | None = None


def check_within(task: Task, limit: float = DEFAULT_LIMIT) -> Answer:
    """Decide one claim in at most ``limit`` seconds.

    Raises:
        InputError: the claim is not read.
    """
    for _, found in check_all([task], limit, 1):
        if isinstance(found, InputError):
            raise found
        return found
    raise RuntimeError("a task without an answer")


def check_all(
    tasks: Iterable[Task], limit: float = DEFAULT_LIMIT, processes: int | None = None
) -> Iterator[tuple[Task, Answer | InputError]]:
    """Every task with its answer, or with what is wrong with it, in the order of the tasks."""
    waiting = list(enumerate(tasks))
    count = max(1, min(processes or cores(), len(waiting)))
    waiting.reverse()
    done: dict[int, tuple[Task, Answer | InputError]] = {}
    upcoming = 0
    workers = [_Worker() for _ in range(count)]
    try:
        while True:
            for worker in workers:
                if worker.task is None and waiting:
                    worker.start(*waiting.pop(), limit)
            busy = [worker for worker in workers if worker.task is not None]
            if not busy:
                return
            soonest = min(worker.deadline for worker in busy)
            wait([w.connection for w in busy], max(0.0, soonest - time.monotonic()))
            for worker in busy:
                found = worker.result(limit)
                if found is not None and worker.task is not None:
                    done[worker.index] = (worker.task, found)
                    worker.task = None
            while upcoming in done:
                yield done.pop(upcoming)
                upcoming += 1
    finally:
        for worker in workers:
            worker.stop()


class _Worker:
    """A process, and the task it is at."""

    def __init__(self) -> None:
        self.task: Task | None = None
        self.index = 0
        self.deadline = 0.0
        self._launch()

    def _launch(self) -> None:
        fork = "fork" in get_all_start_methods()
        context: Any = get_context("fork" if fork else "spawn")
        self.connection, theirs = context.Pipe()
        self.process = context.Process(target=_serve, args=(theirs,), daemon=True)
        with warnings.catch_warnings():
            # Python warns of forks beside threads; the child runs Python and FLINT alone, and
            # takes no lock that a thread might hold.
            warnings.simplefilter("ignore", DeprecationWarning)
            self.process.start()
        theirs.close()

    def start(self, index: int, task: Task, limit: float) -> None:
        """Send the task; its time begins."""
        self.index, self.task = index, task
        self.deadline = time.monotonic() + limit
        self.connection.send((task[:3], limit))

    def result(self, limit: float) -> Answer | InputError | None:
        """The answer if there is one; UNDECIDED when time is over or the process died."""
        try:
            if self.connection.poll():
                found: Answer | InputError = self.connection.recv()
                line = self.task.line if self.task else None
                return found if isinstance(found, InputError) else replace(found, line=line)
        except (EOFError, OSError):
            return self._replaced("its process ended, perhaps for want of memory", limit)
        if time.monotonic() < self.deadline:
            return None
        return self._replaced(f"stopped after {limit:g} s", limit)

    def _replaced(self, reason: str, limit: float) -> Answer:
        self.stop()
        self._launch()
        task = self.task or Task("")
        given = task.claim.given if isinstance(task.claim, Statement) else task.given
        return Answer(
            Verdict.UNDECIDED,
            f"{reason}; fewer variables, a smaller region or a longer --limit may help",
            statement=" ".join(str(task.claim)[:400].split()),
            given=str(given)[:400],
            read_as=read_as(*task[:3]),
            seconds=limit,
            line=task.line,
        )

    def stop(self) -> None:
        """End the process."""
        self.process.kill()
        self.process.join()
        self.connection.close()


def _serve(connection: Connection) -> None:
    """In the process: decide what comes until nothing more does."""
    import signal

    signal.signal(signal.SIGINT, signal.SIG_IGN)
    alarm = getattr(signal, "setitimer", None)
    if alarm is not None:
        signal.signal(signal.SIGALRM, signal.SIG_DFL)
    while True:
        try:
            task, limit = connection.recv()
        except EOFError:
            return
        if alarm is not None:  # should the parent be killed, nobody else stops this
            alarm(signal.ITIMER_REAL, limit + GRACE)
        found = _judged(*task)
        if alarm is not None:
            alarm(signal.ITIMER_REAL, 0)
        connection.send(found)


def _judged(claim: Any, given: Any, path: str | None) -> Answer | InputError:
    """The answer, or what is wrong with the claim."""
    try:
        return judge(claim, given, path)
    except InputError as error:
        return error
    except Exception as error:  # one claim that we fail at must not end the others
        why = f"the procedure failed ({type(error).__name__}); please report this claim"
        text = " ".join(str(claim)[:400].split())
        return Answer(Verdict.UNDECIDED, why, text, read_as=read_as(claim, given, path))
