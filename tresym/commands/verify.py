"""``tresym verify``: verify the ledger, and print it as text or JSON."""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from typing import TYPE_CHECKING

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn
from rich.table import Table
from rich.text import Text

from tresym.commands.parser import (
    UNEXPECTED,
    Commands,
    add_output,
    deliver,
    in_a_checkout,
    worker_count,
)
from tresym.ledger.finding import RULINGS, Premise, Ruling
from tresym.reals.numbers.exact import InputError, fraction_text
from tresym.reals.verdict import Verdict

if TYPE_CHECKING:
    from tresym.dev.mutants.report import MutantReport, MutantRow
    from tresym.ledger.claim import Claim
    from tresym.ledger.verification import Report, Row


def add(commands: Commands) -> None:
    """Add `tresym verify` to the command line."""
    parser = commands.add_parser(
        "verify",
        help="verify every claim, or some claims and everything they depend on",
        description="Give every statement of the paper a verdict: PROVED, ENCLOSED, REFUTED or "
        "UNDECIDED. Definitions are DEFINED, physical assumptions are ASSUMED.",
        epilog="Exit status: 1 if a verdict is not the expected one, or a false variant passes.",
        allow_abbrev=False,
    )
    parser.add_argument("labels", nargs="*", metavar="LABEL", help="claims, such as eq_gamma")
    parser.add_argument(
        "--graph",
        action="store_true",
        help="print the dependencies of the claims as a Mermaid graph",
    )
    parser.add_argument(
        "--mutants",
        action="store_true",
        help="judge false variants of the claims, none of which may pass",
    )
    parser.add_argument(
        "--full",
        action="store_true",
        help="search for the stored box proofs again instead of checking them",
    )
    parser.add_argument(
        "--save-certificates",
        action="store_true",
        help="with --full, store the box proofs that were found",
    )
    parser.add_argument(
        "--workers", metavar="N", help="number of processes (default: one per core)"
    )
    add_output(parser)
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Run the command and return its exit status."""
    if args.save_certificates and not args.full:
        raise InputError("--save-certificates stores what --full finds; give both options")
    if not args.full:
        return _verify_claims(args)
    from tresym.ledger.evidence.box_bounds import finding_anew

    if args.save_certificates:
        from tresym.ledger.certificates import checkout_file

        checkout_file()  # refused before the search, not after it
    with finding_anew():
        return _verify_claims(args)


def _verify_claims(args: argparse.Namespace) -> int:
    from tresym.ledger import verification

    labels = tuple(args.labels)
    workers = worker_count(args.workers)
    if args.graph:
        deliver(verification.graph(labels), args.path)
        return 0
    if args.mutants:
        return _verify_mutants(labels, args, workers)
    if args.json or args.path is not None:
        import json

        from tresym.report.pages.ledger_rows import report_json

        report = verification.verify(labels, workers=workers)
        deliver(json.dumps(report_json(report), ensure_ascii=False, indent=1) + "\n", args.path)
    else:
        from tresym.output import terminal

        report = show_verification(labels, terminal(), workers)
    if args.save_certificates:
        verification.save_certificates(report)
    return 0 if report.as_expected else UNEXPECTED


def _verify_mutants(labels: tuple[str, ...], args: argparse.Namespace, workers: int) -> int:
    with in_a_checkout("verify --mutants"):
        from tresym.dev.mutants.report import verify_mutants
    if args.json or args.path is not None:
        import json

        report = verify_mutants(labels, workers=workers)
        deliver(json.dumps(report.as_json(), ensure_ascii=False, indent=1) + "\n", args.path)
    else:
        from tresym.output import terminal

        report = show_mutants(labels, terminal(), workers)
    return UNEXPECTED if report.survivors or report.stopped else 0


STYLES: dict[Ruling, str] = {
    Verdict.PROVED: "green",
    Verdict.ENCLOSED: "cyan",
    Verdict.REFUTED: "magenta",
    Verdict.UNDECIDED: "bold yellow",
    Premise.DEFINED: "blue",
    Premise.ASSUMED: "bright_blue",
}


LABEL_WIDTH = 30


PLACE_WIDTH = 24


def show_verification(labels: tuple[str, ...], console: Console, workers: int = 1) -> Report:
    """Verify claims, print each row as it is found, then the count by verdict."""
    from tresym.ledger.verification import choose, verify

    # An unknown label is refused here, before anything is printed.
    total = len(choose(labels))
    progress = _progress("verifying", console)
    console.print(_headings())
    with progress:
        task = progress.add_task("claims", total=total)

        def show(row: Row) -> None:
            for line in _row_lines(row, bool(labels), console.width):
                console.print(line, soft_wrap=True)
            progress.advance(task)

        report = verify(labels, on_row=show, workers=workers)
    console.print(_summary(report))
    return report


def show_mutants(labels: tuple[str, ...], console: Console, workers: int = 1) -> MutantReport:
    """Judge false variants, print those that pass as they are found, then the score."""
    from tresym.dev.mutants.report import verify_mutants
    from tresym.ledger.verification import MUTANTS, choose

    total = len(choose(labels))
    progress = _progress("judging mutants", console)
    with progress:
        task = progress.add_task("claims", total=len(labels) or total)

        def show(row: MutantRow) -> None:
            for slip in (*row.survivors, *row.stopped):
                by = " (stopped only by the independent check)" if slip in row.stopped else ""
                text = f"{slip.label}, {slip.place}: {slip.change}{by}"
                console.print(Text(text, style="bold red"), soft_wrap=True)
            progress.advance(task)

        report = verify_mutants(labels, on_row=show, workers=workers)
    refuted, total = report.counts[Verdict.REFUTED.value], sum(report.counts.values())
    of = sum(row.total > 0 for row in report.rows)
    console.print(f"{total} false variants of {of} claims:")
    console.print(_counts(report.counts))
    share = (
        f"{100 * refuted / total:.1f} % refuted with a witness" if total else "no false variants"
    )
    held = len(report.survivors) + len(report.stopped)
    stopped = (
        f" ({len(report.stopped)} stopped only by the independent check)" if report.stopped else ""
    )
    outcome = "none passed" if not held else f"{held} passed{stopped}: the verifier is wrong"
    console.print(Text(f"{share}; {outcome}", style="green" if not held else "bold red"))
    for row in report.few:
        text = f"{row.label}: {row.changes} of {MUTANTS}, {row.why_few}"
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
    for verdict in RULINGS:
        table.add_row(Text(verdict.value, style=STYLES[verdict]), str(counts[verdict.value]))
    return table


def _columns(label: str, place: str, verdict: Text, time: str) -> Text:
    text = Text(f"{label:<{LABEL_WIDTH}}  {place:<{PLACE_WIDTH}}  ", no_wrap=True)
    return text + verdict + Text(" " * (10 - len(verdict)) + f"{time:>9}")


def _headings() -> Text:
    line = _columns("claim", "in the paper", Text("verdict"), "time")
    line.stylize("bold")
    return line


def _row_lines(row: Row, named: bool, width: int) -> list[Text]:
    from tresym.report.pages import coq_page
    from tresym.report.typesetting.paper_location import place_text
    from tresym.report.typesetting.plain_text import in_lines
    from tresym.report.typesetting.statements import in_letters

    claim, finding = row.claim, row.finding
    verdict = Text(finding.verdict.value, style=STYLES[finding.verdict])
    time = f"{1000 * finding.seconds:.1f} ms"
    lines = [_columns(claim.label, place_text(claim), verdict, time)]

    def say(text: str, style: str = "") -> None:
        lines.extend(Text(line, style=style) for line in in_lines(text, " " * 4, " " * 6, width))

    if row.requested and named:
        for stated in _stated(claim):
            say(stated)
        if proved := coq_page.sentence(claim):
            say(proved)
    if not row.as_expected:
        say(f"expected {claim.expect.value}: {finding.why}", "bold red")
    elif finding.verdict is Verdict.REFUTED:
        say(in_letters(finding.why), "dim")
        if finding.witness:
            point = ", ".join(f"{n} = {fraction_text(v)}" for n, v in finding.witness.items())
            say(f"witness: {in_letters(point)}", "dim")
        if claim.amended_by:
            names = ", ".join(c.label for c in claim.amended_by)
            say(f"true instead: {names}", "dim")
    return lines


def _stated(claim: Claim) -> Iterator[str]:
    """Yield the statement of a claim with its conditions, and the formula that is decided."""
    from tresym.report.typesetting.plain_text import plain
    from tresym.report.typesetting.statements import in_plain_text, said

    found = said(claim)
    yield in_plain_text(found)
    yield from (f"decided as {plain(formula)}" for formula in found.means)


def _summary(report: Report) -> Table:
    table = _counts(report.counts)
    kinds = report.refuted
    if any(kinds.values()):
        table.add_row(
            "",
            f"refuted: {kinds['paper']} statements of the paper, {kinds['stricter']} readings "
            f"stricter than its words, {kinds['sharpness']} checks that a bound of ours is sharp",
        )
    unexpected = sum(not row.as_expected for row in report.rows)
    outcome = "every verdict is as expected" if not unexpected else f"{unexpected} not as expected"
    table.add_row("", Text(outcome, style="green" if not unexpected else "bold red"))
    resting = sum(bool(row.claim.axioms) for row in report.rows)
    if resting:
        claims = "1 claim rests" if resting == 1 else f"{resting} claims rest"
        theorems = (
            "1 quoted theorem"
            if len(report.axioms) == 1
            else (f"{len(report.axioms)} quoted theorems")
        )
        table.add_row("", f"{claims} on {theorems}")
    return table
