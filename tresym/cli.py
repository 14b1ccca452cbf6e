"""The ``tresym`` command. Each sub-command is a parser and a function that imports what it needs.

Exit status: 0 as expected; 1 a verdict unexpected or undecided; 2 bad input, with one line on
standard error; 130 interrupted.
"""

from __future__ import annotations

import argparse
import functools
import os
import re
import sys
from typing import TYPE_CHECKING, Any, NoReturn

import tresym
from tresym.reals.numbers.exact import InputError

if TYPE_CHECKING:
    from collections.abc import Callable

    from tresym.racket.body import Shape

    Commands = argparse._SubParsersAction["Parser"]

UNEXPECTED = 1
BAD_INPUT = 2
INTERRUPTED = 130

_OPTION = re.compile(r"-[hof]|--")


class Parser(argparse.ArgumentParser):
    """argparse, with its complaints as one line."""

    def error(self, message: str) -> NoReturn:
        """Raise the complaint as bad input; what it quotes may be long, or not printable."""
        raise InputError(f"{_one_line(message, 200)} (see {self.prog} --help)")


def _one_line(text: str, longest: int) -> str:
    """``text`` as it may be shown: what it quotes may be long, or not printable."""
    shown = text if text.isprintable() else ascii(text)[1:-1]
    return shown if len(shown) <= longest else shown[: longest - 3] + "..."


def build_parser() -> Parser:
    """The parser of the whole command line."""
    parser = Parser(
        prog="tresym",
        description="The tennis racket effect, verified: proofs, certified numbers, figures.",
        allow_abbrev=False,
    )
    parser.add_argument("--version", action="version", version=f"tresym {tresym.__version__}")
    commands = parser.add_subparsers(title="commands", metavar="COMMAND", required=True)
    _add_verify(commands)
    _add_derive(commands)
    _add_table(commands)
    _add_docs(commands)
    _add_flip(commands)
    _add_check(commands)
    _add_audit(commands)
    _add_bench(commands)
    _add_sweep(commands)
    _add_figure(commands)
    _add_chart(commands)
    return parser


def _add_verify(commands: Commands) -> None:
    parser = commands.add_parser(
        "verify",
        help="a verdict on every claim, or on some and all they rest on",
        description="Judge the paper's statements: PROVED, ENCLOSED, REFUTED or UNDECIDED.",
        epilog="Exit status 1 when a verdict is not the expected one, or when a mutant holds.",
        allow_abbrev=False,
    )
    parser.add_argument("labels", nargs="*", metavar="LABEL", help="claims, such as eq_gamma")
    parser.add_argument("--graph", action="store_true", help="what rests on what, in Mermaid")
    parser.add_argument(
        "--mutants", action="store_true", help="judge false variants of the claims: none may hold"
    )
    parser.add_argument(
        "--full", action="store_true", help="find the stored box proofs anew instead of re-checking"
    )
    parser.add_argument(
        "--save-certificates", action="store_true", help="with --full, store what was found"
    )
    parser.add_argument("--workers", metavar="N", help="processes (default: one a core)")
    _add_output(parser)
    parser.set_defaults(run=_verify)


def _verify(args: argparse.Namespace) -> int:
    if args.save_certificates and not args.full:
        raise InputError("--save-certificates stores what --full finds: give both")
    if not args.full:
        return _verify_claims(args)
    from tresym.ledger.evidence.balls import finding_anew

    if args.save_certificates:
        from tresym.ledger.certificates import checkout_file

        checkout_file()  # refused before the search, not after it
    with finding_anew():
        return _verify_claims(args)


def _verify_claims(args: argparse.Namespace) -> int:
    from tresym.ledger import verification

    labels = tuple(args.labels)
    workers = _workers(args.workers)
    if args.graph:
        _deliver(verification.graph(labels), args.path)
        return 0
    if args.mutants:
        return _verify_mutants(labels, args)
    if args.json or args.path is not None:
        import json

        report = verification.verify(labels, workers=workers)
        _deliver(json.dumps(report.as_json(), ensure_ascii=False, indent=1) + "\n", args.path)
    else:
        from rich.console import Console

        from tresym.report.terminal import show_verification

        report = show_verification(labels, Console(highlight=False), workers)
    if args.save_certificates:
        verification.save_certificates(report)
    return 0 if report.as_expected else UNEXPECTED


def _workers(text: str | None) -> int:
    """The number of processes that ``text`` asks for; one a core if nothing is asked."""
    from tresym.reals.processes import cores, parse_workers

    return cores() if text is None else parse_workers(text)


