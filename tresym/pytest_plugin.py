"""A plugin for pytest: ``pytest kepler.tresym`` runs a file of claims, one test for each claim.

A test passes if its claim holds, or is refuted where the file says ``expect refuted``. A line that
cannot be read fails as a test of its own. A file of single claims as ``tresym check -f`` reads it,
one a line, is run in the same way if its name ends in ``.claims``; so are the claims in comments of
a program that is named on the command line (``pytest kernel.c``). pytest finds the plugin by
itself once tresym is installed; ``pytest -p tresym.pytest_plugin`` loads it from a checkout.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from tresym.papers.verification import PaperReport

ENDING = ".tresym"
LINES = ".claims"
SECONDS = 20.0
"""The limit of a single claim."""


def pytest_collect_file(file_path: Path, parent: pytest.Collector) -> pytest.File | None:
    """Collect files of claims."""
    kinds: dict[str, type[ClaimsFile] | type[LinesFile]] = {ENDING: ClaimsFile, LINES: LinesFile}
    kind = kinds.get(file_path.suffix)
    if kind is None and parent.session.isinitpath(file_path) and _has_claims(str(file_path)):
        kind = LinesFile
    if kind is None:
        return None
    found: pytest.File = kind.from_parent(parent, path=file_path)
    return found


def _has_claims(file: str) -> bool:
    """Return whether a file is a program with claims in its comments."""
    from tresym.commands.check import read_tasks
    from tresym.commands.claims_in_code import is_code
    from tresym.reals.numbers.exact import InputError

    try:
        return is_code(file) and next(read_tasks(file, "", None), None) is not None
    except InputError:
        return False


class LinesFile(pytest.File):
    """A file of single claims, one a line, or a program with claims in its comments."""

    def collect(self) -> Iterator[pytest.Item]:
        """Yield a test for each claim."""
        from tresym.commands.check import read_tasks

        for task in read_tasks(str(self.path), "", None):
            yield LineTest.from_parent(self, name=f"{task.line}: {task.claim}", task=task)


class ClaimsFile(pytest.File):
    """A file of claims; it is verified once, when its first test runs."""

    _report: PaperReport | None = None

    def collect(self) -> Iterator[pytest.Item]:
        """Yield a test for each line that cannot be read, each definition and each claim."""
        from tresym.papers.definitions import Definition
        from tresym.papers.reading import OwnPaper, PaperClaim, read_file

        self.paper: OwnPaper = read_file(self.path)
        for problem in self.paper.problems:
            yield BadLine.from_parent(self, name=f"line {problem.line}", problem=problem)
        for item in self.paper.items:
            if isinstance(item, PaperClaim):
                yield ClaimTest.from_parent(self, name=item.label, line=item.line)
            elif isinstance(item, Definition):
                yield ClaimTest.from_parent(self, name=item.name, line=item.line)

    @property
    def report(self) -> PaperReport:
        """The verdicts."""
        if self._report is None:
            from tresym.papers.verification import verify_paper

            self._report = verify_paper(self.paper)
        return self._report


class _Test(pytest.Item):
    """A test that stands on a line of the file."""

    line = 1

    def reportinfo(self) -> tuple[Path, int, str]:
        """Where the test stands."""
        return self.path, self.line - 1, self.name

    def repr_failure(self, excinfo: Any, style: Any = None) -> str:
        """The reason without a traceback."""
        return str(excinfo.value)


class LineTest(_Test):
    """A single claim."""

    def __init__(self, *, task: Any, **more: Any) -> None:
        super().__init__(**more)
        self.task, self.line = task, task.line

    def runtest(self) -> None:
        """Fail if the claim does not hold, or cannot be read."""
        from tresym.checking.time_limited import check_within
        from tresym.reals.numbers.exact import InputError

        where = f"{self.path.name}:{self.line}"
        try:
            answer = check_within(self.task, SECONDS)
        except InputError as error:
            raise AssertionError(f"{where}: {error}") from None
        if not answer:
            raise AssertionError(f"{where}: {answer}")


class BadLine(_Test):
    """A line that cannot be read."""

    def __init__(self, *, problem: Any, **more: Any) -> None:
        super().__init__(**more)
        self.problem, self.line = problem, problem.line

    def runtest(self) -> None:
        """Fail with the line, the column and what to write instead."""
        line, column, message = self.problem
        raise AssertionError(f"{self.path.name}:{line}:{column}: {message}")


class ClaimTest(_Test):
    """A claim, or a definition."""

    def __init__(self, *, line: int, **more: Any) -> None:
        super().__init__(**more)
        self.line = line

    def runtest(self) -> None:
        """Fail if the verdict is not the expected one."""
        from tresym.papers.reading import PaperClaim

        parent = self.parent
        assert isinstance(parent, ClaimsFile)
        row = next(row for row in parent.report.rows if row.item.line == self.line)
        if not row.as_expected:
            text = row.item.text
            lines = [
                f"{parent.path.name}:{self.line}: {row.label} is {row.verdict.value}: {row.why}"
            ]
            lines.append(f"  {text}")
            answer = row.decisive
            if isinstance(row.item, PaperClaim) and answer is not None and answer.witness:
                point = ", ".join(f"{name} = {value}" for name, value in answer.witness.items())
                lines.append(f"  witness: {point}")
            lines += [f"  true instead: {one}" for one in row.instead[:1]]
            raise AssertionError("\n".join(lines))
