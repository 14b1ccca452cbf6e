"""Which files of a project are read as a manuscript, and which branch of a conditional."""

import os
from pathlib import Path

import pytest
from cases import cases

from tresym.commands import main
from tresym.manuscript.source import Display, Missing, read_manuscript
from tresym.reals.numbers.exact import InputError


def texts(path: Path, root: Path | None = None) -> list[str]:
    return [e.text.strip() for e in read_manuscript(path, root) if isinstance(e, Display)]


def write(folder: Path, files: dict[str, str]) -> None:
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)


MAIN = r"\input{../shared/header} \begin{document} \input{parts/one} \[ \half = x \] \end{document}"


@pytest.mark.parametrize("marker", [".git/HEAD", ".latexmkrc", "pyproject.toml"])
def test_files_of_the_project_are_read(tmp_path: Path, marker: str) -> None:
    write(
        tmp_path,
        {
            marker: "",
            "shared/header.tex": r"\newcommand{\half}{\frac12} \input{more}",
            "shared/more.tex": r"\newcommand{\third}{\frac13}",
            "notes/m.tex": MAIN,
            "notes/parts/one.tex": r"\[ \third = y \]",
        },
    )
    assert texts(tmp_path / "notes/m.tex") == [r"\frac13 = y", r"\frac12 = x"]


def test_what_lies_outside_is_left_out(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Else any file of the machine could be shown by a manuscript of somebody else's."""
    write(tmp_path, {"shared/header.tex": r"\[ 1 + 1 = 3 \]", "notes/m.tex": MAIN})
    write(tmp_path, {"notes/parts/one.tex": r"\input{/etc/hostname} \[ c = y \]"})
    (tmp_path / "notes/link.tex").symlink_to(tmp_path / "shared/header.tex")
    path = tmp_path / "notes/m.tex"
    path.write_text(path.read_text().replace(r"\[", r"\input{link} \[", 1))
    found = read_manuscript(path)
    assert [e for e in found if isinstance(e, Missing)] == [
        Missing(name, outside=True) for name in ("../shared/header", "/etc/hostname", "link")
    ]
    assert len(texts(path)) == 2
    assert main(["paper", str(path)]) == 0
    assert "outside the project, see --root; left out: ../shared" in capsys.readouterr().err
    assert len(texts(path, tmp_path)) == 3
    assert main(["paper", str(path), "--suspects", "--root", str(tmp_path)]) == 1
    with pytest.raises(InputError, match="is not in the folder"):
        texts(path, tmp_path / "shared")


def test_parts_with_a_preamble_of_their_own(tmp_path: Path) -> None:
    """Else the main file would end where the first part of it does."""
    main_file = (
        r"\documentclass{book} \newcommand{\half}{\frac12} \begin{document} \subfile{part}"
        r" \[ a = b \] \end{document}"
    )
    part = r"\documentclass[main.tex]{subfiles} \begin{document} \[ \half = x \] \end{document}"
    write(tmp_path, {"main.tex": main_file, "part.tex": part})
    assert texts(tmp_path / "main.tex") == [r"\frac12 = x", "a = b"]
    assert texts(tmp_path / "part.tex") == [r"\frac12 = x"]


@pytest.mark.parametrize("name", ["pipe.tex", "m.tex"])
def test_a_pipe_is_refused_or_left_out(tmp_path: Path, name: str) -> None:
    os.mkfifo(tmp_path / "pipe.tex")
    write(tmp_path, {"m.tex": r"\input{pipe} \[ a = b \]"})
    assert main(["paper", str(tmp_path / name)]) == (2 if name == "pipe.tex" else 0)


@pytest.mark.parametrize(
    ("text", "found"),
    cases(__file__, "the_branch_that_is_taken"),
)
def test_the_branch_that_is_taken(tmp_path: Path, text: str, found: str) -> None:
    (tmp_path / "m.tex").write_text(text)
    assert " ".join(texts(tmp_path / "m.tex")) == found


BOOK = r"\documentclass{book} \usepackage{own,amsmath} \newcommand{\half}{\frac12} \begin{document}"
CHAPTER = r"\[ \half x + \half x = \whole{x} \] \[ \half x = \whole{x} + 1 \]"


def test_a_chapter_alone_has_the_macros_of_its_book(tmp_path: Path) -> None:
    write(
        tmp_path,
        {
            ".git/HEAD": "",
            "book.tex": BOOK + r" \input{parts/one} \[ 1 = 2 \] \end{document}",
            "own.sty": r"\def\half{7} \newcommand{\whole}[1]{(#1)} \def\loop{\loop}",
            "parts/one.tex": CHAPTER,
            "parts/two.tex": CHAPTER,
        },
    )
    found = [r"\frac12 x + \frac12 x = (x)", r"\frac12 x = (x) + 1"]
    assert texts(tmp_path / "parts/one.tex") == found
    assert texts(tmp_path / "parts/two.tex") != found  # no main file inputs it
    assert texts(tmp_path / "book.tex")[0] == found[0]
    events = read_manuscript(tmp_path / "parts/one.tex")
    assert [e.line for e in events if isinstance(e, Display)] == [1, 1]


def test_macros_around_do_not_refuse_a_file(tmp_path: Path) -> None:
    """Those that do not end, as packages have them for what they change of TeX."""
    package = r"\let\saved\frac \def\frac{\saved@it} \def\saved@it{\frac} \newcommand{\y}{\y+\y}"
    main = r"\documentclass{book} \usepackage{own} \begin{document} \[ \frac12 + \y = x \]"
    write(tmp_path, {"own.sty": package, "m.tex": main + r"\end{document}"})
    assert texts(tmp_path / "m.tex") == [r"\frac12 + \y = x"]


def test_no_macros_from_outside_the_project(tmp_path: Path) -> None:
    write(
        tmp_path,
        {"own.sty": r"\def\half{7}", "book.tex": BOOK + r"\input{notes/one}\end{document}"},
    )
    write(tmp_path, {"notes/one.tex": CHAPTER, "notes/own.sty": r"\def\half{8}"})
    assert texts(tmp_path / "notes/one.tex")[0] == r"\half x + \half x = \whole{x}"


def test_symbolic_links_that_lead_back_are_left_out(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The main file of a chapter is sought among the files beside it."""
    (tmp_path / "loop.tex").symlink_to(tmp_path / "loop.tex")
    (tmp_path / "chapter.tex").write_text(r"We have \[ x + x = 2x . \]")
    assert main(["paper", str(tmp_path / "chapter.tex")]) == 0
    assert "loop.tex" in capsys.readouterr().err
    assert main(["paper", str(tmp_path / "loop.tex")]) == 2
    assert capsys.readouterr().err.count("\n") == 1