def _verify_mutants(labels: tuple[str, ...], args: argparse.Namespace) -> int:
    from tresym.ledger import verification

    if args.json or args.path is not None:
        import json

        report = verification.verify_mutants(labels)
        _deliver(json.dumps(report.as_json(), ensure_ascii=False, indent=1) + "\n", args.path)
    else:
        from rich.console import Console

        from tresym.report.terminal import show_mutants

        report = show_mutants(labels, Console(highlight=False))
    return UNEXPECTED if report.survivors or report.stopped else 0


def _add_derive(commands: Commands) -> None:
    parser = commands.add_parser(
        "derive",
        help="the derivation in LaTeX: the whole article, or one statement to paste",
        description="Without labels, one article; with labels, each statement and its chain.",
        epilog="Exit status 1, and nothing printed, when a claim named is refuted.",
        allow_abbrev=False,
    )
    parser.add_argument("labels", nargs="*", metavar="LABEL", help="claims, such as eq_gamma")
    parser.add_argument(
        "--refuted",
        action="store_true",
        help="print refuted claims too, marked, with what is true instead",
    )
    parser.add_argument("-o", dest="path", metavar="PATH", help="write to a file instead")
    parser.set_defaults(run=_derive)


def _derive(args: argparse.Namespace) -> int:
    from tresym.ledger.verification import verify
    from tresym.reals.processes import cores
    from tresym.report.pages import derivation

    report = verify(args.labels, workers=cores())
    asked = [row for row in report.rows if row.requested]
    refused = derivation.refused(asked) if args.labels and not args.refuted else ()
    if refused:
        print("\n".join(refused), file=sys.stderr)
        return UNEXPECTED
    statements = map(derivation.fragment, asked)
    text = "\n".join(statements) if args.labels else derivation.article(report)
    _deliver(text, args.path)
    return 0 if report.as_expected else UNEXPECTED


def _add_table(commands: Commands) -> None:
    parser = commands.add_parser(
        "table",
        help="certified tables: objects, errors, constants, slope, thresholds, routes",
        description="A table of certified numbers, for the terminal, in Markdown or in LaTeX.",
        allow_abbrev=False,
    )
    parser.add_argument("name", metavar="NAME", help="objects, errors, constants, slope, …")
    parser.add_argument(
        "--format", choices=("text", "markdown", "latex"), default="text", help="default: text"
    )
    _add_output(parser)
    parser.set_defaults(run=_table)


def _table(args: argparse.Namespace) -> int:
    from tresym.report.pages import tables

    found = tables.table(args.name)
    if args.json:
        import json

        _deliver(json.dumps(found._asdict(), ensure_ascii=False, indent=1) + "\n", args.path)
        return 0
    _deliver(tables.written(found, args.format), args.path)
    return 0


def _add_docs(commands: Commands) -> None:
    parser = commands.add_parser(
        "docs",
        help="build the generated documents, or check that none is stale",
        description="Write docs/generated from the ledger and the tables.",
        allow_abbrev=False,
    )
    parser.add_argument("--check", action="store_true", help="write nothing; exit 1 when stale")
    parser.set_defaults(run=_docs)


def _docs(args: argparse.Namespace) -> int:
    from tresym.report.pages import documents

    if args.check:
        stale = documents.stale()
        print("\n".join(f"stale: {path}" for path in stale) or "every document is up to date")
        return UNEXPECTED if stale else 0
    print("\n".join(documents.build()))
    return 0


def _add_flip(commands: Commands) -> None:
    parser = commands.add_parser(
        "flip",
        help="the flip of one body, certified",
        description="How far one full turn of a freely rotating body is from a perfect flip.",
        epilog="Numbers are exact: 0.0629, 1e-4 or 16380/1210; angles also pi/2 or -3*pi/4.",
        allow_abbrev=False,
    )
    body = parser.add_mutually_exclusive_group(required=True)
    body.add_argument("--body", metavar="NAME", help="a body of the paper, such as str or book")
    body.add_argument(
        "--inertia", nargs=3, metavar=("I1", "I2", "I3"), help="moments, smallest first"
    )
    body.add_argument("--shape", nargs=2, metavar=("A", "B"), help="a = I2/I1 - 1, b = 1 - I2/I3")
    parser.add_argument("--digits", default="50", metavar="N", help="1 to 10000 (default: 50)")
    parser.add_argument("--rung", metavar="NAME", help="force one model of the ladder")
    where = parser.add_mutually_exclusive_group()
    where.add_argument(
        "--gamma",
        metavar="G",
        help="distance from the separatrix, -b to a (default: 0); on a rigid body a larger one "
        "always flips further",
    )
    where.add_argument("--psi0", metavar="P", help="start at this psi instead, in radians")
    how = parser.add_mutually_exclusive_group()
    how.add_argument("--rate", metavar="V", help="with --psi0: dpsi/dphi at the start")
    how.add_argument("--theta0", metavar="T", help="with --psi0: theta at the start, in radians")
    parser.add_argument(
        "--precession", metavar="ANGLE", help="with --psi0: how far phi goes (default: 2*pi)"
    )
    _add_output(parser)
    parser.set_defaults(run=_flip)


