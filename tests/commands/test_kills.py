"""kill -9 at any moment: every file is the old or the new one, whole, and nobody is left behind.

One kill of each command in every run; twenty where ``HYPOTHESIS_PROFILE`` is ``deep``, at other
moments in each chunk (see ``tests/deep.py``).
"""

import os
import random
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import chunks
import pytest
from hangs import HANGS

ROOT = Path(__file__).resolve().parents[2]
KILLS = 20 if chunks.DEEP else 1
CLAIMS = [f"(x + {n})**2 == x**2 + {2 * n}*x + {n * n}" for n in range(300)]
ROWS = ["sweep", "-o", "t", "--a", "1:9:40", "--b", "1/2,1", "--float64", "--workers", "1"]

# What `tresym docs` does once the documents are there: their texts are those of the checkout.
DOCUMENTS = """
import sys
from pathlib import Path
from tresym.report.pages import documents
home = Path(sys.argv[1])
saved = [(str(p.relative_to(home)), p.read_text()) for p in home.rglob("*") if p.suffix == ".md"]
documents.folder = lambda: Path("out")
documents.documents = lambda: saved * 20
documents.build_pages = lambda: None
documents.build()
"""


class Command(NamedTuple):
    """What is run, below which name it writes, and what is run before."""

    words: list[str]
    target: str
    first: list[str] | None = None


TRESYM = ["-m", "tresym"]
COMMANDS = {
    "check -f": Command([*TRESYM, "check", "-f", "claims", "-o", "out"], "out"),
    "sweep --export": Command([*TRESYM, *ROWS, "--export", "out.csv"], "out.csv", [*TRESYM, *ROWS]),
    "docs": Command(["-c", DOCUMENTS, str(ROOT / "docs" / "generated")], "out"),
}


def started(words: list[str], folder: Path, token: str = "") -> subprocess.Popen[bytes]:
    return subprocess.Popen(
        [sys.executable, *words],
        cwd=folder,
        env={**os.environ, "PYTHONPATH": str(ROOT), "TOKEN": token},
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )


def contents(target: Path) -> dict[str, str]:
    """What is in a file or below a folder, times aside."""
    if not target.is_dir():
        return {"": _timeless(target.read_text())} if target.exists() else {}
    files = (path for path in target.rglob("*") if path.is_file() and path.suffix != ".part")
    return {str(path.relative_to(target)): path.read_text() for path in files}


def _timeless(text: str) -> str:
    return "\n".join(x for x in text.splitlines() if not x.lstrip().startswith("time "))


def family(token: str) -> list[str]:
    """The processes whose environment holds the token."""
    found = []
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            if token.encode() in (folder / "environ").read_bytes():
                found.append(folder.name)
        except OSError:
            continue
    return found


def wait_for(condition: Callable[[], bool]) -> None:
    until = time.monotonic() + HANGS
    while not condition():
        assert time.monotonic() < until, "waited too long"
        time.sleep(0.01)


@pytest.mark.slow
@pytest.mark.skipif(not Path("/proc/self/environ").exists(), reason="needs /proc")
@pytest.mark.parametrize("name", COMMANDS)
def test_a_kill_leaves_files_whole_and_nobody_behind(name: str, tmp_path: Path) -> None:
    words, written, first = COMMANDS[name]
    (tmp_path / "claims").write_text("\n".join(CLAIMS))
    target = tmp_path / written
    if first is not None:
        assert started(first, tmp_path).wait(HANGS) == 0
    start = time.monotonic()
    assert started(words, tmp_path).wait(HANGS) == 0
    longest, whole = time.monotonic() - start, contents(target)
    assert whole
    dice = random.Random(chunks.seed_of(list(COMMANDS).index(name)))
    for kill in range(KILLS):
        if kill % 2 and target.is_file():
            target.unlink()  # the first time as well, not only in place of another
        token = f"tresym-kill-{os.getpid()}-{kill}"
        process = started(words, tmp_path, token)
        time.sleep(dice.uniform(0.2, 1.0) * longest)
        process.kill()
        process.wait(HANGS)
        wait_for(lambda token=token: not family(token))
        found = contents(target)
        assert found in ({}, whole) or (target.is_dir() and found.items() <= whole.items())
        chunks.EXAMPLES["test_a_kill_leaves_files_whole_and_nobody_behind"] += 1
    assert started(words, tmp_path).wait(HANGS) == 0
    assert contents(target) == whole
    assert not list(tmp_path.rglob("*.part"))


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP])
def test_a_process_that_is_asked_to_end_removes_what_it_began(
    number: signal.Signals, tmp_path: Path
) -> None:
    (tmp_path / "claims").write_text("\n".join(CLAIMS * 20))
    process = started([*TRESYM, "check", "-f", "claims", "-o", "out"], tmp_path)
    wait_for(lambda: bool(list(tmp_path.glob("*.part"))))
    process.send_signal(number)
    process.send_signal(number)
    assert process.wait(HANGS) == 128 + number
    assert [path.name for path in tmp_path.iterdir()] == ["claims"]
