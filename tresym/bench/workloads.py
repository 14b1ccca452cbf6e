"""The workloads by name, how one is run, and where a saved measurement stands."""

from __future__ import annotations

import json
from importlib import import_module
from pathlib import Path

import tresym
from tresym.bench.run import Measurement, Timing
from tresym.exact import InputError
from tresym.report.output import write_text

WORKLOADS = ("separatrix", "startup", "identities", "turn", "defect", "flipmap")
"""Each is a module of this package with a function ``measure()``."""


def measure(name: str) -> Measurement:
    """Run one workload.

    Raises:
        InputError: an unknown name.
    """
    if name not in WORKLOADS:
        raise InputError(f"workload: {name!a} is not known; known: {', '.join(WORKLOADS)}")
    found: Measurement = import_module(f"tresym.bench.{name}").measure()
    return found


def save(measurement: Measurement) -> str:
    """Write the measurement to docs/measurements/ of the checkout; returns its path there.

    Raises:
        InputError: this is not a checkout.
    """
    folder = Path(tresym.__file__).parent.parent / "docs"
    if not folder.is_dir():
        raise InputError("--save: measurements are kept in a checkout's docs/ folder; this is none")
    (folder / "measurements").mkdir(exist_ok=True)
    path = f"measurements/{measurement.workload}.json"
    write_text(str(folder / path), json.dumps(measurement.as_json(), indent=2) + "\n")
    return f"docs/{path}"


def measurement_text(measurement: Measurement) -> str:
    """The timings as a table for people."""
    width = max(len(t.name) for t in measurement.timings)
    lines = [f"{measurement.workload}: {measurement.says} ({measurement.rounds} rounds)", ""]
    lines += [f"  {_row(t, measurement.base, width)}" for t in measurement.timings]
    return "\n".join(lines) + "\n"


def _row(timing: Timing, base: Timing, width: int) -> str:
    low, median, high = timing.quartiles
    spread = f"{_time(low)} to {_time(high)}"
    digits = f"{timing.digits} digits" if timing.digits is not None else ""
    ratio = f"{timing.ratio(base):.3g} x"
    return f"{timing.name:<{width}}  {_time(median):>9}  {ratio:>8}  {spread:<22} {digits}".rstrip()


def _time(seconds: float) -> str:
    scale, unit = (1e6, "µs") if seconds < 1e-3 else (1e3, "ms") if seconds < 1 else (1, "s")
    return f"{seconds * scale:.3g} {unit}"
