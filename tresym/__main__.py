"""``python -m tresym`` and the ``tresym`` script: the command, with Ctrl-C answered in one line.

From its first moment on: until the libraries are loaded, and again when the command is over, an
interrupt ends the process at once. In between it is a ``KeyboardInterrupt``, so that files written
aside are removed and other processes ended. So it is when it is asked to end by ``kill`` or by a
terminal that closes. (Nothing is imported above that is not loaded anyway.)
"""

from __future__ import annotations

import os
import sys

SIGINT = 2
INTERRUPTED = 128 + SIGINT


class _Interrupts:
    """What Ctrl-C and kill do: leave, or unwind the command where it runs."""

    def __init__(self) -> None:
        self.process = os.getpid()
        self.unwind = False
        self.heard = 0

    def signal(self, number: int, _: object) -> None:
        """Answer the signal itself."""
        if os.getpid() != self.process:
            os._exit(128 + number)
        if not self.unwind or (self.heard and number == SIGINT):
            leave(128 + number)
        if not self.heard:  # `timeout` sends its signal twice
            self.heard = number
            raise KeyboardInterrupt

    def unraisable(self, found: sys.UnraisableHookArgs) -> None:
        """Leave where an interrupt fell into a callback that nobody waits for."""
        if issubclass(found.exc_type, KeyboardInterrupt):
            leave()
        sys.__unraisablehook__(found)


def leave(status: int = INTERRUPTED) -> None:
    """End the process at once, with one line."""
    try:
        os.write(2, b"tresym: interrupted\n")
    finally:
        os._exit(status)


def main() -> int:
    """Run the command line of this process; returns the exit status."""
    sys.excepthook = lambda kind, *rest: (
        leave() if issubclass(kind, KeyboardInterrupt) else sys.__excepthook__(kind, *rest)
    )
    import signal

    interrupts = _Interrupts()
    # A shell may have its jobs ignore Ctrl-C, nohup a closed terminal; then so do we.
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
        # A library may have turned the interrupt into an error of its own.
        if not interrupts.heard:
            raise
        leave(128 + interrupts.heard)
    return 128 + interrupts.heard if interrupts.heard and status == INTERRUPTED else status


if __name__ == "__main__":
    sys.exit(main())
