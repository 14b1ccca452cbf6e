"""``tresym chart``: draw a chart of saved measurements."""

from __future__ import annotations

import argparse

from tresym.commands import claims_file
from tresym.commands.parser import PICTURE_PATH, Commands, add_options, deliver, deliver_picture
from tresym.reals.numbers.exact import InputError


def add(commands: Commands) -> None:
    """Add `tresym chart` to the command line."""
    parser = commands.add_parser(
        "chart",
        help="a chart of saved measurements",
        description="Draw errors of your own approximations (chart error EXACT APPROX ...), time "
        "against true digits (chart work-precision EXPRESSION), the digits that "
        "double precision loses (chart stability EXPRESSION), or one chart of the "
        "measurements stored by tresym bench --save. Without a name, list these "
        "charts.",
        epilog="Needs matplotlib: pip install 'tresym[docs]'.",
    )
    parser.add_argument(
        "name",
        nargs="?",
        metavar="NAME | FILE.tresym",
        help="a chart, such as work-precision; a file of claims",
    )
    parser.add_argument(
        "more",
        nargs="*",
        metavar="EXPRESSION | LABEL",
        help="the expressions to compare, or the label of a claim of the file",
    )
    parser.add_argument("--as", dest="tends", metavar="PATH", help="error: x -> 0+, oo, 1/2")
    add_options(
        parser,
        ("--at POINTS", "error: values of the variable that tends to the limit point: 1/10,1/100"),
        ("--given CONDITIONS", "parameters: 'M == 1'; stability: the region '0 < x <= 1'"),
        ("--order GAUGE", "error: the comparison function"),
        ("--on REGION", "error: the region for which the constant is computed"),
    )
    parser.add_argument(
        "--mine",
        action="append",
        default=[],
        metavar="MODULE:FUNCTION",
        help="your own function, also FILE.py:FUNCTION, called with the parameters by name",
    )
    parser.add_argument(
        "--from", dest="source", metavar="FILE", help="a saved measurement (default: the one here)"
    )
    parser.add_argument("-o", dest="path", metavar="PATH", help=PICTURE_PATH)


def run(args: argparse.Namespace) -> int:
    """Run the command and return its exit status."""
    label = args.more[0] if len(args.more) == 1 else None
    if args.name is not None and args.name.endswith(claims_file.ENDING):
        if label is None:
            raise InputError("chart: name a claim of the file: tresym chart FILE.tresym LABEL")
        return claims_file.chart(args.name, label, args.path)
    if args.name in OWN and (args.more or args.name != "work-precision"):
        return OWN[args.name](args)
    if args.more:
        raise InputError(
            "chart: a label is for a file of claims: tresym chart FILE.tresym LABEL; expressions "
            f"are for {', '.join(OWN)}"
        )
    from tresym.report import charts

    if args.name is None:
        names = (f"{name:<16} {chart.title}\n" for name, chart in charts.CHARTS.items())
        deliver("".join(names), args.path)
    else:
        deliver_picture(lambda kind: charts.picture(args.name, args.source, kind), args.path)
    return 0


def error(args: argparse.Namespace) -> int:
    """Draw the errors of one or more approximations."""
    from tresym.report.charts import own

    if len(args.more) < 2 or args.tends is None:
        raise InputError("chart: write tresym chart error EXACT APPROX ... --as PATH")
    exact, *approximations = args.more
    points = [part.strip() for part in (args.at or "").split(",") if part.strip()]
    draw = own.error_chart(
        exact, approximations, args.tends, points, args.given or "", args.order, args.on or ""
    )
    deliver_picture(draw, args.path)
    return 0


def work_precision(args: argparse.Namespace) -> int:
    """Draw time against true digits for an expression."""
    from tresym.accuracy.work_precision import work_precision as measured
    from tresym.report.charts import own

    points = measured(_one(args), _values(args.given or ""), args.mine)
    title = f"Time against true digits: {args.more[0]}"
    shown = title if len(title) <= 80 else title[:77] + "…"
    deliver_picture(
        lambda kind: own.saved(
            lambda: own.work_precision(points, shown),
            title,
            own.work_precision_caption(points),
            kind,
        ),
        args.path,
    )
    return 0


def stability(args: argparse.Namespace) -> int:
    """Draw the digits that double precision loses."""
    from tresym.accuracy.stability import stability as measured
    from tresym.report.charts import own

    if args.given is None:
        raise InputError("chart: stability needs a region, as in --given '0 < x <= 1'")
    if len(args.mine) > 1:
        raise InputError("chart: stability takes one function of your own")
    found = measured(_one(args), args.given, args.mine[0] if args.mine else None)
    caption = own.stability_caption(found)
    deliver_picture(
        lambda kind: own.saved(lambda: own.stability(found), "Digits lost", caption, kind),
        args.path,
    )
    return 0


def _one(args: argparse.Namespace) -> str:
    if len(args.more) != 1:
        raise InputError(f"chart: {args.name} takes one expression")
    return str(args.more[0])


def _values(given: str) -> dict[str, str]:
    """Return the parameters of ``x == 1/3, M == 1``."""
    found = {}
    for part in filter(None, (part.strip() for part in given.split(","))):
        name, equals, x = part.replace("==", "=").partition("=")
        if not equals or not name.strip().isidentifier():
            raise InputError(f"chart: write parameters as in --given 'x == 1/3', not {part!a}")
        found[name.strip()] = x.strip()
    return found


OWN = {"error": error, "work-precision": work_precision, "stability": stability}
"""The charts of a user's own expressions."""
