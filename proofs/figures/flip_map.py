"""Fig. 10: |Δψ| after one turn of the handle, over the starts (ψ₀, dψ/dφ) of the standard racket.

The right panel enlarges the rectangle around the unstable point (0, 0) in the left one.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np
from tresym.proofs.figures.curves import rate_at, shape_of

from tresym.racket.floats.flipmap import Floats, flip_map
from tresym.report.figures import style

REACH = (np.pi, 1.5)
ZOOM = (0.3, 0.27)
TOP = 1.5 * np.pi
"""The flip at the end of the colour scale; larger flips have the same colour."""


_DOTS = {**style.SEPARATRIX, "linewidth": 1.1, "linestyle": (0, (1, 3))}
"""The separatrix, dotted so that the colours below it can be seen."""


class Flips(NamedTuple):
    """Columns ψ₀ and rows dψ/dφ, both symmetric about 0; |Δψ| (radians), shape (rows, columns)."""

    psi: Floats
    rate: Floats
    flip: Floats


class Data(NamedTuple):
    """Both panels, and the separatrix dψ/dφ ≥ 0 over ``psi`` of each."""

    whole: Flips
    zoom: Flips
    separatrices: tuple[Floats, Floats]
    reach: tuple[float, float] = REACH
    zoomed: tuple[float, float] = ZOOM


def data(body: tuple[float, float] | None = None) -> Data:
    """Compute the flips at the centres of the pixels, of the standard racket or of ``body``."""
    a, b = body or shape_of("str")
    reach, zoomed = (REACH, ZOOM) if body is None else _windows(a, b)
    whole, zoom = _flips(a, b, *reach, 360, 240), _flips(a, b, *zoomed, 280, 280)
    separatrices = rate_at(whole.psi, 0.0, a, b), rate_at(zoom.psi, 0.0, a, b)
    return Data(whole, zoom, separatrices, reach, zoomed)


def _windows(a: float, b: float) -> tuple[tuple[float, float], tuple[float, float]]:
    """The extent of the panels: above the top of the separatrix, and along its slope at 0."""
    top = float(np.sqrt(b * (a + b)) / max(1 - b, 0.05))
    return (np.pi, 1.6 * top), (ZOOM[0], 0.95 * float(np.sqrt(a * b)) * ZOOM[0])


def _flips(a: float, b: float, width: float, height: float, columns: int, rows: int) -> Flips:
    psi = width * (2 * np.arange(columns) + 1 - columns) / columns
    rate = height * (2 * np.arange(rows) + 1 - rows) / rows
    return Flips(psi, rate, np.abs(flip_map(a, b, psi[None, :], rate[:, None])))


def draw(data: Data) -> Any:
    """Draw both panels on one colour scale, with the exact flip Δψ = π outlined."""
    figure, grid = style.canvas(7.4, 3.5, 1, 2, width_ratios=(1.45, 1))
    for sheet, part, rate, reach in zip(
        grid[0], data[:2], data.separatrices, (data.reach, data.zoomed), strict=True
    ):
        image = sheet.imshow(
            part.flip,
            extent=(-reach[0], reach[0], -reach[1], reach[1]),
            origin="lower",
            aspect="auto",
            interpolation="none",
            cmap="cividis",
            vmin=0,
            vmax=TOP,
        )
        sheet.contour(part.psi, part.rate, part.flip, [np.pi], colors="white", linewidths=0.9)
        sheet.set_xlabel(r"$\psi_0$ (rad)")
        for sign in (1, -1):
            sheet.plot(part.psi, sign * rate, **_DOTS)
        sheet.plot(0, 0, "o", color="black", markerfacecolor="white", markersize=4)
    left, right = grid[0]
    x, y = data.zoomed
    left.plot([-x, x, x, -x, -x], [-y, -y, y, y, -y], color="black", linewidth=1.2)
    left.set_ylabel(r"$(d\psi/d\phi)_0$")
    style.pi_ticks(left.xaxis, [Fraction(i, 2) for i in range(-2, 3)])
    left.set_title("dotted: γ = 0; white: |Δψ| = π")
    right.set_title("the rectangle")
    bar = figure.colorbar(image, ax=grid[0].tolist(), label="|Δψ| (rad)", extend="max")
    style.pi_ticks(bar.ax.yaxis, [Fraction(i, 4) for i in range(7)])
    return figure
