"""Write the ledger as a document in LaTeX: notation, quoted theorems, every claim with its proof.

The article refers to it; see :mod:`tresym.report.pages.article`.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from importlib.resources import files

from tresym import release
from tresym.ledger.paper import sections
from tresym.ledger.verification import Report, Row
from tresym.report.pages.derivation import axiom_key, entry, prose, reference
from tresym.report.pages.symbols import rows as table_of_symbols
from tresym.report.typesetting.formula_width import width

SHORT = 24
"""Width of a formula that fits beside the words in the table of symbols, in letters."""
QUOTED = "Quoted theorems"
SYMBOLS = "Notation"


def ledger_document(report: Report) -> str:
    """Write the document.

    Args:
        report: verdicts on the ledger; claims outside it are left out.
    """
    frame = _file("ledger_document.tex").replace("{{ commands }}", commands())
    return frame.replace("{{ body }}", body(report)).replace("{{ version }}", release.dated())


def body(report: Report) -> str:
    """Write the text of the document, which can also be an appendix."""
    rows = {row.claim.label: row for row in report.rows}
    return "\n".join((*_symbols(rows.keys()), *_quoted(report), *_ledger(rows)))


def commands() -> str:
    """Return the commands that :func:`body` uses, for the preamble."""
    return _file("ledger_commands.tex")


def _file(name: str) -> str:
    return files("tresym.report.pages").joinpath(name).read_text(encoding="utf-8")


def _symbols(known: Collection[str]) -> Iterator[str]:
    """The table of the symbols of the paper, each with the claim that defines it."""
    yield rf"\section{{{SYMBOLS}}}" + "\n"
    yield r"{\small\begin{longtable}{@{}l>{\raggedright}p{0.54\linewidth}l@{}}\toprule"
    named = {row.name: row for row in table_of_symbols() if row.words}
    for row in named.values():
        by = reference(row.entry.claim, known) if row.entry else ""
        short = row.meaning if row.meaning and width(row.meaning) < SHORT else ""
        stands = (
            f": {row.note}${short}$" if short and row.entry and not row.entry.claim.shown else ""
        )
        yield rf"${row.symbol}$ & {prose(row.words)}{stands} & {by} \\"
    yield r"\bottomrule\end{longtable}\addtocounter{table}{-1}}"


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
    yield r"\section{The ledger}" + "\n"
    yield "Every claim, with its proof and its verdict, in the order of the proofs. A step of a"
    yield "derivation uses only the reasons written beside it."
    for part, claims in sections():
        entries = [entry(rows[c.label], rows.keys()) for c in claims if c.label in rows]
        if entries:
            head = prose(part[:1].upper() + part[1:])
            yield rf"\needspace{{12\baselineskip}}\subsection{{{head}}}" + "\n"
            yield from entries
