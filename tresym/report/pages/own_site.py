"""Write a small static site of a file of claims: the text, and a page for each claim.

``index.html`` is the document, in which each claim is a link to its page, ``claims/LABEL.html``.
That page explains the verdict: the lemma with its source, each statement on which it rests, the
constant, a counterexample, and for orders and limits a table of both sides. It names what the claim
uses and what uses it. The pages load nothing from elsewhere.
"""

from __future__ import annotations

from collections.abc import Iterator
from html import escape

from tresym.papers.reading import OwnPaper, PaperClaim
from tresym.papers.verification import PaperReport, Row
from tresym.report.pages.explanation import explained
from tresym.report.pages.own_paper import HTML, Pictures, block, html_body
from tresym.report.typesetting import html

HOME = "index.html"


def site(report: PaperReport, pictures: Pictures | None = None) -> dict[str, str]:
    """Return the pages of the site by their paths in its folder.

    Args:
        report: the verified file.
        pictures: its tables, in HTML, and charts.
    """
    paper = report.paper
    look = HTML._replace(code=lambda text: _link(text, paper, "claims/"))
    body = html_body(report, look, pictures or Pictures())
    found = {HOME: html.page(paper.title, body)}
    for row in report.rows:
        if isinstance(row.item, PaperClaim):
            text = "\n".join(_claim(row, row.item, report))
            found[f"claims/{row.label}.html"] = html.page(f"{row.label}: {paper.title}", text)
    return found


def _link(label: str, paper: OwnPaper, folder: str = "") -> str:
    """A label as a link to its page, if there is one; other code as it is."""
    shown = f"<code>{escape(label)}</code>"
    return f'<a href="{folder}{escape(label)}.html">{shown}</a>' if label in paper.claims else shown


def _claim(row: Row, claim: PaperClaim, report: PaperReport) -> Iterator[str]:
    paper = report.paper
    yield f'<nav><a href="../{HOME}">{html.words(paper.title)}</a></nav>'
    yield f"<h1><code>{escape(row.label)}</code></h1>"
    look = HTML._replace(refer=lambda label: _link(label, paper))
    yield f'<div class="claim {row.verdict.value}">\n{block(row, report, look).rstrip()}\n</div>'
    yield f"<p>Line {claim.line} of the file: <code>{escape(claim.text)}</code></p>"
    for n, answer in enumerate(row.answers, 1):
        name = f"Evidence for step {n}" if len(row.answers) > 1 else "Evidence"
        yield f"<h2>{name}</h2>"
        yield explained(answer).html(with_claim=len(row.answers) > 1)
    used = (*claim.uses, *claim.rests_on, *claim.joined)
    users = [one.label for one in paper.claims.values() if row.label in (*one.uses, *one.joined)]
    for title, labels in (("What it uses", used), ("What uses it", users)):
        if labels:
            yield f"<h2>{title}</h2>\n<p>{', '.join(_link(label, paper) for label in labels)}</p>"
