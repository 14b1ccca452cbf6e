"""The Sphinx extension: claim pages, formulas, and examples that run."""

from __future__ import annotations

import html
import json
import re
import shutil
from functools import cache
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.addnodes import pending_xref
from sphinx.application import Sphinx
from sphinx.errors import ExtensionError
from sphinx.util.docutils import SphinxDirective
from sphinx.writers.html5 import HTML5Translator

from tresym.report.charts import CHARTS
from tresym.report.typesetting.formulas import Piece, pieces
from tresym.site import claims, commands, docstrings, mathematics
from tresym.site.markdown import badge, inline, link, statement, titled

BUILT = "_built"
"""Folder of the source tree that the build writes style sheets to; like claims/, not kept."""


@cache
def _ledger(path: Path) -> dict[str, Any]:
    found: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    return found


def ledger_of(source: Path) -> dict[str, Any]:
    """The saved ledger of the source tree.

    Raises:
        ExtensionError: `tresym docs` was not run.
    """
    path = source / "generated" / "ledger.json"
    if not path.is_file():
        raise ExtensionError(f"{path.name} is missing: run `tresym docs` first")
    return _ledger(path)


def costs(source: Path) -> dict[str, float]:
    """Seconds that judging took, by label, where a measurement of the ledger is saved."""
    path = source / "measurements" / "ledger.json"
    if not path.is_file():
        return {}
    found: dict[str, float] = json.loads(path.read_text(encoding="utf-8")).get("claims", {})
    return found


def write_pages(app: Sphinx) -> None:
    """Write what is made rather than written: claim pages, command reference, the font."""
    source = Path(app.srcdir)
    written = {
        source / "claims" / name: text
        for name, text in claims.pages(ledger_of(source), costs(source))
    }
    written[source / "reference" / "commands.md"] = commands.reference()
    style = source / BUILT / "mathematics.css"
    if not style.is_file():
        written[style] = mathematics.stylesheet(mathematics.font_file())
    for path, text in written.items():
        path.parent.mkdir(exist_ok=True)
        if not path.is_file() or path.read_text(encoding="utf-8") != text:
            path.write_text(text, encoding="utf-8")
    for path in (source / "claims").glob("*.md"):
        if path not in written:
            path.unlink()


_MADE = ("generated/corrections", "claims/", "pages/coq", "pages/symbols")


def link_labels(app: Sphinx, doctree: nodes.document) -> None:
    """On the pages that are made, every label leads to the page of its claim."""
    name = app.env.docname
    if not name.startswith(_MADE):
        return
    known = ledger_of(Path(app.srcdir))["claims"].keys() - {name.removeprefix("claims/")}
    for text in list(doctree.findall(nodes.literal)):
        label = text.astext()
        if label in known and not isinstance(text.parent, nodes.reference | pending_xref):
            uri = app.builder.get_relative_uri(name, f"claims/{label}")
            text.replace_self(nodes.reference("", "", text.deepcopy(), internal=True, refuri=uri))


_AS_WRITTEN = (
    nodes.literal,
    nodes.math,
    nodes.math_block,
    nodes.raw,
    nodes.title,
    nodes.FixedTextElement,
)


_TOUCHES_BEFORE = re.compile(r"[(“]+$")
_TOUCHES_AFTER = re.compile(r"[,.;:)”’!?]+")


def set_formulas(app: Sphinx, doctree: nodes.document) -> None:
    """Set the formulas of every sentence, but for titles, code and what machines have written."""
    if app.env.docname.startswith(("reference/", "pages/api", "pages/coq")):
        return
    for parent in list(doctree.findall(nodes.TextElement)):
        join_lines(parent)
    for text in list(doctree.findall(nodes.Text)):
        if text.parent is None or isinstance(text.parent, _AS_WRITTEN):
            continue
        found = list(pieces(str(text)))
        if any(piece.latex for piece in found):
            text.parent.replace(text, [_node(piece) for piece in found])
    for formula in list(doctree.findall(nodes.math)):
        glue(formula)


