"""``tresym flip``: compute the flip of one body, certified."""

from __future__ import annotations

import argparse
import re
import sys
from decimal import Context, Decimal, Inexact, localcontext
from textwrap import wrap
from typing import TYPE_CHECKING

from flint import arb, fmpq

from tresym.commands.bodies import add_body, body_of
from tresym.commands.parser import (
    UNEXPECTED,
    Commands,
    add_options,
    add_output,
    deliver,
    json_line,
    parse_seconds,
)
from tresym.output import bold, colour_wanted, dim
from tresym.racket.result import Flip, Journey, proves, radians
from tresym.reals.numbers.arithmetic import ball_precision, bits
from tresym.reals.numbers.exact import InputError, fraction_text

if TYPE_CHECKING:
    from concurrent.futures import Future

    from tresym.racket.body import Shape


def add(commands: Commands) -> None:
    """Add `tresym flip` to the command line."""
    parser = commands.add_parser(
        "flip",
        help="compute the flip of one body, certified",
        description="How far one full turn of a freely rotating body is from a perfect flip.",
        epilog="Numbers are exact: 0.0629, 1e-4 or 16380/1210; angles also pi/2 or -3*pi/4.",
    )
    add_body(parser, required=True)
    parser.add_argument("--digits", default="50", metavar="N", help="1 to 10000 (default: 50)")
    parser.add_argument(
        "--model",
        "--rung",
        dest="model",
        metavar="NAME",
        help=(
            "use this model (method of computation) instead of the "
            "cheapest model that gives the digits"
        ),
    )
    where = parser.add_mutually_exclusive_group()
    add_options(
        where,
        (
            "--gamma G",
            "distance from the separatrix, -b to a (default: 0); on a rigid body, a larger "
            "distance always gives a larger flip",
        ),
        ("--psi0 P", "start at this psi, in radians, instead of following the symmetric motion"),
    )
    how = parser.add_mutually_exclusive_group()
    how.add_argument("--rate", metavar="V", help="with --psi0: dpsi/dphi at the start")
    how.add_argument("--theta0", metavar="T", help="with --psi0: theta at the start, in radians")
    add_options(
        parser,
        ("--precession ANGLE", "with --psi0: how far phi goes (default: 2*pi)"),
        ("--limit SECONDS", "time after which the digits known so far are printed (60)"),
    )
    add_output(parser)


def run(args: argparse.Namespace) -> int:
    """Run the command and return its exit status."""
    from tresym.racket.flip.model_selection import parse_digits

    digits, colour = parse_digits(args.digits), colour_wanted() and args.path is None
    if args.limit is None and _is_short(args, digits):
        deliver(_told(args, digits, colour), args.path)
        return 0
    seconds = parse_seconds("60" if args.limit is None else args.limit)
    known, text = _known_within(seconds, args, digits, colour)
    if known:
        deliver(text, args.path)
    if known == digits:
        return 0
    what = f"{known} of {digits} digits are known" if known else "no digits are known"
    print(f"tresym: flip: after {seconds:g} s {what}; see --limit", file=sys.stderr)
    return UNEXPECTED


SOONER = (5, 50, 500, 5000)
"""Numbers of digits to compute first, in case the time is not enough for all."""

PATIENCE = 5.0
"""Seconds after which a message says that the computation goes on."""
_LONG = re.compile(r"[eE][+-]?\d{3}|.{40}")


def _is_short(args: argparse.Namespace, digits: int) -> bool:
    """Whether the answer comes at once: few digits, and no long numbers."""
    asked = (args.gamma, args.psi0, args.rate, args.theta0, args.precession)
    numbers = (*asked, *(args.inertia or ()), *(args.shape or ()))
    return digits <= 1000 and not any(_LONG.search(text) for text in numbers if text is not None)


def _known_within(
    seconds: float, args: argparse.Namespace, digits: int, colour: bool
) -> tuple[int, str]:
    """Return how many digits are known after so many seconds, and the text of the answer.

    FLINT cannot be interrupted, so the work is done in a process that can be ended.
    """
    import time

    from tresym.reals.processes import Processes

    start, known, text = time.monotonic(), 0, ""
    with Processes(1, forked=True) as pool:
        few = [n for n in SOONER if n < digits]
        calls = [(n, pool.submit(_told, args, n, colour)) for n in (*few, digits)]
        for asked, future in calls:
            try:
                text = _awaited(future, start + PATIENCE, start + seconds)
                known = asked
            except TimeoutError:
                pool.end()
                break
            except InputError:
                if asked == digits:
                    raise
        pool.shutdown(cancel_futures=True)
    return known, text


def _awaited(future: Future[str], word: float, end: float) -> str:
    """Return the result if it comes before ``end``; at ``word`` say that the work goes on."""
    import time

    if time.monotonic() < word < end:
        try:
            return future.result(word - time.monotonic())
        except TimeoutError:
            more = f"for {end - word:.0f} s more at most"
            print(f"tresym: flip: still computing, {more}; see --limit", file=sys.stderr)
    return future.result(max(0, end - time.monotonic()))


def _told(args: argparse.Namespace, digits: int, colour: bool) -> str:
    """Return the answer to so many digits, as text."""
    shape, title = body_of(args)
    if args.psi0 is None:
        answer = _flip(args, shape, digits)
        text = answer.as_json() if args.json else flip_text(answer, title, colour)
    else:
        journey = _journey(args, shape, digits)
        text = journey.as_json() if args.json else journey_text(journey, title, colour)
    return text if isinstance(text, str) else json_line(text)


