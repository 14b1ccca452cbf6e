"""Claims within a limit of time: what becomes of answers, refusals, and what is lost.

The pool itself has its tests in tests/reals/test_processes.py; here one call follows the other.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import BrokenExecutor, Future
from typing import Any

import pytest

from tresym.checking import check, time_limited
from tresym.checking.time_limited import Task, _stopped_text, check_all, check_by, check_within
from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.numbers.exact import InputError
from tresym.reals.processes import StoppedError
from tresym.reals.verdict import Cause, Verdict


class Inline:
    """A pool that does the work here, and loses what it is told to lose."""

    def __init__(self, losing: dict[str, type[Exception]]) -> None:
        self.losing = losing

    def __enter__(self) -> Inline:
        return self

    def __exit__(self, *_: object) -> None:
        pass

    def in_order(
        self, work: Callable[..., Any], calls: Iterable[tuple[Any, ...]]
    ) -> Iterator[Future[Any]]:
        for call in calls:
            future: Future[Any] = Future()
            error = self.losing.get(str(call[0]))
            if error is None:
                future.set_result(work(*call))
            else:
                future.set_exception(error("stopped after 1 s"))
            yield future


@pytest.fixture
def losing(monkeypatch: pytest.MonkeyPatch) -> dict[str, type[Exception]]:
    lost: dict[str, type[Exception]] = {}
    monkeypatch.setattr(time_limited, "Processes", lambda *_, **__: Inline(lost))
    return lost


@pytest.mark.usefixtures("losing")
def test_answers_come_in_the_order_of_the_tasks_with_their_lines() -> None:
    tasks = [Task("x == x", line=3), Task("x ==", line=4), Task("x > 0", "x > 1", line=9)]
    found = list(check_all(iter(tasks)))
    assert [task for task, _ in found] == tasks
    first, refused, last = (answer for _, answer in found)
    assert isinstance(refused, InputError)
    assert isinstance(first, Answer)
    assert isinstance(last, Answer)
    assert (first.verdict, first.line) == (last.verdict, 3) == (Verdict.PROVED, 3)
    assert last.line == 9


@pytest.mark.parametrize(
    ("error", "word", "cause"),
    [
        (StoppedError, "stopped after", Cause.STOPPED),
        (BrokenExecutor, "process ended", Cause.DIED),
    ],
)
def test_what_is_lost_is_undecided_and_the_rest_is_decided(
    losing: dict[str, type[Exception]], error: type[Exception], word: str, cause: Cause
) -> None:
    losing["x > 0"] = error
    lost, kept = (answer for _, answer in check_all([Task("x > 0", "x > 1"), Task("x < x + 1")], 1))
    assert isinstance(lost, Answer)
    assert isinstance(kept, Answer)
    assert lost.verdict is Verdict.UNDECIDED
    assert word in lost.why
    assert lost.cause is cause
    assert lost.read_as == "x > 0 given x > 1"
    assert kept.verdict is Verdict.PROVED


@pytest.mark.usefixtures("losing")
def test_one_claim_is_answered_or_refused() -> None:
    assert check_within(Task("x < x + 1")).verdict is Verdict.PROVED
    assert check_within(Task(read("x < x"))).verdict is Verdict.REFUTED
    with pytest.raises(InputError):
        check_within(Task("x <"))
    assert list(check_all([])) == []


@pytest.mark.usefixtures("losing")
def test_a_procedure_that_fails_ends_no_other(monkeypatch: pytest.MonkeyPatch) -> None:
    def fails(*_: object) -> Answer:
        raise ZeroDivisionError

    monkeypatch.setattr(time_limited, "decide_claim", fails)
    found = check_within(Task("x > 0"))
    assert found.verdict is Verdict.UNDECIDED
    assert "report" in found.why
    assert found.cause is Cause.FAILED


def test_a_stopped_claim_names_the_stage_and_what_may_help_there() -> None:
    hard = StoppedError("stopped after 5 s", "sums: branch and bound")
    assert "at the stage sums: branch and bound; fewer variables" in _stopped_text(hard)
    assert "a simpler claim may help" in _stopped_text(StoppedError("stopped after 5 s", "sums"))


@pytest.mark.parametrize("limit", [0, -1, float("inf"), float("nan"), "5", 10**6])
def test_a_limit_is_a_number_of_seconds(limit: Any) -> None:
    with pytest.raises(InputError, match="seconds"):
        check("x == x", limit=limit)


@pytest.mark.usefixtures("losing")
def test_workers_elsewhere_give_the_same_answers(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(time_limited, "BATCH", 2)
    tasks = [Task(f"x + {k} {sign} x", line=k) for k, sign in enumerate(("==", "!=", "<", "= ="))]
    sent: list[bytes] = []

    def in_order(fn: Callable[[bytes], bytes], arguments: Iterator[bytes]) -> Iterator[bytes]:
        for each in arguments:
            sent.append(each)
            yield fn(each)

    found = list(check_by(in_order, iter(tasks), 1))
    assert len(sent) == 2
    assert [(task, str(answer)) for task, answer in found] == [
        (task, str(answer)) for task, answer in check_all(tasks, 1)
    ]


def test_the_search_for_a_constant_does_not_use_up_the_time_of_what_is_proved(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def endless(*_: object) -> None:
        while True:
            pass

    monkeypatch.setattr("tresym.asymptotics.sharp_constants._is_sharp", lambda _: False)
    monkeypatch.setattr("tresym.asymptotics.sharp_constants._found", endless)
    answer = check_within(Task("exp(x) == 1 + x + O(x**2)", "", "x -> 0"), 1)
    assert answer.verdict.holds, answer.why
