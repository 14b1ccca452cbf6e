"""Who computes the batches: this process, processes of this machine, or a Dask cluster.

Each is a ``concurrent.futures`` executor, and the sweep knows nothing else of it.
"""

from __future__ import annotations

import signal
import socket
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import (
    BrokenExecutor,
    CancelledError,
    Executor,
    Future,
    ThreadPoolExecutor,
)
from contextlib import contextmanager, suppress
from multiprocessing import get_context
from multiprocessing.connection import Connection
from multiprocessing.process import BaseProcess
from typing import Any, NamedTuple
from urllib.parse import urlsplit

from tresym.exact import InputError, quoted

DEATHS = 3
"""Processes that may die over one batch before it is given up."""

PATIENCE = 10
"""Seconds to wait for a scheduler, and for workers to come or to come back."""

LARGEST_GREETING = 2**20
"""Bytes that a scheduler's greeting may have."""

MOST_WORKERS = 1024


def parse_workers(text: str) -> int:
    """The number of processes that ``text`` asks for; InputError unless it is 1 to 1024."""
    word = text.strip(" ")
    if not (
        word.isascii() and word.isdecimal() and len(word) <= 4 and 1 <= int(word) <= MOST_WORKERS
    ):
        raise InputError(f"workers: must be an integer from 1 to {MOST_WORKERS}")
    return int(word)


def _nothing_amiss() -> None:
    """Processes of this machine are replaced when they die, or the batch is given up."""


class Workers(NamedTuple):
    """An executor, and how many batches it should have under way.

    ``check`` is asked whenever nothing has landed for :data:`PATIENCE` seconds; it raises
    InputError when nobody is left to work, so that no sweep waits for ever.
    """

    executor: Executor
    window: int
    check: Callable[[], None] = _nothing_amiss


class Here(Executor):
    """An executor that computes at once, in this process."""

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        """Call ``fn`` now."""
        future: Future[Any] = Future()
        future.set_result(fn(*args, **kwargs))
        return future


class Processes(ThreadPoolExecutor):
    """Processes of this machine, each led by a thread of its own through a pipe of its own.

    A process that dies is replaced and its batch computed again. (The standard pool of processes
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


@contextmanager
def processes(count: int) -> Iterator[Workers]:
    """``count`` processes of this machine; with 1, this very process."""
    if count == 1:
        yield Workers(Here(), 1)
        return
    executor = Processes(count)
    try:
        yield Workers(executor, 2 * count)
    except BaseException:
        executor.end()
        raise
    finally:
        executor.shutdown(cancel_futures=True)


def _no_answer(address: str, error: Exception) -> InputError:
    """What to say of a scheduler that cannot be reached."""
    reason = " ".join(str(error).split())[:200]
    return InputError(f"cluster: no scheduler answers at {quoted(address)} ({reason})")


def _knock(address: str) -> None:
    """Connect once and hear the greeting: where there is none Dask's client waits for ever."""
    try:
        parts = urlsplit(address if "://" in address else f"tcp://{address}")
        if parts.scheme not in ("tcp", "tls") or not parts.hostname or not parts.port:
            raise ValueError("the address reads tcp://HOST:PORT")
        with socket.create_connection((parts.hostname, parts.port), timeout=PATIENCE) as line:
            if parts.scheme == "tcp" and not 0 < _size(line) < LARGEST_GREETING:
                raise ValueError("what answers there is something else")
    except (OSError, ValueError) as error:
        raise _no_answer(address, error) from None


def _size(line: socket.socket) -> int:
    """The number that a scheduler opens every conversation with: the size of its greeting."""
    said = b""
    while len(said) < 8:
        more = line.recv(8 - len(said))
        if not more:
            raise ValueError("it hung up")
        said += more
    return int.from_bytes(said, "little")


def _within(seconds: float, call: Callable[[], Any]) -> Any:
    """What ``call`` returns; TimeoutError after ``seconds``, whatever it may still wait for."""
    answer: Future[Any] = Future()

    def run() -> None:
        try:
            answer.set_result(call())
        except BaseException as error:
            answer.set_exception(error)

    threading.Thread(target=run, daemon=True).start()
    return answer.result(seconds)


@contextmanager
def cluster(address: str) -> Iterator[Workers]:
    """The workers of a Dask scheduler; they need the same tresym.

    Raises:
        InputError: no Dask here, no scheduler there, no workers, or workers without tresym.
    """
    try:
        from distributed import Client, KilledWorker
        from distributed.comm import CommClosedError
    except ImportError:
        raise InputError("cluster: needs Dask (pip install 'tresym[cluster]')") from None
    _knock(address)
    try:
        client = _within(
            2 * PATIENCE, lambda: Client(address, timeout=PATIENCE, set_as_default=False)
        )
        threads = _threads(client)
    except Exception as error:
        # What speaks there may be anything, and Dask stumbles over it in many ways.
        raise _no_answer(address, error) from None
    try:
        if threads == 0:
            raise InputError(f"cluster: the scheduler at {address} has no workers")
        executor = client.get_executor(pure=False)
        yield Workers(executor, 2 * threads + 2, _Watch(client))
    except (KilledWorker, CommClosedError, CancelledError) as error:
        reason = type(error).__name__
        raise InputError(f"cluster: the scheduler or its workers are lost ({reason})") from None
    except ImportError as error:
        raise InputError(f"cluster: the workers need the same tresym ({error})") from None
    finally:
        with suppress(OSError):
            client.close(timeout=PATIENCE)


def _threads(client: Any) -> int:
    """The threads of all workers, by the scheduler's own count; OSError if it does not answer."""
    counts: dict[str, int] = client.sync(client.scheduler.ncores, callback_timeout=PATIENCE)
    return sum(counts.values())


class _Watch:
    """Raises InputError when ``LOOKS`` times in a row the scheduler is gone or has no workers."""

    LOOKS = 6

    def __init__(self, client: Any) -> None:
        self.client = client
        self.empty = 0

    def __call__(self) -> None:
        """Look once."""
        try:
            alone = self.client.status != "running" or _threads(self.client) == 0
        except (OSError, AttributeError, RuntimeError):
            # of a client that closes while it is asked
            alone = True
        self.empty = self.empty + 1 if alone else 0
        if self.empty >= self.LOOKS:
            raise InputError(
                "cluster: the scheduler or its workers are lost; "
                "the same command goes on from what has landed"
            )
