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
    """Certified real arithmetic (python-flint ``arb``) under the array API's function names."""

    @property
    def pi(self) -> arb:
        """π at the working precision."""
        return arb.pi()

    sqrt = staticmethod(arb.sqrt)
    exp = staticmethod(arb.exp)
    expm1 = staticmethod(arb.expm1)
    log = staticmethod(arb.log)
    log1p = staticmethod(arb.log1p)
    sin = staticmethod(arb.sin)
    cos = staticmethod(arb.cos)
    tan = staticmethod(arb.tan)
    asin = staticmethod(arb.asin)
    acos = staticmethod(arb.acos)
    atan = staticmethod(arb.atan)
    atan2 = staticmethod(arb.atan2)
    sinh = staticmethod(arb.sinh)
    cosh = staticmethod(arb.cosh)
    tanh = staticmethod(arb.tanh)
    asinh = staticmethod(arb.asinh)
    acosh = staticmethod(arb.acosh)
    atanh = staticmethod(arb.atanh)


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
