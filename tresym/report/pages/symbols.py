"""The table of symbols: meaning, definition, and assumptions."""

from __future__ import annotations

import re
from functools import cache

from tresym.ledger.claim import Claim, Definition, ImplicitFunction, Root
from tresym.ledger.definitions import Entry, table
from tresym.ledger.finding import Premise
from tresym.ledger.formulas import in_trees, names_of
from tresym.ledger.paper import all_claims, racket
from tresym.ledger.verification import Report
from tresym.reals.language.expression import symbol
from tresym.report.typesetting.conditions import gathered
from tresym.report.typesetting.latex import expression_latex, says_latex
from tresym.report.typesetting.line_breaking import broken
from tresym.report.typesetting.markdown import sentence
from tresym.report.typesetting.paper_location import place_text
from tresym.report.typesetting.plain_text import plain
from tresym.report.typesetting.statements import said
from tresym.report.typesetting.titles import shown_name

WIDEST = 30
"""Width of a line of the formula column, in letters."""
MOST = 4
"""Most lines of a formula; the page of its claim shows a longer one."""
SPELLED = {
    "epsilon_pi": ("sweep", "sweeps"),
    "epsilon_4": ("sweep", "sweeps"),
    "epsilon_star": ("ε*",),
    "P": ("phase",),
}
"""Words that stand for a symbol in sentences, besides its letter."""


class Row:
    """A row of the table: a symbol, its meaning in words, and the claim that defines it."""

    def __init__(self, name: str, entry: Entry | None) -> None:
        self.name = name
        self.entry = entry
        self.words = racket().written.words.get(name, "")
        self.own = racket().written.words_of_proofs.get(name, "")
        self.symbol = expression_latex(symbol(name))

    @property
    def meaning(self) -> str:
        """The defining formula in LaTeX; empty for a variable."""
        if self.entry is None:
            return ""
        claim = self.entry.claim
        if isinstance(claim.proof, Root):
            return says_latex(claim.says)
        if claim.shown is None:
            return expression_latex(self.entry.meaning)
        own = [p for p in claim.shown.split(r",\quad ") if p.startswith(f"{self.symbol} = ")]
        return own[0].partition(" = ")[2] if own else claim.shown

    @property
    def given(self) -> list[str]:
        """The conditions of the definition, in LaTeX."""
        return [] if self.entry is None else gathered(self.entry.claim.given)

    @property
    def note(self) -> str:
        """Words in front of the formula, for a root or an implicit function."""
        proof = self.entry and self.entry.claim.proof
        if isinstance(proof, ImplicitFunction):
            return "the slope of an implicit function, "
        return "the root of " if isinstance(proof, Root) else ""


@cache
def rows() -> tuple[Row, ...]:
    """Return every symbol in the order of the paper, then those that only proofs use."""
    claims = [c for c in all_claims() if not _assumed(c)]
    entries: dict[str, list[Entry]] = {}
    for entry in table(claims):
        entries.setdefault(str(entry.symbol), []).append(entry)
    own = racket().written
    names = dict.fromkeys((*own.words, *own.words_of_proofs, *entries))
    return tuple(Row(name, entry) for name in names for entry in entries.get(name, [None]))


def _assumed(claim: Claim) -> bool:
    return claim.expect is Premise.ASSUMED


def symbols(report: Report) -> str:
    """Write the tables of symbols and of physical assumptions in Markdown.

    Args:
        report: verdicts on the ledger; definitions outside it are left out.
    """
    labels = {row.claim.label for row in report.rows}
    assumed = [c for c in (row.claim for row in report.rows) if _assumed(c)]
    found = [row for row in rows() if row.entry is None or row.entry.claim.label in labels]
    return "\n".join(
        (
            "## Symbols of the paper",
            "",
            "| symbol | meaning | defined in | formula | conditions |",
            "|---|---|---|---|---|",
            *(_line(row) for row in found if row.words),
            "",
            "## Symbols used in single proofs",
            "",
            "| symbol | meaning | defined in | formula | conditions |",
            "|---|---|---|---|---|",
            *(_line(row) for row in found if not row.words),
            "",
            "## Physical assumptions",
            "",
            "| equation | conditions | meaning | claim |",
            "|---|---|---|---|",
            *map(_assumption, assumed),
            "",
        )
    )


def _line(row: Row) -> str:
    letter = f'<span id="{anchor(row.name)}"></span>${row.symbol}$'
    lines = broken(row.meaning, WIDEST)
    long = len(lines) > MOST or any(r"\Big/" in line for line in lines)
    formula = (
        "a long formula: see the claim"
        if long
        else "<br>".join(f"${line.strip()}$" for line in lines)
    )
    stands = f"{row.note}{formula}" if row.meaning else "a variable"
    given = ", ".join(f"${condition}$" for condition in row.given)
    by = f"`{shown_name(row.entry.claim.label)}`" if row.entry else ""
    return _cells(letter, sentence(row.words or row.own), by, stands, given)


def anchor(name: str) -> str:
    """Return the HTML id of a symbol's row."""
    return f"symbol-{name.replace('_', '-')}"


def _assumption(claim: Claim) -> str:
    says = claim.shown or says_latex(claim.says)
    given = ", ".join(f"${condition}$" for condition in gathered(claim.given))
    name = claim.proof.assumes if isinstance(claim.proof, Definition) else ""
    return _cells(f"${says}$", given, name, _by(claim))


def _by(claim: Claim) -> str:
    return f"`{shown_name(claim.label)}`" + (f" ({place_text(claim)})" if claim.where else "")


def _cells(*cells: str) -> str:
    written = (re.sub(r"(?<!\\)\|", r"\\vert ", cell) for cell in cells)
    return f"| {' | '.join(written)} |"


def used(claim: Claim) -> list[str]:
    """Return the names of the symbols that a claim uses, in its formulas or in its sentence."""
    stated = () if claim.statement is None else (claim.statement,)
    in_formulas = names_of(*map(in_trees, (*stated, *claim.given)))
    words = said(claim).says or ""
    return [name for name in _patterns() if name in in_formulas or _patterns()[name].search(words)]


@cache
def _patterns() -> dict[str, re.Pattern[str]]:
    """For each symbol a pattern that finds it in a sentence.

    A single small letter is left out, since it may be the article "a".
    """
    found = {}
    for row in rows():
        letters = plain(row.symbol)
        unambiguous = len(letters) > 1 or not letters.isascii() or letters.isupper()
        spellings = [*([letters] if unambiguous else []), *SPELLED.get(row.name, ())]
        either = "|".join(map(_alone, spellings)) or "(?!)"
        found[row.name] = re.compile(either)
    return found


def _alone(letters: str) -> str:
    """A pattern for a symbol that is not part of another symbol or of a word."""
    before = "(?<![A-Za-z])" if letters[0].isascii() else ""
    after = "A-Za-z" if letters[-1].isascii() and letters[-1].isalpha() else ""
    return rf"{before}{re.escape(letters)}(?![{after}*′₀-₉])"


def as_used(claim: Claim) -> list[dict[str, str]]:
    """Return the symbols that a claim uses, each with its letters and its anchor, for its page."""
    letters = {row.name: plain(row.symbol) for row in rows()}
    return [{"letters": letters[name], "anchor": anchor(name)} for name in used(claim)]
