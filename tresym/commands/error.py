"""``tresym error``: the largest error of an approximation on a region, from both sides."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tresym.commands.parser import (
    UNEXPECTED,
    Commands,
    add_options,
    add_output,
    deliver,
    deliver_picture,
    json_line,
)
from tresym.reals.numbers.exact import InputError

if TYPE_CHECKING:
    import argparse

UNDECIDED = 3


def add(commands: Commands) -> None:
    """Add `tresym error` to the command line."""
    parser = commands.add_parser(
        "error",
        help="the largest error of an approximation on a region, certified from both sides",
        description="Enclose the largest absolute and the largest relative error of an "
        "approximation on a region from both sides, and tell where it is reached. The errors of "
        "rounding in a program are not part of it; for a Python function they are bounded "
        "beside it, or sampled, and it is said which.",
        epilog="Example: tresym error 'sin(x)' '[0, 0.9999966, 0, -0.16664824, 0, 0.00830629, 0, "
        "-0.00018363]' --on 'abs(x) <= pi/2'. Exit status: 0, 3 if no bound is found, 2 for bad "
        "input.",
    )
    parser.add_argument("exact", nargs="?", metavar="EXACT", help="a function of one variable")
    parser.add_argument(
        "approx",
        nargs="?",
        metavar="APPROX",
        help="an expression, the coefficients [c0, c1, ...] of a polynomial, lowest power first, "
        "or FILE.py:FUNCTION, a Python function, which is read and not run",
    )
    add_options(
        parser,
        ("--on REGION", "the region: 0 <= x <= 1, abs(x) <= pi/4, x >= 1"),
        ("--chart FILE", "draw the error on the region as svg, pdf or png"),
        ("-f FILE", "a list of published approximations with the bounds that are printed"),
    )
    parser.add_argument(
        "--stored",
        choices=("exact", "double", "single"),
        default="exact",
        help="how the decimals of APPROX are read: as exact numbers (default), or as the nearest "
        "numbers of binary64 or binary32, with which a program computes",
    )
    parser.add_argument(
        "--format",
        choices=("text", "markdown", "latex", "csv", "html"),
        default="text",
        help="with -f; default: text",
    )
    add_output(parser)


def run(args: argparse.Namespace) -> int:
    """Run the command and return its exit status."""
    if args.f is not None:
        return _of_list(args)
    from tresym.accuracy.largest_error import largest_error

    if args.exact is None or args.approx is None:
        raise InputError("error: give a function and an approximation, or -f FILE")
    if args.on is None:
        raise InputError("error: give a region, such as --on '0 <= x <= 1'")
    found = largest_error(args.exact, args.approx, args.on, args.stored)
    if args.chart is not None:
        from tresym.report.charts.own import error_on_region

        deliver_picture(error_on_region(args.exact, args.approx, args.on, found), args.chart)
    deliver(json_line(found.as_json()) if args.json else f"{found}\n", args.path)
    return 0 if found else UNDECIDED


def _of_list(args: argparse.Namespace) -> int:
    """Check the printed bounds of a list; 1 if one is exceeded, 3 if one is open."""
    from tresym.accuracy.approximation_list import EXCEEDED, OPEN, judge, read_list, table
    from tresym.accuracy.table import written

    if args.exact is not None or args.on is not None or args.chart is not None:
        raise InputError("error: -f FILE takes no expressions and draws no chart")
    try:
        with open(args.f, encoding="utf-8") as file:
            text = file.read()
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(f"{args.f}: {error}") from None
    rows = [judge(one) for one in read_list(text)]
    found = table(rows)
    shown = json_line(found._asdict()) if args.json else written(found, args.format)
    deliver(shown, args.path)
    verdicts = {one.verdict for one in rows}
    return UNEXPECTED if EXCEEDED in verdicts else UNDECIDED if OPEN in verdicts else 0
