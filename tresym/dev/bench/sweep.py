"""Benchmark of sweeps: rows per second, the cost of Dask, scaling, and plans for 10⁹ rows."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import AbstractContextManager, ExitStack, nullcontext
from functools import partial
from typing import Any, NamedTuple

from tresym.dev.bench.clusters import Landing, Opened, added_by_dask, environment, own_cluster
from tresym.dev.bench.run import RIGHT, WRONG, Contender, Judged, Pace, Tables, Timing, Workload
from tresym.sweep import Grid, Summary, cluster, processes, sweep
from tresym.sweep.workers import Workers


class Scene(NamedTuple):
    """A kind of sweep: its digits, the grid that is timed repeatedly, and one long run."""

    title: str
    digits: int | None
    grid: tuple[str, str]
    long: tuple[str, str]


SCENES = (
    Scene(
        "float64", None, ("0.01:100:400log", "0.00125:1:800"), ("0.01:100:1000log", "1e-3:1:1000")
    ),
    Scene("50 digits", 50, ("0.01:100:100log", "0.00625:1:160"), ("0.01:100:100log", "0.01:1:100")),
)
SERIAL, ONE_WORKER, LANDING = "this process", "Dask, 1 worker", "landing alone"

PLANNED = 10**9
"""The number of rows for which time and memory are extrapolated."""


def contenders(opened: ExitStack) -> Iterator[Contender]:
    """Yield the sweeps; processes and clusters are started before anything is timed."""
    ways: dict[str, Opened] = {SERIAL: partial(processes, 1)}
    for n in sorted({1, os.cpu_count() or 1}):
        if n > 1:
            ways[f"{n} processes"] = partial(_again, opened.enter_context(processes(n)))
        address = opened.enter_context(own_cluster(n))
        ways[ONE_WORKER if n == 1 else f"Dask, {n} workers"] = partial(cluster, address)
    for scene in SCENES:
        grid = Grid.read(*scene.grid)
        for name, way in {**ways, LANDING: Landing(grid, scene.digits).opened}.items():
            run = _Run(grid, scene.digits, way)
            yield Contender(scene.title, name, run.whole, _judge, ours=True, sample=run.seconds)


class _Run(NamedTuple):
    """A sweep into a new table."""

    grid: Grid
    digits: int | None
    opened: Opened

    def whole(self) -> Summary:
        """Run the sweep."""
        with tempfile.TemporaryDirectory() as folder:
            return sweep(self.grid, f"{folder}/table", self.digits, self.opened)

    def seconds(self) -> float:
        """Return its seconds per row."""
        return self.whole().seconds / self.grid.total


def _judge(found: Summary) -> Judged:
    if found.bad or found.computed != found.rows:
        return Judged(outcome=WRONG, why=f"{found.bad} bad rows")
    return Judged(outcome=RIGHT)


def _again(workers: Workers) -> AbstractContextManager[Workers]:
    """The workers that are open already, kept open."""
    return nullcontext(workers)


def runs(_: Any) -> Iterator[tuple[str, dict[str, Any]]]:
    """Yield what Dask adds, and one long run of each kind."""
    asked = [(scene.title, Grid.read(*scene.grid), scene.digits) for scene in SCENES]
    yield from (("added", found) for found in added_by_dask(asked, PACE.rounds))
    yield from (("runs", _long_run(scene)) for scene in SCENES)


def _long_run(scene: Scene) -> dict[str, Any]:
    """A complete process on every core: rows per second, largest process, bytes per row."""
    how = ["--float64"] if scene.digits is None else ["--digits", str(scene.digits)]
    with tempfile.TemporaryDirectory() as folder:
        path = f"{folder}/table"
        a, b = scene.long
        words = ["sweep", "-o", path, "--a", a, "--b", b, "--json", *how]
        start = time.perf_counter()
        process = subprocess.Popen(
            [sys.executable, "-m", "tresym", *words],
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            env=environment(),
        )
        assert process.stdout is not None
        said = json.loads(process.stdout.read())
        _, _, used = os.wait4(process.pid, 0)
        process.returncode = 0
        seconds = time.perf_counter() - start
        return {
            "scene": scene.title,
            "rows": said["rows"],
            "bad": said["bad"],
            "rows_per_second": round(said["rows"] / seconds),
            "largest_process_megabytes": round(used.ru_maxrss / 1024),
            "bytes_per_row": round(os.path.getsize(path) / said["rows"]),
        }


def numbers(timings: list[Timing], tables: Tables) -> dict[str, dict[str, str]]:
    """Return the numbers quoted on the page about sweeps, measured and for ``PLANNED`` rows."""
    found: dict[str, str] = {}
    at = {(t.contender.scene, t.contender.method): t for t in timings}
    for run, more in zip(tables["runs"], tables["added"], strict=True):
        scene, overhead = run["scene"], more["added"]
        key = "float" if scene == "float64" else "fifty"
        serial, landing = (at[scene, name].quartiles[1] for name in (SERIAL, LANDING))
        workers = max(1, int(serial / landing))
        found |= {
            f"sweep_{key}_rows": _thousands(run["rows"]),
            f"sweep_{key}_rate": _thousands(run["rows_per_second"]),
            f"sweep_{key}_memory": str(run["largest_process_megabytes"]),
            f"sweep_{key}_row": _plain(1e6 * serial),
            f"sweep_{key}_landing": _plain(1e6 * landing),
            f"sweep_{key}_overhead": _plain(100 * overhead),
            f"sweep_{key}_core_hours": _plain(PLANNED * serial * (1 + max(overhead, 0)) / 3600),
            f"sweep_{key}_workers": str(workers),
            f"sweep_{key}_landing_hours": _plain(PLANNED * landing / 3600),
            f"sweep_{key}_gigabytes": _plain(PLANNED * run["bytes_per_row"] / 1e9),
        }
        for (where, name), timing in at.items():
            if where == scene and name.endswith(("processes", "workers")):
                speed = 1 / (timing.ratio(at[scene, SERIAL]) or 1.0)
                found[f"sweep_{key}_{name.split(',')[0].split()[-1].lower()}"] = f"{speed:.2f}"
    return {"numbers": found}


PACE = Pace(rounds=3, limit=300, patience=300)
WORKLOAD = Workload(contenders, PACE, SERIAL, "wall clock", runs, numbers)


def _plain(x: float) -> str:
    """Two digits, or three if the first is 1, without an exponent."""
    rounded = float(f"{x:.3g}" if f"{abs(x):e}".startswith("1") else f"{x:.2g}")
    return f"{rounded:.10g}"


def _thousands(x: int) -> str:
    return f"{x:,}".replace(",", "\u202f")
