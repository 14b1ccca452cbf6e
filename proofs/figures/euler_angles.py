"""Fig. 2: the Euler angles z-y-z with Z along the momentum: bare (left), on the racket (right).

θ is the angle from Z to the handle e₁, and φ the angle from X to its projection on the plane (X,
Y). The line of nodes N is horizontal and perpendicular to the handle; ψ is the angle from N to e₃.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from tresym.proofs.figures.racket import Racket, racket
from tresym.proofs.figures.racket_frame import body
from tresym.proofs.figures.view import View, arc, arrow, bare, circle, curve, label, view

from tresym.racket.floats.flipmap import Floats
from tresym.racket.motion.attitude import Attitude
from tresym.report.figures import style

PHI, THETA, PSI = 0.55, 1.0, 0.7


class Data(NamedTuple):
    """Three angles; the rows e₁, e₂, e₃ and N are unit vectors in space."""

    phi: float
    theta: float
    psi: float
    frame: Floats
    nodes: Floats
    racket: Racket


def data() -> Data:
    """Return one attitude in which all three angles are easily seen."""
    at = Attitude(*(np.array([x]) for x in (0.0, PHI, THETA, PSI)))
    second, third, first = at.rotations()[0].T
    nodes = np.array([-np.sin(PHI), np.cos(PHI), 0.0])
    return Data(PHI, THETA, PSI, np.stack([first, second, third]), nodes, racket())


def draw(data: Data) -> Any:
    """Draw both panels from the same direction."""
    figure, grid = style.canvas(7.2, 3.7, 1, 2)
    eye = view(72, 24)
    for sheet in grid[0]:
        bare(sheet, 1.22)
        _laboratory(sheet, eye)
        _angles(sheet, eye, data)
    left, right = grid[0]
    for vector, name in zip(data.frame, "123", strict=True):
        arrow(left, eye, vector, color="#a34700")
        label(left, eye, 1.13 * vector, rf"$\vec{{e}}_{name}$", color="#a34700", fontsize=11)
    body(right, eye, data.racket, data.frame, 0.85)
    arrow(right, eye, data.frame[2], color="#a34700")
    for vector, name in zip(data.frame[[0, 2]], "13", strict=True):
        label(right, eye, 1.12 * vector, rf"$\vec{{e}}_{name}$", color="#a34700", fontsize=11)
    return figure


def _laboratory(sheet: Any, eye: View) -> None:
    """The frame (X, Y, Z) and its horizontal circle."""
    curve(sheet, eye, circle([0, 0, 1]), seen=np.ones(181, bool), color="0.7", linewidth=0.8)
    names = (r"$\vec{X}$", r"$\vec{Y}$", r"$\vec{Z} \parallel \vec{M}$")
    for vector, name in zip(np.eye(3), names, strict=True):
        arrow(sheet, eye, vector, linewidth=0.9)
        label(sheet, eye, 1.14 * vector, name, fontsize=11)


def _angles(sheet: Any, eye: View, data: Data) -> None:
    """φ, θ and ψ as arcs, with the shadow of the handle and the line of nodes."""
    first, _, third = data.frame
    shadow = first * [1, 1, 0]
    for points in ([[0, 0, 0], shadow], [first, shadow]):
        sheet.plot(*eye.flat(np.array(points)).T, color="0.5", linewidth=0.8, linestyle="--")
    sheet.plot(*eye.flat(np.array([[0, 0, 0], data.nodes])).T, color="#0072b2", linewidth=1.2)
    label(sheet, eye, 1.08 * data.nodes, "N", color="#0072b2")
    level = shadow / np.linalg.norm(shadow)
    looks = (("φ", [1, 0, 0], level, 0.6), ("θ", [0, 0, 1], first, 0.38))
    for name, start, end, radius in (*looks, ("ψ", data.nodes, third, 0.6)):
        turn = arc(start, end, radius)
        sheet.plot(*eye.flat(turn).T, color="#0072b2", linewidth=1.4)
        label(sheet, eye, 1.22 * turn[len(turn) // 2], name, color="#0072b2", fontsize=11)
