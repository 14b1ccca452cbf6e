"""Hypothesis profiles: dev while writing, ci in every run, deep for long hunts.

All are seeded by the test itself (derandomised), or by the number of the chunk (see chunks.py), so
a failure is the same failure tomorrow.
"""

import os
import pickle
import shutil
import signal
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import chunks
import pytest
import unsuggested
from hangs import HANGS
from hypothesis import HealthCheck, settings

if TYPE_CHECKING:
    from tresym.ledger.verification import Report

_COMMON = {
    "deadline": None,
    "derandomize": True,
    "suppress_health_check": [HealthCheck.too_slow, HealthCheck.filter_too_much],
}
settings.register_profile("dev", max_examples=50, **_COMMON)
settings.register_profile("ci", max_examples=100, **_COMMON)
settings.register_profile(
    "deep", max_examples=1000 if chunks.IN_CHUNKS else 10_000, print_blob=True, **_COMMON
)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "dev"))


# Some environments forbid compiled files. Each of the many processes that the tests start would
# compile the package again, which takes longer than most of what they do.
os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
sys.dont_write_bytecode = False


# In the background of a script SIGINT is ignored, under nohup SIGHUP, and a child process would
# inherit that. A handler, unlike SIG_IGN, is reset to the default when a program is started.
if signal.getsignal(signal.SIGINT) == signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)
if signal.getsignal(signal.SIGHUP) == signal.SIG_IGN:
    signal.signal(signal.SIGHUP, lambda *_: None)


@pytest.fixture(scope="session", autouse=True)
def state_folder(tmp_path_factory: pytest.TempPathFactory) -> None:
    """Keep the record of written files apart from the user's."""
    os.environ["XDG_STATE_HOME"] = str(tmp_path_factory.getbasetemp() / "state")
    os.environ["TRESYM_CACHE"] = "off"


TESTS = Path(__file__).parent
SUGGESTING = ("repair/", "checking/test_answer_cache.py")
"""Tests of the core that read the true claims which are suggested in place of a refuted one."""
CORE = (
    *("reals/", "asymptotics/", "checking/", "racket/", "ledger/"),
    *("dev/corpus/", "dev/mutants/", "test_verdicts.py"),
)


@pytest.fixture(scope="module", autouse=True)
def no_suggestions(request: pytest.FixtureRequest) -> Iterator[None]:
    """Search for no true claims near refuted ones, half a second each, where no test reads them."""
    inner = request.path.relative_to(TESTS).as_posix()
    with pytest.MonkeyPatch.context() as patch:
        if inner.startswith(CORE) and not inner.startswith(SUGGESTING):
            patch.setattr("tresym.repair.alternatives", unsuggested.alternatives)
            patch.setattr("tresym.repair.suggestions", unsuggested.suggestions)
        yield


LONGEST = (
    "test_verdicts.py",
    *("ledger/test_verification.py", "commands/test_hostile.py", "site/test_in_the_browser.py"),
    *("site/test_explorer.py", "proofs/figures/test_figures.py", "sweep/test_sweep.py"),
    *("test_packaging.py", "report/pages/test_documents_about.py", "dev/bench/test_bench.py"),
    *("checking/test_dispatch.py", "dev/corpus/test_lists.py", "proofs/test_asymptotics.py"),
)
"""Begun first, so that no process is left with one of them while the others have nothing to do."""


def _turn(item: pytest.Item) -> int:
    inner = item.path.relative_to(TESTS).as_posix()
    return LONGEST.index(inner) if inner in LONGEST else len(LONGEST)


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    """Whether a folder need not be read: it has no quick tests, and no others are wanted."""
    if config.option.markexpr != "quick" or collection_path.parent != TESTS:
        return None
    return None if any(core.split("/")[0] == collection_path.name for core in CORE) else True


NIGHT = frozenset((TESTS / "data" / "night.txt").read_text(encoding="utf-8").splitlines())
"""Parameters of tests that take more than half a second each, and wait for the night."""


SLOW = frozenset((TESTS / "data" / "slow.txt").read_text(encoding="utf-8").splitlines())
"""Tests that take more than 0.1 seconds each, which `pytest` alone leaves out."""


TOOLS = ("dev/mutants/", "dev/corpus/", "report/charts/test_charts.py")
"""Tests of what only developers run, and of charts of measurements, which wait for the night."""


LONG = "tresym.ledger"
"""Where the classes stand whose values no line of a list names, and which take long to print."""


