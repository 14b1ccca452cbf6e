"""A short look at everything first; Ctrl-C keeps what is done."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from tresym.checking.time_limited import Task
from tresym.commands import main
from tresym.manuscript import attempts
from tresym.manuscript.attempts import INTERRUPTED, answers_to
from tresym.manuscript.classification import Attempt, Link
from tresym.manuscript.source import Display
from tresym.reals.decisions.answer import Answer
from tresym.reals.verdict import Cause, Verdict

DISPLAY = Display(1, "brackets", (), "", 1, "")


def link(*texts: str) -> Link:
    return Link(DISPLAY, 1, claims=tuple(Attempt(text, "", text) for text in texts))


class Script:
    """Stands for the deciders: what is asked, and the answers by text and limit."""

    def __init__(self, slow: dict[str, Verdict], stop: str = "") -> None:
        self.slow, self.stop = slow, stop
        self.asked: list[tuple[str, float]] = []

    def __call__(
        self, tasks: list[Task], limit: float, processes: int | None
    ) -> Iterator[tuple[Task, Answer]]:
        for task in tasks:
            if task.claim == self.stop:
                raise KeyboardInterrupt
            self.asked.append((task.claim, limit))
            if task.claim in self.slow:
                stopped = Answer(Verdict.UNDECIDED, "too long", cause=Cause.STOPPED)
                yield task, Answer(self.slow[task.claim], "why") if limit > 1 else stopped
            else:
                yield task, Answer(Verdict.PROVED if "true" in task.claim else Verdict.REFUTED, "")


def run(
    monkeypatch: pytest.MonkeyPatch, script: Script, links: list[Link], keep: bool = False
) -> attempts.Found:
    monkeypatch.setattr(attempts, "check_all", script)
    return answers_to(links, 5.0, 1, lambda done, total: None, keep)


def test_what_was_stopped_gets_the_full_limit_only_where_nothing_passed(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    script = Script({"slow": Verdict.PROVED, "slower": Verdict.REFUTED})
    found = run(monkeypatch, script, [link("slow", "true"), link("slow", "false"), link("slower")])
    assert script.asked[-2:] == [("slow", 5.0), ("slower", 5.0)]
    assert script.asked.count(("slow", 5.0)) == 1
    verdicts = {n: [answer.verdict.value for answer in found[n]] for n in found}  # type: ignore[union-attr]
    assert verdicts == {0: ["UNDECIDED", "PROVED"], 1: ["PROVED"], 2: ["REFUTED"]}


def test_an_interrupted_link_is_open_even_if_one_of_its_readings_is_refuted(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    links = [link("true"), link("false", "stop"), link("false")]
    with pytest.raises(KeyboardInterrupt):
        run(monkeypatch, Script({}, "stop"), links)
    found = run(monkeypatch, Script({}, "stop"), links, keep=True)
    assert [found[n][-1].verdict.value for n in range(3)] == ["PROVED", "UNDECIDED", "REFUTED"]  # type: ignore[union-attr]
    assert found[1] == [Answer(Verdict.UNDECIDED, INTERRUPTED, cause=Cause.INTERRUPTED)]


def test_an_interrupted_run_shows_what_is_done_and_fails(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    paper = tmp_path / "m.tex"
    paper.write_text("We have \\[ x + x = 2x \\] and \\[ x y = y x . \\]")
    monkeypatch.setattr(attempts, "check_all", Script({}, "x*y == y*x"))
    known = tmp_path / "known"
    assert main(["paper", str(paper), "--baseline", str(known), "--update-baseline"]) == 130
    assert INTERRUPTED in capsys.readouterr().out
    assert not known.exists()
