"""The body's attitude in space over time, in float64, for pictures only.

φ, θ, ψ are the paper's z-y-z Euler angles: R = R_z(φ) R_y(θ) R_z(ψ) takes the body axes (e₂, e₃,
e₁) to the space axes (X, Y, Z), with Z along the angular momentum. ψ and θ are computed by the
closed form of :mod:`tresym.racket.floats.flipmap`, so that the momentum is conserved to rounding
errors, however long the motion. Time is measured in units of I₂/M.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from tresym.racket.body import Exact
from tresym.racket.floats.flipmap import Floats, arrivals


class Attitude(NamedTuple):
    """Euler angles (radians) and time (units of I₂/M) along a motion; arrays of equal length."""

    time: Floats
    phi: Floats
    theta: Floats
    psi: Floats

    def rotations(self) -> Floats:
        """Return rotation matrices, shape (n, 3, 3); their columns are e₂, e₃, e₁ in space."""
        return _about_z(self.phi) @ _about_y(self.theta) @ _about_z(self.psi)

    def handle(self) -> Floats:
        """Return the curve of the handle e₁ on the unit sphere in space, shape (n, 3)."""
        sine = np.sin(self.theta)
        return np.stack(
            [sine * np.cos(self.phi), sine * np.sin(self.phi), np.cos(self.theta)], axis=-1
        )

    def momentum(self) -> Floats:
        """Return the unit angular momentum in body axes (M₁, M₂, M₃)/M, shape (n, 3)."""
        sine = np.sin(self.theta)
        return np.stack(
            [np.cos(self.theta), -sine * np.cos(self.psi), sine * np.sin(self.psi)], axis=-1
        )


def attitude(
    a: Exact | float,
    b: Exact | float,
    psi0: float,
    rate: float,
    precession: float = 2 * math.pi,
    points: int = 257,
) -> Attitude:
    """Compute the attitude from the start (ψ₀, dψ/dφ) with φ = 0.

    Args:
        a: I₂/I₁ − 1 > 0.
        b: 1 − I₂/I₃, in (0, 1].
        psi0: ψ at the start in radians.
        rate: dψ/dφ at the start.
        precession: Δφ in radians.
        points: the number of equally spaced values of φ.

    Returns:
        NaN if no body of this shape has such a start.

    Raises:
        InputError: a or b out of range.
    """
    phi = np.linspace(0.0, precession, points)
    there = arrivals(a, b, psi0, rate, phi)
    theta = np.arctan2(there.level, there.handle)
    return Attitude(there.time, phi, theta, psi0 + there.turn)


def _about_z(angle: Floats) -> Floats:
    cosine, sine = np.cos(angle), np.sin(angle)
    zero, one = np.zeros_like(angle), np.ones_like(angle)
    rows = [[cosine, -sine, zero], [sine, cosine, zero], [zero, zero, one]]
    return np.moveaxis(np.array(rows), -1, 0)


def _about_y(angle: Floats) -> Floats:
    cosine, sine = np.cos(angle), np.sin(angle)
    zero, one = np.zeros_like(angle), np.ones_like(angle)
    rows = [[cosine, zero, sine], [zero, one, zero], [-sine, zero, cosine]]
    return np.moveaxis(np.array(rows), -1, 0)