def _flip(args: argparse.Namespace, shape: Shape, digits: int) -> Flip:
    """Compute the flip on the symmetric trajectory."""
    from tresym.racket.flip.model_selection import climb
    from tresym.reals.numbers.exact import parse_number

    if args.rate is not None or args.theta0 is not None or args.precession is not None:
        raise InputError("flip: --rate, --theta0 and --precession need --psi0")
    gamma = parse_number("0" if args.gamma is None else args.gamma, "gamma")
    return climb(shape, gamma, digits, args.model)


def _journey(args: argparse.Namespace, shape: Shape, digits: int) -> Journey:
    """Compute the flip for initial conditions of the user."""
    from tresym.racket.flip import flip_angle

    return flip_angle(
        *shape,
        args.psi0,
        args.rate,
        digits,
        theta0=args.theta0,
        precession="2*pi" if args.precession is None else args.precession,
        model=args.model,
    )


LONGEST_FRACTION = 24

LABEL, LINE = 12, 80
"""Width of the label and of a whole line, which a ball of 50 digits fills.

A longer ball stays on one line, so that it can be copied.
"""


def flip_text(answer: Flip, title: str, colour: bool = False) -> str:
    """Return the answer as text; ``title`` names the body."""
    with ball_precision(bits(answer.digits, 64)):
        rows = [
            *_shape(answer),
            ("defect   ε", radians(answer.defect, answer.digits)),
            ("flip    Δψ", radians(answer.flip, answer.digits)),
            *_approximations(answer),
            *_model(answer),
            ("realizable", _realizable(answer)),
        ]
    lines = [f" {dim(f'{label:<{LABEL}}', colour)}{text}" for label, text in rows]
    return "\n".join([bold(title, colour), "", *lines]) + "\n"


def journey_text(answer: Journey, title: str, colour: bool = False) -> str:
    """Return the answer for given initial conditions as text."""
    with ball_precision(bits(answer.digits, 64)):
        rows = [
            *_shape(answer),
            ("flip    Δψ", radians(answer.flip, answer.digits)),
            ("ends at  ψ", radians(answer.psi, answer.digits)),
            ("         θ", radians(answer.theta, answer.digits)),
            *_model(answer),
            ("realizable", _realizable(answer)),
        ]
    lines = [f" {dim(f'{label:<{LABEL}}', colour)}{text}" for label, text in rows]
    return "\n".join([bold(title, colour), "", *lines]) + "\n"


def _model(answer: Flip | Journey) -> list[tuple[str, str]]:
    """Return the lines on the model that gave the answer."""
    return _headed("model", wrap(f"{answer.model}: {answer.why}", LINE - LABEL - 1))


def _headed(label: str, lines: list[str]) -> list[tuple[str, str]]:
    return [("" if n else label, line) for n, line in enumerate(lines)]


def _approximations(answer: Flip) -> list[tuple[str, str]]:
    """Return the lines on rounded values, and on the value of the paper's asymptotic formula."""
    if not proves(answer.defect, answer.digits):
        return []
    defect, turn, degree = answer.defect, answer.flip, arb.pi() / 180
    rows = [
        ("", f"ε ≈ {_short(defect / degree)}°,   Δψ ≈ {_short(turn / degree)}°"),
        ("", f"Δψ = π(1 {'−' if defect > 0 else '+'} {_short(abs(2 * defect / arb.pi()))})"),
    ]
    estimate = answer.printed_estimate
    if estimate is None:
        return rows
    error = 100 * (estimate / defect - 1)
    size = f"{float(abs(error)):.3g}"
    side = "large" if error > 0 else "small"
    return [
        *rows,
        ("paper", f"its asymptotic formula gives {_short(estimate)}, {size} % too {side}"),
    ]


def _short(x: arb) -> str:
    return str(x.str(6, radius=False))


def _shape(answer: Flip | Journey) -> list[tuple[str, str]]:
    """Return the lines on shape and level, exact if short and rounded."""
    parts = []
    gamma = answer.gamma
    named = [("a", answer.shape.a), ("b", answer.shape.b), ("γ", gamma)]
    for name, value in named:
        exact = _exactly(value) if isinstance(value, fmpq) else ""
        if exact and "/" not in exact and len(exact) <= LONGEST_FRACTION:
            parts.append(f"{name} = {exact}")
        elif exact and len(exact) <= LONGEST_FRACTION:
            parts.append(f"{name} = {exact} ≈ {_short(arb(value))}")
        else:
            parts.append(f"{name} ≈ {_short(arb(value))}")
    lines = parts[:1]
    for part in parts[1:]:
        if len(f"{lines[-1]},   {part}") < LINE - LABEL:
            lines[-1] += f",   {part}"
        else:
            lines = [*lines[:-1], f"{lines[-1]},", part]
    return _headed("shape", lines)


def _exactly(x: fmpq) -> str:
    """Return a number as a short decimal if it is one, else as a fraction."""
    with localcontext(Context(prec=12, traps=[Inexact])):
        try:
            text = str(Decimal(int(x.p)) / Decimal(int(x.q)))
        except Inexact:
            text = ""
    return fraction_text(x) if not text or "E" in text else text


def _realizable(answer: Flip | Journey) -> str:
    if answer.realizable:
        return "yes: I₃ ≤ I₁ + I₂, so a rigid body can have this shape"
    return "no: b > 1/(a+2), that is I₃ > I₁ + I₂; no rigid body has exactly this shape"
