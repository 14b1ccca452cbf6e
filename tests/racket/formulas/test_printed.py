"""Each formula, written once, in four arithmetics; and where the printed forms fail."""

import inspect
import math
from collections.abc import Callable
from fractions import Fraction
from itertools import product
from types import ModuleType
from typing import Any

import numpy as np
import pytest
import sympy
from flint import arb, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st

from tresym.racket.formulas import printed, stable
from tresym.reals.numbers.arithmetic import Balls, ball_precision, balls, mp_precision, to_mp

pytestmark = pytest.mark.slow

Formula = Callable[..., Any]


def formulas_of(module: ModuleType) -> list[Formula]:
    """The public functions a module defines."""
    return [
        f
        for name, f in vars(module).items()
        if inspect.isfunction(f) and f.__module__ == module.__name__ and not name.startswith("_")
    ]


FORMULAS = [f for module in (printed, stable) for f in formulas_of(module)]


def name_of(formula: Formula) -> str:
    return f"{formula.__module__.rpartition('.')[2]}.{formula.__name__}"


# Points: every name a formula may take, within the domain of all that take it


def between(low: str, high: str) -> st.SearchStrategy[Fraction]:
    return st.integers(0, 997).map(
        lambda i: Fraction(low) + (Fraction(high) - Fraction(low)) * Fraction(i, 997)
    )


def near(value: float) -> Fraction:
    return Fraction(value).limit_denominator(10**6)


@st.composite
def points(draw: st.DrawFn) -> dict[str, Fraction]:
    point = {
        "a": draw(between("1/1000", "20")),
        "b": draw(between("1/1000", "1")),
        "theta": draw(between("1/20", "3/2")),
        "psi": draw(between("1/20", "3/2")),
        "defect": draw(between("1/20", "3/2")),
        "phase": draw(between("3", "5")),
        "k": draw(between("1/100", "3")),
        "r": draw(between("1/100", "3")),
        "lam": draw(between("1/10", "2")),
        "mu": draw(between("1/20", "19/20")),
        "u": draw(between("1/100", "1/2")),
        "s": draw(between("1/20", "3")),
        "M": draw(between("1/2", "3")),
        "E": draw(between("1/2", "3")),
        "I1": draw(between("1/2", "1")),
        "I2": draw(between("11/10", "2")),
        "I3": draw(between("21/10", "3")),
        "S": draw(st.sampled_from([Fraction(1), Fraction(-1)])),
        "S2": draw(st.sampled_from([Fraction(1), Fraction(-1)])),
    }
    for i, name in enumerate(("M1", "M2", "M3", "Omega1", "Omega2", "Omega3"), start=1):
        point[name] = draw(between("-2", "2")) + Fraction(i, 7919)
    share = draw(between("1/10", "9/10"))
    point["psi_min"] = point["psi"] * share
    a, b, square = point["a"], point["b"], near(math.cos(point["theta"]) ** 2)
    # A trajectory through this θ, turning at a sin²ψ that leaves room below this ψ.
    room = near(math.sin(point["psi"]) ** 2) * share
    point["gamma"] = a * square - room * b * (1 - square)
    point["x"] = share * near(math.sqrt(b / (a + b)))
    return point


RANGES: dict[Formula, Callable[[dict[str, Fraction]], Fraction]] = {
    printed.psi_bounds: lambda p: -p["b"] * p["psi_min"] / 2,
    printed.theta_bounds_oscillating: lambda p: -p["b"] * p["psi_min"] / 2,
    printed.theta_bounds_rotating: lambda p: p["a"] * p["psi_min"] / 2,
}
"""Formulas for one sign of γ only."""


def arguments(formula: Formula, point: dict[str, Fraction]) -> list[Fraction]:
    point = dict(point)
    if formula in RANGES:
        point["gamma"] = RANGES[formula](point)
    return [point[name] for name in inspect.signature(formula).parameters if name != "m"]


def call(formula: Formula, values: list[Any], m: Any) -> tuple[Any, ...]:
    """The value or values of a formula in the arithmetic ``m``, always as a tuple."""
    namespace = [m] if "m" in inspect.signature(formula).parameters else []
    answer = formula(*values, *namespace)
    return answer if isinstance(answer, tuple) else (answer,)


