"""Run the ``tresym`` command and end it with one line when it is interrupted.

While libraries are loaded, and after the command has finished, an interrupt (Ctrl-C, ``kill``, or a
terminal that closes) ends the process at once. While the command runs it is raised as
``KeyboardInterrupt``, so that temporary files are removed and worker processes ended. This module
imports only modules that Python has already loaded, to be ready for interrupts early.
"""

from __future__ import annotations

import os
import sys

SIGINT = 2
INTERRUPTED = 128 + SIGINT


class _Interrupts:
    """Signal handler: end the process, or raise KeyboardInterrupt while the command runs."""

    def __init__(self) -> None:
        self.process = os.getpid()
        self.unwind = False
        self.heard = 0

    def signal(self, number: int, _: object) -> None:
        """Handle a signal."""
        if os.getpid() != self.process:
            os._exit(128 + number)
        if not self.unwind or (self.heard and number == SIGINT):
            leave(128 + number)
        if not self.heard:  # once only: `timeout` sends its signal twice
            self.heard = number
            raise KeyboardInterrupt

    def unraisable(self, found: sys.UnraisableHookArgs) -> None:
        """End the process if the interrupt was raised where no caller can catch it."""
        if issubclass(found.exc_type, KeyboardInterrupt):
            leave()
        sys.__unraisablehook__(found)


def leave(status: int = INTERRUPTED) -> None:
    """End the process at once with one line.

    Args:
        status: the exit status.
    """
    try:
        os.write(2, b"tresym: interrupted\n")
    finally:
        os._exit(status)


def main() -> int:
    """Run the command line of this process.

    Returns:
        The exit status of the command, or 128 plus the number of the signal that interrupted it.
    """
    sys.excepthook = lambda kind, *rest: (
        leave() if issubclass(kind, KeyboardInterrupt) else sys.__excepthook__(kind, *rest)
    )
    import signal

    interrupts = _Interrupts()
    # A signal that the process was started to ignore, as under nohup, stays ignored.
    for name in ("SIGINT", "SIGTERM", "SIGHUP"):
        number = getattr(signal, name, None)
        if signal.getsignal(number or SIGINT) in (signal.default_int_handler, signal.SIG_DFL):
            signal.signal(number or SIGINT, interrupts.signal)
    sys.unraisablehook = interrupts.unraisable
    from tresym.commands import main as command

    try:
        interrupts.unwind = True
        status = command()
        interrupts.unwind = False
    except BaseException:
        # A library may have replaced the interrupt by an exception of its own.
        if not interrupts.heard:
            raise
        leave(128 + interrupts.heard)
    if interrupts.heard:
        # Where the interrupt struck while Python compiled the methods of a class from text, it
        # would end the process by SIGINT after all; making another such class undoes that.
        from collections import namedtuple

        namedtuple("Undone", "x")
    return 128 + interrupts.heard if interrupts.heard and status == INTERRUPTED else status


if __name__ == "__main__":
    sys.exit(main())
