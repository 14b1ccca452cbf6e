"""Write single derivations to paste, in LaTeX, as slides, in Markdown, or as a notebook.

A fragment reads as a short derivation: the hypotheses, the equations that it uses, and the steps
with their reasons in words. Verdicts are left out; a refuted claim is marked as refuted, and an
UNDECIDED one as not proved.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterator
from typing import NamedTuple

from tresym.ledger.claim import Claim
from tresym.ledger.verification import Row
from tresym.reals.verdict import Verdict
from tresym.report.pages import notebook
from tresym.report.pages.derivation import LONGEST, NARROW, alone, derived, prose
from tresym.report.typesetting.chains import Because, Display, Line, displays
from tresym.report.typesetting.finding_text import readable
from tresym.report.typesetting.markdown import sentence
from tresym.report.typesetting.statements import conditions, in_dollars, said
from tresym.report.typesetting.titles import shown_name, title

_TRIVIAL = frozenset(["algebra", "roots", "trigonometry", "exponentials", "collecting"])
"""Reasons of which two in a row become one step."""
_WORDS = {
    "by the sign prover": "", "algebra": "", "times": "multiplying by",
    "collecting": "collecting terms", "cutting": "splitting the interval",
    "evaluating": "evaluating the derivative", "exponentials": "rules of exponents",
    "roots": "simplifying the roots",
    "inverse functions": "inverse functions cancel",
}  # fmt: skip
"""Reasons that are written in other words than in the ledger; obvious ones are left out."""
_SLIDE = 0.85
"""Width of a slide relative to a line of our article."""
_IN_TEXT = re.compile(r"\\text\{\\(?:footnotesize|small) ([^{}$]*(?:\$[^$]*\$[^{}$]*)*)\}")


class Style(NamedTuple):
    """How the parts of a derivation are written."""

    words: Callable[[str], str]
    equation: Callable[[str, str], str]
    """An equation from its body and its label."""
    refer: Callable[[str], str]
    """A reference to the equation with a label."""
    share: float
    """The width available, relative to a line of our article."""
    strong: Callable[[str], str] = r"\textbf{{{}}}".format
    """A word in bold type."""


def written(rows: Collection[Row], style: str) -> str:
    """Write the derivations of some claims.

    Args:
        rows: the claims with their verdicts.
        style: ``article``, ``beamer``, ``markdown`` or ``jupyter``.
    """
    shown = {row.claim.label for row in rows}
    if style == "article":
        texts = (_head(row) + _paragraphs(row, _LATEX, shown) for row in rows)
        return "\n".join(texts)
    numbers: dict[str, int] = {}
    look = _numbered(numbers, _slide_equation if style == "beamer" else _markdown_equation)
    if style == "beamer":
        look = look._replace(words=prose, share=_SLIDE, strong=_LATEX.strong)
        texts = (
            f"\\begin{{frame}}[shrink]{{{prose(title(row.claim.label))}}}\n\\small\n"
            f"{_paragraphs(row, look, shown)}\\end{{frame}}\n"
            for row in rows
        )
        return "\n".join(texts)
    parts = []
    for row in rows:
        head = f"### {sentence(title(row.claim.label))}\n\n"
        parts.append(head + _paragraphs(row, look, shown, "\n"))
    if style == "markdown":
        return "\n".join(parts)
    cells = [notebook.code("import tresym")]
    for row, text in zip(rows, parts, strict=True):
        cells += [notebook.text(text), notebook.code(notebook.verifying(row.claim.label))]
    return notebook.book(cells)


def _head(row: Row) -> str:
    label = row.claim.label
    return f"% {title(label)}: {row.finding.verdict.value} (tresym verify {shown_name(label)})\n"


def _paragraphs(row: Row, style: Style, shown: set[str], gap: str = "") -> str:
    """The derivation of a claim; the claims that it displays are added to those ``shown``."""
    claim = row.claim
    if row.finding.verdict is Verdict.REFUTED:
        return "".join(f"{paragraph}\n{gap}" for paragraph in _refuted(row, style, shown))
    if row.finding.verdict is Verdict.UNDECIDED:
        marked = [*_marked("Not proved", claim, style)]
        marked.append(style.words(f"Reason: {readable(row.finding.why[:LONGEST])}."))
        return "".join(f"{paragraph}\n{gap}" for paragraph in marked)
    found = [tuple(_folded(display)) for display in displays(claim)]
    cited = [c for c in _cited(claim) if c.label not in shown and said(c).formula]
    shown.update(c.label for c in cited)
    spoken = said(claim)
    uses = "The derivation uses" if cited else ""
    sentences = (_opening(claim, style), style.words(spoken.says or ""), uses)
    paragraphs = [" ".join(filter(None, sentences))] if any(sentences) else []
    for premise in cited:
        body = alone(said(premise).formula or "", style.share)
        paragraphs.append(style.equation(body, premise.label))
    if cited:
        paragraphs.append("Hence" if len(found) == 1 else "Then")
    if spoken.formula and not any(line.reasons for display in found for line in display):
        paragraphs.append(style.equation(alone(spoken.formula, style.share), claim.label))
        found = []
    for n, display in enumerate(found, 1):
        body = derived([_reasoned(line, style, shown) for line in display], style.share)
        paragraphs.append(style.equation(body, claim.label + (f"-{n}" if n > 1 else "")))
    return "".join(f"{paragraph}\n{gap}" for paragraph in paragraphs)


def _refuted(row: Row, style: Style, shown: set[str]) -> Iterator[str]:
    """A refuted claim, marked as such, with the evidence and what is true instead."""
    yield from _marked("Refuted", row.claim, style)
    yield style.words(f"Evidence: {readable(row.finding.why[:LONGEST])}.")
    for claim in row.claim.amended_by:
        if claim.label in shown and said(claim).formula:
            yield f"{style.strong('True instead')}: {style.refer(claim.label)}."
        else:
            shown.add(claim.label)
            yield from _marked("True instead", claim, style)


def _marked(head: str, claim: Claim, style: Style) -> Iterator[str]:
    """The statement of a claim after its label and a word in bold type."""
    found = said(claim)
    name = f"{style.strong(head)} ({style.words(f'`{shown_name(claim.label)}`')}):"
    yield " ".join(filter(None, (name, _opening(claim, style), style.words(found.says or ""))))
    if found.formula:
        yield style.equation(alone(found.formula, style.share), claim.label)


def _opening(claim: Claim, style: Style) -> str:
    """The hypotheses as a sentence."""
    found = said(claim)
    if found.given and not found.parts and not found.where:
        *most, last = map(in_dollars, found.given)
        return f"Let {', '.join(most)}{' and ' if most else ''}{last}."
    return conditions(found, in_dollars, style.words)


def _cited(claim: Claim) -> tuple[Claim, ...]:
    """The claims that the steps of a derivation name, each once."""
    labels = [
        label
        for display in displays(claim)
        for line in display
        for why in line.reasons
        for label in why.labels
    ]
    used = {each.label: each for each in claim.rests_on}
    return tuple(used[label] for label in dict.fromkeys(labels) if label in used)


def _folded(display: Display) -> Iterator[Line]:
    """The lines without those after which the same trivial step goes on."""
    for line, after in zip(display, (*display[1:], None), strict=True):
        names = {why.words for why in line.reasons}
        goes_on = after is not None and names == {why.words for why in after.reasons}
        if not (goes_on and len(names) == 1 and names <= _TRIVIAL and not line.left):
            yield line


def _reasoned(line: Line, style: Style, known: Collection[str]) -> Line:
    """The line with its reasons in words and references."""
    reasons = []
    for why in line.reasons:
        if why.labels:
            named = [
                style.refer(label) if label in known else style.words(_lower(title(label)))
                for label in why.labels
            ]
            reasons.append(Because(f"{why.words} {' and '.join(named)}"))
        elif words := _WORDS.get(why.words, why.words):
            reasons.append(why._replace(words=words))
    return line._replace(reasons=tuple(reasons))


def _lower(text: str) -> str:
    return text[:1].lower() + text[1:]


_LATEX = Style(
    words=prose,
    equation=lambda body, label: (
        f"\\begin{{equation}}\\label{{tresym:{label}}}\n{body}\n\\end{{equation}}"
    ),
    refer=lambda label: rf"\eqref{{tresym:{label}}}",
    share=NARROW,
)


def _numbered(numbers: dict[str, int], equation: Callable[[str, int], str]) -> Style:
    """A style in which equations are numbered here, for formats that cannot refer to them."""

    def number(label: str) -> int:
        return numbers.setdefault(label, len(numbers) + 1)

    return Style(
        words=sentence,
        equation=lambda body, label: equation(body, number(label)),
        refer=lambda label: f"({number(label)})",
        share=NARROW,
        strong="**{}**".format,
    )


def _slide_equation(body: str, number: int) -> str:
    return f"\\[\n{body}\\tag{{{number}}}\n\\]"


def _markdown_equation(body: str, number: int) -> str:
    return f"$$\n{for_markdown(body)}\\tag{{{number}}}\n$$"


def for_markdown(body: str) -> str:
    r"""Return a display in the commands that MathJax and KaTeX have, without $ inside \text."""

    def plain(found: re.Match[str]) -> str:
        parts = found[1].split("$")
        return "".join(
            part if n % 2 else rf"\text{{{part}}}" for n, part in enumerate(parts) if part
        )

    shown = re.sub(r"\\(?:footnotesize|small) ", "", _IN_TEXT.sub(plain, body))
    return re.sub(r"\\operatorname\{(\w+)\}(?!\\left)", r"\\mathrm{\1}\\,", shown).replace(
        r"\operatorname", r"\mathrm"
    )
