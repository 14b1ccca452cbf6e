"""Build the generated documents, or check that they are up to date.

Everything below docs/generated is written by ``tresym docs`` and never by hand. ``tresym docs
--check`` compares the files with what would be written. The documents do not depend on time or
machine: coordinates in pictures are rounded to a grid, and tables show only digits that are proved.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Iterator
from pathlib import Path

import tresym
from tresym.ledger.paper import sections
from tresym.ledger.verification import Report, verify
from tresym.output import write_text
from tresym.reals.numbers.exact import InputError
from tresym.reals.processes import cores
from tresym.report import charts, figures
from tresym.report.charts import saved
from tresym.report.figures.grid import shown
from tresym.report.pages import coq_page
from tresym.report.pages.article import article, passages
from tresym.report.pages.check_tables import by_kind, by_source, measured
from tresym.report.pages.corrections import corrections
from tresym.report.pages.ledger_document import ledger_document
from tresym.report.pages.messages import messages
from tresym.report.pages.methods import methods
from tresym.report.pages.numbers import numbers
from tresym.report.pages.site_data import record
from tresym.report.pages.symbols import symbols
from tresym.report.pages.tables import TABLES, table, written
from tresym.report.pages.trust import trust, trust_details
from tresym.report.typesetting.paper_location import place_text
from tresym.report.typesetting.statements import quoted


def documents() -> Iterator[tuple[str, str]]:
    """Yield every generated document as its path below docs/generated and its text."""
    yield from pages(verify(workers=cores()))
    yield from drawn()


def pages(report: Report) -> Iterator[tuple[str, str]]:
    """Yield the documents of the ledger and of stored measurements."""
    yield "derivation.tex", article(report, figures=False)
    for name, text in passages(report).items():
        yield f"passages/{name}.txt", text
    yield "derivation-ledger.tex", ledger_document(report)
    yield "ledger.md", ledger(report)
    yield "ledger.json", _json(record(report))
    yield "numbers.json", _json(numbers(report))
    yield "corrections.md", corrections(report)
    yield "symbols.md", symbols(report)
    yield "methods.md", methods()
    yield "coq_proofs.md", coq_page.page()
    yield "messages.md", messages()
    measured_tests = [*map(saved.load, ("guards", "hunts", "mutants"))]
    yield "trust.md", trust(report, *measured_tests)
    yield "trust-details.md", trust_details(*measured_tests)
    yield "tables/deciding.md", measured(saved.load("check"))
    yield "tables/kinds.md", by_kind(saved.load("kinds"))
    yield "tables/papers.md", by_source(saved.load("papers"))


def drawn() -> Iterator[tuple[str, str]]:
    """Yield the documents that involve float arithmetic: pictures and tables."""
    for name in figures.FIGURES:
        yield f"figures/{name}.svg", figures.svg(name)
    for name in charts.CHARTS:
        yield f"charts/{name}.svg", charts.svg(name)
    for name in TABLES:
        found = table(name)
        yield f"tables/{name}.md", written(found, "markdown")
        yield f"tables/{name}.tex", written(found, "latex")


def ledger(report: Report) -> str:
    """Write the page of every claim with its place and verdict, in the order of the proofs."""
    rows = {row.claim.label: row for row in report.rows}
    counts = ", ".join(f"{n} {verdict}" for verdict, n in report.counts.items() if n)
    letters = "Symbols are explained in the [table of symbols](../pages/symbols.md)."
    kinds = report.refuted
    lines = [
        "# The ledger",
        "",
        f"{len(rows)} claims: {counts}. Of the refuted claims, {kinds['paper']} are statements of "
        f"the paper, {kinds['stricter']} are stricter readings of its statements, and "
        f"{kinds['sharpness']} are improvements of our own bounds, whose refutation shows that the "
        f"bounds are sharp. {letters}",
        "",
    ]
    for title, stated in sections():
        claims = [claim for claim in stated if claim.label in rows]
        if not claims:
            continue
        lines += [
            f"## {title}",
            "",
            "| claim | place in the paper | verdict | statement |",
            "|---|---|---|---|",
        ]
        for claim in claims:
            cells = (
                f"`{claim.label}`",
                place_text(claim),
                rows[claim.label].finding.verdict.value,
                quoted(claim),
            )
            lines.append(f"| {' | '.join(cells)} |")
        lines.append("")
    return "\n".join(lines)


def _json(value: object) -> str:
    return json.dumps(value, ensure_ascii=False, indent=1) + "\n"


def folder() -> Path:
    """Return docs/generated of the source checkout.

    Raises:
        InputError: tresym does not run from a checkout.
    """
    root = Path(tresym.__file__).resolve().parent.parent
    if not (root / "docs").is_dir():
        raise InputError(
            "docs: tresym is not running from a source checkout, so there is no docs folder; "
            "run the command in a checkout"
        )
    return root / "docs" / "generated"


def build() -> list[str]:
    """Write every document.

    Returns:
        The paths written, relative to the checkout.
    """
    home, done = folder(), []
    for name, text in documents():
        path = home / name
        os.makedirs(path.parent, exist_ok=True)
        write_text(str(path), text)
        done.append(f"docs/generated/{name}")
    return done


def stale(built: Iterable[tuple[str, str]] | None = None) -> list[str]:
    """Return the paths of documents that differ from what would be written.

    Args:
        built: the documents to compare, as :func:`documents` yields them; None builds all.
    """
    home = folder()

    def fresh(name: str, text: str) -> bool:
        path = home / name
        return path.is_file() and shown(path.read_text(encoding="utf-8")) == shown(text)

    found = documents() if built is None else built
    return [f"docs/generated/{name}" for name, text in found if not fresh(name, text)]
