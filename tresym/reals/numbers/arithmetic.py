"""Provide the four arithmetics of a formula, and the only place where precision is set.

A formula is a plain function whose last argument ``m`` is an arithmetic: a namespace with the
function names of the Python array API standard (``sqrt``, ``asin``, ``sinh``, …) and ``pi``. The
modules ``numpy``, ``mpmath.mp`` and ``sympy`` are such namespaces already; the balls of
python-flint need the small adapter below. Precision is a global setting in both mpmath and FLINT,
shared by all threads. It is therefore set only by the two context managers here. They admit one
thread at a time and restore the previous value, also after errors. Threads lose nothing by this, as
python-flint never runs two of them at once.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from operator import methodcaller
from threading import RLock
from typing import TYPE_CHECKING, Any, TypeVar

from flint import arb, ctx, fmpq

if TYPE_CHECKING:
    import mpmath

Found = TypeVar("Found")

WORKING = 128
"""The default precision of balls in bits."""


class Balls:
    """Certified real arithmetic (python-flint ``arb``) under the array API's function names.

    Each function is called as a method of its argument: ``arb.sin(x)`` does not look at the type
    of ``x`` and makes a ball of whatever lies in memory when that is no ``arb``.
    """

    pi = property(lambda self: arb.pi(), doc="π at the working precision.")
    sqrt, exp, expm1, log, log1p = map(methodcaller, ("sqrt", "exp", "expm1", "log", "log1p"))
    sin, cos, tan = map(methodcaller, ("sin", "cos", "tan"))
    asin, acos, atan = map(methodcaller, ("asin", "acos", "atan"))
    sinh, cosh, tanh = map(methodcaller, ("sinh", "cosh", "tanh"))
    asinh, acosh, atanh = map(methodcaller, ("asinh", "acosh", "atanh"))

    @staticmethod
    def atan2(y: arb, x: arb) -> arb:
        """Return the angle of the point ``(x, y)``. It is not a method of ``arb``, so types are
        checked.
        """
        if not isinstance(y, arb):
            raise TypeError("atan2: the arguments must be balls (flint.arb)")
        return arb.atan2(y, x)


balls = Balls()

BITS_PER_DIGIT = 3.3219280948873626
"""log₂ 10, rounded up: turns decimal digits into bits."""


def bits(digits: int, guard: int = 32) -> int:
    """Return the precision in bits for ``digits`` decimal digits plus ``guard`` bits."""
    return int(digits * BITS_PER_DIGIT) + 1 + guard


_alone = RLock()


def _alone_again() -> None:
    """Replace the lock in a forked process, where the thread that held it does not exist."""
    global _alone
    _alone = RLock()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_alone_again)


class ball_precision:  # noqa: N801 - used like a function; a class because it is entered often
    """Set FLINT's working precision to ``precision`` bits inside the block, and yield the balls."""

    __slots__ = ("before", "held", "precision")

    def __init__(self, precision: int = WORKING) -> None:
        """Store the precision in bits."""
        self.precision = precision

    def __enter__(self) -> Balls:
        """Set the precision, once no other thread is inside such a block."""
        self.held = _alone
        self.held.acquire()
        self.before = ctx.prec
        ctx.prec = self.precision
        return balls

    def __exit__(self, *_: object) -> None:
        """Restore the previous precision."""
        ctx.prec = self.before
        self.held.release()


def decided(
    attempt: Callable[[], Found | None], precisions: tuple[int, ...] = (WORKING, 8 * WORKING)
) -> Found | None:
    """Call ``attempt`` at increasing precision until its result is not None.

    Args:
        attempt: the function to call.
        precisions: the precisions in bits.

    Returns:
        The first result that is not None, or None.
    """
    for precision in precisions:
        with ball_precision(precision):
            found = attempt()
        if found is not None:
            return found
    return None


def side(x: arb) -> int | None:
    """Return ±1 if the ball has that sign, else None."""
    return 1 if x > 0 else -1 if x < 0 else None


@contextmanager
def precision_kept() -> Iterator[None]:
    """Restore the precision of FLINT and mpmath behind the block, wherever an exception leaves it.

    mpmath restores its precision in ``finally`` clauses of its functions, which a time limit can
    interrupt.
    """
    before = ctx.prec
    at_start = sys.modules.get("mpmath")
    in_bits = at_start.mp.prec if at_start is not None and hasattr(at_start, "mp") else 53
    try:
        yield
    finally:
        ctx.prec = before
        loaded = sys.modules.get("mpmath")
        if loaded is not None and hasattr(loaded, "mp"):
            loaded.mp.prec = in_bits


@contextmanager
def mp_precision(digits: int) -> Iterator[mpmath.MPContext]:
    """Set mpmath's working precision to ``digits`` inside the block, and yield ``mpmath.mp``."""
    import mpmath

    with _alone, mpmath.workdps(digits):
        yield mpmath.mp


def ball(x: fmpq | int | arb) -> arb:
    """Return the exact rational ``x`` as a ball at working precision."""
    return arb(x)


def to_mp(x: fmpq, m: Any) -> Any:
    """Return the exact rational ``x`` as an mpmath number at working precision."""
    return m.mpf(int(x.p)) / m.mpf(int(x.q))
