"""``tresym verify``: verify the ledger, and print it as text or JSON."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Iterator
from itertools import count
from shutil import get_terminal_size
from typing import TYPE_CHECKING

from tresym.commands import claims_file
from tresym.commands.claims_file import is_file_of_claims
from tresym.commands.parser import (
    UNEXPECTED,
    Commands,
    add_options,
    add_output,
    deliver,
    in_a_checkout,
    parse_seconds,
    worker_count,
)
from tresym.ledger.finding import RULINGS, Premise, Ruling
from tresym.output import bold, colour_wanted, dim, show_progress, styled, write_text
from tresym.reals.numbers.exact import InputError, fraction_text, quoted
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
        description="Give every statement of the paper, or of your own file of claims, a verdict: "
        "PROVED, ENCLOSED, REFUTED or UNDECIDED. Definitions are DEFINED, assumptions are ASSUMED.",
        epilog="Exit status: 1 if a verdict is not the expected one, or a false variant passes; 2 "
        "if a line of the file cannot be read.",
    )
    parser.add_argument(
        "labels",
        nargs="*",
        metavar="[FILE.tresym] LABEL",
        help="claims of the file, or of the racket paper, such as eq_gamma",
    )
    add_options(
        parser,
        ("--graph", "print the dependencies of the claims as a Mermaid graph"),
        ("--mutants", "judge false variants of the claims; no variant may pass"),
        ("--full", "search for the box proofs again instead of checking the stored proofs"),
        ("--save-certificates", "with --full, store the box proofs that the search finds"),
        (
            "--save-sentences",
            "store that the sentences of these claims say the same as their formulas",
        ),
        ("--workers N", "number of processes (default: one per core)"),
        ("--limit SECONDS", "processor time for each claim of a file (20)"),
    )
    parser.add_argument(
        "--coq",
        dest="in_coq",
        action="store_true",
        help="also prove the claims of a file in Coq, and say which proofs Coq accepts",
    )
    add_output(parser)


def run(args: argparse.Namespace) -> int:
    """Run the command and return its exit status."""
    if args.save_certificates and not args.full:
        raise InputError("--save-certificates stores what --full finds; give both options")
    if is_file_of_claims(args.labels):
        return _verify_file(args)
    if args.limit is not None:
        raise InputError("verify: --limit is for a file of claims: tresym verify FILE.tresym")
    if args.in_coq:
        raise InputError("verify: --coq is for a file of claims; the paper's proofs are stored")
    if args.save_sentences:
        return _save_sentences(tuple(args.labels))
    if not args.full:
        return _verify_claims(args)
    from tresym.ledger.evidence.box_bounds import finding_anew

    if args.save_certificates:
        from tresym.ledger.certificates import checkout_file

        checkout_file()  # refused before the search, not after it
    with finding_anew():
        return _verify_claims(args)


def _verify_file(args: argparse.Namespace) -> int:
    if args.full or args.mutants:
        raise InputError("verify: --full and --mutants are for the racket paper, without a file")
    return claims_file.verify(
        args.labels[0],
        args.labels[1:],
        as_json=args.json,
        graph=args.graph,
        target=args.path,
        limit=None if args.limit is None else parse_seconds(args.limit),
        workers=worker_count(args.workers),
        coq=args.in_coq,
    )


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
        report = verification.verify(labels, workers=workers)
        deliver(_as_json(report), args.path)
    else:
        report = show_verification(labels, workers)
    if args.save_certificates:
        verification.save_certificates(report)
    return 0 if report.as_expected else UNEXPECTED


def _as_json(report: Report) -> str:
    import json

    from tresym.ledger.kept_findings import kept_findings
    from tresym.ledger.paper import racket
    from tresym.report.pages.ledger_rows import report_json

    rows = [(f"{r.claim.label} {r.requested}", r.finding) for r in report.rows]
    with kept_findings(racket().folder) as kept:
        return kept.text(
            rows, lambda: json.dumps(report_json(report), ensure_ascii=False, indent=1) + "\n"
        )


def _save_sentences(labels: tuple[str, ...]) -> int:
    """Store the sentences of claims, and of theorems of the article, as compared."""
    from tresym.ledger.paper import all_claims, file_of, racket
    from tresym.ledger.sentences import STORE, digest, sentence_of, stored, updated
    from tresym.report.pages.templates import theorems

    labels = tuple(map(racket().label_of, labels))
    if not labels:
        raise InputError("--save-sentences needs the labels of the claims that were compared")
    claims = {claim.label: claim for claim in all_claims()}
    for label in labels:
        if label not in claims:
            raise InputError(f"no claim is labelled {quoted(label)}")
    found = {
        label: digest(sentence, claim)
        for label, claim in claims.items()
        if label in labels and (sentence := sentence_of(claim)) is not None
    }
    every = theorems()
    found |= {
        f"theorem {label}": digest(text, claims[label])
        for label, text in every.items()
        if label in labels
    }
    kept = {c.label for c in claims.values() if sentence_of(c) is not None}
    kept |= {f"theorem {label}" for label in every}
    write_text(str(file_of(STORE)), updated(found, gone={*(stored() or ())} - kept))
    print(f"{len(found)} sentences stored")
    return 0


def _verify_mutants(labels: tuple[str, ...], args: argparse.Namespace, workers: int) -> int:
    with in_a_checkout("verify --mutants"):
        from tresym.dev.mutants.report import verify_mutants
    if args.json or args.path is not None:
        import json

        report = verify_mutants(labels, workers=workers)
        deliver(json.dumps(report.as_json(), ensure_ascii=False, indent=1) + "\n", args.path)
    else:
        report = show_mutants(labels, workers)
    return UNEXPECTED if report.survivors or report.stopped else 0


STYLES: dict[Ruling, str] = {
    Verdict.PROVED: "32",
    Verdict.ENCLOSED: "36",
    Verdict.REFUTED: "35",
    Verdict.UNDECIDED: "1;33",
    Premise.DEFINED: "34",
    Premise.ASSUMED: "94",
}
"""The colours of terminals: green, cyan, magenta, bold yellow, and two blues."""
GOOD, BAD = "32", "1;31"
LABEL_WIDTH, PLACE_WIDTH = 30, 24


def show_verification(labels: tuple[str, ...], workers: int = 1, width: int = 0) -> Report:
    """Verify claims, print each row as it is found, then the count by verdict.

    Args:
        labels: labels of claims; all if empty.
        workers: the number of processes.
        width: the columns of a line; 0 for those of the terminal.
    """
    from tresym.ledger.verification import choose, verify

    # An unknown label is refused here, before anything is printed.
    advance = _counter(len(choose(labels)))
    columns = width or get_terminal_size().columns
    colour = colour_wanted()
    print(bold(_columns("claim", "in the paper", "verdict", "time", ""), colour))

    def show(row: Row) -> None:
        print("\n".join(_row_lines(row, bool(labels), columns, colour)))
        advance()

    report = verify(labels, on_row=show, workers=workers)
    show_progress("")
    print(_summary(report, colour))
    return report


def show_mutants(labels: tuple[str, ...], workers: int = 1) -> MutantReport:
    """Judge false variants, print those that pass as they are found, then the score."""
    from tresym.dev.mutants.report import verify_mutants
    from tresym.ledger.verification import MUTANTS, choose

    total = len(choose(labels))
    advance, colour = _counter(len(labels) or total), colour_wanted()

    def show(row: MutantRow) -> None:
        for slip in (*row.survivors, *row.stopped):
            by = " (stopped only by the independent check)" if slip in row.stopped else ""
            print(styled(f"{slip.label}, {slip.place}: {slip.change}{by}", BAD, colour))
        advance()

    report = verify_mutants(labels, on_row=show, workers=workers)
    show_progress("")
    refuted, total = report.counts[Verdict.REFUTED.value], sum(report.counts.values())
    of = sum(row.total > 0 for row in report.rows)
    print(f"{total} false variants of {of} claims:\n{_counts(report.counts, colour)}")
    share = (
        f"{100 * refuted / total:.1f} % refuted with a witness" if total else "no false variants"
    )
    held = len(report.survivors) + len(report.stopped)
    stopped = (
        f" ({len(report.stopped)} stopped only by the independent check)" if report.stopped else ""
    )
    outcome = "none passed" if not held else f"{held} passed{stopped}: the verifier is wrong"
    print(styled(f"{share}; {outcome}", BAD if held else GOOD, colour))
    aside = report.aside
    holding = aside[Verdict.PROVED.value] + aside[Verdict.ENCLOSED.value]
    if total := sum(aside.values()):
        left = f"nothing shows that {total} more changes are false: {holding} hold"
        print(dim(f"{left}, {total - holding} are undecided", colour))
    for row in report.few:
        print(dim(f"{row.label}: {row.changes} of {MUTANTS}, {row.why_few}", colour))
    return report


def _counter(total: int) -> Callable[[], None]:
    """Return a function that shows how many claims are done, one more at each call."""
    done = count(1)
    return lambda: show_progress(f"{next(done)} of {total} claims")


def _counts(counts: dict[str, int], colour: bool) -> str:
    return "\n".join(
        f"{styled(f'{v.value:<9}', STYLES[v], colour)}  {counts[v.value]}" for v in RULINGS
    )


def _columns(label: str, place: str, verdict: str, time: str, style: str) -> str:
    shown = styled(f"{verdict:<10}", style, bool(style))
    return f"{label:<{LABEL_WIDTH}}  {place:<{PLACE_WIDTH}}  {shown}{time:>9}"


def _row_lines(row: Row, named: bool, width: int, colour: bool) -> list[str]:
    from tresym.report.pages import coq_page
    from tresym.report.typesetting.paper_location import place_text
    from tresym.report.typesetting.plain_text import in_lines
    from tresym.report.typesetting.statements import in_letters
    from tresym.report.typesetting.titles import shown_name

    claim, finding = row.claim, row.finding
    time, style = f"{1000 * finding.seconds:.1f} ms", STYLES[finding.verdict] if colour else ""
    lines = [
        _columns(shown_name(claim.label), place_text(claim), finding.verdict.value, time, style)
    ]

    def say(text: str, style: str = "") -> None:
        found = in_lines(text, " " * 4, " " * 6, width)
        lines.extend(styled(line, style, colour and bool(style)) for line in found)

    if row.requested and named:
        for stated in _stated(claim):
            say(stated)
        if proved := coq_page.sentence(row):
            say(proved)
    if not row.as_expected:
        say(f"expected {claim.expect.value}: {finding.why}", BAD)
    elif finding.verdict is Verdict.REFUTED:
        say(in_letters(finding.why), "2")
        if finding.witness:
            point = ", ".join(f"{n} = {fraction_text(v)}" for n, v in finding.witness.items())
            say(f"witness: {in_letters(point)}", "2")
        if claim.amended_by:
            names = ", ".join(shown_name(c.label) for c in claim.amended_by)
            say(f"true instead: {names}", "2")
    return lines


def _stated(claim: Claim) -> Iterator[str]:
    """Yield the statement of a claim with its conditions, and the formula that is decided."""
    from tresym.report.typesetting.plain_text import plain
    from tresym.report.typesetting.statements import in_plain_text, said

    found = said(claim)
    yield in_plain_text(found)
    yield from (f"decided as {plain(formula)}" for formula in found.means)


def _summary(report: Report, colour: bool) -> str:
    lines = [_counts(report.counts, colour)]
    kinds = report.refuted
    if any(kinds.values()):
        named = {
            "paper": ("statement of the paper", "statements of the paper"),
            "stricter": (
                "interpretation stricter than its words",
                "interpretations stricter than its words",
            ),
            "sharpness": (
                "check that a bound of ours is sharp",
                "checks that a bound of ours is sharp",
            ),
        }
        counted = (f"{n} {named[kind][n != 1]}" for kind, n in kinds.items() if n)
        lines.append(f"refuted: {', '.join(counted)}")
    unexpected = sum(not row.as_expected for row in report.rows)
    outcome = "every verdict is as expected" if not unexpected else f"{unexpected} not as expected"
    lines.append(styled(outcome, BAD if unexpected else GOOD, colour))
    resting, theorems = sum(bool(row.claim.axioms) for row in report.rows), len(report.axioms)
    if resting:
        claims = "1 claim rests" if resting == 1 else f"{resting} claims rest"
        quoted = "1 quoted theorem" if theorems == 1 else f"{theorems} quoted theorems"
        lines.append(f"{claims} on {quoted}")
    return "\n".join(lines)
