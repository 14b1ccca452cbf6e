"""A process pool in the interface of ``concurrent.futures`` that survives dying workers."""

from __future__ import annotations

import atexit
import os
import signal
import threading
import time
import warnings
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import BrokenExecutor, Future, ThreadPoolExecutor
from contextlib import contextmanager, suppress
from mmap import mmap
from multiprocessing import current_process, get_all_start_methods, get_context, spawn
from multiprocessing.connection import Connection
from multiprocessing.process import BaseProcess
from typing import Any, NamedTuple

from tresym.reals.numbers.exact import whole_number
from tresym.reals.resource_limits import BOARD_SIZE, processor_time, show_stages_on

DEATHS = 3
"""The number of processes that may die during one call before it fails."""

WAIT, WORKED = 60.0, 0.02
"""A call that waits for something uses no processor time, so that its limit does not end it. It is
stopped if it has worked for less than ``WORKED`` seconds in ``WAIT`` seconds of wall time."""

ORPHAN = 0.5
"""The interval in seconds at which a process looks whether its parent is alive."""

AHEAD = 1000
"""The maximal number of ordered calls in progress, so that a slow one delays few others."""

MOST_WORKERS = 1024

_lock = threading.Lock()
"""The lock for starting a process or changing the list of processes, in all pools."""


