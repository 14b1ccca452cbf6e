"""Processes of this machine as a ``concurrent.futures`` executor that outlives their deaths."""

from __future__ import annotations

import os
import signal
import threading
from collections.abc import Callable
from concurrent.futures import BrokenExecutor, Future, ThreadPoolExecutor
from contextlib import suppress
from multiprocessing import get_context
from multiprocessing.connection import Connection
from multiprocessing.process import BaseProcess
from typing import Any

from tresym.exact import InputError

DEATHS = 3
"""Processes that may die over one call before it is given up."""

MOST_WORKERS = 1024


def cores() -> int:
    """How many processes can run at once here: the cores that this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0)) or 1
    return os.cpu_count() or 1


def parse_workers(text: str) -> int:
    """The number of processes that ``text`` asks for; InputError unless it is 1 to 1024."""
    word = text.strip(" ")
    if not (
        word.isascii() and word.isdecimal() and len(word) <= 4 and 1 <= int(word) <= MOST_WORKERS
    ):
        raise InputError(f"workers: must be an integer from 1 to {MOST_WORKERS}")
    return int(word)


class Processes(ThreadPoolExecutor):
    """Processes of this machine, each led by a thread of its own through a pipe of its own.

    A process that dies is replaced and its call made again. (The standard pool of processes
    has one pipe for all answers: who dies while answering leaves half of one there, and the rest is
    waited for forever.)
    """

    def __init__(self, count: int) -> None:
        """Lead ``count`` processes, each started when it is first needed."""
        super().__init__(count, initializer=_deaf_to_interrupts)
        self._mine = threading.local()
        self._lock = threading.Lock()
        self._children: dict[BaseProcess, Connection] = {}
        self._ended = False

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        """Have ``fn`` called in one of the processes."""
        return super().submit(self._lead, fn, args, kwargs)

    def _lead(self, fn: Callable[..., Any], args: Any, kwargs: Any) -> Any:
        for _ in range(DEATHS):
            connection = getattr(self._mine, "connection", None) or self._start()
            try:
                connection.send((fn, args, kwargs))
                value, error = connection.recv()
            except (EOFError, OSError):
                self._mine.connection = None
                continue
            if error is not None:
                raise error
            return value
        raise BrokenExecutor(f"{DEATHS} processes have died over one batch")

    def _start(self) -> Connection:
        context = get_context("spawn")
        ours, theirs = context.Pipe()
        child = context.Process(target=_serve, args=(theirs,), daemon=True)
        with self._lock:
            if self._ended:
                raise BrokenExecutor("the processes have been ended")
            child.start()
            self._children[child] = ours
        # Now only the child holds its end, and its death is the end of the pipe.
        theirs.close()
        self._mine.connection = ours
        return ours

    def end(self) -> None:
        """End the processes at once, whatever they are doing."""
        with self._lock:
            self._ended = True
            for child in self._children:
                child.terminate()

    def __exit__(self, kind: Any, value: Any, trace: Any) -> None:
        """Let the processes go, or end them where something went wrong."""
        if kind is not None:
            self.end()
        self.shutdown(cancel_futures=True)

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """Let the processes go when nothing is left to do."""
        super().shutdown(wait, cancel_futures=cancel_futures)
        for child, connection in self._children.items():
            connection.close()
            child.join()


def _serve(connection: Connection) -> None:
    """The life of a process: calls in, answers out, until the other end of the pipe is gone."""
    with suppress(EOFError, OSError):
        while True:
            fn, args, kwargs = connection.recv()
            answer: tuple[Any, Exception | None]
            try:
                answer = fn(*args, **kwargs), None
            except Exception as error:
                answer = None, error
            connection.send(answer)


def _deaf_to_interrupts() -> None:
    """Processes started by this thread do not hear Ctrl-C: it is for their parent."""
    if hasattr(signal, "pthread_sigmask"):
        from multiprocessing import resource_tracker

        # Starting the tracker, as the first process would, opens the ears again.
        resource_tracker.ensure_running()
        signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
