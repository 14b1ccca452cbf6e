"""Fig. 7: the symmetric trajectories, ψ from ε to π − ε while φ makes one full turn."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from tresym.proofs.figures import flip_portrait
from tresym.proofs.figures.curves import rate_at, shape_of

from tresym.racket.floats.flipmap import Floats, arrivals
from tresym.report.figures import style

GAMMAS = (-0.045, -0.03, -0.015, -0.006, -0.002, 0.0, 0.0032037, 0.0075, 0.012)


class Flip(NamedTuple):
    """One trajectory over φ from −π to π: ψ (radians) and dψ/dφ."""

    gamma: float
    phi: Floats
    psi: Floats
    rate: Floats


class Data(NamedTuple):
    """The trajectories, and the phase portrait in which they are drawn."""

    flips: tuple[Flip, ...]
    portrait: flip_portrait.Data


def data() -> Data:
    """Compute trajectories of the standard racket, both ways from ψ = π/2 at φ = 0."""
    a, b = shape_of("str")
    return Data(tuple(_flip(a, b, gamma) for gamma in GAMMAS), flip_portrait.data())


def _flip(a: float, b: float, gamma: float) -> Flip:
    phi = np.linspace(-np.pi, np.pi, 201)
    start = float(rate_at(np.array(np.pi / 2), gamma, a, b))
    there = arrivals(a, b, np.pi / 2, start, phi)
    psi = np.pi / 2 + there.turn
    square = b * np.sin(psi) ** 2
    return Flip(gamma, phi, psi, (a + square) * there.handle / (1 - square))


def draw(data: Data) -> Any:
    """Draw thick brown lines on the portrait, with dots at their ends."""
    figure, grid = style.canvas(6.4, 3.9)
    sheet = grid[0, 0]
    flip_portrait.lines(sheet, data.portrait, style.QUIET)
    flip = {"color": "#7a4a12", "linewidth": 2.2}
    for one in data.flips:
        sheet.plot(one.psi, one.rate, **flip)
        sheet.plot(one.psi[[0, -1]], one.rate[[0, -1]], "o", color="#7a4a12", markersize=3.5)
    sheet.set_xlim(-np.pi / 4, 5 * np.pi / 4)
    sheet.set_ylim(-1.0, 1.25)
    kinds = (("Δφ = 2π, from ψ = ε to π − ε", flip), ("separatrix, γ = 0", style.SEPARATRIX))
    style.legend(sheet, kinds, loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=2)
    return figure
