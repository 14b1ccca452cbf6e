"""Write the article: the derivation in the paper's order, the corrections, and the ledger.

The text is in article.tex beside this file. A line ``@claim LABEL`` in it is replaced by a
statement with its derivation, ``@says LABEL`` by the statement alone, ``@figure NAME | caption`` by
a figure, and ``{{ name }}`` by a number of :mod:`tresym.report.pages.numbers`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterator
from importlib.resources import files

import tresym
from tresym.ledger.claim import AllOf, Claim
from tresym.ledger.paper import Correction, corrections, sections
from tresym.ledger.verification import Report, Row
from tresym.report.pages.derivation import (
    alone,
    axiom_key,
    entry,
    in_one,
    in_words,
    outcome,
    prose,
    reference,
    set_displays,
)
from tresym.report.pages.numbers import numbers
from tresym.report.pages.symbols import rows as table_of_symbols
from tresym.report.pages.tables import table, written
from tresym.report.typesetting.formula_width import width
from tresym.report.typesetting.paper_location import place_text
from tresym.report.typesetting.statements import said
from tresym.report.typesetting.titles import title

_DIRECTIVE = re.compile(r"^@(\w+)(?: ((?:.+\n?)+?))?(?=\n@|\n\n|\n\Z|^@)", re.MULTILINE)
"""A line that begins with @, up to the next such line or the end of its paragraph."""
LONGEST_CHAIN = 16
"""Most lines of a derivation in the text; longer ones are shown in the ledger only."""
SHORT = 24
"""Width of a formula that fits beside the words in the table of symbols, in letters."""
QUOTED = "Quoted theorems"
SYMBOLS = "Notation"


def article(report: Report) -> str:
    """Write the whole article in LaTeX.

    Args:
        report: verdicts on the ledger; statements of claims outside it are left out.
    """
    rows = {row.claim.label: row for row in report.rows}
    parts: dict[str, Callable[[str], Iterator[str]]] = {
        "claim": lambda label: _claimed(rows, label, with_chain=True),
        "says": lambda label: _claimed(rows, label, with_chain=False),
        "figure": _figure,
        "symbols": lambda _: _symbols(rows.keys()),
        "bodies": lambda _: iter([written(table("objects"), "latex")]),
        "corrections": lambda _: _corrected(rows),
        "quoted": lambda _: _quoted(report),
        "ledger": lambda _: _ledger(rows),
    }

    def put_in(found: re.Match[str]) -> str:
        return "\n".join(parts[found[1]](" ".join((found[2] or "").split()))) + "\n"

    known = numbers(report) | {"version": tresym.__version__}
    text = _DIRECTIVE.sub(put_in, _words())
    return re.sub(r"\{\{ (\w+) \}\}", lambda found: known[found[1]], text)


def figures_of() -> tuple[str, ...]:
    """Return the names of the figures in the article; each is a file ``figures/NAME.pdf``."""
    return tuple(re.findall(r"^@figure ([\w-]+)", _words(), re.MULTILINE))


def _words() -> str:
    return files("tresym.report.pages").joinpath("article.tex").read_text(encoding="utf-8")


def _claimed(rows: dict[str, Row], label: str, with_chain: bool) -> Iterator[str]:
    """A statement with place and verdict, its equation numbered, and its derivation if it is short.

    Nothing if the report does not contain the claim.
    """
    if label not in rows:
        return
    row = rows[label]
    claim, found = row.claim, said(row.claim)
    verdict = row.finding.verdict.value
    mark = rf"\verdict{{{verdict.lower()}}}{{{verdict}}}"
    place = prose(place_text(claim)) if claim.where else "ours"
    yield rf"\judged{{{claim.label}}}{{{prose(title(claim.label))}}}{{{place}}}{{{mark}}}"
    yield from (rf"{{\raggedright {words}\par}}" for words in in_words(claim))
    formulas = [alone(found.formula)] if found.formula else []
    chains = [body for body in set_displays(claim) if r"\footnotesize" in body]
    length = sum(body.count(r"\\") + 1 for body in chains)
    if with_chain and formulas and (at_once := in_one(claim)):
        formulas, chains = [at_once], []
    for n, formula in enumerate(formulas, 1):
        named = f"tresym:{label}" + (f"-{n}" if n > 1 else "")
        yield rf"\begin{{equation}}\label{{{named}}}\fits{{{formula}}}\end{{equation}}"
    if with_chain and length <= LONGEST_CHAIN:
        yield from (rf"\fitted{{{body}}}" for body in chains)
    yield from outcome(row, rows.keys())


def _figure(words: str) -> Iterator[str]:
    name, _, caption = words.partition(" | ")
    yield rf"\begin{{figure}}[tb]\centering\shown{{{name}}}"
    yield rf"\caption{{{caption}}}\label{{{name}}}\end{{figure}}"


def _symbols(known: Collection[str]) -> Iterator[str]:
    """The table of the symbols of the paper, each with the claim that defines it."""
    yield rf"\section{{{SYMBOLS}}}" + "\n"
    yield r"{\small\begin{longtable}{@{}l>{\raggedright}p{0.6\linewidth}l@{}}\toprule"
    named = {row.name: row for row in table_of_symbols() if row.words}
    for row in named.values():
        by = reference(row.entry.claim, known) if row.entry else ""
        short = row.meaning if row.meaning and width(row.meaning) < SHORT else ""
        stands = (
            f": {row.note}${short}$" if short and row.entry and not row.entry.claim.shown else ""
        )
        yield rf"${row.symbol}$ & {prose(row.words)}{stands} & {by} \\"
    yield r"\bottomrule\end{longtable}\addtocounter{table}{-1}}"


def _corrected(rows: dict[str, Row]) -> Iterator[str]:
    yield r"\section{Corrections}\label{corrections}" + "\n"
    yield "Printed statements that do not hold, most important first, each listed once.\n"
    yield r"\begin{enumerate}\raggedright"
    for correction in corrections():
        if correction.labels[0] in rows:
            yield from _correction(correction, rows)
    yield r"\end{enumerate}"


def _correction(correction: Correction, rows: dict[str, Row]) -> Iterator[str]:
    refuted = [rows[label].claim for label in correction.labels if label in rows]
    claim = refuted[0]
    names = ", ".join(reference(each, rows.keys()) for each in refuted)
    yield rf"\item \textbf{{{prose(correction.title)}}} ({prose(place_text(claim))}; {names})."
    yield rf"Printed: “{prose(correction.quote)}”."
    why = correction.why or claim.note
    yield prose(why) if why else ""
    own = [each for each in refuted if each is claim or not isinstance(each.proof, AllOf)]
    true = dict.fromkeys(each for wrong in own for each in wrong.amended_by)
    if true:
        listed = "; ".join(map(_instead, true))
        yield rf"True instead: {listed}"


def _instead(claim: Claim) -> str:
    """What is true instead, in one line: its sentence, or its formula if that is short."""
    found = said(claim)
    name = rf"\claim{{{claim.label}}}"
    if found.says:
        return f"{prose(found.says.rstrip('.'))} ({name})"
    short = found.formula and width(found.formula) < 2 * SHORT
    return f"${found.formula}$ ({name})" if short else name


def _quoted(report: Report) -> Iterator[str]:
    """The theorems that are quoted without proof, each with the claims that depend on it."""
    yield rf"\section{{{QUOTED}}}\label{{quoted}}" + "\n"
    known = [row.claim.label for row in report.rows]
    for axiom, resting in report.axioms.items():
        names = ", ".join(reference(claim, known) for claim in resting)
        yield rf"\paragraph{{{prose(axiom.name)}}}\label{{{axiom_key(axiom)}}} {prose(axiom.says)}"
        yield rf"\fitted{{{axiom.formula}}}" if axiom.formula else ""
        yield rf"{prose(axiom.source)}. {{\raggedright Claims that depend on it: {names}.\par}}"
    if not report.axioms:
        yield "None."


def _ledger(rows: dict[str, Row]) -> Iterator[str]:
    """Every claim in the order of the proofs, with its derivation."""
    for part, claims in sections():
        entries = [entry(rows[c.label], rows.keys()) for c in claims if c.label in rows]
        if entries:
            head = prose(part[:1].upper() + part[1:])
            yield rf"\needspace{{12\baselineskip}}\subsection{{{head}}}" + "\n"
            yield from entries
