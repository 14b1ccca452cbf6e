"""Limit processor time and garbage collection, and name the stage at which a limit was reached.

All limits on time count processor time, so that an answer does not depend on what else the machine
does, and there are two kinds. :func:`time_limit` raises an exception in this process, in which one
method may give up and another go on. :class:`tresym.reals.processes.Processes` ends a process, also
in the middle of a call of FLINT; what it was to decide stays undecided, and is not stored. Both use
timer signals of the operating system.
"""

from __future__ import annotations

import gc
import signal
import threading
import time
import weakref
from collections.abc import Iterator
from contextlib import contextmanager
from mmap import mmap
from types import FrameType

from tresym.reals.numbers.arithmetic import precision_kept


class TimeUp(BaseException):
    """Raised at the time limit. It is not an ``Exception``, so that a method cannot catch it by
    mistake.
    """


def processor_time(process: int) -> float | None:
    """Return the seconds for which a process has worked, or None where that cannot be asked for."""
    try:
        return time.clock_gettime(~process << 3 | 2)  # as clock_getcpuclockid of Linux does
    except (AttributeError, OSError):
        return None


def time_left() -> float | None:
    """Return the seconds after which this process is ended; None if it has no limit of its own."""
    if not hasattr(signal, "getitimer"):
        return None
    return signal.getitimer(signal.ITIMER_VIRTUAL)[0] or None


_CALLBACKS = frozenset((weakref.__file__, weakref.WeakSet.__init__.__code__.co_filename))
SOON = 0.01
"""The delay in seconds after which a suspended limit is tried again."""
_held: list[None] = []


class held:  # noqa: N801 - used like a function
    """Suspend time limits inside the block, as C libraries lose exceptions of their callbacks."""

    def __enter__(self) -> None:
        """Suspend them."""
        _held.append(None)

    def __exit__(self, *_: object) -> None:
        """Let them act again."""
        _held.pop()


@contextmanager
def time_limit(seconds: float, error: type[BaseException] = TimeUp) -> Iterator[None]:
    """Raise ``error`` in the block once it has used ``seconds`` of processor time.

    A call of a C library is not interrupted, nor is the entry or exit of a ``with`` block: it
    acquires or restores something, such as the precision, and would do it by halves. There is no
    limit where the system has no such signal, outside the main thread, and inside another limit.

    Args:
        seconds: the processor time.
        error: the exception that is raised.
    """
    main = threading.current_thread() is threading.main_thread()
    if not main or not hasattr(signal, "setitimer") or signal.getitimer(signal.ITIMER_PROF)[0]:
        yield
        return

    over = False

    def end(_: int, frame: FrameType | None) -> None:
        if over:
            return
        if not _held and not _must_end(frame):
            raise error
        signal.setitimer(signal.ITIMER_PROF, SOON, seconds)

    before = signal.signal(signal.SIGPROF, end)
    try:
        # An exception raised in a callback of the garbage collector is lost, so the timer repeats.
        signal.setitimer(signal.ITIMER_PROF, seconds, seconds)
        with precision_kept():
            yield
    finally:
        over = True
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, before)


def _must_end(frame: FrameType | None) -> bool:
    """Return whether a frame belongs to the entry or exit of a block, or to a callback of weakref.

    Python ignores what is raised in the latter.
    """
    while frame is not None:
        code = frame.f_code
        if code.co_name in ("__enter__", "__exit__") or code.co_filename in _CALLBACKS:
            return True
        frame = frame.f_back
    return False


BOARD_SIZE = 160
"""The bytes of memory in which a process shows its parent the stage that it has reached."""
_board: list[mmap] = []
_stages: list[str] = []


class stage:  # noqa: N801 - used like a function
    """Name the work inside the block, for the message about a process that is stopped there.

    Example:
        >>> from tresym.reals.resource_limits import stage, stages
        >>> with stage("integrals"), stage("branch and bound"):
        ...     stages()
        'integrals: branch and bound'
    """

    __slots__ = ("name",)

    def __init__(self, name: str) -> None:
        """Store the name, a noun or two."""
        self.name = name

    def __enter__(self) -> None:
        """Begin the stage."""
        _stages.append(self.name)
        _show_stages()

    def __exit__(self, *_: object) -> None:
        """Return to the stage before."""
        _stages.pop()
        _show_stages()


def stages() -> str:
    """Return the stages under way, the outermost first; of many, the first and the last two."""
    found = _stages if len(_stages) <= 3 else [_stages[0], *_stages[-2:]]
    return ": ".join(dict.fromkeys(found))


def _show_stages() -> None:
    if _board:
        text = stages().encode("ascii", "replace")[:BOARD_SIZE]
        _board[0][:] = text.ljust(BOARD_SIZE, b"\0")


def show_stages_on(board: mmap) -> None:
    """Show the stages of this process in shared memory of ``BOARD_SIZE`` bytes from now on."""
    _board[:] = [board]
    _stages.clear()
    _show_stages()


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
