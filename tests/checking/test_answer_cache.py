"""The cache of answers: found again, never trusted when damaged, shared by several runs."""

import json
import os
import sqlite3
import threading
from collections.abc import Callable
from pathlib import Path

import pytest
from hangs import HANGS

from tresym import repair
from tresym.checking import answer_cache, cache_folder, kept_rows, time_limited
from tresym.checking.answer_cache import AnswerCache, cached_answers, clear_cache
from tresym.checking.time_limited import Task, check_all
from tresym.commands import main
from tresym.reals.decisions.answer import Answer
from tresym.reals.verdict import Cause, Verdict

CLAIMS = [
    *("x + x == 2*x", "x**2 == 9", "exp(x) >= 1 + x", "sin(x) == x + O(x**3) as x -> 0"),
    "(x**5 - x - 1)**2*(1 + y**2) > 0",  # refuted at the root of a polynomial
]


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("TRESYM_CACHE", str(tmp_path / "cache"))
    return tmp_path / "cache"


def run(claims: list[str]) -> tuple[list[Answer], int]:
    """The answers, and how many came from the cache."""
    with cached_answers() as opened:
        found = [answer for _, answer in check_all(map(Task, claims), HANGS)]
        assert opened is not None
        return found, opened.found  # type: ignore[return-value]


def test_a_second_run_decides_nothing_and_answers_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    first, none = run(CLAIMS)
    monkeypatch.setattr(time_limited, "Processes", None)
    second, all_ = run(CLAIMS)
    assert (none, all_) == (0, len(CLAIMS))
    assert [a.as_json() for a in second] == [a.as_json() for a in first]


def test_only_what_changed_is_decided_again() -> None:
    run(CLAIMS)
    found, known = run([*CLAIMS[:2], "x + x == 3*x", *CLAIMS[2:]])
    assert known == len(CLAIMS)
    assert found[2].verdict is Verdict.REFUTED


def test_undecided_is_found_again_for_the_same_limit_alone() -> None:
    cache = AnswerCache(Path(str(kept_rows.cache_file())))
    for verdict, known in ((Verdict.UNDECIDED, False), (Verdict.PROVED, True)):
        cache.put("x == y", "", None, 1.0, Answer(verdict, "why"))
        assert cache.get("x == y", "", None, 1.0) == Answer(verdict, "why")
        assert (cache.get("x == y", "", None, 2.0) is not None) is known
        assert cache.get("x == y", "x > 0", None, 1.0) is None
    cache.close()


@pytest.mark.parametrize("cause", [cause for cause in Cause if cause.of_the_run])
def test_what_depends_on_the_run_is_not_stored(cause: Cause) -> None:
    cache = AnswerCache(Path(str(kept_rows.cache_file())))
    cache.put("x == y", "", None, 1.0, Answer(Verdict.UNDECIDED, "why", cause=cause))
    assert cache.get("x == y", "", None, 1.0) is None
    cache.close()


def test_a_stopped_claim_is_decided_by_the_next_run() -> None:
    claim = "sum(exp(-k**2)*sin(k**3), k, 1, 400) < 9"
    with cached_answers():
        (_, stopped) = next(check_all([Task(claim)], 0.0005))
    assert isinstance(stopped, Answer)
    assert stopped.cause is Cause.STOPPED
    _, known = run([claim])
    assert known == 0


