"""``tresym table``: print certified tables, by name, of a file of claims, or of two expressions."""

from __future__ import annotations

import argparse
from functools import partial
from typing import TYPE_CHECKING

from tresym.commands import claims_file
from tresym.commands.parser import (
    UNEXPECTED,
    Commands,
    add_options,
    add_output,
    deliver,
    json_line,
)
from tresym.reals.numbers.exact import InputError, quoted

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from tresym.accuracy.error_table import Cell, Question
    from tresym.accuracy.values import Exact
    from tresym.reals.language.expression import Expr

TABLES = "objects, errors, constants, slope, thresholds, routes"


def add(commands: Commands) -> None:
    """Add `tresym table` to the command line."""
    parser = commands.add_parser(
        "table",
        help=f"certified tables: EXACT APPROX, or {TABLES}",
        description="Compare an approximate expression with the exact expression in a limit "
        "process: certified values and errors, empirical order, verdict on the order,"
        " smallest constant. Or print a certified table by its name, or a table that "
        "a file of claims defines.",
        epilog="Example: tresym table 'root(y - e*sin(y) - 1, y, 0, 4)' '1 + e*sin(1)' "
        "--as 'e -> 0+' --order 'e**2'. Exit status: 0, 1 if a printed cell "
        "is wrong, 2 for bad input.",
    )
    parser.add_argument(
        "name",
        nargs="?",
        metavar="EXACT | NAME | FILE.tresym",
        help=f"an expression; {TABLES}; a file of claims",
    )
    parser.add_argument(
        "label",
        nargs="?",
        metavar="APPROX | LABEL",
        help="an expression, or your own function as FILE.py:FUNCTION, whose errors are sampled at "
        "the points of --at; a claim of the file",
    )
    parser.add_argument(
        "--as",
        dest="tends",
        metavar="PATH",
        help="the limit process (path): x -> 0+, 0-, 0, 1/2, oo, -oo",
    )
    add_options(
        parser,
        ("--at POINTS", "exact values of the variable that tends to the limit point: 1/10,1/100"),
        ("--given CONDITIONS", "'M == 1', or an equation that defines an unknown of EXACT"),
        ("--digits N", "digits of the values (15)"),
        ("--order GAUGE", "the comparison function; guessed from the last rows if not given"),
        ("--on REGION", "the region for which the constant is computed: 0 < e <= 1/2"),
        ("--against FILE.csv", "check the printed cells of a file against the formula EXACT"),
        ("--column NAME", "with --against: the column that the formula gives"),
        ("--scheduler ADDRESS", "the workers of a Dask scheduler, as tcp://HOST:PORT"),
    )
    parser.add_argument(
        "--rounded",
        action="store_true",
        help="with --against: the printed arguments are rounded numbers (they count as exact)",
    )
    parser.add_argument(
        "--format",
        choices=("text", "markdown", "latex", "csv", "html"),
        default="text",
        help="default: text",
    )
    add_output(parser)


def run(args: argparse.Namespace) -> int:
    """Run the command and return its exit status."""
    if args.rounded and args.against is None:
        raise InputError("table: --rounded goes with --against")
    from tresym.accuracy.sampled import names_function

    if args.name is None:
        raise InputError(f"table: give two expressions, or one of {TABLES}")
    if args.against is not None:
        return check_printed(args)
    if args.label is not None and any(map(names_function, (args.name, args.label))):
        return sample(args)
    if args.name.endswith(claims_file.ENDING):
        if args.label is None:
            raise InputError("table: name a claim of the file: tresym table FILE.tresym LABEL")
        return claims_file.table(args.name, args.label, args.format, args.json, args.path)
    if args.label is not None:
        return compare(args)
    if args.tends is not None:
        raise InputError("table: give two expressions: tresym table EXACT APPROX --as PATH")
    from tresym.ledger.paper import racket

    tables = racket().tables()
    found = tables.table(args.name)
    if args.json:
        import json

        deliver(json.dumps(found._asdict(), ensure_ascii=False, indent=1) + "\n", args.path)
        return 0
    deliver(tables.written(found, args.format), args.path)
    return 0


