"""The racket's flip in space: an SVG that animates itself (SMIL, no script), a GIF or an MP4.

The motion is that of the standard racket at the γ > 0 with ε(γ) = 0, from ψ = 0. During one turn of
the handle the racket makes exactly half a turn about its handle, and after two turns of the handle
it is as it was, so that the picture repeats without a jump. The frames are equally spaced in φ;
each is shown for the time that the motion takes.
"""

from __future__ import annotations

import io
import math
import os
from collections.abc import Iterable
from fractions import Fraction
from tempfile import TemporaryDirectory
from typing import Any, NamedTuple

import numpy as np
from tresym.proofs.figures.curves import rate_at, shape_of
from tresym.proofs.figures.defect_map import symmetric_defect
from tresym.proofs.figures.racket import racket
from tresym.proofs.figures.view import View, bare, circle, view

from tresym.racket.floats.flipmap import Floats
from tresym.racket.motion.attitude import attitude
from tresym.reals.numbers.exact import InputError
from tresym.report.figures import style
from tresym.report.figures.grid import coordinate

STEPS = 96
SECONDS = 8.0
SCALE, WIDTH, HEIGHT = 150.0, 380, 310
FINER = 3
"""The frames of a GIF or MP4 are drawn larger by this factor and then reduced."""
LEAST_PIXELS, MOST_PIXELS = 100, 1000
"""The width of a GIF or MP4; all frames are held in memory."""
ROUNDS, RATE = 2, 25
"""How often an MP4 shows the motion, and its frames per second."""
STILLS = 9
FACES = ("#e69f00", "#0072b2")
"""The colours of the two faces of the head; +e₃ first."""

WORDS = (
    "The handle moves around the angular momentum M, which stays vertical, almost in a horizontal "
    "circle. During one turn of the handle the head makes half a turn about it: where the blue "
    "face was seen before, the orange one is seen afterwards. After two turns the racket is as it "
    "was."
)
LESS_MOTION = (
    ".held{display:none}"
    "@media (prefers-reduced-motion:reduce){.held{display:inline}.moving{display:none}}"
)
"""Readers whose browser asks for reduced motion see the first frame."""


class Data(NamedTuple):
    """Two turns of the handle: γ, times as fractions of the total, φ, ψ, and the frames.

    ``frames`` has shape (n, 3, 3) with rows e₁, e₂, e₃ in space; the last equals the first.
    """

    gamma: float
    time: Floats
    phi: Floats
    psi: Floats
    frames: Floats


def data(body: tuple[float, float] | None = None) -> Data:
    """Compute the motion with an exact flip, by bisection on the decreasing function ε(γ).

    Args:
        body: (a, b) of a shape; the standard racket if None.

    Raises:
        InputError: float arithmetic finds no level on which this shape flips exactly.
    """
    a, b = body or shape_of("str")
    low, high = 0.0, min(0.01, a / 2)
    while symmetric_defect(a, b, np.array(high)) > 0:
        if 2 * high >= a:
            raise InputError("figure: no motion of this body flips by π exactly in one turn")
        low, high = high, 2 * high
    for _ in range(60):
        middle = (low + high) / 2
        still = symmetric_defect(a, b, np.array(middle)) > 0
        low, high = (middle, high) if still else (low, middle)
    start = float(rate_at(np.array(0.0), low, a, b))
    found = attitude(a, b, 0.0, start, 4 * math.pi, STEPS + 1)
    second, third, first = np.moveaxis(found.rotations(), -1, 0)
    frames = np.stack([first, second, third], axis=1)
    return Data(low, found.time / found.time[-1], found.phi, found.psi, frames)


