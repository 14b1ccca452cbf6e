"""The example manuscripts: the right ones hold, and each planted error is found."""

import json
import re
import subprocess
from html.parser import HTMLParser
from pathlib import Path

import pytest
from hangs import HANGS

from tresym.commands import main

ROOT = Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "docs" / "examples"
PAPERS = sorted(ROOT.parent.glob("shared/paper/*.txt"))


def rows(path: Path, capsys: pytest.CaptureFixture[str], *words: str) -> tuple[int, list[dict]]:
    status = main(["paper", str(path), "--json", "--limit", str(HANGS), *words])
    return status, [json.loads(line) for line in capsys.readouterr().out.splitlines()]


@pytest.mark.parametrize(("name", "planted"), [("pendulum", (7, 1)), ("kepler", (5, 2))])
@pytest.mark.slow
def test_an_example_is_right_and_its_copy_is_refuted_where_it_is_wrong(
    name: str, planted: tuple[int, int], capsys: pytest.CaptureFixture[str]
) -> None:
    status, right = rows(EXAMPLES / f"{name}.tex", capsys, "--strict")
    assert status == 0
    status, wrong = rows(EXAMPLES / f"{name}-wrong.tex", capsys)
    assert status == 1
    changed = [r for r, w in zip(right, wrong, strict=True) if r["status"] != w["status"]]
    assert [(r["display"], r["link"], r["status"]) for r in changed] == [(*planted, "PROVED")]
    (refuted,) = (w for w in wrong if w["status"] == "REFUTED")
    assert refuted["witness"]


class _Balanced(HTMLParser):
    """Complains of a tag that is closed where another is open."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []

    def handle_starttag(self, tag: str, attrs: object) -> None:
        if tag not in ("meta", "br", "p", "html"):
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        if tag not in ("p", "html"):
            assert self.open.pop() == tag


def test_page_and_marks_show_every_display(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    source = EXAMPLES / "kepler-wrong.tex"
    marks = tmp_path / "k.marks"
    _, found = rows(source, capsys, "--html", str(tmp_path / "h"), "--marks", str(marks))
    page = (tmp_path / "h" / "index.html").read_text()
    parser = _Balanced()
    parser.feed(page)
    assert not parser.open
    parts = ('id="attention"', 'id="display-1"', "Kinds of symbols")
    places = [page.index(part) for part in parts]
    assert places == sorted(places)
    accused = sum(row["status"] in ("REFUTED", "SUSPECT") for row in found)
    assert page.count('<math display="block">') == 11 + accused
    assert page.count("<section class=") == 11
    assert "Witness: E_ = " in page
    lines = re.findall(r"\\tresymstatus\{(\d+)\}\{(\w+)\}", marks.read_text())
    assert [int(number) for number, _ in lines] == list(range(1, 12))
    assert ("5", "REFUTED") in lines
    assert "\\ProvidesPackage{tresym}" in (tmp_path / "tresym.sty").read_text()


MARKED = r"""\documentclass{article}
\usepackage{amsmath,tresym}
\newtheorem{lemma}{Lemma}
\tresymmarks{m.marks}
\renewcommand{\tresymshown}{\typeout{mark \arabic{tresymdisplay}, line \the\inputlineno}}
\begin{document}
\[ 1 = 1 \]
\begin{lemma} $$ 2 = 2 $$ \end{lemma}
\begin{equation} \begin{aligned} 3 &= 3 \\ 4 &= 4 \end{aligned} \end{equation}
\begin{displaymath} 4 = 4 \end{displaymath}
\begin{align*} 5 &= 5 \\ 5 &= 5 \end{align*}
\begin{eqnarray} 6 & = & 6 \end{eqnarray}
\begin{multline} 7 \\ = 7 \end{multline}
\begin{gather} 8 = 8 \\ 8 = 8 \text{ if $x = x$} \end{gather}
\begin{subequations} \begin{alignat}{2} 9 &= 9 & 1 &= 1 \end{alignat} \end{subequations}
$$ 10 = 10 $$
\end{document}
"""


def test_each_mark_stands_at_its_display(
    pdflatex: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "m.tex").write_text(MARKED)
    _, found = rows(tmp_path / "m.tex", capsys, "--marks", str(tmp_path / "m.marks"))
    words = [pdflatex, "-interaction=nonstopmode", "-halt-on-error", "m.tex"]
    done = subprocess.run(words, cwd=tmp_path, capture_output=True, text=True, check=True)
    marks = re.findall(r"^mark (\d+), line (\d+)", done.stdout, re.MULTILINE)
    assert [*map(tuple, marks)] == [
        *dict.fromkeys((str(row["display"]), str(row["line"])) for row in found)
    ]


@pytest.mark.skipif(not PAPERS, reason="the paper's LaTeX is not at hand")
def test_the_racket_paper_without_and_with_the_notes_that_are_shipped(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    paper = tmp_path / "paper.tex"
    paper.write_bytes(PAPERS[0].read_bytes())
    brief = ("--limit", "2")  # for two integrals that stay open
    status, bare = rows(paper, capsys, *brief)
    assert status == 0
    assert len({row["display"] for row in bare}) == 58
    notes = ROOT / "proofs" / "displays.notes"
    _, noted = rows(paper, capsys, "--notes", str(notes), *brief)
    proved = {row["display"] for row in noted if row["status"] == "PROVED"}
    assert {9, 10, 12, 13, 15, 16, 40} <= proved
    paper.write_bytes(PAPERS[0].read_bytes().replace(rb"\cos\theta}{1-b", rb"\sin\theta}{1-b"))
    assert main(["paper", str(paper), "--notes", str(notes)]) == 2
    assert "the hash is not that of display" in capsys.readouterr().err
