"""A Sphinx extension: claims with their verdicts, error tables and error charts in your documents.

In ``conf.py``::

    extensions = ["tresym.sphinx"]

In reStructuredText::

    .. tresym-claim:: sin(x) == x + O(x**3)
       :as: x -> 0

    .. tresym-table:: root(y - e*sin(y) - 1, y, 0, 4)
       :approx: 1 + e*sin(1)
       :as: e -> 0+
       :order: e**2

    .. tresym-chart:: tan(x)
       :approx: x; x + x**3/3
       :as: x -> 0+

The same in MyST, as `` ```{tresym-claim} sin(x) == x + O(x**3) ``. Everything is computed when the
document is read, and stored with Sphinx's environment, so an unchanged page costs nothing. A claim
that does not hold ends the build with an error that names file and line; ``:expect: REFUTED`` says
that another verdict is meant. Bad input ends it too.
"""

from __future__ import annotations

import hashlib
import os
from typing import Any, ClassVar

from docutils import nodes
from docutils.parsers.rst import directives
from sphinx.application import Sphinx
from sphinx.errors import SphinxError
from sphinx.util.docutils import SphinxDirective

import tresym

KEY = "tresym_answers"
"""The attribute of the environment that stores what was computed."""
LIMIT = 30.0
"""Processor seconds for a claim."""
STYLE = (
    ".tresym-claim{border-left:3px solid;padding:.3em .8em;margin:1em 0}"
    ".tresym-holds{border-color:#009e73}.tresym-other{border-color:#d55e00}"
    "figure.tresym-chart svg{max-width:100%;height:auto}"
)


class VerdictError(SphinxError):
    """Ends the build: a verdict is not the expected one, or something cannot be read."""

    category = "tresym"


class _Directive(SphinxDirective):
    """A directive whose result is stored in the environment."""

    required_arguments = 1
    final_argument_whitespace = True
    has_content = False

    def refuse(self, why: object) -> VerdictError:
        """Return the error that ends the build, with file and line."""
        source, line = self.get_source_info()
        return VerdictError(f"{os.path.relpath(source)}:{line}: {why}")

    def stored(self, *asked: object) -> Any:
        """Return what was computed for these arguments, by this version of tresym, or compute it.

        Raises:
            VerdictError: the input is bad.
        """
        answers: dict[str, Any] = self.env.__dict__.setdefault(KEY, {})
        text = repr((type(self).__name__, tresym.__version__, asked))
        key = hashlib.sha256(text.encode()).hexdigest()
        if key not in answers:
            try:
                answers[key] = self.computed(*asked)
            except tresym.InputError as error:
                raise self.refuse(error) from None
        return answers[key]

    def computed(self, *asked: Any) -> Any:
        """Compute the result, which can be pickled."""
        raise NotImplementedError

    @property
    def points(self) -> list[str]:
        """The points of ``:at:``."""
        return [part.strip() for part in self.options.get("at", "").split(",") if part.strip()]


class ClaimDirective(_Directive):
    """Show a claim with its verdict."""

    option_spec: ClassVar[dict[str, Any]] = {
        "given": directives.unchanged,
        "as": directives.unchanged,
        "expect": directives.unchanged,
    }

    def computed(self, claim: str, given: str, path: str | None) -> tuple[str, str, str, str]:
        """Return verdict, sentence, LaTeX and text of a claim."""
        from tresym.reals.language.readings import in_latex

        answer = tresym.check(claim, given, path, limit=LIMIT)
        return answer.verdict.value, answer.in_text()[0], in_latex(answer.read_as), answer.read_as

    def run(self) -> list[nodes.Node]:
        """Return the claim as a formula, and its verdict."""
        asked = self.arguments[0], self.options.get("given", ""), self.options.get("as")
        verdict, sentence, formula, text = self.stored(*asked)
        expected = self.options.get("expect", "").strip().upper()
        holds = verdict in ("PROVED", "ENCLOSED")
        if (verdict != expected) if expected else not holds:
            wanted = expected or "PROVED or ENCLOSED"
            raise self.refuse(f"{text} is {verdict}, expected {wanted}: {sentence}")
        box = nodes.container(classes=["tresym-claim", f"tresym-{'holds' if holds else 'other'}"])
        if formula:
            box += nodes.math_block(formula, formula, nowrap=False, number=None, label=None)
        else:
            box += nodes.literal_block(text, text)
        box += nodes.paragraph("", "", nodes.strong(verdict, verdict), nodes.Text(f": {sentence}"))
        return [box]


