"""Limit processor time and garbage collection.

The limit on time uses a timer signal of the operating system.
"""

from __future__ import annotations

import gc
import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager


class TimeUp(BaseException):
    """Raised at the time limit. It is not an ``Exception``, so that a method cannot catch it by
    mistake.
    """


SOON = 0.01
"""The delay in seconds after which a suspended limit is tried again."""
_held: list[None] = []


@contextmanager
def held() -> Iterator[None]:
    """Suspend time limits inside the block, as C libraries lose exceptions of their callbacks."""
    _held.append(None)
    try:
        yield
    finally:
        _held.pop()


@contextmanager
def time_limit(seconds: float, error: type[BaseException] = TimeUp) -> Iterator[None]:
    """Raise ``error`` in the block once it has used ``seconds`` of processor time.

    A call of a C library is not interrupted. There is no limit where the system has no such signal,
    outside the main thread, and inside another limit.

    Args:
        seconds: the processor time.
        error: the exception that is raised.
    """
    main = threading.current_thread() is threading.main_thread()
    if not main or not hasattr(signal, "setitimer") or signal.getitimer(signal.ITIMER_PROF)[0]:
        yield
        return

    def over(*_: object) -> None:
        if not _held:
            raise error
        signal.setitimer(signal.ITIMER_PROF, SOON, seconds)

    before = signal.signal(signal.SIGPROF, over)
    # An exception raised in a callback of the garbage collector is lost, so the timer repeats.
    signal.setitimer(signal.ITIMER_PROF, seconds, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, before)


@contextmanager
def collecting_seldom(objects: int) -> Iterator[None]:
    """Run cyclic garbage collection inside the block only after ``objects`` new objects.

    Expression trees contain few reference cycles.
    """
    thresholds = gc.get_threshold()
    gc.set_threshold(max(objects, thresholds[0]) if thresholds[0] else 0, *thresholds[1:])
    try:
        yield
    finally:
        gc.set_threshold(*thresholds)
