"""Values apart from the engine, by balls that walk over SymPy expressions."""

import mpmath
import pytest
from flint import acb, arb, fmpq
from sympy import (
    Abs,
    Basic,
    Derivative,
    Integer,
    Integral,
    Subs,
    Symbol,
    acosh,
    asin,
    atanh,
    exp,
    log,
    pi,
    sign,
    sin,
    sqrt,
    tan,
)

from tresym.ledger.ball_evaluation import value
from tresym.reals.numbers.arithmetic import ball_precision

x, y, t = (Symbol(name, real=True) for name in "xyt")

VALUES = [
    (sin(x) * exp(x) / (1 + x**2), lambda m, v: m.sin(v) * m.exp(v) / (1 + v**2)),
    (x**pi + sqrt(x) + x ** Integer(-3), lambda m, v: v**m.pi + m.sqrt(v) + v**-3),
    (Abs(-x) + sign(x), lambda m, v: v + 1),
    (Integral(exp(-t * x), (t, 0, 1)), lambda m, v: (1 - m.exp(-v)) / v),
    (Integral(sqrt(t), (t, 0, x)), lambda m, v: 2 * v ** m.mpf("1.5") / 3),
    (Derivative(x**3 * log(x), x), lambda m, v: 3 * v**2 * m.log(v) + v**2),
    (Subs(t**2 + x, t, x), lambda m, v: v**2 + v),
    (asin(x / 2) + atanh(x / 2), lambda m, v: m.asin(v / 2) + m.atanh(v / 2)),
]


@pytest.mark.parametrize(("e", "expected"), VALUES, ids=[str(e) for e, _ in VALUES])
def test_values_agree_with_mpmath(e: Basic, expected: object) -> None:
    assert callable(expected)
    with ball_precision(128), mpmath.workdps(30):
        found = value(e, {x: arb(fmpq(7, 5))})
        near = arb(mpmath.nstr(expected(mpmath.mp, mpmath.mpf(7) / 5), 25))
        assert abs(found - near).contains(0) or abs(found - near) < 1e-20
        assert found.rad() < 1e-2


@pytest.mark.parametrize(
    ("e", "at"),
    [
        (1 / x, 0),
        (sqrt(x), -1),
        (log(x), 0),
        (x**y, -1),
        (sign(x), 0),
        (asin(x), 2),
        (acosh(x), 0),
        (tan(x) / x, 0),
        (Integral(1 / t, (t, -1, 1)), 0),
        (Integral(log(t), (t, x, 1)), -1),
        (Integral(t, (t, 0, 1 / x)), 0),
    ],
    ids=str,
)
def test_where_nothing_is_defined_there_is_no_number(e: Basic, at: int) -> None:
    with ball_precision(64):
        assert not value(e, {x: arb(at), y: arb(2)}).is_finite()


@pytest.mark.parametrize("e", [sqrt(x), log(x), Abs(x), sign(x), asin(x), 1 / x], ids=str)
def test_an_integrand_is_not_taken_for_analytic_across_a_cut(e: Basic) -> None:
    with ball_precision(64):
        across = acb(arb(0, 0.5), arb(0, 0.5)) if e != asin(x) else acb(arb(0))
        assert not value(e, {x: across}, analytic=True).is_finite()
