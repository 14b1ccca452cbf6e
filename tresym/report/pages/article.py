"""Write the article: text from the templates beside the proofs, filled in from the ledger.

The text is in ``proofs/article``, one file for each section; its placeholders are explained in
:mod:`tresym.report.pages.templates`. The frame, with the document class and the commands that the
text uses, is article.tex beside this file.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterator
from functools import cache
from importlib.resources import files

from tresym import release
from tresym.ledger.claim import AllOf, Claim
from tresym.ledger.paper import Correction, all_claims, corrections, racket
from tresym.ledger.verification import Report, Row
from tresym.report.pages import ledger_document, templates
from tresym.report.pages.article_markdown import article_markdown
from tresym.report.pages.corrections import FAULTS
from tresym.report.pages.derivation import LINE, alone, prose
from tresym.report.typesetting.formula_width import width
from tresym.report.typesetting.latex import expression_latex
from tresym.report.typesetting.markdown_from_latex import markdown_from_latex
from tresym.report.typesetting.paper_location import place_text
from tresym.report.typesetting.statements import said

SHORT = 26
"""Width of a formula that fits a line of text, in letters."""
MOST = 2
"""Most true statements that are quoted beside a correction."""


_FILL = re.compile(r"\{\{ (\w+) \}\}")
LEDGER = {"": "", "document": r"\ledgertrue", "appendix": r"\ledgertrue"}
"""Where the ledger is, with the setting of the frame: not there, beside the article, or in it."""
_APPENDIX = r"""\clearpage\appendix\newgeometry{margin=25mm}\small
\setlength{\parindent}{0pt}\setlength{\parskip}{4pt plus 2pt}"""
_SEE = re.compile(r"Figure~\\ref\{fig:([\w-]+)\}")
_FIGURE = re.compile(r"\\begin\{figure\}.*?\\end\{figure\}\n?", re.DOTALL)


def article(report: Report, ledger: str = "", figures: bool = True) -> str:
    """Write the whole article in LaTeX.

    Args:
        report: verdicts on the claims of :func:`labels`, or on the whole ledger.
        ledger: a key of ``LEDGER``: where the ledger is that verdicts link to.
        figures: whether to include the figures, which are read from the folder ``NAME-figures``
            beside an article ``NAME.tex``.

    Raises:
        InputError: the text no longer fits the verdicts.
    """
    text = "\n".join(map(templates_of(report).filled, templates.names()))
    if not figures:
        text = without_figures(text)
    if ledger == "appendix":
        text += f"\n{_APPENDIX}\n{ledger_document.body(report)}"
    commands = ledger_document.commands() if ledger == "appendix" else ""
    parts = {"commands": commands, "ledger": LEDGER[ledger], "body": text}
    framed = _FILL.sub(lambda found: parts.get(found[1], found[0]), _frame())
    return framed.replace("{{ version }}", release.dated())


def without_figures(text: str) -> str:
    """Return the text of the article without figures; it names the commands that draw them."""
    return _SEE.sub(r"\\texttt{tresym figure \1}", _FIGURE.sub("", text))


def in_markdown(report: Report, folder: str = "") -> str:
    """Write the whole article in Markdown.

    Args:
        report: verdicts on the claims of :func:`labels`, or on the whole ledger.
        folder: the folder of the figures, as SVG; an empty text for no figures.
    """
    text = "\n".join(map(templates_of(report, "markdown").filled, templates.names()))
    return article_markdown(text if folder else without_figures(text), folder)


def templates_of(report: Report, form: str = "latex") -> templates.Templates:
    """Return the templates with the verdicts of a report and all other numbers.

    Args:
        report: the verdicts.
        form: the format of tables, ``latex`` or ``markdown``.
    """
    rows = {row.claim.label: row for row in report.rows}

    def _labelled(name: str) -> str:
        return "" if form == "latex" else rf"\label{{tab:{name}}}"

    tables = racket().tables()
    pieces: dict[str, Callable[..., str]] = {
        "corrections": lambda: "\n".join(_corrected(rows)),
        "derivations": lambda: "\n".join(_derived_otherwise()),
        "table": lambda name: _labelled(name) + tables.written(tables.table(name), form),
    }
    return templates.Templates(rows, racket().numbers() | _counts(), pieces)


def passages(report: Report) -> dict[str, str]:
    """Return the passages that pages of the site quote, in Markdown, by name."""
    filled = templates_of(report)
    return {
        name: markdown_from_latex(filled.fill(text), _link)
        for name, text in templates.passages().items()
    }


def _link(label: str, letter: str) -> str:
    return f"[{letter}](/claims/{label}.md){{.mark}}"


def labels() -> tuple[str, ...]:
    """Return the labels of the claims that the article names, each once."""
    named = [
        label for name in templates.names() for label in templates.expected(templates.text_of(name))
    ]
    wrong = {label for c in corrections() for label in c.labels}
    true = [each.label for c in all_claims(wrong) if c.label in wrong for each in c.amended_by]
    return tuple(dict.fromkeys((*named, *sorted(wrong), *true)))


def figures_of() -> tuple[str, ...]:
    """Return the names of the figures of the article."""
    found = (templates.figures_in(templates.text_of(name)) for name in templates.names())
    return tuple(figure for figures in found for figure in figures)


def _frame() -> str:
    return files("tresym.report.pages").joinpath("article.tex").read_text(encoding="utf-8")


@cache
def _counts() -> dict[str, str]:
    """The counts of the whole ledger, by the verdicts that its claims must get."""
    from tresym.ledger.paper import index
    from tresym.report.pages.coq_page import found as in_coq

    claims = all_claims()
    in_coq_by = Counter(entry.status for entry in in_coq().values())
    found = Counter(claim.expect.value.lower() for claim in claims)
    refuted = [claim for claim in claims if claim.expect.value == "REFUTED"]
    kinds = Counter("stricter" if c.paper_says else "paper" if c.where else "own" for c in refuted)
    counts = {"undecided": 0} | found | {f"refuted_{kind}": n for kind, n in kinds.items()}
    counts |= {
        "claims": len(claims),
        "lemmas": sum(claim.where is None for claim in claims),
        "corrections": len(corrections()),
        "displays": len(index()["displays"]),
        "coq": in_coq_by["proved"],
        "resting": sum(bool(claim.axioms) for claim in claims),
    }
    return {name: str(count) for name, count in counts.items()}


def _corrected(rows: dict[str, Row]) -> Iterator[str]:
    """The corrections by weight, each once, with what is true instead."""
    for number, (fault, heading, meaning) in enumerate(FAULTS):
        yield rf"\subsection*{{{prose(heading)}}} {prose(meaning)}"
        options = f"{'resume,' if number else ''}leftmargin=*,itemsep=2pt"
        yield rf"\begin{{enumerate}}[{options}]\small\raggedright"
        for correction in corrections():
            if rows[correction.labels[0]].claim.fault is fault:
                yield " ".join(_correction(correction, rows))
        yield r"\end{enumerate}"


def _correction(correction: Correction, rows: dict[str, Row]) -> Iterator[str]:
    refuted = [rows[label].claim for label in correction.labels]
    claim = refuted[0]
    yield rf"\item \textbf{{{prose(correction.title)}}} ({prose(place_text(claim))})."
    yield rf"Printed: “{prose(correction.quote)}”.{_mark(rows[claim.label])}"
    yield prose(correction.why or claim.note)
    own = [each for each in refuted if each is claim or not isinstance(each.proof, AllOf)]
    true = [*dict.fromkeys(each for wrong in own for each in wrong.amended_by)]
    told = [text + _mark(rows[each.label]) for each in true if (text := _in_a_line(each))][:MOST]
    if told:
        yield rf"\emph{{True instead:}} {'. '.join(told)}."


def _derived_otherwise() -> Iterator[str]:
    """The derivations by another system, each step with its result and how it is found."""
    for title, steps in racket().derivations():
        yield rf"\paragraph{{{prose(title)}.}}"
        yield r"\begin{enumerate}[leftmargin=*,itemsep=2pt]\small\raggedright"
        for step in steps:
            formula = f"{step.name} = {expression_latex(step.written)}"
            if width(formula) < LINE / 2:
                yield rf"\item ${formula}$, {prose(step.how)}."
            else:
                shown = alone(formula, templates.SHARE)
                how = step.how[0].upper() + step.how[1:]
                yield rf"\item {prose(how)}:"
                yield f"\\begin{{equation*}}\n{shown}\n\\end{{equation*}}"
        yield r"\end{enumerate}"


def _mark(row: Row) -> str:
    return rf"\raised{{{row.claim.label}}}{{{row.finding.verdict.value[0]}}}"


def _in_a_line(claim: Claim) -> str:
    """A statement in one line of text: its sentence, or its formula if that is short."""
    found = said(claim)
    if found.says:
        return prose(found.says.rstrip("."))
    return f"${found.formula}$" if found.formula and width(found.formula) < SHORT else ""
