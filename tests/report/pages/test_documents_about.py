"""Slides, notebook and Markdown about the paper: complete, compiled, and with computed numbers."""

import json
import re
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest
from notebook import run
from tresym.proofs import figures

from tresym.commands import main
from tresym.ledger.verification import Report
from tresym.output import check_replaceable
from tresym.reals.numbers.exact import InputError
from tresym.report.pages import documents_about as documents
from tresym.report.pages import fragments, ledger_document, templates
from tresym.report.pages.article import article, without_figures

NIGHT = pytest.mark.night
ENGINES = ("pdflatex", *(pytest.param(name, marks=NIGHT) for name in ("xelatex", "lualatex")))


@pytest.fixture(scope="module")
def report(whole: Report) -> Report:
    return whole


@pytest.fixture(scope="module")
def figure_files(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the figures of all documents."""
    pytest.importorskip("matplotlib")
    folder = tmp_path_factory.mktemp("figures")
    for name in {*documents.figures_of("article"), *documents.figures_of("beamer")}:
        (folder / f"{name}.pdf").write_bytes(figures.printed(name))
    return folder


def compiled(text: str, folder: Path, engine: str, pictures: Path | None = None) -> str:
    """The log of TeX on a text; no error, nothing undefined, nothing that sticks out."""
    if shutil.which(engine) is None:
        pytest.skip(f"{engine} is not installed")
    (folder / "text.tex").write_text(text, encoding="utf-8")
    if pictures is not None:
        shutil.copytree(pictures, folder / "text-figures")
    for _ in range(2):
        command = [engine, "-interaction=nonstopmode", "text.tex"]
        subprocess.run(command, cwd=folder, capture_output=True)
    log = (folder / "text.log").read_text(encoding="utf-8", errors="replace")
    assert (folder / "text.pdf").exists()
    assert "\n!" not in log, log[log.index("\n!") :][:400]
    assert "undefined" not in log
    assert "Overfull" not in log, log[log.index("Overfull") :][:200]
    return log


@pytest.mark.slow
@pytest.mark.usefixtures("pdflatex")
@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("style", ["article", "beamer"])
def test_documents_with_figures_compile(
    style: str, engine: str, report: Report, figure_files: Path, tmp_path: Path
) -> None:
    compiled(documents.written(report, style, "", "x"), tmp_path, engine, figure_files)


@pytest.mark.slow
@pytest.mark.usefixtures("pdflatex")
@pytest.mark.parametrize("style", ["article", "beamer"])
def test_documents_without_figures_compile_alone(
    style: str, report: Report, tmp_path: Path
) -> None:
    text = documents.written(report, style)
    assert "fig:" not in text
    assert text.count("{figure}") == 0
    compiled(text, tmp_path, "pdflatex")


def test_a_document_without_figures_names_the_commands_that_draw_them() -> None:
    text = r"As in Figure~\ref{fig:shape-map}, so.\begin{figure}[tb]\shown{x}\end{figure}"
    assert without_figures(text) == r"As in \texttt{tresym figure shape-map}, so."


@pytest.mark.night
@pytest.mark.usefixtures("pdflatex")
def test_the_ledger_is_a_document_or_an_appendix(report: Report, tmp_path: Path) -> None:
    beside = ledger_document.ledger_document(report)
    inside = article(report, "appendix", figures=False)
    linked = set(re.findall(r"\\(?:raised|inmargin|claim)\{(\w+)\}", inside))
    for text in (beside, inside):
        assert linked <= set(re.findall(r"\\hypertarget\{claim:(\w+)\}", text))
    assert r"\ledgertrue" in article(report, "document")
    assert "\\ledgertrue" not in article(report)
    log = compiled(inside, tmp_path, "pdflatex")
    assert "tresym: a display is shrunk" not in log


@pytest.mark.parametrize("name", [documents.SLIDES, documents.NOTEBOOK])
def test_a_template_fits_the_verdicts(name: str, report: Report) -> None:
    rows = {row.claim.label: row for row in report.rows}
    assert not [*templates.changed(templates.text_of(name), rows)]


def test_the_slides_have_figures(report: Report) -> None:
    text = documents.written(report, "beamer", "", "x")
    assert text.count(r"\begin{frame}") == 12
    assert set(documents.figures_of("beamer")) <= set(figures.FIGURES)
    assert text.count(r"\shown{") == len(documents.figures_of("beamer")) >= 4
    assert "{{" not in text


@pytest.mark.night
def test_the_cells_of_the_notebook_compute_the_numbers_of_its_text(report: Report) -> None:
    pytest.importorskip("matplotlib")
    book = json.loads(documents.written(report, "jupyter"))
    assert book["nbformat"] == 4
    assert len({cell["id"] for cell in book["cells"]}) == len(book["cells"])
    cells = run(book)["cells"]
    numbers = 0
    for n, cell in enumerate(cells):
        if cell["cell_type"] == "markdown":
            assert "{{" not in cell["source"]
            shown = "".join(
                str(output["data"]["text/plain"])
                for after in cells[n + 1 : n + 3]
                for output in after.get("outputs", ())
            )
            for number in re.findall(r"\d+\.\d+", re.sub(r"\$\$.*?\$\$", "", cell["source"])):
                near = number.rstrip("0")[:-1]  # the last digit is rounded
                assert near in shown, (number, shown)
                numbers += 1
    assert numbers >= 8


def test_the_article_in_markdown_has_no_latex_outside_formulas(report: Report) -> None:
    text = documents.written(report, "markdown", "", "article-figures")
    words = re.sub(r"\$\$.*?\$\$|\$[^$]*\$", "", text, flags=re.DOTALL)
    assert not re.findall(r"\\[a-zA-Z]+|\{\{|\}\}|``|''", words)
    pictures = re.findall(r"!\[[^\]]*\]\(article-figures/([\w-]+)\.svg\)", text)
    assert pictures == list(documents.figures_of("markdown"))
    tags = set(re.findall(r"\\tag\{(\d+\.\d+)\}", text))
    assert set(re.findall(r"\((\d\.\d+)\)", words)) <= tags
    assert len(re.findall(r"^## \d+ ", text, re.MULTILINE)) == text.count("\n## ") - 1
    assert "![" not in documents.written(report, "markdown")


# Single derivations

PIECES = ["eq_gamma", "d37", "eq_Euler", "d08", "repaired", "printed_leading_term", "d24"]


@pytest.fixture(scope="module")
def pieces(judged: Callable[..., Report]) -> Report:
    return judged(*PIECES)


@pytest.mark.night
def test_a_fragment_refers_only_to_equations_that_it_has(pieces: Report) -> None:
    rows = [pieces[label] for label in PIECES]
    text = fragments.written(rows, "article")
    labels = re.findall(r"\\label\{([^}]*)\}", text)
    assert len(labels) == len(set(labels))
    assert set(re.findall(r"\\eqref\{([^}]*)\}", text)) <= set(labels)
    for style in ("markdown", "beamer"):
        text = fragments.written(rows, style)
        tags = re.findall(r"\\tag\{(\d+)\}", text)
        assert sorted(tags, key=int) == [str(n) for n in range(1, len(tags) + 1)]
        cited = re.findall(r"by \((\d+)\)(?: and \((\d+)\))?", text)
        assert {n for pair in cited for n in pair if n} <= set(tags)


def test_a_claim_that_is_written_before_is_not_repeated(pieces: Report) -> None:
    both = fragments.written([pieces["d08"], pieces["eq_gamma"]], "article")
    assert both.count(r"\label{tresym:d08}") == 1


def test_a_fragment_in_markdown_has_formulas_that_mathjax_reads(pieces: Report) -> None:
    text = fragments.written([pieces[label] for label in PIECES], "markdown")
    assert r"\operatorname" not in text
    assert r"\footnotesize" not in text
    assert not re.findall(r"\\text\{[^}]*\$", text)
    assert text.count("$$") % 2 == 0
    assert "**Refuted** (`main_theorem_remainder`)" in text
    assert r"\textbf" not in text


def test_a_notebook_of_claims_verifies_them(pieces: Report) -> None:
    book = run(json.loads(fragments.written([pieces["eq_gamma"]], "jupyter")))
    shown = [output["data"]["text/plain"] for c in book["cells"] for output in c.get("outputs", ())]
    assert shown == ["Row(eq_gamma: PROVED)"]


@pytest.mark.slow
@pytest.mark.usefixtures("pdflatex")
def test_slides_of_claims_compile(pieces: Report, tmp_path: Path) -> None:
    frames = fragments.written([pieces[label] for label in PIECES], "beamer")
    head = "\\documentclass[aspectratio=169]{beamer}\\usepackage{amsmath}\n\\begin{document}\n"
    compiled(f"{head}{frames}\\end{{document}}", tmp_path, "pdflatex")


# The command


def test_options_that_do_not_fit_together_are_refused(capsys: pytest.CaptureFixture[str]) -> None:
    for words in (
        ["--ledger"],
        ["--figures"],
        ["--ledger", "-o", "/dev/null"],
        ["--ledger", "--appendix", "-o", "x"],
        ["eq_gamma", "--appendix"],
        ["eq_gamma", "--figures", "-o", "x"],
        ["--style", "beamer", "--appendix"],
        ["--style", "jupyter", "--figures", "-o", "x"],
        ["--style", "word"],
    ):
        assert main(["derive", *words]) == 2
        out, err = capsys.readouterr()
        assert out == ""
        assert err.count("\n") == 1


@pytest.mark.night
def test_slides_are_written_with_their_figures_and_no_file_of_the_user_is_replaced(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    pytest.importorskip("matplotlib")
    path = str(tmp_path / "talk.tex")
    words = ["derive", "--style", "beamer", "-o", path]
    assert main(words) == 0
    pictures = sorted((tmp_path / "talk-figures").iterdir())
    assert {one.stem for one in pictures} == set(documents.figures_of("beamer"))
    assert all(one.read_bytes().startswith(b"%PDF") for one in pictures)
    check_replaceable(map(str, pictures))
    pictures[0].write_bytes(b"mine")
    with pytest.raises(InputError):
        check_replaceable([str(pictures[0])])
    capsys.readouterr()
    assert main(words) == 2
    assert str(pictures[0]) in capsys.readouterr().err
    assert pictures[0].read_bytes() == b"mine"
    assert main([*words, "--force"]) == 0
    assert pictures[0].read_bytes().startswith(b"%PDF")


@pytest.mark.night
def test_without_figures_none_are_written(tmp_path: Path) -> None:
    path = tmp_path / "talk.tex"
    assert main(["derive", "--style", "beamer", "--no-figures", "-o", str(path)]) == 0
    assert [one.name for one in tmp_path.iterdir()] == ["talk.tex"]
