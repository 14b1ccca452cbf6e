"""``tresym check``: check claims of your own, and print the answers as text or JSON."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from itertools import chain
from shutil import get_terminal_size
from typing import TYPE_CHECKING, TypeAlias

from tresym.commands.claims_file import ENDING
from tresym.commands.claims_in_code import claims_in_comments, how_to_write, is_code
from tresym.commands.parser import Commands, add_options, add_output, json_line, parse_seconds
from tresym.output import bold, colour_wanted, dim, say_if_waiting, show_progress, writing
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict

if TYPE_CHECKING:
    from tresym.checking.time_limited import Task
    from tresym.reals.decisions.answer import Answer

    Answers: TypeAlias = Iterator[tuple[Task, Answer | InputError]]


def add(commands: Commands) -> None:
    """Add `tresym check` to the command line."""
    parser = commands.add_parser(
        "check",
        help="check a claim: an identity, a bound, an order, a limit, an integral, a sum",
        description="Decide claims such as 'diff(F, x) == f', 'exp(x) >= 1 + x', "
        "'integral(f, x, 0, oo) == V', 'integral(f, x) == F', 'sum(f, k, 1, n) == S', "
        "'product(f, k, 1, n) == P' or, with a limit process, "
        "'sin(x) == x + O(x**3)' (O, o, Theta, omega, "
        "~), 'f -> L', 'f > g' (eventually); also 'A and B', 'A <=> B', 'exactly one x in (0, 1): "
        "f == g', 'increasing(f, x)', 'at some point: A': PROVED, ENCLOSED, REFUTED or UNDECIDED, "
        "and why.",
        epilog="Exit status: 0 if the claim holds, 1 if it is refuted, 3 if it is undecided, 2 if"
        " it cannot be parsed. For many claims, it is the first of 2, 1, 3 that occurs.",
    )
    parser.add_argument("claim", nargs="?", metavar="CLAIM", help="text or LaTeX")
    parser.add_argument(
        "--given",
        default=[],
        action="append",
        metavar="CONDITIONS",
        help=(
            "conditions: a > 0, 0 < b <= 1, a + b == 1, n integer; all "
            "conditions of repeated options hold"
        ),
    )
    parser.add_argument(
        "--as",
        dest="tends",
        metavar="PATH",
        help="the limit process (path): x -> 0+, 0-, 0, 1/2, oo, -oo",
    )
    parser.add_argument(
        "--on",
        metavar="REGION",
        help="the region of the constant of an order, or where a bound holds: 0 < x <= 1/2",
    )
    parser.add_argument(
        "-f",
        dest="file",
        metavar="FILE",
        help="a file with one claim per line; # starts a comment; - reads standard input; of a "
        "program (.py, .c, .jl, .glsl, .m and others) the comments '# tresym: CLAIM' are read",
    )
    parser.add_argument(
        "--coq",
        metavar="PROOF.v",
        help="write the statement and its proof for Coq; coqc checks them if it is installed",
    )
    parser.add_argument(
        "--limit", default="5", metavar="SECONDS", help="processor time for each claim (5)"
    )
    parser.add_argument(
        "--no-suggest",
        dest="suggest",
        action="store_false",
        help="do not search for a true statement close to a refuted claim",
    )
    add_options(
        parser,
        (
            "--scheduler ADDRESS",
            "with -f: the workers of a Dask scheduler, as tcp://HOST:PORT (without it: all cores)",
        ),
        ("--no-cache", "with -f: do not use cached answers"),
    )
    add_output(parser)


def run(args: argparse.Namespace) -> int:
    """Run the command and return its exit status."""
    if (args.claim is None) == (args.file is None):
        raise InputError("check: give either one claim or -f FILE")
    if args.file is None and args.scheduler is not None:
        raise InputError("check: --scheduler is for many claims; give them with -f FILE")
    named = (args.claim if args.file is None else args.file).strip()
    if args.file is None and named.endswith(".tex"):
        raise InputError(f"check: {MANUSCRIPT}")
    if named.endswith(ENDING):
        raise InputError(f"check: to verify a file of claims, use: tresym verify {named}")
    given = ", ".join(part for part in args.given if part.strip())
    if args.on is not None and args.file is not None:
        raise InputError("check: --on is for one claim; in a file, end a line with on REGION")
    if args.on is not None:
        args.claim = f"{args.claim.strip()} on {args.on}"
    if args.file is None:
        asked = args.claim, given, args.tends, args.limit
        return one(*asked, args.json, args.path, args.coq, args.suggest)
    if args.coq is not None:
        raise InputError("check: --coq writes one claim; give it without -f")
    from tresym.checking.answer_cache import cached_answers

    asked = args.file, given, args.tends, args.limit
    with cached_answers(not args.no_cache):
        return many(*asked, args.json, args.path, args.scheduler, args.suggest)


LONGEST_LINE = 100_000
"""The maximal length of a line in characters; a longer claim is refused."""
LONGEST_REST = 50_000_000
"""How many characters are skipped in search of the end of a line that is too long."""

MANUSCRIPT = "to check the formulas of a manuscript, use: tresym paper FILE"

REFUTED, BAD, UNDECIDED = 1, 2, 3


_STATUS = {Verdict.REFUTED: REFUTED, Verdict.UNDECIDED: UNDECIDED}


def one(
    claim: str,
    given: str,
    path: str | None,
    limit: str,
    as_json: bool,
    target: str | None,
    coq: str | None = None,
    suggest: bool = True,
) -> int:
    """Decide one claim, show the answer, and return the exit status.

    Args:
        claim, given, path: the claim, its conditions, and the path of a limit or an order.
        limit: seconds, as text.
        target: the file to write the answer to; None for standard output.
        coq: the file for statement and proof in Coq; None for none.
        suggest: whether to search for a true statement close to a refuted claim.
    """
    from tresym.checking.time_limited import Task, check_within
    from tresym.reals.language.readings import need_variables

    need_variables(claim, given, path)
    answer = check_within(Task(claim.strip(), given, path), parse_seconds(limit))
    if suggest and answer.verdict is Verdict.REFUTED:
        from tresym.repair import AS_ALONE, suggestions

        answer = replace(answer, instead=next(suggestions([(answer.read_as, *AS_ALONE)], 1)))
    colour = colour_wanted() and target is None
    said = None if coq is None else _in_coq(claim.strip(), given, path, answer, coq)
    if as_json:
        value = answer.as_json() if said is None else answer.as_json() | {"coq": said}
        text = json_line(value)
    else:
        text = answer_text(answer, colour, _columns(target))
        text += "" if said is None else f"  {dim('coq        ', colour)}{said['says']}\n"
    with _shown_by(target) as show:
        show(text)
    return _STATUS.get(answer.verdict, 0)


def _in_coq(
    claim: str, given: str, path: str | None, answer: Answer, target: str
) -> dict[str, object]:
    """Export a claim to Coq, and return the outcome; the file is written if there is a proof."""
    from tresym.coq.candidate_search import export
    from tresym.coq.claim_export import theorems_of_parts
    from tresym.coq.constant_proofs import with_constant
    from tresym.coq.statement import NotExportedError
    from tresym.output import write_text
    from tresym.reals.decisions.claim_parsing import read
    from tresym.reals.language.compound import read_compound

    if not answer:
        return {
            "accepted": None,
            "says": ("only claims that are PROVED or ENCLOSED are exported to Coq"),
        }
    try:
        whole = read_compound(claim, given, path)
        if whole is None:
            outcome = export(*with_constant(read(claim, given, path), answer))
        else:
            outcome = export(theorems_of_parts(whole))
    except NotExportedError as error:
        return {"accepted": None, "says": str(error)}
    if outcome.accepted is False:
        return {"accepted": False, "says": f"{outcome.says}; nothing is written"}
    write_text(target, outcome.text)
    return {"accepted": outcome.accepted, "says": f"{target}: {outcome.says}"}


def many(
    file: str,
    given: str,
    path: str | None,
    limit: str,
    as_json: bool,
    target: str | None,
    scheduler: str | None = None,
    suggest: bool = True,
) -> int:
    """Decide every claim of a file, show each answer as it comes, and return the exit status."""
    tasks = read_tasks(file, given, path)
    seconds = parse_seconds(limit)
    counts = dict.fromkeys([*(verdict.value for verdict in Verdict), "not read"], 0)
    status = 0
    colour, columns = colour_wanted() and target is None, _columns(target)
    with _shown_by(target) as show:
        answers = _with_known_names(_answers(tasks, seconds, scheduler))
        if suggest:
            from tresym.repair import suggested

            answers = suggested(answers)
        for task, found in answers:
            if isinstance(found, InputError):
                if task.claim.startswith("\\documentclass"):
                    raise InputError(f"{file}: {MANUSCRIPT}") from None
                print(f"tresym: {file}, line {task.line}: {found}", file=sys.stderr)
                status = _worse(status, BAD)
                counts["not read"] += 1
                if as_json:
                    show(_bad_line(task, found))
            else:
                status = _worse(status, _STATUS.get(found.verdict, 0))
                counts[found.verdict.value] += 1
                show(json_line(found.as_json()) if as_json else answer_text(found, colour, columns))
            show_progress(f"{sum(counts.values())} claims")
    summary = ", ".join(f"{count} {name}" for name, count in counts.items() if count)
    print(f"{sum(counts.values())} claims: {summary}", file=sys.stderr)
    return status


def _answers(tasks: Iterator[Task], limit: float, scheduler: str | None) -> Answers:
    """Yield every task with its answer, decided on all cores or by a scheduler's workers."""
    from tresym.checking.time_limited import check_all, check_by

    if scheduler is None:
        yield from check_all(tasks, limit)
        return
    from tresym.sweep.workers import cluster

    with cluster(scheduler) as workers:
        yield from check_by(workers.in_order, tasks, limit)