_COMPARED = {
    "approx": directives.unchanged_required,
    "as": directives.unchanged_required,
    "at": directives.unchanged,
    "given": directives.unchanged,
    "order": directives.unchanged,
    "on": directives.unchanged,
}


class TableDirective(_Directive):
    """Show an error table, with the verdict of its order and the smallest constant."""

    option_spec: ClassVar[dict[str, Any]] = _COMPARED | {"digits": directives.positive_int}

    def computed(self, *asked: Any) -> tuple[Any, tuple[str, ...]]:
        """Return the table and the sentences below it."""
        exact, approx, path, at, given, digits, order, region = asked
        found = tresym.error_table(exact, approx, path, at, given, digits, order, region)
        return found.table, found.notes

    def run(self) -> list[nodes.Node]:
        """Return the table and what is said below it."""
        if "approx" not in self.options or "as" not in self.options:
            raise self.refuse("tresym-table needs :approx: and :as:")
        options = self.options
        table, notes = self.stored(
            self.arguments[0], options["approx"], options["as"], self.points,
            options.get("given", ""), options.get("digits", 20), options.get("order"),
            options.get("on", ""),
        )  # fmt: skip
        return [_table(table), *(nodes.paragraph(note, note) for note in notes)]


def _table(found: Any) -> nodes.table:
    """Return a table as nodes of docutils."""
    group = nodes.tgroup(cols=len(found.heads))
    for n, head in enumerate(found.heads):
        widest = max(len(cells[n]) for cells in (found.heads, *found.rows))
        group += nodes.colspec(colwidth=max(widest, len(head)))
    head, body = nodes.thead(), nodes.tbody()
    head += _row(found.heads, literal=False)
    for cells in found.rows:
        body += _row(cells, literal=True)
    group += head
    group += body
    table = nodes.table(classes=["tresym-table"])
    table += nodes.title(found.caption, found.caption)
    table += group
    return table


def _row(cells: tuple[str, ...], literal: bool) -> nodes.row:
    row = nodes.row()
    for cell in cells:
        entry = nodes.entry()
        text = nodes.literal(cell, cell) if literal and cell else nodes.Text(cell)
        entry += nodes.paragraph("", "", text)
        row += entry
    return row


class ChartDirective(_Directive):
    """Draw the errors of one or more approximations, separated by semicolons."""

    option_spec: ClassVar[dict[str, Any]] = _COMPARED

    def computed(self, *asked: Any) -> dict[str, bytes]:
        """Return the chart as SVG and as PDF."""
        from tresym.report.charts.own import error_chart

        exact, approximations, path, at, given, order, region = asked
        drawn = error_chart(exact, approximations, path, at, given, order, region)
        return {kind: drawn(kind) for kind in ("svg", "pdf")}

    def run(self) -> list[nodes.Node]:
        """Return the chart, for HTML and for LaTeX."""
        if "approx" not in self.options or "as" not in self.options:
            raise self.refuse("tresym-chart needs :approx: and :as:")
        options = self.options
        approximations = [part.strip() for part in options["approx"].split(";") if part.strip()]
        pictures = self.stored(
            self.arguments[0], approximations, options["as"], self.points,
            options.get("given", ""), options.get("order"), options.get("on", ""),
        )  # fmt: skip
        svg = pictures["svg"].decode()
        svg = svg[svg.index("<svg") :]
        found: list[nodes.Node] = [
            nodes.raw("", f'<figure class="tresym-chart">{svg}</figure>', format="html")
        ]
        name = f"tresym-{hashlib.sha256(pictures['pdf']).hexdigest()[:16]}.pdf"
        if self.env.app.builder.format == "latex":
            os.makedirs(self.env.app.outdir, exist_ok=True)
            with open(os.path.join(self.env.app.outdir, name), "wb") as file:
                file.write(pictures["pdf"])
        latex = rf"\begin{{center}}\includegraphics[width=0.8\linewidth]{{{name}}}\end{{center}}"
        found.append(nodes.raw("", latex, format="latex"))
        return found


def _style(app: Sphinx, page: str, template: str, context: dict[str, Any], tree: object) -> None:
    context["metatags"] = f"{context.get('metatags', '')}<style>{STYLE}</style>"


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the directives."""
    app.add_directive("tresym-claim", ClaimDirective)
    app.add_directive("tresym-table", TableDirective)
    app.add_directive("tresym-chart", ChartDirective)
    app.connect("html-page-context", _style)
    return {
        "version": tresym.__version__,
        "parallel_read_safe": True,
        "parallel_write_safe": True,
    }
