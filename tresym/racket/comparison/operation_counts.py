"""Count the FLINT or numpy operations of a computation.

F(ε, γ) is evaluated with balls that count their operations, and the float64 map with arrays that
do.
"""

from __future__ import annotations

import operator
from collections.abc import Callable
from typing import Any

import numpy as np
from flint import arb, fmpq

from tresym.racket.body import named_body
from tresym.racket.floats import float_orbit
from tresym.racket.motion.gauss import ball_ending, turn_by_gauss
from tresym.reals.numbers.arithmetic import ball_precision, bits

DIGITS = 50
STARTS = 64
TAKEN = ("add", "sub", "mul", "truediv", "neg", "abs", "lt", "gt")


class Counted:
    """A ball that counts; ``made`` gets one entry for each operation on it and on its results."""

    def __init__(self, ball: arb, made: list[str]) -> None:
        """Wrap a ball whose operations are recorded in ``made``."""
        self.ball, self.made = ball, made

    def done(self, name: str, function: Callable[..., Any], *others: Any) -> Any:
        """Return the result of an operation, counted."""
        self.made.append(name)
        balls = (x.ball if isinstance(x, Counted) else x for x in (self, *others))
        found = function(*balls)
        return Counted(found, self.made) if isinstance(found, arb) else found


def _operator(name: str, turned: bool = False) -> Callable[..., Any]:
    function = getattr(operator, name)

    def count(x: Counted, *others: Any) -> Any:
        if turned:
            return x.done(name, lambda y, z: function(z, y), *others)
        return x.done(name, function, *others)

    return count


for taken in TAKEN:
    setattr(Counted, f"__{taken}__", _operator(taken))
    setattr(Counted, f"__r{taken}__", _operator(taken, turned=True))


class Counting:
    """The arithmetic of such balls, as far as F needs it."""

    @staticmethod
    def sqrt(x: Counted) -> Any:
        """Return √x."""
        return x.done("sqrt", arb.sqrt)

    @staticmethod
    def atan(x: Counted) -> Any:
        """Return the arctangent."""
        return x.done("atan", arb.atan)

    @staticmethod
    def log(x: Counted) -> Any:
        """Return the logarithm."""
        return x.done("log", arb.log)


def turn_calls(gamma: fmpq) -> int:
    """Return the number of FLINT calls in F(1/10, γ) of the standard racket to 50 digits."""
    made: list[str] = []
    with ball_precision(bits(DIGITS, 12)):
        a, b, g = (Counted(arb(x), made) for x in (*named_body("str").shape, gamma))
        tangent = arb(fmpq(1, 10)).tan()
        rest = g.ball + (g.ball + b.ball) * tangent * tangent
        t, z = (Counted(x, made) for x in (tangent, rest))
        turn_by_gauss(t, z, a, b, g, Counting, ball_ending())
    return len(made)


class Watched(np.ndarray[Any, Any]):
    """An array that counts the operations on it and on their results."""

    made = 0

    def __array_ufunc__(self, ufunc: Any, method: str, *given: Any, **more: Any) -> Any:
        """Count an operation and apply it to plain arrays."""
        Watched.made += 1
        plain = (x.view(np.ndarray) if isinstance(x, Watched) else x for x in given)
        found = getattr(ufunc, method)(*plain, **more)
        return found.view(Watched) if isinstance(found, np.ndarray) else found


def map_operations() -> int:
    """Return the number of array operations, except selections, in the map for a full turn."""
    a, b = (int(x.p) / int(x.q) for x in named_body("str").shape)
    psi, rate = np.linspace(-3, 3, STARTS), np.linspace(-2, 2, STARTS)
    work = np.empty((5, float_orbit.LEVELS + 1, STARTS))
    around = np.full(STARTS, 2 * np.pi)
    Watched.made = 0
    with np.errstate(all="ignore"):
        given = (x.view(Watched) for x in (psi, rate, around, work))
        float_orbit.turn(a, b, *given)
    return Watched.made
