"""Where batches are computed: this process, local processes, or a Dask cluster.

Each is a ``concurrent.futures`` executor; the sweep, and ``tresym check -f``, know nothing else.
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
"""Seconds to wait for a scheduler, and for workers to come or to come back."""

MOST_LOST = 3
"""How often the answer to one call may be lost on its way."""

LOUD = ("distributed", "tornado", "asyncio")
"""Libraries that log what Dask meets."""

LARGEST_GREETING = 2**20
"""Bytes that a scheduler's greeting may have."""


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

    def as_landed(
        self, fn: Callable[[bytes], bytes], arguments: Iterator[tuple[int, bytes]]
    ) -> Iterator[tuple[int, bytes]]:
        """What ``fn`` returns for each argument, with its number, as it comes.

        Raises:
            InputError: nobody is left to work.
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
        """The same in order; no more is under way, or waits to be given, than the window.

        Raises:
            InputError: nobody is left to work.
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
        """Those that are done, at least one of them."""
        while True:
            done = wait(futures, PATIENCE, until).done
            if done:
                return done
            self.check()


class _Call:
    """A call that is under way, and is made again where its answer is lost."""

    def __init__(
        self, executor: Executor, fn: Callable[[bytes], bytes], argument: bytes, number: int = 0
    ) -> None:
        """Begin it."""
        self.submit = lambda: executor.submit(fn, argument)
        self.number, self.lost, self.future = number, 0, self.submit()

    def answer(self) -> bytes | None:
        """What it returned; None where that was lost, and ``future`` is another now."""
        try:
            return self.future.result()
        except ValueError as error:
            # A Dask worker that dies between its answer and the reading of it.
            if isinstance(error, InputError) or self.lost == MOST_LOST:
                raise
        self.lost += 1
        self.future = self.submit()
        return None


class Here(Executor):
    """An executor that computes at once, in this process."""

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        """Call ``fn`` now."""
        future: Future[Any] = Future()
        future.set_result(fn(*args, **kwargs))
        return future


@contextmanager
def processes(count: int) -> Iterator[Workers]:
    """``count`` processes of this machine; with 1, this very process."""
    if count == 1:
        yield Workers(Here(), 1)
        return
    with Processes(count) as executor:
        yield Workers(executor, 2 * count)


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
def _unheard() -> Iterator[None]:
    """Inside, Dask prints nothing: it logs in whole tracebacks what is said here in one line."""
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
    """The workers of a Dask scheduler; they need the same tresym.

    Raises:
        InputError: no Dask here, no scheduler there, no workers, or workers without tresym.
    """
    try:
        from distributed import Client, KilledWorker
        from distributed.comm import CommClosedError
    except ImportError:
        raise InputError("cluster: needs Dask (pip install -e '.[cluster]')") from None
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
        # What speaks there may be anything, and Dask stumbles over it in many ways.
        raise _no_answer(address, error) from None
    try:
        if threads == 0:
            raise InputError(f"cluster: the scheduler at {address} has no workers")
        executor = client.get_executor(pure=False)
        yield Workers(executor, 2 * threads + 2, _Watch(client))
    except losses as error:
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
            raise InputError("cluster: the scheduler or its workers are lost")
