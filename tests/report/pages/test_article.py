"""The article: its templates fit the ledger, and every number in them comes from it."""

import re
from itertools import chain
from pathlib import Path

import pytest
from tresym.proofs import figures

import tresym
from tresym.ledger.verification import Report
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict
from tresym.report.pages import templates
from tresym.report.pages.article import _counts, article, figures_of, labels, passages
from tresym.report.typesetting.markdown_from_latex import markdown_from_latex

TEMPLATES = templates.names()
DOCS = Path(__file__).resolve().parents[3] / "docs"


@pytest.fixture(scope="module")
def report(whole: Report) -> Report:
    return whole


@pytest.fixture(scope="module")
def text(report: Report) -> str:
    return article(report)


@pytest.mark.parametrize("name", TEMPLATES)
def test_every_claim_has_the_verdict_that_the_text_expects(name: str, report: Report) -> None:
    rows = {row.claim.label: row for row in report.rows}
    assert not [*templates.changed(templates.text_of(name), rows)]


def test_a_changed_verdict_and_a_claim_that_is_gone_are_errors(
    report: Report, monkeypatch: pytest.MonkeyPatch
) -> None:
    rows = {row.claim.label: row for row in report.rows}
    texts = {
        "{{formula d24}}": "d24 is REFUTED; the text expects that it holds",
        "% expects: d24 ENCLOSED\n": "d24 is REFUTED; the text expects ENCLOSED",
        "% expects: eq_gamma REFUTED\n{{ref eq_gamma}}": "eq_gamma is PROVED",
        "{{steps d99}} 1 {{end}}": "d99 is not in the ledger",
    }
    for text, why in texts.items():
        monkeypatch.setattr(templates, "text_of", lambda _, text=text: text)
        with pytest.raises(InputError, match=why):
            templates.Templates(rows, {}, {}).filled("any")


def bare_numbers(text: str) -> list[str]:
    """The numbers that a template states itself, but for 0, 1, 2, indices and exponents."""
    text = re.sub(r"^%.*$", "", text, flags=re.MULTILINE)
    steps = r"\{\{steps [^}]*\}\}.*?\{\{end\}\}"
    lines = re.compile(r"(?<=[|}])\s*\d+(?:\+\d+)*")
    text = re.sub(steps, lambda m: lines.sub("", m[0]), text, flags=re.DOTALL)
    text = templates.INLINE.sub("", text)
    text = re.sub(r"\\(?:label|ref|cite|texttt)\{[^}]*\}", "", text)
    text = re.sub(r"[_^](?:\d|\{[^{}]*\})", "", text)
    return [n for n in re.findall(r"\d+(?:\.\d+)?", text) if n not in ("0", "1", "2")]


@pytest.mark.parametrize("name", [n for n in TEMPLATES if n != "11-references"])
def test_every_number_comes_from_the_ledger(name: str) -> None:
    assert bare_numbers(templates.text_of(name)) == []


def test_a_number_that_is_written_by_hand_is_found() -> None:
    allowed = r"$2\pi$, $x^2$, $I_3$, $e^{-1/s}$, {{value d 3}}, \cite{a17}, \label{d3}"
    steps = "{{steps d}} 3+4 by {{ref e 7}} | 5 {{end}}"
    assert bare_numbers(allowed + steps) == []
    assert bare_numbers(r"at most 0.17 on 33 boxes, $\frac{7}{5}$") == ["0.17", "33", "7", "5"]
    assert bare_numbers("{{steps d}} 3 in 12 steps {{end}}") == ["12"]


@pytest.mark.parametrize("name", TEMPLATES)
def test_what_a_template_states_itself_is_proved(name: str) -> None:
    for line in re.findall(r"^% check: (.+)$", templates.text_of(name), re.MULTILINE):
        claim, _, given = line.partition(" given ")
        assert tresym.check(claim, given=given).verdict is Verdict.PROVED, line


@pytest.mark.slow
def test_the_counts_are_those_of_the_verification(report: Report) -> None:
    counts = _counts()
    assert all(counts.get(name.lower(), "0") == str(n) for name, n in report.counts.items())
    kinds = {"paper": "paper", "stricter": "stricter", "own": "sharpness"}
    assert all(counts[f"refuted_{k}"] == str(report.refuted[v]) for k, v in kinds.items())


def test_nothing_is_left_to_fill_in(report: Report, text: str) -> None:
    assert not re.search(r"\{\{ ?\w", text)
    assert set(labels()) <= {row.claim.label for row in report.rows}
    found = re.findall(r"\\label\{([^}]+)\}", text)
    assert len(found) == len(set(found))
    assert set(re.findall(r"\\(?:eq)?ref\{([^}]+)\}", text)) <= {*found, "#1"}


def test_every_figure_exists_and_is_referred_to() -> None:
    assert 0 < len(figures_of()) <= 8
    assert set(figures_of()) <= set(figures.FIGURES)
    words = "".join(chain.from_iterable(map(templates.text_of, TEMPLATES)))
    assert all(rf"\ref{{fig:{name}}}" in words for name in figures_of())


def test_passages_for_the_site_are_markdown(report: Report) -> None:
    found = passages(report)
    pages = "".join(path.read_text(encoding="utf-8") for path in DOCS.rglob("*.md"))
    used = set(re.findall(r"_pages/passages/([\w-]+)\.txt", pages))
    assert used <= set(found)
    for name, text in found.items():
        outside = re.sub(r"\$\$.*?\$\$|\$[^$]*\$", "", text, flags=re.DOTALL)
        assert "\\" not in outside, name
        assert "{{" not in text
    assert "[R](/claims/d24.md){.mark}" in found["asymptotics"]


def test_latex_becomes_markdown() -> None:
    latex = (
        r"\noindent\emph{One} formula~\cite{dlmf} \begin{equation*}x^2,\end{equation*} to "
        r"$2\,\%$\raised{d24}{R} (Section~\ref{sec:off}), see \texttt{a\_b}."
    )
    marked = markdown_from_latex(latex, lambda label, letter: f"[{letter}:{label}]")
    assert marked == "*One* formula\n$$\nx^2\n$$\n to $2\\,\\%$[R:d24], see `a_b`.\n"
