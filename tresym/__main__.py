"""``python -m tresym`` and the ``tresym`` script: the command, with Ctrl-C answered in one line.

From its first moment on: until the libraries are loaded, and again when the command is over, an
interrupt ends the process at once. In between it is a ``KeyboardInterrupt``, so that files written
aside are removed and other processes ended. (Nothing is imported above that is not loaded anyway.)
"""

from __future__ import annotations

import os
import sys

INTERRUPTED = 130


class _Interrupts:
    """What Ctrl-C does: leave, or unwind the command where it runs."""

    def __init__(self) -> None:
        self.process = os.getpid()
        self.unwind = False
        self.heard = False

    def signal(self, *_: object) -> None:
        """Answer the signal itself."""
        if os.getpid() != self.process:
            os._exit(INTERRUPTED)
        if self.heard or not self.unwind:
            leave()
        self.heard = True
        raise KeyboardInterrupt

    def unraisable(self, found: sys.UnraisableHookArgs) -> None:
        """Leave where an interrupt fell into a callback that nobody waits for."""
        if issubclass(found.exc_type, KeyboardInterrupt):
            leave()
        sys.__unraisablehook__(found)


def leave() -> None:
    """End the process at once, with one line."""
    try:
        os.write(2, b"tresym: interrupted\n")
    finally:
        os._exit(INTERRUPTED)


def main() -> int:
    """Run the command line of this process; returns the exit status."""
    sys.excepthook = lambda kind, *rest: (
        leave() if issubclass(kind, KeyboardInterrupt) else sys.__excepthook__(kind, *rest)
    )
    import signal

    interrupts = _Interrupts()
    # A shell may have its jobs ignore Ctrl-C; then so do we.
    if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
        signal.signal(signal.SIGINT, interrupts.signal)
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
        leave()
    return status


if __name__ == "__main__":
    sys.exit(main())
