"""The ``tresym`` command. Each sub-command is a parser and a function that imports what it needs.

Exit status: 0 as expected; 1 a verdict unexpected or undecided; 2 bad input, with one line on
standard error; 130 interrupted.
"""

from __future__ import annotations

import argparse
import os
import re
import sys
from typing import TYPE_CHECKING, Any, NoReturn

import tresym
from tresym.exact import InputError

if TYPE_CHECKING:
    from tresym.body import Shape

    Commands = argparse._SubParsersAction["Parser"]

UNEXPECTED = 1
BAD_INPUT = 2
INTERRUPTED = 130

_OPTION = re.compile(r"-[hof]|--")


class Parser(argparse.ArgumentParser):
    """argparse, with its complaints as one line."""

    def error(self, message: str) -> NoReturn:
        """Raise the complaint as bad input."""
        raise InputError(f"{message} (see {self.prog} --help)")


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
    _add_flip(commands)
    _add_audit(commands)
    _add_bench(commands)
    return parser


def _add_verify(commands: Commands) -> None:
    parser = commands.add_parser(
        "verify",
        help="a verdict on every claim, or on some and all they rest on",
        description="Judge the paper's statements: PROVED, ENCLOSED, REFUTED or UNDECIDED.",
        epilog="Exit status 1 when a verdict is not the expected one.",
        allow_abbrev=False,
    )
    parser.add_argument("labels", nargs="*", metavar="LABEL", help="claims, such as eq_gamma")
    parser.add_argument("--graph", action="store_true", help="what rests on what, in Mermaid")
    _add_output(parser)
    parser.set_defaults(run=_verify)


def _verify(args: argparse.Namespace) -> int:
    from tresym import verification

    labels = tuple(args.labels)
    if args.graph:
        _deliver(verification.graph(labels), args.path)
        return 0
    if args.json or args.path:
        import json

        report = verification.verify(labels)
        _deliver(json.dumps(report.as_json(), ensure_ascii=False, indent=1) + "\n", args.path)
    else:
        from rich.console import Console

        from tresym.report.terminal import show_verification

        report = show_verification(labels, Console(highlight=False))
    return 0 if report.as_expected else UNEXPECTED


def _add_derive(commands: Commands) -> None:
    parser = commands.add_parser(
        "derive",
        help="the derivation in LaTeX: the whole article, or one statement to paste",
        description="Without labels, one article; with labels, each statement and its chain.",
        allow_abbrev=False,
    )
    parser.add_argument("labels", nargs="*", metavar="LABEL", help="claims, such as eq_gamma")
    parser.add_argument("-o", dest="path", metavar="PATH", help="write to a file instead")
    parser.set_defaults(run=_derive)


def _derive(args: argparse.Namespace) -> int:
    from tresym.report import derivation
    from tresym.verification import verify

    report = verify(args.labels)
    if args.labels:
        text = "\n".join(derivation.fragment(row) for row in report.rows if row.requested)
    else:
        text = derivation.article(report)
    _deliver(text, args.path)
    return 0 if report.as_expected else UNEXPECTED


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
    where.add_argument("--gamma", metavar="G", help="distance from the separatrix (default: 0)")
    where.add_argument("--psi0", metavar="P", help="start at this psi instead, in radians")
    how = parser.add_mutually_exclusive_group()
    how.add_argument("--rate", metavar="V", help="with --psi0: dpsi/dphi at the start")
    how.add_argument("--theta0", metavar="T", help="with --psi0: theta at the start, in radians")
    parser.add_argument(
        "--precession", metavar="ANGLE", help="with --psi0: how far phi goes (default: 2*pi)"
    )
    _add_output(parser)
    parser.set_defaults(run=_flip)


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

    from tresym import audit, proofs

    index = audit.load_index(Path(proofs.__file__).with_name("index.json"))
    found = audit.audit(Path(args.paper), proofs.claims(), index)
    if args.json or args.path:
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
    from tresym.exact import parse_number
    from tresym.flip.ladder import climb, parse_digits

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
        from tresym.report.flip import flip_text
        from tresym.report.output import colour_wanted

        _deliver(flip_text(answer, title, colour_wanted() and not args.path), args.path)
    return 0


def _journey(args: argparse.Namespace) -> int:
    """A start of the user's own."""
    from tresym.flip import flip_angle
    from tresym.flip.ladder import parse_digits

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
        from tresym.report.flip import journey_text
        from tresym.report.output import colour_wanted

        _deliver(journey_text(answer, title, colour_wanted() and not args.path), args.path)
    return 0


def _deliver_json(answer: dict[str, Any], path: str | None) -> None:
    import json

    _deliver(json.dumps(answer, ensure_ascii=False) + "\n", path)


def _body(args: argparse.Namespace) -> tuple[Shape, str]:
    """The shape asked for, and a title that says where it came from."""
    from tresym import body

    if args.body is not None:
        named = body.named_body(args.body)
        return named.shape, f"{named.title}, {named.source}"
    if args.inertia is not None:
        return body.shape_of_moments(*args.inertia), "body with the given moments"
    return body.shape(*args.shape), "body of the given shape"


def _add_bench(commands: Commands) -> None:
    parser = commands.add_parser(
        "bench",
        help="time a workload against its peers",
        description="Time workloads, every contender in turn; quote only ratios within one run.",
        allow_abbrev=False,
    )
    parser.add_argument(
        "workloads", nargs="*", metavar="WORKLOAD", help="separatrix, startup (default: all)"
    )
    parser.add_argument("--save", action="store_true", help="keep it in docs/measurements")
    _add_output(parser)
    parser.set_defaults(run=_bench)


def _bench(args: argparse.Namespace) -> int:
    import json

    from tresym.bench import workloads

    measured = [workloads.measure(name) for name in args.workloads or workloads.WORKLOADS]
    for measurement in measured if args.save else ():
        print(f"saved {workloads.save(measurement)}", file=sys.stderr)
    if args.json:
        values = [measurement.as_json() for measurement in measured]
        _deliver(json.dumps(values, indent=2) + "\n", args.path)
    else:
        _deliver("\n".join(workloads.measurement_text(m) for m in measured), args.path)
    return 0


def _deliver(text: str, path: str | None) -> None:
    if path is None:
        print(text, end="")
        return
    from tresym.report.output import write_text

    write_text(path, text)


def _keep_negative_values(words: list[str]) -> list[str]:
    """Mark words such as -1e5, -pi/2 or -inf as values: a leading space hides them from argparse.

    Every number is parsed after the spaces around it are dropped.
    """
    return [
        " " + word if word.startswith("-") and not _OPTION.match(word) else word for word in words
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
        print(f"tresym: {error}", file=sys.stderr)
        return BAD_INPUT
    except KeyboardInterrupt:
        print("tresym: interrupted", file=sys.stderr)
        return INTERRUPTED
    except BrokenPipeError:
        # The reader has left: nothing to say, and nothing must be said while Python shuts down.
        _forget_output()
        return 0
    except OSError as error:
        print(f"tresym: {error.filename or 'output'}: {error.strerror}", file=sys.stderr)
        if error.filename is None:
            _forget_output()
        return BAD_INPUT


def _forget_output() -> None:
    """Send what is left in the buffer nowhere: Python would complain of it at its end."""
    if sys.stdout is not None:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
