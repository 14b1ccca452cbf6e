"""Executors for batches: this process, local processes, or a Dask cluster.

Each is a ``concurrent.futures`` executor; the sweep and ``tresym check -f`` need nothing else.
"""

from __future__ import annotations

import logging
import socket
import threading
from collections import deque
from collections.abc import Callable, Collection, Iterator
from concurrent.futures import (
    ALL_COMPLETED,
    FIRST_COMPLETED,
    CancelledError,
    Executor,
    Future,
    wait,
)
from contextlib import contextmanager, suppress
from itertools import islice
from typing import Any, NamedTuple
from urllib.parse import urlsplit

from tresym.reals.numbers.exact import InputError, quoted
from tresym.reals.processes import Processes

PATIENCE = 10
"""Seconds to wait for a scheduler, and for workers to appear or to return."""

MOST_LOST = 3
"""How often a call is repeated whose result was lost in transfer."""

LOUD = ("distributed", "tornado", "asyncio")
"""Libraries whose log messages are suppressed while Dask runs."""

LARGEST_GREETING = 2**20
"""The size in bytes that a scheduler's first message may have."""


def _nothing_amiss() -> None:
    """Check nothing: the pool of local processes notices by itself when one dies."""


class Workers(NamedTuple):
    """An executor, and the number of batches that should be in progress.

    ``check`` is called whenever no batch has finished for :data:`PATIENCE` seconds. It raises
    InputError if no worker is left, so that no sweep waits for ever.
    """

    executor: Executor
    window: int
    check: Callable[[], None] = _nothing_amiss

    def as_landed(
        self, fn: Callable[[bytes], bytes], arguments: Iterator[tuple[int, bytes]]
    ) -> Iterator[tuple[int, bytes]]:
        """Yield the results of ``fn`` with the numbers of their arguments, as they are completed.

        Args:
            fn: the function to call in a worker.
            arguments: numbers and arguments.

        Raises:
            InputError: no worker is left.
        """
        calls: dict[Future[bytes], _Call] = {}
        while True:
            for number, argument in islice(arguments, self.window - len(calls)):
                call = _Call(self.executor, fn, argument, number)
                calls[call.future] = call
            if not calls:
                return
            for future in self._wait(calls, FIRST_COMPLETED):
                call = calls.pop(future)
                found = call.answer()
                if found is None:
                    calls[call.future] = call
                else:
                    yield call.number, found

    def in_order(self, fn: Callable[[bytes], bytes], arguments: Iterator[bytes]) -> Iterator[bytes]:
        """Yield the results of ``fn`` in the order of the arguments.

        At most ``window`` calls are in progress or finished and not yet yielded.

        Raises:
            InputError: no worker is left.
        """
        calls = deque(_Call(self.executor, fn, each) for each in islice(arguments, self.window))
        while calls:
            self._wait((calls[0].future,), ALL_COMPLETED)
            found = calls[0].answer()
            if found is not None:
                calls.popleft()
                calls.extend(_Call(self.executor, fn, each) for each in islice(arguments, 1))
                yield found

    def _wait(self, futures: Collection[Future[bytes]], until: str) -> set[Future[bytes]]:
        """The futures that are done, at least one of them."""
        while True:
            done = wait(futures, PATIENCE, until).done
            if done:
                return done
            self.check()


class _Call:
    """A call in progress, which is repeated if its result is lost."""

    def __init__(
        self, executor: Executor, fn: Callable[[bytes], bytes], argument: bytes, number: int = 0
    ) -> None:
        """Submit the call."""
        self.submit = lambda: executor.submit(fn, argument)
        self.number, self.lost, self.future = number, 0, self.submit()

    def answer(self) -> bytes | None:
        """Return the result, or None if it was lost and ``future`` is a new attempt."""
        try:
            return self.future.result()
        except ValueError as error:
            # A Dask worker may die after its call is done and before the result is read.
            if isinstance(error, InputError) or self.lost == MOST_LOST:
                raise
        self.lost += 1
        self.future = self.submit()
        return None


class Here(Executor):
    """An executor that computes at once, in this process."""

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        """Call ``fn`` and return a finished future."""
        future: Future[Any] = Future()
        future.set_result(fn(*args, **kwargs))
        return future


@contextmanager
def processes(count: int) -> Iterator[Workers]:
    """Open ``count`` processes of this machine; with 1, compute in this process."""
    if count == 1:
        yield Workers(Here(), 1)
        return
    with Processes(count) as executor:
        yield Workers(executor, 2 * count)


