"""The commands for a file of claims: ``tresym verify kepler.tresym`` and the like."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Callable, Sequence
from itertools import count
from shutil import get_terminal_size
from typing import TYPE_CHECKING

from tresym.commands.parser import BAD_INPUT, UNEXPECTED, deliver
from tresym.output import bold, colour_wanted, dim, show_progress, styled
from tresym.reals.numbers.exact import InputError

if TYPE_CHECKING:
    from tresym.papers.reading import OwnPaper
    from tresym.papers.verification import PaperReport, Row

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
    """Read a file of claims, and print a line on standard error for each line of it not read.

    Raises:
        InputError: there is no such file.
    """
    from tresym.papers.reading import read_file

    paper = read_file(path)
    for problem in paper.problems:
        print(f"{path}:{problem.line}:{problem.column}: {problem.message}", file=sys.stderr)
    return paper


def status(report: PaperReport) -> int:
    """Return the exit status: 2 if a line is not read, 1 if a verdict is not as expected."""
    if report.paper.problems:
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
) -> int:
    """Verify a file of claims, print or write the rows, and return the exit status."""
    from tresym.papers.verification import LIMIT, verify_paper

    paper = opened(path)
    if graph:
        deliver(dependency_graph(paper, labels), target)
        return BAD_INPUT if paper.problems else 0
    if as_json or target is not None:
        report = verified(paper, labels, limit, workers)
        deliver(json.dumps(report.as_json(), ensure_ascii=False, indent=1) + "\n", target)
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
    return status(report)


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
    from tresym.reals.decisions.answer import ball_text
    from tresym.reals.decisions.statement import chained
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
        expected = "REFUTED" if claim is not None and claim.expect_refuted else "that it holds"
        say(f"expected {expected}: {abbreviated(row.why)}", BAD)
    elif full or name in ("REFUTED", "ASSUMED"):
        say(abbreviated(row.why), "2")
    if full and claim is not None:
        for link in claim.links:
            say(f"decided as {abbreviated(chained((link,)))}", "2")
        if claim.conditions:
            say(f"given {chained(claim.conditions)}", "2")
    if answer is not None and answer.witness:
        say("witness: " + ", ".join(f"{k} = {v}" for k, v in answer.witness.items()), "2")
    if answer is not None and answer.constant is not None and (full or row.verdict.holds):
        region = f" on {answer.region}" if answer.region else ""
        say(f"constant: {ball_text(answer.constant)}{region}", "2")
    for one in row.instead[:1]:
        say(f"true instead: {one.claim}{' given ' + one.given if one.given else ''}", "2")
    if row.axioms:
        say(f"it rests on {', '.join(row.axioms)}, which is quoted and not proved here", "2")
    return lines


def summary(report: PaperReport, colour: bool) -> str:
    """Return how many rows have which verdict, and whether all is as expected."""
    counts = [
        f"{styled(f'{r.value:<9}', COLOURS[r.value], colour)}  {n}"
        for r, n in report.counts.items()
        if n
    ]
    unexpected = sum(not row.as_expected for row in report.rows)
    problems = len(report.paper.problems)
    lines = "1 line is not read" if problems == 1 else f"{problems} lines are not read"
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

    if style not in own_paper.STYLES:
        raise InputError(
            f"derive: for a file of claims the styles are {', '.join(own_paper.STYLES)}"
        )
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
    pictures = own_paper.Pictures()
    deliver(own_paper.document(report, style, pictures), target)
    return status(report)


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
