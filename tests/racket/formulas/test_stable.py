"""Where the printed formulas fall off a cliff, and that their stable forms do not.

The failures are asserted as well: they are what the atlas shows. Then hunts for the worst points of
our own methods; what they found stands as explicit examples.
"""

import math

import numpy as np
import pytest
from flint import arb, fmpq
from hypothesis import example, given, target
from hypothesis import strategies as st

from tresym.dev.bench import atlas, peers, turn
from tresym.dev.bench.flipmap import ball_flip
from tresym.dev.bench.truth import true_digits
from tresym.racket.body import Shape, named_body
from tresym.racket.flip import separatrix
from tresym.racket.flip.model_selection import MODELS, climb
from tresym.racket.floats.flipmap import flip_map, flip_uncertainty
from tresym.racket.floats.shapes import defects
from tresym.reals.numbers.exact import parse_number

PAIRS = {pair.name: pair for pair in atlas.PAIRS}
ROOT, LEFT = "root of the separatrix equation", "its left-hand side"
SLOPE, FLIP = r"$\partial F/\partial\gamma$ at $\gamma = 0$", r"flip $\Delta\psi$"
MOMENTS = "$a$ by the moments"
ANGLES, MOMENTUM = r"$\gamma$ by the angles", r"$\gamma$ by the momentum"
RADICAND, TURN = r"$\gamma + b\,\sin^2\psi$", r"$F(\psi, \gamma)$"
ROTATING = r"$F(\psi, \gamma)$, $\gamma > 0$"
THETA = r"$\theta_{\min}$"

CLIFFS = [
    # pair, x, y, precision, digits lost at least as printed, at most by the stable form
    (ROOT, "30", "1/2", 16, 10, 1.5),
    (ROOT, "100", "1/100", 16, 15, 1.5),
    (ROOT, "1000", "1/2", 50, 45, 1.5),
    (LEFT, "30", "1/2", 16, 12, 1),
    (LEFT, "1000", "1/10", 50, 45, 0.5),
    (SLOPE, "1e-7", "1", 16, 7, 7),
    (SLOPE, "1e-4", "1e-4", 16, 0.5, 1),
    (FLIP, "1e-8", "1e-6", 16, 2, 1),
    (FLIP, "1e-8", "1e-6", 50, 1.5, 0.5),
    (MOMENTS, "1e-8", "1", 16, 6, 0.5),
    (MOMENTS, "1e-8", "1", 50, 5, 0.5),
    (ANGLES, "1e-6", "1e-12", 16, 10, 2),
    (ANGLES, "1e-6", "1e-12", 50, 10, 1),
    (MOMENTUM, "1e-6", "1e-12", 16, 9, 2),
    (MOMENTUM, "1e-6", "1e-12", 50, 9, 1),
    (RADICAND, "1e-13", "1/10", 16, 10, 0.8),
    (RADICAND, "1e-13", "1/10", 50, 10, 0.5),
    (TURN, "1e-10", "1/10", 16, 6, 1),
    (TURN, "1e-13", "1/10", 50, 3, 0.5),
    (ROTATING, "1e-6", "7.743e-8", 16, 3, 1),
    (THETA, "1e-12", "1", 16, 10, 0.5),
    (THETA, "1e-12", "1", 50, 10, 0.5),
]


@pytest.mark.parametrize(("name", "x", "y", "digits", "printed", "stable"), CLIFFS)
def test_the_printed_form_fails_where_the_stable_one_does_not(
    name: str, x: str, y: str, digits: int, printed: float, stable: float
) -> None:
    at = PAIRS[name], parse_number(x), parse_number(y), digits
    assert atlas.digits_lost(*at, "printed") >= printed
    assert atlas.digits_lost(*at, "stable") <= stable


def test_every_pair_of_the_atlas_has_its_cliff() -> None:
    assert {row[0] for row in CLIFFS} == set(PAIRS)


def test_what_all_digits_lost_means() -> None:
    """At ab = 30 a root finder on the printed equation in float64 stops almost anywhere."""
    shape = Shape(fmpq(60), fmpq(1, 2))
    truth = separatrix.solve(*shape, 30).defect
    assert true_digits(peers.brentq_printed(shape, fmpq(0), 15), truth) < 5
    assert true_digits(float(defects(60.0, 0.5)), truth) > 14