def _worse(*statuses: int) -> int:
    """Return the most important of several exit statuses."""
    return next((status for status in (BAD, REFUTED, UNDECIDED) if status in statuses), 0)


def _with_known_names(answers: Answers) -> Answers:
    """Yield the answers, with an error for each claim that holds a name that is no variable."""
    from tresym.reals.language.readings import need_variables

    for task, found in answers:
        try:
            need_variables(task.claim, task.given, task.path)
        except InputError as error:
            yield task, error
        else:
            yield task, found


def read_tasks(file: str, given: str, path: str | None) -> Iterator[Task]:
    """Yield the claims of a file, one per line; ``#`` begins a comment.

    Of a program only the comments ``tresym: CLAIM`` are read.

    Args:
        file: its path; ``-`` is standard input.
        given, path: conditions and path of every claim.

    Raises:
        InputError: the file cannot be read, or contains no claim.
    """
    from tresym.checking.time_limited import Task

    code = is_code(file)
    lines = claims_in_comments(file, _lines(file)) if code else _lines(file)
    tasks = (
        Task(claim, given, path, number)
        for number, line in enumerate(lines, 1)
        if (claim := line.split("#")[0].strip())
    )
    first = next(tasks, None)
    if first is None:
        how = f"write it in a comment: {how_to_write(file)}" if code else "write one per line"
        raise InputError(f"{file}: it contains no claim; {how}")
    return chain([first], tasks)