def _no_answer(address: str, error: Exception) -> InputError:
    """The error for a scheduler that cannot be reached."""
    reason = " ".join(str(error).split())[:200]
    return InputError(f"cluster: no scheduler answers at {quoted(address)} ({reason})")


def _knock(address: str) -> None:
    """Connect once and read the first message; Dask's client would wait for ever without one."""
    try:
        parts = urlsplit(address if "://" in address else f"tcp://{address}")
        if parts.scheme not in ("tcp", "tls") or not parts.hostname or not parts.port:
            raise ValueError("the address must have the form tcp://HOST:PORT")
        with socket.create_connection((parts.hostname, parts.port), timeout=PATIENCE) as line:
            if parts.scheme == "tcp" and not 0 < _size(line) < LARGEST_GREETING:
                raise ValueError("the program that answers is not a Dask scheduler")
    except (OSError, ValueError) as error:
        raise _no_answer(address, error) from None


def _size(line: socket.socket) -> int:
    """The number with which a scheduler opens a conversation: the size of its first message."""
    received = b""
    while len(received) < 8:
        more = line.recv(8 - len(received))
        if not more:
            raise ValueError("the connection was closed")
        received += more
    return int.from_bytes(received, "little")


def _within(seconds: float, call: Callable[[], Any]) -> Any:
    """The result of ``call``, or TimeoutError after ``seconds``, even if ``call`` never returns."""
    answer: Future[Any] = Future()

    def run() -> None:
        try:
            answer.set_result(call())
        except BaseException as error:
            answer.set_exception(error)

    threading.Thread(target=run, daemon=True).start()
    return answer.result(seconds)


@contextmanager
def _unheard() -> Iterator[None]:
    """Suppress Dask's log: it would print tracebacks where tresym prints one line."""
    names = [name for name in logging.root.manager.loggerDict if name.split(".")[0] in LOUD]
    before = {name: logging.getLogger(name).disabled for name in names}
    try:
        for name in names:
            logging.getLogger(name).disabled = True
        yield
    finally:
        for name, was in before.items():
            logging.getLogger(name).disabled = was


@contextmanager
def cluster(address: str) -> Iterator[Workers]:
    """Use the workers of a Dask scheduler; they need the same version of tresym.

    Args:
        address: ``tcp://HOST:PORT`` of the scheduler.

    Raises:
        InputError: Dask is not installed, no scheduler answers, or it has no workers with tresym.
    """
    try:
        from distributed import Client, KilledWorker
        from distributed.comm import CommClosedError
    except ImportError:
        raise InputError("cluster: needs Dask (pip install 'tresym[cluster]')") from None
    _knock(address)
    with _unheard():
        yield from _led(address, Client, (KilledWorker, CommClosedError, CancelledError))


def _led(
    address: str, open_client: Any, losses: tuple[type[BaseException], ...]
) -> Iterator[Workers]:
    """The workers of the scheduler that answers at ``address``."""
    try:
        client = _within(
            2 * PATIENCE, lambda: open_client(address, timeout=PATIENCE, set_as_default=False)
        )
        threads = _threads(client)
    except Exception as error:
        # Anything may answer at the address, and Dask fails on it in many ways.
        raise _no_answer(address, error) from None
    try:
        if threads == 0:
            raise InputError(f"cluster: the scheduler at {address} has no workers")
        executor = client.get_executor(pure=False)
        yield Workers(executor, 2 * threads + 2, _Watch(client))
    except losses as error:
        reason = type(error).__name__
        raise InputError(
            f"cluster: the scheduler or its workers are lost ({reason}); start them and run the "
            "command again"
        ) from None
    except ImportError as error:
        raise InputError(
            f"cluster: the workers need the same version of tresym ({error})"
        ) from None
    finally:
        with suppress(OSError):
            client.close(timeout=PATIENCE)


def _threads(client: Any) -> int:
    """The number of threads of all workers, by the scheduler; OSError if it does not answer."""
    counts: dict[str, int] = client.sync(client.scheduler.ncores, callback_timeout=PATIENCE)
    return sum(counts.values())


class _Watch:
    """Raises InputError if ``LOOKS`` times in a row the scheduler is gone or has no workers."""

    LOOKS = 6

    def __init__(self, client: Any) -> None:
        self.client = client
        self.empty = 0

    def __call__(self) -> None:
        """Check once."""
        try:
            alone = self.client.status != "running" or _threads(self.client) == 0
        except (OSError, AttributeError, RuntimeError):
            # raised by a client that is being closed
            alone = True
        self.empty = self.empty + 1 if alone else 0
        if self.empty >= self.LOOKS:
            raise InputError(
                "cluster: the scheduler or its workers are lost; start them and run the command "
                "again"
            )
