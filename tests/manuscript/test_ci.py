"""Manuscripts in CI: formats, baselines, settings, the hook for pre-commit."""

import json
import re
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest
from hangs import HANGS

from tresym.commands import main

ROOT = Path(__file__).resolve().parents[2]
PAPER = r"""\documentclass{article}
\begin{document}
We have the identity \[ \sin 2x = 3 \sin x\cos x . \]
We have \[ (x+1)^2 = x^2 + 2x + 1 . \]
\end{document}
"""
FALSE = r"Also the identity \[ \cos 2x = 3\cos^2 x . \]" + "\n"


@pytest.fixture
def paper(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    path = Path("m.tex")
    path.write_text(PAPER)
    return path


def run(*words: str) -> int:
    return main(["paper", "--limit", str(HANGS), "--no-suggest", *words])


def with_more(text: str) -> str:
    return PAPER.replace("\\end{document}", f"{text}\\end{{document}}")


def test_only_what_is_new_since_the_baseline_fails(
    paper: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run("m.tex") == 1
    assert run("m.tex", "--baseline", "known", "--update-baseline") == 0
    assert run("m.tex", "--baseline", "known") == 0
    paper.write_text("% a line before\n" + with_more(FALSE))
    capsys.readouterr()
    assert run("m.tex", "--baseline", "known") == 1
    shown = capsys.readouterr()
    assert "1 new problems, 1 in the baseline" in shown.err
    assert "sin(2*x)" not in shown.out
    assert "cos(2*x)" in shown.out
    paper.write_text(with_more("The identity \\[ \\sin 2x = 3 \\sin x\\cos x . \\]\n"))
    assert run("m.tex", "--baseline", "known") == 1, "the same falsehood a second time is new"


def test_what_is_no_baseline_is_refused(paper: Path) -> None:
    assert run("m.tex", "--baseline", "missing") == 2
    Path("other").write_text("text\n")
    assert run("m.tex", "--baseline", "other") == 2
    assert run("m.tex", "--update-baseline") == 2
    for file in ("other", "m.tex"):
        before = Path(file).read_text()
        assert run("m.tex", "--baseline", file, "--update-baseline") == 2
        assert Path(file).read_text() == before
    assert run("m.tex", "-o", "m.tex", "--force") == 2


def test_github(paper: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run("m.tex", "--format", "github") == 1
    (line,) = capsys.readouterr().out.splitlines()
    assert line.startswith("::error file=m.tex,line=3,title=tresym REFUTED::sin(2*x) ==")


def test_sarif(paper: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run("m.tex", "--format", "sarif") == 1
    log = json.loads(capsys.readouterr().out)
    (result,) = log["runs"][0]["results"]
    assert log["version"] == "2.1.0"
    assert (result["ruleId"], result["level"]) == ("REFUTED", "error")
    where = result["locations"][0]["physicalLocation"]
    assert (where["artifactLocation"]["uri"], where["region"]["startLine"]) == ("m.tex", 3)


def test_junit(paper: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run("m.tex", "--format", "junit") == 1
    suite = ElementTree.fromstring(capsys.readouterr().out)
    assert (suite.get("tests"), suite.get("failures")) == ("2", "1")
    assert suite.find("testcase/failure").get("type") == "REFUTED"  # type: ignore[union-attr]


def test_several_manuscripts(paper: Path, capsys: pytest.CaptureFixture[str]) -> None:
    Path("n.tex").write_text(PAPER)
    assert run("m.tex", "n.tex", "--json") == 1
    files = [json.loads(line)["file"] for line in capsys.readouterr().out.splitlines()]
    assert files == ["m.tex", "m.tex", "n.tex", "n.tex"]
    assert run("m.tex", "n.tex", "--html", "pages") == 2


SETTINGS = """
files = ["*.tex"]
strict = true
limit = 20
baseline = "known"
ignore-macros = ["todo"]
directives = ["given x > 0"]
"""


def test_settings_beside_the_manuscript(paper: Path, capsys: pytest.CaptureFixture[str]) -> None:
    paper.write_text(PAPER.replace(r"\sin 2x = 3 \sin x\cos x", r"\sqrt{x^2} = x \todo{why}"))
    Path("tresym.toml").write_text(SETTINGS)
    assert main(["paper", "--update-baseline"]) == 0
    assert main(["paper", "--json"]) == 0
    first = json.loads(capsys.readouterr().out.splitlines()[0])
    assert first["status"] == "PROVED"
    Path("tresym.toml").unlink()
    Path("pyproject.toml").write_text(
        "[tool.tresym]\n" + SETTINGS.replace('baseline = "known"\n', "")
    )
    assert main(["paper"]) == 0


@pytest.mark.parametrize(
    "text",
    [
        "nonsense = 1",
        "files = 3",
        "strict = 1",
        "limit = true",
        'files = ["missing*.tex"]',
        'directives = ["define"]',
        'directives = ["given"]',
        'ignore-macros = ["a b"]',
        "= =",
        "x = [" * 2000,
    ],
)
def test_settings_that_are_not_understood_are_one_line(
    text: str, paper: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    Path("tresym.toml").write_text(text)
    assert main(["paper"]) == 2
    assert capsys.readouterr().err.count("\n") == 1


def test_the_hook_for_pre_commit_runs_a_command_that_is_there(
    paper: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    hooks = (ROOT / ".pre-commit-hooks.yaml").read_text()
    keys = dict(re.findall(r"^(?:- |  )(\w+): (.+)$", hooks, re.MULTILINE))
    assert {"id", "name", "entry", "language", "files"} <= keys.keys()
    assert re.search(keys["files"], "chapters/one.tex")
    command, *words = keys["entry"].split()
    assert command == "tresym"
    assert main([*words, "m.tex"]) == 1
