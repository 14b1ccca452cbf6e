"""The Sphinx extension: pages of claims, formulas, and examples that are run."""

from __future__ import annotations

import html
import json
import re
import shutil
from functools import cache, partial
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.addnodes import pending_xref
from sphinx.application import Sphinx
from sphinx.errors import ExtensionError
from sphinx.util.docutils import SphinxDirective
from sphinx.writers.html5 import HTML5Translator

from tresym.manuscript.deciding import Row, decided
from tresym.manuscript.links import read_links
from tresym.manuscript.source import read_manuscript
from tresym.manuscript.suspects import proofread
from tresym.reals.language.expression import symbols
from tresym.reals.language.readings import in_latex
from tresym.reals.numbers.exact import InputError
from tresym.report.charts import CHARTS, conclusion
from tresym.report.pages import opened
from tresym.report.pages.explanation import explain
from tresym.report.typesetting.formulas import Piece, pieces
from tresym.report.typesetting.formulas_in_words import parts
from tresym.site import atlas, claims, commands, docstrings, mathematics, search, sources
from tresym.site.markdown import badge, statement, titled

BUILT = "_built"
"""The folder for style sheets that the build writes; like claims/, it is not versioned."""


@cache
def _ledger(path: Path) -> dict[str, Any]:
    found: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    return found


def ledger_of(source: Path) -> dict[str, Any]:
    """Return the saved ledger of the source tree.

    Raises:
        ExtensionError: ``tresym docs`` was not run.
    """
    path = source / "_pages" / "ledger.json"
    if not path.is_file():
        raise ExtensionError(f"{path.name} is missing: run `tresym docs` first")
    return _ledger(path)


def costs(source: Path) -> dict[str, float]:
    """Return the saved seconds of each verdict by label; empty without a saved measurement."""
    path = source / "measurements" / "ledger.json"
    if not path.is_file():
        return {}
    found: dict[str, float] = json.loads(path.read_text(encoding="utf-8")).get("claims", {})
    return found


def write_pages(app: Sphinx) -> None:
    """Write what is generated: pages of claims, the command reference, the font."""
    source = Path(app.srcdir)
    written = {
        source / "claims" / name: text
        for name, text in claims.pages(ledger_of(source), costs(source))
    }
    written |= {source / "atlas" / name: text for name, text in atlas.pages()}
    written[source / "reference" / "commands.md"] = commands.reference()
    style = source / BUILT / "mathematics.css"
    if not style.is_file():
        written[style] = mathematics.stylesheet(mathematics.font_file())
    search.write_scorer(source / BUILT / "scorer.js", ledger_of(source)["claims"])
    for path, text in written.items():
        path.parent.mkdir(exist_ok=True)
        if not path.is_file() or path.read_text(encoding="utf-8") != text:
            path.write_text(text, encoding="utf-8")
    for path in (source / "claims").glob("*.md"):
        if path not in written:
            path.unlink()


_MADE = ("generated/corrections", "claims/", "pages/coq", "pages/symbols")


def link_labels(app: Sphinx, doctree: nodes.document) -> None:
    """On generated pages, show every claim by its readable name, as a link to its page."""
    name = app.env.docname
    if not name.startswith(_MADE):
        return
    claims, own = ledger_of(Path(app.srcdir))["claims"], name.removeprefix("claims/")
    shown = {label: claim["alias"] or label for label, claim in claims.items() if label != own}
    labels = {alias: label for label, alias in shown.items()}
    for text in list(doctree.findall(nodes.literal)):
        label = labels.get(text.astext(), text.astext())
        if label not in shown:
            continue
        if text.astext() != shown[label]:
            text.children = []
            text += nodes.Text(shown[label])
        if not isinstance(text.parent, nodes.reference | pending_xref):
            uri = app.builder.get_relative_uri(name, f"claims/{label}")
            text.replace_self(nodes.reference("", "", text.deepcopy(), internal=True, refuri=uri))


def link_pictures(app: Sphinx, doctree: nodes.document) -> None:
    """Link every drawn picture to its file, in a frame that scrolls where the page is narrow."""
    up = "../" * app.env.docname.count("/")
    for image in list(doctree.findall(nodes.image)):
        path = image["uri"]
        if "/generated/" not in f"/{path}" or isinstance(image.parent, nodes.reference):
            continue
        wide = "charts/" in path or image.get("width") == "100%"
        link = nodes.reference(
            "", "", internal=False, refuri=f"{up}_images/{Path(path).name}", classes=["picture"]
        )
        if wide:
            link["classes"].append("wide")
        image.replace_self(link)
        link += image


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
    """Typeset the formulas in sentences, except in titles, code and output of commands."""
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
    """Keep a formula on one line with the comma or bracket that touches it."""
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
    """Join the lines of a sentence, which Markdown keeps apart, to one text node."""
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
    """Copy the explorer, a page of its own, beside the other pages."""
    source = Path(app.srcdir) / "explorer"
    if error is None and source.is_dir():
        shutil.copytree(source, Path(app.outdir) / "explorer", dirs_exist_ok=True)


