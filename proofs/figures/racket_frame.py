"""Fig. 1: the frame (e₁, e₂, e₃) attached to the racket: handle a thick line, head a disk."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from tresym.proofs.figures.racket import Racket, racket
from tresym.proofs.figures.view import View, arrow, bare, label, view

from tresym.racket.floats.flipmap import Floats
from tresym.report.figures import style


class Data(NamedTuple):
    """The racket and the unit vectors of its frame (rows), in that frame."""

    racket: Racket
    axes: Floats


def data() -> Data:
    """Return the racket at rest in its own frame."""
    return Data(racket(), np.eye(3))


def draw(data: Data) -> Any:
    """Draw the racket, seen from above its face."""
    figure, grid = style.canvas(4.8, 3.1)
    sheet, eye = grid[0, 0], view(-62, 32)
    bare(sheet)
    sheet.set_xlim(-1.0, 1.6)
    sheet.set_ylim(-0.65, 1.0)
    body(sheet, eye, data.racket, np.eye(3))
    for vector, reach, name in zip(data.axes, (1.45, 0.95, 0.9), ("1", "2", "3"), strict=True):
        arrow(sheet, eye, reach * vector)
        label(sheet, eye, (reach + 0.1) * vector, rf"$\vec{{e}}_{name}$", fontsize=12)
    sheet.plot(0, 0, "o", color="black", markersize=4)
    return figure


def body(sheet: Any, eye: View, shape: Racket, frame: Floats, scale: float = 1.0) -> None:
    """Draw the racket with its axes e₁, e₂, e₃ along the rows of ``frame``."""
    rim = eye.flat(scale * shape.rim @ frame)
    sheet.fill(*rim.T, facecolor="#d55e00", alpha=0.35, edgecolor="none")
    for string in shape.strings:
        sheet.plot(*eye.flat(scale * string @ frame).T, color="0.45", linewidth=0.4)
    sheet.plot(*rim.T, color="#a34700", linewidth=2)
    handle = eye.flat(scale * shape.handle @ frame)
    sheet.plot(*handle.T, color="black", linewidth=5 * scale, solid_capstyle="round")
