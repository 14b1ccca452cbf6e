r"""Write the documents of a file of claims: an article in LaTeX, fragments, Markdown, HTML, a
notebook.

Prose is carried over, every statement is printed as it is written in the file, with its verdict and
the reason, and a derivation step by step. A claim that is UNDECIDED is marked as not proved, and a
refuted one stands with its counterexample and, if one was found, with a true statement close to it.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterator, Mapping
from functools import partial
from html import escape
from typing import NamedTuple
from xml.sax.saxutils import quoteattr

from tresym.ledger.finding import Premise
from tresym.papers.definitions import PREFIX, Definition
from tresym.papers.reading import (
    Declaration,
    Drawn,
    Header,
    Let,
    OwnPaper,
    PaperClaim,
    Prose,
    Section,
)
from tresym.papers.verification import PaperReport, Row
from tresym.reals.language.as_typed import as_typed
from tresym.reals.language.calls import INFINITY, INTEGERS
from tresym.reals.language.compound import formula_in_latex, mapped
from tresym.reals.language.expression import (
    LEAVES,
    ORDERS,
    ZERO,
    Expr,
    bind,
    instantiate,
    rebuild,
    symbol,
    symbols,
    unknown,
)
from tresym.reals.language.formula import Compared
from tresym.reals.language.paths import read_path
from tresym.reals.language.readings import in_latex
from tresym.reals.language.typesetting import expression_in_latex as any_expression
from tresym.reals.language.typesetting import to_latex as any_formula
from tresym.reals.verdict import Verdict
from tresym.report.pages import notebook
from tresym.report.typesetting import html
from tresym.report.typesetting.formulas_in_words import parts, region_latex
from tresym.report.typesetting.plain_text import plain

LINE = 72
"""Signs of a formula and its conditions that fit in one line of an article."""
STYLES = ("article", "markdown", "html", "jupyter")
"""What this module writes; slides and a site have modules of their own."""
_TEX = {
    "\\": r"\textbackslash{}", "{": r"\{", "}": r"\}", "&": r"\&", "%": r"\%", "#": r"\#",
    "_": r"\_", "^": r"\textasciicircum{}", "~": r"\textasciitilde{}", "<": r"\textless{}",
    ">": r"\textgreater{}", "|": r"\textbar{}",
}  # fmt: skip
_POINTS = re.compile(
    "; (?:both sides are defined|the differentiated functions|the equations are satisfied at)"
)
"""Where a reason begins to name points, which are left out."""
_PIECES = re.compile(r"\$[^$\n]+\$|`[^`\n]+`")
_KINDS = {
    "real": ("a real number", "real numbers"),
    "integer": ("an integer", "integers"),
    "natural": ("a positive integer", "positive integers"),
    "positive": ("a positive number", "positive numbers"),
}
_PREAMBLE = r"""\documentclass[a4paper,11pt]{article}
\usepackage{iftex}
\ifPDFTeX
  \usepackage[T1]{fontenc}
  \usepackage[utf8]{inputenc}
  \usepackage{lmodern}
\else
  \usepackage{fontspec}
