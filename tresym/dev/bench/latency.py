"""Command latency: wall time of complete commands, each with a budget.

The budgets are for a machine with two idle cores. For comparison, Python importing python-flint and
SymPy is measured too: no command that needs them can be faster.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import Any, NamedTuple

import tresym
from tresym.dev.bench.run import Contender, Pace, Workload


class Wait(NamedTuple):
    """Arguments for Python, the budget in seconds, and a library that is needed."""

    words: str
    goal: float | None = None
    needs: str = "flint"


WAITS = {
    "tresym verify": Wait("-m tresym verify --json", 12),
    "tresym verify eq_gamma": Wait("-m tresym verify eq_gamma --json", 1.2),
    "tresym derive": Wait("-m tresym derive", 12),
    "tresym derive eq_gamma": Wait("-m tresym derive eq_gamma", 2),
    "tresym figure flip-map": Wait("-m tresym figure flip-map", 3, "matplotlib"),
    "tresym chart work-precision": Wait("-m tresym chart work-precision", 2, "matplotlib"),
    "tresym flip": Wait("-m tresym flip --shape 12.5372 0.0629"),
    "tresym check": Wait("-m tresym check sin(2*x)==2*sin(x)*cos(x)"),
    "import tresym": Wait("-c import~tresym", 0.03),
    "import flint": Wait("-c import~flint"),
    "import sympy": Wait("-c import~sympy"),
}


def launch(words: list[str]) -> Callable[[], float]:
    """Return a sample function: the wall time of Python with these arguments, start to end."""
    environment = {**os.environ, "PYTHONPATH": str(Path(tresym.__file__).parent.parent)}

    def sample() -> float:
        with tempfile.TemporaryFile() as nowhere:
            start = time.perf_counter()
            subprocess.run([sys.executable, *words], stdout=nowhere, env=environment, check=True)
            return time.perf_counter() - start

    return sample


def contenders(_: Any) -> Iterator[Contender]:
    """Yield the commands as complete processes, to be measured in turn."""
    for name, (words, _, needs) in WAITS.items():
        if find_spec(needs):
            run = launch([word.replace("~", " ") for word in words.split(" ")])
            yield Contender("start to end", name, run, ours="tresym" in name, sample=run)


WORKLOAD = Workload(contenders, Pace(5, 120.0, 120.0), "import flint", "wall clock")