def _add_check(commands: Commands) -> None:
    parser = commands.add_parser(
        "check",
        help="a claim of your own: an identity, an inequality, an order",
        description="Decide claims such as 'diff(F, x) == f', 'exp(x) >= 1 + x' or, with a path, "
        "'sin(x) == x + O(x**3)': PROVED, ENCLOSED, REFUTED or UNDECIDED, and why.",
        epilog="Exit status 0 when it holds, 1 when refuted, 3 when undecided, 2 when not read; "
        "of many claims the first of 2, 1, 3 that occurs.",
        allow_abbrev=False,
    )
    parser.add_argument("claim", nargs="?", metavar="CLAIM", help="text or LaTeX")
    parser.add_argument("--given", default="", metavar="CONDITIONS", help="a > 0, 0 < b <= 1")
    parser.add_argument("--as", dest="tends", metavar="PATH", help="x -> 0+, 0-, 0, 1/2, oo, -oo")
    parser.add_argument(
        "-f", dest="file", metavar="FILE", help="one claim a line; # comments; - reads input"
    )
    parser.add_argument("--limit", default="5", metavar="SECONDS", help="for each claim (5)")
    _add_output(parser)
    parser.set_defaults(run=_check)


def _check(args: argparse.Namespace) -> int:
    from tresym.report import check

    if (args.claim is None) == (args.file is None):
        raise InputError("check: give either one claim or -f FILE")
    if args.file is None:
        return check.one(args.claim, args.given, args.tends, args.limit, args.json, args.path)
    return check.many(args.file, args.given, args.tends, args.limit, args.json, args.path)


def _add_audit(commands: Commands) -> None:
    parser = commands.add_parser(
        "audit",
        help="the displays of the paper's LaTeX against the claims",
        description="Name the claims that answer each display, theorem, table and figure of the "
        "paper, and compare what they say with its LaTeX.",
        epilog="Exit status 1 unless all of the paper is covered, unaltered and rightly copied.",
        allow_abbrev=False,
    )
    parser.add_argument("paper", metavar="PAPER.tex", help="the LaTeX source of the paper")
    _add_output(parser)
    parser.set_defaults(run=_audit)


def _audit(args: argparse.Namespace) -> int:
    from pathlib import Path

    from tresym import proofs
    from tresym.ledger import audit

    index = audit.load_index(Path(proofs.__file__).with_name("index.json"))
    found = audit.audit(Path(args.paper), proofs.claims(), index)
    if args.json or args.path is not None:
        import json

        _deliver(json.dumps(found.as_json(), ensure_ascii=False, indent=1) + "\n", args.path)
    else:
        from rich.console import Console

        from tresym.report.audit import show_audit

        show_audit(found, Console(highlight=False))
    return 0 if found.complete else UNEXPECTED


def _add_output(parser: Parser) -> None:
    parser.add_argument("--json", action="store_true", help="print JSON")
    parser.add_argument("-o", dest="path", metavar="PATH", help="write to a file instead")


def _flip(args: argparse.Namespace) -> int:
    from tresym.racket.flip.ladder import climb, parse_digits
    from tresym.reals.numbers.exact import parse_number

    if args.psi0 is not None:
        return _journey(args)
    if args.rate is not None or args.theta0 is not None or args.precession is not None:
        raise InputError("flip: --rate, --theta0 and --precession belong to --psi0")
    shape, title = _body(args)
    gamma = parse_number("0" if args.gamma is None else args.gamma, "gamma")
    answer = climb(shape, gamma, parse_digits(args.digits), args.rung)
    if args.json:
        _deliver_json(answer.as_json(), args.path)
    else:
        from tresym.output import colour_wanted
        from tresym.report.flip import flip_text

        _deliver(flip_text(answer, title, colour_wanted() and args.path is None), args.path)
    return 0