def check_printed(args: argparse.Namespace) -> int:
    """Check the printed cells of a file against a formula, and return the exit status."""
    from tresym.accuracy import table
    from tresym.accuracy.printed_tables import against

    if args.label is not None or args.tends is not None:
        raise InputError("table: --against takes one formula and no --as")
    found = against(args.against, args.name, args.column, args.rounded)
    text = json_line(found.as_json()) if args.json else table.written(found.table(), args.format)
    deliver(text, args.path)
    return 0 if found else UNEXPECTED


def compare(args: argparse.Namespace) -> int:
    """Print the error table of two expressions, and return the exit status."""
    from tresym.accuracy.error_table import DIGITS, error_table

    if args.tends is None:
        raise InputError("table: two expressions need a limit process, such as --as 'x -> 0+'")
    points = [part for part in (args.at or "").split(",") if part.strip()]
    found = error_table(
        args.name,
        args.label,
        args.tends,
        [point.strip() for point in points],
        args.given or "",
        DIGITS if args.digits is None else digits_of(args.digits),
        args.order,
        args.on or "",
        rows=partial(cells, scheduler=args.scheduler),
    )
    deliver(json_line(found.as_json()) if args.json else found.written(args.format), args.path)
    return 0


def sample(args: argparse.Namespace) -> int:
    """Print the sampled errors of a function of the user, and return the exit status."""
    from tresym.accuracy.error_table import points_of
    from tresym.accuracy.sampled import DIGITS, names_function, sampled_table
    from tresym.reals.language.paths import read_path

    if args.order is not None or args.on is not None or args.scheduler is not None:
        raise InputError(
            "table: the errors of a function of your own are sampled at points, so --order, --on "
            "and --scheduler do not apply; leave them out"
        )
    function, exact = args.name, args.label
    if not names_function(function):
        function, exact = exact, function
    if names_function(exact):
        raise InputError("table: compare your function with an expression, such as 'erf(x)'")
    at: list[Exact] = [part.strip() for part in (args.at or "").split(",") if part.strip()]
    path = None if args.tends is None else read_path(args.tends)
    if not at and path is not None:
        at = list(points_of(path))
    digits = DIGITS if args.digits is None else digits_of(args.digits)
    name = "" if path is None else path.name
    found = sampled_table(function, exact, at, name, args.given or "", digits)
    deliver(json_line(found.as_json()) if args.json else found.written(args.format), args.path)
    return 0


def digits_of(text: str) -> int:
    """Return the number of --digits.

    Raises:
        InputError: it is no integer.
    """
    if not (text.isascii() and text.isdecimal() and len(text) < 7):
        raise InputError(f"--digits: {quoted(text)} is not an integer from 1 to 10000")
    return int(text)


FEW_CELLS = 16
"""So many cells are computed in this process; more are spread over the cores."""


def cells(
    question: Question, points: Sequence[Expr], digits: int, scheduler: str | None = None
) -> Iterator[Cell | InputError]:
    """Yield the cells of a table, on all cores or by a scheduler's workers, with progress."""
    from contextlib import ExitStack

    from tresym.accuracy.cells import computed, decoded, encoded, kept_cells
    from tresym.output import show_progress
    from tresym.reals.processes import cores
    from tresym.sweep.workers import cluster, processes

    asked = [encoded(question, x, digits) for x in points]
    with ExitStack() as opened:
        many = len(points) > FEW_CELLS or scheduler is not None
        store = opened.enter_context(kept_cells()) if many else None
        known = {} if store is None else {n: store.get(one) for n, one in enumerate(asked)}
        missing = [one for n, one in enumerate(asked) if known.get(n) is None]
        if scheduler is not None:
            workers = opened.enter_context(cluster(scheduler))
            results = workers.in_order(computed, iter(missing))
        elif many and cores() > 1 and missing:
            workers = opened.enter_context(processes(cores()))
            results = workers.in_order(computed, iter(missing))
        else:
            results = map(computed, missing)
        for n, one in enumerate(asked):
            found: Cell | InputError | None = known.get(n)
            if found is None:
                found = decoded(next(results))
                if store is not None and not isinstance(found, InputError):
                    store.put(one, found)
            show_progress(f"{n + 1} of {len(points)} cells")
            yield found
    show_progress("")
