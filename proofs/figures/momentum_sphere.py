"""Fig. 3: energy ellipsoid and momentum sphere; the curves on it; the angles θ and ψ on it.

All lengths are in units of M: the sphere is |M| = 1 and the ellipsoid M₁²(1+a) + M₂² + M₃²(1−b) =
1 + γ. The body is the paper's book, since a racket's curves would be too narrow to be seen.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
from tresym.proofs.figures.curves import ILLUSTRATION, DrawnOrbit, orbit, separatrix, shape_of
from tresym.proofs.figures.view import View, arc, arrow, ball, bare, circle, curve, label, view

from tresym.racket.floats.flipmap import Floats
from tresym.report.figures import style

EYE = view(38, 24)
LEVELS = (-0.29, -0.24, -0.17, -0.08, 0.1, 0.3, 0.55, 0.8, 1.0)
ELLIPSOIDS = (-0.15, 0.2)
REACH = 1.55
SHADES = 32
"""Steps between dark and light, each too small to be visible."""


class Data(NamedTuple):
    """Two pairs of intersection curves, all curves, and one momentum with its angles.

    ``radii`` are the semi-axes of the two ellipsoids, shape (2, 3); ``equilibria`` the unit vectors
    p₊, p_D and p₋; ``momentum`` the vector with the angles ``theta`` and ``psi``.
    """

    a: float
    b: float
    radii: Floats
    meetings: tuple[tuple[DrawnOrbit, DrawnOrbit], ...]
    orbits: tuple[DrawnOrbit, ...]
    separatrices: tuple[DrawnOrbit, DrawnOrbit]
    equilibria: Floats
    theta: float
    psi: float
    momentum: Floats


def data() -> Data:
    """Compute the curves of the book."""
    a, b = shape_of(ILLUSTRATION)
    radii = [[math.sqrt((1 + g) / x) for x in (1 + a, 1, 1 - b)] for g in ELLIPSOIDS]
    meetings = tuple((orbit(a, b, g, 1), orbit(a, b, g, -1)) for g in ELLIPSOIDS)
    orbits = tuple(orbit(a, b, g, side) for g in LEVELS for side in (1, -1))
    theta, psi = 0.9, 0.75
    sine = math.sin(theta)
    momentum = [math.cos(theta), -sine * math.cos(psi), sine * math.sin(psi)]
    return Data(
        a,
        b,
        np.array(radii),
        meetings,
        orbits,
        (separatrix(a, b), separatrix(a, b, -1)),
        np.array([[1.0, 0, 0], [0, 1.0, 0], [0, 0, 1.0]]),
        theta,
        psi,
        np.array(momentum),
    )


def draw(data: Data) -> Any:
    """Draw four panels, all from the same direction."""
    figure, grid = style.canvas(7.2, 7.2, 2, 2)
    titles = (r"oscillating, $2I_2E < M^2 < 2I_3E$", r"rotating, $2I_1E < M^2 < 2I_2E$")
    for i in range(2):
        bare(grid[0, i], REACH)
        grid[0, i].set_title(titles[i], pad=12)
        _surfaces(grid[0, i], data.radii[i], data.meetings[i])
    _curves(grid[1, 0], data)
    _angles(grid[1, 1], data)
    return figure


def shades(inverse: Floats, eye: View) -> Iterator[tuple[Floats, float]]:
    """Yield the parts of the surface x·diag(inverse)·x = 1 by brightness, darkest first.

    Each part is an outline on the paper, shape (n, 2), with its brightness from 0 to 1; the first
    is the whole surface. The normals n with n·light ≥ c form a cap of the sphere.
    """
    light = eye.towards + 0.5 * eye.up - 0.6 * eye.right
    light /= np.linalg.norm(light)
    yield _seen(circle(eye.towards), inverse, eye), 0.0
    for height in np.arange(1, SHADES) / SHADES:
        yield _seen(circle(light, float(height), 61), inverse, eye), float(height)


def _seen(normals: Floats, inverse: Floats, eye: View) -> Floats:
    """The visible outline of a line on the surface; hidden parts are replaced by the rim."""
    behind = np.minimum(eye.depth(normals), 0)[:, None]
    rim = normals - behind * eye.towards
    on = rim / np.linalg.norm(rim, axis=1, keepdims=True) / inverse
    return eye.flat(on / np.sqrt(np.sum(on**2 * inverse, axis=1, keepdims=True)))


def in_front(inverse: Floats, meeting: tuple[DrawnOrbit, DrawnOrbit], eye: View) -> Floats:
    """Return the outline of the cap of one surface that lies in front of the other."""
    near = max(meeting, key=lambda on: float(eye.depth(on.momentum.mean(axis=0))))
    normals = near.momentum * inverse
    return _seen(normals / np.linalg.norm(normals, axis=1, keepdims=True), inverse, eye)


def _surfaces(sheet: Any, radii: Floats, meeting: tuple[DrawnOrbit, DrawnOrbit]) -> None:
    from matplotlib.patches import Polygon

    sphere, ellipsoid = (np.ones(3), 0.95), (radii**-2, 0.55)
    # Two caps of one surface are outside the other: of the ellipsoid about its longest axis, or of
    # the sphere about the shortest. The other surface is drawn over it, then the near cap again.
    capped, belt = (sphere, ellipsoid) if meeting[0].gamma > 0 else (ellipsoid, sphere)
    cap = Polygon(in_front(capped[0], meeting, EYE), transform=sheet.transData)
    for (inverse, tone), within in ((capped, None), (belt, None), (capped, cap)):
        for outline, shade in shades(inverse, EYE):
            grey = str(round(tone * (0.62 + 0.38 * shade), 3))
            part = Polygon(outline, facecolor=grey, edgecolor="none")
            sheet.add_patch(part)
            part.set_clip_path(within)
    for on in meeting:
        # Visible where neither surface is in front: the outward normals point to the viewer.
        seen = (EYE.depth(on.momentum) >= 0) & (EYE.depth(on.momentum / radii**2) >= 0)
        look = {**style.kind(on.gamma), "linewidth": 2.0, "linestyle": "-"}
        curve(sheet, EYE, on.momentum, seen, **look)
    _axes(sheet, np.maximum(radii, 1))


def _axes(sheet: Any, starts: Floats) -> None:
    for vector, start, name in zip(np.eye(3), starts, "123", strict=True):
        arrow(sheet, EYE, (start + 0.24) * vector, start * vector, linewidth=1)
        label(sheet, EYE, (start + 0.35) * vector, rf"$\vec{{e}}_{name}$", fontsize=11)


def _curves(sheet: Any, data: Data) -> None:
    bare(sheet, REACH)
    ball(sheet)
    for on in data.orbits:
        curve(sheet, EYE, on.momentum, **style.kind(on.gamma))
    for on in data.separatrices:
        curve(sheet, EYE, on.momentum, **style.SEPARATRIX)
    for point, name in zip(data.equilibria, ("$p_+$", "$p_D$", "$p_-$"), strict=True):
        sheet.plot(*EYE.flat(point), "o", color="black", markersize=4)
        label(sheet, EYE, point + 0.13 * EYE.up - 0.06 * EYE.right, name, fontsize=11)
    style.legend(sheet, style.ORBITS, loc="upper center", bbox_to_anchor=(0.5, 0.14), ncols=2)


def _angles(sheet: Any, data: Data) -> None:
    bare(sheet, REACH)
    ball(sheet)
    _axes(sheet, np.ones(3))
    first, second, _ = data.equilibria
    shadow = data.momentum * [0, 1, 1]
    level = shadow / np.linalg.norm(shadow)
    arrow(sheet, EYE, data.momentum, color="#a34700", linewidth=1.8)
    label(sheet, EYE, 1.12 * data.momentum, r"$\vec{M}$", color="#a34700", fontsize=11)
    for points in ([[0, 0, 0], shadow], [data.momentum, shadow], [[0, 0, 0], -second]):
        sheet.plot(*EYE.flat(np.array(points)).T, color="0.5", linewidth=0.8, linestyle="--")
    turns = (("θ", arc(first, data.momentum, 0.4)), ("ψ", arc(-second, level, 0.7)))
    for name, turn in turns:
        sheet.plot(*EYE.flat(turn).T, color="#0072b2", linewidth=1.4)
        label(sheet, EYE, 1.2 * turn[len(turn) // 2], name, color="#0072b2", fontsize=11)
    label(sheet, EYE, -1.1 * second, r"$-\vec{e}_2$", color="0.4")
    for vector in np.eye(3):
        sheet.plot(*EYE.flat(np.array([0 * vector, vector])).T, color="0.15", linewidth=0.8)
