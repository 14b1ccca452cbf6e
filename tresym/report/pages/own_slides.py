r"""Write the slides of a file of claims in LaTeX, for the class beamer.

A slide shows one claim or definition, with the prose that stands before it and with its verdict; a
table or a chart has a slide of its own. The title of a slide is that of its section. Prose that is
long fills a slide of its own, and what does not fit a slide is continued on the next, so nothing of
the file is left out.
"""

from __future__ import annotations

from collections.abc import Iterator
from importlib.resources import files

from tresym import release
from tresym.papers.definitions import Definition
from tresym.papers.reading import Drawn, PaperClaim, Section
from tresym.papers.verification import PaperReport
from tresym.report.pages.own_paper import LATEX, Pictures, item_blocks, summary, tex_words

LONG = 420
"""Characters of prose that still share a slide with the claim that follows."""
SLIDES = LATEX._replace(
    section=lambda title: "",
    display=lambda formula, label: f"\\[\n{formula}\n\\]\n",
    refer=lambda label: rf"\texttt{{{tex_words(label)}}}",
    picture=lambda path: (
        rf"\begin{{center}}\includegraphics[width=\linewidth,height=0.72\textheight,"
        rf"keepaspectratio]{{{path}}}\end{{center}}" + "\n"
    ),
)
"""How the parts of a slide are written."""


def slides(report: PaperReport, pictures: Pictures | None = None) -> str:
    """Return the slides of a file, as a LaTeX document.

    Args:
        report: the verified file.
        pictures: its tables, in LaTeX, and charts.
    """
    paper, header = report.paper, report.paper.header
    frame = files("tresym.report.pages").joinpath("slides.tex").read_text(encoding="utf-8")
    title = tex_words(paper.title)
    head = frame.partition(r"\hypersetup")[0] + "\\usepackage{array,booktabs}\n"
    authors = r" \and ".join(map(tex_words, header.authors))
    parts = [r"\begin{frame}", r"\titlepage", r"\end{frame}"]
    if header.abstract:
        parts += _frame("Abstract", tex_words(header.abstract))
    parts += _frames(report, pictures or Pictures())
    if header.references:
        works = "".join(
            f"\\bibitem{{{key}}} {tex_words(words)}\n" for key, words in header.references.items()
        )
        works = f"\\begin{{thebibliography}}{{99}}\n{works}\\end{{thebibliography}}"
        parts += _frame("References", works)
    parts += _frame("Verdicts", summary(report, SLIDES))
    body = "\n".join(parts)
    for key in header.references:
        body = body.replace(f"[{tex_words(key)}]", rf"\cite{{{key}}}")
    return (
        f"{head}\\setbeamertemplate{{frametitle continuation}}[from second]\n"
        f"\\setbeamertemplate{{bibliography item}}[text]\n"
        f"\\title{{{title}}}\n\\author{{{authors}}}\n\\date{{tresym {release.dated()}}}\n"
        f"\\begin{{document}}\n{body}\n\\end{{document}}\n"
    )


def _frames(report: PaperReport, pictures: Pictures) -> Iterator[str]:
    """Yield the lines of the slides of the items of a file."""
    title, waiting = tex_words(report.paper.title), ""
    for item in report.paper.items:
        text = "\n".join(item_blocks(item, report, SLIDES, pictures)).strip()
        if isinstance(item, Section):
            yield from _frame(title, waiting)
            title, waiting = tex_words(item.title), ""
            yield rf"\section{{{title}}}"
        elif isinstance(item, Drawn):
            yield from _frame(title, waiting)
            waiting = ""
            yield from _frame(title, text.replace("sidewaystable", "table"), "shrink")
        elif isinstance(item, PaperClaim | Definition):
            if len(waiting) > LONG:
                yield from _frame(title, waiting)
                waiting = ""
            yield from _frame(title, f"{waiting}\n\n{text}")
            waiting = ""
        else:
            waiting = f"{waiting}\n\n{text}".strip()
    yield from _frame(title, waiting)


def _frame(title: str, text: str, how: str = "allowframebreaks") -> Iterator[str]:
    """Yield the lines of one slide; nothing if it has no text."""
    if text.strip():
        yield rf"\begin{{frame}}[{how}]{{{title}}}"
        yield text.strip()
        yield r"\end{frame}"
