"""Documents, tables and charts of files of claims, and the commands that write them."""

import importlib.util
import json
import re
from pathlib import Path

import pytest

import tresym
from tresym.commands import main
from tresym.papers.error_rows import error_rows
from tresym.papers.reading import read_paper
from tresym.papers.verification import verify_paper
from tresym.report.pages import own_paper, own_tables

TEXT = """\
# Sines & cosines
x real; given 0 < x < 1
y, n real

## First part
Prose with 50 % and $x_1$.

sine: sin(x) == x - x**3/6 + O(x**5) as x -> 0+
wrong: sin(y) > y expect refuted quoted from (Nobody 1900)
open: cos(x)**x > sin(x)**y + n
steps: (y - 1)**2 == y**2 - 2*y + 1 == y*(y - 2) + 1
table sine: at x == 1/10, 1/100; digits 30
chart sine
"""


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("TRESYM_CACHE", str(tmp_path / "cache"))
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    (tmp_path / "own.tresym").write_text(TEXT)
    return tmp_path


def test_the_article_says_what_is_proved_and_what_is_not() -> None:
    report = verify_paper(read_paper(TEXT), limit=2, cached=False, suggest=False)
    text = own_paper.document(report)
    assert r"\title{Sines \& cosines}" in text
    assert r"50 \% and $x_1$" in text
    assert r"\section*{First part}" in text
    assert r"\sin(x) = x - \frac{x^{3}}{6} + O(x^{5}) \qquad (x \to 0^+)" in text
    assert r"\texttt{open}: \textbf{false}" in text
    assert r"\texttt{wrong} (quoted from Nobody 1900): \textbf{false}" in text
    assert text.count("&=") == 2
    assert text.count("{") == text.count("}")


def test_the_errors_of_a_table_are_true() -> None:
    """Against the next term of the series: sin x − x + x³/6 = x⁵/120 − x⁷/5040 + …"""
    paper = read_paper(TEXT)
    rows = list(error_rows(paper.claims["sine"], paper.drawn("table")[0]))
    for row, x in zip(rows, (0.1, 0.01), strict=True):
        assert row.error is not None
        assert float(row.error.mid) == pytest.approx(x**5 / 120 - x**7 / 5040, rel=1e-7)
    table = own_tables.error_table(paper, paper.drawn("table")[0])
    assert table.rows[0][1] == "0.0998334166468281523068141984106"
    assert table.heads[-1] == "error/(x⁵)"


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("table near: at x == 2", "does not hold at x == 2"),
        ("table near: at x == 1/2; z == 1", "z is no variable"),
        ("table near: digits 5", "state values for x"),
        ("table sum: at x == 1/2", "of the form"),
        ("table pole: at x == 1/2", "no real value"),
    ],
)
def test_points_that_do_not_fit(line: str, message: str) -> None:
    text = "x real; given 0 < x < 1\nnear: abs(sin(x) - x) <= x**3/6\nsum: x + 1 > x\n"
    text += "pole: abs(log(x - 1/2) - x) <= 3\n"
    paper = read_paper(f"{text}{line}\n")
    assert not paper.problems
    with pytest.raises(tresym.InputError, match=re.escape(message)):
        own_tables.error_table(paper, paper.drawn("table")[0])


