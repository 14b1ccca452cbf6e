"""The orbits of one body as curves, on the momentum sphere and in both phase planes.

An orbit of γ is the intersection of a M₁² − b M₃² = γ with the unit sphere. Its parametrisation by
an angle u has no square root that vanishes on the curve, so it is smooth at turning points too.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tresym.racket.body import Shape, named_body
from tresym.racket.floats.flipmap import Floats

ILLUSTRATION = "book"
"""The body shown on the sphere; for a racket b/a is so small that the curves coincide."""


class DrawnOrbit(NamedTuple):
    """A closed curve: its γ and the points (M₁, M₂, M₃)/M, shape (n, 3)."""

    gamma: float
    momentum: Floats


def floats(shape: Shape) -> tuple[float, float]:
    """Return (a, b) of an exact shape in float64."""
    return int(shape.a.p) / int(shape.a.q), int(shape.b.p) / int(shape.b.q)


def shape_of(name: str) -> tuple[float, float]:
    """Return (a, b) of a named body in float64."""
    return floats(named_body(name).shape)


def orbit(a: float, b: float, gamma: float, side: int = 1, points: int = 241) -> DrawnOrbit:
    """Return the orbit of γ ≠ 0 with M₁ (rotating) or M₃ (oscillating) of the sign ``side``."""
    u = np.linspace(0.0, 2 * np.pi, points)
    if gamma > 0:
        third = np.sqrt((a - gamma) / (a + b)) * np.cos(u)
        first = side * np.sqrt((gamma + b * third**2) / a)
        second = np.sqrt((a - gamma) / a) * np.sin(u)
    else:
        first = np.sqrt((gamma + b) / (a + b)) * np.cos(u)
        third = side * np.sqrt((a * first**2 - gamma) / b)
        second = np.sqrt((gamma + b) / b) * np.sin(u)
    return DrawnOrbit(gamma, np.stack([first, second, third], axis=-1))


def separatrix(a: float, b: float, side: int = 1, points: int = 241) -> DrawnOrbit:
    """Return the great circle √a M₁ = ``side`` √b M₃, which holds two heteroclinic orbits."""
    u = np.linspace(0.0, 2 * np.pi, points)
    first = side * np.sqrt(b / (a + b)) * np.sin(u)
    return DrawnOrbit(0.0, np.stack([first, -np.cos(u), np.sqrt(a / (a + b)) * np.sin(u)], axis=-1))


def flip_plane(momentum: Floats, a: float, b: float) -> tuple[Floats, Floats]:
    """Return (ψ, dψ/dφ) of points of the sphere; ψ is continuous along the curve."""
    first, second, third = np.moveaxis(momentum, -1, 0)
    square = second**2 + third**2
    psi = np.unwrap(np.arctan2(third, -second))
    return psi, (a * square + b * third**2) * first / (square - b * third**2)


def handle_plane(momentum: Floats, a: float, b: float) -> tuple[Floats, Floats]:
    """Return (θ, dθ/dφ) of points of the sphere."""
    first, second, third = np.moveaxis(momentum, -1, 0)
    square = second**2 + third**2
    rate = b * np.sqrt(square) * second * third / (square - b * third**2)
    return np.arctan2(np.sqrt(square), first), rate


def rate_at(psi: Floats, gamma: Floats | float, a: float, b: float) -> Floats:
    """Return dψ/dφ ≥ 0 on the orbit of γ at ψ; NaN where the orbit does not reach ψ."""
    square = b * np.sin(psi) ** 2
    with np.errstate(invalid="ignore"):
        return np.asarray(np.sqrt((a + square) * (gamma + square)) / (1 - square))
