"""The example papers of the documentation: short, readable, and with the verdicts they expect."""

from pathlib import Path

import pytest

from tresym.papers.reading import read_file
from tresym.papers.verification import verify_paper

FILES = sorted((Path(__file__).resolve().parents[2] / "docs" / "examples").glob("*.tresym"))
SAMPLE = {
    "algorithm": ("order", "linear", "without_correction"),
    "damped": ("start", "velocity", "frequency", "regular_bound"),
    "kepler": ("equation", "slope", "value"),
    "layer": ("composite", "outer", "wrong_end"),
    "methods": ("heun", "rk4_wrong", "gauss"),
    "pendulum": ("at_45", "lima_at_90", "misprint"),
    "recurrences": ("merge_sort_linear", "hanoi", "bound_wrong", "catalan"),
    "queue": ("sojourn", "traffic", "tail_wrong"),
    "scheme": ("central", "forward_wrong", "simpson"),
    "stirling": ("recurrence", "at_10", "leading"),
}
WITHOUT_PICTURES = ("algorithm", "layer", "methods", "recurrences", "scheme")


def test_they_are_short() -> None:
    assert {path.stem for path in FILES} == set(SAMPLE)
    for path in FILES:
        assert len(path.read_text(encoding="utf-8").splitlines()) <= 80
        paper = read_file(path)
        assert not paper.problems
        pictures = path.stem not in WITHOUT_PICTURES
        assert bool(paper.drawn("table")) is bool(paper.drawn("chart")) is pictures


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_some_of_their_claims(path: Path) -> None:
    report = verify_paper(read_file(path), SAMPLE[path.stem], cached=False, suggest=False)
    assert report.as_expected, [row for row in report.rows if not row.as_expected]


@pytest.mark.night
@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_all_of_their_claims(path: Path) -> None:
    report = verify_paper(read_file(path), limit=60, cached=False, suggest=False)
    assert report.as_expected, [row for row in report.rows if not row.as_expected]
