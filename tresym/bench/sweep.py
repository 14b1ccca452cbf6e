"""Sweeps: rows a second here, what Dask costs, how it scales, and the numbers to plan 10⁹ rows."""

from __future__ import annotations

import json
import os
import pickle
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, Future
from contextlib import AbstractContextManager, ExitStack, contextmanager, nullcontext
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

import tresym
from tresym.bench.run import (
    RIGHT,
    WRONG,
    Contender,
    Judged,
    Keep,
    Measurement,
    Pace,
    Timing,
    forget,
    interleave,
)
from tresym.sweep import Grid, Summary, cluster, processes, sweep
from tresym.sweep.run import batch_size, computed
from tresym.sweep.workers import Workers


class Scene(NamedTuple):
    """A kind of sweep: its digits, the grid that is timed again and again, and one long run."""

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

PACE = Pace(rounds=3, limit=300, patience=300)

QUIET = {
    "DASK_DISTRIBUTED__WORKER__PROFILE__ENABLED": "False",
    "DASK_DISTRIBUTED__ADMIN__TICK__INTERVAL": "500ms",
}
"""How the page says to start workers: Dask's own profiler would take a tenth of each."""

PLANNED = 10**9
"""Rows of the sweep that is planned."""

CLUSTER = """
import sys
from distributed import LocalCluster
if __name__ == "__main__":
    with LocalCluster(
        n_workers=int(sys.argv[1]), threads_per_worker=1, processes=True, dashboard_address=None
    ) as found:
        print(found.scheduler_address, flush=True)
        sys.stdin.read()
"""

Opened = Callable[[], AbstractContextManager[Workers]]


def measure(
    keep: Keep = forget, pace: Pace = PACE, scenes: tuple[Scene, ...] = SCENES
) -> Measurement:
    """The workload ``sweep``; the processes and clusters are up before anything is timed."""
    with ExitStack() as stack:
        ways: dict[str, Opened] = {SERIAL: partial(processes, 1)}
        addresses: dict[int, str] = {}
        for n in sorted({1, os.cpu_count() or 1}):
            if n > 1:
                kept = stack.enter_context(processes(n))
                ways[f"{n} processes"] = partial(_again, kept)
            address = addresses[n] = stack.enter_context(_cluster(n))
            ways[ONE_WORKER if n == 1 else f"Dask, {n} workers"] = partial(cluster, address)
        contenders = [c for scene in scenes for c in _contenders(scene, ways)]
        timings, complete = interleave(contenders, pace, keep)
        added = [_added(scene, addresses[1], pace.rounds) for scene in scenes] if complete else []
    runs = [_long_run(scene) for scene in scenes] if complete else []
    return Measurement(
        "sweep",
        "seconds a row of a sweep, and long runs with their memory",
        timings,
        SERIAL,
        "wall clock",
        notes={"numbers": _numbers(timings, runs, added)} if complete else {},
        tables={"runs": runs, "added": added},
        complete=complete,
    )


def _contenders(scene: Scene, ways: dict[str, Opened]) -> Iterator[Contender]:
    grid = Grid.read(*scene.grid)
    for name, opened in {**ways, LANDING: _Landing(grid, scene.digits).opened}.items():
        run = _Run(grid, scene.digits, opened)
        yield Contender(scene.title, name, run.whole, _judge, ours=True, sample=run.seconds)


class _Run(NamedTuple):
    """A sweep into a new table."""

    grid: Grid
    digits: int | None
    opened: Opened

    def whole(self) -> Summary:
        """The sweep."""
        with tempfile.TemporaryDirectory() as folder:
            return sweep(self.grid, f"{folder}/table", self.digits, self.opened)

    def seconds(self) -> float:
        """Its seconds a row."""
        return self.whole().seconds / self.grid.total


