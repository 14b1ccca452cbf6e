"""Laws of the flow in float64, many starts at once; and its errors are what they are said to be."""

import math
from fractions import Fraction

import numpy as np
from flint import fmpq
from hypothesis import example
from hypothesis import strategies as st
from strategies import Start, fly, fraction, law, starts, tame_shapes, turns

from tresym import InputError, flip_angle
from tresym.racket.body import Shape
from tresym.racket.floats.flipmap import arrivals, flip_map, flip_uncertainty

STARTS = 40
"""Starts in each array; counted as a quarter of so many examples."""


@law(starts(), turns)
@example((Shape(fmpq(1), fmpq(1, 1000)), Fraction(1, 100), Fraction(0)), Fraction(1, 100))
def test_the_float_map_is_as_good_as_it_says(start: Start, phi: Fraction) -> None:
    shape, psi, rate = start
    numbers = [float(fraction(x)) for x in shape] + [float(x) for x in (psi, rate, phi)]
    exact = [Fraction(x) for x in numbers]
    try:
        truth = flip_angle(*exact[:4], 20, precession=exact[4])
    except InputError:
        return
    a, b, *rest = numbers
    error = float(abs(truth.turn - float(flip_map(a, b, *rest))))
    assert error <= float(flip_uncertainty(a, b, *rest))


@law(starts(), turns)
def test_an_ode_solver_comes_to_the_same_end(start: Start, phi: Fraction) -> None:
    """scipy's DOP853 on the angle equations: it shares nothing with the ball it must lie in."""
    from scipy.integrate import solve_ivp

    (a, b), psi, rate = start
    p, q, psi0, rate0, end = (float(fraction(x)) if hasattr(x, "p") else float(x)
                              for x in (a, b, psi, rate, phi))  # fmt: skip

    def slopes(_: float, y: list[float]) -> list[float]:
        sine, cosine = math.sin(y[0]), math.cos(y[0])
        clock = 1 - q * sine * sine
        return [
            (p + q * sine * sine) * math.cos(y[1]) / clock,
            -q * math.sin(y[1]) * sine * cosine / clock,
        ]

    square = math.sin(psi0) ** 2
    handle = rate0 * (1 - q * square) / (p + q * square)
    found = solve_ivp(slopes, (0, end), [psi0, math.acos(handle)], method="DOP853",
                      rtol=1e-9, atol=1e-11)  # fmt: skip
    growth = math.exp(math.sqrt(p * q) * end)
    truth = fly(start, phi, 12)
    tolerance = 1e-7 * (1 + p) * growth / (1 - q)
    assert abs(found.y[0, -1] - float(truth.psi)) < tolerance
    assert abs(found.y[1, -1] - float(truth.theta)) < tolerance


def many(shape: Shape, number: int) -> tuple[float, float, np.ndarray, np.ndarray, np.ndarray]:
    """a, b and arrays of ψ₀, rates and Δφ."""
    a, b = (float(fraction(x)) for x in shape)
    random = np.random.default_rng(number)
    psi = random.uniform(-4, 4, STARTS)
    largest = (a + b * np.sin(psi) ** 2) / (1 - b * np.sin(psi) ** 2)
    rate, phi = largest * random.uniform(-0.99, 0.99, STARTS), random.uniform(0, 6, STARTS)
    return a, b, psi, rate, phi


seeds = st.integers(0, 2**32 - 1)


@law(tame_shapes(), seeds, each=STARTS // 4)
def test_many_floats_keep_gamma_momentum_and_bounds(shape: Shape, number: int) -> None:
    a, b, psi, rate, phi = many(shape, number)
    there = arrivals(a, b, psi, rate, phi)
    end = psi + there.turn
    before = a - (1 - _handle(a, b, psi, rate) ** 2) * (a + b * np.sin(psi) ** 2)
    gamma = a - (1 - there.handle**2) * (a + b * np.sin(end) ** 2)
    slope = 1 + a + 2 * b
    doubt = 1e-11 * slope + slope * flip_uncertainty(a, b, psi, rate, phi)
    assert np.all(np.abs(gamma - before) <= doubt)
    # |M| = 1: sin θ and cos θ come from different quotients
    assert np.all(np.abs(there.handle**2 + there.level**2 - 1) <= doubt)
    rotating = before > 1e-9
    assert np.all((there.handle * rate > 0)[rotating])
    oscillating = before < -1e-9
    assert np.all(np.abs(there.turn)[oscillating] < math.pi)
    assert np.all((b * np.sin(end) ** 2 + before >= -doubt)[oscillating])


def _handle(a: float, b: float, psi: np.ndarray, rate: np.ndarray) -> np.ndarray:
    """cos θ of a start."""
    square = np.sin(psi) ** 2
    return rate * (1 - b * square) / (a + b * square)


@law(tame_shapes(), seeds, each=STARTS // 4)
def test_many_floats_have_the_symmetries(shape: Shape, number: int) -> None:
    a, b, psi, rate, phi = many(shape, number)
    here = arrivals(a, b, psi, rate, phi)
    doubt = 2 * flip_uncertainty(a, b, psi, rate, phi)
    images = (
        (arrivals(a, b, -psi, -rate, phi), -1, -1),
        (arrivals(a, b, psi, -rate, -phi), 1, -1),
        (arrivals(a, b, -psi, rate, -phi), -1, 1),
    )
    for there, turn, handle in images:
        assert np.all(np.abs(there.turn - turn * here.turn) <= doubt)
        assert np.all(
            np.abs(there.handle - handle * here.handle) <= (1 + a + b) / a * (doubt + 1e-11)
        )


@law(tame_shapes(), seeds, each=STARTS // 4)
def test_many_floats_compose(shape: Shape, number: int) -> None:
    a, b, psi, rate, phi = many(shape, number)
    whole, half = arrivals(a, b, psi, rate, phi), arrivals(a, b, psi, rate, phi / 3)
    middle = psi + half.turn
    speed = half.handle * (a + b * np.sin(middle) ** 2) / (1 - b * np.sin(middle) ** 2)
    again = half.turn + flip_map(a, b, middle, speed, phi - phi / 3)
    allowed = flip_uncertainty(a, b, psi, rate, phi)
    allowed = allowed + flip_uncertainty(a, b, middle, speed, phi - phi / 3)
    exists = np.isfinite(again)
    growth = 1e-12 * (1 + a) * math.exp(2 * math.pi * math.sqrt(a * b)) / b
    assert np.all(np.abs(again - whole.turn)[exists] <= (100 * allowed + growth)[exists])
    assert exists.mean() > 0.9
