"""The laws of the formulas: proved on symbols, and true in balls, mpmath and float64."""

import random
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from flint import arb
from formula_laws import LAWS, Equations, Law, Point
from hypothesis import strategies as st
from strategies import law, rational
from sympy import Rational

from tresym.reals.decisions.identity import decide
from tresym.reals.domain.conditions import Given
from tresym.reals.language.sympy import from_sympy
from tresym.reals.numbers.arithmetic import balls, mp_precision
from tresym.reals.verdict import Verdict

NAMES = ("theta", "psi", "a", "b", "M", "I1", "I2", "I3", "c", "S")
GIVEN = "a > 0, 0 < b < 1, M > 0, I1 > 0, I2 > I1, I3 > I2, c > 0"

each_law = pytest.mark.parametrize("says", LAWS, ids=lambda says: says.__name__)


def symbolic(says: Law) -> Equations:
    import sympy

    return says(Point(**{name: sympy.Symbol(name, real=True) for name in NAMES}), sympy)


def verdict(terms: Sequence[Any]) -> Verdict:
    """Whether the first term is the opposite of the sum of the others."""
    left, right = (from_sympy(x) for x in (terms[0], -sum(terms[1:])))
    return decide(left, right, Given.parse(GIVEN)).verdict


@each_law
def test_a_law_of_the_formulas_is_proved_on_symbols(says: Law) -> None:
    for terms in symbolic(says):
        assert verdict(terms) is Verdict.PROVED


@each_law
def test_a_false_law_is_refuted_on_symbols(says: Law) -> None:
    for first, *rest in symbolic(says):
        assert verdict([first * Rational(1_000_001, 1_000_000), *rest]) is Verdict.REFUTED


def point_of(number: int) -> dict[str, Fraction]:
    """A point, by its number: drawing ten fractions takes longer than trying all laws on them."""
    dice = random.Random(number)

    def between(low: float, high: float) -> Fraction:
        return Fraction(dice.uniform(low, high)).limit_denominator(10**6)

    def even(low: int, high: int) -> Fraction:
        return Fraction(10 ** dice.uniform(low, high)).limit_denominator(10**6)

    first, second, third = even(-2, 1), even(-2, 1), even(-2, 1)
    return {
        "theta": between(-4, 4),
        "psi": between(-8, 8),
        "a": even(-3, 2),
        "b": between(0.001, 0.99),
        "M": even(-2, 2),
        "I1": first,
        "I2": first + second,
        "I3": first + second + third,
        "c": even(-2, 2),
        "S": Fraction(dice.choice([-1, 1])),
    }


points = st.integers(0, 2**64).map(point_of)


def check(point: dict[str, Fraction], convert: Any, m: Any, small: Any) -> None:
    at = Point(**{name: convert(value) for name, value in point.items()})
    for says in LAWS:
        for terms in says(at, m):
            size = 1 + sum(abs(term) for term in terms)
            assert abs(sum(terms)) <= small * size, says.__name__


@law(points)
def test_a_law_of_the_formulas_in_balls(point: dict[str, Fraction]) -> None:
    at = Point(**{name: arb(rational(value)) for name, value in point.items()})
    for says in LAWS:
        for terms in says(at, balls):
            total = sum(terms)
            assert total.contains(0), says.__name__
            assert total.rad() < arb("1e-100"), says.__name__


@law(points)
def test_a_law_of_the_formulas_in_mpmath(point: dict[str, Fraction]) -> None:
    with mp_precision(50) as mp:
        check(point, lambda x: mp.mpf(x.numerator) / x.denominator, mp, mp.mpf("1e-42"))


@law(points)
def test_a_law_of_the_formulas_in_floats(point: dict[str, Fraction]) -> None:
    check(point, lambda x: np.float64(float(x)), np, 1e-12)