def write_data(app: Sphinx, error: Exception | None) -> None:
    """Write each claim as JSON beside its page, and the files of the proofs with numbered lines."""
    if error is not None:
        return
    for label, claim in ledger_of(Path(app.srcdir))["claims"].items():
        text = json.dumps(claims.data(label, claim), ensure_ascii=False, indent=1)
        (Path(app.outdir) / "claims" / f"{label}.json").write_text(text + "\n", encoding="utf-8")
    folder = Path(app.outdir) / "proofs"
    folder.mkdir(exist_ok=True)
    for name, page in sources.pages():
        (folder / name).write_text(page, encoding="utf-8")


def share_tree(
    kept: dict[object, str],
    app: Sphinx,
    page: str,
    _template: str,
    context: dict[str, Any],
    *_: Any,
) -> None:
    """Resolve the tree of pages once for all pages of a folder that do not stand in it.

    Hundreds of claims have the same tree beside them, of which no entry is the page itself.
    """
    folder, resolve = page.rpartition("/")[0], context.get("toctree")
    if not folder or resolve is None or any(page in p for p in app.env.toctree_includes.values()):
        return

    def tree(**options: Any) -> str:
        key = folder, *sorted(options.items())
        if key not in kept:
            kept[key] = resolve(**options)
        return kept[key]

    context["toctree"] = tree


class ClaimDirective(SphinxDirective):
    """The directive ``{claim} LABEL``: a statement, its verdict and a link to its page."""

    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        """Return the statement in a frame."""
        label, claim = _named(self, self.arguments[0])
        box = nodes.container(classes=["claim"])
        text = f"{titled(label, claim)}\n\n{statement(claim)}"
        box += self.parse_text_to_nodes(text)
        return [box]


def _named(directive: SphinxDirective, name: str) -> tuple[str, dict[str, Any]]:
    """The label and the data of the claim with a label or a readable name."""
    found = ledger_of(Path(directive.env.srcdir))["claims"]
    aliases = {claim["alias"]: label for label, claim in found.items()}
    label = aliases.get(name, name)
    if label not in found:
        raise directive.error(f"no claim is labelled {name}")
    return label, found[label]


class ChartsDirective(SphinxDirective):
    """The directive ``{charts}``: every chart of saved measurements, with what a reader learns."""

    def run(self) -> list[nodes.Node]:
        """Return a title, a sentence and a picture for each chart; the picture has its description.

        The picture links to its file.
        """
        folder = Path(self.env.srcdir) / "generated" / "charts"
        found: list[nodes.Node] = []
        for name, chart in CHARTS.items():
            path = folder / f"{name}.svg"
            if path.is_file():
                alt = _description(path.read_text(encoding="utf-8")) or chart.title
                picture = nodes.image(uri=f"/generated/charts/{path.name}", alt=alt, width="100%")
                sentence = nodes.paragraph("", conclusion(name))
                found += [nodes.rubric(chart.title, chart.title), sentence, picture]
        return found


def _description(svg: str) -> str:
    """The description within an SVG file, for readers who cannot see the picture."""
    found = re.search(r"<desc>(.*?)</desc>", svg, re.DOTALL)
    return " ".join(html.unescape(found[1]).split()) if found else ""


class RunDirective(SphinxDirective):
    """The directive ``{run} tresym …``: a command and its output, run while the page is built."""

    required_arguments = 1
    final_argument_whitespace = True

    def run(self) -> list[nodes.Node]:
        """Return a block of console text."""
        try:
            text = commands.transcript(self.arguments[0])
        except ValueError as error:
            raise self.error(str(error)) from None
        return [nodes.literal_block(text, text, language="console")]


class PaperDirective(SphinxDirective):
    """The directive ``{paper} FILE.tresym``: the document of a file of claims, without charts."""

    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        """Return the document in a frame, its headings in bold."""
        path = Path(self.env.srcdir) / self.arguments[0]
        self.env.note_dependency(str(path))
        try:
            text = opened.open(path).derive(style="markdown")
        except InputError as error:
            raise self.error(str(error)) from None
        text = re.sub(r"^#+ (.*)$", r"**\1**", text, flags=re.MULTILINE)
        box = nodes.container(classes=["claim"])
        box += self.parse_text_to_nodes(text)
        return [box]


