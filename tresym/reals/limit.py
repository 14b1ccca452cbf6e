"""A limit on the processor time of a piece of work, kept by a signal of the operating system."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import NoReturn


class TimeUp(BaseException):
    """The limit is reached. Not an ``Exception``: a method under test must not swallow it."""


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

    def over(*_: object) -> NoReturn:
        raise error

    before = signal.signal(signal.SIGPROF, over)
    # Struck in a callback of the collector, the first one is lost: so it strikes again.
    signal.setitimer(signal.ITIMER_PROF, seconds, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, before)
