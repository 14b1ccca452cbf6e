"""Measure time against true digits for one expression: balls, mpmath, SciPy, a user's function.

Each method is asked for more and more digits. The true digits of an answer are counted against a
ball of many more digits, so that no method is judged by its own error estimate. Times are of the
processor, the smallest of a few runs.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import Any, NamedTuple

from flint import arb

from tresym.accuracy.other_libraries import InDoubles, InMpmath, called, loaded, takes_digits
from tresym.accuracy.values import certified, constant, placed, read
from tresym.reals.language.expression import Expr
from tresym.reals.numbers.arithmetic import ball_precision, bits, mp_precision
from tresym.reals.numbers.exact import InputError

ASKED = (5, 10, 15, 20, 30, 50, 70, 100, 150, 200)
"""The digits that are asked for."""
BEYOND = 60
"""The digits of the true value beyond the largest number asked for."""
SECONDS = 2.0
"""A method is not asked for more digits after an answer that took longer."""
REPEAT = 3


class Point(NamedTuple):
    """One measurement.

    Attributes:
        method: the name of the method.
        asked: the digits asked for; None for double precision.
        digits: the correct digits of the answer, at most the number asked for.
        seconds: processor time.
        certified: whether the method proves its digits.
    """

    method: str
    asked: int | None
    digits: float
    seconds: float
    certified: bool


def work_precision(
    expression: str | Expr,
    at: Mapping[str, str] | None = None,
    mine: Sequence[str] = (),
    asked: Sequence[int] = ASKED,
) -> list[Point]:
    """Measure every method on an expression at exact parameters.

    Args:
        expression: the expression.
        at: the value of each variable.
        mine: functions of the user, as ``module:function``.
        asked: the numbers of digits.

    Raises:
        InputError: the expression has no value, or a function is not found.
    """
    e = read(expression)
    point = {name: constant(x, name) for name, x in (at or {}).items()}
    closed = placed(e, point)
    truth = certified(closed, max(asked) + BEYOND)
    found: list[Point] = []

    def measure(name: str, ask: Callable[[int], Any], proves: bool = False) -> None:
        for digits in asked:
            answer, seconds = _timed(lambda digits=digits: ask(digits))  # type: ignore[misc]
            if answer is None:
                break
            found.append(Point(name, digits, _true(answer, truth), seconds, proves))
            if seconds > SECONDS:
                break

    measure("tresym, balls", lambda digits: certified(closed, digits), proves=True)
    measure("mpmath", lambda digits: _by_mpmath(closed, digits))
    once: dict[str, Callable[[], Any]] = {"SciPy, double": lambda: _by_scipy(closed)}
    numbers = {name: _fraction(x, name) for name, x in (at or {}).items()} if mine else {}
    for name in mine:
        function = loaded(name)
        if takes_digits(function):
            measure(name, lambda digits, f=function: called(f, numbers, digits))  # type: ignore[misc]
        else:
            once[name] = lambda f=function: called(f, numbers)  # type: ignore[misc]
    for name, ask in once.items():
        answer, seconds = _timed(ask)
        if answer is not None:
            found.append(Point(name, None, _true(answer, truth), seconds, False))
    return found


def _fraction(x: str, name: str) -> Fraction:
    value = constant(x, name)
    if value.op != "number":
        raise InputError(f"--mine: {name} must be a fraction, not {x}")
    return Fraction(int(value.args[0].p), int(value.args[0].q))


def _by_mpmath(e: Expr, digits: int) -> str:
    with mp_precision(digits + 5) as mp:
        found = InMpmath(mp, {}).value(e)
        return str(mp.nstr(mp.mpf(getattr(found, "real", found)), digits + 5))


def _by_scipy(e: Expr) -> float:
    import numpy as np

    with np.errstate(all="ignore"):
        return float(InDoubles(np, {}).value(e))


def _timed(ask: Callable[[], Any]) -> tuple[Any, float]:
    """Return an answer, None if there is none, and the least time of a few runs."""
    best = math.inf
    answer = None
    for _ in range(REPEAT):
        start = time.perf_counter()
        begin = time.process_time()
        try:
            answer = ask()
        except (InputError, ArithmeticError, ValueError, TypeError, AttributeError, ImportError):
            return None, 0.0
        spent = time.process_time() - begin
        best = min(best, spent if spent > 1e-5 else time.perf_counter() - start)
        if best > SECONDS / REPEAT:
            break
    return answer, best


def _true(answer: Any, truth: arb) -> float:
    """Return the number of true significant digits of an answer."""
    with ball_precision(bits(400)):
        try:
            x = answer if isinstance(answer, arb) else arb(_text(answer))
        except (ValueError, TypeError):
            return 0.0
        if not x.is_finite():
            return 0.0
        error = abs(x.mid() - truth) + x.rad()
        if truth.is_zero():
            return 0.0
        relative = (error / abs(truth)).upper()
        if relative.is_zero():
            return 400.0
        return max(0.0, -float(relative.log().mid()) / math.log(10))


def _text(answer: Any) -> str | float:
    return (
        answer
        if isinstance(answer, str)
        else repr(answer)
        if isinstance(answer, float)
        else str(answer)
    )