class DrawDirective(SphinxDirective):
    """The directive ``{draw} tresym figure …``: a picture, drawn while the page is built."""

    required_arguments = 1
    final_argument_whitespace = True

    def run(self) -> list[nodes.Node]:
        """Return the command, and its SVG within the page."""
        command = self.arguments[0]
        try:
            text = commands.transcript(command)
        except ValueError as error:
            raise self.error(str(error)) from None
        shown = f'<div class="drawn">{text[text.index("<svg") :]}</div>'
        asked = f"$ {commands.on_lines(command)}"
        block = nodes.literal_block(asked, asked, language="console")
        return [block, nodes.raw("", shown, format="html")]


class ExplainDirective(SphinxDirective):
    """The directive ``{explain} CLAIM``: the verdict on a claim, typeset, with a picture."""

    required_arguments = 1
    final_argument_whitespace = True

    def run(self) -> list[nodes.Node]:
        """Return the command, and the explanation in a frame."""
        claim = self.arguments[0]
        try:
            found = explain(claim)
        except InputError as error:
            raise self.error(str(error)) from None
        asked = f"$ tresym explain '{claim}'"
        box = nodes.container(classes=["claim"])
        box += self.parse_text_to_nodes(with_badges(found.markdown()))
        box += nodes.raw("", f'<div class="drawn">{found.picture()}</div>', format="html")
        return [nodes.literal_block(asked, asked, language="console"), box]


def with_badges(text: str) -> str:
    """Return Markdown with the verdicts in their colours."""
    return re.sub(r"\b(PROVED|ENCLOSED|REFUTED|UNDECIDED)\b", lambda word: badge(word[0]), text)


class ManuscriptDirective(SphinxDirective):
    """The directive ``{manuscript} FILE.tex``: the formulas that fail, typeset."""

    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        """Return the command, and for each failing formula its line, why, and what is true."""
        path = Path(self.env.srcdir) / self.arguments[0]
        self.env.note_dependency(str(path))
        rows = proofread(decided(read_links(read_manuscript(path)), 5.0))
        text = "\n\n".join(_failing(row, path.name) for row in rows if row.status == "REFUTED")
        if not text:
            raise self.error(f"{path.name}: no formula fails")
        asked = f"$ tresym paper docs/{self.arguments[0]}"
        box = nodes.container(classes=["claim"])
        box += self.parse_text_to_nodes(with_badges(text))
        return [nodes.literal_block(asked, asked, language="console"), box]


def _failing(row: Row, name: str) -> str:
    shown = in_latex(row.refuted or row.link.read_as)
    text = f"REFUTED in line {row.link.display.line} of `{name}`:\n\n$$\n{shown}\n$$\n\n"
    sides = row.link.sides
    why = parts(
        row.why[:1].upper() + row.why[1:], symbols(sides[0]) | symbols(sides[2]) if sides else ()
    )
    text += "".join(f"${part}$" if is_formula else part for part, is_formula in why) + "."
    if row.instead:
        text += f"\n\nTrue instead:\n\n$$\n{in_latex(row.instead[0].claim)}\n$$\n"
    return text


class NotebookDirective(SphinxDirective):
    """The directive ``{notebook} PATH``: the cells of a notebook with their saved outputs."""

    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        """Return text cells as text, and code cells as code with their outputs."""
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
    """Write an inline formula as MathML."""
    translator.body.append(mathematics.mathml(node.astext(), block=False))
    raise nodes.SkipNode


def visit_block(translator: HTML5Translator, node: nodes.math_block) -> None:
    """Write a displayed formula as MathML, in a frame that scrolls if the formula is too wide."""
    shown = mathematics.mathml(node.astext(), block=True)
    translator.body.append(f'<div class="math">{shown}</div>\n')
    raise nodes.SkipNode


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the extension with Sphinx."""
    (Path(app.srcdir) / BUILT).mkdir(exist_ok=True)  # Sphinx checks it before the build starts
    app.connect("builder-inited", write_pages)
    app.connect("autodoc-process-docstring", docstrings.process)
    app.connect("autodoc-process-signature", docstrings.signature)
    app.connect("autodoc-skip-member", docstrings.skip)
    app.add_html_math_renderer("mathml", (visit_inline, None), (visit_block, None))
    app.add_directive("claim", ClaimDirective)
    app.add_directive("charts", ChartsDirective)
    app.connect("html-page-context", partial(share_tree, {}), priority=400)  # before the theme
    app.connect("build-finished", copy_explorer)
    app.connect("build-finished", write_data)
    app.connect("doctree-read", link_labels)
    app.connect("doctree-read", set_formulas)
    app.connect("doctree-read", link_pictures)
    app.add_directive("run", RunDirective)
    app.add_directive("draw", DrawDirective)
    app.add_directive("paper", PaperDirective)
    app.add_directive("explain", ExplainDirective)
    app.add_directive("manuscript", ManuscriptDirective)
    app.add_directive("notebook", NotebookDirective)
    app.add_css_file("mathematics.css")
    return {"parallel_read_safe": True, "parallel_write_safe": True}