def _lines(file: str) -> Iterator[str]:
    """Yield the lines; neither a long file nor a long line is ever held in memory."""
    if file == "-" and sys.stdin is None:
        raise InputError("there is no standard input to read claims from")
    name: str | int = sys.stdin.fileno() if file == "-" else file
    if file != "-":
        say_if_waiting(file, "writer")
    try:
        with open(name, encoding="utf-8-sig", errors="replace", closefd=file != "-") as stream:
            while line := stream.readline(LONGEST_LINE):
                rest = line
                for _ in range(LONGEST_REST // LONGEST_LINE):
                    if not rest or rest.endswith("\n"):
                        break
                    rest = stream.readline(LONGEST_LINE)
                else:
                    raise InputError(f"{file}: a line is too long")
                if "\0" in line:
                    raise InputError(f"{file}: this is a binary file, not a list of claims")
                yield line.removesuffix("\n")  # not splitlines, which counts as no editor does
    except FileNotFoundError:
        raise InputError(f"{file}: no such file") from None
    except OSError as error:
        raise InputError(f"{file}: cannot be read ({error.strerror})") from None


def answer_text(answer: Answer, colour: bool = False, columns: int = 0) -> str:
    """Return an answer as text: the verdict and one sentence, then the details, one a line.

    Args:
        answer: the answer.
        colour: whether for a terminal with colours.
        columns: where lines are wrapped; 0 for nowhere.
    """
    from tresym.checking.towards_the_end import in_a_line

    sentence, rows = answer.in_text()
    if answer.verdict is Verdict.REFUTED and answer.witness and (seen := in_a_line(answer)):
        rows = [row for row in rows if row[0] not in ("witness", "left side", "right side")]
        place = next((n for n, row in enumerate(rows) if row[0] == "instead"), len(rows))
        rows.insert(place, ("on the way", seen))
    edit = answer.instead[0].edit if answer.instead else ""
    if edit.startswith("the coefficient of "):  # the failure at a glance
        place = next(
            (n for n, row in enumerate(rows) if row[0] in ("note", "on the way")), len(rows)
        )
        rows.insert(place, ("because", sentence))
        sentence = edit
    if answer.line is not None:
        rows.insert(0, ("line", str(answer.line)))
    seconds = answer.seconds
    time = f"{1000 * seconds:.3g} ms" if seconds < 0.9995 else f"{seconds:.3g} s"
    rows.append(("time", time))
    from tresym.report.typesetting.plain_text import in_lines

    said = [(f"{answer.verdict.value}: ", bold(f"{answer.verdict.value}", colour) + ": ", sentence)]
    said += [(f"  {n:<11}", f"  {dim(f'{n:<11}', colour)}", t) for n, t in rows]
    lines: list[str] = []
    for plain, shown, text in said:
        first, *more = in_lines(text, plain, " " * 13, columns) if columns else [plain + text]
        lines += [shown + first.removeprefix(plain), *more]
    return "\n".join(lines) + "\n"


def _columns(target: str | None) -> int:
    """Return where lines are wrapped: at the width of a terminal, and nowhere in a file."""
    wide = target is None and sys.stdout is not None and sys.stdout.isatty()
    return get_terminal_size().columns if wide else 0


def _bad_line(task: Task, error: InputError) -> str:
    from tresym.reals.decisions.answer import Answer

    keys = Answer(Verdict.UNDECIDED, "").as_json()
    value = dict.fromkeys(keys) | {
        "statement": str(task.claim)[:400],
        "line": task.line,
        "error": str(error),
    }
    return json_line(value)


@contextmanager
def _shown_by(target: str | None) -> Iterator[Callable[[str], object]]:
    """Yield a function that prints a text, or writes it to the file ``target``."""
    if target is None:
        yield partial(print, end="", flush=True)
        return
    with (
        writing(target) as aside,
        open(aside, "w", encoding="utf-8", errors="backslashreplace", newline="") as file,
    ):
        yield file.write
