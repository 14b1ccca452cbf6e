"""The ledger at the terminal: rows as they are found, then the count by verdict."""

from __future__ import annotations

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn
from rich.table import Table
from rich.text import Text

from tresym.ledger.mutants.report import MUTANTS, MutantReport, MutantRow, verify_mutants
from tresym.ledger.verification import Report, Row, choose, verify
from tresym.reals.numbers.exact import fraction_text
from tresym.reals.verdict import Verdict
from tresym.report.words.place import place_text

STYLES = {
    Verdict.PROVED: "green",
    Verdict.ENCLOSED: "cyan",
    Verdict.REFUTED: "magenta",
    Verdict.UNDECIDED: "bold yellow",
}

LABEL_WIDTH = 30
PLACE_WIDTH = 22


def show_verification(labels: tuple[str, ...], console: Console, workers: int = 1) -> Report:
    """Verify, print each row as it is found under a progress bar, then the count by verdict."""
    # An unknown label is refused here, before anything is printed.
    total = len(choose(labels))
    progress = _progress("verifying", console)
    console.print(_headings())
    with progress:
        task = progress.add_task("claims", total=total)

        def show(row: Row) -> None:
            for line in _row_lines(row):
                console.print(line, soft_wrap=True)
            progress.advance(task)

        report = verify(labels, on_row=show, workers=workers)
    console.print(_summary(report))
    return report


def show_mutants(labels: tuple[str, ...], console: Console) -> MutantReport:
    """Judge mutants, print those that hold as they are found, then the score."""
    total = len(choose(labels))
    progress = _progress("judging mutants", console)
    with progress:
        task = progress.add_task("claims", total=len(labels) or total)

        def show(row: MutantRow) -> None:
            for mutant in (*row.survivors, *row.stopped):
                by = " (stopped by the advocate alone)" if mutant in row.stopped else ""
                text = f"{row.claim.label}, {mutant.place}: {mutant.change}{by}"
                console.print(Text(text, style="bold red"), soft_wrap=True)
            progress.advance(task)

        report = verify_mutants(labels, on_row=show)
    refuted, total = report.counts[Verdict.REFUTED.value], sum(report.counts.values())
    of = sum(row.total > 0 for row in report.rows)
    console.print(f"{total} false variants of {of} claims:")
    console.print(_counts(report.counts))
    share = f"{100 * refuted / total:.1f} % refuted with a witness" if total else "nothing to judge"
    held = len(report.survivors) + len(report.stopped)
    stopped = f" ({len(report.stopped)} but for the advocate)" if report.stopped else ""
    outcome = "none holds" if not held else f"{held} of them hold{stopped}: the verifier is wrong"
    console.print(Text(f"{share}, {outcome}", style="green" if not held else "bold red"))
    for row in report.few:
        text = f"{row.claim.label}: {row.changes} of {MUTANTS}, {row.why_few}"
        console.print(Text(text, style="dim"), soft_wrap=True)
    return report


def _progress(doing: str, console: Console) -> Progress:
    return Progress(
        TextColumn(doing),
        BarColumn(bar_width=None),
        MofNCompleteColumn(),
        TimeElapsedColumn(),
        console=console,
        transient=True,
        disable=not console.is_terminal,
    )


def _counts(counts: dict[str, int]) -> Table:
    table = Table(show_header=False, box=None, pad_edge=False)
    for verdict in Verdict:
        table.add_row(Text(verdict.value, style=STYLES[verdict]), str(counts[verdict.value]))
    return table


def _columns(label: str, place: str, verdict: Text, time: str) -> Text:
    text = Text(f"{label:<{LABEL_WIDTH}}  {place:<{PLACE_WIDTH}}  ", no_wrap=True)
    return text + verdict + Text(" " * (10 - len(verdict)) + f"{time:>9}")


def _headings() -> Text:
    line = _columns("claim", "in the paper", Text("verdict"), "time")
    line.stylize("bold")
    return line


def _row_lines(row: Row) -> list[Text]:
    claim, finding = row.claim, row.finding
    verdict = Text(finding.verdict.value, style=STYLES[finding.verdict])
    time = f"{1000 * finding.seconds:.1f} ms"
    lines = [_columns(claim.label, place_text(claim), verdict, time)]
    if not row.as_expected:
        lines.append(Text(f"    expected {claim.expect.value}: {finding.why}", style="bold red"))
    elif finding.verdict is Verdict.REFUTED:
        lines.append(Text(f"    {finding.why}", style="dim"))
        if finding.witness:
            point = ", ".join(f"{n} = {fraction_text(v)}" for n, v in finding.witness.items())
            lines.append(Text(f"    witness: {point}", style="dim"))
        if claim.amended_by:
            names = ", ".join(c.label for c in claim.amended_by)
            lines.append(Text(f"    true instead: {names}", style="dim"))
    return lines


def _summary(report: Report) -> Table:
    table = _counts(report.counts)
    unexpected = sum(not row.as_expected for row in report.rows)
    outcome = "every verdict is as expected" if not unexpected else f"{unexpected} not as expected"
    table.add_row("", Text(outcome, style="green" if not unexpected else "bold red"))
    return table