def test_commands(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["verify", "own.tresym", "sine", "wrong", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert [row["verdict"] for row in found["claims"]] == ["ENCLOSED", "REFUTED"]
    assert main(["verify", "own.tresym", "sines"]) == 2
    assert "did you mean sine?" in capsys.readouterr().err
    assert main(["verify", "own.tresym", "steps"]) == 0
    assert "every verdict is as expected" in capsys.readouterr().out
    assert main(["derive", "own.tresym", "steps", "--style", "markdown"]) == 0
    assert r"\begin{aligned}" in capsys.readouterr().out
    assert main(["table", "own.tresym", "sine"]) == 0
    assert "0.0998334166468281523068141984106" in capsys.readouterr().out
    assert main(["table", "own.tresym"]) == 2
    assert main(["table", "own.tresym", "steps"]) == 2
    assert main(["verify", "none.tresym"]) == 2


def test_the_example_that_new_writes_passes(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["new", "mine"]) == 0
    assert main(["verify", "mine.tresym"]) == 0
    assert main(["new", "mine"]) == 2
    assert "exists already" in capsys.readouterr().err


def test_documents_go_beside_the_output_and_replace_no_file_of_the_user(folder: Path) -> None:
    pytest.importorskip("matplotlib")
    (folder / "short.tresym").write_text("\n".join([*TEXT.split("\n")[:9], "chart sine"]))
    assert main(["derive", "short.tresym", "-o", "short.tex"]) == 0
    assert (folder / "short-figures" / "sine.pdf").stat().st_size > 1000
    assert "short-figures/sine.pdf" in (folder / "short.tex").read_text()
    (folder / "theirs.tex").write_text("mine")
    assert main(["derive", "short.tresym", "-o", "theirs.tex"]) == 2
    assert main(["verify", "short.tresym", "-o", "short.tresym"]) == 2
    assert (folder / "short.tresym").read_text().startswith("# Sines")


def test_a_chart_that_is_left_out_is_named(
    folder: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    text = "x real; given 0 < x < 1\npole: abs(log(x - 1/2) - x) <= 3\nchart pole: at x == 1/2\n"
    (folder / "pole.tresym").write_text(text)
    if importlib.util.find_spec("matplotlib"):
        main(["derive", "pole.tresym", "-o", "pole.tex"])
        assert "left out the chart of pole: " in capsys.readouterr().err
    monkeypatch.setattr("importlib.util.find_spec", lambda _: None)
    main(["derive", "pole.tresym", "-o", "other.tex"])
    assert "left out the charts of pole: charts need matplotlib" in capsys.readouterr().err


def test_a_file_in_python(folder: Path) -> None:
    paper = tresym.open("own.tresym")
    assert repr(paper) == "OpenedPaper(own.tresym: 4 claims)"
    assert paper.verify("steps").as_expected
    assert r"\begin{equation}" in paper.derive("steps")
    assert len(paper.table("sine").rows) == 2
    with pytest.raises(tresym.InputError, match="no claim is labelled"):
        paper.verify("stepz")


HEADER = r"""# On $x^2$

@author A. First
@author B. Second
@abstract Squares & their signs,
  100 % proved.
@reference key_1 A book, 1974.

As in [key_1], but [nothing] else.
square: x**2 + 1 >= 1
"""


def test_authors_abstract_and_references_stand_in_every_style() -> None:
    report = verify_paper(read_paper(HEADER), cached=False, suggest=False)
    article = own_paper.document(report)
    for part in (
        r"\author{A. First \and B. Second}",
        "\\begin{abstract}\nSquares \\& their signs, 100 \\% proved.\n\\end{abstract}",
        r"As in \cite{key_1}, but [nothing] else.",
        r"\bibitem{key_1} A book, 1974.",
    ):
        assert part in article
    markdown = own_paper.document(report, "markdown")
    assert "*A. First, B. Second*" in markdown
    assert "**Abstract.** Squares & their signs, 100 % proved." in markdown
    assert markdown.endswith("- [key_1] A book, 1974.\n")
    assert "Abstract" in own_paper.document(report, "jupyter")


@pytest.mark.parametrize(
    ("line", "why"),
    [
        ("@autor A", "'@autor' is not known: write @author NAME"),
        ("@abstract", "@abstract needs words after it"),
        ("@reference key", "a reference needs a key and words"),
    ],
)
def test_a_line_of_the_header_that_is_not_read_is_told(line: str, why: str) -> None:
    (problem,) = read_paper(f"a real\n{line}\nsquare: a**2 >= 0").problems
    assert problem.line == 2
    assert problem.message.startswith(why)


def test_slides_and_a_site_contain_every_claim_and_prose(folder: Path) -> None:
    """Nothing of the file is missing, and every link of the site leads to a page of it."""
    (folder / "own.tresym").write_text(TEXT.replace("open: cos(x)**x > sin(x)**y + n\n", ""))
    assert main(["derive", "own.tresym", "--style", "site", "-o", "out", "--no-figures"]) == 0
    pages = {path: path.read_text() for path in (folder / "out").rglob("*.html")}
    home = pages[folder / "out" / "index.html"]
    assert {path.stem for path in pages} == {"index", "sine", "wrong", "steps"}
    for path, text in pages.items():
        for link in re.findall(r'(?:href|src)="([^"#]+)', text):
            assert (path.parent / link).resolve() in pages, link
    assert re.sub("<[^>]+>", "", pages[folder / "out" / "claims" / "wrong.html"]).count("false")
    assert main(["derive", "own.tresym", "--style", "beamer", "-o", "own.tex", "--no-figures"]) == 0
    slides = (folder / "own.tex").read_text()
    assert slides.count(r"\begin{frame}") == slides.count(r"\end{frame}") > 5
    for label in ("sine", "wrong", "steps"):
        assert f">{label}<" in home
        assert rf"\texttt{{{label}}}" in slides
    assert "50 %" in home
    assert r"50 \%" in slides
    assert main(["derive", "own.tresym", "--style", "site"]) == 2
    assert main(["derive", "own.tresym", "sine", "--style", "beamer"]) == 2
    assert main(["derive", "--style", "html"]) == 2


def test_formulas_of_html_are_typeset_and_words_escaped() -> None:
    from tresym.report.typesetting import html

    assert html.words("`<b>` & <script>") == "<code>&lt;b&gt;</code> &amp; &lt;script&gt;"
    pytest.importorskip("math_core")
    assert "<msup>" in html.words("the *square* $x^2$")
    assert html.typesets()


COUPONS = """\
# Coupons
n integer; given n >= 1
H(n) := sum(1/j, j, 1, n)
growth: n*H(n) == n*log(n) + EulerGamma*n + 1/2 + O(1/n) as n -> oo
chart growth: at n == 10, 300000
"""


def test_functions_of_the_file_keep_the_form_of_the_text_and_points_are_skipped() -> None:
    """The terms stay in the author's order, and a sum of 300 000 terms does no harm."""
    paper = read_paper(COUPONS)
    (link,) = own_paper.statement_latex(paper.claims["growth"]).split(r" \qquad ")[:1]
    assert (
        link == r"n \, H(n) = n \, \ln(n) + \gamma \, n + \frac{1}{2} + O\left(\frac{1}{n}\right)"
    )
    drawn = read_paper(COUPONS).drawn("chart")[0]
    assert len(list(error_rows(paper.claims["growth"], drawn, skipping=True))) == 1
    with pytest.raises(tresym.InputError, match="300000"):
        list(error_rows(paper.claims["growth"], drawn))
