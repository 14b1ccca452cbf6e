"""Typeset claims in LaTeX: statements with their derivations, for the article or to paste."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from decimal import Context

from tresym.ledger.axioms import Axiom
from tresym.ledger.claim import AllOf, Claim
from tresym.ledger.finding import Finding
from tresym.ledger.verification import Row
from tresym.reals.numbers.exact import fraction_text
from tresym.reals.verdict import Verdict
from tresym.report.typesetting.chains import EQUIVALENT, Because, Display, Line, displays
from tresym.report.typesetting.finding_text import readable
from tresym.report.typesetting.formula_width import width
from tresym.report.typesetting.formulas import pieces
from tresym.report.typesetting.line_breaking import broken
from tresym.report.typesetting.markdown import scripted
from tresym.report.typesetting.paper_location import place_text
from tresym.report.typesetting.statements import conditions, said
from tresym.report.typesetting.titles import shown_name, title

WIDEST = 62
"""Width of a line of the article with a formula and its reason, in letters."""
TOO_WIDE = 72
"""Width of a line beyond which a formula that cannot be broken is left out."""
LONGEST = 400
"""Characters of a finding that are shown."""
LINE = 66
"""Width of a line with a formula alone, in letters."""
NARROW = 0.8
"""Width of a line of LaTeX's article class relative to our article, less the equation number."""
_EQREF = re.compile(r"\\eqref\{[^}]*\}")
_LABEL = re.compile(r"\b[a-z]\w*_\w+")
"""A label with an underscore, which cannot be an ordinary word."""

_LETTERS = {
    "²": r"\textsuperscript{2}", "⁻": r"\textsuperscript{$-$}", "¹": r"\textsuperscript{1}",
    "“": "``", "”": "''", "_": r"\_", "&": r"\&", "%": r"\%", "#": r"\#", "^": r"\^{}",
    "{": r"\{", "}": r"\}", "~": r"\textasciitilde{}", "\\": r"\textbackslash{}",
    "…": r"\dots{}", "<": "$<$", ">": "$>$", "−": "$-$", "√": r"$\surd$", "=": "$=$",
    "°": r"$^\circ$", "·": r"$\cdot$", "→": r"$\to$", "|": r"$\vert$",
}  # fmt: skip
"""Characters in sentences that are special in TeX or missing in its text fonts."""


def prose(text: str) -> str:
    """Return a sentence in LaTeX: formulas as mathematics, names in backticks as labels.

    A character that text fonts lack becomes a question mark, so that LaTeX does not stop.
    """

    def script(mark: str, inside: str) -> str:
        command = r"\textsuperscript" if mark == "^" else r"\textsubscript"
        return f"{command}{{{_lettered(inside)}}}"

    return "".join(
        code(p.text)
        if p.code
        else f"${p.latex.strip()}$"
        if p.latex
        else scripted(p.text, _lettered, script)
        for p in pieces(text)
    )


def _lettered(text: str) -> str:
    return "".join(_LETTERS.get(c, c if ord(c) < 256 or c in "–—’“”šćž" else "?") for c in text)


def axiom_key(axiom: Axiom) -> str:
    """Return the LaTeX label of a quoted theorem."""
    return "axiom:" + "".join(c for c in axiom.name if c.isascii() and c.isalpha())


def refused(rows: Collection[Row]) -> tuple[str, ...]:
    """Return an error line for each refuted claim, with what is true instead."""

    def named(claims: Collection[Claim]) -> str:
        return ", ".join(shown_name(claim.label) for claim in claims) or "no claim of the ledger"

    return tuple(
        f"tresym: {shown_name(row.claim.label)} is REFUTED; true instead: "
        f"{named(row.claim.amended_by)} (to print it marked as refuted, use derive --refuted)"
        for row in rows
        if row.finding.verdict is Verdict.REFUTED
    )


