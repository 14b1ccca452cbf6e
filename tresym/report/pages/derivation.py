"""The derivation as one LaTeX article: each statement, its chain with the reasons, its verdict."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator

from tresym.ledger.axioms import Axiom
from tresym.ledger.claim import Claim
from tresym.ledger.paper import sections
from tresym.ledger.verification import Report, Row
from tresym.reals.numbers.exact import fraction_text
from tresym.reals.verdict import Verdict
from tresym.report.pages.symbols import rows as table_of_symbols
from tresym.report.words.chains import EQUIVALENT, Because, Display, Line, displays
from tresym.report.words.markdown import scripted
from tresym.report.words.place import place_text
from tresym.report.words.said import conditions, said
from tresym.report.words.width import width
from tresym.report.words.wording import readable

WIDEST = 62
"""Letters of a formula with its reason that fit a line of the article."""
QUOTED = "Theorems that are quoted"
SYMBOLS = "Symbols"
SHORT = 24
"""Letters of a formula that fit beside the words in the table of symbols."""

PREAMBLE = r"""\documentclass[a4paper,11pt]{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\usepackage{lmodern,amsmath,amssymb,adjustbox,xcolor,geometry,longtable}
\usepackage[hidelinks]{hyperref}
\geometry{margin=25mm}
\setlength{\parindent}{0pt}
\setlength{\parskip}{4pt plus 2pt}
\emergencystretch=3em
\definecolor{proved}{HTML}{1B6E3C}
\definecolor{enclosed}{HTML}{1F5FA8}
\definecolor{refuted}{HTML}{9C2A6B}
\definecolor{undecided}{HTML}{8A6D00}
\definecolor{defined}{HTML}{4A5A6A}
\definecolor{assumed}{HTML}{7A4B1E}
\newcommand{\verdict}[2]{\textcolor{#1}{\textsf{\small #2}}}
\newcommand{\fitted}[1]{\[\adjustbox{max width=\linewidth}{$\displaystyle #1$}\]}
"""

TITLE = r"""\title{The tennis racket effect, derived and judged}
\author{tresym}
\date{}
\begin{document}
\maketitle
Each statement of L.~Van Damme, P.~Mardešić and D.~Sugny, \emph{The tennis racket effect in a
three-dimensional rigid body}, Physica~D 338 (2017) 17, with its proof and its verdict. A step of a
chain uses only the reasons that stand at its right.
"""

_LETTERS = {
    "₀": r"\textsubscript{0}", "₁": r"\textsubscript{1}", "₂": r"\textsubscript{2}",
    "₃": r"\textsubscript{3}", "ᵢ": r"\textsubscript{i}", "₊": r"\textsubscript{+}",
    "₋": r"\textsubscript{$-$}", "⁰": r"\textsuperscript{0}", "²": r"\textsuperscript{2}",
    "³": r"\textsuperscript{3}", "⁴": r"\textsuperscript{4}", "⁵": r"\textsuperscript{5}",
    "“": "``", "”": "''",
    "⁶": r"\textsuperscript{6}", "⁻": r"\textsuperscript{$-$}", "ᵀ": r"\textsuperscript{T}",
    "ⁿ": r"\textsuperscript{n}",
    "α": r"$\alpha$", "β": r"$\beta$", "γ": r"$\gamma$", "δ": r"$\delta$", "Δ": r"$\Delta$",
    "ε": r"$\epsilon$", "θ": r"$\theta$", "κ": r"$\kappa$", "λ": r"$\lambda$", "μ": r"$\mu$",
    "π": r"$\pi$", "ρ": r"$\rho$", "σ": r"$\sigma$", "τ": r"$\tau$", "φ": r"$\phi$",
    "Φ": r"$\Phi$", "χ": r"$\chi$",
    "ψ": r"$\psi$", "Ω": r"$\Omega$", "Ψ": r"$\Psi$", "∂": r"$\partial$", "∞": r"$\infty$",
    "√": r"$\surd$", "≤": r"$\le$", "≥": r"$\ge$", "≠": r"$\ne$", "≈": r"$\approx$",
    "≃": r"$\simeq$", "≪": r"$\ll$", "≫": r"$\gg$", "→": r"$\to$", "⇒": r"$\Rightarrow$",
    "⟺": r"$\Leftrightarrow$", "±": r"$\pm$", "·": r"$\cdot$", "×": r"$\times$", "−": "$-$",
    "∈": r"$\in$", "∉": r"$\notin$", "∥": r"$\parallel$", "∫": r"$\int$", "′": "$'$",
    "<": "$<$", ">": "$>$", "_": r"\_", "&": r"\&", "%": r"\%", "#": r"\#", "^": r"\^{}",
    "{": r"\{", "}": r"\}", "…": r"\dots{}", "Ṙ": r"$\dot R$", "″": "$''$",
    "Σ": r"$\Sigma$", "~": r"\textasciitilde{}", "∝": r"$\propto$", "∓": r"$\mp$",
    "\\": r"\textbackslash{}", "°": r"$^\circ$",
}  # fmt: skip


def prose(text: str) -> str:
    """A sentence of ours for LaTeX: the letters that text fonts lack become mathematics.

    Anything else outside Latin-1 falls back to a visible placeholder rather than a broken run.
    """

    def script(mark: str, inside: str) -> str:
        command = r"\textsuperscript" if mark == "^" else r"\textsubscript"
        return f"{command}{{{_lettered(inside)}}}"

    return scripted(text, _lettered, script)


def _lettered(text: str) -> str:
    return "".join(_LETTERS.get(c, c if ord(c) < 256 or c in "–—’“”šćž" else "?") for c in text)


def article(report: Report) -> str:
    """The whole article for the rows of a report, in the order of the proofs."""
    rows = {row.claim.label: row for row in report.rows}
    pages = [PREAMBLE, TITLE, *_symbols(rows.keys())]
    for title, claims in sections():
        entries = [_entry(rows[c.label], rows.keys()) for c in claims if c.label in rows]
        if entries:
            pages += [rf"\section*{{{prose(title[:1].upper() + title[1:])}}}" + "\n", *entries]
    return "\n".join([*pages, *_quoted(report), r"\end{document}", ""])


def _symbols(known: Collection[str]) -> Iterator[str]:
    """The table of the symbols that have words, each with the claim that defines it."""
    yield rf"\section*{{{SYMBOLS}}}" + "\n"
    yield r"\begin{longtable}{@{}lp{0.56\linewidth}l@{}}"
    named = {row.name: row for row in table_of_symbols() if row.words}
    for row in named.values():
        by = _reference(row.entry.claim, known) if row.entry else ""
        short = row.meaning if row.meaning and width(row.meaning) < SHORT else ""
        stands = (
            f": {row.note}${short}$" if short and row.entry and not row.entry.claim.shown else ""
        )
        yield rf"${row.symbol}$ & {prose(row.words)}{stands} & {by} \\"
    yield r"\end{longtable}"


def _quoted(report: Report) -> Iterator[str]:
    """The theorems that are quoted, each with the claims that rest on it, as a bibliography."""
    if not report.axioms:
        return
    known = [row.claim.label for row in report.rows]
    yield rf"\section*{{{QUOTED}}}" + "\n"
    yield r"\begin{thebibliography}{99}"
    for axiom, resting in report.axioms.items():
        names = ", ".join(_reference(claim, known) for claim in resting)
        yield rf"\bibitem{{{_key(axiom)}}} \emph{{{prose(axiom.name)}}}. {prose(axiom.says)}"
        yield rf"\fitted{{{axiom.formula}}}" if axiom.formula else ""
        yield rf"{prose(axiom.source)}. {{\raggedright Claims that rest on it: {names}.\par}}"
    yield r"\end{thebibliography}"


def _key(axiom: Axiom) -> str:
    return "axiom:" + "".join(c for c in axiom.name if c.isascii() and c.isalpha())


def fragment(row: Row) -> str:
    """One statement with its conditions and its chain, to paste into a paper that loads amsmath.

    A refuted one is a paragraph that says so, with the evidence and what is true instead.
    """
    claim = row.claim
    if row.finding.verdict is not Verdict.REFUTED:
        return "\n".join([*_in_words(claim), *_numbered(claim)]) + "\n"
    lines = [rf"\textbf{{Refuted}} (\texttt{{{_lettered(claim.label)}}}):", *_stated(claim)]
    lines += [prose(f"Evidence: {readable(row.finding.why[:300])}.")]
    for true in claim.amended_by:
        lines += [rf"\textbf{{True instead}} (\texttt{{{_lettered(true.label)}}}):", *_stated(true)]
    return "\n".join(lines) + "\n"


def refused(rows: Collection[Row]) -> tuple[str, ...]:
    """For every refuted claim one line that says so, and what is true instead."""
    return tuple(
        f"tresym: {row.claim.label} is REFUTED; true instead: "
        f"{', '.join(true.label for true in row.claim.amended_by) or 'nothing is claimed'}"
        " (derive --refuted prints it, marked)"
        for row in rows
        if row.finding.verdict is Verdict.REFUTED
    )


def _in_words(claim: Claim, name: Callable[[str], str] | None = None) -> list[str]:
    """What a claim says in words: its sentence, if it has one, and its conditions."""
    found = said(claim)
    lines = [prose(found.says)] if found.says else []
    return [*lines, *filter(None, [conditions(found, in_dollars, prose, name)])]


def _stated(claim: Claim) -> list[str]:
    """What a claim says with its conditions, without its chain, in lines of text."""
    formula = said(claim).formula
    return [*_in_words(claim), *([rf"\[{formula}\]"] if formula else [])]


def _numbered(claim: Claim) -> Iterator[str]:
    """The displays as equations that can be referred to: by the label of the claim, then -2, -3."""
    for n, body in enumerate(_displays(claim), 1):
        label = f"tresym:{claim.label}" + (f"-{n}" if n > 1 else "")
        yield f"\\begin{{equation}}\\label{{{label}}}\n{body}\n\\end{{equation}}"


def in_dollars(formula: str) -> str:
    """A formula within a line of text."""
    return f"${formula}$"


def _entry(row: Row, known: Collection[str]) -> str:
    claim, finding = row.claim, row.finding
    verdict = finding.verdict.value
    head = (
        rf"\paragraph{{\texttt{{{_lettered(claim.label)}}}}}\label{{claim:{claim.label}}}"
        rf"\hfill\verdict{{{verdict.lower()}}}{{{verdict}}}\ \textsf{{\small "
        rf"{prose(place_text(claim) if claim.where else 'lemma')}}}\par"
    )
    lines = [head]
    if finding.verdict is Verdict.REFUTED:
        lines.append(r"\verdict{refuted}{This is refuted:}\par")
    if claim.paper_says:
        lines.append(rf"\textsf{{\small The paper:}} {prose(claim.paper_says)}\par")
    lines += [rf"{{\raggedright {words}\par}}" for words in _in_words(claim, _code)]
    lines += [rf"\textsf{{\small Decided as}} \fitted{{{body}}}" for body in said(claim).means]
    lines += [rf"\fitted{{{body}}}" for body in _displays(claim)]
    if claim.note:
        lines.append(rf"{prose(claim.note)}\par")
    if claim.axioms:
        cited = ", ".join(rf"{prose(a.name)}~\cite{{{_key(a)}}}" for a in claim.axioms)
        lines.append(rf"\textsf{{\small Quoted:}} {cited}.\par")
    lines += _outcome(row, known)
    return "\n".join(lines) + "\n"


def _outcome(row: Row, known: Collection[str]) -> Iterator[str]:
    """What a report adds to the statement: value, witness, amendment."""
    finding = row.finding
    if finding.value is not None:
        yield rf"\textsf{{\small Value}} {finding.value.mid[:52]}.\par"
    if finding.verdict is Verdict.REFUTED:
        why = readable(finding.why[:300])
        yield rf"\textsf{{\small Evidence:}} {{\sloppy {prose(why)}}}.\par"
        if finding.witness and " = " not in why:
            point = ", ".join(f"{n} = {fraction_text(v)}" for n, v in finding.witness.items())
            yield rf"\textsf{{\small Witness:}} {{\sloppy {prose(readable(point[:400]))}}}.\par"
    if row.claim.amended_by:
        names = ", ".join(_reference(c, known) for c in row.claim.amended_by)
        yield rf"{{\raggedright\textsf{{\small True instead:}} {names}.\par}}"


def _reference(claim: Claim, known: Collection[str]) -> str:
    name = rf"\texttt{{{_lettered(claim.label)}}}"
    return rf"\hyperref[claim:{claim.label}]{{{name}}}" if claim.label in known else name


def _displays(claim: Claim) -> list[str]:
    """The displays of a claim, each in `aligned`; a formula alone stands by itself."""
    return [_aligned(display) for display in displays(claim)]


def _aligned(display: Display) -> str:
    """Lines aligned at the sign, reasons at the right; what is too wide for that is broken."""
    if len(display) == 1 and not display[0].reasons:
        return display[0].right
    start = width(display[0].left)
    broken = any(start + width(line.right) + _extent(line) > WIDEST for line in display)
    rows = []
    for line in display:
        why = ", ".join(map(_reason, line.reasons))
        reason = rf"\text{{\footnotesize {why}}}"
        if not broken:
            rows.append(f"{line.left} &{line.right}{f' && {reason}' if why else ''}".lstrip())
            continue
        arrow = line.left if line.left == EQUIVALENT else ""
        rows += [f"&{line.left}"] if line.left and not arrow else []
        fits = width(line.right) + _extent(line) <= WIDEST or not why
        rows.append(rf"&{arrow}\quad {line.right}" + (rf"\qquad {reason}" if fits and why else ""))
        rows += [] if fits else [rf"&\qquad {reason}"]
    body = " \\\\\n".join(rows)
    return f"\\begin{{aligned}}\n{body}\n\\end{{aligned}}"


def _extent(line: Line) -> float:
    """About how wide the reasons of a line are set, in letters of a formula."""
    words = sum(len(why.words) + 1 + sum(map(len, why.labels)) for why in line.reasons)
    return 0.6 * words + sum(0.8 * width(why.formula) for why in line.reasons)


def _reason(why: Because) -> str:
    if why.labels:
        return f"{why.words} " + ", ".join(map(_code, why.labels))
    return f"{why.words} ${why.formula}$" if why.formula else why.words


def _code(label: str) -> str:
    return rf"\texttt{{{_lettered(label)}}}"
