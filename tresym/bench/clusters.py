"""A local Dask cluster, and the processor time that Dask adds to a sweep."""

from __future__ import annotations

import os
import pickle
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, Future
from contextlib import AbstractContextManager, contextmanager
from functools import partial
from pathlib import Path
from typing import Any

import tresym
from tresym.sweep import Grid, cluster, sweep
from tresym.sweep.run import batch_size, computed
from tresym.sweep.workers import Workers

QUIET = {
    "DASK_DISTRIBUTED__WORKER__PROFILE__ENABLED": "False",
    "DASK_DISTRIBUTED__ADMIN__TICK__INTERVAL": "500ms",
}
"""How the page says to start workers: Dask's own profiler would take a tenth of each."""

Opened = Callable[[], AbstractContextManager[Workers]]

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


@contextmanager
def own_cluster(workers: int) -> Iterator[str]:
    """The address of a scheduler with so many worker processes of one thread each."""
    process = subprocess.Popen(
        [sys.executable, "-c", CLUSTER, str(workers)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
        env=environment(),
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


def environment() -> dict[str, str]:
    """That of processes which import this tresym."""
    return {**os.environ, **QUIET, "PYTHONPATH": str(Path(tresym.__file__).parent.parent)}


class Landing(Executor):
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


def added_by_dask(sweeps: list[tuple[str, Grid, int | None]], rounds: int) -> list[dict[str, Any]]:
    """What Dask adds to the processor time of each sweep (a name, a grid, digits).

    Everything is on one core: on two that share a unit each would be counted slower for the other's
    sake, which is not Dask's.
    """
    with _one_core(), own_cluster(1) as address:
        return [_added(*asked, address, rounds) for asked in sweeps]


@contextmanager
def _one_core() -> Iterator[None]:
    """Inside the block this process and those it starts have one core, where that can be asked."""
    if not hasattr(os, "sched_setaffinity"):
        yield
        return
    before = os.sched_getaffinity(0)
    os.sched_setaffinity(0, {min(before)})
    try:
        yield
    finally:
        os.sched_setaffinity(0, before)


def _added(name: str, grid: Grid, digits: int | None, address: str, rounds: int) -> dict[str, Any]:
    """All processor time beyond what the same batches take to compute and to land.

    The batches are clocked inside the workers: the speed of a machine changes too much from one run
    to the next for a difference of runs.
    """
    from distributed import Client

    spent = []
    landing = Landing(grid, digits)
    with Client(address, set_as_default=False) as client:

        def used() -> tuple[float, float]:
            """Processor seconds so far: of all, and of them those inside the batches."""
            far = sum(client.run(time.process_time).values())
            far += client.run_on_scheduler(time.process_time) + time.process_time()
            return float(far), float(sum(client.run(batches_took).values()))

        for _ in range(rounds + 1):
            start = time.process_time()
            _sweep(grid, digits, landing.opened)
            landed, before = time.process_time() - start, used()
            _sweep(grid, digits, partial(_clocked_cluster, address))
            total, inside = (now - then for now, then in zip(used(), before, strict=True))
            spent.append((total, inside + landed))
    del spent[0]  # what is loaded once is not the sweep's
    return {
        "scene": name,
        "processor_seconds": [[round(x, 3) for x in pair] for pair in spent],
        "added": round(statistics.median(total / work for total, work in spent) - 1, 4),
    }


def _sweep(grid: Grid, digits: int | None, opened: Opened) -> None:
    with tempfile.TemporaryDirectory() as folder:
        sweep(grid, f"{folder}/table", digits, opened)


@contextmanager
def _clocked_cluster(address: str) -> Iterator[Workers]:
    with cluster(address) as workers:
        yield workers._replace(executor=_Clocked(workers.executor))


class _Clocked(Executor):
    """Another executor whose workers remember the time that calls take."""

    def __init__(self, inner: Executor) -> None:
        self.inner = inner

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        """Call ``fn`` under the worker's clock."""
        return self.inner.submit(_clocked, fn, *args, **kwargs)


_inside = 0.0


def batches_took() -> float:
    """Processor seconds that this process has spent in batches."""
    return _inside


def _clocked(fn: Callable[..., Any], *args: Any) -> Any:
    """In a worker: call ``fn``, and remember the time it took."""
    global _inside
    start = time.process_time()
    try:
        return fn(*args)
    finally:
        _inside += time.process_time() - start
