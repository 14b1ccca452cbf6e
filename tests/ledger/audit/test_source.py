"""A LaTeX source taken apart, or refused in one line that names the place."""

from pathlib import Path

import pytest
from cases import cases

from tresym.ledger.audit.source import Piece, scan
from tresym.ledger.latex_source import MAX_BYTES, read_source
from tresym.reals.numbers.exact import InputError


def document(body: str, preamble: str = "") -> str:
    return f"{preamble}\\begin{{document}}\n{body}\n\\end{{document}}\n"


def displays(body: str) -> list[tuple[str, str, str]]:
    return [(p.kind, p.label, p.text) for p in scan(document(body)).displays]


@pytest.mark.parametrize(
    ("body", "found"),
    [
        (r"\begin{equation}\label{eq:a} x=1 \end{equation}", ("equation", "eq:a", None)),
        (r"\[ x=1 \]", ("brackets", "d01", "x=1")),
        ("$$ x\n =\t1 $$", ("dollars", "d01", "x = 1")),
        ("\\begin{align*} x &= 1 % two\n \\end{align*}", ("align*", "d01", "x &= 1")),
        (r"\[ 50\% \]", ("brackets", "d01", r"50\%")),
        (r"\[ \text{a $x$ b} \]", ("brackets", "d01", r"\text{a $x$ b}")),
        (r"costs \$5 \[ x \]", ("brackets", "d01", "x")),
    ],
)
def test_displays(body: str, found: tuple[str, str, str | None]) -> None:
    ((kind, label, text),) = displays(body)
    assert (kind, label) == found[:2]
    assert found[2] is None or text == found[2]


def test_what_is_in_a_comment_or_outside_is_not_there() -> None:
    assert displays("% \\[ x \\]\n$y$ text") == []
    text = "\\[ a \\]" + document("\\[ b \\]") + "\\[ c"
    assert [p.text for p in scan(text).displays] == ["b"]


def test_numbers_and_lines_count_from_one() -> None:
    first, second = scan(document("\\[ a \\]\n\n\\[\nb\n\\]")).displays
    assert (first.number, first.line, first.end) == (1, 2, 2)
    assert (second.number, second.line, second.end, second.label) == (2, 4, 6, "d02")


def test_theorems_tables_and_figures_with_their_own_labels() -> None:
    body = (
        "\\begin{thm}\\begin{equation}\\label{inner}x\\end{equation}\\label{outer}\\end{thm}"
        "\\begin{thm} y \\end{thm}\\begin{figure*} z \\end{figure*}"
    )
    source = scan(document(body, "\\newtheorem{thm}{Theorem}\n"))
    assert [(p.kind, p.label) for p in source.others] == [
        ("theorem", "outer"),
        ("theorem", "theorem2"),
        ("figure", "figure1"),
    ]
    assert [p.label for p in source.displays] == ["inner"]


def test_a_changed_sign_is_an_alteration_and_a_line_break_is_none() -> None:
    def sha(body: str) -> str:
        return scan(document(body)).displays[0].sha256

    assert sha(r"\[ x + 1 \]") == sha("\\[ x\n  + % note\n 1 \\]")
    assert sha(r"\[ x + 1 \]") != sha(r"\[ x - 1 \]")
    assert Piece("equation", "a", 1, 1, "é").sha256 == Piece("other", "b", 2, 3, "é").sha256


@pytest.mark.parametrize(
    "body",
    cases(__file__, "what_is_not_closed_is_refused_with_its_line"),
)
def test_what_is_not_closed_is_refused_with_its_line(body: str) -> None:
    with pytest.raises(InputError, match="line 2") as caught:
        scan(document(body), "paper.tex")
    assert str(caught.value).startswith("paper.tex")


def test_a_file_that_is_cut_off() -> None:
    with pytest.raises(InputError, match="cut off"):
        scan("\\begin{document} x")


TEXT = document("é \\[ x \\]")
LATIN = "\\usepackage[latin1]{inputenc}\n" + TEXT


@pytest.mark.parametrize(
    "data",
    [
        TEXT.encode(),
        TEXT.encode("utf-8-sig"),
        TEXT.encode("utf-16"),
        TEXT.replace("\n", "\r\n").encode(),
        TEXT.replace("\n", "\r").encode(),
    ],
)
def test_encodings_and_line_ends(data: bytes, tmp_path: Path) -> None:
    (tmp_path / "a.tex").write_bytes(data)
    assert read_source(tmp_path / "a.tex") == TEXT


def test_a_declared_encoding(tmp_path: Path) -> None:
    (tmp_path / "a.tex").write_bytes(LATIN.encode("latin-1"))
    assert read_source(tmp_path / "a.tex") == LATIN


@pytest.mark.parametrize(
    "data",
    [
        b"",
        b"no document",
        TEXT.encode("latin-1"),
        LATIN.replace("latin1", "klingon").encode("latin-1"),
        LATIN.replace("latin1", "ascii").encode("latin-1"),
        TEXT.encode() + b"\0",
        b"x" * (MAX_BYTES + 1),
    ],
    ids=["empty", "none", "undeclared", "unknown", "wrong", "nul", "large"],
)
def test_what_is_no_latex_source(data: bytes, tmp_path: Path) -> None:
    (tmp_path / "a.tex").write_bytes(data)
    with pytest.raises(InputError) as caught:
        read_source(tmp_path / "a.tex")
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("name", ["missing.tex", "a\0b", "."])
def test_what_is_no_file(name: str, tmp_path: Path) -> None:
    with pytest.raises(InputError):
        read_source(tmp_path / name)
