"""Benchmark of ε₀ to 50 digits: mpmath on the paper's equations against the phase equation.

The other methods are what a reader of the paper would use: ``findroot`` on the exact equation as
printed, or over ``quad`` of the paper's integral, from the paper's asymptotic formula. Two
processes run the methods, one with mpmath on gmpy2 and one with mpmath in pure Python; each returns
the seconds and the number of digits that agree with the ball. A sample is ``BLOCK`` calls.
"""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from functools import partial
from importlib.util import find_spec
from typing import Any
from unittest.mock import patch

from flint import arb, fmpq

from tresym.dev.bench import peers
from tresym.dev.bench.run import WRONG, Contender, Judged, Pace, Workload
from tresym.dev.bench.truth import SLACK, true_digits
from tresym.racket.body import Shape, named_body
from tresym.racket.flip import flip_defects, separatrix
from tresym.reals.processes import Processes

BODY = "str"
DIGITS = 50
BLOCK = 20
OURS = "tresym, certified"
PUBLIC = "tresym.flip_defect, from text"
BATCH = "tresym.flip_defects, 20 shapes"


def certified(shape: Shape, _: fmpq, digits: int) -> arb:
    """Return the ball that ``tresym flip`` computes, with its digits proved."""
    return separatrix.solve(*shape, digits).defect


def batch(shape: Shape, _: fmpq, digits: int) -> list[arb]:
    """Return a block of equal shapes computed in one call; the first is judged."""
    return [flip.defect for flip in flip_defects([shape] * BLOCK, digits=digits)]


WORK: dict[str, peers.Method] = {
    "findroot on the printed equation": peers.findroot_printed,
    "findroot over quad": peers.findroot_quad,
    "our phase equation in mpmath": peers.findroot_phase,
    PUBLIC: lambda *_: peers.from_text(BODY, "0", DIGITS),
    BATCH: lambda *asked: batch(*asked)[0],
    OURS: certified,
}


def digits_at(method: peers.Method, shape: Shape) -> float:
    """Return the correct digits of a method at a shape, at most ``DIGITS``; 0 if it fails."""
    truth = separatrix.solve(*shape, 2 * DIGITS).defect
    try:
        return true_digits(method(shape, fmpq(0), DIGITS), truth, most=DIGITS)
    except Exception:
        return 0.0


def timed(name: str) -> tuple[float, float]:
    """Return the seconds of a method in this process, over a block, and its correct digits."""
    shape, method = named_body(BODY).shape, WORK[name]
    digits = digits_at(method, shape)
    calls = 1 if name == BATCH or "quad" in name else BLOCK
    start = time.process_time()
    for _ in range(calls):
        method(shape, fmpq(0), DIGITS)
    seconds = (time.process_time() - start) / (BLOCK if name == BATCH else calls)
    return seconds, digits


def contenders(opened: ExitStack) -> Iterator[Contender]:
    """Yield both mpmath backends and the certified ball, interleaved."""
    asks = {}
    for backend in ("gmpy2", "python") if find_spec("gmpy2") else ("python",):
        process = opened.enter_context(Processes(1))
        with patch.dict(os.environ):
            os.environ.pop("MPMATH_NOGMPY", None)
            if backend == "python":
                os.environ["MPMATH_NOGMPY"] = "1"
            process.submit(timed, OURS).result()  # starts it, and imports mpmath there
        asks[backend] = partial(_ask, process)
    for name in WORK:
        if name.startswith("tresym"):
            yield _contender(name, partial(next(iter(asks.values())), name))
        else:
            for backend, ask in asks.items():
                yield _contender(f"{name}, {backend}", partial(ask, name))


def _ask(process: Processes, name: str) -> tuple[float, float]:
    found: tuple[float, float] = process.submit(timed, name).result()
    return found


def _contender(method: str, ask: Callable[[], tuple[float, float]]) -> Contender:
    ours = method.startswith(("tresym", "our"))
    return Contender("ε₀", method, ask, _judge, ours, DIGITS, sample=lambda: ask()[0])


def _judge(answer: Any) -> Judged:
    digits = answer[1]
    if digits >= DIGITS - SLACK:
        return Judged(digits, DIGITS)
    return Judged(digits, DIGITS, WRONG, f"{digits:.1f} true digits of {DIGITS}")


WORKLOAD = Workload(contenders, Pace(rounds=40, patience=2.0), OURS)
