"""The commands for a file of claims: ``tresym verify kepler.tresym`` and the like."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Callable, Sequence
from itertools import count
from shutil import get_terminal_size
from typing import TYPE_CHECKING

from tresym.commands.parser import BAD_INPUT, UNEXPECTED, deliver, deliver_picture
from tresym.output import (
    bold,
    check_replaceable,
    colour_wanted,
    dim,
    make_folder,
    show_progress,
    styled,
    write_bytes,
    write_text,
)
from tresym.reals.numbers.exact import InputError

if TYPE_CHECKING:
    from tresym.papers.reading import OwnPaper, Problem
    from tresym.papers.verification import PaperReport, Row
    from tresym.report.pages.own_paper import Pictures

ENDING = ".tresym"
COLOURS = {
    "PROVED": "32", "ENCLOSED": "36", "REFUTED": "35", "UNDECIDED": "1;33", "DEFINED": "34",
    "ASSUMED": "94",
}  # fmt: skip
GOOD, BAD = "32", "1;31"
LABEL_WIDTH = 24


def is_file_of_claims(words: Sequence[str]) -> bool:
    """Return whether the first word names a file of claims."""
    return bool(words) and words[0].endswith(ENDING)


def opened(path: str) -> OwnPaper:
    """Read a file of claims, and report each line that cannot be read on standard error.

    Raises:
        InputError: there is no such file.
    """
    from tresym.papers.reading import read_file

    paper = read_file(path)
    places: dict[str, list[Problem]] = {}
    for problem in paper.problems:
        places.setdefault(problem.message, []).append(problem)
    for message, (first, *more) in places.items():
        lines = ", ".join(str(problem.line) for problem in more)
        same = f"; the same in line {lines}" if len(more) == 1 else f"; the same in lines {lines}"
        print(
            f"{path}:{first.line}:{first.column}: {message}{same if more else ''}", file=sys.stderr
        )
    return paper


def status(report: PaperReport) -> int:
    """Return the exit status: 2 if a line is not read or no claim is there, else 0 or 1."""
    if report.paper.problems or not report.paper.claims:
        return BAD_INPUT
    return 0 if report.as_expected else UNEXPECTED


def verified(
    paper: OwnPaper, labels: Sequence[str], limit: float | None, workers: int | None = None
) -> PaperReport:
    """Verify a file with a counter on the terminal."""
    from tresym.papers.verification import LIMIT, verify_paper

    advance = _counter(len(paper.chosen(labels)))
    report = verify_paper(paper, labels, limit or LIMIT, workers, on_row=lambda row: advance())
    show_progress("")
    return report


def verify(
    path: str,
    labels: Sequence[str],
    *,
    as_json: bool = False,
    graph: bool = False,
    target: str | None = None,
    limit: float | None = None,
    workers: int | None = None,
    coq: bool = False,
) -> int:
    """Verify a file of claims, print or write the rows, and return the exit status."""
    from tresym.papers.verification import LIMIT, verify_paper

    paper = opened(path)
    if graph:
        deliver(dependency_graph(paper, labels), target)
        return BAD_INPUT if paper.problems else 0
    if as_json or target is not None:
        report = verified(paper, labels, limit, workers)
        whole = report.as_json() | ({"coq": _in_coq(report)} if coq else {})
        deliver(json.dumps(whole, ensure_ascii=False, indent=1) + "\n", target)
        return status(report)
    colour, columns = colour_wanted(), get_terminal_size().columns
    advance = _counter(len(paper.chosen(labels)))
    print(bold(paper.title, colour))

    def show(row: Row) -> None:
        print("\n".join(row_lines(row, bool(labels), columns, colour)))
        advance()

    report = verify_paper(paper, labels, limit or LIMIT, workers, on_row=show)
    show_progress("")
    print(summary(report, colour))
    if coq:
        found = _in_coq(report)
        for label, said in found.items():
            print(f"{label:<{LABEL_WIDTH}}  {said['says']}")
        count_ = sum(said["accepted"] is True for said in found.values())
        print(f"{count_} of {len(found)} claims proved in Coq")
    return status(report)


def _in_coq(report: PaperReport) -> dict[str, dict[str, object]]:
    """Return of each claim whether Coq accepts a proof, and what is said of it."""
    from tresym.coq.paper_proofs import outcomes

    found: dict[str, dict[str, object]] = {}
    for label, outcome in outcomes(report):
        found[label] = {"accepted": outcome.accepted, "says": outcome.says}
        show_progress(f"{label} in Coq")
    show_progress("")
    return found


def row_lines(row: Row, full: bool, width: int, colour: bool) -> list[str]:
    """Return the lines of a row: label, line, verdict and time, and the statement below them.

    Args:
        row: the result.
        full: whether to add the reason, the conditions, the constant and the region.
        width: the columns of a line.
        colour: whether to use terminal colours.
    """
    from textwrap import wrap

    from tresym.papers.reading import PaperClaim
    from tresym.reals.language.formula import chained
    from tresym.reals.notebook import abbreviated

    item, name = row.item, row.verdict.value
    verdict = styled(f"{name:<9}", COLOURS[name], colour)
    head = f"{row.label:<{LABEL_WIDTH}}  line {item.line:<5} {verdict} {row.seconds:>8.2f} s"
    lines = [head]

    def say(text: str, style: str = "") -> None:
        found = wrap(text, max(width, 40), initial_indent="    ", subsequent_indent="      ")
        lines.extend(styled(line, style, colour and bool(style)) for line in found)

    claim = item if isinstance(item, PaperClaim) else None
    say(item.text if isinstance(item, PaperClaim) else f"{item.head} := {item.text}")
    answer = row.decisive
    if not row.as_expected:
        say(f"{unexpected(row)}: {abbreviated(row.why)}", BAD)
    elif full or name in ("REFUTED", "ASSUMED"):
        say(abbreviated(row.why), "2")
    if full and claim is not None:
        for meaning in claim.meanings:
            say(f"decided as {abbreviated(meaning)}", "2")
        if claim.conditions:
            say(f"given {chained(claim.conditions)}", "2")
    if answer is not None and answer.witness:
        say("witness: " + ", ".join(f"{k} = {v}" for k, v in answer.witness.items()), "2")
    if answer is not None and answer.constant is not None and (full or row.verdict.holds):
        region = f" on {answer.region}" if answer.region else ""
        say(f"constant: {answer.constant_text()}{region}", "2")
    if full and answer is not None and answer.lemma:
        say(f"lemma: {answer.lemma}", "2")
    if full and claim is not None and claim.has_parameters and answer is not None:
        uniform = "all values of the parameters at once" if answer.uniform else ""
        say(f"for {uniform or 'each fixed value of the parameters'}", "2")
    for one in row.instead[:1]:
        say(f"true instead: {one.claim}{' given ' + one.given if one.given else ''}", "2")
    if row.axioms:
        say(f"it rests on what is not proved here: {', '.join(row.axioms)}", "2")
    return lines


def unexpected(row: Row) -> str:
    """Return in words how a verdict differs from what the file expects.

    The reason of the verdict follows it, so ``expected that it holds: REASON`` would be misread.
    """
    from tresym.papers.reading import PaperClaim

    expects_refuted = isinstance(row.item, PaperClaim) and row.item.expect_refuted
    if row.verdict.value == "REFUTED":
        return "it is false, though the file does not expect that"
    if row.verdict.value == "UNDECIDED":
        return "not refuted" if expects_refuted else "not proved"
    return "it holds, though the file expects it to be refuted" if expects_refuted else "not shown"


def summary(report: PaperReport, colour: bool) -> str:
    """Return how many rows have which verdict, and whether all is as expected."""
    counts = [
        f"{styled(f'{r.value:<9}', COLOURS[r.value], colour)}  {n}"
        for r, n in report.counts.items()
        if n
    ]
    unexpected = sum(not row.as_expected for row in report.rows)
    problems = len(report.paper.problems)
    lines = "1 line cannot be parsed" if problems == 1 else f"{problems} lines cannot be parsed"
    if not report.paper.claims:
        return "no claim is read: write label: CLAIM, such as square: a**2 >= 0"
    parts = [f"{unexpected} not as expected"] if unexpected else []
    parts += [lines] if problems else []
    outcome = "; ".join(parts) or "every verdict is as expected"
    return "\n".join([*counts, styled(outcome, BAD if parts else GOOD, colour)])


def dependency_graph(paper: OwnPaper, labels: Sequence[str]) -> str:
    """Return the claims and what they use, as a Mermaid graph."""
    lines = ["graph LR"]
    for claim in paper.chosen(labels):
        used = (*claim.uses, *claim.rests_on)
        lines += [f"  {claim.label} --> {name}" for name in used] or [f"  {claim.label}"]
    return "\n".join(lines) + "\n"


def derive(
    path: str,
    labels: Sequence[str],
    *,
    style: str = "article",
    target: str | None = None,
    refuted: bool = False,
    figures: bool | None = None,
    force: bool = False,
) -> int:
    """Write the document of a file of claims, or of some claims, and return the exit status."""
    from tresym.report.pages import own_paper

    if labels and style not in own_paper.STYLES:
        raise InputError(
            f"derive: single claims have the styles {', '.join(own_paper.STYLES)}; leave out the "
            f"labels for --style {style}"
        )
    if style == "site" and target is None:
        raise InputError("derive: --style site writes a folder: name it with -o FOLDER")
    paper = opened(path)
    report = verified(paper, labels, None)
    if labels:
        rows = [report[label] for label in dict.fromkeys(labels)]
        refused = [] if refuted else own_paper.refused(rows)
        if refused:
            print("\n".join(refused), file=sys.stderr)
            return UNEXPECTED
        deliver(own_paper.fragments(report, rows, style), target)
        return status(report)
    pictures = _pictures(paper, style, target, figures, force)
    if style in ("html", "site"):
        _say_if_not_typeset(paper)
    if style == "site" and target is not None:
        from tresym.report.pages.own_site import site

        pages = {os.path.join(target, name): text for name, text in site(report, pictures).items()}
        check_replaceable(pages, force)
        for page in pages:
            make_folder(os.path.dirname(page))
        for page, text in pages.items():
            write_text(page, text)
    elif style == "beamer":
        from tresym.report.pages.own_slides import slides

        deliver(slides(report, pictures), target)
    else:
        deliver(own_paper.document(report, style, pictures), target)
    return status(report)


def _say_if_not_typeset(paper: OwnPaper) -> None:
    from tresym.report.typesetting.html import typesets

    if not typesets():
        need = "typesetting needs math-core (pip install 'tresym[html]')"
        print(f"{paper.name}: formulas are shown as LaTeX: {need}", file=sys.stderr)


def _pictures(
    paper: OwnPaper, style: str, target: str | None, wanted: bool | None, force: bool
) -> Pictures:
    """Compute the tables of a document, and write its charts to a folder beside it."""
    from importlib.util import find_spec

    from tresym.report.pages import own_tables
    from tresym.report.pages.own_paper import Pictures

    if style == "jupyter":
        return Pictures()
    show_progress("tables")
    tables, errors = own_tables.all_tables(paper, style)
    show_progress("")
    print("".join(f"{line}\n" for line in errors), end="", file=sys.stderr)
    if wanted and find_spec("matplotlib") is None:
        raise InputError("derive: charts need matplotlib (pip install 'tresym[docs]')")
    drawn_ones = list(paper.drawn("chart"))
    if target is None or wanted is False or find_spec("matplotlib") is None:
        if drawn_ones and target is not None and wanted is None:
            names = ", ".join(drawn.label for drawn in drawn_ones)
            need = "charts need matplotlib (pip install 'tresym[docs]')"
            print(f"{paper.name}: left out the charts of {names}: {need}", file=sys.stderr)
        return Pictures(tables)
    folder = f"{os.path.splitext(target)[0]}-figures"
    if style == "site":
        folder = os.path.join(target, "figures")
    kind = "pdf" if style in ("article", "beamer") else "svg"
    charts: dict[int, str] = {}
    pictures: dict[str, bytes] = {}
    for drawn in drawn_ones:
        path = os.path.join(folder, f"{drawn.label}.{kind}")
        try:
            pictures[path] = own_tables.chart(paper, drawn.label, kind)
        except InputError as error:
            note = f"left out the chart of {drawn.label}: {error}"
            print(f"{paper.name}:{drawn.line}:1: {note}", file=sys.stderr)
            continue
        charts[drawn.line] = f"{os.path.basename(folder)}/{drawn.label}.{kind}"
    check_replaceable(pictures, force)
    if pictures:
        make_folder(folder)
    for path, picture in pictures.items():
        write_bytes(path, picture)
    return Pictures(tables, charts)


def export(path: str, labels: Sequence[str], folder: str, force: bool) -> int:
    """Write the claims of a file that hold as theorems of Coq, one file for each claim.

    Each theorem has a proof if one is found; if Coq is installed, it checks the file. The folder
    also gets ``index.json``, which says of each claim what came of it.
    """
    from tresym.coq.paper_proofs import file_name, outcomes

    paper = opened(path)
    report = verified(paper, labels, None)
    make_folder(folder)
    index: dict[str, dict[str, object]] = {}
    files: dict[str, str] = {}
    for label, found in outcomes(report):
        show_progress(f"{label} in Coq")
        if found.text and found.accepted is not False:
            files[os.path.join(folder, f"{file_name(label)}.v")] = found.text
        index[label] = {"accepted": found.accepted, "says": found.says}
    show_progress("")
    files[os.path.join(folder, "index.json")] = (
        json.dumps(index, ensure_ascii=False, indent=1) + "\n"
    )
    check_replaceable(files, force)
    for target, text in files.items():
        write_text(target, text)
    for label, found_row in index.items():
        print(f"{label:<{LABEL_WIDTH}}  {found_row['says']}")
    print(f"{folder}: {len(files) - 1} of {len(index)} claims written")
    return status(report)


def table(path: str, label: str, form: str, as_json: bool, target: str | None) -> int:
    """Print the tables that a file asks for of a claim, and return the exit status."""
    from tresym.accuracy.table import written
    from tresym.report.pages import own_tables

    found = own_tables.tables_of(opened(path), label)
    if as_json:
        rows = [one._asdict() for one in found]
        deliver(json.dumps(rows, ensure_ascii=False, indent=1) + "\n", target)
    else:
        words = own_tables.latex_words
        deliver("\n".join(written(one, form, words) for one in found), target)
    return 0


def chart(path: str, label: str, target: str | None) -> int:
    """Draw the chart of a claim, and return the exit status."""
    from tresym.report.pages import own_tables

    paper = opened(path)
    deliver_picture(lambda kind: own_tables.chart(paper, label, kind), target)
    return 0


def _counter(total: int) -> Callable[[], None]:
    done = count(1)
    return lambda: show_progress(f"{next(done)} of {total} claims and definitions")


def example_path(path: str) -> str:
    """Return the path of a new file, which ends in ``.tresym`` and does not exist.

    Raises:
        InputError: there is such a file or folder.
    """
    found = path if path.endswith(ENDING) else f"{path}{ENDING}"
    if os.path.exists(found):
        raise InputError(f"{found}: exists already; name another file")
    return found


__all__ = ["derive", "dim", "is_file_of_claims", "opened", "verify"]
