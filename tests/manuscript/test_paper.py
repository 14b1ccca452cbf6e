"""`tresym paper`: a small manuscript from end to end, and what it refuses in one line."""

import json
from pathlib import Path

import pytest
from hangs import HANGS

from tresym.commands import main

SMALL = r"""
\documentclass{article}
\newcommand{\half}{\tfrac{1}{2}}
\newcommand{\sq}[1]{#1^{2}}
\newcommand{\be}{\begin{equation}}
\newcommand{\ee}{\end{equation}}
\begin{document}
Let $a > 0$. We define
\begin{equation} r = \sqrt{a^2 + b^2} \label{eq:r} \end{equation}
and have the chain
\begin{align}
  \sq{r} - b^2 &= a^2 + b^2 - b^2 \nonumber \\
               &= a^2 = a^3/a.
\end{align}
\be \sin^2 x + \cos^2 x = 1, \qquad \cos 2x = 2\cos^2 x - 1 \ee
The angle obeys the equation
\[ \ddot\theta + \sin\theta = 0, \]
and $x$ the equation \[ x = \cos x. \]
We find the identity
\[ \sin 2x = 3 \sin x\cos x . \]
% tresym: skip: a drawing
\[ A \square B = C \]
% tresym: as x -> 0
\[ \sin x = x + O(x^3) \]
\[ |x| = \begin{cases} x & \text{if } x \ge 0, \\ -x & \text{otherwise.} \end{cases} \]
\[ \ln 2 = 0.6931\ldots, \quad \sqrt{a^2} = a \]
\end{document}
"""


def rows(path: Path, capsys: pytest.CaptureFixture[str], *words: str) -> tuple[int, list[dict]]:
    status = main(["paper", str(path), "--json", "--limit", str(HANGS), *words])
    return status, [json.loads(line) for line in capsys.readouterr().out.splitlines()]


def test_each_link_of_a_small_manuscript_has_its_status(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "m.tex").write_text(SMALL)
    status, found = rows(tmp_path / "m.tex", capsys)
    assert [(r["display"], r["link"], r["status"]) for r in found] == [
        (1, 1, "DEFINED"),
        (2, 1, "PROVED"),
        (2, 2, "PROVED"),
        (2, 3, "PROVED"),
        (3, 1, "PROVED"),
        (3, 2, "PROVED"),
        (4, 1, "EQUATION"),
        (5, 1, "EQUATION"),
        (6, 1, "REFUTED"),
        (7, 1, "UNREAD"),
        (8, 1, "ENCLOSED"),
        (9, 1, "PROVED"),
        (9, 2, "PROVED"),
        (10, 1, "ENCLOSED"),
        (10, 2, "PROVED"),
    ]
    assert status == 1
    assert found[0]["line"] == 9
    assert found[0]["label"] == "eq:r"
    assert found[8]["witness"]
    assert found[9]["why"] == "skipped by a directive: a drawing"
    assert found[-1]["read_as"] == "sqrt(a**2) == a given a > 0"


def paper(tmp_path: Path, text: str) -> int:
    (tmp_path / "m.tex").write_text(text)
    return main(["paper", str(tmp_path / "m.tex")])


HOSTILE = {
    "unbalanced": r"\begin{equation} a = {b \end{equation}",
    "unclosed": r"\begin{equation} a = b",
    "closes nothing": r"a \end{equation}",
    "brackets": r"\[ a = b",
    "recursive": r"\newcommand{\a}{\a\a} \[ \a = b \]",
    "mutually recursive": r"\def\a{\b}\def\b{\a x} \[ \a = b \]",
    "doubling": "".join(
        rf"\newcommand{{\m{chr(98 + n)}}}{{\m{chr(97 + n)}\m{chr(97 + n)}}}" for n in range(24)
    )
    + r"\newcommand{\ma}{x}\[ \my = 1 \]",
    "braces": r"\[" + "{" * 100_000 + "}" * 100_000 + r"= 1\]",
    "deep": r"\[" + "{" * 5_000 + "}" * 5_000 + r"= 1\]",
    "itself": r"\input{m} \[ a = {b \]",
    "an environment": r"\[ \begin{cases} x = 1 \]",
    "a definition": r"\newcommand{\a}{x" * 100,
    "words": "Let $n$" + " , $m$" * 3000 + r" and \[ a = {",
    "no display": "Nothing here.",
    "a note": "% tresym: prove it\n\\[ a = a \\]",
    "cut off": r"\begin{document} \[ a = {a \]",
}


