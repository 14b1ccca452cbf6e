"""The racket's flip in space, as an SVG that moves by itself (SMIL, no script).

The motion is the standard racket's at the γ > 0 with ε(γ) = 0, from ψ = 0: after one turn of the
handle it has made exactly half a turn about the handle and after two it is as it was, so that the
picture repeats without a jump. Steps are equal in φ; the clock follows the time of the motion.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from tresym.racket.floats.flipmap import Floats
from tresym.racket.motion.attitude import attitude
from tresym.report.figures.curves import rate_at, shape_of
from tresym.report.figures.defect_map import symmetric_defect
from tresym.report.figures.grid import coordinate
from tresym.report.figures.racket import racket
from tresym.report.figures.view import View, circle, view

STEPS = 96
SECONDS = 8.0
SCALE, WIDTH, HEIGHT = 150.0, 380, 310
FACES = ("#e69f00", "#0072b2")
"""The colours of the two faces of the head; +e₃ first."""

WORDS = (
    "The handle goes round the angular momentum M, which stays upright, almost in a level circle. "
    "While the handle makes one turn the head makes half a turn about it: where the blue face was "
    "seen before, the orange one is seen after. After two turns all is as it was."
)
LESS_MOTION = (
    ".held{display:none}"
    "@media (prefers-reduced-motion:reduce){.held{display:inline}.moving{display:none}}"
)
"""Who asks for less motion sees the first moment, held."""


class Data(NamedTuple):
    """Two turns of the handle: γ, times as shares of the whole, φ, ψ, and the frames.

    ``frames`` has shape (n, 3, 3) with rows e₁, e₂, e₃ in space; the last is the first again.
    """

    gamma: float
    time: Floats
    phi: Floats
    psi: Floats
    frames: Floats


def data() -> Data:
    """The motion with an exact flip, found by bisection on ε(γ), which falls through 0."""
    a, b = shape_of("str")
    low, high = 0.0, 0.01
    for _ in range(60):
        middle = (low + high) / 2
        still = symmetric_defect(a, b, np.array(middle)) > 0
        low, high = (middle, high) if still else (low, middle)
    start = float(rate_at(np.array(0.0), low, a, b))
    found = attitude(a, b, 0.0, start, 4 * math.pi, STEPS + 1)
    second, third, first = np.moveaxis(found.rotations(), -1, 0)
    frames = np.stack([first, second, third], axis=1)
    return Data(low, found.time / found.time[-1], found.phi, found.psi, frames)


def draw(data: Data) -> str:
    """The moving picture as SVG text."""
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
            f'width="{WIDTH}" height="{HEIGHT}" role="img">',
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
    """The racket, each of its three parts with what moves it."""
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
    """The circle a level handle's end runs on, and the momentum."""
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
    """The drawing commands of a line through points in space."""
    return "M" + "L".join(
        f"{coordinate(x, 1)} {coordinate(y, 1)}" for x, y in (_at(eye, point) for point in points)
    )


def _moves(attribute: str, values: Iterable[str], clock: str, mode: str = "linear") -> str:
    return (
        f'<animate attributeName="{attribute}" dur="{SECONDS:g}s" repeatCount="indefinite" '
        f'calcMode="{mode}" keyTimes="{clock}" values="{";".join(values)}"/>'
    )
