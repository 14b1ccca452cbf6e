"""The article compiles: no error, no undefined reference, no box that sticks out by 5 pt."""

import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

from tresym.commands import main
from tresym.ledger.verification import Report, verify
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict
from tresym.report.pages.derivation import article, fragment, prose


@pytest.fixture(scope="module")
def report() -> Report:
    return verify()


def test_every_claim_is_in_the_article(report: Report) -> None:
    text = article(report)
    for row in report.rows:
        assert rf"\label{{claim:{row.claim.label}}}" in text


def test_quoted_theorems_are_in_the_bibliography(report: Report) -> None:
    text = article(report)
    entries = text[text.index(r"\begin{thebibliography}") :].split(r"\bibitem")[1:]
    assert len(entries) == len(report.axioms) > 0
    for (axiom, resting), entry in zip(report.axioms.items(), entries, strict=True):
        assert prose(axiom.name) in entry
        assert prose(axiom.source) in entry
        assert all(rf"\hyperref[claim:{claim.label}]" in entry for claim in resting)
    cited = text.count(r"\cite{axiom:")
    assert cited == sum(len(row.claim.axioms) for row in report.rows)
    assert "bibliography" not in article(verify(["eq_gamma"]))


def test_nothing_unprintable_is_left(report: Report) -> None:
    for row in report.rows:
        for sentence in (row.claim.note, row.claim.says, row.claim.paper_says):
            if isinstance(sentence, str):
                assert "?" not in prose(sentence.replace("?", "")), row.claim.label


def test_one_statement_to_paste() -> None:
    text = fragment(verify(["eq_gamma"])["eq_gamma"])
    assert r"\gamma &= \frac{2I_2E}{M^2}-1 && \text{\footnotesize by \texttt{d08}}" in text
    with pytest.raises(InputError):
        verify(["eq_gamm"])


@pytest.mark.parametrize("labels", [["d24"], ["eq_gamma", "d24"], ["d24", "eq_pavao"]])
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
    assert text.index(r"\textbf{Refuted} (\texttt{d24})") < formula
    assert formula < text.index(r"\textbf{True instead} (\texttt{printed\_error})")
    assert r"\begin{aligned}" in text
    assert main(["derive", "--refuted", "eq_gamma"]) == 0
    assert "Refuted" not in capsys.readouterr().out


def test_the_article_marks_what_is_refuted(report: Report) -> None:
    entries = article(report).split(r"\paragraph{\texttt{")[1:]
    marked = [r"\verdict{refuted}{This is refuted:}" in entry for entry in entries]
    assert sum(marked) == report.counts[Verdict.REFUTED.value]


@pytest.mark.slow
def test_the_article_compiles(report: Report, tmp_path: Path) -> None:
    if shutil.which("pdflatex") is None:
        assert not os.environ.get("CI"), "TeX Live must be there in CI"
        pytest.skip("pdflatex is not installed (Debian: texlive-latex-extra)")
    (tmp_path / "derivation.tex").write_text(article(report), encoding="utf-8")
    for _ in range(2):
        command = ["pdflatex", "-interaction=nonstopmode", "derivation.tex"]
        subprocess.run(command, cwd=tmp_path, capture_output=True)
    log = (tmp_path / "derivation.log").read_text(encoding="latin-1")
    assert (tmp_path / "derivation.pdf").exists()
    assert "\n!" not in log, log[log.index("\n!") :][:400]
    assert "undefined" not in log
    overfull = [float(x) for x in re.findall(r"Overfull \\hbox \(([\d.]+)pt", log)]
    assert all(x < 5 for x in overfull), overfull
