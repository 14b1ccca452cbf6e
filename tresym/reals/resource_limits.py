"""Limits on processor time and on garbage collection.

That of time is kept by a signal of the operating system.
"""

from __future__ import annotations

import gc
import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager


class TimeUp(BaseException):
    """The limit is reached. Not an ``Exception``: a method under test must not swallow it."""


SOON = 0.01
"""Seconds after which a limit strikes again that was put off."""
_held: list[None] = []


@contextmanager
def held() -> Iterator[None]:
    """Inside, no limit strikes: a C library that calls back loses what the callback raises."""
    _held.append(None)
    try:
        yield
    finally:
        _held.pop()


@contextmanager
def time_limit(seconds: float, error: type[BaseException] = TimeUp) -> Iterator[None]:
    """Raise ``error`` in the block once it has used ``seconds`` of processor time.

    Work inside one call of a C library goes on to the end of that call. Where the system has no
    such signal, outside the main thread, and where a limit runs already, there is no limit.
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
    # Struck in a callback of the collector, the first one is lost: so it strikes again.
    signal.setitimer(signal.ITIMER_PROF, seconds, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, before)


@contextmanager
def collecting_seldom(objects: int) -> Iterator[None]:
    """Inside, memory is searched for circles after so many new objects: terms make few circles."""
    thresholds = gc.get_threshold()
    gc.set_threshold(max(objects, thresholds[0]) if thresholds[0] else 0, *thresholds[1:])
    try:
        yield
    finally:
        gc.set_threshold(*thresholds)
