"""All orders in ε*: exact coefficients by two routes, four arithmetics, a bound that holds."""

import mpmath
import numpy as np
import pytest
import sympy
from flint import arb, fmpq

from tresym.racket.flip import series
from tresym.racket.flip.separatrix import solve
from tresym.racket.formulas import stable
from tresym.reals.numbers.arithmetic import ball_precision, balls, to_mp

SHAPES = [
    (fmpq(1, 4), fmpq(1)),
    (fmpq(16380, 1210) - 1, 1 - fmpq(16380, 17480)),
    (fmpq(1, 2), fmpq(1, 2)),
    (fmpq(100), fmpq(1, 400)),
]


def test_coefficients_are_those_found_by_hand():
    ring = series.coefficients(3)[0].context()
    b, R = ring.gens()
    assert series.coefficients(3) == (
        ring.constant(1),
        (6 * b + 3 * R - 1) / 12,
        (50 * b**2 + 40 * b * R + 5 * R**2 - 20 * b - 10 * R + 1) / 80,
        (
            (1372 * b**3 + 1470 * b**2 * R + 378 * b * R**2 + 21 * R**3)
            - (882 * b**2 + 728 * b * R + 105 * R**2)
            + (126 * b + 63 * R - 3)
        )
        / 1344,
    )


@pytest.mark.parametrize("order", [0, 1, 6, 20])
def test_sympy_and_flint_generate_the_same_polynomials(order):
    ours = series.coefficients(order)
    theirs = series.coefficients_sympy(order)
    assert len(ours) == len(theirs) == order + 1
    for n, (one, other) in enumerate(zip(ours, theirs, strict=True)):
        table = {tuple(map(int, key)): (int(c.p), int(c.q)) for key, c in one.to_dict().items()}
        assert table == {key: (int(c.numerator), int(c.denominator)) for key, c in other.terms()}
        assert max(sum(key) for key in table) == n
        assert len(table) == (n + 1) * (n + 2) // 2


def test_lower_orders_are_the_same_polynomials():
    assert series.coefficients(4) == series.coefficients(9)[:5]


@pytest.mark.parametrize(("a", "b"), SHAPES)
def test_the_four_arithmetics_agree(a, b):
    order = 6
    with ball_precision(200):
        exact = series.expansion(order, arb(a), arb(b), balls)
    with mpmath.workdps(50):
        digits = series.expansion(order, to_mp(a, mpmath.mp), to_mp(b, mpmath.mp), mpmath.mp)
        assert abs(digits / mpmath.mpf(exact.str(50, radius=False)) - 1) < mpmath.mpf(10) ** -45
    shapes = np.array([float(a.p) / float(a.q)] * 3)
    floats = series.expansion(order, shapes, float(b.p) / float(b.q), np)
    assert floats.shape == (3,)
    assert np.allclose(floats, float(exact), rtol=1e-13)
    symbolic = series.expansion(order, sympy.Rational(int(a.p), int(a.q)), sympy.Symbol("b"), sympy)
    value = symbolic.subs("b", sympy.Rational(int(b.p), int(b.q))).evalf(40)
    assert abs(value / sympy.Float(exact.str(45, radius=False), 45) - 1) < sympy.Float("1e-35")


def test_the_expansion_is_better_than_the_leading_term_at_every_named_shape():
    for a, b in SHAPES:
        with ball_precision(200):
            exact = solve(a, b, 40).defect
            errors = [
                float(abs(series.expansion(order, arb(a), arb(b), balls) - exact))
                for order in range(8)
            ]
        assert errors == sorted(errors, reverse=True)


@pytest.mark.parametrize(("a", "b"), SHAPES)
def test_what_is_left_out_after_any_number_of_terms(a, b):
    """The claim ``every_order``: at most 4^−N/(2N + 3)."""
    with ball_precision(400):
        exact = solve(a, b, 90).defect
        leading = stable.leading_term(arb(a * b).sqrt(), arb(b / a).sqrt(), balls)
        for order in range(12):
            error = series.expansion(order, arb(a), arb(b), balls) / leading - exact / leading
            assert abs(error) < arb(4) ** -order / (2 * order + 3)