def draw(data: Data, width: float | None = None) -> str:
    """Return the animation as SVG text.

    Args:
        data: the motion.
        width: its width in millimetres; None means 380 pixels.
    """
    size = f'width="{WIDTH}" height="{HEIGHT}"'
    if width is not None:
        size = f'width="{width:g}mm" height="{width * HEIGHT / WIDTH:g}mm"'
    eye, shape = view(-50, 22), racket(41)
    clock = ";".join(coordinate(x, 4) for x in (*data.time[:-1], 1.0))
    rims = [_line(eye, shape.rim @ frame) for frame in data.frames]
    handles = [_line(eye, shape.handle @ frame) for frame in data.frames]
    strings = [
        "".join(_line(eye, string @ frame) for string in shape.strings) for frame in data.frames
    ]
    faces = [FACES[0 if eye.depth(frame[2]) > 0 else 1] for frame in data.frames]
    moves = (
        _moves("d", rims, clock) + _moves("fill", faces, clock, "discrete"),
        _moves("d", strings, clock),
        _moves("d", handles, clock),
    )
    first = rims[0], faces[0], strings[0], handles[0]
    return "\n".join(
        [
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" '
            f'{size} role="img">',
            "<title>A tennis racket flips once in every turn of its handle</title>",
            f"<desc>{WORDS}</desc>",
            f"<style>{LESS_MOTION}</style>",
            f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>',
            *_still(eye),
            *_body("moving", *first, moves),
            *_body("held", *first, ("", "", "")),
            "</svg>\n",
        ]
    )


def _body(
    name: str, rim: str, face: str, strings: str, handle: str, moves: tuple[str, str, str]
) -> list[str]:
    """The racket: rim, strings and handle, each with its animation."""
    ink = 'stroke="#222"'
    return [
        f'<g class="{name}">',
        f'<path d="{rim}" fill="{face}" {ink} stroke-width="3">{moves[0]}</path>',
        f'<path d="{strings}" fill="none" {ink} stroke-width="0.6">{moves[1]}</path>',
        f'<path d="{handle}" fill="none" {ink} stroke-width="7" stroke-linecap="round">'
        f"{moves[2]}</path>",
        "</g>",
    ]


def _still(eye: View) -> list[str]:
    """The circle that the tip of a horizontal handle would describe, and the angular momentum."""
    ring = _line(eye, circle([0, 0, 1], points=73))
    tip = _at(eye, np.array([0, 0, 1.05]))
    wings = [(tip[0] - 4, tip[1] + 10), (tip[0] + 4, tip[1] + 10), tip]
    head = " ".join(f"{coordinate(x, 1)},{coordinate(y, 1)}" for x, y in wings)
    momentum = _line(eye, np.array([[0, 0, 0], [0, 0, 1.0]]))
    letter = f"M{coordinate(tip[0] + 10, 1)} {coordinate(tip[1] + 12, 1)}l2 -11l4 8l6 -8l2 11"
    return [
        f'<path d="{ring}" fill="none" stroke="#bbb"/>',
        f'<path d="{momentum}" stroke="#555" stroke-width="1.5"/>',
        f'<polygon points="{head}" fill="#555"/>',
        f'<path id="M" d="{letter}" fill="none" stroke="#333" stroke-width="1.5"/>',
    ]


def _at(eye: View, point: Floats) -> tuple[float, float]:
    x, y = eye.flat(point)
    return WIDTH / 2 + SCALE * x, 0.55 * HEIGHT - SCALE * y


def _line(eye: View, points: Floats) -> str:
    """The SVG path through points in space."""
    return "M" + "L".join(
        f"{coordinate(x, 1)} {coordinate(y, 1)}" for x, y in (_at(eye, point) for point in points)
    )


def _moves(attribute: str, values: Iterable[str], clock: str, mode: str = "linear") -> str:
    return (
        f'<animate attributeName="{attribute}" dur="{SECONDS:g}s" repeatCount="indefinite" '
        f'calcMode="{mode}" keyTimes="{clock}" values="{";".join(values)}"/>'
    )


def moving(data: Data, pixels: int = WIDTH) -> bytes:
    """Return the animation as a GIF of equal steps in φ.

    Args:
        data: the motion.
        pixels: the width of the picture.

    Raises:
        InputError: ``pixels`` is out of range.
    """
    shown = np.diff(np.round(100 * SECONDS * data.time))  # a GIF counts in hundredths of a second
    out = io.BytesIO()
    first, *rest = _sheets(data, pixels)
    first.save(
        out,
        format="GIF",
        save_all=True,
        append_images=rest,
        duration=[10 * max(int(part), 2) for part in shown],
        loop=0,
        comment="tresym",
    )
    return out.getvalue()


