"""Fig. 5: the phase portrait of θ, (θ, dθ/dφ), for the body that is shown on the sphere."""

from __future__ import annotations

from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np
from tresym.proofs.figures.curves import (
    ILLUSTRATION,
    DrawnOrbit,
    handle_plane,
    orbit,
    separatrix,
    shape_of,
)

from tresym.racket.floats.flipmap import Floats
from tresym.report.figures import style

LEVELS = (-0.3, -0.26, -0.2, -0.12, -0.04, 0.04, 0.15, 0.3, 0.5, 0.75, 1.0)


class Curve(NamedTuple):
    """An orbit in the phase plane: its γ, θ (radians) and dθ/dφ."""

    gamma: float
    theta: Floats
    rate: Floats


class Data(NamedTuple):
    """The curves; a rotating orbit is also drawn mirrored at π − θ."""

    a: float
    b: float
    curves: tuple[Curve, ...]
    separatrix: tuple[Curve, Curve]


def data() -> Data:
    """Compute the orbits of the book."""
    a, b = shape_of(ILLUSTRATION)

    def curve(on: DrawnOrbit) -> Curve:
        return Curve(on.gamma, *handle_plane(on.momentum, a, b))

    sides = [(g, side) for g in LEVELS for side in ((1, -1) if g > 0 else (1,))]
    rest = (curve(separatrix(a, b, 1)), curve(separatrix(a, b, -1)))
    return Data(a, b, tuple(curve(orbit(a, b, g, side)) for g, side in sides), rest)


def draw(data: Data) -> Any:
    """Draw the range 0 ≤ θ ≤ π."""
    figure, grid = style.canvas(6.4, 3.9)
    sheet = grid[0, 0]
    for on in data.curves:
        sheet.plot(on.theta, on.rate, **style.kind(on.gamma))
    for on in data.separatrix:
        sheet.plot(on.theta, on.rate, **style.SEPARATRIX)
    sheet.axvline(np.pi / 2, color="0.6", linewidth=0.6, zorder=0)
    sheet.plot(np.pi / 2, 0, "o", color="black", markersize=4, zorder=5)
    sheet.set_xlim(0, np.pi)
    style.pi_ticks(sheet.xaxis, [Fraction(i, 4) for i in range(5)])
    sheet.set_xlabel("θ (rad)")
    sheet.set_ylabel("dθ/dφ")
    style.legend(sheet, style.ORBITS, loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=3)
    return figure
