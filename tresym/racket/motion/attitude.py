"""The body's attitude in space over time, in float64, for pictures only.

φ, θ, ψ are the paper's z-y-z Euler angles: R = R_z(φ) R_y(θ) R_z(ψ) takes the body axes (e₂, e₃,
e₁) to the space axes (X, Y, Z), with Z along the angular momentum. ψ and θ come from the closed
form of :mod:`tresym.racket.floats.flipmap`, so the momentum stays where it is to rounding, however
long the motion. Time is measured in units of I₂/M.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from tresym.racket.body import Exact
from tresym.racket.floats.flipmap import Floats, arrivals


class Attitude(NamedTuple):
    """Euler angles (radians) and time (units of I₂/M) along a motion; arrays of one length."""

    time: Floats
    phi: Floats
    theta: Floats
    psi: Floats

    def rotations(self) -> Floats:
        """Rotation matrices, shape (n, 3, 3); columns are the body axes e₂, e₃, e₁ in space."""
        return _about_z(self.phi) @ _about_y(self.theta) @ _about_z(self.psi)

    def handle(self) -> Floats:
        """The curve of the handle e₁ on the unit sphere in space, shape (n, 3)."""
        sine = np.sin(self.theta)
        return np.stack(
            [sine * np.cos(self.phi), sine * np.sin(self.phi), np.cos(self.theta)], axis=-1
        )

    def momentum(self) -> Floats:
        """The unit angular momentum in body axes (M₁, M₂, M₃)/M, shape (n, 3)."""
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
    """The attitude from the start (ψ₀, dψ/dφ), φ = 0, at ``points`` equal steps of φ.

    NaN where no body of this shape has such a start.

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
