"""Fig. 11: ε₀ over the shapes (a, b), with the paper's bodies; impossible shapes are hatched.

A rigid body satisfies I₃ ≤ I₁ + I₂, that is b ≤ 1/(a+2). The printed moments of the three further
rackets and the printed a and b of one of them do not.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from tresym.proofs.figures.curves import floats

from tresym.racket.body import NAMED_BODIES
from tresym.racket.floats.flipmap import Floats
from tresym.racket.formulas.stable import separatrix_map
from tresym.report.figures import style

BODIES = ("str", "racket-1", "racket-2", "racket-3", "book", "ethylene")
REACH = (20.0, 0.4)
LEVELS = (0.01, 0.02, 0.05, 0.15, 0.25, 0.4, 0.6)
BEST = 2 * math.atan(math.exp(-math.pi))
"""The infimum of ε₀ over rigid bodies: the limit of planar bodies (b = 1/(a+2)) as a → ∞."""

_DASHED = {"linewidths": 1.4, "linestyles": [(0, (4, 2))]}


class Mark(NamedTuple):
    """A body: its name, shape, ε₀ (radians) and whether a rigid body can have that shape."""

    name: str
    a: float
    b: float
    defect: float
    realizable: bool


class Data(NamedTuple):
    """Columns a, rows b; ε₀ (radians) and realizability, shape (rows, columns); the bodies."""

    a: Floats
    b: Floats
    defect: Floats
    realizable: Any
    bodies: tuple[Mark, ...]


def data() -> Data:
    """Compute ε₀ at the centres of pixels by the fixed-point map, a contraction by b sin²ε₀."""
    a, b = (top * (np.arange(n) + 0.5) / n for top, n in zip(REACH, (360, 280), strict=True))
    defect = separatrix_defect(a[None, :], b[:, None])
    points = []
    for name in BODIES:
        shape = NAMED_BODIES[name].shape
        p, q = floats(shape)
        angle = float(separatrix_defect(np.array(p), np.array(q)))
        points.append(Mark(name, p, q, angle, shape.realizable))
    return Data(a, b, defect, b[:, None] * (a[None, :] + 2) <= 1, tuple(points))


def separatrix_defect(a: Floats, b: Floats) -> Floats:
    """Return ε₀ of many shapes with b ≤ 0.4, to rounding errors."""
    defect = np.zeros(np.broadcast(a, b).shape)
    for _ in range(48):
        defect = separatrix_map(defect, a, b, np)
    return defect


def draw(data: Data) -> Any:
    """Draw labelled level curves on a background that is lighter where ε₀ is larger."""
    figure, grid = style.canvas(6.6, 4.8)
    sheet = grid[0, 0]
    ground = sheet.imshow(
        np.log10(data.defect),
        extent=(0, REACH[0], 0, REACH[1]),
        origin="lower",
        aspect="auto",
        interpolation="none",
        cmap="cividis",
        vmin=-2.2,
        vmax=0.2,
    )
    lines = sheet.contour(data.a, data.b, data.defect, LEVELS, colors="white", linewidths=0.9)
    sheet.clabel(lines, fmt="%g", fontsize=7)
    sheet.contour(data.a, data.b, data.defect, [BEST], colors="white", **_DASHED)
    _planar(sheet, data.a)
    for point in data.bodies:
        sheet.plot(point.a, point.b, zorder=5, **_dot(point.realizable))
        _name(sheet, point)
    sheet.set_xlim(0, REACH[0])
    sheet.set_ylim(0, REACH[1])
    sheet.set_xlabel(r"$a = I_2/I_1 - 1$")
    sheet.set_ylabel(r"$b = 1 - I_2/I_3$")
    kinds = (
        ("planar bodies, $I_3 = I_1 + I_2$", {"color": "black", "linewidth": 1.4}),
        ("shape of a rigid body", _dot(True)),
        (r"$\varepsilon_0 = 2\,\arctan\,e^{-\pi}$", {"color": "0.5", "linestyle": (0, (4, 2))}),
        ("printed, but of no rigid body", _dot(False)),
    )
    style.legend(sheet, kinds, loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=2)
    bar = figure.colorbar(ground, label=r"$\varepsilon_0$ (rad)", extend="min")
    ticks = (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0)
    bar.set_ticks(np.log10(ticks), labels=[f"{x:g}" for x in ticks])
    return figure


def _dot(realizable: bool) -> dict[str, Any]:
    face = "black" if realizable else "white"
    return {
        "color": "black",
        "marker": "o",
        "linestyle": "",
        "markerfacecolor": face,
        "markersize": 6,
    }


def _planar(sheet: Any, a: Floats) -> None:
    """The planar bodies, and beyond them the shapes that no rigid body has."""
    edge = 1 / (a + 2)
    sheet.fill_between(
        a, edge, 1, facecolor="none", edgecolor="0.85", hatch="//", linewidth=0, zorder=1.5
    )
    sheet.plot(a, edge, color="white", linewidth=2.6)
    sheet.plot(a, edge, color="black", linewidth=1.4)
    sheet.text(12.5, 0.32, "no rigid body", color="white", fontsize=12, ha="center")


def _name(sheet: Any, point: Mark) -> None:
    sheet.annotate(
        point.name,
        (point.a, point.b),
        {"racket-1": (-7, -5), "racket-3": (7, 0)}.get(point.name, (7, -3)),
        textcoords="offset points",
        ha="right" if point.name == "racket-1" else "left",
        fontsize=8,
        path_effects=style.halo(),
        zorder=6,
    )