def _journey(args: argparse.Namespace) -> int:
    """A start of the user's own."""
    from tresym.racket.flip import flip_angle
    from tresym.racket.flip.ladder import parse_digits

    shape, title = _body(args)
    answer = flip_angle(
        *shape,
        args.psi0,
        args.rate,
        parse_digits(args.digits),
        theta0=args.theta0,
        precession="2*pi" if args.precession is None else args.precession,
        rung=args.rung,
    )
    if args.json:
        _deliver_json(answer.as_json(), args.path)
    else:
        from tresym.output import colour_wanted
        from tresym.report.flip import journey_text

        _deliver(journey_text(answer, title, colour_wanted() and args.path is None), args.path)
    return 0


def _deliver_json(answer: dict[str, Any], path: str | None) -> None:
    import json

    _deliver(json.dumps(answer, ensure_ascii=False) + "\n", path)


def _body(args: argparse.Namespace) -> tuple[Shape, str]:
    """The shape asked for, and a title that says where it came from."""
    from tresym.racket import body

    if args.body is not None:
        named = body.named_body(args.body)
        return named.shape, f"{named.title}, {named.source}"
    if args.inertia is not None:
        return body.shape_of_moments(*args.inertia), "body with the given moments"
    return body.shape(*args.shape), "body of the given shape"


def _add_bench(commands: Commands) -> None:
    from tresym.bench.names import WORKLOADS

    width = max(map(len, WORKLOADS))
    parser = commands.add_parser(
        "bench",
        help="time workloads against their peers",
        description="Time workloads, every contender in turn; quote only ratios within one run.",
        epilog="\n".join(
            ["workloads (default: all):"]
            + [f"  {name:<{width}}  {says}" for name, says in WORKLOADS.items()]
            + ["", "Interrupted with Ctrl-C, it shows (and with --save keeps) what it has."]
        ),
        formatter_class=argparse.RawDescriptionHelpFormatter,
        allow_abbrev=False,
    )
    parser.add_argument("workloads", nargs="*", metavar="WORKLOAD", help="see below")
    parser.add_argument("--save", action="store_true", help="keep it in docs/measurements")
    _add_output(parser)
    parser.set_defaults(run=_bench)


def _bench(args: argparse.Namespace) -> int:
    from tresym.bench import show

    return show.run(args.workloads, args.save, args.json, args.path)


def _add_sweep(commands: Commands) -> None:
    parser = commands.add_parser(
        "sweep",
        help="the flip of very many bodies, into one table",
        description="Compute the flip defect of every row of a grid or of a CSV file, and the "
        "errors of the formulas, into an SQLite table. A sweep that was interrupted goes on where "
        "it stopped when the same command is given again.",
        epilog="VALUES: 0.1,1/3 or LOW:HIGH:COUNT, with log after it for equal ratios. Exit status "
        "1 when some rows have a problem; line and reason are in the table.",
        allow_abbrev=False,
    )
    parser.add_argument("-o", dest="path", metavar="TABLE", required=True, help="the SQLite file")
    parser.add_argument("--csv", metavar="FILE", help="columns a, b or I1, I2, I3 or body; gamma")
    parser.add_argument("--a", metavar="VALUES", help="the grid's a = I2/I1 - 1")
    parser.add_argument("--b", metavar="VALUES", help="the grid's b = 1 - I2/I3")
    parser.add_argument("--gamma", metavar="VALUES", help="the grid's gamma (default: 0)")
    digits = parser.add_mutually_exclusive_group()
    digits.add_argument("--digits", default="50", metavar="N", help="1 to 10000 (default: 50)")
    digits.add_argument("--float64", action="store_true", help="fast, not certified")
    where = parser.add_mutually_exclusive_group()
    where.add_argument("--workers", metavar="N", help="processes here (default: one a core)")
    where.add_argument("--dask", metavar="ADDRESS", help="the workers of a Dask scheduler")
    parser.add_argument("--export", metavar="PATH", help="also write a .csv or .parquet file")
    parser.add_argument("--json", action="store_true", help="print JSON")
    parser.set_defaults(run=_sweep)


def _sweep(args: argparse.Namespace) -> int:
    from tresym import sweep
    from tresym.racket.flip.ladder import parse_digits
    from tresym.reals.processes import parse_workers
    from tresym.sweep.run import summary_text, to_stderr

    grid = (args.a, args.b, args.gamma)
    source: sweep.Source
    if args.csv is not None and grid == (None, None, None):
        source = sweep.CsvFile(args.csv)
    elif args.csv is None and args.a is not None and args.b is not None:
        source = sweep.Grid.read(args.a, args.b, "0" if args.gamma is None else args.gamma)
    else:
        raise InputError("sweep: give either --csv, or --a and --b, and --gamma if wanted")
    digits = None if args.float64 else parse_digits(args.digits)
    workers = None
    if args.dask is not None:
        workers = functools.partial(sweep.cluster, args.dask)
    elif args.workers is not None:
        workers = functools.partial(sweep.processes, parse_workers(args.workers))
    found = sweep.sweep(source, args.path, digits, workers, export=args.export, notice=to_stderr)
    if args.json:
        _deliver_json(found.as_json(), None)
    else:
        _deliver(summary_text(found), None)
    return UNEXPECTED if found.bad else 0