def film(data: Data, pixels: int = WIDTH) -> bytes:
    """Return the animation as an MP4 of equal steps in time, repeated ``ROUNDS`` times.

    Args:
        data: the motion.
        pixels: the width of the picture.

    Raises:
        InputError: ``pixels`` is out of range, or imageio-ffmpeg, which contains the encoder, is
            not installed.
    """
    try:
        from imageio_ffmpeg import write_frames
    except ImportError:
        raise InputError(
            "figure: an MP4 needs imageio-ffmpeg: pip install -e '.[video]'; a GIF does not"
        ) from None
    sheets = [sheet.tobytes() for sheet in _sheets(data, pixels)]
    moments = np.arange(round(ROUNDS * SECONDS * RATE)) / (SECONDS * RATE) % 1
    with TemporaryDirectory() as folder:
        path = os.path.join(folder, "flip.mp4")
        options = ["-metadata", "comment=tresym"]
        size = _size(pixels)
        writer = write_frames(path, size, fps=RATE, macro_block_size=2, output_params=options)
        writer.send(None)
        for at in np.searchsorted(data.time, moments, "right") - 1:
            writer.send(sheets[min(at, len(sheets) - 1)])
        writer.close()
        with open(path, "rb") as written:
            return written.read()


def _size(pixels: int) -> tuple[int, int]:
    """Width and height of an animation ``pixels`` wide, both even, as encoders of video need."""
    if not LEAST_PIXELS <= pixels <= MOST_PIXELS:
        raise InputError(
            f"figure: {pixels} pixels wide, by --width and --dpi; an animation is {LEAST_PIXELS} "
            f"to {MOST_PIXELS} pixels wide"
        )
    wide = 2 * round(pixels / 2)
    return wide, 2 * round(wide * HEIGHT / WIDTH / 2)


def _sheets(data: Data, pixels: int) -> list[Any]:
    """The frames in order, each as an image of Pillow."""
    from PIL import Image, ImageDraw

    size = _size(pixels)
    zoom = FINER * size[0] / WIDTH

    def points(places: Floats) -> list[tuple[float, float]]:
        return [(zoom * x, zoom * y) for x, y in (_at(eye, place) for place in places)]

    def thick(width: float) -> int:
        return max(1, round(width * zoom))

    eye, shape = view(-50, 22), racket(41)
    ring = points(circle([0, 0, 1], points=73))
    momentum = points(np.array([[0, 0, 0], [0, 0, 1.0]]))
    pictures = []
    for frame in data.frames[:-1]:
        sheet = Image.new("RGB", (FINER * size[0], FINER * size[1]), "white")
        pen = ImageDraw.Draw(sheet)
        pen.line(ring, fill="#bbbbbb", width=thick(1))
        pen.line(momentum, fill="#555555", width=thick(2))
        face = FACES[0 if eye.depth(frame[2]) > 0 else 1]
        pen.polygon(points(shape.rim @ frame), fill=face, outline="#222222", width=thick(3))
        for string in shape.strings:
            pen.line(points(string @ frame), fill="#222222", width=thick(1 / 3))
        pen.line(points(shape.handle @ frame), fill="#222222", width=thick(7))
        pictures.append(sheet.resize(size, Image.Resampling.LANCZOS))
    return pictures


def strip(data: Data) -> Any:
    """Draw stills of one turn of the handle, side by side, for print."""
    eye, shape = view(-50, 22), racket(41)
    figure, grid = style.canvas(9.0, 1.4, 1, STILLS)
    for n, sheet in enumerate(grid[0]):
        at = n * STEPS // (2 * (STILLS - 1))
        frame = data.frames[at]
        bare(sheet, 1.2)
        sheet.plot(*eye.flat(circle([0, 0, 1], points=73)).T, color="0.75", linewidth=0.6)
        face = FACES[0 if eye.depth(frame[2]) > 0 else 1]
        sheet.fill(
            *eye.flat(shape.rim @ frame).T, facecolor=face, edgecolor=style.INK, linewidth=0.7
        )
        sheet.plot(*eye.flat(shape.handle @ frame).T, color=style.INK, linewidth=1.6)
        turned = style.multiple_of_pi(Fraction(2 * n, STILLS - 1))
        sheet.set_title(turned if n else f"φ = {turned}", fontsize=8)
    return figure
