"""The ledger compiles: no error, no undefined reference, no box that sticks out by 5 pt."""

import re
import subprocess
from pathlib import Path

import pytest

from tresym.commands import main
from tresym.ledger.verification import Report, verify
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict
from tresym.report.pages import fragments
from tresym.report.pages.derivation import _valued, prose
from tresym.report.pages.ledger_document import ledger_document


@pytest.fixture(scope="module")
def report(whole: Report) -> Report:
    return whole


@pytest.fixture(scope="module")
def text(report: Report) -> str:
    return ledger_document(report)


def test_every_claim_is_in_the_ledger(report: Report, text: str) -> None:
    for row in report.rows:
        assert rf"\label{{claim:{row.claim.label}}}" in text


def test_quoted_theorems_have_their_section(report: Report, text: str) -> None:
    entries = text[text.index(r"\label{quoted}") : text.index(r"\section{The ledger}")]
    listed = entries.split(r"\paragraph")[1:]
    assert len(listed) == len(report.axioms) > 0
    for (axiom, resting), entry in zip(report.axioms.items(), listed, strict=True):
        assert prose(axiom.name) in entry
        assert prose(axiom.source) in entry
        assert all(rf"\hyperref[claim:{claim.label}]" in entry for claim in resting)
    ledger = text[text.index(r"\section{The ledger}") :]
    assert ledger.count(r"\textsf{\small Quoted:}") == sum(
        bool(r.claim.axioms) for r in report.rows
    )


def test_nothing_unprintable_is_left(report: Report) -> None:
    for row in report.rows:
        for sentence in (row.claim.note, row.claim.says, row.claim.paper_says):
            if isinstance(sentence, str):
                assert "?" not in prose(sentence.replace("?", "")), row.claim.label


def test_one_statement_to_paste() -> None:
    text = fragments.written([verify(["eq_gamma"])["eq_gamma"]], "article")
    assert text.startswith("% ")
    assert r"Let $0 < I_1 < I_2 < I_3$ and $M > 0$." in text
    assert r"\gamma &= \frac{2I_2E}{M^2}-1 && \text{\footnotesize by \eqref{tresym:d08}}" in text
    assert text.index(r"\label{tresym:d08}") < text.index(r"\label{tresym:eq_gamma}")
    assert "PROVED" not in text.split("\n", 1)[1]
    with pytest.raises(InputError):
        verify(["eq_gamm"])


@pytest.mark.parametrize("labels", [["d24"], ["eq_gamma", "d24"], ["d24", "eq_pavao"]])
@pytest.mark.slow
def test_what_is_refuted_is_not_printed_unasked(
    labels: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["derive", *labels, "-o", str(tmp_path / "out.tex")]) == 1
    assert not (tmp_path / "out.tex").exists()
    printed = capsys.readouterr()
    assert printed.out == ""
    lines = printed.err.splitlines()
    assert len(lines) == len(set(labels) - {"eq_gamma"})
    for line in lines:
        assert re.match(r"tresym: \w+ is REFUTED; true instead: \w+, \w+", line)
    assert "true instead: printed_leading_term, printed_error, repaired" in printed.err


def test_what_is_refuted_is_printed_marked(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["derive", "--refuted", "d24", "prop1", "eq_gamma"]) == 0
    text = capsys.readouterr().out
    assert text.count(r"\textbf{Refuted}") == 2
    formula = text.index(r"\epsilon_0 = \left(2\sqrt")
    assert text.index(r"\textbf{Refuted} (\texttt{main\_theorem\_remainder})") < formula
    assert formula < text.index(r"\textbf{True instead} (\texttt{printed\_error})")
    assert r"\begin{aligned}" in text
    assert main(["derive", "--refuted", "eq_gamma"]) == 0
    assert "Refuted" not in capsys.readouterr().out


def test_the_ledger_marks_what_is_refuted(report: Report, text: str) -> None:
    entries = re.split(r"\\label\{claim:", text)[1:]
    marked = [r"\verdict{refuted}{This is refuted:}" in entry for entry in entries]
    assert sum(marked) == report.counts[Verdict.REFUTED.value]


@pytest.mark.slow
@pytest.mark.usefixtures("pdflatex")
def test_the_ledger_compiles(text: str, tmp_path: Path) -> None:
    log = compiled(text, tmp_path, times=2)
    assert "undefined" not in log
    assert "tresym: a display is shrunk" not in log


@pytest.mark.slow
@pytest.mark.usefixtures("pdflatex")
def test_statements_to_paste_fit_an_article_as_latex_sets_it(tmp_path: Path) -> None:
    """Short and long chains; no margin is set, and each is referred to."""
    labels = ["d37", "eq_gamma", "eq_Euler", "stable_equation", "logarithmic_equation"]
    report = verify(labels)
    body = fragments.written([report[label] for label in labels], "article")
    body += "".join(rf"\eqref{{tresym:{label}}}" for label in labels)
    head = r"\documentclass{article}\usepackage{amsmath,amssymb}\begin{document}"
    assert "undefined" not in compiled(head + body + r"\end{document}", tmp_path, times=2)


@pytest.mark.usefixtures("pdflatex")
def test_tables_for_a_paper_compile(tmp_path: Path) -> None:
    tables = Path(__file__).parents[3] / "docs" / "generated" / "tables"
    head = r"""\documentclass{article}
\usepackage[T1]{fontenc}\usepackage[utf8]{inputenc}
\usepackage{lmodern,amsmath,amssymb,booktabs,array,graphicx,rotating}
"""
    body = "".join(path.read_text(encoding="utf-8") for path in sorted(tables.glob("*.tex")))
    assert body.count(r"\label{tab:") == len(list(tables.glob("*.tex"))) > 4
    compiled(head + r"\begin{document}" + body + r"\end{document}", tmp_path, times=1)


def compiled(text: str, folder: Path, times: int) -> str:
    """What TeX says of a text: there must be no error, and nothing that sticks out by 5 pt."""
    (folder / "text.tex").write_text(text, encoding="utf-8")
    for _ in range(times):
        command = ["pdflatex", "-interaction=nonstopmode", "text.tex"]
        subprocess.run(command, cwd=folder, capture_output=True)
    log = (folder / "text.log").read_text(encoding="latin-1")
    assert (folder / "text.pdf").exists()
    assert "\n!" not in log, log[log.index("\n!") :][:400]
    overfull = [float(x) for x in re.findall(r"Overfull \\hbox \(([\d.]+)pt", log)]
    assert all(x < 5 for x in overfull), overfull
    return log


@pytest.mark.parametrize(
    ("mid", "shown"),
    [
        ("1209.999999999999999999999999999999999999999999999999999999", "$1210$"),
        ("-2.50", "$-2.5$"),
        ("1200", "$1200$"),
        ("0.14999999999999999999999999999999999999999999999999", f"$0.14{'9' * 48}$"),
    ],
)
def test_a_value_is_rounded_and_not_cut_off(mid: str, shown: str) -> None:
    assert _valued(mid) == shown
