"""Fig. 4: the phase portrait of the flip angle, (ψ, dψ/dφ), of the standard racket."""

from __future__ import annotations

from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np
from tresym.proofs.figures.curves import flip_plane, orbit, rate_at, shape_of

from tresym.racket.floats.flipmap import Floats
from tresym.report.figures import style

OSCILLATING = (-0.06, -0.05, -0.036, -0.022, -0.01, -0.003)
ROTATING = (0.003, 0.012, 0.03, 0.06, 0.1)


class Curve(NamedTuple):
    """An orbit in the phase plane: its γ, ψ (radians) and dψ/dφ."""

    gamma: float
    psi: Floats
    rate: Floats


class Data(NamedTuple):
    """The curves of one cell 0 ≤ ψ ≤ π (the portrait has period π), and its separatrix."""

    a: float
    b: float
    oscillating: tuple[Curve, ...]
    rotating: tuple[Curve, ...]
    separatrix: Curve


def data(body: tuple[float, float] | None = None) -> Data:
    """Compute orbits of the standard racket, or of the shape ``body``, for a few values of γ."""
    standard = shape_of("str")
    a, b = body or standard
    part = 1.0 if body is None else b / standard[1]
    oscillating = [gamma * part for gamma in OSCILLATING]
    rotating = [gamma * part for gamma in ROTATING if gamma * part < a]
    psi = np.linspace(0.0, np.pi, 181)
    closed = tuple(Curve(g, *flip_plane(orbit(a, b, g).momentum, a, b)) for g in oscillating)
    through = tuple(Curve(g, psi, rate_at(psi, g, a, b)) for g in rotating)
    return Data(a, b, closed, through, Curve(0.0, psi, rate_at(psi, 0.0, a, b)))


def draw(data: Data) -> Any:
    """Draw two cells, so that two unstable points are inside."""
    figure, grid = style.canvas(6.4, 3.9)
    sheet = grid[0, 0]
    lines(sheet, data)
    for x, name in ((0, "unstable"), (np.pi, "unstable"), (np.pi / 2, "stable")):
        face = "white" if name == "unstable" else "black"
        sheet.plot(x, 0, "o", color="black", markerfacecolor=face, markersize=5, zorder=5)
    top = 1.75 if (data.a, data.b) == shape_of("str") else 1.15 * _highest(data)
    sheet.set_ylim(-top, top)
    style.legend(sheet, style.ORBITS, loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=3)
    return figure


def _highest(data: Data) -> float:
    """The largest dψ/dφ that is drawn."""
    return max(float(curve.rate.max()) for curve in (*data.rotating, data.separatrix))


def lines(sheet: Any, data: Data, look: dict[str, Any] | None = None) -> None:
    """Draw all orbits for −π/2 ≤ ψ ≤ 3π/2, each in its own style or all in the given one."""
    for shift in (-np.pi, 0.0, np.pi):
        for on in data.oscillating:
            sheet.plot(on.psi + shift, on.rate, **(look or style.OSCILLATING))
        for on in data.rotating:
            for sign in (1, -1):
                sheet.plot(on.psi + shift, sign * on.rate, **(look or style.ROTATING))
        for sign in (1, -1):
            psi = data.separatrix.psi + shift
            sheet.plot(psi, sign * data.separatrix.rate, **style.SEPARATRIX)
    sheet.set_xlim(-np.pi / 2, 3 * np.pi / 2)
    style.pi_ticks(sheet.xaxis, [Fraction(i, 2) for i in range(-1, 4)])
    sheet.set_xlabel("ψ (rad)")
    sheet.set_ylabel("dψ/dφ")
