"""ε₀ to 50 digits: mpmath on the paper's own equations against the same root in its phase.

The peers do what a reader of the paper would do: ``findroot`` on the exact equation as printed, or
over ``quad`` of the paper's integral, from the paper's asymptotic formula. Two processes serve the
contenders, one with mpmath on gmpy2 and one with mpmath in pure Python; each hands back the seconds
and the digits its answer has in common with the ball.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from typing import Any
from unittest.mock import patch

from flint import arb, fmpq

from tresym.bench import peers
from tresym.bench.run import (
    WRONG,
    Contender,
    Judged,
    Keep,
    Measurement,
    Pace,
    forget,
    interleave,
    time_once,
)
from tresym.bench.truth import SLACK, true_digits
from tresym.racket.body import Shape, named_body
from tresym.racket.flip import flip_defect, separatrix
from tresym.reals.numbers.exact import fraction_text
from tresym.reals.processes import Processes

BODY = "str"
DIGITS = 50
OURS = "tresym, certified"
PUBLIC = "tresym.flip_defect, from text"
A, B = map(fraction_text, named_body(BODY).shape)

PRODUCTS = tuple(fmpq(10) ** (n // 2) * fmpq(3 if n % 2 else 1) for n in range(-6, 9))
"""The values of ab, 10⁻³ … 10⁴ in steps of about √10."""
WIDTHS = tuple(fmpq(*x) for x in ((1, 1), (1, 2), (1, 10), (1, 100), (1, 1000)))
SHAPES = tuple(Shape(p / b, b) for p in PRODUCTS for b in WIDTHS)
"""The 75 shapes on which correctness is counted."""


def certified(shape: Shape, _: fmpq, digits: int) -> arb:
    """What ``tresym flip`` computes: the ball, its digits proved."""
    return separatrix.solve(*shape, digits).defect


def public(_: Shape, __: fmpq, digits: int) -> arb:
    """The same of ``BODY``, as a user asks for it: text is read, and a value comes back."""
    return flip_defect(A, B, digits=digits).defect


WORK: dict[str, peers.Method] = {
    "findroot on the printed equation": peers.findroot_printed,
    "findroot over quad": peers.findroot_quad,
    "our phase equation in mpmath": peers.findroot_phase,
    PUBLIC: public,
    OURS: certified,
}


def digits_at(method: peers.Method, shape: Shape) -> float:
    """True digits, at most ``DIGITS``, of a method at a shape; 0 where it fails."""
    truth = separatrix.solve(*shape, 2 * DIGITS).defect
    try:
        return true_digits(method(shape, fmpq(0), DIGITS), truth, most=DIGITS)
    except Exception:
        return 0.0


def timed(name: str) -> tuple[float, float]:
    """The seconds that a method takes once in this process, and its true digits."""
    shape = named_body(BODY).shape
    return time_once(partial(WORK[name], shape, fmpq(0), DIGITS)), digits_at(WORK[name], shape)


Ask = Callable[[str], tuple[float, float]]


@contextmanager
def worker(pure_python: bool) -> Iterator[Ask]:
    """A process that times by name, with mpmath on gmpy2 or in pure Python."""
    with Processes(1) as process:
        with patch.dict(os.environ):
            os.environ.pop("MPMATH_NOGMPY", None)
            if pure_python:
                os.environ["MPMATH_NOGMPY"] = "1"
            process.submit(timed, OURS).result()  # starts it, and imports mpmath there
        yield lambda name: process.submit(timed, name).result()


PACE = Pace(rounds=40, patience=2.0)


def measure(keep: Keep = forget, pace: Pace = PACE) -> Measurement:
    """The workload ``separatrix``: both mpmath backends and the certified ball, interleaved."""
    with worker(False) as on_gmpy, worker(True) as on_python:
        backends = {"python": on_python}
        if _has_gmpy():
            backends = {"gmpy2": on_gmpy, **backends}
        first = next(iter(backends.values()))
        contenders = [
            _contender(f"{name}, {backend}", name, ask)
            for name in WORK
            if name not in (OURS, PUBLIC)
            for backend, ask in backends.items()
        ]
        contenders += [_contender(name, name, first) for name in (PUBLIC, OURS)]
        timings, complete = interleave(contenders, pace, keep)
    says = f"the flip defect of {BODY} on the separatrix to {DIGITS} digits"
    notes = {"shapes": correct_on_shapes()} if complete else {}
    return Measurement("separatrix", says, timings, OURS, notes=notes, complete=complete)


def correct_on_shapes() -> dict[str, dict[str, int]]:
    """On how many of the 75 shapes each method has its digits, is short of 45, and of 2."""
    found = {}
    for name in ("findroot on the printed equation", OURS):
        digits = [digits_at(WORK[name], shape) for shape in SHAPES]
        found[name] = {
            "shapes": len(digits),
            "correct": sum(d >= DIGITS - SLACK for d in digits),
            "below 45 digits": sum(d < 45 for d in digits),
            "below 2 digits": sum(d < 2 for d in digits),
        }
    return found


def _contender(method: str, name: str, ask: Ask) -> Contender:
    def judge(answer: Any) -> Judged:
        digits = answer[1]
        if digits >= DIGITS - SLACK:
            return Judged(digits, DIGITS)
        return Judged(digits, DIGITS, WRONG, f"{digits:.1f} true digits of {DIGITS}")

    ours = name in (OURS, PUBLIC) or name.startswith("our")
    return Contender(
        "ε₀", method, lambda: ask(name), judge, ours, DIGITS, sample=lambda: ask(name)[0]
    )


def _has_gmpy() -> bool:
    from importlib.util import find_spec

    return find_spec("gmpy2") is not None