def cores() -> int:
    """Return the number of processor cores that this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0)) or 1
    return os.cpu_count() or 1


def parse_workers(text: str) -> int:
    """Return the number of processes that ``text`` states.

    Raises:
        InputError: it is not an integer from 1 to 1024.
    """
    word = text.strip(" ")
    is_number = word.isascii() and word.isdecimal() and len(word) <= len(str(MOST_WORKERS))
    return checked_workers(int(word) if is_number else 0)


def checked_workers(count: int) -> int:
    """Return ``count``.

    Raises:
        InputError: it is not between 1 and 1024.
    """
    return whole_number(count, 1, MOST_WORKERS, "workers")


class StoppedError(TimeoutError):
    """A call has reached its limit.

    Attributes:
        stage: what it was doing, if known; see :class:`tresym.reals.resource_limits.stage`.
    """

    def __init__(self, why: str, stage: str = "") -> None:
        """Store the reason and the stage."""
        super().__init__(why)
        self.stage = stage


class _Child(NamedTuple):
    """A process, this side of the pipe to it, and the memory in which it shows its stage."""

    process: BaseProcess
    connection: Connection
    board: mmap | None

    def end(self) -> None:
        """Kill the process and wait until it has ended."""
        self.process.kill()
        self.process.join()
        self.connection.close()

    def worked(self) -> float | None:
        """Return the processor time of the process, or None where that cannot be asked for."""
        return processor_time(self.process.pid or 0)

    @property
    def stage(self) -> str:
        """What it does, or did last."""
        text = bytes(self.board).strip(b"\0") if self.board is not None else b""
        return text.decode("ascii", "replace")


class Processes(ThreadPoolExecutor):
    """A pool of processes, each controlled by a thread of its own through a pipe of its own.

    A process that dies is replaced and its call repeated. A process that exceeds the limit on
    processor time is killed and replaced. The standard process pool has a single pipe for all
    results; a process that dies while sending leaves half a message there, and all others wait
    forever. It also has no limit on time, and FLINT cannot be interrupted from within a process, so
    the operating system ends the process: a timer counts the process's own time and sends it a
    signal that is not handled.
    """

    def __init__(
        self, count: int, limit: float | None = None, deaths: int = DEATHS, forked: bool = False
    ) -> None:
        """Prepare ``count`` processes, each of which is started when it is first needed.

        Args:
            count: the maximal number of processes.
            limit: the processor time of a call in seconds; its future then fails with
                :class:`StoppedError`. Where the system cannot count it, wall time is limited.
            deaths: the number of processes that may die during one call; its future then fails with
                BrokenExecutor.
            forked: whether to fork this process where the system can. Use it only for calls that
                run Python and FLINT alone, as locks of other libraries may remain locked in the
                copy.
        """
        self._forked = forked and "fork" in get_all_start_methods()
        super().__init__(count, initializer=_deaf_to_interrupts, initargs=(self._forked,))
        self._context: Any = get_context("fork" if self._forked else "spawn")
        self._limit, self._deaths = limit, deaths
        self._mine = threading.local()
        self._children: list[_Child] = []
        self._ended = False

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        """Call ``fn`` in one of the processes, and return the future of its result."""
        return super().submit(self._lead, fn, args, kwargs)

    def in_order(
        self, fn: Callable[..., Any], calls: Iterable[tuple[Any, ...]]
    ) -> Iterator[Future[Any]]:
        """Yield the future of ``fn`` on each tuple of arguments, in order; few calls are read
        ahead.
        """
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
                child.connection.send((fn, args, kwargs, self._limit))
                in_time = self._answers(child)
                value, error = child.connection.recv() if in_time else (None, None)
            except (EOFError, OSError):
                self._lose(child)
                if _COUNTS_TIME and child.process.exitcode == -signal.SIGVTALRM:
                    why = f"stopped after {self._limit:g} s of processor time"
                    raise StoppedError(why, child.stage) from None
                continue
            if not in_time:
                self._lose(child)
                raise StoppedError("stopped because it did not work any more", child.stage)
            if error is not None:
                raise error
            return value
        raise BrokenExecutor(f"{self._deaths} processes have died during one batch")

    def _answers(self, child: _Child) -> bool:
        """Wait for an answer; return False once the process does not work any more."""
        if self._limit is None or not _COUNTS_TIME:
            return child.connection.poll(self._limit)
        before, start = child.worked(), time.monotonic()
        while not child.connection.poll(WAIT):
            now = child.worked()
            if now is None or before is None:  # no such clock: much longer than it can take
                if time.monotonic() - start > 20 * self._limit + WAIT:
                    return False
            elif now - before < WORKED:
                return False
            before = now
        return True

    def _start(self) -> _Child:
        with _lock, _unhindered():
            if self._ended:
                raise BrokenExecutor("the process pool has been shut down")
            ours, theirs = self._context.Pipe()
            # A forked process inherits all open pipe ends of this one, and must close them.
            copied = [ours, *(child.connection for child in self._children)] if self._forked else []
            board = mmap(-1, BOARD_SIZE) if self._forked and self._limit is not None else None
            process = self._context.Process(
                target=_serve, args=(theirs, os.getpid(), copied, board), daemon=True
            )
            process.start()
            # Now only the child holds its end, so that the pipe closes when the child dies.
            theirs.close()
            self._mine.child = _Child(process, ours, board)
            self._children.append(self._mine.child)
        return self._mine.child

    def _lose(self, child: _Child) -> None:
        self._mine.child = None
        with _lock:
            self._children.remove(child)
        child.end()

    def end(self) -> None:
        """Kill the processes at once."""
        with _lock:
            self._ended = True
            for child in self._children:
                child.process.kill()

    def __exit__(self, kind: Any, value: Any, trace: Any) -> None:
        """Shut the processes down, or kill them after an exception."""
        if kind is not None:
            self.end()
        self.shutdown(cancel_futures=True)

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """Shut the processes down when no call is left."""
        super().shutdown(wait, cancel_futures=cancel_futures)
        for child in self._children:
            child.end()


def end_with_parent(parent: int) -> None:
    """End this process soon after its parent, which nobody can tell it if that was killed.

    The timer is stopped at exit: an interpreter that shuts down resets its handlers, and the next
    signal would then kill a process that has done its work.
    """

    def look(*_: object) -> None:
        if os.getppid() != parent:
            os._exit(1)

    if hasattr(signal, "setitimer"):
        signal.signal(signal.SIGALRM, look)
        signal.setitimer(signal.ITIMER_REAL, ORPHAN, ORPHAN)
        atexit.register(signal.setitimer, signal.ITIMER_REAL, 0)


_COUNTS_TIME = hasattr(signal, "setitimer")
"""Whether the system can count the processor time of a call."""


def _serve(
    connection: Connection, parent: int, copied: list[Connection], board: mmap | None
) -> None:
    """Run calls from the pipe and send their results, until the other end of the pipe closes."""
    for end in copied:
        end.close()
    signal.signal(signal.SIGTERM, signal.SIG_DFL)  # a fork inherits the handler of its parent
    if board is not None:
        show_stages_on(board)
    end_with_parent(parent)
    if _COUNTS_TIME:
        signal.signal(signal.SIGVTALRM, signal.SIG_DFL)  # ends the process, also within FLINT
    with suppress(EOFError, OSError):
        while True:
            fn, args, kwargs, limit = connection.recv()
            counted = _COUNTS_TIME and limit is not None
            if counted:
                signal.setitimer(signal.ITIMER_VIRTUAL, limit)
            answer: tuple[Any, Exception | None]
            try:
                answer = fn(*args, **kwargs), None
            except Exception as error:
                answer = None, error
            if counted:
                signal.setitimer(signal.ITIMER_VIRTUAL, 0)
            connection.send(answer)


def _deaf_to_interrupts(forked: bool) -> None:
    """Block Ctrl-C in processes started by this thread; their parent handles it."""
    if hasattr(signal, "pthread_sigmask"):
        if not forked:
            from multiprocessing import resource_tracker

            # Starting the tracker, as the first process would, unblocks the signal again.
            resource_tracker.ensure_running()
        signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})


@contextmanager
def _unhindered() -> Iterator[None]:
    """Allow any process to start others inside the block, without running its main script in them.

    Calls name functions of modules, so that a script needs no ``__main__`` guard. The processes end
    with their parent, also if it is a daemonic worker of another pool.
    """
    parent, prepared = current_process(), spawn.get_preparation_data
    daemon, parent.daemon = parent.daemon, False

    def without_main(name: str) -> dict[str, Any]:
        found = prepared(name)
        return {key: value for key, value in found.items() if not key.startswith("init_main")}

    spawn.get_preparation_data = without_main
    try:
        with warnings.catch_warnings():
            # Python warns of forking with threads because of locks; see the argument ``forked``.
            warnings.simplefilter("ignore", DeprecationWarning)
            yield
    finally:
        spawn.get_preparation_data = prepared
        parent.daemon = daemon