def in_words(claim: Claim, name: Callable[[str], str] | None = None) -> list[str]:
    """Return the sentence of a claim, if it has one, and its conditions, as lines of LaTeX.

    Args:
        claim: the claim.
        name: how to write the label of a part of a conjunction; see
            :func:`tresym.report.typesetting.statements.conditions`.
    """
    found = said(claim)
    lines = [prose(found.says)] if found.says else []
    return [*lines, *filter(None, [conditions(found, in_dollars, prose, name)])]


def in_dollars(formula: str) -> str:
    """Return a formula as inline mathematics."""
    return f"${formula}$"


def entry(row: Row, known: Collection[str]) -> str:
    """Return the entry of a claim in the ledger of the article.

    Args:
        row: the claim with its verdict.
        known: labels that have an entry and can be linked to.
    """
    claim, finding = row.claim, row.finding
    verdict = finding.verdict.value
    place = prose(place_text(claim)) if claim.where else "lemma"
    head = (
        rf"\paragraph{{{prose(title(claim.label))}}}\label{{claim:{claim.label}}}"
        rf"\hypertarget{{claim:{claim.label}}}{{}}"
        rf"\texttt{{\small {_lettered(shown_name(claim.label))}}}\atend{{"
        rf"\verdict{{{verdict.lower()}}}{{{verdict}}}\ \textsf{{\small {place}}}}}"
    )
    lines = [r"\needspace{4\baselineskip}", head]
    if finding.verdict is Verdict.REFUTED:
        lines.append(r"\verdict{refuted}{This is refuted:}\par")
    if claim.paper_says:
        lines.append(rf"\textsf{{\small The paper:}} {prose(claim.paper_says)}\par")
    lines += [rf"{{\raggedright {words}\par}}" for words in in_words(claim, code)]
    lines += _decided(claim, said(claim).means)
    lines += _fitting(claim)
    if claim.note:
        lines.append(rf"{prose(claim.note)}\par")
    if claim.axioms:
        cited = ", ".join(rf"{prose(a.name)} (Section~\ref{{quoted}})" for a in claim.axioms)
        lines.append(rf"\textsf{{\small Quoted:}} {cited}.\par")
    lines += outcome(row, known)
    return "\n".join(lines) + "\n"


def _fitting(claim: Claim) -> Iterator[str]:
    """The displays of a claim; in place of those that are too wide, where they are printed."""
    left_out = False
    for body in set_displays(claim):
        if any(width(line) > TOO_WIDE for line in body.split(r" \\ ")):
            left_out = True
        else:
            yield rf"\fitted{{{body}}}"
    if left_out:
        shown = rf"\texttt{{tresym verify {_lettered(shown_name(claim.label))} -{{}}-json}}"
        parts = ""
        if isinstance(claim.proof, AllOf):
            named = ", ".join(
                rf"\texttt{{{_lettered(shown_name(c.label))}}}" for c in claim.proof.claims
            )
            parts = f"The claim states all of {named}. "
        long = f"{parts}A formula that is too long for this page is left out; {shown} prints it."
        yield rf"{{\raggedright\textsf{{\small {long}}}\par}}"


def _decided(claim: Claim, means: Collection[str]) -> Iterator[str]:
    """The formulas that stand for a sentence, unless one is too wide for the page."""
    if any(width(line) > TOO_WIDE for formula in means for line in broken(formula, LINE)):
        shown = rf"\texttt{{tresym verify {_lettered(shown_name(claim.label))} -{{}}-json}}"
        long = f"The formula that is decided is too long for this page; {shown} prints it."
        yield rf"\textsf{{\small {long}}}\par"
    elif means:
        rows = r" \\ ".join(map(alone, means))
        body = rows if len(means) == 1 else rf"\begin{{gathered}}{rows}\end{{gathered}}"
        yield rf"\textsf{{\small As a formula:}} \fitted{{{body}}}"


def _valued(mid: str) -> str:
    """A value rounded to 50 digits: 1210 if the midpoint of its ball is 1209.99…."""
    text = f"{Context(prec=50).create_decimal(mid):f}"
    return f"${text.rstrip('0').rstrip('.') if '.' in text else text}$"


