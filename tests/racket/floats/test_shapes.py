"""ε₀ of arrays of shapes: against balls, with what is promised, and what is no shape."""

import math

import numpy as np
import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from tresym.racket.flip.separatrix import solve
from tresym.racket.floats import shapes
from tresym.racket.floats.shapes import CHUNK, defects
from tresym.reals.numbers.arithmetic import ball_precision


def error(a: float, b: float, value: float) -> float:
    """value/ε₀ − 1 by balls."""
    exact = solve(fmpq(*a.as_integer_ratio()), fmpq(*b.as_integer_ratio()), 30).defect
    with ball_precision(160):
        return float(abs(arb(value) / exact - 1))


positive = st.floats(-8, 3).map(lambda x: 10.0**x)


@given(st.lists(st.tuples(positive, st.floats(1e-9, 1)), min_size=1, max_size=5))
def test_they_are_the_roots_to_a_few_roundings(shapes: list[tuple[float, float]]) -> None:
    a, b = map(np.array, zip(*shapes, strict=True))
    for one, p, q in zip(defects(a, b), a.tolist(), b.tolist(), strict=True):
        assert error(p, q, float(one)) < 2e-15 * (1 + math.pi * math.sqrt(p * q))


@pytest.mark.parametrize(
    ("a", "b"),
    [(1.0, 1.0), (1e-300, 1.0), (1e-12, 1e-12), (1e6, 1e-300), (4e4, 1.0), (0.5, 5e-324)],
)  # fmt: skip
def test_at_the_edges(a: float, b: float) -> None:
    value = float(defects(a, b))
    assert error(a, b, value) < 4e-15 * (1 + math.pi * math.sqrt(a * b))
    assert error(a, b, value * (1 + 1e-11)) > 4e-15 * (1 + math.pi * math.sqrt(a * b)) or a > 1e3


@pytest.mark.parametrize(
    ("a", "b"),
    [(0.0, 0.5), (-1.0, 0.5), (1.0, 0.0), (1.0, -0.5), (1.0, 1.0000000000000002), (math.nan, 1.0),
     (1.0, math.nan), (-1.0, -1.0)],
)  # fmt: skip
def test_what_is_no_shape_is_not_a_number(a: float, b: float) -> None:
    found = defects([a, 2.0], [b, 0.25])
    assert math.isnan(found[0])
    assert found[1] == float(defects(2.0, 0.25))


def test_shapes_broadcast_and_chunks_do_not_show() -> None:
    a, b = np.geomspace(1e-3, 50, 3)[:, None], np.linspace(0.01, 1, CHUNK // 3 + 5)
    table = defects(a, b)
    assert table.shape == (3, CHUNK // 3 + 5)
    whole = table.ravel()
    for i in (0, 1, CHUNK - 1, CHUNK, CHUNK + 1, whole.size - 1):
        row, column = divmod(i, b.size)
        assert whole[i] == pytest.approx(float(defects(a[row, 0], b[column])), rel=1e-15)
    assert defects([], []).shape == (0,)
    assert defects(1, 1).shape == ()


def test_far_out_it_may_be_nothing_and_is_no_more() -> None:
    found = defects([1e4, 1e6, 1e300, math.inf], 1.0)
    assert found[0] > 0
    assert (found[1:] < 1e-300).all() or np.isnan(found[3])


def test_they_fall_with_a_and_with_b() -> None:
    a, b = np.geomspace(1e-4, 1e4, 300), np.geomspace(1e-6, 1, 300)
    assert (np.diff(defects(a, 0.5)) < 0).all()
    assert (np.diff(defects(2.0, b)) < 0).all()
    assert (defects(a, 1e-12) < math.pi / 2).all()


def test_the_parts_are_as_near_as_they_say() -> None:
    """The guess to three parts in a hundred, the rough arctangent to 1e-5, and the last step."""
    k, r = (
        x.ravel() for x in np.meshgrid(np.geomspace(1e-3, 1e2, 60), np.geomspace(1e-3, 1e2, 60))
    )
    k, r = k[k * r <= 1], r[k * r <= 1]
    phase = np.full_like(k, 4.0)
    for _ in range(2000):
        phase = np.pi + np.arctan(r * np.tanh(k * phase))
    guess = shapes._guess(k, r)
    assert np.abs(guess / phase - 1).max() < 0.03
    x = np.geomspace(1e-6, 1e6, 2000)
    assert np.abs(shapes._rough_arctan(x) - np.arctan(x)).max() < 1.2e-5
    first = guess - shapes._halley(guess, k, r, shapes._rough_arctan)[0]
    step, tangent = shapes._halley(first, k, r, np.arctan)
    assert np.abs(first - step - phase).max() < 1e-13
    assert (np.abs(k * step) < 1e-3).all()
    assert np.abs(tangent - np.tanh(k * first)).max() < 1e-15


def test_a_planted_error_in_the_last_step_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    whole = shapes._halley
    monkeypatch.setattr(shapes, "_halley", lambda *x: (whole(*x)[0] * (1 + 1e-3), whole(*x)[1]))
    wrong = float(defects(0.3, 0.9))
    assert error(0.3, 0.9, wrong) > 1e-13