def test_quad_loses_half_its_digits_at_the_turning_point(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    tried = ("mpmath quad, tanh-sinh", "mpmath quad of our substitution")
    monkeypatch.setattr(turn, "SCENES", ("-1/100",))
    found = [c for c in turn.contenders() if c.method in tried]
    rows = {c.method: c.judge(c.work()) for c in found}
    assert rows["mpmath quad, tanh-sinh"].digits < 35
    assert rows["mpmath quad of our substitution"].digits > 49


# Hunts on our own methods: hypothesis climbs towards the largest loss; the worst points it found
# in long runs are the examples.

logs = st.integers(0, 4095)


def power(n: int, low: float, high: float) -> float:
    """A float between 10^low and 10^high."""
    return 10 ** (low + (high - low) * n / 4095)


@given(n=logs, m=logs)
@example(n=0, m=4095)
@example(n=4095, m=4095)
@example(n=699, m=4094)
def test_arrays_of_shapes_lose_no_more_than_they_say(n: int, m: int) -> None:
    a, b = power(n, -9, 5), power(m, -9, 0)
    time = math.pi * math.sqrt(a * b)
    if time > 600:
        return
    truth = separatrix.solve(exact(a), exact(b), 25).defect
    error = 10 ** -true_digits(float(defects(a, b)), truth) / (1 + time)
    target(math.log10(max(error, 1e-18)))
    assert error < 2e-15


def exact(x: float) -> fmpq:
    return fmpq(*x.as_integer_ratio())


@pytest.mark.slow
@given(n=logs, m=logs, p=st.integers(0, 4095), q=st.integers(-4095, 4095))
def test_the_flip_map_is_as_good_as_it_says(n: int, m: int, p: int, q: int) -> None:
    a, b = power(n, -2, 2), power(m, -3, -0.02)
    psi, rate = 3.2 * p / 4095, 0.9 * a * q / 4095
    expected = float(flip_uncertainty(a, b, psi, rate))
    if not math.isfinite(expected):
        return
    found = float(flip_map(a, b, psi, rate))
    error = abs(float((ball_flip(a, b, psi, rate) - arb(found)).mid()))
    target(math.log10(max(error, 1e-30) / max(expected, 1e-30)))
    assert error <= expected


@given(n=logs, m=logs, g=st.integers(-4095, 4095), digits=st.sampled_from([3, 10, 30]))
def test_every_rung_that_answers_has_the_digits(n: int, m: int, g: int, digits: int) -> None:
    """The balls of all rungs that answer have a point in common, and their digits are true."""
    a, b = exact(power(n, -3, 2)), exact(power(m, -3, 0))
    gamma = fmpq(0) if abs(g) < 1365 else (a if g > 0 else b) * fmpq(g, 5000) ** 3
    shape, truth = Shape(a, b), climb(Shape(a, b), gamma, 60).defect
    for rung in MODELS:
        try:
            found = climb(shape, gamma, digits, rung).defect
        except ValueError:
            continue
        assert found.overlaps(truth)
        assert true_digits(found, truth) >= digits - 0.5


@pytest.mark.slow
@pytest.mark.parametrize("name", [ROOT, LEFT, MOMENTS, RADICAND, THETA])
@given(i=logs, j=logs)
def test_stable_forms_have_no_cliff_anywhere_on_their_plane(name: str, i: int, j: int) -> None:
    pair = PAIRS[name]
    plane = atlas.plane_of(pair)
    x, y = (
        fmpq(*power(n, low, high).as_integer_ratio())
        for n, (_, low, high) in ((i, plane.x), (j, plane.y))
    )
    lost = atlas.digits_lost(pair, x, y, 16, "stable")
    target(lost)
    assert lost < (3.2 if name == ROOT else 1.2)


def test_the_racket_at_its_turning_point_is_served_by_the_last_rung() -> None:
    shape = named_body("str").shape
    found = climb(shape, parse_number("-0.0034786129"), 30)
    assert found.rung == "planar"
    assert np.isclose(float(found.defect), 0.237335, atol=1e-5)
