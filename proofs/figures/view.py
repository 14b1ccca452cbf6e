"""Orthographic projection, with hidden parts drawn faintly."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from tresym.racket.floats.flipmap import Floats
from tresym.report.figures import style


class View(NamedTuple):
    """The viewer's axes in space, orthonormal: to the right, up, and towards the viewer."""

    right: Floats
    up: Floats
    towards: Floats

    def flat(self, points: Any) -> Floats:
        """Return points (..., 3) projected on the paper, shape (..., 2)."""
        return np.stack([points @ self.right, points @ self.up], axis=-1)

    def depth(self, points: Any) -> Floats:
        """Return the coordinate of points towards the viewer."""
        return np.asarray(points @ self.towards)


def view(azimuth: float, elevation: float) -> View:
    """Return the view from these angles in degrees; the third axis of space points up."""
    az, el = math.radians(azimuth), math.radians(elevation)
    towards = [math.cos(el) * math.cos(az), math.cos(el) * math.sin(az), math.sin(el)]
    up = [-math.sin(el) * math.cos(az), -math.sin(el) * math.sin(az), math.cos(el)]
    return View(np.array([-math.sin(az), math.cos(az), 0.0]), np.array(up), np.array(towards))


def bare(axes: Any, reach: float = 1.15) -> None:
    """Make the axes a blank sheet from −reach to reach."""
    axes.set_aspect("equal")
    axes.set_xlim(-reach, reach)
    axes.set_ylim(-reach, reach)
    axes.set_axis_off()


def curve(axes: Any, eye: View, points: Floats, seen: Any = None, **line: Any) -> None:
    """Draw a curve in space, faint where it is not ``seen``.

    ``seen`` marks visible points; by default those in front of the origin. Faint parts are thin and
    pale.
    """
    front = eye.depth(points) >= 0 if seen is None else np.asarray(seen)
    flat = eye.flat(points)
    # A neighbouring point is added to each part, so that there is no gap between the parts.
    for part, look in ((~front, {**line, "alpha": 0.3, "linewidth": 0.6}), (front, line)):
        near = part.copy()
        near[1:] |= part[:-1]
        if part.any():
            axes.plot(*np.where(near[:, None], flat, np.nan).T, **look)


def ball(axes: Any, **look: Any) -> None:
    """Draw the unit sphere as a filled disk."""
    options = {"facecolor": "0.96", "edgecolor": "0.5", "linewidth": 0.7, "zorder": 0, **look}
    axes.fill(*circle([0, 0, 1])[:, :2].T, **options)


def arrow(axes: Any, eye: View, end: Any, start: Any = (0, 0, 0), **look: Any) -> None:
    """Draw a straight arrow in space."""
    tail, head = eye.flat(np.array([start, end], dtype=float))
    options = {"arrowstyle": "-|>", "color": "0.15", "linewidth": 1.2, "shrinkA": 0, "shrinkB": 0}
    axes.annotate("", head, tail, arrowprops={**options, **look})


def label(axes: Any, eye: View, point: Any, text: str, **look: Any) -> None:
    """Write text at a point in space, readable on any background."""
    options = {"ha": "center", "va": "center", "color": "0.1"}
    x, y = eye.flat(np.asarray(point, dtype=float))
    axes.text(x, y, text, path_effects=style.halo(), **{**options, **look})


def arc(start: Any, end: Any, radius: float = 1.0, points: int = 61) -> Floats:
    """Return the shorter arc between two unit vectors that are not opposite, shape (points, 3)."""
    a, b = np.asarray(start, dtype=float), np.asarray(end, dtype=float)
    angle = math.atan2(float(np.linalg.norm(np.cross(a, b))), float(a @ b))
    t = np.linspace(0.0, angle, points)[:, None]
    across = b - (a @ b) * a
    return radius * (np.cos(t) * a + np.sin(t) * across / np.linalg.norm(across))


def circle(axis: Any, height: float = 0.0, points: int = 181) -> Floats:
    """Return the circle on the unit sphere at this height along the unit vector ``axis``."""
    axis = np.asarray(axis, dtype=float)
    first = np.cross(axis, [1.0, 0.0, 0.0] if abs(axis[0]) < 0.9 else [0.0, 1.0, 0.0])
    first /= np.linalg.norm(first)
    u = np.linspace(0.0, 2 * np.pi, points)[:, None]
    flat = np.cos(u) * first + np.sin(u) * np.cross(axis, first)
    return height * axis + math.sqrt(1 - height**2) * flat
