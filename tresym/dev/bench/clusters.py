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
    """Start a scheduler with ``workers`` worker processes of one thread each; yield its address."""
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
    """Return the environment of processes that import this tresym."""
    return {**os.environ, **QUIET, "PYTHONPATH": str(Path(tresym.__file__).parent.parent)}


class Landing(Executor):
    """An executor with precomputed results, to measure only the storing of batches."""

    def __init__(self, grid: Grid, digits: int | None) -> None:
        self.grid, self.digits = grid, digits
        self.answers: dict[bytes, bytes] = {}

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        """Return the rows of the part."""
        future: Future[Any] = Future()
        future.set_result(self.answers[args[0]])
        return future

    @contextmanager
    def opened(self) -> Iterator[Workers]:
        """Compute the results at the first opening, which is not timed."""
        if not self.answers:
            size = batch_size(self.grid.total, self.digits)
            for _, part in self.grid.parts(size, ()):
                asked = pickle.dumps((part, self.digits))
                self.answers[asked] = computed(asked)
        yield Workers(self, 1)


def added_by_dask(sweeps: list[tuple[str, Grid, int | None]], rounds: int) -> list[dict[str, Any]]:
    """Measure the processor time that Dask adds to each sweep (a name, a grid, digits).

    Everything runs on one core: two cores that share a unit would slow each other down, which is
    not due to Dask.
    """
    with _one_core(), own_cluster(1) as address:
        return [_added(*asked, address, rounds) for asked in sweeps]


@contextmanager
def _one_core() -> Iterator[None]:
    """Restrict this process and those it starts to one core, if the system allows it."""
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
    """The processor time beyond what the same batches take to be computed and stored.

    The batches are timed inside the workers, since the speed of a machine varies too much between
    two runs for their difference to be meaningful.
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
    """A wrapped executor whose workers record the time of the calls."""

    def __init__(self, inner: Executor) -> None:
        self.inner = inner

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        """Call ``fn`` and record its time in the worker."""
        return self.inner.submit(_clocked, fn, *args, **kwargs)


_inside = 0.0


def batches_took() -> float:
    """Return the processor seconds that this process has spent in batches."""
    return _inside


def _clocked(fn: Callable[..., Any], *args: Any) -> Any:
    """Call ``fn`` in a worker and record its time."""
    global _inside
    start = time.process_time()
    try:
        return fn(*args)
    finally:
        _inside += time.process_time() - start