@pytest.mark.parametrize("name", HOSTILE)
def test_hostile_latex_is_refused_in_one_line(
    name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert paper(tmp_path, HOSTILE[name]) == 2
    written = capsys.readouterr()
    assert written.out == ""
    assert len(written.err.splitlines()) == 1
    assert len(written.err) < 400


@pytest.mark.parametrize(
    "broken",
    [
        r"a \end{equation}",
        r"\newcommand{\a}{x",
        r"\[" + "{" * 5000 + "}" * 5000 + r"= 1\]",
        r"\input{m}",
        "\x01\x02 \x011\x02",
        r"\newcommand{\a}{\a\a} \[ \a = b \]",
        r"\begin{document}",
    ],
)
def test_what_is_broken_leaves_the_other_displays(
    broken: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "m.tex").write_text(rf"{broken} \[ 1 + 1 = 2 \]")
    assert main(["paper", str(tmp_path / "m.tex"), "--json", "--no-suggest"]) == 0
    statuses = [json.loads(line)["status"] for line in capsys.readouterr().out.splitlines()]
    assert statuses[-1] == "PROVED"


def test_the_markdown_of_a_notebook_is_read_at_its_lines(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    page = "# A\n\n$$\n1 + 1 = 3\n$$"
    cells = [
        {"cell_type": "code", "source": ["print('$$')\n"]},
        {"cell_type": "markdown", "source": page.splitlines(keepends=True)},
    ]
    path = tmp_path / "m.ipynb"
    for indent in (1, None):
        path.write_text(json.dumps({"cells": cells, "nbformat": 4}, indent=indent))
        main(["paper", str(path), "--json", "--no-suggest"])
        (row,) = map(json.loads, capsys.readouterr().out.splitlines())
        assert row["status"] in ("REFUTED", "SUSPECT")
        written = path.read_text().splitlines()
        assert not indent or written[row["line"]].strip().startswith('"1 + 1 = 3')
    path.write_text(path.read_text()[:60])
    assert main(["paper", str(path)]) == 2


@pytest.mark.parametrize("asked", [[], ["-f"]])
def test_check_names_the_command_for_a_manuscript(
    asked: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "m.tex").write_text(SMALL.strip())
    assert main(["check", *asked, str(tmp_path / "m.tex")]) == 2
    assert "tresym paper FILE" in capsys.readouterr().err


def test_a_long_report_is_one_screen_unless_all_is_asked_for(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """What was found to fail is shown, whatever word near it keeps it from being called false."""
    unread = "\n".join(rf"\[ x_{{{n}}} \propto y_{{{n}}} + {n} \]" for n in range(10, 40))
    text = rf"""Pick $t$ in some interval.
    \begin{{align}} y &= (1-x)(1-t) + xt \\ &= 1 - x - t - 2xt \end{{align}}
    {unread}"""
    (tmp_path / "m.tex").write_text(text)
    assert main(["paper", str(tmp_path / "m.tex"), "--no-suggest"]) == 0
    short = capsys.readouterr().out
    assert short.count("\n") < 30
    assert "fails     m.tex:2  (1 - x)*(1 - t) + x*t == 1 - x - t - 2*x*t" in short
    assert "30 links: the relation \\propto is not supported, first at m.tex:3" in short
    assert main(["paper", str(tmp_path / "m.tex"), "--no-suggest", "--all"]) == 0
    assert capsys.readouterr().out.count("\\propto is not supported") == 30
