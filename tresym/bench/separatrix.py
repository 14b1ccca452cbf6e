"""ε₀ to 50 digits: mpmath on the paper's own equation against the same root in its phase.

The peer does what a reader of the paper would do: ``findroot`` on the exact equation as printed,
from the paper's asymptotic formula. Each contender runs in a process of its own kind, one with
mpmath on gmpy2 and one with mpmath in pure Python, and hands back what it found so that its digits
can be counted against the ball.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import IO, Any

from flint import arb

import tresym
from tresym.arithmetic import ball_precision, mp_precision, to_mp
from tresym.bench.run import Contender, Measurement, interleave
from tresym.body import named_body
from tresym.flip import separatrix
from tresym.formulas import printed, stable

BODY = "str"
DIGITS = 50
SAMPLE_SECONDS = 0.01

SHAPE = named_body(BODY).shape


def findroot_printed() -> Any:
    """``mpmath.findroot`` on the printed equation from the paper's asymptotic formula."""
    with mp_precision(DIGITS) as mp:
        a, b = to_mp(SHAPE.a, mp), to_mp(SHAPE.b, mp)
        start = printed.asymptotic_defect(a, b, mp)
        return mp.findroot(lambda e: printed.separatrix_residual(e, a, b, mp), start)


def newton_phase() -> Any:
    """Our phase equation in mpmath: Newton's method from the float64 root; not certified."""
    with mp_precision(DIGITS + 5) as mp:
        a, b = to_mp(SHAPE.a, mp), to_mp(SHAPE.b, mp)
        k, r = mp.sqrt(a * b), mp.sqrt(b / a)
        phase = mp.mpf(separatrix.float_phase(float(k), float(b))[0])
        for _ in range(2):
            residual = phase - stable.phase_map(phase, k, r, mp)
            phase -= residual / stable.phase_slope(phase, k, r, mp)
        return stable.defect_at(phase, k, r, mp)


def certified() -> arb:
    """What ``tresym flip`` computes: the ball, its digits proved."""
    return separatrix.solve(SHAPE.a, SHAPE.b, DIGITS).defect


WORK: dict[str, Callable[[], Any]] = {
    "findroot on the printed equation": findroot_printed,
    "our phase equation in mpmath": newton_phase,
    "tresym, certified": certified,
}


def time_once(work: Callable[[], Any], seconds: float = SAMPLE_SECONDS) -> float:
    """Processor seconds one call takes, over as many calls as fill ``seconds``.

    Processor time, so that what else the machine does is not counted.
    """
    calls = 1
    while True:
        start = time.process_time()
        for _ in range(calls):
            work()
        elapsed = time.process_time() - start
        if elapsed >= seconds:
            return elapsed / calls
        calls *= 4


def digits_of(value: Any) -> int:
    """Decimal digits, at most ``DIGITS``, that a value has in common with the ball."""
    truth = separatrix.solve(SHAPE.a, SHAPE.b, 2 * DIGITS).defect
    with ball_precision(500):
        found = value.mid() if isinstance(value, arb) else arb((int(value.man), int(value.exp)))
        error = abs(found / truth - 1)
        right = -float(error.upper().log() / arb.const_log10())
    return min(DIGITS, int(right))


def serve(commands: IO[str], answers: IO[str]) -> None:
    """The process behind a contender: reads a name, times it once, writes seconds and digits."""
    for line in commands:
        work = WORK[line.strip()]
        print(json.dumps([time_once(work), digits_of(work())]), file=answers, flush=True)


@contextmanager
def worker(pure_python: bool) -> Iterator[Callable[[str], tuple[float, int]]]:
    """A process that times by name, with mpmath on gmpy2 or in pure Python."""
    environment = {**os.environ, "PYTHONPATH": str(Path(tresym.__file__).parent.parent)}
    environment.pop("MPMATH_NOGMPY", None)
    if pure_python:
        environment["MPMATH_NOGMPY"] = "1"
    process = subprocess.Popen(
        [sys.executable, "-m", "tresym.bench.separatrix"],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        encoding="utf-8",
        env=environment,
    )
    assert process.stdin is not None
    assert process.stdout is not None
    commands, answers = process.stdin, process.stdout

    def ask(name: str) -> tuple[float, int]:
        print(name, file=commands, flush=True)
        seconds, digits = json.loads(answers.readline())
        return seconds, digits

    try:
        yield ask
    finally:
        commands.close()
        process.wait()
        answers.close()


def measure(rounds: int = 40) -> Measurement:
    """The workload ``separatrix``: both mpmath backends and the certified ball, interleaved."""
    with worker(False) as on_gmpy, worker(True) as on_python:
        backends = {"python": on_python}
        if _has_gmpy():
            backends = {"gmpy2": on_gmpy, **backends}
        first = next(iter(backends.values()))
        *peers, ours = WORK
        contenders = [
            _contender(f"{name}, {backend}", name, ask)
            for name in peers
            for backend, ask in backends.items()
        ]
        contenders.append(_contender(ours, ours, first))
        timings = interleave(contenders, rounds)
    says = f"the flip defect of {BODY} on the separatrix to {DIGITS} digits"
    return Measurement("separatrix", says, rounds, timings, reference=ours)


def _contender(label: str, name: str, ask: Callable[[str], tuple[float, int]]) -> Contender:
    _, digits = ask(name)
    return Contender(label, lambda: ask(name)[0], digits)


def _has_gmpy() -> bool:
    from importlib.util import find_spec

    return find_spec("gmpy2") is not None


if __name__ == "__main__":
    serve(sys.stdin, sys.stdout)