def glue(formula: nodes.math) -> None:
    """Let no line end between a formula and the comma or the bracket that touches it."""
    parent, at = formula.parent, formula.parent.index(formula)
    before, after = parent.children[:at][-1:], parent.children[at + 1 : at + 2]
    opens = _TOUCHES_BEFORE.search(before[0]) if before and _is_text(before[0]) else None
    shuts = _TOUCHES_AFTER.match(after[0]) if after and _is_text(after[0]) else None
    if not (opens or shuts):
        return
    glued = nodes.inline("", "", classes=["glued"])
    parent.replace(formula, glued)
    if opens:
        parent.replace(before[0], nodes.Text(before[0][: opens.start()]))
        glued += nodes.Text(opens[0])
    glued += formula
    if shuts:
        parent.replace(after[0], nodes.Text(after[0][shuts.end() :]))
        glued += nodes.Text(shuts[0])


def _is_text(node: nodes.Node) -> bool:
    return isinstance(node, nodes.Text)


def join_lines(parent: nodes.TextElement) -> None:
    """Make one text of the lines of a sentence, which Markdown keeps apart."""
    joined: list[nodes.Node] = []
    for child in parent.children:
        if joined and isinstance(child, nodes.Text) and isinstance(joined[-1], nodes.Text):
            joined[-1] = nodes.Text(f"{joined[-1]}{child}")
        else:
            joined.append(child)
    parent.children = []
    parent.extend(joined)


def _node(piece: Piece) -> nodes.Node:
    return nodes.math("", piece.latex) if piece.latex else nodes.Text(piece.text)


def copy_explorer(app: Sphinx, error: Exception | None) -> None:
    """The explorer is a page of its own, beside the others."""
    source = Path(app.srcdir) / "explorer"
    if error is None and source.is_dir():
        shutil.copytree(source, Path(app.outdir) / "explorer", dirs_exist_ok=True)


class ClaimDirective(SphinxDirective):
    """``{claim} LABEL``: the statement, its verdict and a link to its page."""

    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        """The statement in a frame."""
        (label,) = self.arguments
        claim = _named(self, label)
        box = nodes.container(classes=["claim"])
        text = f"{titled(label, claim)}\n\n{statement(claim)}"
        box += self.parse_text_to_nodes(text)
        return [box]


class FindingsDirective(SphinxDirective):
    """``{findings}``, each line a claim of the paper, a colon, and what is true instead."""

    has_content = True

    def run(self) -> list[nodes.Node]:
        """A table of three columns; on a narrow screen a list."""
        rows = ["| the paper | verdict | what is true |", "|---|---|---|"]
        for line in self.content:
            label, truths = line.split(":")
            claim = _named(self, label)
            said = (f"{inline(_named(self, name))} {link(name)}" for name in truths.split())
            cells = (f"{inline(claim)} {link(label)}", badge(claim["verdict"]), "<br>".join(said))
            rows.append(f"| {' | '.join(cells)} |")
        box = nodes.container(classes=["findings"])
        box += self.parse_text_to_nodes("\n".join(rows))
        return [box]


def _named(directive: SphinxDirective, label: str) -> dict[str, Any]:
    found = ledger_of(Path(directive.env.srcdir))["claims"]
    if label not in found:
        raise directive.error(f"no claim is labelled {label}")
    claim: dict[str, Any] = found[label]
    return claim


class ChartsDirective(SphinxDirective):
    """``{charts}``: every chart of saved measurements that is there, under its title."""

    def run(self) -> list[nodes.Node]:
        """A figure for each; what a chart shows is told in it, and stands in its stead."""
        folder = Path(self.env.srcdir) / "generated" / "charts"
        found: list[nodes.Node] = []
        for name, chart in CHARTS.items():
            path = folder / f"{name}.svg"
            if path.is_file():
                told = _told(path.read_text(encoding="utf-8")) or chart.title
                picture = nodes.image(uri=f"/generated/charts/{path.name}", alt=told, width="100%")
                found += [nodes.rubric(chart.title, chart.title), picture]
        return found


