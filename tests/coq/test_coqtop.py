"""The cache of compiled lemmas."""

from pathlib import Path
from subprocess import CompletedProcess
from typing import Any

import pytest

from tresym.coq import coqtop


@pytest.fixture
def compilations(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The files compiled, without Coq."""
    done: list[str] = []

    def run(command: list[str], cwd: Path, **_: Any) -> CompletedProcess[str]:
        done.append(command[-1])
        Path(cwd, f"{command[-1]}o").touch()
        return CompletedProcess(command, 0)

    monkeypatch.setattr(coqtop.subprocess, "run", run)
    monkeypatch.setattr(coqtop, "version", lambda: "8.16.1")
    return done


def compiled(text: str) -> tuple[str, ...]:
    return coqtop.library.__wrapped__(text)


def test_the_same_lemmas_are_compiled_once(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, compilations: list[str]
) -> None:
    monkeypatch.setattr(coqtop, "cache_folder", lambda: tmp_path)
    assert compiled("one") == compiled("one")
    assert compilations == ["Tresym.v", "Racket.v"]


def test_other_lemmas_and_another_coq_are_compiled_again(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, compilations: list[str]
) -> None:
    monkeypatch.setattr(coqtop, "cache_folder", lambda: tmp_path)
    first = compiled("one")
    assert compiled("two") != first
    assert compilations == ["Tresym.v", "Racket.v", "Racket.v"]
    monkeypatch.setattr(coqtop, "version", lambda: "8.17.0")
    assert compiled("one") != first
    assert compilations[3:] == ["Tresym.v", "Racket.v"]


@pytest.mark.parametrize("folder", [None, Path("/dev/null/nowhere")])
def test_without_a_cache_they_are_compiled_for_this_process(
    monkeypatch: pytest.MonkeyPatch, folder: Path | None, compilations: list[str]
) -> None:
    monkeypatch.setattr(coqtop, "cache_folder", lambda: folder)
    assert Path(compiled("one")[1], "Tresym.v").is_file()


def test_what_is_not_compiled_to_its_end_is_not_kept(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    def interrupted(*_: Any, **__: Any) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(coqtop, "cache_folder", lambda: tmp_path)
    monkeypatch.setattr(coqtop, "version", lambda: "8.16.1")
    monkeypatch.setattr(coqtop.subprocess, "run", interrupted)
    with pytest.raises(KeyboardInterrupt):
        compiled("one")
    assert not [*(tmp_path / "coq").iterdir()]
