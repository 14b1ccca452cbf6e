"""The attitude in space: the momentum stays, and the spin is the one it asks for."""

import math

import numpy as np
import pytest

from tresym.racket.body import named_body
from tresym.racket.motion.attitude import attitude

STR = named_body("str").shape
A, B = 1517 / 121, 55 / 874
STARTS = [(0.1, 0.2), (0.1, -0.2), (0.5, 0.0), (0.1, -3.0), (math.pi / 2, 0.4)]


@pytest.mark.parametrize(("psi0", "rate"), STARTS)
def test_the_momentum_is_fixed_in_space_to_rounding(psi0, rate):
    motion = attitude(STR.a, STR.b, psi0, rate, 200 * math.pi, 2001)
    body = motion.momentum()[:, [1, 2, 0]]
    space = np.einsum("nij,nj->ni", motion.rotations(), body)
    assert np.abs(space - [0, 0, 1]).max() < 1e-15


@pytest.mark.parametrize(("psi0", "rate"), STARTS)
def test_the_angular_velocity_of_the_rotation_gives_that_momentum(psi0, rate):
    """R⁻¹ dR/dτ by differences, times the moments of inertia: physics, no angles."""
    motion = attitude(STR.a, STR.b, psi0, rate, math.pi, 4001)
    rotations = motion.rotations()
    slopes = np.gradient(rotations, motion.time, axis=0)
    spin = np.einsum("nji,njk->nik", rotations, slopes)
    velocity = np.stack([spin[:, 2, 1], spin[:, 0, 2], spin[:, 1, 0]], axis=-1)
    inertia = np.array([1, 1 / (1 - B), 1 / (1 + A)])
    momentum = np.einsum("nij,nj->ni", rotations, velocity * inertia)
    assert np.abs(momentum[5:-5] - [0, 0, 1]).max() < 1e-5


def test_the_first_integral_is_conserved_along_the_motion():
    motion = attitude(STR.a, STR.b, 0.2, 0.1, 100 * math.pi, 5001)
    m1, _, m3 = motion.momentum().T
    gamma = A * m1**2 - B * m3**2
    assert np.ptp(gamma) < 1e-14


def test_the_handle_is_the_third_column_and_the_bounds_hold():
    motion = attitude(STR.a, STR.b, 0.5, 0.0, 8 * math.pi, 999)
    assert np.allclose(motion.rotations()[:, :, 2], motion.handle(), atol=1e-15)
    gamma = -B * math.sin(0.5) ** 2
    least = math.acos(math.sqrt((gamma + B) / (A + B)))
    assert motion.theta.min() >= least - 1e-12
    assert motion.theta.max() <= math.pi - least + 1e-12
    assert (np.diff(motion.time) > 0).all()
    assert motion.psi.min() >= 0.5 - 1e-12


def test_no_such_start():
    assert np.isnan(attitude(STR.a, STR.b, 0.0, 100.0, points=5).psi).all()