def outcome(row: Row, known: Collection[str]) -> Iterator[str]:
    """Yield the results below a statement: value, evidence, witness, and what is true instead."""
    finding = row.finding
    if finding.value is not None:
        yield rf"\textsf{{\small Value}} {_valued(finding.value.mid)}.\par"
    if finding.verdict is Verdict.ENCLOSED and " = " not in finding.why:
        yield rf"{{\raggedright\textsf{{\small Enclosed:}} {_enclosed(finding, known)}.\par}}"
    if finding.verdict is Verdict.REFUTED:
        why = readable(finding.why[:LONGEST])
        yield rf"{{\raggedright\textsf{{\small Evidence:}} {_told(why, known)}.\par}}"
        if finding.witness and " = " not in why:
            point = ", ".join(f"{n} = {fraction_text(v)}" for n, v in finding.witness.items())
            text = prose(readable(point[:LONGEST]))
            yield rf"{{\raggedright\textsf{{\small Witness:}} {text}.\par}}"
    if row.claim.amended_by:
        names = ", ".join(reference(c, known) for c in row.claim.amended_by)
        yield rf"{{\raggedright\textsf{{\small True instead:}} {names}.\par}}"


def _enclosed(finding: Finding, known: Collection[str]) -> str:
    """How a bound was proved, with the labels of the claims that it follows from."""
    if finding.follows_from:
        return "follows from " + ", ".join(map(code, finding.follows_from))
    return _told(readable(finding.why[:LONGEST]), known)


def _told(why: str, known: Collection[str]) -> str:
    """A finding in LaTeX, with known labels in typewriter type."""
    return prose(_LABEL.sub(lambda m: f"`{m[0]}`" if m[0] in known else m[0], why))


def reference(claim: Claim, known: Collection[str]) -> str:
    """Return the label of a claim, linked to its entry if it has one."""
    name = rf"\texttt{{{_lettered(shown_name(claim.label))}}}"
    return rf"\hyperref[claim:{claim.label}]{{{name}}}" if claim.label in known else name


def set_displays(claim: Claim, share: float = 1) -> list[str]:
    """Return the displays of a claim as LaTeX ``aligned`` blocks; a formula alone needs none.

    Args:
        claim: the claim.
        share: the width available, relative to a line of our article.
    """
    return [_aligned(display, share) for display in displays(claim)]


def chosen_lines(claim: Claim, items: Iterable[tuple[str, str]], share: float) -> str:
    """Return some lines of a derivation, aligned, with reasons in words that the caller gives.

    Args:
        claim: a claim whose proof is a chain.
        items: the number of each line, counted from 1, or several joined by a plus sign that are
            set in one line; and the reason in LaTeX, or an empty text.
        share: the width available, relative to a line of our article.
    """
    lines = [(n, line) for n, d in enumerate(displays(claim)) for line in d]
    lines = lines[len(claim.knowing) :]
    starts = {n: line.left for n, line in reversed(lines)}
    rows: list[str] = []
    shown: set[int] = set()
    for numbers, why in items:
        chosen = [lines[int(number) - 1] for number in numbers.split("+")]
        of, first = chosen[0]
        left = first.left if first.left == EQUIVALENT or of in shown else starts[of]
        left = "" if left == EQUIVALENT and not rows else left
        shown.add(of)
        rows += _worded(left, " ".join(line.right for _, line in chosen), why, share * LINE)
    return aligned_rows(rows)


def _worded(left: str, right: str, why: str, limit: float) -> Iterator[str]:
    """A line of a derivation; what is too wide for one line continues on the next."""
    reason = rf"\text{{\small {why}}}" if why else ""
    if width(left) + width(right) > limit and left != EQUIVALENT:
        first, *rest = broken(left, limit)
        yield from (f"&{first}", *map(continued, rest))
        left = ""
    first, *rest = broken(right, limit)
    *lines, last = (f"{left or ' '}&{first}", *map(continued, rest))
    yield from lines
    used = (width(left) + width(first) if not rest else width(rest[-1])) + 0.5 * len(why)
    yield last + (rf"\qquad {reason}" if why and used <= limit else "")
    if why and used > limit:
        yield rf"&\qquad\qquad {reason}"