def in_balls(formula: Formula, at: list[Fraction], precision: int) -> tuple[arb, ...]:
    with ball_precision(precision):
        return call(formula, [arb(fmpq(x.numerator, x.denominator)) for x in at], balls)


def in_floats(formula: Formula, at: list[Fraction]) -> tuple[Any, ...]:
    return call(formula, [np.float64(x.numerator / x.denominator) for x in at], np)


def exactly(x: Any) -> arb:
    """An mpmath, SymPy or float number as the ball that is exactly it."""
    if isinstance(x, float):
        return arb(x)
    sign, mantissa, exponent, _ = x._mpf_
    return arb((-int(mantissa) if sign else int(mantissa), int(exponent)))


@pytest.mark.slow
@pytest.mark.parametrize("formula", FORMULAS, ids=name_of)
@settings(max_examples=6)
@given(point=points())
def test_four_arithmetics_agree(formula: Formula, point: dict[str, Fraction]) -> None:
    at = arguments(formula, point)
    coarse, fine, best = (in_balls(formula, at, bits) for bits in (80, 160, 320))
    rough = in_balls(formula, at, 53)
    with mp_precision(90) as mp:
        multiple = call(formula, [to_mp(fmpq(x.numerator, x.denominator), mp) for x in at], mp)
    symbols = call(formula, [sympy.Rational(x.numerator, x.denominator) for x in at], sympy)
    floats = in_floats(formula, at)
    for i, truth in enumerate(best):
        third = exactly(sympy.N(symbols[i], 90))
        for enclosure in (coarse[i], fine[i]):
            assert enclosure.contains(exactly(multiple[i]))
            assert enclosure.contains(third)
        assert fine[i].rel_accuracy_bits() > 100
        with ball_precision(320):
            assert abs(arb(float(floats[i])) - truth) <= 8 * allowed_error(rough[i])


def allowed_error(rough: arb) -> arb:
    """One ulp of float64 times the formula's condition number, as a ball evaluation measures it.

    At 53 bits every operation of the ball contributes one rounding of float64, and its radius is
    what they can grow to in this formula at this point.
    """
    return abs(rough).upper() * arb((1, -53)) + rough.rad()


def test_formulas_take_arrays() -> None:
    for formula in FORMULAS:
        point = {
            "a": "1", "b": "1/2", "theta": "1", "psi": "1", "defect": "1", "phase": "4", "k": "1",
            "r": "1", "lam": "1", "mu": "1/2", "u": "1/4", "M": "1", "E": "1", "I1": "1", "I2": "2",
            "I3": "3", "S": "1", "S2": "1", "M1": "1", "M2": "1", "M3": "1", "psi_min": "1/2",
            "gamma": "1/10", "x": "1/4",
            "s": "1", "Omega1": "1", "Omega2": "1", "Omega3": "1",
        }  # fmt: skip
        at = arguments(formula, {name: Fraction(text) for name, text in point.items()})
        single = in_floats(formula, at)
        many = call(formula, [np.full(3, float(x)) for x in at], np)
        for one, array in zip(single, many, strict=True):
            np.testing.assert_allclose(array, np.full(3, one), rtol=1e-14)


# Where the printed forms lose their digits


def relative_error(formula: Formula, at: list[str], entry: int = 0) -> float:
    """How far float64 is off, against balls at 600 bits."""
    exact = [Fraction(text) for text in at]
    # The formula is asked about the floats it is given, so inputs carry no error of their own.
    exact = [Fraction(float(x)) for x in exact]
    truth = in_balls(formula, exact, 600)[entry]
    with np.errstate(all="ignore"):
        value = float(in_floats(formula, exact)[entry])
    with ball_precision(600):
        return float(abs(arb(value) / truth - 1)) if math.isfinite(value) else math.inf


NEAR_RIGHT_ANGLE = "1.570796326"

