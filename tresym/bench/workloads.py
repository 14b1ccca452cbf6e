"""The workloads by name, how to run one, and where saved measurements are."""

from __future__ import annotations

import json
import time
from importlib import import_module
from pathlib import Path
from typing import Any

import tresym
from tresym.bench.names import WORKLOADS
from tresym.bench.run import Keep, Measurement, Pace, Tables, Timing, Workload, forget
from tresym.output import write_text
from tresym.reals.numbers.exact import InputError, quoted

KEEP_EVERY = 0.2
"""Seconds between two writings of what has been measured so far."""


def measure(name: str, keep: Keep = forget, pace: Pace | None = None) -> Measurement:
    """Run one workload; ``keep`` is called with what it has after each sample.

    Raises:
        InputError: an unknown name, or a library that the workload needs is not installed.
    """
    if name not in WORKLOADS:
        raise InputError(f"workload: {quoted(name)} is not known; known: {', '.join(WORKLOADS)}")
    try:
        found: Workload = import_module(f"tresym.bench.{name}").WORKLOAD
        return found.measure(name, WORKLOADS[name], keep, pace)
    except ModuleNotFoundError as error:
        raise InputError(f"bench: needs {error.name} (pip install -e '.[bench]')") from None


def folder() -> Path:
    """docs/measurements of the checkout.

    Raises:
        InputError: this is not a checkout.
    """
    docs = Path(tresym.__file__).resolve().parent.parent / "docs"
    if not docs.is_dir():
        raise InputError("--save: measurements are kept in a checkout's docs/ folder; this is none")
    (docs / "measurements").mkdir(exist_ok=True)
    return docs / "measurements"


def save(measurement: Measurement, home: Path | None = None) -> str:
    """Write the measurement to docs/measurements/ of the checkout; returns its path there.

    An interrupted one is written beside, as NAME.partial.json, and what stood there before stays.

    Raises:
        InputError: this is not a checkout.
    """
    home = home or folder()
    partial = home / f"{measurement.workload}.partial.json"
    path = home / f"{measurement.workload}.json" if measurement.complete else partial
    write_text(str(path), json_text(measurement.as_json()))
    if measurement.complete:
        partial.unlink(missing_ok=True)
    return f"docs/measurements/{path.name}"


def keeper(name: str, home: Path) -> Keep:
    """Keeps the samples of a running workload in NAME.partial.json, whole at every moment."""
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
    """JSON with one line for each key and for each row, so that changes can be read."""
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
    """The timings as a table for people, with machine and versions."""
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
