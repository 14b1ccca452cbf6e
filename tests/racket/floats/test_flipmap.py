"""The float64 map against balls, with every case the prototypes failed at."""

import math

import numpy as np
import pytest
from flint import arb, fmpq

import tresym
from tresym.racket.angle import Angle
from tresym.racket.body import Shape, named_body
from tresym.racket.floats import float_orbit
from tresym.racket.floats.flipmap import arrivals, flip_map, flip_uncertainty
from tresym.racket.motion.trajectory import Start, travel
from tresym.reals.numbers.exact import InputError

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
def test_the_map_is_right_to_2e_13(reach):
    rng = np.random.default_rng(5)
    psi, rate = rng.uniform(-3, 3, 60), rng.uniform(-reach, reach, 60)
    assert errors(A, B, psi, rate).max() < 2e-13


EDGES = (0.0, math.pi / 2, -math.pi / 2, 3 * math.pi / 2, math.pi, -math.pi, 1e-12, 1e-300, 0.1)


@pytest.mark.parametrize("psi", EDGES)
def test_at_every_edge_too(psi):
    """Quarter turns, unstable points and their neighbours; rates from 0 to the largest."""
    square = math.sin(psi) ** 2
    most = (A + B * square) / (1 - B * square)
    on_separatrix = math.sqrt((A + B * square) * B * square) / (1 - B * square)
    rates = np.array([0, 1e-300, 1e-12, 0.3, 2.5, 12, on_separatrix, most * (1 - 1e-15)])
    rates = np.concatenate([rates, -rates])
    assert errors(A, B, np.full(rates.size, psi), rates).max() < 2e-13


def test_a_planted_error_in_a_step_is_seen(monkeypatch):
    """The drift of the phase off by 1e-9: a hundred times what the errors are held to, and more."""
    right = float_orbit.orbit

    def wrong(*given):
        on = right(*given)
        return on._replace(drift=on.drift * (1 + 1e-9))

    monkeypatch.setattr(float_orbit, "orbit", wrong)
    assert errors(A, B, [0.3], [0.5]).max() > 1e-11


def test_starts_at_quarter_turns():
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
    assert errors(a, b, psi, rate).max() < 1e-11


HOSTILE = [
    # b = 1 at the angle where the precession stands still, and next to it
    (0.2, 1.0, -math.pi / 2, 0.0),
    (4.67, 1.0, math.pi / 2, 0.32),
    (4.8, 1.0, 1.5707963273856709, 0.0),
    (0.3, 1.0, math.pi / 2, 1.9e21),
    # small shapes near π/2, where an estimate was once exceeded
    (1.5e-7, 1.0, 1.5707954760856808, 0.0),
    (4.4e-5, 1.0, math.pi / 2, 0.0),
    # rates next to the largest on long and on thin bodies
    (8545.180096369711, 0.00014310905955628247, math.pi, 8545.179991391893),
    (6451.495619212201, 1e-12, 0.6047296781861622, -3855.057299673109),
    (102.67206671024692, 0.06, -4.6e-143, 102.67206671022929),
    # offsets whose squares vanish, on bodies that amplify them until they are large
    (2786.2, 0.99999999998701, 0.0, -1.4e-270),
    (25834.4, 0.9459955902681422, -8.6e-239, 0.0),
    (12.5, 0.06, 1e-170, 0.0),
]


@pytest.mark.parametrize(("a", "b", "psi", "rate"), HOSTILE)
def test_hostile_starts_are_answered_within_what_is_said(a, b, psi, rate):
    said = float(flip_uncertainty(a, b, psi, rate))
    assert np.isfinite(flip_map(a, b, psi, rate))
    assert errors(a, b, [psi], [rate])[0] <= said


def test_what_is_said_is_not_said_too_low_or_far_too_high():
    """Random starts of random shapes: never exceeded, and within four digits of what is made."""
    rng = np.random.default_rng(21)
    ratios = []
    for _ in range(60):
        a, b = 10 ** rng.uniform(-3, 2), rng.choice([1.0, rng.uniform(0.01, 1)])
        psi = rng.choice([rng.uniform(-4, 4), math.pi / 2 + 10 ** rng.uniform(-16, 0)])
        square, cosine = math.sin(psi) ** 2, math.cos(psi) ** 2
        rate = rng.uniform(-1, 1) * (a + b * square) / ((1 - b) + b * cosine)
        said = float(flip_uncertainty(a, b, psi, rate))
        made = errors(a, b, [psi], [rate])[0]
        assert made <= said
        ratios.append(said / max(made, 1e-300))
    assert np.median(ratios) < 1e4


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
    for wrong in (math.nan, math.inf, "nan", "1e101", "1e-101", 1e200):
        with pytest.raises(InputError):
            flip_map(wrong, 0.5, 0.1, 0.1)
    with pytest.raises(InputError, match="use flip_angle"):
        flip_map(1.0, "1e-9999", 0.1, 0.1)


def test_what_is_masked_is_no_start():
    psi = np.ma.masked_array([0.1, 0.2], [False, True])
    found = flip_map(A, B, psi, [1.0, 1.0])
    assert found[0] == flip_map(A, B, 0.1, 1.0)
    assert np.isnan(found[1])
    assert np.isnan(flip_map(A, B, 0.1, np.ma.masked_array([1], [True]))).all()


@pytest.mark.parametrize("start", ["x", None, 1j, ["a"], [[1, 2], [3]]])
def test_what_is_no_real_start_is_refused_in_one_sentence(start: object) -> None:
    with pytest.raises(InputError, match=r"^flip map: starts and precession are real numbers"):
        flip_map(1.0, 0.1, start, 0.4)
