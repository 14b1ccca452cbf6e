"""The four arithmetics a formula runs in, and the one place where precision is set.

A formula is a plain function whose last argument ``m`` is an arithmetic: a namespace with the
function names of the Python array API standard (``sqrt``, ``asin``, ``sinh``, …) and ``pi``.
``numpy``, ``mpmath.mp`` and ``sympy`` are such namespaces already; only the balls of python-flint
need the small adapter below. Precision is global in both mpmath and FLINT, so it is set only by
the two context managers here, which restore what they found, on errors too.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

from flint import arb, ctx, fmpq

if TYPE_CHECKING:
    import mpmath


class Balls:
    """Certified real arithmetic (python-flint ``arb``) under the array API's function names.

    Each function is called as a method of its argument: ``arb.sin(x)`` does not look at the type
    of ``x`` and makes a ball of whatever lies in memory when that is no ``arb``.
    """

    @property
    def pi(self) -> arb:
        """π at the working precision."""
        return arb.pi()

    @staticmethod
    def sqrt(x: arb) -> arb:
        """Square root."""
        return x.sqrt()

    @staticmethod
    def exp(x: arb) -> arb:
        """Exponential."""
        return x.exp()

    @staticmethod
    def expm1(x: arb) -> arb:
        """``exp(x) − 1`` without cancellation."""
        return x.expm1()

    @staticmethod
    def log(x: arb) -> arb:
        """Natural logarithm."""
        return x.log()

    @staticmethod
    def log1p(x: arb) -> arb:
        """``log(1 + x)`` without cancellation."""
        return x.log1p()

    @staticmethod
    def sin(x: arb) -> arb:
        """Sine."""
        return x.sin()

    @staticmethod
    def cos(x: arb) -> arb:
        """Cosine."""
        return x.cos()

    @staticmethod
    def tan(x: arb) -> arb:
        """Tangent."""
        return x.tan()

    @staticmethod
    def asin(x: arb) -> arb:
        """Inverse sine."""
        return x.asin()

    @staticmethod
    def acos(x: arb) -> arb:
        """Inverse cosine."""
        return x.acos()

    @staticmethod
    def atan(x: arb) -> arb:
        """Inverse tangent."""
        return x.atan()

    @staticmethod
    def atan2(y: arb, x: arb) -> arb:
        """Angle of the point ``(x, y)``; the one that is no method, and looks at its types."""
        if not isinstance(y, arb):
            raise TypeError("atan2: needs balls")
        return arb.atan2(y, x)

    @staticmethod
    def sinh(x: arb) -> arb:
        """Hyperbolic sine."""
        return x.sinh()

    @staticmethod
    def cosh(x: arb) -> arb:
        """Hyperbolic cosine."""
        return x.cosh()

    @staticmethod
    def tanh(x: arb) -> arb:
        """Hyperbolic tangent."""
        return x.tanh()

    @staticmethod
    def asinh(x: arb) -> arb:
        """Inverse hyperbolic sine."""
        return x.asinh()

    @staticmethod
    def acosh(x: arb) -> arb:
        """Inverse hyperbolic cosine."""
        return x.acosh()

    @staticmethod
    def atanh(x: arb) -> arb:
        """Inverse hyperbolic tangent."""
        return x.atanh()


balls = Balls()

BITS_PER_DIGIT = 3.3219280948873626
"""log₂ 10, rounded up: turns decimal digits into bits."""


def bits(digits: int, guard: int = 32) -> int:
    """Working precision in bits that carries ``digits`` decimal digits and ``guard`` bits more."""
    return int(digits * BITS_PER_DIGIT) + 1 + guard


class ball_precision:  # noqa: N801 - used like a function; a class because it is entered often
    """Set FLINT's working precision to ``precision`` bits inside the block; yields the balls."""

    __slots__ = ("before", "precision")

    def __init__(self, precision: int) -> None:
        """Remember the precision to work at."""
        self.precision = precision

    def __enter__(self) -> Balls:
        """Set the precision."""
        self.before = ctx.prec
        ctx.prec = self.precision
        return balls

    def __exit__(self, *_: object) -> None:
        """Restore what was found."""
        ctx.prec = self.before


@contextmanager
def mp_precision(digits: int) -> Iterator[mpmath.MPContext]:
    """Set mpmath's working precision to ``digits`` inside the block; yields ``mpmath.mp``."""
    import mpmath

    with mpmath.workdps(digits):
        yield mpmath.mp


def ball(x: fmpq | int | arb) -> arb:
    """The exact rational ``x`` as a ball at the working precision."""
    return arb(x)


def to_mp(x: fmpq, m: Any) -> Any:
    """The exact rational ``x`` as an mpmath number at the working precision."""
    return m.mpf(int(x.p)) / m.mpf(int(x.q))
