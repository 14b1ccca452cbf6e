"""A process pool in the interface of ``concurrent.futures`` that survives dying workers."""

from __future__ import annotations

import os
import signal
import threading
import warnings
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import BrokenExecutor, Future, ThreadPoolExecutor
from contextlib import contextmanager, suppress
from multiprocessing import current_process, get_all_start_methods, get_context, spawn
from multiprocessing.connection import Connection
from multiprocessing.process import BaseProcess
from typing import Any, NamedTuple

from tresym.reals.numbers.exact import whole_number

DEATHS = 3
"""Processes that may die over one call before it is given up."""

GRACE = 5.0
"""Seconds beyond the limit of a call after which its process ends of itself."""

AHEAD = 1000
"""Calls in order that are under way at most: one that is slow keeps few others waiting."""

MOST_WORKERS = 1024

_lock = threading.Lock()
"""Held where a process is started or the list of them changes: one at a time, whosever it is."""


def cores() -> int:
    """How many processes can run at once here: the cores that this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0)) or 1
    return os.cpu_count() or 1


def parse_workers(text: str) -> int:
    """The number of processes that ``text`` asks for; InputError unless it is 1 to 1024."""
    word = text.strip(" ")
    is_number = word.isascii() and word.isdecimal() and len(word) <= len(str(MOST_WORKERS))
    return checked_workers(int(word) if is_number else 0)


def checked_workers(count: int) -> int:
    """``count`` if it is between 1 and 1024; InputError otherwise."""
    return whole_number(count, 1, MOST_WORKERS, "workers")


class _Child(NamedTuple):
    """A process, and our end of the pipe to it."""

    process: BaseProcess
    connection: Connection

    def end(self) -> None:
        """End it at once, and wait until it has ended."""
        self.process.kill()
        self.process.join()
        self.connection.close()


class Processes(ThreadPoolExecutor):
    """Processes of this machine, each led by a thread of its own through a pipe of its own.

    A process that dies is replaced and its call made again; one over the limit is ended and
    replaced. (The standard pool of processes has one pipe for all answers: who dies while answering
    leaves half of one there, and the rest is waited for forever. It knows no limit: FLINT cannot be
    interrupted from inside, so one is kept from outside.)
    """

    def __init__(
        self, count: int, limit: float | None = None, deaths: int = DEATHS, forked: bool = False
    ) -> None:
        """Lead ``count`` processes, each started when it is first needed.

        Args:
            count: how many at most.
            limit: seconds that a call may take; its future then fails with TimeoutError.
            deaths: processes that may die over one call; its future then fails with BrokenExecutor.
            forked: start them at once as copies of this one, where the system can. For calls that
                run Python and FLINT alone: other libraries take locks that a copy never gets back.
        """
        self._forked = forked and "fork" in get_all_start_methods()
        super().__init__(count, initializer=_deaf_to_interrupts, initargs=(self._forked,))
        self._context: Any = get_context("fork" if self._forked else "spawn")
        self._limit, self._deaths = limit, deaths
        self._mine = threading.local()
        self._children: list[_Child] = []
        self._ended = False

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        """Have ``fn`` called in one of the processes."""
        return super().submit(self._lead, fn, args, kwargs)

    def in_order(
        self, fn: Callable[..., Any], calls: Iterable[tuple[Any, ...]]
    ) -> Iterator[Future[Any]]:
        """The future of ``fn`` on each tuple of arguments, in order; few calls are read ahead."""
        under_way: deque[Future[Any]] = deque()
        for call in calls:
            under_way.append(self.submit(fn, *call))
            if len(under_way) == AHEAD:
                yield under_way.popleft()
        yield from under_way

    def _lead(self, fn: Callable[..., Any], args: Any, kwargs: Any) -> Any:
        for _ in range(self._deaths):
            child = getattr(self._mine, "child", None) or self._start()
            try:
                child.connection.send((fn, args, kwargs))
                in_time = child.connection.poll(self._limit)
                value, error = child.connection.recv() if in_time else (None, None)
            except (EOFError, OSError):
                self._lose(child)
                continue
            if not in_time:
                self._lose(child)
                raise TimeoutError(f"stopped after {self._limit:g} s")
            if error is not None:
                raise error
            return value
        raise BrokenExecutor(f"{self._deaths} processes have died over one batch")

    def _start(self) -> _Child:
        with _lock, _unhindered():
            if self._ended:
                raise BrokenExecutor("the processes have been ended")
            ours, theirs = self._context.Pipe()
            # A copy of this process holds all ends that this one holds, and has to let them go.
            copied = [ours, *(child.connection for child in self._children)] if self._forked else []
            process = self._context.Process(
                target=_serve, args=(theirs, self._limit, copied), daemon=True
            )
            process.start()
            # Now only the child holds its end, and its death is the end of the pipe.
            theirs.close()
            self._mine.child = _Child(process, ours)
            self._children.append(self._mine.child)
        return self._mine.child

    def _lose(self, child: _Child) -> None:
        self._mine.child = None
        with _lock:
            self._children.remove(child)
        child.end()

    def end(self) -> None:
        """End the processes at once, whatever they are doing."""
        with _lock:
            self._ended = True
            for child in self._children:
                child.process.kill()

    def __exit__(self, kind: Any, value: Any, trace: Any) -> None:
        """Let the processes go, or end them where something went wrong."""
        if kind is not None:
            self.end()
        self.shutdown(cancel_futures=True)

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """Let the processes go when nothing is left to do."""
        super().shutdown(wait, cancel_futures=cancel_futures)
        for child in self._children:
            child.end()


def _serve(connection: Connection, limit: float | None, copied: list[Connection]) -> None:
    """The life of a process: calls in, answers out, until the other end of the pipe is gone."""
    for end in copied:
        end.close()
    signal.signal(signal.SIGTERM, signal.SIG_DFL)  # a copy has what its parent answers
    alarm = getattr(signal, "setitimer", None) if limit is not None else None
    if alarm is not None:
        signal.signal(signal.SIGALRM, signal.SIG_DFL)
    with suppress(EOFError, OSError):
        while True:
            fn, args, kwargs = connection.recv()
            if alarm is not None:  # should the parent be killed, nobody else stops this
                alarm(signal.ITIMER_REAL, (limit or 0) + GRACE)
            answer: tuple[Any, Exception | None]
            try:
                answer = fn(*args, **kwargs), None
            except Exception as error:
                answer = None, error
            if alarm is not None:
                alarm(signal.ITIMER_REAL, 0)
            connection.send(answer)


def _deaf_to_interrupts(forked: bool) -> None:
    """Processes started by this thread do not hear Ctrl-C: it is for their parent."""
    if hasattr(signal, "pthread_sigmask"):
        if not forked:
            from multiprocessing import resource_tracker

            # Starting the tracker, as the first process would, opens the ears again.
            resource_tracker.ensure_running()
        signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})


@contextmanager
def _unhindered() -> Iterator[None]:
    """Inside, any process may start others, and these do not run the script that it runs.

    What is called are functions of modules, so a script needs no ``__main__`` guard for us; and
    ours end with their parent, a worker of somebody's pool (a daemon) as well.
    """
    parent, prepared = current_process(), spawn.get_preparation_data
    daemon, parent.daemon = parent.daemon, False

    def without_main(name: str) -> dict[str, Any]:
        found = prepared(name)
        return {key: value for key, value in found.items() if not key.startswith("init_main")}

    spawn.get_preparation_data = without_main
    try:
        with warnings.catch_warnings():
            # Python warns of copies beside threads, for the sake of locks: see ``forked``.
            warnings.simplefilter("ignore", DeprecationWarning)
            yield
    finally:
        spawn.get_preparation_data = prepared
        parent.daemon = daemon