def _added(scene: Scene, address: str, rounds: int) -> dict[str, Any]:
    """What Dask adds to the processor time of a sweep: its one worker, its scheduler and this."""
    from distributed import Client

    grid = Grid.read(*scene.grid)
    here, there = (_Run(grid, scene.digits, way) for way in
                   (partial(processes, 1), partial(cluster, address)))  # fmt: skip
    pairs = []
    with Client(address, set_as_default=False) as client:

        def used() -> float:
            far = client.run(time.process_time).values()
            return float(sum(far) + client.run_on_scheduler(time.process_time))

        for _ in range(rounds):
            start = time.process_time()
            here.whole()
            alone, before = time.process_time() - start, used()
            start = time.process_time()
            there.whole()
            pairs.append((alone, time.process_time() - start + used() - before))
    return {
        "scene": scene.title,
        "processor_seconds": [[round(x, 3) for x in pair] for pair in pairs],
        "added": round(statistics.median(dask / alone for alone, dask in pairs) - 1, 4),
    }


def _judge(found: Summary) -> Judged:
    if found.bad or found.computed != found.rows:
        return Judged(outcome=WRONG, why=f"{found.bad} bad rows")
    return Judged(outcome=RIGHT)


class _Landing(Executor):
    """Knows the answers that a worker would send: what it leaves to do is to land them."""

    def __init__(self, grid: Grid, digits: int | None) -> None:
        self.grid, self.digits = grid, digits
        self.answers: dict[bytes, bytes] = {}

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        """The rows of the part that is asked for."""
        future: Future[Any] = Future()
        future.set_result(self.answers[args[0]])
        return future

    @contextmanager
    def opened(self) -> Iterator[Workers]:
        """The answers are computed when it is opened first, which is not timed."""
        if not self.answers:
            size = batch_size(self.grid.total, self.digits)
            for _, part in self.grid.parts(size, ()):
                asked = pickle.dumps((part, self.digits))
                self.answers[asked] = computed(asked)
        yield Workers(self, 1)


def _again(workers: Workers) -> AbstractContextManager[Workers]:
    """What is open already, and stays so."""
    return nullcontext(workers)


@contextmanager
def _cluster(workers: int) -> Iterator[str]:
    """The address of a scheduler with so many worker processes of one thread each."""
    process = subprocess.Popen(
        [sys.executable, "-c", CLUSTER, str(workers)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
        env=_environment(),
    )
    assert process.stdin is not None
    assert process.stdout is not None
    try:
        yield process.stdout.readline().strip()
    finally:
        process.stdin.close()
        try:
            process.wait(10)
        except subprocess.TimeoutExpired:
            process.kill()


def _environment() -> dict[str, str]:
    return {**os.environ, **QUIET, "PYTHONPATH": str(Path(tresym.__file__).parent.parent)}


def _long_run(scene: Scene) -> dict[str, Any]:
    """A whole process on every core: rows a second, the largest process, bytes a row."""
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
            env=_environment(),
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
            "processes": os.cpu_count(),
            "seconds": round(seconds, 2),
            "rows_per_second": round(said["rows"] / seconds),
            "processor_seconds": round(used.ru_utime + used.ru_stime, 2),
            "largest_process_megabytes": round(used.ru_maxrss / 1024),
            "bytes_per_row": round(os.path.getsize(path) / said["rows"]),
        }


def _numbers(
    timings: list[Timing], runs: list[dict[str, Any]], added: list[dict[str, Any]]
) -> dict[str, str]:
    """What the page on sweeps quotes, by name: as measured, and for ``PLANNED`` rows."""
    found: dict[str, str] = {}
    at = {(t.contender.scene, t.contender.method): t for t in timings}
    for run, more in zip(runs, added, strict=True):
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
    return found


def _plain(x: float) -> str:
    """Two digits, or three where the first is 1, and no exponent."""
    rounded = float(f"{x:.3g}" if f"{abs(x):e}".startswith("1") else f"{x:.2g}")
    return f"{rounded:.10g}"


def _thousands(x: int) -> str:
    return f"{x:,}".replace(",", "\u202f")
