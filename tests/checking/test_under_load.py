"""A busy machine gives the verdicts of an idle one: limits count processor time, not wall time."""

import multiprocessing
import random
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from tresym.checking.time_limited import Task, check_all
from tresym.reals.decisions.answer import Answer
from tresym.reals.processes import cores

CLAIMS = Path(__file__).parents[1] / "data" / "claims"
SLOW = (
    "integral(x**2*exp(-x)*cos(x), x, 0, 1) == 1",
    "sum(k**5, k, 1, n) == n**2*(n + 1)**2*(2*n**2 + 2*n - 1)/12",
    "abs(sin(x) - (x - x**3/6 + x**5/120)) <= 1/5040*x**7 given 0 <= x <= 1",
)


def work_for_ever() -> None:
    while True:
        pass


@contextmanager
def busy(count: int) -> Iterator[None]:
    """Keep processors busy inside the block."""
    processes = [multiprocessing.Process(target=work_for_ever, daemon=True) for _ in range(count)]
    try:
        for process in processes:
            process.start()
        yield
    finally:
        for process in processes:
            process.kill()
            process.join()


def sample(count: int) -> list[Task]:
    """Claims of the lists with known truth, drawn by a fixed seed."""
    lines = [
        line.partition("|")[2].strip()
        for path in sorted(CLAIMS.glob("*.txt"))
        for line in path.read_text(encoding="utf-8").splitlines()
        if line.startswith(("true |", "false |"))
    ]
    return [Task(text) for text in random.Random(1).sample(lines, count)]


def verdicts(tasks: list[Task], limit: float) -> list[tuple[str, object]]:
    return [
        (str(task.claim), found.verdict if isinstance(found, Answer) else str(found))
        for task, found in check_all(tasks, limit)
    ]


@pytest.mark.night
def test_a_loaded_machine_gives_the_same_verdicts() -> None:
    """With a limit on wall time the slower claims are stopped beside the busy processes."""
    tasks = [*map(Task, SLOW), *sample(10)]
    idle = verdicts(tasks, 2)
    with busy(2 * cores()):
        assert verdicts(tasks, 2) == idle


@pytest.mark.night
def test_two_hundred_claims_give_the_same_verdicts_beside_four_busy_processes() -> None:
    tasks = sample(200)
    idle = verdicts(tasks, 5)
    with busy(4):
        assert verdicts(tasks, 5) == idle
