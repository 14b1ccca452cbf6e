"""``tresym sweep``: compute the flip of many bodies into one table."""

from __future__ import annotations

import argparse
import functools

from tresym.commands.parser import UNEXPECTED, Commands, deliver, deliver_json
from tresym.reals.numbers.exact import InputError


def add(commands: Commands) -> None:
    """Add `tresym sweep` to the command line."""
    parser = commands.add_parser(
        "sweep",
        help="compute the flip of many bodies into one table",
        description="Compute the flip defect of every row of a grid or of a CSV file, and the "
        "errors of the formulas, into an SQLite table. Run the same command again to continue a "
        "sweep that was interrupted.",
        epilog="VALUES: 0.1,1/3 or LOW:HIGH:COUNT, with log after it for equal ratios. Exit "
        "status: 1 if a row has a problem; the table shows the line and the reason.",
    )
    parser.add_argument("-o", dest="path", metavar="TABLE", required=True, help="the SQLite file")
    parser.add_argument("--csv", metavar="FILE", help="columns a, b or I1, I2, I3 or body; gamma")
    parser.add_argument("--a", metavar="VALUES", help="the grid's a = I2/I1 - 1")
    parser.add_argument("--b", metavar="VALUES", help="the grid's b = 1 - I2/I3")
    parser.add_argument("--gamma", metavar="VALUES", help="the grid's gamma (default: 0)")
    digits = parser.add_mutually_exclusive_group()
    digits.add_argument("--digits", default="50", metavar="N", help="1 to 10000 (default: 50)")
    digits.add_argument(
        "--float64", action="store_true", help="use floating point: fast, but not certified"
    )
    where = parser.add_mutually_exclusive_group()
    where.add_argument("--workers", metavar="N", help="number of processes (default: one per core)")
    where.add_argument(
        "--scheduler", "--dask", metavar="ADDRESS", help="use the workers of this Dask scheduler"
    )
    parser.add_argument(
        "--export", metavar="PATH", help="also export the rows to a .csv or .parquet file"
    )
    parser.add_argument("--json", action="store_true", help="print JSON")


def run(args: argparse.Namespace) -> int:
    """Run the command and return its exit status."""
    from tresym import sweep
    from tresym.racket.flip.model_selection import parse_digits
    from tresym.reals.processes import parse_workers
    from tresym.sweep.run import summary_text, to_stderr

    if args.path.lower().endswith((".csv", ".parquet", ".json", ".txt")):
        raise InputError(
            f"{args.path}: a sweep stores its rows in an SQLite file, so that it can be continued; "
            f"write -o TABLE.sqlite --export {args.path}"
        )
    grid = (args.a, args.b, args.gamma)
    source: sweep.Source
    if args.csv is not None and grid == (None, None, None):
        source = sweep.CsvFile(args.csv)
    elif args.csv is None and args.a is not None and args.b is not None:
        source = sweep.Grid.read(args.a, args.b, "0" if args.gamma is None else args.gamma)
    else:
        raise InputError(
            "sweep: give either --csv FILE, or --a and --b (and --gamma), each as 0.1,1/3 or as "
            "LOW:HIGH:COUNT"
        )
    digits = None if args.float64 else parse_digits(args.digits)
    workers = None
    if args.scheduler is not None:
        workers = functools.partial(sweep.cluster, args.scheduler)
    elif args.workers is not None:
        workers = functools.partial(sweep.processes, parse_workers(args.workers))
    found = sweep.sweep(source, args.path, digits, workers, export=args.export, notice=to_stderr)
    if args.json:
        deliver_json(found.as_json(), None)
    else:
        deliver(summary_text(found), None)
    return UNEXPECTED if found.bad else 0