def _told(svg: str) -> str:
    """What a picture says of itself for those who do not see it."""
    found = re.search(r"<desc>(.*?)</desc>", svg, re.DOTALL)
    return " ".join(html.unescape(found[1]).split()) if found else ""


class RunDirective(SphinxDirective):
    """``{run} tresym …``: the command and what it prints, run while the page is built."""

    required_arguments = 1
    final_argument_whitespace = True

    def run(self) -> list[nodes.Node]:
        """A block of console text."""
        try:
            text = commands.transcript(self.arguments[0])
        except ValueError as error:
            raise self.error(str(error)) from None
        return [nodes.literal_block(text, text, language="console")]


class DrawDirective(SphinxDirective):
    """``{draw} tresym figure …``: the picture that the command draws while the page is built."""

    required_arguments = 1
    final_argument_whitespace = True

    def run(self) -> list[nodes.Node]:
        """The command, and its SVG within the page."""
        command = self.arguments[0]
        try:
            text = commands.transcript(command)
        except ValueError as error:
            raise self.error(str(error)) from None
        shown = f'<div class="drawn">{text[text.index("<svg") :]}</div>'
        asked = f"$ {command}"
        block = nodes.literal_block(asked, asked, language="console")
        return [block, nodes.raw("", shown, format="html")]


class NotebookDirective(SphinxDirective):
    """``{notebook} PATH``: the cells of a notebook with the outputs that it holds."""

    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        """Text as it is, code as code, and beneath it what it shows, as HTML where it can."""
        path = Path(self.env.srcdir) / self.arguments[0]
        self.env.note_dependency(str(path))
        found: list[nodes.Node] = []
        for cell in json.loads(path.read_text(encoding="utf-8"))["cells"]:
            source = "".join(cell["source"])
            if cell["cell_type"] == "markdown":
                found += self.parse_text_to_nodes(source)
                continue
            found.append(nodes.literal_block(source, source, language="python"))
            for data in (output["data"] for output in cell["outputs"]):
                text = data.get("text/html") or f"<pre>{html.escape(data['text/plain'])}</pre>"
                found.append(nodes.raw("", f'<div class="shown">{text}</div>', format="html"))
        return found


def visit_inline(translator: HTML5Translator, node: nodes.math) -> None:
    """A formula in a line."""
    translator.body.append(mathematics.mathml(node.astext(), block=False))
    raise nodes.SkipNode


def visit_block(translator: HTML5Translator, node: nodes.math_block) -> None:
    """A formula on its own; the theme sets it in a frame that scrolls where it is too wide."""
    shown = mathematics.mathml(node.astext(), block=True)
    translator.body.append(f'<div class="math">{shown}</div>\n')
    raise nodes.SkipNode


def setup(app: Sphinx) -> dict[str, Any]:
    """What Sphinx asks of an extension."""
    (Path(app.srcdir) / BUILT).mkdir(exist_ok=True)  # looked for before anything is built
    app.connect("builder-inited", write_pages)
    app.connect("autodoc-process-docstring", docstrings.process)
    app.connect("autodoc-process-signature", docstrings.signature)
    app.connect("autodoc-skip-member", docstrings.skip)
    app.add_html_math_renderer("mathml", (visit_inline, None), (visit_block, None))
    app.add_directive("claim", ClaimDirective)
    app.add_directive("findings", FindingsDirective)
    app.add_directive("charts", ChartsDirective)
    app.connect("build-finished", copy_explorer)
    app.connect("doctree-read", link_labels)
    app.connect("doctree-read", set_formulas)
    app.add_directive("run", RunDirective)
    app.add_directive("draw", DrawDirective)
    app.add_directive("notebook", NotebookDirective)
    app.add_css_file("mathematics.css")
    return {"parallel_read_safe": True, "parallel_write_safe": True}
