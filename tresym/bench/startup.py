"""How long ``tresym flip`` takes from the shell, against Python importing python-flint alone."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import tresym
from tresym.bench.run import Contender, Keep, Measurement, Pace, forget, interleave

WORK = {
    "python -c 'import flint'": ["-c", "import flint"],
    "tresym flip": ["-m", "tresym", "flip", "--shape", "12.5372", "0.0629"],
}


def launch(words: list[str]) -> Callable[[], float]:
    """A sample: the seconds on the clock that Python takes with these words, start to end."""
    environment = {**os.environ, "PYTHONPATH": str(Path(tresym.__file__).parent.parent)}

    def sample() -> float:
        start = time.perf_counter()
        subprocess.run(
            [sys.executable, *words], stdout=subprocess.DEVNULL, env=environment, check=True
        )
        return time.perf_counter() - start

    return sample


PACE = Pace(rounds=20, patience=20.0)


def measure(keep: Keep = forget, pace: Pace = PACE) -> Measurement:
    """The workload ``startup``: whole processes, interleaved."""
    contenders = [
        Contender("start", name, run, ours=name.startswith("tresym"), sample=run)
        for name, run in ((name, launch(words)) for name, words in WORK.items())
    ]
    timings, complete = interleave(contenders, pace, keep)
    says = "a whole process, from its start to its end"
    reference = next(iter(WORK))
    return Measurement("startup", says, timings, reference, "wall clock", complete=complete)