def alone(formula: str, share: float = 1) -> str:
    """Return a formula without a derivation, broken into lines if it is too wide."""
    lines = broken(formula, share * LINE)
    return (
        formula if len(lines) == 1 else aligned_rows([f"&{lines[0]}", *map(continued, lines[1:])])
    )


def derived(display: Sequence[Line], share: float = 1) -> str:
    """Return the lines of a derivation, aligned at their relation signs.

    Args:
        display: the lines with their reasons.
        share: the width available, relative to a line of our article.
    """
    return _aligned(tuple(display), share)


def _aligned(display: Display, share: float) -> str:
    """Lines aligned at the relation sign, reasons at the right; too wide ones are broken."""
    if len(display) == 1 and not display[0].reasons:
        return alone(display[0].right, share)
    start = max(width(line.left) for line in display)
    narrow = all(start + width(line.right) + _extent(line) <= share * WIDEST for line in display)
    return aligned_rows([*map(_row, display)] if narrow else [*_broken(display, share)])


def _row(line: Line) -> str:
    why = _because(line)
    return f"{line.left} &{line.right}{f' && {why}' if why else ''}".lstrip()


def _broken(display: Display, share: float) -> Iterator[str]:
    """Lines with the left side above the right side, each reason beside or below its formula."""
    for line, after in zip(display, (*display[1:], None), strict=True):
        arrow = line.left if line.left == EQUIVALENT else ""
        if line.left and not arrow and (after is None or after.left not in ("", EQUIVALENT)):
            line = Line("", line.left + line.right, line.reasons)
        if line.left and not arrow:
            first, *rest = broken(line.left, share * LINE)
            yield from (f"&{first}", *map(continued, rest))
        first, *rest = broken(line.right, share * LINE)
        *lines, last = (rf"&{arrow}\quad {first}", *map(continued, rest))
        yield from lines
        beside = width((rest or [first])[-1]) + _extent(line) <= share * WIDEST
        whys = [why for part in _parted(line, share) if (why := _because(part))]
        yield last + (rf"\qquad {whys.pop(0)}" if whys and beside else "")
        yield from (rf"&\qquad {why}" for why in whys)


def _parted(line: Line, share: float) -> Iterator[Line]:
    """The line with as many reasons as fit below it, then again with the following ones."""
    fitting: tuple[Because, ...] = ()
    for why in line.reasons:
        if fitting and _extent(line._replace(reasons=(*fitting, why))) > share * WIDEST:
            yield line._replace(reasons=fitting)
            fitting = ()
        fitting = (*fitting, why)
    yield line._replace(reasons=fitting)


def continued(line: str) -> str:
    """Return the continuation of a line, indented."""
    return rf"&\quad\quad {line}"


def aligned_rows(rows: list[str]) -> str:
    """Return rows with alignment marks as a LaTeX ``aligned`` block."""
    body = " \\\\\n".join(rows)
    return f"\\begin{{aligned}}\n{body}\n\\end{{aligned}}"


def _because(line: Line) -> str:
    why = ", ".join(map(_reason, line.reasons))
    return rf"\text{{\footnotesize {why}}}" if why else ""


def _extent(line: Line) -> float:
    """The approximate width of the reasons of a line, in letters of a formula."""
    words = sum(
        len(_EQREF.sub("(1.1)", why.words)) + 1 + sum(map(len, why.labels)) for why in line.reasons
    )
    return 0.6 * words + sum(0.8 * width(why.formula) for why in line.reasons)


def _reason(why: Because) -> str:
    if why.labels:
        return f"{why.words} " + ", ".join(map(code, why.labels))
    return f"{why.words} ${why.formula}$" if why.formula else why.words


def code(label: str) -> str:
    """Return the readable name of a claim in typewriter type."""
    return rf"\texttt{{{_lettered(shown_name(label))}}}"