_PICTURE_PATH = "write to a file instead: .svg, .pdf or .png"


def _add_figure(commands: Commands) -> None:
    parser = commands.add_parser(
        "figure",
        help="a figure of the paper, recomputed",
        description="Draw one figure; without a name, list them.",
        epilog="Needs matplotlib: pip install 'tresym[docs]'.",
        allow_abbrev=False,
    )
    parser.add_argument("name", nargs="?", metavar="NAME", help="a figure, such as flip-map")
    parser.add_argument("-o", dest="path", metavar="PATH", help=_PICTURE_PATH)
    parser.set_defaults(run=_figure)


def _figure(args: argparse.Namespace) -> int:
    from tresym.report import figures

    if args.name is None:
        names = (f"{name:<16} {title}\n" for name, title in figures.FIGURES.items())
        _deliver("".join(names), args.path)
    else:
        _deliver_picture(lambda kind: figures.picture(args.name, kind), args.path)
    return 0


def _add_chart(commands: Commands) -> None:
    parser = commands.add_parser(
        "chart",
        help="a chart of saved measurements",
        description="Draw one chart of `tresym bench --save`; without a name, list them.",
        epilog="Needs matplotlib: pip install 'tresym[docs]'.",
        allow_abbrev=False,
    )
    parser.add_argument("name", nargs="?", metavar="NAME", help="a chart, such as work-precision")
    parser.add_argument(
        "--from", dest="source", metavar="FILE", help="a saved measurement (default: the one here)"
    )
    parser.add_argument("-o", dest="path", metavar="PATH", help=_PICTURE_PATH)
    parser.set_defaults(run=_chart)


def _chart(args: argparse.Namespace) -> int:
    from tresym.report import charts

    if args.name is None:
        names = (f"{name:<16} {chart.title}\n" for name, chart in charts.CHARTS.items())
        _deliver("".join(names), args.path)
    else:
        _deliver_picture(lambda kind: charts.picture(args.name, args.source, kind), args.path)
    return 0


def _deliver_picture(draw: Callable[[str], bytes], path: str | None) -> None:
    """To a file of the kind its name ends in, or as SVG to standard output."""
    from tresym.output import write_bytes
    from tresym.report.figures import kind_of

    picture = draw(kind_of(path))
    if path is None:
        print(picture.decode(), end="")
    else:
        write_bytes(path, picture)


def _deliver(text: str, path: str | None) -> None:
    if path is None:
        print(text, end="")
        return
    from tresym.output import write_text

    write_text(path, text)


def _keep_negative_values(words: list[str]) -> list[str]:
    """Mark words such as -1e5, -pi/2 or -inf as values: a leading space hides them from argparse.

    Every number is parsed after the spaces around it are dropped.
    """
    return [
        " " + word if word.startswith("-") and word != "-" and not _OPTION.match(word) else word
        for word in words
    ]


def main(arguments: list[str] | None = None) -> int:
    """Run one command line; returns the exit status."""
    words = sys.argv[1:] if arguments is None else arguments
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="replace")
    try:
        args = build_parser().parse_args(_keep_negative_values(words))
        status: int = args.run(args)
        if sys.stdout is not None:
            sys.stdout.flush()
        return status
    except InputError as error:
        print(f"tresym: {_one_line(str(error), 2000)}", file=sys.stderr)
        return BAD_INPUT
    except KeyboardInterrupt:
        print("tresym: interrupted", file=sys.stderr)
        return INTERRUPTED
    except BrokenPipeError:
        # The reader has left: nothing to say, and nothing must be said while Python shuts down.
        _forget_output()
        return 0
    except OSError as error:
        name = _one_line(str(error.filename or "output"), 400)
        print(f"tresym: {name}: {error.strerror}", file=sys.stderr)
        if error.filename is None:
            _forget_output()
        return BAD_INPUT


def _forget_output() -> None:
    """Send what is left in the buffer nowhere: Python would complain of it at its end."""
    if sys.stdout is not None:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
