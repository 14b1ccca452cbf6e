"""Fig. 6: the curve of the handle on the sphere in space, for γ < 0 and γ > 0, with θ's bounds."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from tresym.proofs.figures.curves import ILLUSTRATION, rate_at, shape_of
from tresym.proofs.figures.view import arrow, ball, bare, circle, curve, label, view

from tresym.racket.floats.flipmap import Floats
from tresym.racket.formulas.stable import theta_min
from tresym.racket.motion.attitude import attitude
from tresym.report.figures import style

GAMMAS = (-0.1, 0.12)
TURNS = 5


class Motion(NamedTuple):
    """The handle e₁ in space, shape (n, 3), over the angle φ; θ and its bounds (radians)."""

    gamma: float
    phi: Floats
    theta: Floats
    handle: Floats
    bounds: tuple[float, float]


Data = tuple[Motion, Motion]


def data() -> Data:
    """Compute five turns of the handle of the book, from ψ = π/2."""
    a, b = shape_of(ILLUSTRATION)
    below, above = (_motion(a, b, gamma) for gamma in GAMMAS)
    return below, above


def _motion(a: float, b: float, gamma: float) -> Motion:
    rate = float(rate_at(np.array(np.pi / 2), gamma, a, b))
    found = attitude(a, b, np.pi / 2, rate, 2 * np.pi * TURNS, 200 * TURNS + 1)
    least = float(theta_min(a, b, gamma, np))
    most = np.pi - least if gamma < 0 else float(np.arccos(np.sqrt(gamma / a)))
    return Motion(gamma, found.phi, found.theta, found.handle(), (least, most))


def draw(data: Data) -> Any:
    """Draw both spheres from the same direction."""
    figure, grid = style.canvas(7.2, 3.7, 1, 2)
    eye = view(25, 20)
    for sheet, motion in zip(grid[0], data, strict=True):
        bare(sheet, 1.4)
        ball(sheet)
        names = (r"$\theta_{\min}$", r"$\theta_{\max}$")
        for bound, name in zip(motion.bounds, names, strict=True):
            height = np.array([0, 0, float(np.cos(bound))])
            curve(sheet, eye, circle([0, 0, 1], height[2]), color="0.2", linewidth=1.6)
            edge = height + (np.sin(bound) + 0.14) * eye.right
            label(sheet, eye, edge, name, fontsize=10)
        curve(sheet, eye, circle([0, 0, 1]), color="0.65", linewidth=0.7)
        look = {**style.kind(motion.gamma), "linestyle": "-", "linewidth": 1.3}
        curve(sheet, eye, motion.handle, **look)
        arrow(sheet, eye, [0, 0, 1.2], [0, 0, 1])
        label(sheet, eye, [0, 0, 1.28], r"$\vec{Z} \parallel \vec{M}$", fontsize=10)
        sign = "<" if motion.gamma < 0 else ">"
        kind = "oscillating" if motion.gamma < 0 else "rotating"
        sheet.set_title(f"γ = {motion.gamma} {sign} 0, {kind}".replace("-", "−"))
    return figure