\fi
\usepackage{amsmath,amssymb,array,graphicx,booktabs,rotating,geometry,microtype}
\usepackage[hidelinks]{hyperref}
\geometry{margin=28mm}
\emergencystretch=2em
\allowdisplaybreaks
"""


to_latex = partial(any_formula, upright=True)
expression_in_latex = partial(any_expression, upright=True)


class Pictures(NamedTuple):
    """The tables and charts of a document, written out, by their place in the file.

    Attributes:
        tables: the table of a line of the file, in the language of the document.
        charts: the path of the picture of a line of the file, as the document names it.
    """

    tables: Mapping[int, str] = {}
    charts: Mapping[int, str] = {}


class Style(NamedTuple):
    """How the parts of a document are written in one language."""

    words: Callable[[str], str]
    section: Callable[[str], str]
    formula: Callable[[str], str]
    """A formula in a line of text."""
    display: Callable[[str, str], str]
    """A displayed formula, and its label."""
    strong: Callable[[str], str]
    code: Callable[[str], str]
    refer: Callable[[str], str]
    picture: Callable[[str], str]


def tex_words(text: str) -> str:
    r"""Return words in LaTeX; formulas between dollars stay, and code between back quotes.

    Example:
        >>> tex_words("50 % of $x_1$")
        '50 \\% of $x_1$'
    """
    found, last = "", 0
    for piece in _PIECES.finditer(text):
        found += _escaped(text[last : piece.start()])
        inside = piece[0]
        found += inside if inside[0] == "$" else rf"\texttt{{{_escaped(inside[1:-1])}}}"
        last = piece.end()
    return found + _escaped(text[last:])


def _escaped(text: str) -> str:
    return "".join(_TEX.get(character, character) for character in text)


def _md_words(text: str) -> str:
    return text


LATEX = Style(
    tex_words,
    lambda title: f"\\section*{{{tex_words(title)}}}\n",
    lambda formula: f"${formula}$",
    lambda formula, label: (
        f"\\begin{{equation}}\n\\label{{tresym:{label}}}\n{formula}\n\\end{{equation}}\n"
        if label
        else f"\\[\n{formula}\n\\]\n"
    ),
    lambda text: rf"\textbf{{{text}}}",
    lambda text: rf"\texttt{{{_escaped(text)}}}",
    lambda label: rf"\eqref{{tresym:{label}}}",
    lambda path: (
        f"\\begin{{center}}\\includegraphics[width=0.8\\linewidth]{{{path}}}\\end{{center}}\n"
    ),
)
MARKDOWN = Style(
    _md_words,
    lambda title: f"## {title}\n",
    lambda formula: f"${formula}$",
    lambda formula, label: f"$$\n{formula}\n$$\n",
    lambda text: f"**{text}**",
    lambda text: f"`{text}`",
    lambda label: f"`{label}`",
    lambda path: f"![]({path})\n",
)
HTML = Style(
    html.words,
    lambda title: f"<h2>{html.words(title)}</h2>\n",
    html.formula,
    lambda formula, label: (
        f'<div class="formula"{f" id={quoteattr(label)}" if label else ""}>'
        f"{html.formula(formula, True)}</div>\n"
    ),
    lambda text: f"<strong>{text}</strong>",
    lambda text: f"<code>{escape(text)}</code>",
    lambda label: f'<a href="#{escape(label)}"><code>{escape(label)}</code></a>',
    lambda path: f'<p><img src="{escape(path)}" alt=""></p>\n',
)


def document(report: PaperReport, style: str = "article", pictures: Pictures | None = None) -> str:
    """Write the whole paper.

    Args:
        report: the verified file.
        style: ``article`` (LaTeX), ``markdown``, ``html`` or ``jupyter``.
        pictures: its tables and charts, if they were drawn.
    """
    if style == "jupyter":
        return _notebook(report)
    if style == "html":
        return html.page(report.paper.title, html_body(report, HTML, pictures or Pictures()))
    look = LATEX if style == "article" else MARKDOWN
    header = report.paper.header
    body = "\n".join(_blocks(report.paper, report, look, pictures or Pictures()))
    if style == "markdown":
        head = _markdown_head(report.paper)
        return f"{head}\n{body}\n{summary(report, look)}{_markdown_references(header)}"
    for key in header.references:
        body = body.replace(f"[{_escaped(key)}]", rf"\cite{{{key}}}")
    authors = r" \and ".join(map(tex_words, header.authors))
    abstract = tex_words(header.abstract)
    head = f"\\title{{{tex_words(report.paper.title)}}}\n"
    head += f"\\author{{{authors}}}\n" if authors else ""
    head += "\\date{}\n\\begin{document}\n\\maketitle\n\n"
    head += f"\\begin{{abstract}}\n{abstract}\n\\end{{abstract}}\n\n" if abstract else ""
    works = "".join(
        f"\\bibitem{{{key}}} {tex_words(words)}\n" for key, words in header.references.items()
    )
    end = f"\\begin{{thebibliography}}{{99}}\n{works}\\end{{thebibliography}}\n" if works else ""
    return f"{_PREAMBLE}{head}{body}\n{summary(report, look)}{end}\\end{{document}}\n"


def html_body(report: PaperReport, look: Style, pictures: Pictures) -> str:
    """Return the whole paper in HTML, without the frame of the page.

    Args:
        report: the verified file.
        look: :data:`HTML`, or what writes some parts otherwise.
        pictures: its tables and charts.
    """
    paper, header = report.paper, report.paper.header
    authors = html.words(", ".join(header.authors))
    parts = [f"<h1>{html.words(paper.title)}</h1>"]
    parts += [f'<p class="authors">{authors}</p>'] if authors else []
    if header.abstract:
        parts.append(f'<p class="abstract">{html.words(header.abstract)}</p>')
    for item in paper.items:
        text = "".join(item_blocks(item, report, look, pictures)).rstrip()
        if isinstance(item, PaperClaim | Definition):
            verdicts = [row.verdict.value for row in report.rows if row.item is item]
            parts.append(f'<div class="claim {verdicts[0] if verdicts else ""}">\n{text}\n</div>')
        elif isinstance(item, Prose | Declaration | Let):
            parts.append(f"<p>{text}</p>")
        elif text:
            parts.append(f'<div class="wide">{text}</div>' if isinstance(item, Drawn) else text)
    if works := header.references:
        listed = "".join(f"<li>[{escape(k)}] {html.words(v)}</li>\n" for k, v in works.items())
        parts.append(f"<h2>References</h2>\n<ul>\n{listed}</ul>")
    parts.append(f"<footer><p>{summary(report, look).strip()}</p></footer>")
    return "\n".join(parts)


def _markdown_head(paper: OwnPaper) -> str:
    """The title, the authors and the abstract."""
    header = paper.header
    authors = f"\n*{', '.join(header.authors)}*\n" if header.authors else ""
    abstract = f"\n**Abstract.** {header.abstract}\n" if header.abstract else ""
    return f"# {paper.title}\n{authors}{abstract}"


def _markdown_references(header: Header) -> str:
    works = "".join(f"- [{key}] {words}\n" for key, words in header.references.items())
    return f"\n## References\n\n{works}" if works else ""


def fragments(report: PaperReport, rows: Collection[Row], style: str = "article") -> str:
    """Write single claims to paste into a text: each with its conditions, verdict and reason."""
    if style == "jupyter":
        cells = [notebook.code(f'import tresym\n\npaper = tresym.open("{report.paper.name}")')]
        for row in rows:
            cells.append(notebook.text(block(row, report, MARKDOWN)))
            cells.append(notebook.code(f'paper.verify("{row.label}")["{row.label}"]'))
        return notebook.book(cells)
    look = {"article": LATEX, "html": HTML}.get(style, MARKDOWN)
    return "\n".join(block(row, report, look) for row in rows)


def refused(rows: Collection[Row]) -> list[str]:
    """Return for each claim that is refuted, and not by intention, a line that says why."""
    return [
        f"{row.label} is REFUTED: {row.why}"
        for row in rows
        if row.verdict is Verdict.REFUTED and not row.as_expected
    ]


def _notebook(report: PaperReport) -> str:
    """A notebook with the prose, and a cell that verifies each claim."""
    cells = [
        notebook.text(_markdown_head(report.paper).rstrip()),
        notebook.code(f'import tresym\n\npaper = tresym.open("{report.paper.name}")'),
    ]
    for item in report.paper.items:
        blocks = list(item_blocks(item, report, MARKDOWN, Pictures()))
        cells += [notebook.text(block) for block in blocks if block.strip()]
        if isinstance(item, PaperClaim) and item.label in report.by_label:
            cells.append(notebook.code(f'paper.verify("{item.label}")["{item.label}"]'))
        if isinstance(item, Drawn):
            cells.append(notebook.code(f'paper.{item.kind}("{item.label}")'))
    if works := _markdown_references(report.paper.header).strip():
        cells.append(notebook.text(works))
    return notebook.book(cells)


def _blocks(paper: OwnPaper, report: PaperReport, look: Style, pictures: Pictures) -> Iterator[str]:
    for item in paper.items:
        yield from item_blocks(item, report, look, pictures)


def item_blocks(
    item: object, report: PaperReport, look: Style, pictures: Pictures
) -> Iterator[str]:
    """Yield what a document contains of one item of the file.

    Args:
        item: the item.
        report: the verified file.
        look: the language of the document.
        pictures: the tables and charts.
    """
    if isinstance(item, Section):
        yield look.section(item.title)
    elif isinstance(item, Prose):
        yield f"{look.words(item.text)}\n"
    elif isinstance(item, Declaration):
        yield f"{_declared(item, look)}\n"
    elif isinstance(item, Let):
        yield f"{_let(item, look)}\n"
    elif isinstance(item, PaperClaim | Definition):
        key = item.label if isinstance(item, PaperClaim) else item.name
        rows = [row for row in report.rows if row.item is item]
        if rows:
            yield block(rows[0], report, look)
        else:
            yield f"{look.code(key)} was not verified.\n"
    elif isinstance(item, Drawn) and item.kind == "table" and item.line in pictures.tables:
        yield pictures.tables[item.line]
    elif isinstance(item, Drawn) and item.line in pictures.charts:
        yield look.picture(pictures.charts[item.line])


def _let(item: Let, look: Style) -> str:
    """A line ``let``: what holds in the claims that use it."""
    parts = [rf"{_latex(made.head)} := {_latex(made.written)}" for made in item.definitions]
    parts += [conditions_latex(item.given)] if item.given else []
    shown = ", ".join(map(look.formula, parts))
    place = f" ({look.words(item.place)})" if item.place else ""
    return f"Where {look.code(item.label)}{place} is used: {shown}."


def _declared(item: Declaration, look: Style) -> str:
    conditions = look.formula(conditions_latex(item.given)) if item.given else ""
    if not item.names:
        return f"From here on {conditions}."
    names = look.formula(", ".join(expression_in_latex(symbol(name)) for name in item.names))
    kind = _KINDS[item.kind][len(item.names) > 1]
    return f"Let {names} be {kind}{' with ' + conditions if conditions else ''}."


def block(row: Row, report: PaperReport, look: Style) -> str:
    """Return a definition or a claim with its verdict, in the language of a document."""
    item = row.item
    if isinstance(item, Definition):
        text = _display(rf"{_latex(item.head)} := {_latex(item.written)}", "", look)
        if not row.verdict.holds:
            text += f"{look.strong('Not shown to be defined')}: {_reason(row.why, look)}.\n"
        return text
    shown = statement_latex(item, aligned=item.is_derivation)
    text = _display(shown, item.label, look)
    return f"{text}{_verdict(row, item, look)}\n"


def _display(formula: str, label: str, look: Style) -> str:
    return look.display(formula, label)


def _verdict(row: Row, item: PaperClaim, look: Style) -> str:
    """The sentence below a claim: its verdict, the reason, the constant and the region."""
    name = look.code(item.label) + (f" ({look.words(item.place)})" if item.place else "")
    quoted = f" (quoted from {look.words(item.source)})" if item.source else ""
    head = f"{name}{quoted}: "
    known = frozenset().union(*(symbols(e) for link in item.links for e in link[::2]))
    found = item.asymptotic
    has_terms = found is not None and found[1] != ZERO and found[2] is not None
    reason = _reason(row.why, look, known, has_terms)
    if row.verdict is Verdict.UNDECIDED:
        return f"{head}{look.strong('not proved')}: {reason}."
    if row.verdict is Premise.ASSUMED:
        return f"{head}{look.strong('assumed, not proved here')}: {reason}."
    answer = row.decisive
    if row.verdict is Verdict.REFUTED:
        told = [one.edit for one in row.instead[:1] if one.edit.startswith("the coefficient of")]
        reason = _reason(told[0], look, known) if told else reason  # the failure at a glance
        text = f"{head}{look.strong('false')}: {reason}."
        text += "".join(
            f" True is {look.formula(in_latex(_with_given(one.claim, one.given)))}."
            for one in row.instead[:1]
            if in_latex(_with_given(one.claim, one.given))
        )
        return text
    words = "proved" if row.verdict is Verdict.PROVED else "proved in ball arithmetic"
    if answer is not None and answer.lemma:
        reason = f"by {look.words(answer.lemma)}"
    text = f"{head}{words}: {reason}."
    if item.has_parameters and answer is not None:
        uniform = "all values of the parameters at once" if answer.uniform else ""
        text += f" It holds for {uniform or 'each fixed value of the parameters'}."
    if answer is not None and answer.constant is not None:
        text += f" The constant is {_numbers(answer.constant_text(), look)}."
    if answer is not None and answer.region:
        where = region_latex(answer.region)
        text += f" Region: {look.formula(where) if where else look.code(answer.region)}."
    if row.axioms:
        text += f" It rests on {', '.join(look.refer(label) for label in row.axioms)}."
    return text


def _numbers(text: str, look: Style) -> str:
    """Words with numbers in the notation of print: 4.5e-11 with a power of ten."""
    parts_ = re.split(r"(\d[\d.]*)e([-+]?\d+)", text)
    found = look.words(parts_[0])
    for digits, power, rest in zip(parts_[1::3], parts_[2::3], parts_[3::3], strict=True):
        found += look.formula(rf"{digits} \cdot 10^{{{int(power)}}}") + look.words(rest)
    return found


def _with_given(claim: str, given: str) -> str:
    return f"{claim} given {given}" if given else claim


def _reason(why: str, look: Style, known: Collection[str] = (), is_error: bool = False) -> str:
    """The reason of a verdict up to the points that were tried, its formulas typeset.

    Of an order the factor C is left out, since the constant is given below; and what the reason
    calls the left side is the error, where terms stand beside the O(...).
    """
    first = _POINTS.split(why)[0]
    if is_error:
        first = first.replace("the left side behaves like", "the error behaves like")
    if first.startswith("|left| <= C |right|"):
        first = first.partition("; ")[2] or "the ratio of both sides is bounded"
    found = ""
    for part, is_formula in parts(first, known):
        if is_formula:
            found += look.formula(part)
        elif look.words is not tex_words and re.search(r"[*_^<>|]", part):
            found += re.sub(r"\S*[*_^<>|]\S*", lambda word: look.code(word[0]), part)
        else:
            found += look.words(part)
    return found


def statement_latex(claim: PaperClaim, aligned: bool = False) -> str:
    r"""Return a claim in LaTeX as it is written in the file: formula, values, conditions, path."""
    if not claim.links:
        said = claim.said and mapped(claim.said, _plain)
        text = formula_in_latex(said, len(claim.given), claim.path) if said else ""
    elif claim.rounded:
        left = claim.shown[0][0]
        text = rf"{_latex(left)} \approx {claim.rounded}"
    elif aligned:
        text = _aligned(_printed(claim))
    else:
        text = to_latex(_printed(claim))
    labels = (rf"\text{{{label}}}" for label in claim.joined)
    text = r" \quad\text{and}\quad ".join(part for part in (*labels, text) if part)
    extra = []
    if claim.at:
        extra.append(to_latex((symbol(name), "==", _plain(value)) for name, value in claim.at))
    if claim.given:
        extra.append(conditions_latex(claim.given))
    if claim.path is not None:
        extra.append(path_latex(claim.path))
    on = claim.on if claim.whole is None else claim.whole.on
    if on:
        extra.append(conditions_latex(on))
    if claim.uniformly:
        extra.append(r"\text{uniformly}")
    listed = r",\ ".join(extra)
    if not extra:
        return text
    if len(plain(text)) + len(plain(listed)) > LINE:  # formula and conditions in two lines
        return f"\\begin{{gathered}}\n{text} \\\\\n({listed})\n\\end{{gathered}}"
    return rf"{text} \qquad ({listed})"


def _aligned(links: Collection[Compared]) -> str:
    """A derivation with its relations below each other."""
    rows = []
    for number, link in enumerate(links):
        left, relation, right = link
        whole = to_latex([(left, relation, right)])
        start = expression_in_latex(left)
        rest = whole[len(start) :].lstrip() if whole.startswith(start) else whole
        rows.append(f"{start if not number else ''} &{rest}")
    joined = " \\\\\n".join(rows)
    return f"\\begin{{aligned}}\n{joined}\n\\end{{aligned}}"


def path_latex(path: str) -> str:
    r"""Return a limit process in LaTeX, ``x \to 0^+`` for ``x -> 0+``."""
    found = read_path(path)
    if found.point is None:
        end = INFINITY if found.sides[0] > 0 else -INFINITY
        return to_latex([(symbol(found.name), "->", end)])
    side = "" if len(found.sides) > 1 else "^+" if found.sides[0] > 0 else "^-"
    return to_latex([(symbol(found.name), "->", found.point)]) + side


def conditions_latex(given: Collection[Compared]) -> str:
    """Return conditions in LaTeX."""
    return to_latex(
        link if link[1] == "in" and link[2] == INTEGERS else _plain_link(link) for link in given
    )


def _latex(e: Expr) -> str:
    return expression_in_latex(_plain(e))


def _printed(claim: PaperClaim) -> list[Compared]:
    """The comparisons of a claim in the form in which the author typed them."""
    named = tuple((_plain(a, False), sign, _plain(b, False)) for a, sign, b in claim.shown)
    typed = as_typed(claim.text, named)
    return list(typed) if typed is not named else [_plain_link(link) for link in claim.shown]


def _plain_link(link: Compared) -> Compared:
    return _plain(link[0]), link[1], _plain(link[2])


def _plain(e: Expr, ordered: bool = True) -> Expr:
    """The expression with functions under the names that the file gives them.

    Args:
        e: the expression.
        ordered: whether expansions are put in the order of print.
    """
    if e.op in LEAVES or not e.hidden:
        return e
    if e.op == "unknown":
        name, orders = e.args[0].args
        return unknown(
            name.removeprefix(PREFIX), tuple(_plain(x, ordered) for x in e.args[1:]), orders
        )
    if e.names:
        inside = _plain(instantiate(e.args[0], tuple(map(symbol, e.names))), ordered)
        ends = (_plain(x, ordered) for x in e.args[1:])
        return Expr(e.op, (bind(inside, e.names), *ends), e.names)
    parts = tuple(_plain(x, ordered) for x in e.args)
    if ordered and e.op == "+" and any(part.op in ORDERS for part in parts):
        # as expansions are written: the constant first, and the order last
        ranks = {"number": 0} | dict.fromkeys(ORDERS, 2)
        return Expr("+", tuple(sorted(parts, key=lambda part: ranks.get(part.op, 1))))
    return rebuild(e, parts)


def summary(report: PaperReport, look: Style) -> str:
    """Return the last paragraph: how many claims have which verdict, and what was not read."""
    counts = ", ".join(f"{n} {ruling.value}" for ruling, n in report.counts.items() if n)
    text = f"Verified with tresym: {counts or 'no claims'}."
    if report.paper.problems:
        lines = ", ".join(str(problem.line) for problem in report.paper.problems)
        text += f" {look.strong('Not read')}: lines {lines} of the file."
    return f"{text}\n"
