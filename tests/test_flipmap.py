"""The float64 map against balls, with every case the prototypes failed at."""

from __future__ import annotations

import math

import numpy as np
import pytest
from flint import arb, fmpq

import tresym
from tresym.body import Shape, named_body
from tresym.exact import InputError
from tresym.flip.angle import Angle
from tresym.flip.flipmap import arrivals, flip_map, flip_uncertainty
from tresym.flip.trajectory import Start, travel

STR = named_body("str").shape
TURN = Angle(fmpq(0), fmpq(*(2 * math.pi).as_integer_ratio()))


def exact(x: float) -> fmpq:
    return fmpq(*float(x).as_integer_ratio())


def errors(a: float, b: float, psi, rate) -> np.ndarray:
    """|map − ball| for each start, the float64 shape taken as it is."""
    values = flip_map(a, b, psi, rate)
    shape = Shape(exact(a), exact(b))
    found = []
    for p, v, value in zip(psi, rate, values, strict=True):
        ball = travel(shape, Start(Angle(fmpq(0), exact(p)), exact(v)), TURN, 20).turn
        found.append(float(abs(ball - arb(float(value))).mid()))
    return np.array(found)


def ratio(x: fmpq) -> float:
    return int(x.p) / int(x.q)


A, B = ratio(STR.a), ratio(STR.b)


@pytest.mark.parametrize("reach", [0.3, 3.0, 12.5])
def test_the_map_is_right_to_1e_11(reach):
    rng = np.random.default_rng(5)
    psi, rate = rng.uniform(-3, 3, 60), rng.uniform(-reach, reach, 60)
    assert errors(A, B, psi, rate).max() < 1e-11


def test_starts_at_quarter_turns_and_large_rates():
    psi = [math.pi / 2, -math.pi / 2, 3 * math.pi / 2, 0, 0, 0, math.pi, -math.pi, 0.1, 0.1]
    rate = [0.3, -0.3, 1, 0.5, -0.5, -2.5, -0.5, 0.5, 12, -12]
    assert errors(A, B, psi, rate).max() < 2e-12
    assert flip_map(A, B, 0, 0.5) == -flip_map(A, B, 0, -0.5)
    assert flip_map(A, B, 0, 0) == 0
    assert abs(flip_map(A, B, math.pi / 2, 0)) < 1e-15


@pytest.mark.parametrize("psi", [1e-5, 1e-12, 1e-100, 1e-150, 1e-300])
def test_tiny_offsets_keep_relative_accuracy(psi):
    error = errors(A, B, [psi], [0.0])[0]
    assert error < 1e-14 * flip_map(A, B, psi, 0.0)


def test_at_rest_where_nothing_moves():
    for a, b in ((A, B), (3.0, 1.0), (1e5, 1.0), (6e5, 0.46)):
        for psi in (math.pi / 2, -math.pi / 2, 0.0):
            assert abs(flip_map(a, b, psi, 0.0)) < 3e-16
            assert flip_uncertainty(a, b, 0.0, 0.0) == 0


def separatrix(a: float, b: float, psi):
    square = np.sin(psi) ** 2
    return np.sqrt(a + b * square) * np.sqrt(b * square) / (1 - b * square)


@pytest.mark.parametrize("growth", [0.9, 2.0, 3.0])
@pytest.mark.parametrize("b", [0.06, 0.5, 1.0])
def test_on_and_off_the_separatrix_the_error_is_what_is_said(growth, b):
    """√(ab) up to 3: errors grow by e^(2π√(ab)) ≈ 1e8, and the map says where."""
    a = growth**2 / b
    rng = np.random.default_rng(2)
    psi = np.concatenate([np.linspace(0.05, 3.1, 12), rng.uniform(-3, 3, 12)])
    reach = min(3, 0.9 * a)
    rate = np.concatenate([separatrix(a, b, psi[:12]), rng.uniform(-reach, reach, 12)])
    rate[1:12:2] *= -1
    said = flip_uncertainty(a, b, psi, rate)
    made = errors(a, b, psi, rate)
    assert (made < said).all()
    assert np.median(made[12:]) < 1e-13


@pytest.mark.parametrize(
    ("a", "b", "reach"), [(1e-9, 0.5, 1e-9), (1e6, 0.5, 10), (2.0, 1e-12, 1.9), (1e6, 1e-12, 10)]
)
def test_extreme_shapes(a, b, reach):
    rng = np.random.default_rng(9)
    psi, rate = rng.uniform(-3, 3, 15), rng.uniform(-reach, reach, 15)
    assert errors(a, b, psi, rate).max() < 1e-10


def test_where_no_such_start_exists_it_says_nan():
    psi = np.array([0.0, 0.0, 0.0, np.nan, np.inf, 1.0])
    rate = np.array([A, A * (1 + 1e-9), -2 * A, 0.0, 0.0, np.nan])
    assert np.isnan(flip_map(A, B, psi, rate)).tolist() == [False, True, True, True, True, True]


def test_shapes_broadcast_and_chunks_do_not_show():
    psi, rate = np.linspace(-3, 3, 101)[:, None], np.linspace(-2, 2, 90)
    grid = flip_map(STR.a, STR.b, psi, rate)
    assert grid.shape == (101, 90)
    alone = flip_map(STR.a, STR.b, psi[40, 0], rate[7])
    assert grid[40, 7] == pytest.approx(float(alone), rel=1e-14)
    assert flip_map(A, B, [], []).shape == (0,)
    assert tresym.flip_map("12.5", "0.06", 0.1, 0.2).shape == ()


def test_central_symmetry():
    rng = np.random.default_rng(0)
    psi, rate = rng.uniform(-3, 3, 500), rng.uniform(-3, 3, 500)
    difference = flip_map(A, B, psi, rate) + flip_map(A, B, -psi, -rate)
    assert np.abs(difference).max() < 1e-12


def test_the_precession_may_be_any_and_many():
    psi, rate = 0.3, 0.2
    turns = flip_map(A, B, psi, rate, [0.0, math.pi, 2 * math.pi, -math.pi])
    assert abs(turns[0]) < 1e-15
    there = arrivals(A, B, psi, rate, math.pi)
    square = math.sin(psi + turns[1]) ** 2
    speed = float(there.handle) * (A + B * square) / (1 - B * square)
    assert turns[1] + flip_map(A, B, psi + turns[1], speed, math.pi) == pytest.approx(
        turns[2], abs=1e-12
    )


@pytest.mark.parametrize(("a", "b"), [(-1.0, 0.5), (1.0, 0.0), (1.0, 1.5), ("x", "1")])
def test_shapes_out_of_range_are_refused(a, b):
    with pytest.raises(InputError):
        flip_map(a, b, 0.1, 0.1)
    with pytest.raises((InputError, ValueError)):
        flip_map(math.nan, 0.5, 0.1, 0.1)
