"""How long ``tresym flip`` takes from the shell, against Python importing python-flint alone."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import tresym
from tresym.bench.run import Contender, Measurement, interleave

WORK = {
    "python -c 'import flint'": ["-c", "import flint"],
    "tresym flip": ["-m", "tresym", "flip", "--shape", "12.5372", "0.0629"],
}


def _launch(words: list[str]) -> Callable[[], float]:
    environment = {**os.environ, "PYTHONPATH": str(Path(tresym.__file__).parent.parent)}

    def sample() -> float:
        start = time.perf_counter()
        subprocess.run(
            [sys.executable, *words], stdout=subprocess.DEVNULL, env=environment, check=True
        )
        return time.perf_counter() - start

    return sample


def measure(rounds: int = 20) -> Measurement:
    """The workload ``startup``: whole processes, interleaved."""
    contenders = [Contender(name, _launch(words)) for name, words in WORK.items()]
    says = "a whole process, from its start to its end"
    return Measurement("startup", says, rounds, interleave(contenders, rounds), next(iter(WORK)))
