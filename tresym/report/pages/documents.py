"""Build the generated documents, or check that they are up to date.

``tresym docs`` writes two folders. ``docs/generated`` is in git: the article, the corrections,
figures, charts and certified tables, which people read there. ``docs/_pages`` is not: what only the
site shows (the ledger with its formulas, numbers in prose, the trust page, tables of methods). The
site builds it when it is missing or older than the sources.

The documents do not depend on time or machine: coordinates in pictures are rounded to a grid, and
tables show only digits that are proved.
"""

from __future__ import annotations

import json
import os
import pickle
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from hashlib import sha256
from pathlib import Path

import tresym
from tresym.ledger.paper import racket
from tresym.ledger.verification import Report, verify
from tresym.output import write_text
from tresym.reals.numbers.exact import InputError
from tresym.reals.processes import cores
from tresym.report import charts
from tresym.report.charts import saved
from tresym.report.figures.grid import shown
from tresym.report.pages import coq_page
from tresym.report.pages.approximations import page as approximations_page
from tresym.report.pages.article import article, passages
from tresym.report.pages.check_tables import by_kind, by_source, measured
from tresym.report.pages.corrections import corrections
from tresym.report.pages.functions import page as functions_page
from tresym.report.pages.methods import methods
from tresym.report.pages.numbers import numbers
from tresym.report.pages.published_errors import page as published_errors_page
from tresym.report.pages.site_data import record
from tresym.report.pages.symbols import symbols
from tresym.report.pages.trust import trust, trust_details


def documents() -> Iterator[tuple[str, str]]:
    """Yield the documents that are in git, as their paths below docs/generated with their texts."""
    yield from kept(judged())
    yield from drawn()


def judged() -> Report:
    """Judge the whole ledger, or read the judgement that was stored for the same sources.

    The site and the tests, which begin at once in ``.ci/run``, judge it once together.
    """
    with _alone("judged"):
        return _judged()


@contextmanager
def _alone(work: str) -> Iterator[None]:
    """Wait until no other process does the same work, where the system can lock files."""
    try:
        import fcntl
    except ImportError:
        yield
        return
    home = site_folder()
    home.mkdir(exist_ok=True)
    with (home / f"{work}.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        yield


def _judged() -> Report:
    from tresym.ledger.paper import all_claims
    from tresym.ledger.verification import Row

    place, wanted = site_folder() / "judged.pickle", fingerprint()
    if place.is_file():
        found, findings = pickle.loads(place.read_bytes())
        if found == wanted:
            rows = (Row(claim, replace(findings[claim.label], of=claim)) for claim in all_claims())
            return Report(tuple(rows), racket().labels_by_alias)
    report = verify(workers=cores())
    findings = {row.claim.label: replace(row.finding, of=None) for row in report.rows}
    aside = place.with_name(f"judged.{os.getpid()}")
    aside.write_bytes(pickle.dumps((wanted, findings)))
    aside.replace(place)
    return report


def fingerprint() -> str:
    """Return a digest of the sources, the proofs and the stored measurements."""
    root, digest = site_folder().parent.parent, sha256()
    files = [
        *root.glob("tresym/**/*.py"),
        *root.glob("proofs/**/*"),
        *root.glob("docs/measurements/*"),
    ]
    for path in sorted(path for path in files if path.is_file() and path.suffix != ".pyc"):
        digest.update(str(path.relative_to(root)).encode() + b"\0" + path.read_bytes() + b"\0")
    return digest.hexdigest()


def kept(report: Report) -> Iterator[tuple[str, str]]:
    """Yield the documents of the ledger that are in git."""
    yield "derivation.tex", article(report, figures=False)
    yield "corrections.md", corrections(report)


def pages(report: Report) -> Iterator[tuple[str, str]]:
    """Yield what only the site shows, as paths below docs/_pages with their texts."""
    for name, text in passages(report).items():
        yield f"passages/{name}.txt", text
    yield "ledger.json", _json(record(report))
    yield "numbers.json", _json(numbers(report))
    yield "symbols.md", symbols(report)
    yield "methods.md", methods()
    yield "functions.md", functions_page()
    yield "approximations.md", approximations_page(_docs())
    yield "published_errors.md", published_errors_page(_docs())
    yield "coq_proofs.md", coq_page.page()
    measured_tests = [*map(saved.load, ("guards", "hunts", "mutants"))]
    yield "trust.md", trust(report, *measured_tests)
    yield "trust-details.md", trust_details(*measured_tests)
    yield "deciding.md", measured(saved.load("check"))
    yield "kinds.md", by_kind(saved.load("kinds"))
    yield "papers.md", by_source(saved.load("papers"))


def build_pages() -> Path:
    """Write docs/_pages if it is missing or older than the sources, and return the folder."""
    home, wanted = site_folder(), fingerprint()
    mark = home / "sources"
    with _alone("pages"):
        if not mark.is_file() or mark.read_text(encoding="utf-8") != wanted:
            _write_all(home, pages(judged()))
            mark.write_text(wanted, encoding="utf-8")
    return home


def drawn() -> Iterator[tuple[str, str]]:
    """Yield the documents that involve float arithmetic: pictures and tables."""
    figures, tables = racket().figures(), racket().tables()
    for name in figures.FIGURES:
        yield f"figures/{name}.svg", figures.svg(name)
    for name in charts.CHARTS:
        yield f"charts/{name}.svg", charts.svg(name)
    for name in tables.TABLES:
        found = tables.table(name)
        yield f"tables/{name}.md", tables.written(found, "markdown")
        yield f"tables/{name}.tex", tables.written(found, "latex")


def _json(value: object) -> str:
    return json.dumps(value, ensure_ascii=False, indent=1) + "\n"


def folder() -> Path:
    """Return docs/generated of the source checkout.

    Raises:
        InputError: tresym does not run from a checkout.
    """
    return _docs() / "generated"


def site_folder() -> Path:
    """Return docs/_pages of the source checkout, which git ignores; errors as for `folder`."""
    return _docs() / "_pages"


def _docs() -> Path:
    root = Path(tresym.__file__).resolve().parent.parent
    if not (root / "docs").is_dir():
        raise InputError(
            "docs: tresym is not running from a source checkout, so there is no docs folder; "
            "run the command in a checkout"
        )
    return root / "docs"


def _write_all(home: Path, texts: Iterable[tuple[str, str]]) -> list[str]:
    done = []
    for name, text in texts:
        path = home / name
        os.makedirs(path.parent, exist_ok=True)
        write_text(str(path), text)
        done.append(f"docs/{home.name}/{name}")
    return done


def build() -> list[str]:
    """Write every document.

    Returns:
        The paths written, relative to the checkout.
    """
    done = _write_all(folder(), documents())
    build_pages()
    return done


def stale(built: Iterable[tuple[str, str]] | None = None) -> list[str]:
    """Return the paths of documents in git that differ from what would be written.

    Args:
        built: the documents to compare, as :func:`documents` yields them; None builds all.
    """
    home = folder()

    def fresh(name: str, text: str) -> bool:
        path = home / name
        return path.is_file() and shown(path.read_text(encoding="utf-8")) == shown(text)

    found = documents() if built is None else built
    return [f"docs/generated/{name}" for name, text in found if not fresh(name, text)]