@pytest.mark.parametrize("name", cache_folder.LIBRARIES)
def test_another_version_of_a_library_finds_nothing(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    version = cache_folder.version.__wrapped__
    before, installed = version(), cache_folder._installed
    monkeypatch.setattr(
        cache_folder, "_installed", lambda each: installed(each) + "x" * (each == name)
    )
    assert version() != before


def test_suggestions_are_found_again(monkeypatch: pytest.MonkeyPatch) -> None:
    asked = [("sqrt(x**2) == x", (), False)]
    with cached_answers():
        first = list(repair.suggestions(asked, 1))
    monkeypatch.setattr(repair, "_pool", None)
    with cached_answers():
        assert list(repair.suggestions(asked, 1)) == first
    assert first[0]


def test_another_version_of_the_deciders_finds_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    run(CLAIMS)
    monkeypatch.setattr(answer_cache, "version", lambda: b"another")
    assert run(CLAIMS)[1] == 0


def poison(path: Path) -> None:
    database = sqlite3.connect(path)
    for key, value in database.execute("SELECT key, value FROM answers").fetchall():
        wrong = json.dumps(json.loads(value) | {"verdict": "PROVED", "witness": None})
        database.execute("UPDATE answers SET value = ? WHERE key = ?", (wrong, key))
    database.commit()
    database.close()


def truncate(path: Path) -> None:
    path.write_bytes(path.read_bytes()[:5000])


def replace_by_text(path: Path) -> None:
    path.write_text("no database\n" * 1000)


def empty(path: Path) -> None:
    path.write_bytes(b"")


def other_table(path: Path) -> None:
    path.unlink()
    database = sqlite3.connect(path)
    database.execute("CREATE TABLE answers (what TEXT)")
    database.commit()
    database.close()


@pytest.mark.parametrize("damage", [poison, truncate, replace_by_text, empty, other_table])
@pytest.mark.slow
def test_a_damaged_cache_changes_no_answer(damage, folder: Path) -> None:  # type: ignore[no-untyped-def]
    first, _ = run(CLAIMS)
    for beside in folder.glob("*-*"):
        beside.unlink()
    damage(folder / "answers.sqlite")
    second, _ = run(CLAIMS)
    assert [(a.verdict, a.witness) for a in second] == [(a.verdict, a.witness) for a in first]
    run(CLAIMS)
    assert run(CLAIMS)[1] == len(CLAIMS)  # it is used again


@pytest.mark.parametrize("damage", [replace_by_text, other_table])
def test_a_damaged_cache_is_begun_anew_with_one_line(
    damage: Callable[[Path], None], folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    run(CLAIMS[:1])
    for beside in folder.glob("*-*"):
        beside.unlink()
    damage(folder / "answers.sqlite")
    run(CLAIMS[:1])
    assert "damaged" in capsys.readouterr().err
    run(CLAIMS[:1])
    assert capsys.readouterr().err == ""


def test_a_row_of_other_bytes_costs_one_answer(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    run(CLAIMS[:2])
    database = sqlite3.connect(folder / "answers.sqlite")
    database.execute(
        "UPDATE answers SET value = CAST(x'fffe80' AS TEXT) "
        "WHERE key = (SELECT key FROM answers LIMIT 1)"
    )
    database.commit()
    database.close()
    assert run(CLAIMS[:2])[1] == 1
    assert capsys.readouterr().err == ""


def test_a_cache_that_is_only_readable_is_read(folder: Path) -> None:
    run(CLAIMS[:1])
    file = folder / "answers.sqlite"
    file.chmod(0o400)
    cache = AnswerCache(file)
    cache.rows._forget()
    cache.rows._recover(sqlite3.OperationalError("attempt to write a readonly database"))
    if not os.access(file, os.W_OK):  # the superuser may write
        assert cache.reads_only
        assert cache.get(CLAIMS[0], "", None, HANGS) is not None


def test_a_relative_cache_folder_of_the_desktop_is_ignored(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("TRESYM_CACHE")
    monkeypatch.setenv("XDG_CACHE_HOME", "here")
    found = cache_folder.cache_folder()
    assert found is not None
    assert found.is_absolute()


def test_a_cache_that_cannot_be_written_is_told_in_one_line(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("TRESYM_CACHE", str(tmp_path / "file"))
    found, known = run(CLAIMS[:1])
    assert found[0].verdict is Verdict.PROVED
    assert known == 0
    assert capsys.readouterr().err.count("\n") == 1


def test_several_runs_share_it() -> None:
    path = kept_rows.cache_file()
    assert path is not None

    def write(start: int) -> None:
        cache = AnswerCache(path)
        for n in range(start, start + 50):
            cache.put(f"x == {n}", "", None, 1.0, Answer(Verdict.PROVED, "why"))
        cache.close()

    threads = [threading.Thread(target=write, args=(25 * n,)) for n in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    cache = AnswerCache(path)
    assert all(cache.get(f"x == {n}", "", None, 1.0) for n in range(125))
    cache.close()


def test_its_size_is_bounded(monkeypatch: pytest.MonkeyPatch, folder: Path) -> None:
    monkeypatch.setattr(kept_rows, "MAX_BYTES", 100_000)
    for _ in range(3):
        cache = AnswerCache(folder / "answers.sqlite")
        for n in range(300):
            cache.put(f"x == {n}", "", None, 1.0, Answer(Verdict.PROVED, "why " * 300))
        cache.close()
        assert (folder / "answers.sqlite").stat().st_size < 110_000


def test_it_is_cleared_and_switched_off(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    run(CLAIMS[:1])
    assert main(["paper", "--clear-cache"]) == 0
    assert not list(folder.glob("answers*"))
    assert "cleared" in capsys.readouterr().err
    claims = folder / "claims"
    claims.write_text("x + x == 2*x\n")
    assert main(["check", "-f", str(claims), "--no-cache"]) == 0
    assert not list(folder.glob("answers*"))
    assert main(["check", "-f", str(claims)]) == 0
    assert list(folder.glob("answers*"))
    monkeypatch.setenv("TRESYM_CACHE", "off")
    assert clear_cache() == "there is no cache"
