"""Run the workloads by name, and save and print their measurements."""

from __future__ import annotations

import json
import time
from importlib import import_module
from pathlib import Path
from typing import Any

import tresym
from tresym.dev.bench.names import MODULES, WORKLOADS
from tresym.dev.bench.run import Keep, Measurement, Pace, Tables, Timing, Workload, forget
from tresym.output import write_text
from tresym.reals.numbers.exact import InputError, quoted

KEEP_EVERY = 0.2
"""Seconds between two writes of the measurement so far."""


def measure(name: str, keep: Keep = forget, pace: Pace | None = None) -> Measurement:
    """Run one workload.

    Args:
        name: one of :data:`~tresym.dev.bench.names.WORKLOADS`.
        keep: called with the samples so far after each one.
        pace: how many samples to take and for how long; None uses the workload's own.

    Raises:
        InputError: there is no such workload, or a library that it needs is not installed.
    """
    if name not in WORKLOADS:
        raise InputError(f"workload: {quoted(name)} is not known; known: {', '.join(WORKLOADS)}")
    try:
        found: Workload = import_module(MODULES[name]).WORKLOAD
        return found.measure(name, WORKLOADS[name], keep, pace)
    except ModuleNotFoundError as error:
        raise InputError(f"bench: needs {error.name} (pip install -e '.[bench]')") from None


def folder() -> Path:
    """Return docs/measurements of the source checkout.

    Raises:
        InputError: tresym does not run from a checkout.
    """
    docs = Path(tresym.__file__).resolve().parent.parent / "docs"
    if not docs.is_dir():
        raise InputError(
            "--save: measurements are saved in the docs/ folder of a "
            "source checkout, and tresym is "
            "not running from one"
        )
    (docs / "measurements").mkdir(exist_ok=True)
    return docs / "measurements"


def save(measurement: Measurement, home: Path | None = None) -> str:
    """Write a measurement to docs/measurements/.

    An interrupted measurement is written to NAME.partial.json, and the complete one stays.

    Returns:
        The path of the file, relative to the checkout.

    Raises:
        InputError: tresym does not run from a checkout.
    """
    home = home or folder()
    partial = home / f"{measurement.workload}.partial.json"
    path = home / f"{measurement.workload}.json" if measurement.complete else partial
    write_text(str(path), json_text(measurement.as_json()))
    if measurement.complete:
        partial.unlink(missing_ok=True)
    return f"docs/measurements/{path.name}"


def keeper(name: str, home: Path) -> Keep:
    """Return a function that saves the samples so far in NAME.partial.json, at most every 0.2 s."""
    last = time.monotonic()

    def keep(timings: list[Timing], tables: Tables | None = None) -> None:
        nonlocal last
        if time.monotonic() - last < KEEP_EVERY:
            return
        so_far = Measurement(name, WORKLOADS[name], timings, tables=tables or {}, complete=False)
        save(so_far, home)
        last = time.monotonic()

    return keep


def json_text(value: dict[str, Any]) -> str:
    """Return JSON with one line for each key and each row, so that differences can be read."""
    lines = []
    for key, item in value.items():
        if isinstance(item, list):
            rows = ",\n".join(f"  {json.dumps(row, ensure_ascii=False)}" for row in item)
            text = f"[\n{rows}\n ]"
        else:
            text = json.dumps(item, ensure_ascii=False)
        lines.append(f" {json.dumps(key)}: {text}")
    return "{\n" + ",\n".join(lines) + "\n}\n"


def measurement_text(measurement: Measurement) -> str:
    """Return the timings as a table for people, with machine and versions."""
    found = measurement.as_json()
    lines = [f"{measurement.workload}: {measurement.says}"]
    machine, versions = found["machine"], found["versions"]
    lines.append(f"  {machine['processor']}, {machine['cores']} cores; {measurement.clock}")
    lines.append("  " + ", ".join(f"{k} {v}" for k, v in versions.items()))
    if not measurement.complete:
        lines.append("  interrupted: these are the samples so far")
    scene = None
    for row in found["rows"]:
        if row["scene"] != scene:
            scene = row["scene"]
            lines += ["", f"  {scene}"]
        lines.append(f"    {_row(row)}")
    for name, note in found.get("notes", {}).items():
        lines += ["", f"  {name}", *_note(note)]
    return "\n".join(lines) + "\n"


def _row(row: dict[str, Any]) -> str:
    name = row["method"] + (f", {row['asked']:g}" if row["asked"] is not None else "")
    if row["seconds"] is None:
        return f"{name:<44} {row['outcome']}: {row['why'] or 'not timed'}"
    low, high = row["quartiles"]
    ratio = "" if row["ratio"] is None else f"{row['ratio']:.3g} x"
    spread = f"{_time(low)} to {_time(high)}"
    digits = "" if row["digits"] is None else f"{row['digits']:g} true digits"
    text = f"{name:<44} {_time(row['seconds']):>9} {ratio:>9}  {spread:<22} {digits}"
    return text.rstrip() + (f"; {row['outcome']}: {row['why']}" if row["why"] else "")


def _note(note: Any) -> list[str]:
    if not isinstance(note, dict):
        return [f"    {note}"]
    return [
        f"    {key}: "
        + (", ".join(f"{k} {v}" for k, v in item.items()) if isinstance(item, dict) else str(item))
        for key, item in note.items()
    ]


def _time(seconds: float) -> str:
    for scale, unit in ((1e9, "ns"), (1e6, "µs"), (1e3, "ms")):
        if seconds * scale < 999.5:
            return f"{seconds * scale:.3g} {unit}"
    return f"{seconds:.3g} s"