FAILURES = [
    pytest.param(
        printed.shape, ["3", "3.0000001", "5"], stable.shape, None, id="a of a nearly symmetric top"
    ),
    pytest.param(
        printed.depth,
        [NEAR_RIGHT_ANGLE, "1e-6", "2", "0.5"],
        stable.depth,
        None,
        id="gamma next to the unstable point",
    ),
    pytest.param(
        printed.separatrix_left, ["1e-6", "12", "0.06"], stable.separatrix_left, None, id="left"
    ),
    pytest.param(
        printed.turn_slope,
        [NEAR_RIGHT_ANGLE, "12", "0.06", "1"],
        stable.turn_slope,
        [NEAR_RIGHT_ANGLE, "12", "0.06"],
        id="dF/dgamma of a small turn",
    ),
    pytest.param(
        printed.theta_bounds_rotating,
        ["2", "0.5", "1.99999999999"],
        stable.theta_min,
        None,
        id="theta_min next to the stable rotation",
    ),
    pytest.param(
        printed.flip,
        ["1.57079632"],
        stable.flip_at,
        ["3.1415927", "1e-9", "1e-3"],
        id="the flip of a nearly symmetric top",
    ),
]


@pytest.mark.parametrize(("form", "at", "repaired", "there"), FAILURES)
def test_printed_forms_lose_digits_and_stable_ones_do_not(
    form: Formula, at: list[str], repaired: Formula, there: list[str] | None
) -> None:
    assert relative_error(form, at) > 1e-10
    assert relative_error(repaired, there or at) < 2e-15


def test_the_energy_form_of_gamma_loses_what_the_momentum_form_keeps() -> None:
    momentum = [Fraction(float(x)) for x in (1e-8, 1.0, 1e-8)]
    moments = [Fraction(float(x)) for x in (1.0, 2.0, 2.5)]
    truth = 2 * moments[1] * printed.energy(*momentum, *moments) / sum(x**2 for x in momentum) - 1
    energy = printed.energy(*map(float, momentum), *map(float, moments))
    size = math.sqrt(printed.momentum_squared(*map(float, momentum)))
    by_energy = printed.depth_from_energy(energy, size, float(moments[1]))
    shape = stable.shape(*map(float, moments))
    by_momentum = stable.depth_from_momentum(*map(float, momentum), *shape)
    assert abs(by_energy / float(truth) - 1) > 1e-3
    assert abs(by_momentum / float(truth) - 1) < 1e-14


@pytest.mark.slow
@given(point=points())
def test_printed_and_stable_forms_are_the_same_quantity(point: dict[str, Fraction]) -> None:
    pairs = [
        (printed.shape, stable.shape),
        (printed.depth, stable.depth),
        (printed.separatrix_left, stable.separatrix_left),
    ]
    for form, repaired in pairs:
        at = arguments(form, point)
        left, right = in_balls(form, at, 300), in_balls(repaired, at, 300)
        assert all(x.overlaps(y) for x, y in zip(left, right, strict=True))
    rational = {name: fmpq(x.numerator, x.denominator) for name, x in point.items()}
    with ball_precision(300):
        a, b, psi, defect = (arb(rational[name]) for name in ("a", "b", "psi", "defect"))
        slope = printed.turn_slope(defect, a, b, 1, balls)
        assert slope.overlaps(stable.turn_slope(defect, a, b, balls))
        k, r = (a * b).sqrt(), (b / a).sqrt()
        phase = stable.phase(defect, a, b, balls)
        assert stable.separatrix_map(defect, a, b, balls).overlaps(
            stable.defect_at(phase, k, r, balls)
        )
        turning = -b * balls.sin(arb(rational["psi_min"])) ** 2
        assert (turning + b * balls.sin(psi) ** 2).overlaps(
            stable.radicand(psi, arb(rational["psi_min"]), b, balls)
        )


def test_balls_are_made_of_balls_only() -> None:
    """python-flint's unbound methods read the memory of any object as if it were an ``arb``."""
    for name, other in product(
        [n for n in vars(Balls) if not n.startswith("_") and n != "pi"], [3, 0.5, "x", None]
    ):
        operands = (other, arb(1)) if name == "atan2" else (other,)
        with pytest.raises((AttributeError, TypeError)):
            getattr(balls, name)(*operands)
