"""Fig. 9: ψ over φ during one turn of the standard racket, from many ψ₀, for six values of γ."""

from __future__ import annotations

from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np
from tresym.proofs.figures.curves import rate_at, shape_of

from tresym.racket.floats.flipmap import Floats, arrivals
from tresym.report.figures import style

GAMMAS = (-0.03, 0.03, -0.003, 0.003, -0.0003, 0.0003)
STARTS = 13


class Panel(NamedTuple):
    """φ, shape (n,), and ψ of each start, shape (starts, n), in radians."""

    gamma: float
    phi: Floats
    psi: Floats


Data = tuple[Panel, ...]


def data(body: tuple[float, float] | None = None, gamma: float | None = None) -> Data:
    """Compute ψ(φ) from evenly spaced starts with dψ/dφ ≥ 0.

    The starts lie between the turning points of an oscillating orbit, or over half a turn of a
    rotating one.

    Args:
        body: (a, b) of another shape than the standard racket's; the γ are in proportion to b.
        gamma: only this level, −b < γ ≤ a and not 0.
    """
    a, b = body or shape_of("str")
    if gamma is not None:
        return (_panel(a, b, gamma),)
    part = 1.0 if body is None else b / shape_of("str")[1]
    return tuple(_panel(a, b, level * part) for level in GAMMAS)


def _panel(a: float, b: float, gamma: float) -> Panel:
    least = np.arcsin(np.sqrt(max(-gamma, 0.0) / b))
    start = np.linspace(least, np.pi - least, STARTS)
    rate = rate_at(start, gamma, a, b)
    if gamma < 0:
        rate[[0, -1]] = 0  # they turn there; a root of what is left by rounding would not
    phi = np.linspace(0.0, 2 * np.pi, 121)
    turn = arrivals(a, b, start[:, None], rate[:, None], phi).turn
    return Panel(gamma, phi, start[:, None] + turn)


def draw(data: Data) -> Any:
    """Draw γ < 0 left and γ > 0 right, nearer to the separatrix from top to bottom."""
    size = (7.2, 7.6, 3, 2) if len(data) > 1 else (5.0, 3.6, 1, 1)
    figure, grid = style.canvas(*size, sharex=True)
    for sheet, panel in zip(grid.flat, data, strict=True):
        for x in (0, np.pi, 2 * np.pi):
            sheet.axhline(x, color="0.75", linewidth=0.6, zorder=0)
        for psi in panel.psi:
            look = {**style.kind(panel.gamma), "linestyle": "-", "linewidth": 0.9}
            sheet.plot(panel.phi, psi, **look)
        sheet.set_title(f"γ = {panel.gamma:.3g}".replace("-", "−"))
        sheet.set_xlim(0, 2 * np.pi)
        style.pi_ticks(sheet.xaxis, [Fraction(i, 2) for i in range(5)])
        whole = panel.gamma > 0
        sheet.set_ylim(-0.15, 3 * np.pi if whole else np.pi + 0.15)
        style.pi_ticks(sheet.yaxis, [0, 1, 2, 3] if whole else [Fraction(i, 4) for i in range(5)])
    for sheet in grid[-1]:
        sheet.set_xlabel("φ (rad)")
    for sheet in grid[:, 0]:
        sheet.set_ylabel("ψ (rad)")
    return figure