def _values(item: pytest.Item) -> str:
    call = getattr(item, "callspec", None)
    values = () if call is None else call.params.values()
    if any(str(type(value).__module__).startswith(LONG) for value in values):
        return ""
    return " ".join(map(str, values))


# First, so that what is marked here can be chosen by ``-m quick``.
@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    for item in items:
        inner = item.path.relative_to(TESTS).as_posix()
        if _values(item) in NIGHT or inner.startswith(TOOLS):
            item.add_marker("night")
        if item.nodeid.removeprefix("tests/") in SLOW:
            item.add_marker("slow")
        marks = {mark.name for mark in item.iter_markers()}
        if "whole" in getattr(item, "fixturenames", ()) and "night" not in marks:
            item.add_marker("slow")  # the whole ledger is judged first
            marks.add("slow")
        if inner.startswith(CORE) and not marks & {"slow", "night"}:
            item.add_marker("quick")
        if "coq" in marks and shutil.which("coqc") is None:
            item.add_marker(pytest.mark.skip(reason="coqc is not installed"))
    finished = chunks.done()
    if finished:
        config.hook.pytest_deselected(items=[item for item in items if item.nodeid in finished])
        items[:] = [item for item in items if item.nodeid not in finished]
    items.sort(key=_turn)


def pytest_runtest_logreport(report: pytest.TestReport) -> None:
    if report.when == "call":
        chunks.record(report.nodeid, report.outcome, report.duration)


CORE_ALONE = "not slow and not coq and not night"
"""The tests that ``pytest`` runs without ``-m``."""


def pytest_terminal_summary(
    terminalreporter: pytest.TerminalReporter, config: pytest.Config
) -> None:
    if config.option.markexpr == CORE_ALONE:
        terminalreporter.write_line(
            "These were the core tests. The others: pytest -m slow (minutes), pytest -m night "
            "(an hour), pytest -m coq (needs Coq); .ci/run runs core and slow."
        )


@pytest.fixture
def pdflatex() -> str:
    """LaTeX, which is there in CI."""
    found = shutil.which("pdflatex")
    if found is None:
        assert not os.environ.get("CI"), "TeX Live must be there in CI"
        pytest.skip("pdflatex is not installed (Debian: texlive-latex-extra)")
    return found


def _kept(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where the process that judges the ledger leaves it for the others."""
    return tmp_path_factory.getbasetemp().parent / "ledger.pickle"


def _read(kept: Path) -> "Report | None":
    """The judged ledger; None if that failed."""
    from tresym.ledger.paper import all_claims
    from tresym.ledger.verification import Report, Row

    data = kept.read_bytes()
    found = pickle.loads(data) if data else {}
    rows = (Row(c, replace(found[c.label], of=c)) for c in all_claims() if found)
    return Report(tuple(rows)) if found else None


@pytest.fixture(scope="session")
def whole(tmp_path_factory: pytest.TempPathFactory) -> "Report":
    """The whole ledger, judged once for the same sources by whichever process comes first."""
    from tresym.report.pages.documents import judged

    if "PYTEST_XDIST_WORKER" not in os.environ:
        return judged()
    kept = _kept(tmp_path_factory)
    try:
        kept.with_suffix(".mine").touch(exist_ok=False)
    except FileExistsError:
        started = time.monotonic()
        while not kept.exists():
            time.sleep(0.1)
            assert time.monotonic() - started < HANGS
        return _read(kept) or judged()
    aside, data = kept.with_suffix(".aside"), b""
    try:
        report = judged()
        found = {row.claim.label: replace(row.finding, of=None) for row in report.rows}
        data = pickle.dumps(found)
    finally:  # nothing where it failed: the others find that out for themselves
        aside.write_bytes(data)
        aside.rename(kept)
    return report


@pytest.fixture(scope="session")
def judged(tmp_path_factory: pytest.TempPathFactory) -> "Callable[..., Report]":
    """Return the report on some claims, from the whole ledger where it is judged already."""
    from tresym.ledger.paper import all_claims
    from tresym.ledger.verification import Report, _choose, verify

    def some(*labels: str) -> Report:
        kept = _kept(tmp_path_factory)
        found = _read(kept) if "PYTEST_XDIST_WORKER" in os.environ and kept.exists() else None
        if found is None:
            return verify(labels)
        chosen, requested = _choose(all_claims(labels), labels)
        rows = (found[claim.label] for claim in chosen)
        return Report(tuple(replace(row, requested=row.claim.label in requested) for row in rows))

    return some
