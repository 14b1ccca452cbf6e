"""The pool: limits, deaths, order, and who may start it."""

import multiprocessing
import os
import subprocess
import sys
import time
from collections.abc import Iterator
from concurrent.futures import BrokenExecutor
from pathlib import Path

import pytest

import tresym
from tresym.reals import processes
from tresym.reals.processes import Processes, StoppedError
from tresym.reals.resource_limits import stage

pytestmark = pytest.mark.slow

HANGS = 60
"""Seconds after which a process must be hanging."""

ROOT = Path(__file__).resolve().parents[2]


def _work_for_ever() -> None:
    with stage("a long computation"):
        while True:
            pass


@pytest.mark.parametrize("forked", [True, False])
def test_a_call_over_the_limit_is_ended_and_the_next_one_made(forked: bool) -> None:
    with Processes(1, 20, forked=forked) as pool:
        first = pool.submit(os.getpid).result()
        assert first != os.getpid()
        pool._limit = 0.05
        with pytest.raises(StoppedError, match=r"stopped after 0\.05 s of processor") as stopped:
            pool.submit(_work_for_ever).result()
        assert stopped.value.stage == ("a long computation" if forked else "")
        pool._limit = 20
        assert pool.submit(os.getpid).result() != first


def test_a_call_within_a_library_is_ended_as_well() -> None:
    """No handler in Python would run before the power is computed."""
    with Processes(1, 0.05, forked=True) as pool, pytest.raises(StoppedError):
        pool.submit(pow, 3, 10**9).result()


def test_waiting_uses_no_processor_time_but_comes_to_an_end(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    with Processes(1, 0.05, forked=True) as pool:
        assert pool.submit(time.sleep, 0.2).result() is None  # four times the limit
        monkeypatch.setattr(processes, "WAIT", 0.2)
        with pytest.raises(StoppedError, match=r"did not work"):
            pool.submit(time.sleep, 600).result()


def test_a_death_is_reported_where_it_is_not_to_be_tried_again() -> None:
    with Processes(1, deaths=1, forked=True) as pool:
        with pytest.raises(BrokenExecutor):
            pool.submit(os._exit, 1).result()
        assert pool.submit(abs, -1).result() == 1


def test_answers_come_in_order_and_few_calls_are_read_ahead(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(processes, "AHEAD", 5)
    read = 0

    def calls() -> Iterator[tuple[int]]:
        nonlocal read
        for n in range(40):
            read = n + 1
            yield (-n,)

    with Processes(2, forked=True) as pool:
        for n, future in enumerate(pool.in_order(abs, calls())):
            assert future.result() == n
            assert read <= n + 5
    assert read == 40


def test_leaving_early_ends_what_is_under_way() -> None:
    def leave() -> None:
        with Processes(2, forked=True) as pool:
            pool.submit(time.sleep, 600)
            raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        leave()


KILLED = """
import os, time
from tresym.reals.processes import Processes, StoppedError
from tresym.reals.resource_limits import stage
with Processes(2, forked=True) as pool:
    for future in [pool.submit(time.sleep, 0.1) for _ in range(4)]:
        future.result()
    os.kill(os.getpid(), 9)
"""


@pytest.mark.skipif(not hasattr(os, "fork"), reason="needs fork")
def test_copies_end_with_their_parent() -> None:
    """As long as one of them lives it holds the other end of what is read here."""
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    command = [sys.executable, "-c", KILLED]
    done = subprocess.run(
        command, env=environment, stdout=subprocess.PIPE, timeout=HANGS, check=False
    )
    assert done.returncode == -9


def _decided(claim: str) -> str:
    return tresym.check(claim, limit=60).verdict.value


def test_a_worker_of_another_pool_may_start_processes() -> None:
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        assert pool.map(_decided, ["x < x + 1"]) == ["PROVED"]


UNGUARDED = """
from functools import partial
from tresym.sweep import Grid, processes, sweep
found = sweep(Grid.read("1,2", "0.2:1:20", "0"), "t", 9, partial(processes, 2))
print(found.computed)
"""


@pytest.mark.parametrize("from_file", [True, False])
def test_a_script_needs_no_guard(from_file: bool, tmp_path: Path) -> None:
    (tmp_path / "script.py").write_text(UNGUARDED)
    done = subprocess.run(
        [sys.executable, "script.py" if from_file else "-"],
        input="" if from_file else UNGUARDED,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=False,
    )
    assert (done.returncode, done.stdout) == (0, "40\n"), done.stderr
