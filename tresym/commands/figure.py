"""``tresym figure``: draw a figure of the paper, recomputed."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

from tresym.commands.bodies import add_body, body_of
from tresym.commands.parser import (
    PICTURE_PATH,
    Commands,
    add_options,
    deliver,
    deliver_picture,
)
from tresym.reals.numbers.exact import InputError

if TYPE_CHECKING:
    from tresym.racket.body import Shape

KINDS = ("svg", "pdf", "png", "gif", "mp4")
WIDTHS, DOTS = (40, 600), (20, 1200)
"""The range of --width, in millimetres, and of --dpi."""


def add(commands: Commands) -> None:
    """Add `tresym figure` to the command line."""
    parser = commands.add_parser(
        "figure",
        help="draw a figure of the paper, also for your own body",
        description="Draw one figure. Without a name, list all figures. flip-portrait, flip-map, "
        "flip-curves and racket-flip can be drawn for any body.",
        epilog="Needs matplotlib: pip install 'tresym[docs]'; for an MP4 imageio-ffmpeg: "
        "pip install 'tresym[docs,video]'.",
    )
    parser.add_argument("name", nargs="?", metavar="NAME", help="a figure, such as flip-map")
    add_body(parser, required=False)
    add_options(
        parser,
        ("--gamma G", "for flip-curves: draw only this level"),
        ("--width MM", "width of the picture in millimetres"),
        ("--dpi N=200", "resolution in dots per inch of a PNG, or of a GIF or MP4 with --width"),
    )
    parser.add_argument(
        "--format", choices=KINDS, help="file format (default: from the ending of PATH, or svg)"
    )
    parser.add_argument(
        "-o", dest="path", metavar="PATH", help=f"{PICTURE_PATH}; racket-flip .gif or .mp4"
    )


def run(args: argparse.Namespace) -> int:
    """Run the command and return its exit status."""
    from tresym.proofs import figures

    if args.name is None:
        names = (f"{name:<16} {title}\n" for name, title in figures.FIGURES.items())
        deliver("".join(names), args.path)
        return 0
    from tresym.proofs.figures.curves import floats

    own = any((args.body, args.inertia, args.shape))
    shape, _ = body_of(args if own else argparse.Namespace(body="str", inertia=None))
    gamma = None if args.gamma is None else _level(shape, args.gamma)
    width = None if args.width is None else _within(args.width, WIDTHS, "--width")
    dpi = round(_within(args.dpi, DOTS, "--dpi"))

    def draw(kind: str) -> bytes:
        return figures.picture(args.name, kind, floats(shape) if own else None, gamma, width, dpi)

    deliver_picture(draw, args.path, args.format)
    return 0


def _level(shape: Shape, text: str) -> float:
    """Return γ of a level; it must be neither that of the separatrix nor of an equilibrium."""
    from tresym.racket.flip.defect import checked_gamma
    from tresym.reals.numbers.exact import parse_number

    gamma = checked_gamma(*shape, parse_number(text, "gamma"))
    if gamma == 0:
        raise InputError(
            "figure: --gamma 0 is the separatrix, whose motion never returns; give another level"
        )
    return int(gamma.p) / int(gamma.q)


def _within(text: str, ends: tuple[int, int], what: str) -> float:
    from tresym.reals.numbers.exact import parse_number

    value = parse_number(text, what)
    if not ends[0] <= value <= ends[1]:
        raise InputError(f"{what}: must be from {ends[0]} to {ends[1]}")
    return int(value.p) / int(value.q)
