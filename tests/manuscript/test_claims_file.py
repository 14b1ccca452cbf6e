"""Manuscripts written as files of claims, whose claims have the verdicts of the manuscript."""

from pathlib import Path

import pytest

from tresym.commands import main
from tresym.papers.reading import read_file
from tresym.papers.verification import verify_paper

EXAMPLES = Path(__file__).resolve().parents[2] / "docs" / "examples"


@pytest.mark.parametrize(("name", "refuted"), [("pendulum", []), ("kepler-wrong", ["display_5_2"])])
@pytest.mark.slow
def test_a_manuscript_as_a_file_of_claims(
    name: str, refuted: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("TRESYM_CACHE", str(tmp_path / "cache"))
    target = tmp_path / "own.tresym"
    main(["paper", str(EXAMPLES / f"{name}.tex"), "--claims", str(target), "-o", "/dev/null"])
    paper = read_file(target)
    assert not paper.problems
    assert len(paper.claims) > 5
    assert len(paper.definitions) > 3
    report = verify_paper(paper, cached=False, suggest=False)
    assert [row.label for row in report.rows if not row.as_expected] == refuted


def test_the_file_must_be_one_of_claims(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["paper", str(EXAMPLES / "kepler.tex"), "--claims", "own.txt"]) == 2
    assert "name it own.txt.tresym" in capsys.readouterr().err
